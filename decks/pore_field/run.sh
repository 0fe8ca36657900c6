#!/bin/bash
# Pores, all runs and the pictures of this scene, into results/pore_field: four minutes of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
"$here/pores.py" 1 50 "$here"
# As good as none.
"$pdrun" "$here/specimen.yaml" --quiet --set "Output/Output Filename=free" \
  --set "Discretization/Voids={Speck: {Type: Sphere, Center: [0.0, 0.0, 0.0], Radius: 1.0e-9}}"
"$pdrun" --study "$here/study.yaml"
for seed in 1 2; do # points half as far apart: another length of the material
  "$pdrun" "$here/specimen.yaml" --quiet --set "Discretization/Voids/Pores/File Name=pores_$seed.txt" \
    --set "Output/Output Filename=fine_$seed" --set "Blocks/Body/Horizon=0.1025 mm" \
    --set "Discretization/TensorProduct3DMeshGenerator/Number Points X=40" \
    --set "Discretization/TensorProduct3DMeshGenerator/Number Points Y=40" \
    --set "Discretization/TensorProduct3DMeshGenerator/Number Points Z=92"
done
"$here/plot.py" "$results"
