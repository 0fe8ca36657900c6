#!/bin/bash
# All runs and the picture of this scene, into results/through_crack: two minutes or so of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
grid="Discretization/TensorProduct3DMeshGenerator"
run() { # name, thickness in points, more overrides
  local name=$1 points=$2
  shift 2
  "$pdrun" "$here/through_crack.yaml" --quiet --set "Output/Output Filename=$name" \
    --set "$grid/Number Points Z=$points" --set "$grid/Z Length=$points mm" --set "$grid/Z Origin=-0.5*$points mm" \
    --set "Boundary Conditions/Face Node Set/Expression=z < -0.5e-3*($points - 1) + 1e-4" "$@"
}
plane=(--set "Discretization/Thickness=1 mm")
for part in Materials/Steel "Damage Models/Fatigue"; do
  plane+=(--set "$part/Plane Strain=true" --set "$part/Thickness=1 mm")
done
run plane 1 "${plane[@]}"
run slab_6 6
run slab_9 9
"$here/plot.py" "$results"
