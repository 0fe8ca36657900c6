#!/bin/bash
# Mesh, all runs, table and picture of this study, into results/static_plate.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../../scene.sh"
"$pdmesh" grid box --size 0.2 0.1 --spacing 0.001 --thickness 0.004 -o "$here/plate.txt"
cd "$results"
"$pdrun" --study "$here/study.yaml"
