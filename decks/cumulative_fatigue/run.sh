#!/bin/bash
# All runs and the pictures of this scene, into results/cumulative_fatigue: two minutes of one core.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../scene.sh"
cd "$results"
bar() { # name, amplitude of the stress in MPa, strain limit
  "$pdrun" "$here/bar.yaml" --quiet --set "Output/Output Filename=$1" --set "Damage Models/Fatigue/Strain Limit=$3" \
    --set "Boundary Conditions/Left Grip/Value=$2.0e6/110.0e9*x" --set "Boundary Conditions/Right Grip/Value=$2.0e6/110.0e9*x"
}
for stress in 250 255 260 280 300 315 350 400 500 600; do bar "bar_254_$stress" "$stress" 0.00231; done
for stress in 310 316 320 350 400 500 600; do bar "bar_315_$stress" "$stress" 0.002864; done
"$pdrun" --study "$here/specimens.yaml"
"$pdrun" --study "$here/bonds.yaml"
"$here/../compact_tension/specimen.py" 0.75 "$here/specimen.txt"
for range in 5 8 10 15 20 30 50; do
  for measure in Amplitude Range; do
    "$pdrun" "$here/growth.yaml" --quiet --set "Output/Output Filename=growth_${measure}_$range" \
      --set "Damage Models/Fatigue/Strain Measure=$measure" --set "Solver/Fatigue/Stress Intensity/Range=$range.0e6"
  done
done
# Half the horizon.
"$here/../compact_tension/specimen.py" 0.375 "$here/fine.txt"
for range in 5 30; do
  "$pdrun" "$here/growth.yaml" --quiet --set "Output/Output Filename=fine_Amplitude_$range" \
    --set "Discretization/Input Mesh File=fine.txt" --set "Blocks/Body/Horizon=1.125 mm" \
    --set "Damage Models/Fatigue/Horizon=1.125 mm" --set "Damage Models/Fatigue/Spacing=0.375 mm" \
    --set "Compute Class Parameters/J/Inner Radius=2.25 mm" --set "Compute Class Parameters/J/Outer Radius=3.5 mm" \
    --set "Solver/Fatigue/Stress Intensity/Range=$range.0e6" --set "Solver/Fatigue/Stop When/Reaches=0.0165"
done
"$here/plot.py" "$results"
