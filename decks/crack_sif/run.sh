#!/bin/bash
# The mesh, eleven half lengths by five rules, round cracks in space, and the pictures of this scene, into results/crack_sif: seven minutes of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
"$pdmesh" grid box --size 0.05 0.1 --origin -0.025 -0.05 --spacing 0.00025 --thickness 0.001 -o "$here/plate.txt"
for rule in Adaptive Uniform Intersection Both Either; do
  for k in 0 1 2 3 4 5 6 7 8 9 10; do
    a=$(awk "BEGIN {print 9.875e-3 + $k * 0.025e-3}")
    "$pdrun" "$here/plate.yaml" --quiet --set "Discretization/Cracks/Centre/Points=[-$a, 0.0, $a, 0.0]" \
      --set "Discretization/Bond Decomposition/Rule=$rule" --set "Output/Output Filename=${rule}_$k"
  done
done
# In space.
penny() { # name, radius and height of the middle in mm, tilt in degrees, rule, more overrides
  local rim sine cosine
  mapfile -t rim < <("$here/penny.py" "$2" "$3" "$4")
  read -r sine cosine < <(awk "BEGIN {t = $4 * atan2(0, -1) / 180; print sin(t), cos(t)}")
  "$pdrun" "$here/penny.yaml" --quiet --set "Output/Output Filename=$1" \
    --set "Discretization/Cracks/Penny={Type: Disk, Center: [0.0, 0.0, $3e-3], Normal: [$sine, 0.0, $cosine], Radius: $2e-3}" \
    --set "Discretization/Bond Decomposition={Rule: $5}" --set "Boundary Conditions/Rim X/Value=\"${rim[0]}\"" \
    --set "Boundary Conditions/Rim Y/Value=\"${rim[1]}\"" --set "Boundary Conditions/Rim Z/Value=\"${rim[2]}\"" "${@:6}"
}
for radius in 9.0 9.25 9.5 9.75 10.0; do
  for rule in Adaptive Intersection; do penny "penny_${radius}_0_0_$rule" "$radius" 0 0 "$rule"; done
done
penny penny_10.0_0.5_0_Adaptive 10.0 0.5 0 Adaptive # through points
penny penny_10.0_0_20_Adaptive 10.0 0 20 Adaptive
penny penny_10.0_0_20_Intersection 10.0 0 20 Intersection
penny penny_10.0_0_45_Adaptive 10.0 0 45 Adaptive # through points; Intersection leaves some of them without a bond
grid=Discretization/TensorProduct3DMeshGenerator # points two thirds as far apart
penny penny_fine 10.0 0 0 Adaptive --set "Blocks/Cube/Horizon=2.0 mm" \
  --set "$grid={X Origin: -0.0133333333333, Y Origin: -0.0133333333333, Z Origin: -0.0133333333333,
                X Length: 0.0266666666667, Y Length: 0.0266666666667, Z Length: 0.0266666666667,
                Number Points X: 40, Number Points Y: 40, Number Points Z: 40}" \
  --set "Boundary Conditions/Rim Node Set/Expression=\"max(max(abs(x), abs(y)), abs(z)) > 11.3e-3\""
"$here/plot.py" "$results"
