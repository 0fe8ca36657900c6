#!/bin/bash
# Meshes, runs, fit and pictures of this scene, into results/mg_pin: two minutes.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
# 0.2 and 0.5 spacings off the wire's axis, so that 200 cells make up its area, within 0.5 %.
"$pdmesh" grid box --quiet --spacing 5e-6 --size 735e-6 445e-6 --origin -266.5e-6 0 --block "2: y > 425e-6" \
  -o "$here/mg_pin.txt"
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
"$here/plot.py" "$results"
