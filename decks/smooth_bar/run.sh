#!/bin/bash
# All runs and the picture of this scene, into results/smooth_bar.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
run() { # name, largest strain of a cycle, load ratio
  "$pdrun" "$here/bar.yaml" --quiet --set "Output/Output Filename=$1" --set "Solver/Fatigue/Load Ratio=$3" --set "Solver/Final Time=1.0e10" \
    --set "Boundary Conditions/Left Grip/Value=$2*x" --set "Boundary Conditions/Right Grip/Value=$2*x"
}
for ratio in -1 0 0.5; do
  # Ranges of 1.8e-3 (below the limit) to 8e-3: the largest strain is the range over 1 - R.
  for range in 1.8e-3 1.9e-3 2.0e-3 2.5e-3 3.0e-3 4.0e-3 6.0e-3 8.0e-3; do
    run "R${ratio}_$range" "$(awk "BEGIN {print $range / (1 - $ratio)}")" "$ratio"
  done
done
"$pdrun" --fit "$here/fit.yaml"
"$here/plot.py" "$results"
