#!/bin/bash
# Meshes, runs and pictures of this scene, into results/start_up: some forty seconds of processor time.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
lattice() { # name, edges and spacing of the flow, more
  "$pdmesh" grid box --quiet --spacing "$4" --size "$(computed "$2 + 8*$4")" "$(computed "$3 + 8*$4")" \
    --origin "$(computed "-4*$4")" "$(computed "-4*$4")" "${@:5}" -o "$here/$1.txt"
}
run() { # deck, mesh, spacing, more
  "$pdrun" "$here/$1.yaml" --quiet --set "Output/Output Filename=${@:4:1}" \
    --set "Discretization/Input Mesh File=$2.txt" --set "Blocks/Fluid/Horizon=$(computed "3.015*$3")" "${@:5}"
}
for points in 10 20 40; do
  spacing=$(computed "1/$points")
  lattice "couette_$points" 0.8 1 "$spacing"
  lattice "couette_jittered_$points" 0.8 1 "$spacing" --jitter 0.1
  for mesh in couette couette_jittered; do run couette "${mesh}_$points" "$spacing" "${mesh}_$points"; done
  lattice "womersley_$points" 0.5 1 "$spacing"
  for number in 2 5; do
    frequency=$(computed "0.5*$number^2") periods=$((number == 2 ? 4 : 12))
    run womersley "womersley_$points" "$spacing" "womersley_${number}_$points" \
      --set "Boundary Conditions/Force/Value=cos($frequency*t)" \
      --set "Solver/Final Time=$(computed "2*pi*$periods/$frequency")" \
      --set "Solver/Weakly Compressible Flow/Load Steps=$((32 * periods))"
  done
done
for points in 16 32 64; do
  spacing=$(computed "pi/$points")
  lattice "vortices_$points" "$(computed pi)" "$(computed pi)" "$spacing"
  lattice "vortices_jittered_$points" "$(computed pi)" "$(computed pi)" "$spacing" --jitter 0.1
  for mesh in vortices vortices_jittered; do run vortices "${mesh}_$points" "$spacing" "${mesh}_$points"; done
done
# Error against work: what a smaller speed of sound saves, and costs.
for speed in 6 10 30; do
  run vortices vortices_32 "$(computed pi/32)" "vortices_sound_$speed" \
    --set "Solver/Weakly Compressible Flow/Sound Speed=$speed"
done
# What is left of the pressure's error is that of compressibility, not of the points.
for speed in 30 60; do
  run vortices vortices_64 "$(computed pi/64)" "vortices_64_sound_$speed" \
    --set "Solver/Weakly Compressible Flow/Sound Speed=$speed"
done
"$here/plot.py" "$results"
