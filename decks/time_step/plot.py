#!/usr/bin/python3
"""order.png: error against the time step and against the bond-updates it took, with the observed orders; plot.py [RESULTS]"""
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
exact = Results(folder / "RKC_20480")
reference = exact.field("Concentration", exact.steps[-1])
duration = exact.time(exact.steps[-1])


def bond_updates(file):
    return sum(phase["bond_updates"] for phase in json.loads(file.read_text())["phases"])


figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
for method in sorted({file.stem.split("_")[0] for file in folder.glob("*_*.h5")}):
    runs = sorted(int(file.stem.split("_")[1]) for file in folder.glob(f"{method}_*.h5"))
    runs = [steps for steps in runs if steps != 20480]
    errors, work = [], []
    for steps in runs:
        results = Results(folder / f"{method}_{steps}")
        field = results.field("Concentration", results.steps[-1])
        errors.append(np.linalg.norm(field - reference) / np.linalg.norm(reference))
        work.append(bond_updates(folder / f"{method}_{steps}.report.json"))
    sizes = duration / np.array(runs)
    order = np.polyfit(np.log(sizes), np.log(errors), 1)[0]
    left.loglog(sizes, errors, "o-", markersize=4, label=f"{method}: order {order:.2f}")
    right.loglog(work, errors, "o-", markersize=4, label=method)
    print(f"{method}: observed order {order:.3f}; " + "  ".join(f"{s:.3g} s: {e:.2e}" for s, e in zip(sizes, errors)))
left.set_xlabel("time step (s)")
right.set_xlabel("directed bond-updates")
for axis in (left, right):
    axis.set_ylabel("relative L2 error")
    axis.grid(alpha=0.3, which="both")
    axis.legend()
figure.savefig(folder / "order.png", dpi=150)
print(folder / "order.png")
