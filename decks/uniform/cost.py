#!/usr/bin/python3
"""Cost of a step against points: strips whose electrolyte or whose metal is made deeper; cost.png and its table.

cost.py PDRUN [RESULTS]    some minutes; for times of evaluations the machine should do nothing else
"""
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402

SPACING, ROWS = 1e-6, 200
LEAST = 40  # columns of the electrolyte and of the metal
COLUMNS = (40, 80, 160, 320, 640)  # of the one that grows
FEW, MANY, STEP = 10, 60, 0.5  # steps of two runs, whose difference is free of what comes once; s


def run(electrolyte, metal, steps, folder):
    """(processor time, seconds of one evaluation of fluxes) of a strip of so many columns of each."""
    x, y = np.meshgrid(SPACING * (np.arange(-electrolyte, metal) + 0.5), SPACING * (np.arange(ROWS) + 0.5))
    table = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size), np.ones(x.size), np.full(x.size, SPACING**2)])
    np.savetxt(folder / "strip.txt", table, fmt=["%.9g"] * 3 + ["%d", "%.9g"])
    settings = {"Solver/Final Time": steps * STEP, "Solver/Corrosion/Load Steps": 1, "Solver/Corrosion/Fixed dt": STEP,
                "Boundary Conditions/Mouth Node Set/Expression": f"x < {(5 - electrolyte) * SPACING!r}"}
    command = [pdrun, "strip.yaml", "--quiet"]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    report = json.loads((folder / "strip.report.json").read_text())
    flux = next(phase for phase in report["phases"] if phase["name"] == "flux divergence")
    return seconds, flux["seconds"] / flux["calls"]


def measure(grows):
    """Processor time of a step and time of an evaluation of fluxes, ms, of each number of columns."""
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "strip.yaml").write_text((HERE / "strip.yaml").read_text())
        for columns in COLUMNS:
            electrolyte, metal = (columns, LEAST) if grows == "electrolyte" else (LEAST, columns)
            few, many = (run(electrolyte, metal, steps, folder) for steps in (FEW, MANY))
            rows.append(((many[0] - few[0]) / (MANY - FEW), many[1]))
            times = " | ".join(f"{seconds * 1e3:.3g}" for seconds in rows[-1])
            print(f"| {electrolyte * ROWS} | {metal * ROWS} | {times} |", flush=True)
    return np.array(rows).T * 1e3


def main():
    print("| points of electrolyte | of metal | a step (ms) | an evaluation of fluxes (ms) |")
    figure, axes = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True, sharey=True)
    points = ROWS * np.array(COLUMNS)
    for axis, grows, rest in zip(axes, ("electrolyte", "metal"), ("metal", "electrolyte")):
        for seconds, label in zip(measure(grows), ("step of 0.5 s", "evaluation of the fluxes")):
            axis.loglog(points, seconds, "o-", markersize=4, label=label)
            if grows == "electrolyte":
                axis.loglog(points, seconds[-1] * points / points[-1], "k--", linewidth=0.8)
            print(f"{label}: {seconds[-1] / seconds[0]:.3g} times for {points[-1] / points[0]:g} times the {grows}")
        axis.set_xlabel(f"points of {grows} ({LEAST * ROWS} of {rest})")
        axis.grid(alpha=0.3, which="both")
    axes[0].set_ylabel("time (ms); dashed: in proportion")
    axes[0].legend(fontsize=8)
    figure.savefig(results / "cost.png", dpi=110)
    print(results / "cost.png")


pdrun = os.path.abspath(sys.argv[1])
results = Path(sys.argv[2] if len(sys.argv) > 2 else ".").resolve()
if __name__ == "__main__":
    main()
