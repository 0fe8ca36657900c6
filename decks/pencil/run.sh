#!/bin/bash
# Mesh, the three runs, the study of methods and the pictures of this scene, into results/pencil.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
"$pdmesh" grid box --spacing 1e-6 --size 457e-6 --origin -0.000007 -o "$here/pencil.txt" --quiet
cd "$results"
run() { # name, D, C_solid, C_sat, z, i, final time
  "$pdrun" "$here/pencil.yaml" --set "Output/Output Filename=$1" --set "Materials/Metal/Diffusivity=$2" \
    --set "Materials/Metal/Solid Concentration=$3" --set "Boundary Conditions/Metal/Value=$3" \
    --set "Materials/Metal/Saturation Concentration=$4" --set "Materials/Metal/Charge Number=$5" \
    --set "Materials/Metal/Current Density=$6" --set "Solver/Final Time=$7"
}
"$pdrun" "$here/pencil.yaml"
run copper 1297e-12 141000 5000 2 1e6 1000
run finite 860e-12 142900 4600 2.19 5.1e3 3000
"$here/plot.py" "$results"
"$here/study.py" "$pdrun" "$here/pencil.yaml" "$results"
