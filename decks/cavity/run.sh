#!/bin/bash
# Meshes, runs and pictures of this scene, into results/cavity: a minute or so.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
for points in 24 48 96; do
  edge=$(computed "1 + 8/$points")
  corner=$(computed "-4/$points")
  "$pdmesh" grid box --quiet --spacing "$(computed "1/$points")" --size "$edge" "$edge" \
    --origin "$corner" "$corner" -o "$here/cavity_$points.txt"
  "$pdrun" "$here/cavity.yaml" --quiet --set "Output/Output Filename=cavity_$points" \
    --set "Discretization/Input Mesh File=cavity_$points.txt" \
    --set "Blocks/Fluid/Horizon=$(computed "3.015/$points")"
done
"$here/plot.py" "$results"
