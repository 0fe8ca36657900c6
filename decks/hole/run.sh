#!/bin/bash
# The meshes, all runs and the pictures of this scene, into results/hole: two minutes of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
for spacing in 0.5 0.25 0.125 0.0625; do
  "$pdmesh" grid box --size 0.04 0.04 --origin -0.02 -0.02 --spacing "${spacing}e-3" --thickness 0.001 -o "$here/plate_$spacing.txt"
done
run() { # name, spacing in mm, rule; of each hole x and y of the centre, half axes in mm, angle in degrees
  local name=$1 spacing=$2 rule=$3 voids="" k=0
  shift 3
  mapfile -t rim < <("$here/exact.py" 20 "$@")
  while (($#)); do
    voids+="${voids:+, }Hole $((++k)): {Type: Ellipse, Center: [$1e-3, $2e-3], Half Axes: [$3e-3, $4e-3], Angle: $5 deg}"
    shift 5
  done
  local layer=$(computed "20 - 3.2 * $spacing")e-3
  TIMEFORMAT="$name %U" # seconds of the processor
  { time "$pdrun" "$here/plate.yaml" --quiet --set "Output/Output Filename=$name" \
    --set "Discretization/Input Mesh File=plate_$spacing.txt" --set "Blocks/Plate/Horizon=$(computed "3 * $spacing") mm" \
    --set "Discretization/Voids={$voids}" --set "Discretization/Bond Decomposition={Rule: $rule}" \
    --set "Boundary Conditions/Rim Node Set={Expression: \"abs(x) > $layer || abs(y) > $layer\"}" \
    --set "Boundary Conditions/Rim X/Value=\"${rim[0]}\"" --set "Boundary Conditions/Rim Y/Value=\"${rim[1]}\"" >&3 2>&3; } 2>> times.txt
}
exec 3>&2
rm -f times.txt
for k in 0 1 2 3 4; do # the hole moves by a quarter of a spacing
  x=$(computed "$k * 0.0625")
  run "ellipse_2_$k" 0.25 Adaptive "$x" 0.0 5.0 2.5 30.0
  run "ellipse_flat_$k" 0.25 Adaptive "$x" 0.0 2.5 5.0 0.0
  run "ellipse_4_$k" 0.25 Adaptive "$x" 0.0 5.0 1.25 0.0
  run "two_$k" 0.25 Adaptive "$(computed "$x - 4.5")" 0.0 3.0 3.0 0.0 "$(computed "$x + 4.5")" 0.0 3.0 3.0 0.0
  x=$(computed "$k * 0.03125") # the same with points half as far apart
  run "ellipse_fine_$k" 0.125 Adaptive "$x" 0.0 5.0 2.5 30.0
  run "two_fine_$k" 0.125 Adaptive "$(computed "$x - 4.5")" 0.0 3.0 3.0 0.0 "$(computed "$x + 4.5")" 0.0 3.0 3.0 0.0
  for spacing in 0.5 0.25 0.125 0.0625; do
    x=$(computed "$k * 0.25 * $spacing")
    for rule in Adaptive Intersection; do run "circle_${rule}_${spacing}_$k" "$spacing" "$rule" "$x" 0.0 5.0 5.0 0.0; done
  done
done
"$here/plot.py" "$results"
