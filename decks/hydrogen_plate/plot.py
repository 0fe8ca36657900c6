#!/usr/bin/python3
"""Pictures of the hydrogen plate: plot.py [FOLDER OF THE RESULTS]

damage.png and coverage.png at four load steps, crack_length.png over time, and, where run.sh compare has been run,
comparison.png: crack length against the place where the coverage is 0.74, for its cases.
"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import PlotError, Results, read_history  # noqa: E402

SATURATION = 2.65e-5
# f(psi)^2 = G / G_c = 0.1005 of the strip, with f the law of the deck (README.md).
CRITICAL_COVERAGE = 0.74
DAY = 86400.0


def coverage_front(results, step):
    """Largest x (m) on the rows beside y = 0 up to which the coverage is critical without a gap."""
    rows = np.abs(results.x[:, 1]) < results.spacing()
    order = np.argsort(results.x[rows, 0])
    x = results.x[rows, 0][order]
    enough = (results.field("Concentration", step)[rows] / SATURATION)[order] >= CRITICAL_COVERAGE
    return x[-1] if enough.all() else x[max(0, int(np.argmin(enough)) - 1)]


def maps(folder):
    results = Results(folder / "hydrogen_plate")
    damage = figures.View("Damage", limits=(0.0, 0.6))
    coverage = figures.View("Concentration", factor=1 / SATURATION, unit="C / C_sv", limits=(0.0, 1.0), crack=0.36)
    for view, name, wanted in ((damage, "damage", (900, 1200, 1500, 1700)),
                               (coverage, "coverage", (900, 1200, 1500, 3000))):
        steps = [step for step in wanted if step in results.steps] or results.steps[-1:]
        figure = figures.map_panels([(results, step, figures.step_title(results, step)) for step in steps], view)
        save(figure, folder / f"{name}.png")


def crack_length(folder):
    history = read_history(folder / "hydrogen_plate.csv")
    figure, axis = figures.plt.subplots(figsize=(6, 3.6), constrained_layout=True)
    axis.plot(history["time"] / DAY, history["Crack_Length"] * 1e3)
    axis.set_xlabel("time (d)")
    axis.set_ylabel("crack length (mm)")
    axis.set_ylim(0, 205)
    axis.grid(alpha=0.3)
    save(figure, folder / "crack_length.png")


def comparison(folder):
    cases = [("hydrogen_plate", "s_c ∝ f(ψ)", "C3"), ("fracture_energy_law", "G_c ∝ f(ψ)", "C0"),
             ("no_hydrogen", "no hydrogen", "C2"), ("one_relaxation", "s_c ∝ f(ψ), one relaxation a load step", "C1")]
    if not all((folder / f"{name}.csv").exists() for name, _, _ in cases):
        return
    figure, axis = figures.plt.subplots(figsize=(6.4, 4), constrained_layout=True)
    for name, label, color in cases:
        history = read_history(folder / f"{name}.csv")
        axis.plot(history["time"] / DAY, history["Crack_Length"] * 1e3, color=color, label=label)
        if name not in ("no_hydrogen", "one_relaxation"):
            results = Results(folder / name)
            front = [coverage_front(results, step) * 1e3 for step in results.steps]
            axis.plot([results.time(step) / DAY for step in results.steps], front, "--", color=color, linewidth=1,
                      label=f"ψ = {CRITICAL_COVERAGE} on y = 0, {label}")
    axis.set_xlabel("time (d)")
    axis.set_ylabel("x (mm)")
    axis.grid(alpha=0.3)
    axis.legend()
    save(figure, folder / "comparison.png")


def save(figure, file):
    figure.savefig(file, dpi=150)
    print(file)


if __name__ == "__main__":
    where = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    try:
        maps(where)
        crack_length(where)
        comparison(where)
    except PlotError as error:
        sys.exit(f"plot.py: {error}")
