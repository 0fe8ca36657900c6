#!/usr/bin/python3
"""Speed against error of the solver's methods: methods.png and its table; study.py PDRUN DECK [RESULTS]"""
import os
import re
import resource
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import read_history  # noqa: E402

METHODS = {"Euler": {}, "RKL": {}, "Backward Euler": {}, "SDIRK2": {},
           "Backward Euler, Polak-Ribière": {"Method": "Backward Euler", "Nonlinear Solver": "Polak Ribiere"}}
STEPS = (0.0125, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8)
REFERENCE_STEP, TIME, OUTPUTS = 0.001, 100.0, 20


def run(method, step):
    """Depths at the outputs from 10 s on, evaluations of the flux, CPU time in s, longest step in s."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    settings = {"Output/Output Filename": "study", "Output/Output Frequency": 1, "Solver/Final Time": TIME,
                "Solver/Corrosion/Load Steps": OUTPUTS, "Solver/Corrosion/Method": method,
                "Solver/Corrosion/Fixed dt": step}
    settings.update({f"Solver/Corrosion/{key}": value for key, value in METHODS[method].items()})
    command = [pdrun, deck] + [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    text = subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    evaluations = int(re.search(r"(\d+) evaluations", text).group(1))
    longest = float(re.search(r"steps of \S+ to (\S+) s", text).group(1))
    history = read_history(folder / "study.csv")
    depth = history["Dissolved"][history["time"] >= 0.1 * TIME]
    return depth, evaluations, after.ru_utime - before.ru_utime, longest


def main():
    reference, evaluations, seconds, _ = run("Euler", REFERENCE_STEP)
    print(f"reference: Euler, {REFERENCE_STEP} s: {reference[-1] * 1e6:.4f} um, {evaluations} evaluations, {seconds:.1f} s")
    figure, axes = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True, sharey=True)
    for method, marker in zip(METHODS, "os^dv"):
        rows = []
        for step in STEPS:
            depth, evaluations, seconds, longest = run(method, step)
            error = np.sqrt(np.mean((depth / reference - 1) ** 2)) * 100
            rows.append((step, evaluations, error))
            print(f"| {method} | {step} | {longest:.3g} | {error:.3f} % | {evaluations} | {seconds:.2f} s |", flush=True)
        step, evaluations, error = np.array(rows).T
        axes[0].loglog(step, error, marker=marker, label=method)
        axes[1].loglog(evaluations, error, marker=marker, label=method)
    axes[0].set_xlabel("time step (s)")
    axes[1].set_xlabel("evaluations of the flux")
    axes[0].set_ylabel("error of the depth in time (%)")
    for axis in axes:
        axis.grid(alpha=0.3, which="both")
        axis.legend(fontsize=8)
    for axis, ticks in ((axes[0].xaxis, STEPS), (axes[0].yaxis, (0.05, 0.1, 0.2, 0.5))):
        axis.set_ticks(ticks, [f"{tick:g}" for tick in ticks])
        axis.set_ticks([], minor=True)
    figure.savefig(folder / "methods.png", dpi=110)
    print(folder / "methods.png")


pdrun, deck = (os.path.abspath(path) for path in sys.argv[1:3])
folder = Path(sys.argv[3] if len(sys.argv) > 3 else ".").resolve()
if __name__ == "__main__":
    main()
