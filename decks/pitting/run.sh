#!/bin/bash
# Meshes, the three runs and the pictures of this scene, into results/pitting. RANKS: those of the run in 3D.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
"$pdmesh" grid box --size 240e-6 128e-6 --spacing 1e-6 --origin -0.00012 -0.00012 \
  --block "2: y > 0 and y < 4e-6 and (x < -5e-6 or x > 5e-6)" -o "$here/pit.txt" --quiet
"$here/pits.py" 1e-6 "$here"
cd "$results"
"$pdrun" "$here/pit.yaml"
"$pdrun" "$here/pit.yaml" --set "Materials/SS304/Current Density=2.55e4" --set "Solver/Final Time=500.0" \
  --set "Solver/Corrosion/Load Steps=200" --set "Output/Output Filename=salted" --set "Output/Output Frequency=-1"
mpirun --allow-run-as-root --oversubscribe --bind-to none -np "${RANKS:-2}" "$pdrun" "$here/film.yaml"
"$here/plot.py" "$results"
