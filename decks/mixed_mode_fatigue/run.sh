#!/bin/bash
# Meshes, all runs and the picture of this scene, into results/mixed_mode_fatigue.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
# Three lattices, turned by 0, 30 and 60 degrees and jittered, so that rows of points favour no direction.
for mesh in 1 2 3; do
  "$pdmesh" grid disc --radius 0.02 --spacing 0.0005 --jitter 0.2 --seed "$mesh" --turn "$((30 * mesh - 30))" --thickness 0.004 \
    --quiet -o "disc_$mesh.txt"
done
for angle in 90 75 60 45 30; do
  mapfile -t displacements < <("$here/cases.py" "$angle")
  for mesh in 1 2 3; do
    "$pdrun" "$here/mixed_mode_fatigue.yaml" --quiet "${displacements[@]}" \
      --set "Discretization/Input Mesh File=$PWD/disc_$mesh.txt" --set "Output/Output Filename=crack_${angle}_$mesh"
  done
done
"$here/plot.py" "$results"
