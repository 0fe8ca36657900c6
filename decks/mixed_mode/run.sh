#!/bin/bash
# Mesh, all runs and the pictures of this scene, into results/mixed_mode.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
gmsh -v 2 -2 "$here/square.geo" -o "$here/square.msh"
"$pdmesh" convert "$here/square.msh" "$here/square.txt" --at nodes --thickness 0.004 --horizon 0.002
cd "$results"

# Overrides that turn the crack of a deck to an angle (degrees) with the load along y.
turned() {
  awk -v angle="$1" 'BEGIN {
    c = cos(angle * atan2(0, -1) / 180); s = sin(angle * atan2(0, -1) / 180); filter = "Discretization/Bond Filters/Pre-Crack/"
    printf "--set\n%sNormal_X=%.12f\n--set\n%sNormal_Y=%.12f\n", filter, -c, filter, s
    printf "--set\n%sLower_Left_Corner_X=%.12f\n--set\n%sLower_Left_Corner_Y=%.12f\n", filter, -0.01 * s, filter, -0.01 * c
    printf "--set\n%sBottom_Unit_Vector_X=%.12f\n--set\n%sBottom_Unit_Vector_Y=%.12f\n", filter, s, filter, c }'
}
for deck in dry hydrogen; do
  for angle in 90 75 60 45 30; do
    mapfile -t overrides < <(turned "$angle")
    "$pdrun" "$here/$deck.yaml" --quiet --set "Output/Output Filename=${deck}_$angle" "${overrides[@]}"
  done
done
"$pdrun" "$here/shear.yaml" --quiet
"$here/plot.py" "$results"
