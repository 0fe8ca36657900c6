#!/usr/bin/python3
"""Speed against error of ways to step the crevice in time: methods_*.png and tables; study.py PDRUN DECK [RESULTS]

The error is that in time: against a run with much smaller limits on the same mesh."""
import os
import re
import resource
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from crevice_run import CREVICE, HOUR, Run  # noqa: E402
from pdplot_lib import figures  # noqa: E402

# How far the attack has come before it nears the mouth; and how deep the trench is at the end.
SITE_HOURS, END = (2, 5, 10), 72
FIRST = 0.5  # h, of the comparison of nonlinear solvers
COMPARED = {"Method": "Backward Euler", "Front Limit": 1.0, "Relative Tolerance": 1e-2}
SITE_REFERENCE, TRENCH_REFERENCE = ("SDIRK2", 0.25, 1e-5), ("SDIRK2", 0.25, 1e-3)  # method, front limit, tolerance
SITE = {"Backward Euler, tolerance from 0.01 to 0.00003": [("Backward Euler", 1.0, t) for t in
                                                           (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5)],
        "SDIRK2, tolerance from 0.01 to 0.0001": [("SDIRK2", 1.0, t) for t in (1e-2, 3e-3, 1e-3, 3e-4, 1e-4)]}
TRENCH = {"Backward Euler, tolerance 0.01, front limit from 2 to 0.25": [("Backward Euler", limit, 1e-2) for limit in
                                                                         (2.0, 1.0, 0.5, 0.25)],
          "Backward Euler, tolerance 0.001, front limit from 2 to 0.5": [("Backward Euler", limit, 1e-3) for limit in
                                                                         (2.0, 1.0, 0.5)],
          "SDIRK2, tolerance 0.01, front limit from 2 to 0.5": [("SDIRK2", limit, 1e-2) for limit in (2.0, 1.0, 0.5)]}


def solve(hours, increments, **settings):
    """Of a run of that length: steps, evaluations of the flux, CPU time in s."""
    given = {"Output/Output Filename": "study", "Solver/Final Time": hours * HOUR,
             "Solver/Corrosion/Load Steps": increments}
    given.update({f"Solver/Corrosion/{key}": value for key, value in settings.items()})
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    command = [pdrun, deck] + [word for key, value in given.items() for word in ("--set", f"{key}={value}")]
    text = subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    counts = [int(re.search(rf"(\d+) {unit}", text).group(1)) for unit in ("steps of", "evaluations")]
    return *counts, seconds


def run(hours, method, limit, tolerance):
    work = solve(hours, hours, **{"Method": method, "Front Limit": limit, "Relative Tolerance": tolerance})
    return work, Run(folder / "study")


def sites(case):
    """Work; % of L."""
    work, found = run(SITE_HOURS[-1], *case)
    return work, np.array([found.active_site(found.at(hour)) for hour in SITE_HOURS]) / CREVICE.length * 100


def trench(case):
    """Work; depth, and place of it along the crevice, in um."""
    work, found = run(END, *case)
    depth = found.depth(found.at(END))
    return work, np.array([depth.max(), found.x[found.isCrevice][np.argmax(depth)]]) * 1e6


def compare(measure, reference, series):
    """Prints and returns {name: [(evaluations, errors), ...]}."""
    work, exact = measure(reference)
    print(f"reference {reference}: {exact}, {work}")
    found = {}
    for name, cases in series.items():
        found[name] = []
        for case in cases:
            (steps, evaluations, seconds), values = measure(case)
            found[name].append((evaluations, values - exact))
            print("| {} | {:g} | {:g} |".format(*case), f"{steps} | {evaluations} | {seconds:.0f} s | "
                  + " | ".join(f"{value:+.2f}" for value in values - exact) + " |", flush=True)
    return found


def draw(name, title, found, norm):
    figure, axis = figures.plt.subplots(figsize=(6.4, 4.2), constrained_layout=True)
    for (label, points), marker in zip(found.items(), "osd"):
        axis.loglog([n for n, _ in points], [norm(off) for _, off in points], marker=marker, label=label)
    axis.set_xlabel("evaluations of the flux")
    axis.set_ylabel(title)
    axis.margins(y=0.3)  # room for the legend
    axis.grid(alpha=0.3, which="both")
    axis.legend(fontsize=8, loc="upper right")
    figure.savefig(folder / name, dpi=110)
    print(folder / name)


def main():
    draw("methods_site.png", "error in time of the site at 2, 5, 10 h (r.m.s., % of L)",
         compare(sites, SITE_REFERENCE, SITE), lambda off: np.sqrt(np.mean(off**2)))
    draw("methods_trench.png", "error in time of the depth at 72 h (µm)",
         compare(trench, TRENCH_REFERENCE, TRENCH), lambda off: abs(off[0]))
    for solver in ("Newton Krylov", "Polak Ribiere"):
        for step, settings in (("adaptive", {}), ("5 s", {"Fixed dt": 5.0})):
            steps, evaluations, seconds = solve(FIRST, 1, **{**COMPARED, "Nonlinear Solver": solver, **settings})
            print(f"{solver}, {step}, first {FIRST} h: {steps} steps, {evaluations} evaluations, {seconds:.1f} s")


pdrun, deck = (os.path.abspath(path) for path in sys.argv[1:3])
folder = Path(sys.argv[3] if len(sys.argv) > 3 else ".").resolve()
if __name__ == "__main__":
    main()
