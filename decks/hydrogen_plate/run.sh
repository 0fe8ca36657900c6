#!/bin/bash
# Mesh, run and pictures of this scene.
#
#   run.sh            the plate with hydrogen, into results/hydrogen_plate
#   run.sh compare    also without hydrogen, with the law that scales the fracture energy, and by one relaxation a load step
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
"$here/make_mesh.sh"
cd "$results"
"$pdrun" "$here/hydrogen_plate.yaml"
if [[ "${1:-}" == compare ]]; then
  "$pdrun" "$here/hydrogen_plate.yaml" --set "Output/Output Filename=no_hydrogen" \
    --set "Boundary Conditions/Hydrogen On Crack Lips/Value=0.0" \
    --set "Boundary Conditions/Hydrogen On New Crack Faces/Value=0.0"
  "$pdrun" "$here/hydrogen_plate.yaml" --set "Output/Output Filename=fracture_energy_law" \
    --set "Damage Models/Hydrogen/Degradation Law=Fracture Energy"
  "$pdrun" "$here/one_relaxation.yaml"
fi
"$here/plot.py" "$results"
