#!/bin/bash
# Mesh, run and picture of the wire in space, on 2 ranks, into results/mg_pin: some minutes; run_space.sh [SPACING].
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
h="${1:-10e-6}"
# 0.2 and 0.5 spacings off the wire's axis, so that 50 cells of 10 um make up its area, within 0.5 %.
before="$(computed "int(150e-6/$h + 0.999) + 4")"
behind="$(computed "int(250e-6/$h + 0.999) + 5")"
side="$(computed "int(425e-6/$h) + 4")"
"$pdmesh" grid box --quiet --spacing "$h" --size "$(computed "$h*($before + $behind)")" "$(computed "$h*$side")" \
  "$(computed "$h*$side")" --origin "$(computed "-$h*(0.3 + $before)")" 0 0 \
  --remove "y^2 + z^2 > (425e-6 + 3.2*$h)^2" --block "2: y^2 + z^2 > (425e-6)^2" -o "$here/pin3d.txt"
mpirun --allow-run-as-root --oversubscribe --bind-to none -np 2 "$pdrun" "$here/pin3d.yaml" --quiet \
  --set "Blocks/Channel/Horizon=$(computed "3.015*$h")" \
  --set "Blocks/Walls/Horizon=$(computed "3.015*$h")" --set "Materials/Fluid/Flux Horizon=$(computed "1.2*$h")"
"$here/plot_pin3d.py" "$results"
