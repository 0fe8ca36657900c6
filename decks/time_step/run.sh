#!/bin/bash
# Mesh, all runs and the picture of this scene, into results/time_step.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
"$here/../hydrogen_plate/make_mesh.sh" "$here" 74 38 0.0085
cd "$results"
run() { # method, steps
  "$pdrun" "$here/hydrogen.yaml" --quiet --set "Solver/Diffusion/Method=$1" --set "Solver/Diffusion/Sub Steps=$2" \
    --set "Output/Output Filename=$1_$2"
}
for steps in 640 1280 2560 5120; do run Euler "$steps"; done
for method in RKC RKL; do
  for steps in 5 10 20 40 80 160; do run "$method" "$steps"; done
done
run RKC 20480
"$here/plot.py" "$results"
