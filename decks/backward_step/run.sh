#!/bin/bash
# Meshes, runs and pictures of this scene, into results/backward_step: about a minute.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
run() { # name, points a step, shift of the lattice in spacings along x and y
  local h
  h=$(computed "1/$2")
  "$pdmesh" grid box --quiet --spacing "$h" --size "$(computed "18 + 9*$h")" "$(computed "2 + 9*$h")" \
    --origin "$(computed "-3 - (4 + $3)*$h")" "$(computed "(-4 - $4)*$h")" \
    --remove "x < -4.5*$h and y < 1 - 4.5*$h" -o "$here/$1.txt"
  "$pdrun" "$here/step.yaml" --quiet --set "Output/Output Filename=$1" \
    --set "Discretization/Input Mesh File=$1.txt" --set "Blocks/Fluid/Horizon=$(computed "3.015*$h")"
}
run step_10 10 0 0
run step_20 20 0 0
run shifted_20 20 0.37 0.81
"$here/plot.py" "$results"
