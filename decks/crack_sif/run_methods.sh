#!/bin/bash
# Shares of bonds by several rules against exact ones, and stress intensities by distance of points, rule and time, into
# results/crack_sif: two minutes of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
"$here/neighbours.py" mesh "$here/pairs.txt"
pairs() { # name, rule, straight parts of a crack
  "$pdrun" "$here/neighbours.yaml" --set "Discretization/Bond Decomposition=$2" --set "Output/Output Filename=pairs_$1" \
    --set "Discretization/Cracks=$("$here/neighbours.py" cracks "$3")" | sed -n "s/^cracks and voids/$1/p" >> pairs.log
}
rm -f pairs.log
for n in 2 5 10 20 40; do pairs "Uniform_$n" "{Rule: Uniform, Partitions: $n}" 1; done
for tolerance in 1.0e-2 1.0e-3 1.0e-4; do
  for parts in 1 2; do pairs "Adaptive_${tolerance}_$parts" "{Rule: Adaptive, Tolerance: $tolerance}" "$parts"; done
done

: > times.txt
exec 3>&2
plate() { # name, spacing in mm, half length in mm, rule
  TIMEFORMAT="$1 %U" # seconds of the processor
  { time "$pdrun" "$here/plate.yaml" --quiet --set "Discretization/Cracks/Centre/Points=[-${3}e-3, 0.0, ${3}e-3, 0.0]" \
    --set "Discretization/Input Mesh File=plate_$2.txt" --set "Blocks/Plate/Horizon=$(computed "4 * $2") mm" \
    --set "Discretization/Bond Decomposition=$4" --set "Output/Output Filename=$1" >&3 2>&3; } 2>> times.txt
}
for spacing in 0.5 0.333333333 0.25; do
  "$pdmesh" grid box --size 0.05 0.1 --origin -0.025 -0.05 --spacing "${spacing}e-3" --thickness 0.001 -o "$here/plate_$spacing.txt"
  for k in 0 1 2 3 4; do # from one point, or edge of cells, to the next
    a=$(computed "10 + ($k - 2) * 0.24 * $spacing")
    for rule in Adaptive Intersection Both Either; do plate "spaced_${rule}_${spacing}_$k" "$spacing" "$a" "{Rule: $rule}"; done
  done
done
for n in 1 2 5 10 20 40; do
  for k in 0 1 2 3 4; do
    plate "parts_${n}_$k" 0.333333333 "$(computed "10 + ($k - 2) * 0.24 * 0.333333333")" "{Rule: Uniform, Partitions: $n}"
  done
done
"$here/plot_methods.py" "$results"
