#!/bin/bash
# Meshes, the three runs and the pictures of this scene, into results/grain_boundary.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
mesh() { # name, spacing, thickness of boundaries
  "$pdmesh" grid box --spacing "$2" --size 127e-6 120e-6 --origin -0.000007 0 -o "$here/plain.txt" --quiet
  "$pdmesh" grains "$here/plain.txt" --size 25e-6 --width "$3" --where "x > 0" --seeds "$here/seeds.txt" -o "$here/$1.txt"
}
mesh polycrystal 1e-6 3e-6
mesh fine 0.5e-6 3e-6
mesh thin 1e-6 0
cd "$results"
"$pdrun" "$here/grain_boundary.yaml"
"$pdrun" "$here/grain_boundary.yaml" --set "Discretization/Input Mesh File=thin.txt" --set "Output/Output Filename=thin"
"$pdrun" "$here/grain_boundary.yaml" --set "Discretization/Input Mesh File=fine.txt" \
  --set "Output/Output Filename=fine" --set "Blocks/Body/Horizon=2.0e-6"
"$here/plot.py" "$results"
