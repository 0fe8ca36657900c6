#!/bin/bash
# Pores, all runs and the pictures of this scene, into results/pore_field: 70 s of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
"$here/pores.py" 1 50 "$here"
# As good as none.
"$pdrun" "$here/specimen.yaml" --quiet --set "Output/Output Filename=free" \
  --set "Discretization/Voids={Speck: {Type: Sphere, Center: [0.0, 0.0, 0.0], Radius: 1.0e-9}}"
"$pdrun" --study "$here/study.yaml"
"$here/plot.py" "$results"
