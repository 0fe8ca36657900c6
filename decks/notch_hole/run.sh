#!/bin/bash
# Meshes, all runs and the picture of this scene, into results/notch_hole: fifteen minutes or so of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
until_long() { echo "Solver/Fatigue/Stop When={Value: Crack_Length, Reaches: $1e-3}"; } # in mm
run() { # name, height of the hole in mm, mesh, more overrides
  "$pdrun" "$here/plate.yaml" --quiet --set "Output/Output Filename=$1" --set "Discretization/Input Mesh File=$3" \
    --set "Boundary Conditions/Rim Node Set/Expression=\"(x - 20.0e-3)^2 + (y - $2e-3)^2 < (4.5e-3)^2\"" "${@:4}"
}
hole() { echo "Discretization/Voids/Hole={Type: Circle, Center: [20.0e-3, $1e-3], Radius: 4.0e-3}"; } # height in mm
"$pdmesh" grid box --size 0.04 0.07 --origin 0 -0.035 --spacing 0.0005 --thickness 0.001 --quiet -o "$here/plate.txt"
for height in 5 6 7 8 9 11; do
  passes=()
  if [[ $height == 11 ]]; then passes=(--set "$(until_long 38)"); fi # before the plate comes apart
  run "shares_$height" "$height" plate.txt --set "$(hole "$height")" "${passes[@]}"
  gmsh -v 1 -2 "$here/plate.geo" -setnumber Height "$height" -o "$here/cut_$height.msh"
  "$pdmesh" convert "$here/cut_$height.msh" "$here/cut_$height.txt" --scale 1e-3 --thickness 0.001 --quiet
  run "cut_$height" "$height" "cut_$height.txt" --set "Discretization/Voids={}" "${passes[@]}"
  [[ $height =~ ^(6|8)$ ]] && continue
  # The same lattice with the points in the hole taken out.
  "$pdmesh" grid box --size 0.04 0.07 --origin 0 -0.035 --spacing 0.0005 --thickness 0.001 --hole 0.02 "${height}e-3" 0.004 \
    --quiet -o "$here/lattice_$height.txt"
  run "lattice_$height" "$height" "lattice_$height.txt" --set "Discretization/Voids={}" "${passes[@]}"
done
# Triangles that know nothing of the hole, and what they do to a crack that has none beside it.
gmsh -v 1 -2 "$here/plate.geo" -setnumber IsCut 0 -o "$here/triangles.msh"
"$pdmesh" convert "$here/triangles.msh" "$here/triangles.txt" --scale 1e-3 --thickness 0.001 --quiet
for height in 5 7; do run "triangles_$height" "$height" triangles.txt --set "$(hole "$height")"; done
run triangles_9 9 triangles.txt --set "$(hole 9)" --set "$(until_long 35)" # it passes
run straight 7 triangles.txt --set "Discretization/Voids={}" --set "$(until_long 20)"
# Half as large triangles, and what they do without a hole.
for height in 5 6 7 8 9 11; do
  passes=()
  if [[ $height == 11 ]]; then passes=(--set "$(until_long 38)"); fi
  gmsh -v 1 -2 "$here/plate.geo" -setnumber Size 0.6 -setnumber Height "$height" -o "$here/fine_$height.msh"
  "$pdmesh" convert "$here/fine_$height.msh" "$here/fine_$height.txt" --scale 1e-3 --thickness 0.001 --quiet
  run "fine_$height" "$height" "fine_$height.txt" --set "Discretization/Voids={}" "${passes[@]}"
done
gmsh -v 1 -2 "$here/plate.geo" -setnumber Size 0.6 -setnumber IsCut 0 -o "$here/fine.msh"
"$pdmesh" convert "$here/fine.msh" "$here/fine.txt" --scale 1e-3 --thickness 0.001 --quiet
run straight_fine 7 fine.txt --set "Discretization/Voids={}" --set "$(until_long 20)"
"$here/plot.py" "$results"
