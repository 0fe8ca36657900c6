#!/bin/bash
# Meshes, runs, fit and pictures of this scene, into results/mg_pin: some minutes; with --study also what_matters.yaml.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
# 0.2 and 0.5 spacings off the wire's axis, so that 200 cells make up its area, within 0.5 %.
tube() { # name, spacing, columns before the axis, all columns, rows, radius of the tube
  "$pdmesh" grid box --quiet --spacing "$2" --size "$(computed "$2*$4")" "$(computed "$2*$5")" --origin "$(computed "$2*(-0.3 - $3)")" 0 \
    --block "2: abs(y) > ${6:-425e-6}" -o "$here/$1.txt"
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
# The layer at a surface that is always saturated: of the whole wire, of half of its diameter (half of the velocity is the same
# for both of its numbers), and with upwind ends.
"$pdmesh" grid box --quiet --spacing 4e-6 --size 992e-6 416e-6 --origin -416e-6 0 -o "$here/layer.txt"
"$pdrun" "$here/layer.yaml" --quiet
"$pdrun" "$here/layer.yaml" --quiet --set "Output/Output Filename=layer_thin" \
  --set "Boundary Conditions/Far/Velocity=['0.0235*(1 + 300e-6/(2*pi)*x/(x^2 + y^2))', '0.0235*300e-6/(2*pi)*y/(x^2 + y^2)']"
"$pdrun" "$here/layer.yaml" --quiet --set "Output/Output Filename=layer_upwind" --set "Materials/Ions/Upwind Share=1"
"$here/plot_grains.py" "$results"
"$here/plot.py" "$results"
[[ -z "$(command -v ffmpeg)" ]] || "$here/plot_film.py" "$results"
[[ "${1:-}" == --study ]] || exit 0
tube pin_10.6 10.625e-6 26 76 44
tube pin_7.1 7.0833333e-6 38 112 64
"$pdrun" --study "$here/what_matters.yaml"
of_pin() { # name, mesh, spacing, more: a run of mg_pin.yaml on other points
  "$pdrun" "$here/mg_pin.yaml" --quiet --set "Output/Output Filename=$1" --set "Discretization/Input Mesh File=$2.txt" \
    --set "Blocks/Channel/Horizon=$(computed "3.015*$3")" --set "Blocks/Walls/Horizon=$(computed "3.015*$3")" \
    --set "Materials/Fluid/Flux Horizon=$(computed "1.2*$3")" "${@:4}"
}
# Transport control: a surface that is always saturated.
saturated=(--set "Materials/Wire/Saturation Concentration=14302" --set "Materials/Wire/Current Density=1e7"
  --set "Boundary Conditions/Film/Value=0" --set "Solver/Staggered/Solvers/Dissolution/Corrosion={}")
until=(--set "Solver/Final Time=0.3" --set "Solver/Staggered/Load Steps=30")
of_pin transport_10.6 pin_10.6 10.625e-6 "${saturated[@]}" "${until[@]}"
of_pin transport_7.1 pin_7.1 7.0833333e-6 "${saturated[@]}" "${until[@]}"
# When the flow is found anew: after 5 % of the wire, in each load step, or when the drag should have changed.
flow="Solver/Staggered/Solvers/Flow/When"
for part in 0.1 0.02 0.005; do
  by_drag=(--set "$flow/Value=Drag" --set "$flow/Value Change=$part")
  of_pin "drag_$part" pin_10.6 10.625e-6 "${by_drag[@]}"
  of_pin "transport_drag_$part" pin_10.6 10.625e-6 "${saturated[@]}" "${until[@]}" "${by_drag[@]}"
done
of_pin volume pin_10.6 10.625e-6
of_pin each pin_10.6 10.625e-6 --set "$flow/Has Changed By=1e-20"
of_pin transport_each pin_10.6 10.625e-6 "${saturated[@]}" "${until[@]}" --set "$flow/Has Changed By=1e-20"
# The same flow through a tube of 150 um radius.
tube narrow 5e-6 53 147 34 150e-6
of_pin narrow narrow 5e-6 --set "Boundary Conditions/Channel Node Set/Expression=abs(y) < 150e-6" \
  --set "Boundary Conditions/Sides Node Set/Expression=abs(y) > 150e-6" \
  --set "Boundary Conditions/Inlet Node Set/Expression=x < -250e-6 && abs(y) < 150e-6" \
  --set "Boundary Conditions/Outlet Of Ions Node Set/Expression=x > 450e-6 && abs(y) < 150e-6" \
  --set "Boundary Conditions/Sides/Surface=150e-6 - abs(y)" \
  --set "Boundary Conditions/Inflow/Velocity=['0.45*(1 - (y/150e-6)^2)', 0.0]" \
  --set "Compute Class Parameters/Drag/Outer Radius=140e-6"
"$here/plot_study.py" "$results"
