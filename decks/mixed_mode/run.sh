#!/bin/bash
# Meshes, all runs and the pictures of this scene, into results/mixed_mode.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"

# Three lattices, turned by 0, 30 and 60 degrees and jittered, so that rows of points favour no direction.
for mesh in 1 2 3; do
  "$pdmesh" grid disc --radius 0.02 --spacing 0.00025 --jitter 0.2 --seed "$mesh" --turn "$((30 * mesh - 30))" \
    --thickness 0.004 --quiet -o "$here/disc_$mesh.txt"
done

cd "$results"
for mesh in 1 2 3; do
  for case in 90 75 60 45 30 shear; do
    # cases.py prints the displacements of a case: with the load t, and with 0.8 of the critical load.
    mapfile -t growing < <("$here/cases.py" "$case" t)
    mapfile -t constant < <("$here/cases.py" "$case" 0.8)
    input=(--quiet --set "Discretization/Input Mesh File=disc_$mesh.txt")
    "$pdrun" "$here/dry.yaml" "${input[@]}" "${growing[@]}" --set "Output/Output Filename=dry_${case}_$mesh"
    "$pdrun" "$here/hydrogen.yaml" "${input[@]}" "${constant[@]}" --set "Output/Output Filename=hydrogen_${case}_$mesh"
  done
done
"$here/plot.py" "$results"
