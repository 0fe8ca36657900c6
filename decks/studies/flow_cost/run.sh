#!/bin/bash
# Meshes, all runs, tables and pictures of this study, into results/flow_cost: some ten minutes of processor time.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source "$here/../../scene.sh"
"$here/cost.py" "$pdrun" "$results" "$@"
