#!/bin/bash
# Meshes, all runs and the picture of this scene, into results/ct_hole.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
run() { # y of the hole in mm, spacing in mm
  local options name="hole_16_$1_$2"
  mapfile -t options < <("$here/specimen.py" 16 "$1" "$2" 3 "$PWD/$name.txt")
  "$pdrun" "$here/ct_hole.yaml" --quiet "${options[@]}" --set "Output/Output Filename=$name"
}
for y in 7 8 9; do
  "$here/lefm.py" 16 "$y" "lefm_16_$y.csv"
  run "$y" 0.4
done
run 8 0.25
"$here/plot.py" "$results"
