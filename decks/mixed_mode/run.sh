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
# Angle, and the load step at which the branches are long enough, about.
for case in "90 600" "75 600" "60 620" "45 660" "30 800"; do
  read -r angle steps <<<"$case"
  mapfile -t overrides < <(turned "$angle")
  "$pdrun" "$here/dry.yaml" --quiet --set "Output/Output Filename=dry_$angle" "${overrides[@]}" \
    --set "Solver/Final Time=$(awk "BEGIN {print $steps / 1000}")" \
    --set "Solver/Adaptive Dynamic Relaxation/Load Steps=$steps"
  "$pdrun" "$here/hydrogen.yaml" --quiet --set "Output/Output Filename=hydrogen_$angle" "${overrides[@]}" \
    --set "Solver/Final Time=$((20 * steps))" --set "Solver/Staggered/Load Steps=$steps"
done
"$pdrun" "$here/shear.yaml" --quiet
"$here/plot.py" "$results"
