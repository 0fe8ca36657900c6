#!/bin/bash
# Meshes, all runs and the picture of this scene, into results/mesh_convergence.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"

# name, elements along x and y, spacing in m
meshes=("4k 90 44 0.00225" "6k 110 54 0.001835" "8k 126 64 0.001575" "10k 142 70 0.001419" "12k 154 78 0.00129"
        "50k 316 158 0.000633")
for mesh in "${meshes[@]}"; do
  read -r name nx ny _ <<<"$mesh"
  mkdir -p "$here/$name"
  gmsh -v 2 -2 "$here/../hydrogen_plate/plate.geo" -setnumber nx "$nx" -setnumber ny "$ny" -o "$here/$name/plate.msh"
  "$pdmesh" convert "$here/$name/plate.msh" "$here/$name/plate.txt" --thickness 0.004 --quiet
done
cd "$results"
for mesh in "${meshes[@]}"; do
  read -r name _ _ spacing <<<"$mesh"
  for deck in mechanics hydrogen; do
    for rescaled in false true; do
      # The horizon stays 5 mm (m-convergence), or is 4 spacings (delta-convergence).
      for horizon in 0.005 "$(awk "BEGIN {print 4 * $spacing}")"; do
        kind=delta
        [[ "$horizon" == 0.005 ]] && kind=m
        "$pdrun" "$here/$deck.yaml" --quiet --set "Discretization/Input Mesh File=$name/plate.txt" \
          --set "Blocks/Plate/Horizon=$horizon" --set "Materials/AISI 4340/Lattice Rescaling=$rescaled" \
          --set "Output/Output Filename=${deck}_${kind}_${rescaled}_$name"
      done
    done
  done
done
"$here/plot.py" "$results"
