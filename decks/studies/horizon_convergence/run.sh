#!/bin/bash
# Meshes, all runs, tables and pictures of these two studies, into results/horizon_convergence.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../../scene.sh"
for spacing in 0.5 0.75 1.0 1.5 2.0 3.0 4.0; do
  "$pdmesh" grid box --size 0.192 0.096 --spacing "${spacing}e-3" --thickness 0.004 -o "$here/plate_$spacing.txt"
done
cd "$results"
"$pdrun" --study "$here/delta_convergence.yaml"
"$pdrun" --study "$here/m_convergence.yaml"
