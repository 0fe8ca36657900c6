#!/bin/bash
# Meshes, all runs and the picture of this scene, into results/notch_hole: fifteen minutes or so of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
run() { # name, height of the hole in mm, mesh, more overrides
  "$pdrun" "$here/plate.yaml" --quiet --set "Output/Output Filename=$1" --set "Discretization/Input Mesh File=$3" \
    --set "Boundary Conditions/Rim Node Set/Expression=\"(x - 20.0e-3)^2 + (y - $2e-3)^2 < (4.5e-3)^2\"" "${@:4}"
}
hole() { echo "Discretization/Voids/Hole={Type: Circle, Center: [20.0e-3, $1e-3], Radius: 4.0e-3}"; } # height in mm
"$pdmesh" grid box --size 0.04 0.07 --origin 0 -0.035 --spacing 0.0005 --thickness 0.001 --quiet -o "$here/plate.txt"
for height in 5 6 7 8 9 11; do
  run "shares_$height" "$height" plate.txt --set "$(hole "$height")"
  gmsh -v 1 -2 "$here/plate.geo" -setnumber Height "$height" -o "$here/cut_$height.msh"
  "$pdmesh" convert "$here/cut_$height.msh" "$here/cut_$height.txt" --scale 1e-3 --thickness 0.001 --quiet
  run "cut_$height" "$height" "cut_$height.txt" --set "Discretization/Voids={}"
done
for height in 5 7 9 11; do # the same lattice with the points in the hole taken out
  "$pdmesh" grid box --size 0.04 0.07 --origin 0 -0.035 --spacing 0.0005 --thickness 0.001 --hole 0.02 "${height}e-3" 0.004 \
    --quiet -o "$here/lattice_$height.txt"
  run "lattice_$height" "$height" "lattice_$height.txt" --set "Discretization/Voids={}"
done
"$here/plot.py" "$results"
