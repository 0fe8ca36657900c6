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
finer() { # name, distance of points in mm, how many along an edge, where the rim begins in mm
  local grid=Discretization/TensorProduct3DMeshGenerator length=$(computed "$2 * $3")e-3 origin=$(computed "-0.5 * $2 * $3")e-3
  penny "$1" 10.0 0 0 Adaptive --set "Blocks/Cube/Horizon=$(computed "3 * $2") mm" \
    --set "$grid={X Origin: $origin, Y Origin: $origin, Z Origin: $origin, X Length: $length, Y Length: $length, Z Length: $length,
                  Number Points X: $3, Number Points Y: $3, Number Points Z: $3}" \
    --set "Boundary Conditions/Rim Node Set/Expression=\"max(max(abs(x), abs(y)), abs(z)) > ${4}e-3\""
}
finer penny_0.667 "2 / 3" 40 11.3
finer penny_0.5 0.5 52 11.47
"$here/plot.py" "$results"
