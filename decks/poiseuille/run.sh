#!/bin/bash
# Meshes, all runs and pictures of this scene, into results/poiseuille: a minute or so.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
times() { /usr/bin/python3 -c "print($1)"; }
for points in 10 20 40; do
  spacing=$(times "1e-3/$points")
  lattice() { # name, size, corner in spacings beyond that of the channel, more
    "$pdmesh" grid box --quiet --spacing "$spacing" --size "$(times "2e-3+$2*$spacing")" "$(times "1e-3+$2*$spacing")" \
      --origin "$(times "-$3*$spacing")" "$(times "-$4*$spacing")" "${@:5}" -o "$here/$1_$points.txt"
  }
  lattice along 8 4 4
  lattice off 9 4.37 4.81
  lattice turned $((points * 2)) $((points / 2 + 4)) "$(times "$points*1.2")" --turn 20
  for mesh in along off turned; do
    run() { "$pdrun" "$here/channel.yaml" --quiet --set "Output/Output Filename=$1_$points" \
      --set "Discretization/Input Mesh File=${mesh}_$points.txt" \
      --set "Blocks/Water/Horizon=$(times "3.015*$spacing")" \
      --set "Compute Class Parameters/In/Width=$(times "2*$spacing")" \
      --set "Compute Class Parameters/Out/Width=$(times "2*$spacing")" "${@:2}"; }
    run "$mesh"
    # Without surfaces walls are staircases, half way to the points beyond them.
    run "${mesh}_staircase" --set "Boundary Conditions/Walls={Type: Prescribed Velocity, Node Set: Walls Node Set}"
  done
  # Half sections of a pipe: rows half a spacing from the axis and the wall between rows; rows 0.31 spacings from the
  # axis and the wall anywhere; points off their places by up to 0.15 spacings.
  half() { # name, distance of the first cells' lower edge from the axis, more
    "$pdmesh" grid box --quiet --spacing "$spacing" --size "$(times "2e-3+9*$spacing")" "$(times "(round($points/2)+4)*$spacing")" \
      --origin "$(times "-4.37*$spacing")" "$(times "$2*$spacing")" "${@:3}" -o "$here/pipe_$1_$points.txt"
  }
  half along 0
  half off -0.19
  half jittered 0 --jitter 0.15
  for mesh in along off jittered; do
    pipe() { "$pdrun" "$here/pipe.yaml" --quiet --set "Output/Output Filename=pipe_$1_$points" \
      --set "Discretization/Input Mesh File=pipe_${mesh}_$points.txt" \
      --set "Blocks/Water/Horizon=$(times "3.015*$spacing")" \
      --set "Compute Class Parameters/In/Width=$(times "2*$spacing")" \
      --set "Compute Class Parameters/Out/Width=$(times "2*$spacing")" "${@:2}"; }
    pipe "$mesh"
    pipe "${mesh}_staircase" --set "Boundary Conditions/Walls={Type: Prescribed Velocity, Node Set: Walls Node Set}"
  done
done
"$here/plot.py" "$results"
