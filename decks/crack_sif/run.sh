#!/bin/bash
# The mesh, eleven half lengths by five rules, and the picture of this scene, into results/crack_sif: three minutes of one core.
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
"$here/plot.py" "$results"
