#!/bin/bash
# Meshes, runs and the picture of this scene, into results/taylor_couette: half a minute.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
for points in 10 20 40; do
  edge=$(computed "2 + 9/$points")
  "$pdmesh" grid box --quiet --spacing "$(computed "1/$points")" --size "$edge" "$edge" \
    --origin "$(computed "-1 - 4.63/$points")" "$(computed "-1 - 4.19/$points")" \
    -o "$here/disc_$points.txt"
  "$pdrun" "$here/annulus.yaml" --quiet --set "Output/Output Filename=annulus_$points" \
    --set "Discretization/Input Mesh File=disc_$points.txt" \
    --set "Blocks/Fluid/Horizon=$(computed "3.015/$points")"
done
"$here/plot.py" "$results"
