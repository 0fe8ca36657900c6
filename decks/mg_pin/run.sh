#!/bin/bash
# Meshes, runs, fit and pictures of this scene, into results/mg_pin: some minutes; with --study also what_matters.yaml.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
# 0.2 and 0.5 spacings off the wire's axis, so that 200 cells make up its area, within 0.5 %.
tube() { # name, spacing, columns before the axis, all columns, rows
  "$pdmesh" grid box --quiet --spacing "$2" --size "$(computed "$2*$4")" "$(computed "$2*$5")" --origin "$(computed "$2*(-0.3 - $3)")" 0 \
    --block "2: abs(y) > 425e-6" -o "$here/$1.txt"
}
tube mg_pin 5e-6 53 147 89
"$pdmesh" grid box --quiet --spacing 5e-6 --size 310e-6 310e-6 --origin -156.5e-6 -155e-6 -o "$here/still.txt"
"$pdrun" "$here/still.yaml" --quiet
"$pdrun" "$here/still.yaml" --quiet --set "Boundary Conditions/Film/Value=0" \
  --set "Materials/Wire/Current Density=5.0" --set "Output/Output Filename=no_film"
"$pdrun" "$here/mg_pin.yaml" --quiet
# Along the axis of the tube; what is beyond the ends of the wire is fluid that stands still.
"$pdmesh" grid box --quiet --spacing 5e-6 --size 280e-6 445e-6 --origin -15e-6 0 \
  --block "2: y > 425e-6 || (y < 40e-6 && (x < 0 || x > 250e-6))" -o "$here/along.txt"
"$pdrun" "$here/along.yaml" --quiet
"$pdrun" --fit "$here/fit.yaml"
# A wire of grains: particles of a second phase, then the boundaries of grains in what is left.
grains() { # name, spacing, cells across
  "$pdmesh" grid box --quiet --spacing "$2" --size "$(computed "$2*$3")" "$(computed "$2*$3")" \
    --origin "$(computed "-60e-6 - 0.3*$2")" -60e-6 -o "$here/$1_plain.txt"
  "$pdmesh" grains "$here/$1_plain.txt" --quiet --size 4e-6 --width 0 --by-share --where "r < 40e-6" \
    --boundary-block 2 --phase 3=0.04 -o "$here/$1_particles.txt"
  "$pdmesh" grains "$here/$1_particles.txt" --quiet --split 1 --size 40e-6 --width 2e-6 --by-share --where "r < 40e-6" \
    --boundary-block 2 --seed 3 -o "$here/$1.txt"
}
grains grains 1e-6 120
grains grains_coarse 2e-6 60
coarse=(--quiet --set "Discretization/Input Mesh File=grains_coarse.txt" --set "Blocks/All/Horizon=6.03e-6")
"$pdrun" "$here/grains.yaml" --quiet
"$pdrun" "$here/grains.yaml" "${coarse[@]}" --set "Output/Output Filename=grains_coarse"
"$pdrun" "$here/grains.yaml" "${coarse[@]}" --set "Materials/Wire/Phase Current Densities=[4.6, 4.6]" \
  --set "Output/Output Filename=grains_alone"
"$here/plot_grains.py" "$results"
"$here/plot.py" "$results"
[[ -z "$(command -v ffmpeg)" ]] || "$here/plot_film.py" "$results"
[[ "${1:-}" == --study ]] || exit 0
tube pin_10.6 10.625e-6 26 76 44
tube pin_7.1 7.0833333e-6 38 112 64
"$pdrun" --study "$here/what_matters.yaml"
# Transport control: a surface that is always saturated.
"$pdrun" "$here/mg_pin.yaml" --quiet --set "Discretization/Input Mesh File=pin_10.6.txt" \
  --set "Blocks/Channel/Horizon=32.03e-6" --set "Blocks/Walls/Horizon=32.03e-6" \
  --set "Materials/Fluid/Flux Horizon=12.75e-6" --set "Materials/Wire/Saturation Concentration=14302" \
  --set "Materials/Wire/Current Density=1e7" --set "Boundary Conditions/Film/Value=0" --set "Solver/Final Time=1.5" \
  --set "Solver/Staggered/Load Steps=15" --set "Solver/Staggered/Solvers/Dissolution/Corrosion={}" \
  --set "Output/Output Filename=transport"
