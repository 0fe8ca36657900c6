#!/bin/bash
# Meshes, runs of both metals in 1D, 2D and 3D, some with random bonds, the comparison of interface kernels and pictures
# of this scene, into results/uniform.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
mesh() { "$pdmesh" grid box --spacing 1e-6 -o "$here/$1.txt" --quiet "${@:2}"; }
mesh bar --size 67e-6 --origin -0.000007
mesh strip --size 67e-6 20e-6 --origin -0.000007 0
mesh block --size 67e-6 10e-6 10e-6 --origin -0.000007 0 0
mesh plate --size 76e-6 76e-6 --origin -0.000038 -0.000038
mesh long5 --size 240e-6 300e-6 --spacing 5e-6 1e-6
mesh long25 --size 1200e-6 1400e-6 --spacing 25e-6 1e-6
cd "$results"
copper=(Diffusivity=1297e-12 "Solid Concentration=141000" "Saturation Concentration=5000" "Charge Number=2"
        "Current Density=1450")
for body in bar strip block; do
  "$pdrun" "$here/$body.yaml"
  changes=(--set "Output/Output Filename=${body}_copper" --set "Boundary Conditions/Metal/Value=141000")
  for change in "${copper[@]}"; do changes+=(--set "Materials/Metal/$change"); done
  "$pdrun" "$here/$body.yaml" "${changes[@]}"
done
for seed in 1 2 3; do
  "$pdrun" "$here/strip.yaml" --set "Damage Models/Phases/Rule=Stochastic" \
    --set "Damage Models/Phases/Random Seed=$seed" --set "Output/Output Filename=random$seed" \
    --set "Solver/Corrosion/Load Steps=600" --set "Output/Output Frequency=1"
done
"$pdplot" strip --field Concentration --step 0,10,20,30 -o strip.png
"$here/plot.py" "$results"
"$here/kernels.py" "$pdrun" "$here/strip.yaml" "$results"
