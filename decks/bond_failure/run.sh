#!/bin/bash
# Mesh, the three runs and the picture of this scene, into results/bond_failure.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
"$here/../hydrogen_plate/make_mesh.sh" "$here"
"$here/../hydrogen_plate/make_mesh.sh"
cd "$results"
"$pdrun" "$here/intact.yaml"
"$pdrun" "$here/cracked.yaml"
# Hydrogen on the crack lips: the hydrogen plate by one relaxation a load step, its pre-cut bonds left out of the damage.
"$pdrun" "$here/../hydrogen_plate/one_relaxation.yaml" --set "Output/Output Filename=lips" \
  --set "Discretization/Bond Filters/Pre-Crack/Count In Damage=false"
"$here/plot.py" "$results"
