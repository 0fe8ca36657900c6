#!/bin/bash
# Mesh, all runs, table and picture of this study, into results/hydrogen_strength.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../../scene.sh"
"$pdmesh" grid box --size 0.05 0.05 --origin -0.025 -0.025 --spacing 1e-3 --thickness 0.001 -o "$here/plate.txt"
cd "$results"
"$pdrun" --study "$here/study.yaml"
