#!/bin/bash
# Mesh, both runs and pictures of this scene, into results/decoupled.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
"$here/../hydrogen_plate/make_mesh.sh" "$here"
cd "$results"
"$pdrun" "$here/mechanics_only.yaml"
"$pdrun" "$here/hydrogen_only.yaml"
"$pdplot" mechanics_only --field Displacement --component y -o displacement.png
"$here/plot.py" "$results"
