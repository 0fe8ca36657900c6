#!/bin/bash
# Mesh, both runs and the pictures of this scene, into results/crevice. DEPTH (m): how much metal there is; SPACING (m): of
# points along the crevice.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
# The mouth's layer of electrolyte, one horizon long, is as high as the mouth. Cells are 25 x 1 um.
spacing="${SPACING:-25e-6}"
horizon="$(awk "BEGIN { printf \"%.9f\", 4 * $spacing }")"
height="$(awk "BEGIN { print 25e-6 + ${DEPTH:-400e-6} }")"
length="$(awk "BEGIN { print 12.7e-3 + $horizon }")"
"$pdmesh" grid box --size "$length" "$height" --spacing "$spacing" 1e-6 --origin "-$horizon" 0 \
  --remove "x < 0 and y > 25e-6" -o "$here/crevice.txt" --quiet
shape=(--set "Blocks/Body/Horizon=$horizon" --set "Materials/Alloy 625/Horizon Axes=[$horizon, 4.0e-6]"
       --set "Boundary Conditions/Mouth Node Set/Expression=x < $spacing && y < 25e-6")
cd "$results"
"$pdrun" "$here/crevice.yaml" "${shape[@]}"
"$pdrun" "$here/crevice.yaml" "${shape[@]}" --set "Output/Output Filename=printed" \
  --set "Materials/Alloy 625/Current Density=1.0e4*pow(10, 1.151*exp(-0.723*pH) - 7.647)"
"$here/plot.py" "$results"
