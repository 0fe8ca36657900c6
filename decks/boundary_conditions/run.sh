#!/bin/bash
# Mesh, run and pictures of this scene, into results/boundary_conditions.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
"$here/../hydrogen_plate/make_mesh.sh" "$here" 40 20 0.0155
cd "$results"
"$pdrun" "$here/conditions.yaml"
"$pdplot" conditions --field Displacement --component y --deformed -o displacement.png
"$pdplot" conditions --field Concentration -o concentration.png
"$pdplot" conditions --history ReactionY -o reaction.png

# A quarter of a plate, and the whole.
"$pdmesh" grid box --size 0.1 0.05 --spacing 0.005 --thickness 0.004 -o "$here/quarter.txt"
"$pdmesh" grid box --size 0.2 0.1 --origin -0.1 -0.05 --spacing 0.005 --thickness 0.004 -o "$here/whole.txt"
"$pdrun" "$here/quarter.yaml"
"$pdrun" "$here/quarter.yaml" --set "Discretization/Symmetry={}" --set "Discretization/Input Mesh File=whole.txt" \
  --set "Output/Output Filename=whole"
"$pdplot" quarter --field Damage --deformed --step 8 -o quarter.png
