#!/bin/bash
# Meshes, all runs and the picture of this scene, into results/compact_tension: half an hour or so of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
run() { # name, spacing and horizon in mm, exponent of Paris' law, more overrides
  local name=$1 spacing=$2 horizon=$3 exponent=$4
  shift 4
  "$here/specimen.py" "$spacing" "$here/specimen_$spacing.txt"
  "$pdrun" "$here/compact_tension.yaml" --quiet --set "Output/Output Filename=$name" \
    --set "Discretization/Input Mesh File=specimen_$spacing.txt" --set "Blocks/Body/Horizon=${horizon}e-3" \
    --set "Damage Models/Fatigue/Horizon=${horizon}e-3" --set "Damage Models/Fatigue/Spacing=${spacing}e-3" \
    --set "Damage Models/Fatigue/Paris Exponent=$exponent" "$@"
}
constant=(--set "Solver/Fatigue/Stress Intensity/Range=15.0e6" --set "Solver/Fatigue/Stop When/Reaches=0.021")
for exponent in 2.0 3.0 4.0; do
  run "amplitude_$exponent" 0.75 2.25 "$exponent"
  run "range_$exponent" 0.75 2.25 "$exponent" "${constant[@]}"
done
run range_conical 0.75 2.25 3.0 "${constant[@]}" --set "Solver/Fatigue/Stop When/Reaches=0.0185" \
  --set "Discretization/Influence Function=max(1 - zeta/horizon, 0)"
"$here/plot.py" "$results"
