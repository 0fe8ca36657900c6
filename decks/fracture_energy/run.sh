#!/bin/bash
# Meshes, all runs, the table and the pictures of this scene, into results/fracture_energy.
#   run.sh [BODY ...]     strip, notch, beam and pressed without arguments; pressed needs the results of beam
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"

bodies=("$@")
[[ $# -gt 0 ]] || bodies=(strip notch beam pressed)
declare -A first=([strip]=1.012 [notch]=1.008 [beam]=1.014 [pressed]=1.014) # ends of the filter that cuts the crack
declare -A deck=([strip]=strip [notch]=notch [beam]=beam [pressed]=beam)
press="{Type: Force, Node Set: Left Node Set, Coordinate: x, Value: 270.0}" # N: 15 MPa along both arms
constants="Fracture Energy: 8.0, Young's Modulus: 70.0e9, Poisson's Ratio: 0.3333333333333333, Plane Stress: true, Horizon: 0.0015"
declare -A models=(
  [Nodal]="Damage Model: Nodal Energy, Thickness: 0.001, $constants"
  [Stretch]="Damage Model: Critical Stretch, $constants"
)

cd "$results"
for body in "${bodies[@]}"; do
  for lattice in square_3 square_4 square_5 turned_20 turned_45 jittered triangles; do
    "$here/lattices.py" "$body" "$lattice" "$here/${body}_$lattice.txt"
    run=("$pdrun" "$here/${deck[$body]}.yaml" --quiet --set "Discretization/Input Mesh File=${body}_$lattice.txt")
    [[ $body != pressed ]] || run+=(--set "Boundary Conditions/Press=$press")
    # Stiffness for cracks of several lengths: CUTS of growth.py.
    cut=0
    for horizons in -1.0 0.5 2.0 3.5 5.0; do
      length=$(awk "BEGIN {print ${first[$body]} + $horizons * 0.0015}")
      "${run[@]}" --set "Discretization/Bond Filters/Pre-Crack/Bottom_Length=$length" \
        --set "Damage Models/Breakage={Damage Model: Critical Stretch, Critical Stretch: 1.0}" \
        --set "Solver/Initial Time=0" --set "Solver/Final Time=1" --set "Solver/QuasiStatic/Load Steps=1" \
        --set "Output/Output Frequency=1" --set "Output/Output Filename=${body}_${lattice}_cut_$cut"
      cut=$((cut + 1))
    done
    for model in "${!models[@]}"; do
      "${run[@]}" --set "Damage Models/Breakage={${models[$model]}}" \
        --set "Output/Output Filename=${body}_${lattice}_$model"
    done
  done
done
"$here/plot.py" "$results"
