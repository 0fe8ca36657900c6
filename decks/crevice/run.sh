#!/bin/bash
# Mesh, both runs and the pictures of this scene, into results/crevice. DEPTH (m): how much metal there is.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
# The mouth's layer of electrolyte, one horizon long, is as high as the mouth. Cells are 25 x 1 um.
height="$(awk "BEGIN { print 25e-6 + ${DEPTH:-400e-6} }")"
"$pdmesh" grid box --size 12.8e-3 "$height" --spacing 25e-6 1e-6 --origin -0.0001 0 --remove "x < 0 and y > 25e-6" \
  -o "$here/crevice.txt" --quiet
cd "$results"
"$pdrun" "$here/crevice.yaml"
"$pdrun" "$here/crevice.yaml" --set "Output/Output Filename=printed" \
  --set "Materials/Alloy 625/Current Density=1.0e4*pow(10, 1.151*exp(-0.723*pH) - 7.647)"
"$here/plot.py" "$results"
