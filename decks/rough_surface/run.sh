#!/bin/bash
# Images, outlines, all runs and the picture of this scene, into results/rough_surface: a minute and a half of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
"$pdmesh" grid box --size 4e-3 0.92e-3 --origin -2e-3 -0.88e-3 --spacing 20e-6 --thickness 1e-3 --quiet -o "$here/plate.txt"
run() { # name, height of the mean surface over an edge of cells in um, image.py's words
  local name=$1 height=$2
  "$here/image.py" "${@:3}" "$name.png"
  "$pdmesh" outline "$name.png" --pixel 2e-6 --origin -2e-3 "$(awk "BEGIN {print ($height - 80) * 1e-6}")" --quiet -o "$here/$name.txt"
  "$pdrun" "$here/plate.yaml" --quiet --set "Output/Output Filename=$name" \
    --set "Discretization/Voids/Air/File Name=$name.txt"
}
for amplitude in 2 4 6 8 10; do # waves 400 um long, at four places between the points
  for place in "0 0" "10 0" "0 10" "5 5"; do
    read -r start height <<< "$place"
    run "sine_${amplitude}_${start}_$height" "$height" sine "$amplitude" 400 "$start"
  done
done
for seed in 1 2 3 4 5 6 7 8 9 10; do run "random_$seed" 0 random "$seed"; done
"$here/plot.py" "$results"
