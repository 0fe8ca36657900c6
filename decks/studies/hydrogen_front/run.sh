#!/bin/bash
# Meshes, all runs, table and picture of this study, into results/hydrogen_front.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../../scene.sh"
for spacing in 0.25 0.5 1.0 2.0; do
  "$pdmesh" grid box --size 0.124 0.048 --origin -0.062 0 --spacing "${spacing}e-3" --thickness 0.004 \
    -o "$here/plate_$spacing.txt"
done
cd "$results"
"$pdrun" --study "$here/study.yaml"
