#!/bin/bash
# Meshes, runs and pictures of this scene, into results/cylinder: a minute and a half of processor time.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
run() { # name, points a diameter, shift of the lattice in spacings along x and y
  local spacing
  spacing=$(computed "0.1/$2")
  "$pdmesh" grid box --quiet --spacing "$spacing" --size "$(computed "2.2 + 9*$spacing")" \
    "$(computed "0.41 + 9*$spacing")" --origin "$(computed "(-4 - $3)*$spacing")" \
    "$(computed "(-4 - $4)*$spacing")" -o "$here/$1.txt"
  "$pdrun" "$here/cylinder.yaml" --quiet --set "Output/Output Filename=$1" \
    --set "Discretization/Input Mesh File=$1.txt" --set "Blocks/Fluid/Horizon=$(computed "3.015*$spacing")"
}
run channel_10 10 0 0
run shifted_10 10 0.37 0.81
run askew_10 10 0.61 0.23
run channel_20 20 0 0
"$here/plot.py" "$results"

spacing=$(computed 1/14)
"$pdmesh" grid box --quiet --spacing "$spacing" --size "$(computed "30 + 8/14")" "$(computed "12 + 4/14")" \
  --origin "$(computed "-12 - 4/14")" 0 -o "$here/wide.txt"
"$pdrun" "$here/wide.yaml" --quiet
"$here/plot_wide.py" "$results"
