#!/bin/bash
# Meshes, all runs and the picture of this scene, into results/ct_hole.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
run() { # x and y of the hole in mm, spacing in mm, spacings a horizon
  local options name="hole_$1_$2_$3"
  mapfile -t options < <("$here/specimen.py" "$1" "$2" "$3" "$4" "$PWD/$name.txt")
  "$pdrun" "$here/ct_hole.yaml" --quiet "${options[@]}" --set "Output/Output Filename=$name"
}
for y in 7 8 9; do
  "$here/lefm.py" 16 "$y" "lefm_16_$y.csv"
  run 16 "$y" 0.3 4
done
for y in 8; do run 16 "$y" 0.15 4; done
"$here/plot.py" "$results"
