#!/bin/bash
# Mesh, run and pictures of this scene, into results/boundary_conditions.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
"$here/../hydrogen_plate/make_mesh.sh" "$here" 40 20 0.0155
cd "$results"
"$pdrun" "$here/conditions.yaml"
"$pdplot" conditions --field Displacement --component y --deformed -o displacement.png
"$pdplot" conditions --field Concentration -o concentration.png
"$pdplot" conditions --history ReactionY -o reaction.png
