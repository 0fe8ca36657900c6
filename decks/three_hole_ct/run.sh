#!/bin/bash
# Meshes, all runs and the pictures of this scene, into results/three_hole_ct.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
run() { # specimen, spacing in mm
  local options
  mapfile -t options < <("$here/specimen.py" "$1" "$2" "$PWD/specimen_$1_$2.txt")
  "$pdrun" "$here/three_hole_ct.yaml" --quiet "${options[@]}" --set "Output/Output Filename=specimen_$1_$2"
}
for specimen in 1 2 3 4; do run "$specimen" 0.5; done
run 2 0.25
for specimen in 1 2 3 4; do "$here/lefm.py" "$specimen" "lefm_$specimen.csv"; done
"$here/plot.py" "$results"
