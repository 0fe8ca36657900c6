#!/bin/bash
# Meshes, all runs and the pictures of this scene, into results/gas_pore: two minutes or so of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
times() { awk "BEGIN {printf \"%.9g\", $1 * $2}"; }
specimen() { # name, spacing in mm, pore or nothing, more overrides
  local name=$1 spacing=$2 voids=$3
  shift 3
  "$pdrun" "$here/specimen.yaml" --quiet --set "Output/Output Filename=$name" \
    --set "Discretization/Voids={$voids}" --set "Discretization/Input Mesh File=specimen_$spacing.txt" \
    --set "Blocks/Body/Horizon=$(times 3 "$spacing") mm" "$@"
}
pore() { echo "Pore: {Type: Circle, Center: [${1}e-3, ${2}e-3], Radius: $3 um}"; } # x and y in mm, radius in um

for spacing in 0.64 0.21 0.32 0.42 0.84 1.12; do "$here/specimen.py" "$spacing" "$here/specimen_$spacing.txt"; done
SECONDS=0
for radius in 20 50 100; do # the map: depths in steps of the lattice, so that all pores are at the same place in a cell
  for depth in 0.26 0.90 1.54 2.18 2.82 3.46 4.10 4.74 5.38 6.02 6.66; do
    specimen "map_${radius}_$depth" 0.64 "$(pore "$depth" 0.0 "$radius")"
  done
  specimen "semicircle_$radius" 0.64 "$(pore 0.0 0.0 "$radius")"
done
specimen free_0.64 0.64 ""
echo "the map took $SECONDS s"
for radius in 20 50 100; do # other places in a cell
  for depth in $(seq 0.26 0.16 6.66); do
    for height in 0.0 0.31; do
      specimen "place_${radius}_${depth}_$height" 0.64 "$(pore "$depth" "$height" "$radius")"
    done
  done
done
for spacing in 0.21 0.32 0.42 0.64 0.84 1.12; do # distances between points
  [[ $spacing == 0.64 ]] || specimen "free_$spacing" "$spacing" ""
  for radius in 20 50 100; do
    for depth in 0.26 6.66; do
      specimen "spacing_${spacing}_${radius}_$depth" "$spacing" "$(pore "$depth" 0.0 "$radius")"
    done
  done
done
for stress in 150 155 160 200 300; do # lives near the strength, which the map infers from those at 400 MPa
  specimen "stress_$stress" 0.64 "$(pore 0.26 0.0 100)" \
    --set "Boundary Conditions/Pull/Value=$stress.0e6*13.44e-3*3.2e-3"
done
# The pore resolved by points.
control() { # name, edge of the plate, rim of it, spacing, horizon, x and y of the pore in mm, rule, more overrides
  local name=$1 edge=$2 rim=$3 spacing=$4 horizon=$5 voids
  voids="$(pore "$6" "$7" 100)"
  "$pdmesh" grid box --size "$(times "$edge" 1e-3)" "$(times "$edge" 1e-3)" --spacing "$(times "$spacing" 1e-3)" \
    --origin "$(times "$edge" -0.5e-3)" "$(times "$edge" -0.5e-3)" --thickness 3.2e-3 --quiet \
    -o "$here/control_${edge}_$spacing.txt"
  "$pdrun" "$here/control.yaml" --quiet --set "Output/Output Filename=$name" --set "Discretization/Voids={$voids}" \
    --set "Discretization/Input Mesh File=control_${edge}_$spacing.txt" --set "Blocks/Plate/Horizon=$horizon mm" \
    --set "Discretization/Bond Decomposition={Rule: $8}" \
    --set "Boundary Conditions/Rim Node Set/Expression=\"max(abs(x), abs(y)) > ${rim}e-3\"" "${@:9}"
}
same() { # points along the edge of a cell, x and y of the pore, rule, more overrides: the horizon of the map
  control "${5:-same}_$2_$3_$1" 11.52 1.92 "$(times 0.64 "1 / $1")" 1.92 "$2" "$3" "$4" "${@:6}"
}
whole() { same "$1" "$2" "$3" Adaptive whole --set "Damage Models/Fatigue/Strain Limit=1"; } # nothing breaks
for place in "0.26 0.0" "0.02 0.0" "0.26 0.31"; do
  read -r x y <<< "$place"
  same 1 "$x" "$y" Adaptive
  same 6 "$x" "$y" Intersection
  for points in 1 2 4 6; do whole "$points" "$x" "$y"; done
done
same 8 0.26 0.0 Intersection
whole 8 0.02 0.0
for spacing in 0.05 0.025 0.0125; do # three spacings a horizon
  control "local_$spacing" 3.2 1.3 "$spacing" "$(times 3 "$spacing")" 0.0 0.0 Intersection
done
"$here/plot.py" "$results"
