#!/bin/bash
# Mesh of a plate: plate.txt, and the points within one horizon of each side: top.txt, bottom.txt ...
#
#   make_mesh.sh                          here, 148 x 74 elements, horizon 5 mm
#   make_mesh.sh FOLDER NX NY HORIZON     elsewhere, in another resolution
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
folder="${1:-$here}" nx="${2:-148}" ny="${3:-74}" horizon="${4:-0.005}"
gmsh -v 2 -2 "$here/plate.geo" -setnumber nx "$nx" -setnumber ny "$ny" -o "$folder/plate.msh"
"$here/../../meshes/pdmesh" convert "$folder/plate.msh" "$folder/plate.txt" --thickness 0.004 --layer-depth "$horizon" \
  --horizon "$horizon"
