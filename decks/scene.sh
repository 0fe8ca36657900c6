# Sourced by the run.sh of every scene, which sets `here`: where things are. PDRUN and RESULTS may be set beforehand.
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
pdrun="${PDRUN:-$root/build/pdrun}"
pdmesh="$root/meshes/pdmesh"
pdplot="$root/meshes/pdplot"
results="${RESULTS:-$root/results}/$(basename "$here")"
[[ -x "$pdrun" ]] || { echo "$pdrun: not built; run ./setup.sh build, or set PDRUN" >&2; exit 1; }
mkdir -p "$results"
# Of an expression, such as "3.015*0.1/20" or "2*pi", all digits.
computed() { /usr/bin/python3 -c "from math import pi; print($1)"; }
