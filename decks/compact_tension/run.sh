#!/bin/bash
# Meshes, all runs and the picture of this scene, into results/compact_tension: twelve minutes of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
times() { computed "$1 * $2"; }
run() { # name, horizon in mm, exponent of Paris' law, more overrides
  local name=$1 horizon=$2 exponent=$3
  shift 3
  local spacing mesh
  spacing=$(times "$horizon" 1/3)
  mesh="specimen_$horizon.txt"
  "$here/specimen.py" "$spacing" "$here/$mesh"
  "$pdrun" "$here/compact_tension.yaml" --quiet --set "Output/Output Filename=$name" \
    --set "Discretization/Input Mesh File=$mesh" --set "Blocks/Body/Horizon=$horizon mm" \
    --set "Damage Models/Fatigue/Horizon=$horizon mm" --set "Damage Models/Fatigue/Spacing=$spacing mm" \
    --set "Compute Class Parameters/J/Inner Radius=$(times 2 "$horizon") mm" \
    --set "Compute Class Parameters/J/Outer Radius=$(times 3.1 "$horizon") mm" \
    --set "Compute Class Parameters/J Of Bonds/Ahead=$(times 2 "$horizon") mm" \
    --set "Compute Class Parameters/J Of Bonds/Behind=$(times 2 "$horizon") mm" \
    --set "Compute Class Parameters/J Of Bonds/Above=$(times 2 "$horizon") mm" \
    --set "Compute Class Parameters/J Of Bonds Further Out/Ahead=$(times 2 "$horizon") mm" \
    --set "Compute Class Parameters/J Of Bonds Further Out/Behind=$(times 3 "$horizon") mm" \
    --set "Compute Class Parameters/J Of Bonds Further Out/Above=$(times 4.5 "$horizon") mm" \
    --set "Damage Models/Fatigue/Paris Exponent=$exponent" "$@"
}
constant=(--set "Solver/Fatigue/Stress Intensity/Range=15.0e6" --set "Solver/Fatigue/Stop When/Reaches=0.021")
shorter=(--set "Solver/Fatigue/Stop When/Reaches=0.0165")
conical=(--set "Discretization/Influence Function=max(1 - zeta/horizon, 0)"
         --set "Solver/Fatigue/Stress Intensity/Effective Modulus=204.4e9")
for horizon in 2.25 1.125 0.5625; do
  more=("${constant[@]}")
  [[ $horizon == 0.5625 ]] && more+=("${shorter[@]}")
  for exponent in 2.0 3.0 4.0; do
    [[ $horizon == 0.5625 ]] || run "amplitude_${exponent}_$horizon" "$horizon" "$exponent"
    run "range_${exponent}_$horizon" "$horizon" "$exponent" "${more[@]}"
    run "conical_${exponent}_$horizon" "$horizon" "$exponent" "${more[@]}" "${conical[@]}"
  done
done
"$here/plot.py" "$results"
"$here/studies.py" "$pdrun" "$results"
"$pdplot" amplitude_{2.0,3.0,4.0}_1.125 --growth -o paris.png
