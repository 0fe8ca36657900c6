#!/usr/bin/python3
"""convergence.png: error against the spacing, and the same as a table; plot.py [RESULTS]"""
import json
import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

from pdplot_lib import figures  # noqa: E402

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
AREA = 0.2 * 0.1  # m2, of the plate
meshes = ["4k", "6k", "8k", "10k", "12k", "50k"]
styles = {("m", "false"): ("horizon 5 mm", "C0", "o--"), ("m", "true"): ("horizon 5 mm, rescaled", "C0", "o-"),
          ("delta", "false"): ("horizon 4 Δx", "C3", "s--"), ("delta", "true"): ("horizon 4 Δx, rescaled", "C3", "s-")}
figure, axes = figures.plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
for axis, deck, title in zip(axes, ("mechanics", "hydrogen"), ("displacement", "concentration")):
    for (kind, rescaled), (label, color, style) in styles.items():
        spacings, errors = [], []
        for mesh in meshes:
            report = json.loads((folder / f"{deck}_{kind}_{rescaled}_{mesh}.report.json").read_text())
            spacings.append(math.sqrt(AREA / report["points"]) * 1e3)
            errors.append(next(value for name, value in report["error_norms"].items() if "L2" in name))
        axis.loglog(spacings, errors, style, color=color, label=label, markersize=4)
        print(f"{title:14} {label:24}", "  ".join(f"{mesh}: {error:.2e}" for mesh, error in zip(meshes, errors)))
    axis.set_xlabel("spacing (mm)")
    axis.set_ylabel(f"relative L2 error of the {title}")
    axis.grid(alpha=0.3, which="both")
    axis.legend()
figure.savefig(folder / "convergence.png", dpi=110)
print(folder / "convergence.png")
