#!/bin/bash
# The mesh, all runs and the picture of this scene, into results/hole: half a minute of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
"$pdmesh" grid box --size 0.04 0.04 --origin -0.02 -0.02 --spacing 0.00025 --thickness 0.001 -o "$here/plate.txt"
run() { # name, x and y of the centre, half axes in mm, angle in degrees, rule
  mapfile -t rim < <("$here/exact.py" "$2" "$3" "$4" "$5" "$6" 20)
  "$pdrun" "$here/plate.yaml" --quiet --set "Output/Output Filename=$1" \
    --set "Discretization/Voids/Hole={Type: Ellipse, Center: [$2e-3, $3e-3], Half Axes: [$4e-3, $5e-3], Angle: $6 deg}" \
    --set "Discretization/Bond Decomposition={Rule: $7}" \
    --set "Boundary Conditions/Rim X/Value=\"${rim[0]}\"" --set "Boundary Conditions/Rim Y/Value=\"${rim[1]}\""
}
for k in 0 1 2 3 4; do # the hole moves by a quarter of a spacing
  x=$(awk "BEGIN {print $k * 0.0625}")
  run "circle_Adaptive_$k" "$x" 0.0 5.0 5.0 0.0 Adaptive
  run "circle_Intersection_$k" "$x" 0.0 5.0 5.0 0.0 Intersection
  run "ellipse_2_$k" "$x" 0.0 5.0 2.5 30.0 Adaptive
  run "ellipse_flat_$k" "$x" 0.0 2.5 5.0 0.0 Adaptive
  run "ellipse_4_$k" "$x" 0.0 5.0 1.25 0.0 Adaptive
done
"$here/plot.py" "$results"
