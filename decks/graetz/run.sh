#!/bin/bash
# Meshes, runs and pictures of this scene, into results/graetz: a quarter of a minute.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
for points in 10 20 40; do
  spacing=$(computed "1e-3/$points")
  lattice() { # name, size and corner in spacings beyond that of the channel, more
    "$pdmesh" grid box --quiet --spacing "$spacing" --size "$(computed "4e-3+$2*$spacing")" "$(computed "1e-3+$2*$spacing")" \
      --origin "$(computed "-$3*$spacing")" "$(computed "-$4*$spacing")" -o "$here/$1_$points.txt" "${@:5}"
  }
  run() { # mesh, name, more
    "$pdrun" "$here/graetz.yaml" --quiet --set "Output/Output Filename=$2_$points" \
      --set "Discretization/Input Mesh File=$1_$points.txt" --set "Blocks/Channel/Horizon=$(computed "3.015*$spacing")" \
      --set "Materials/Water/Flux Horizon=$(computed "1.2*$spacing")" "${@:3}"
  }
  lattice channel 8 4 4
  lattice off 9 4.37 4.81
  run channel graetz
  run off off
  run channel upwind --set "Materials/Salt/Scheme=Upwind Biased"
  run channel thin --set "Materials/Salt/Diffusivity=2.0e-8"
done
# A pipe, half of its section, by points a radius.
for points in 10 20; do
  spacing=$(computed "0.5e-3/$points")
  "$pdmesh" grid box --quiet --spacing "$spacing" --size "$(computed "4e-3+8*$spacing")" "$(computed "0.5e-3+4*$spacing")" \
    --origin "$(computed "-4*$spacing")" 0 -o "$here/pipe_$points.txt"
  for run in "pipe 8.0e-7" "pipe_thin 2.0e-8"; do
    read -r name diffusivity <<< "$run"
    "$pdrun" "$here/pipe.yaml" --quiet --set "Output/Output Filename=${name}_$points" \
      --set "Discretization/Input Mesh File=pipe_$points.txt" --set "Blocks/Pipe/Horizon=$(computed "3.015*$spacing")" \
      --set "Materials/Water/Flux Horizon=$(computed "1.2*$spacing")" --set "Materials/Salt/Diffusivity=$diffusivity"
  done
done
"$here/plot.py" "$results"
"$here/plot_pipe.py" "$results"
