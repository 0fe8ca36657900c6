#!/bin/bash
# Meshes, all runs and pictures of this scene, into results/poiseuille: a minute or so.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
for points in 10 20 40; do
  spacing=$(computed "1e-3/$points")
  lattice() { # name, size, corner in spacings beyond that of the channel, more
    "$pdmesh" grid box --quiet --spacing "$spacing" --size "$(computed "2e-3+$2*$spacing")" "$(computed "1e-3+$2*$spacing")" \
      --origin "$(computed "-$3*$spacing")" "$(computed "-$4*$spacing")" "${@:5}" -o "$here/$1_$points.txt"
  }
  lattice along 8 4 4
  lattice off 9 4.37 4.81
  lattice turned $((points * 2)) $((points / 2 + 4)) "$(computed "$points*1.2")" --turn 20
  # Without surfaces walls are staircases, half way to the points beyond them.
  both() { # deck, mesh
    run() { "$pdrun" "$here/$1.yaml" --quiet --set "Output/Output Filename=$3_$points" \
      --set "Discretization/Input Mesh File=$2_$points.txt" \
      --set "Blocks/Water/Horizon=$(computed "3.015*$spacing")" \
      --set "Compute Class Parameters/In/Width=$(computed "2*$spacing")" \
      --set "Compute Class Parameters/Out/Width=$(computed "2*$spacing")" "${@:4}"; }
    run "$1" "$2" "$2"
    run "$1" "$2" "$2_staircase" --set "Boundary Conditions/Walls={Type: Prescribed Velocity, Node Set: Walls Node Set}"
  }
  for mesh in along off turned; do
    both channel "$mesh"
    # Points beyond the walls mirrored, for comparison.
    run channel "$mesh" "${mesh}_reflected" --set "Materials/Water/Walls=Reflected Points"
  done
  [[ $points -le 20 ]] || continue  # a jitter of 0.15 spacings leaves one of more points with too few neighbours
  # Half sections of a pipe: rows half a spacing from the axis and the wall between rows; rows 0.31 spacings from the
  # axis and the wall anywhere; points off their places by up to 0.15 spacings.
  half() { # name, distance of the first cells' lower edge from the axis, more
    "$pdmesh" grid box --quiet --spacing "$spacing" --size "$(computed "2e-3+9*$spacing")" "$(computed "(round($points/2)+4)*$spacing")" \
      --origin "$(computed "-4.37*$spacing")" "$(computed "$2*$spacing")" "${@:3}" -o "$here/pipe_$1_$points.txt"
  }
  half along 0
  half off -0.19
  half jittered 0 --jitter 0.15
  for mesh in along off jittered; do both pipe "pipe_$mesh"; done
done
"$here/plot.py" "$results"
