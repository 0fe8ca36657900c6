#!/bin/bash
# Meshes, all runs and the pictures of this scene, into results/gas_pore: four minutes or so of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
times() { awk "BEGIN {printf \"%.9g\", $1 * $2}"; }
specimen() { # name, spacing in mm, pore or nothing, more overrides
  local name=$1 spacing=$2 voids=$3
  shift 3
  "$pdrun" "$here/specimen.yaml" --quiet --set "Output/Output Filename=$name" --set "Discretization/Voids={$voids}" \
    --set "Discretization/Input Mesh File=specimen_$spacing.txt" --set "Blocks/Body/Horizon=$(times 3 "$spacing") mm" "$@"
}
pore() { echo "Pore: {Type: Circle, Center: [${1}e-3, ${2}e-3], Radius: $3 um}"; } # x and y in mm, radius in um

for spacing in 0.6 0.2 0.3 0.4 0.88 1.2; do "$here/specimen.py" "$spacing" "$here/specimen_$spacing.txt"; done
SECONDS=0
for radius in 20 50 100; do # the map
  for depth in 0.26 0.86 1.46 2.06 2.66 3.26 3.86 4.46 5.06 5.66 6.26 6.66; do
    specimen "map_${radius}_$depth" 0.6 "$(pore "$depth" 0.0 "$radius")"
  done
  specimen "semicircle_$radius" 0.6 "$(pore 0.0 0.0 "$radius")"
done
echo "the map took $SECONDS s"
for radius in 20 50 100; do # places of the pore in its cell
  for depth in $(seq 0.26 0.1 6.66); do
    for height in 0.0 0.14 0.29; do
      specimen "place_${radius}_${depth}_$height" 0.6 "$(pore "$depth" "$height" "$radius")"
    done
  done
done
for spacing in 0.2 0.3 0.4 0.6 0.88 1.2; do # distances between points
  specimen "free_$spacing" "$spacing" ""
  for radius in 20 50 100; do
    for depth in 0.26 6.66; do
      specimen "spacing_${spacing}_${radius}_$depth" "$spacing" "$(pore "$depth" 0.0 "$radius")"
    done
  done
done
for stress in 155 160 170 200 250 300; do # lives near the strength, which the map infers from those at 400 MPa
  specimen "stress_$stress" 0.6 "$(pore 0.26 0.0 100)" --set "Boundary Conditions/Pull/Value=$stress.0e6*13.2e-3*3.2e-3"
done
# The pore resolved by points.
control() { # name, edge of the plate, rim of it, spacing, horizon in mm, more overrides
  local name=$1 edge=$2 rim=$3 spacing=$4 horizon=$5
  shift 5
  "$pdmesh" grid box --size "$(times "$edge" 1e-3)" "$(times "$edge" 1e-3)" --spacing "$(times "$spacing" 1e-3)" --quiet \
    --origin "$(times "$edge" -0.5e-3)" "$(times "$edge" -0.5e-3)" --thickness 3.2e-3 -o "$here/control_${edge}_$spacing.txt"
  "$pdrun" "$here/control.yaml" --quiet --set "Output/Output Filename=$name" \
    --set "Discretization/Input Mesh File=control_${edge}_$spacing.txt" --set "Blocks/Plate/Horizon=$horizon mm" \
    --set "Boundary Conditions/Rim Node Set/Expression=\"max(abs(x), abs(y)) > ${rim}e-3\"" "$@"
}
for rule in Adaptive Intersection; do # the horizon of the map, finer points; lives, and displacements of the whole body
  for spacing in 0.6 0.1 0.075; do
    [[ $rule == Intersection || $spacing == 0.6 ]] || continue
    options=(--set "Discretization/Bond Decomposition={Rule: $rule}")
    control "same_${rule}_$spacing" 10.8 1.8 "$spacing" 1.8 "${options[@]}"
    control "whole_${rule}_$spacing" 10.8 1.8 "$spacing" 1.8 "${options[@]}" --set "Damage Models/Fatigue/Strain Limit=1"
  done
done
for spacing in 0.05 0.025 0.0125; do # three spacings a horizon
  control "local_$spacing" 3.2 1.3 "$spacing" "$(times 3 "$spacing")" --set "Discretization/Bond Decomposition={Rule: Intersection}"
done
"$here/plot.py" "$results"
