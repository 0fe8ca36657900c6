# Sourced by the run.sh of every scene, which sets `here`: where things are. PDRUN and RESULTS may be set beforehand.
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
pdrun="${PDRUN:-$root/build/pdrun}"
pdmesh="$root/meshes/pdmesh"
pdplot="$root/meshes/pdplot"
results="${RESULTS:-$root/results}/$(basename "$here")"
[[ -x "$pdrun" ]] || { echo "$pdrun: not built; run ./setup.sh build, or set PDRUN" >&2; exit 1; }
mkdir -p "$results"
# Of an expression of awk, such as "3.015*0.1/20", "2*pi" or "round(7/2)", to 15 digits.
computed() { awk "function round(x) { return int(x + 0.5) } BEGIN { pi = atan2(0, -1); printf \"%.15g\", $1 }"; }
