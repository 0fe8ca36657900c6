#!/usr/bin/python3
"""paths.png and growth.png: cracks of all runs over the measured ones, lengths over cycles, rates over ranges of K; and
what the README states of them; plot.py [RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from measured import LIVES, PATHS  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from specimen import HOLES  # noqa: E402

MODULUS, RATIO, PARIS, EXPONENT = 205.9e9, 0.1, 1.615e-11, 2.08  # of the deck; Pa, 1, m/cycle at 1 MPa sqrt(m), 1
RUNS = [("1", "0.5"), ("2", "0.5"), ("2", "0.25"), ("3", "0.5"), ("4", "0.5")]
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def theory(specimen):
    """lefm.py: x, y, length, K_I, K_II, cycles [steps]."""
    return np.loadtxt(folder / f"lefm_{specimen}.csv", delimiter=",", skiprows=1).T


class Run:
    def __init__(self, specimen, spacing):
        self.specimen, self.spacing = specimen, float(spacing)
        with open(folder / f"specimen_{specimen}_{spacing}.csv") as file:
            rows = list(csv.DictReader(file))[1:]  # before the first look there is no load
        self.cycles, self.length, x, y, energy, peak = (
            np.array([float(row[key]) for row in rows])
            for key in ("time", "Crack_Length", "Crack_TipX", "Crack_TipY", "J", "Peak_Load"))
        self.length *= 1e3
        self.tips = np.stack([x, y], axis=1) * 1e3
        self.largest = np.sqrt(np.maximum(energy, 0) * MODULUS) * peak * 1e-6  # MPa sqrt(m)
        name = f"specimen {specimen}, " + ("no holes, " if specimen == "1" else "") + f"horizon {3 * self.spacing:g} mm"
        self.name = name

    def cycles_at(self, length):
        """When the crack had first that length (mm)."""
        return np.interp(length, np.maximum.accumulate(self.length), self.cycles)

    def height_at(self, x):
        ahead = np.maximum.accumulate(self.tips[:, 0])
        first = np.concatenate([[True], np.diff(ahead) > 0])
        return np.interp(x, ahead[first], self.tips[first, 1])

    def end(self):
        """Name and distance (mm) of the hole that is nearest to the last tip."""
        distance = {name: np.hypot(*(self.tips[-1] - hole[:2])) - hole[2] for name, hole in zip("abc", HOLES)}
        return min(distance.items(), key=lambda item: item[1])

    def rates(self, step=1.0):
        """Mean rates (m/cycle) and ranges of K over growth by `step` mm."""
        a = np.arange(np.ceil(self.length[0]) + 1.0, self.length.max() - 1.0, step)
        middle = [self.largest[(self.length > low) & (self.length < low + step)] for low in a[:-1]]
        ranges = np.array([(1 - RATIO) * np.median(k) if len(k) else np.nan for k in middle])
        return ranges, np.diff(a) * 1e-3 / np.diff(self.cycles_at(a))


def report(run):
    print(run.name + f": {len(run.cycles)} steps; K_max at 11.5 mm "
          f"{np.median(run.largest[np.abs(run.length - 11.5) < 0.4]):.2f} MPa m^0.5")
    ranges, rates = run.rates()
    print("   da/dN over the law: " + " ".join(f"{value:.2f}" for value in rates / (PARIS * ranges**EXPONENT)))
    _, _, lengths, _, _, ends = theory(run.specimen)
    first = LIVES[run.specimen][0, 1] if run.specimen in LIVES else 11.5
    for last in (14.0, 16.0, 18.0, 20.0, 25.0):
        if last < min(run.length.max(), lengths.max()):
            own = run.cycles_at(last) - run.cycles_at(first)
            print(f"   cycles from {first} to {last} mm over those of finite elements: "
                  f"{own / np.diff(np.interp([first, last], lengths, ends))[0]:.2f}")
    if run.specimen not in PATHS:
        return
    path, life = PATHS[run.specimen], LIVES[run.specimen]
    name, distance = run.end()
    print(f"   ends {distance:.2f} mm from the rim of hole {name}, at {run.tips[-1].round(2)}; measured {path[-1]}")
    x = path[:, 0]
    shown = path[(x > 8.5) & (x < run.tips[:, 0].max()) & (np.maximum.accumulate(x) == x)]
    off = run.height_at(shown[:, 0]) - shown[:, 1]
    print("   y less measured: " + " ".join(f"{x:.1f}:{y:+.2f}" for x, y in zip(shown[::3, 0], off[::3])))
    inside = life[life[:, 1] < run.length.max()]
    cycles = run.cycles_at(inside[:, 1]) - run.cycles_at(inside[0, 1])
    print("   cycles over measured: " + " ".join(f"{a:.1f}:{n / m:.2f}" for (m, a), n in zip(inside[1:], cycles[1:])))


def draw_paths(runs):
    figure, axes = figures.plt.subplots(1, 3, figsize=(14, 4.6), constrained_layout=True, sharey=True)
    for axis, specimen in zip(axes, "234"):
        for x, y, radius in HOLES:
            axis.add_patch(figures.plt.Circle((x, y), radius, color="0.85"))
        axis.plot(*PATHS[specimen].T, "k.", markersize=4, label="measured")
        for run in (run for run in runs if run.specimen == specimen):
            axis.plot(*run.tips.T, linewidth=1, label=f"horizon {3 * run.spacing:g} mm")
        axis.plot(*theory(specimen)[:2], "k--", linewidth=0.8, label="finite elements")
        axis.set_title(f"specimen {specimen}")
        axis.set_xlim(7, 33)
        axis.set_ylim(-12, 12)
        axis.set_aspect("equal")
        axis.set_xlabel("x (mm)")
        axis.legend(loc="lower left")
    axes[0].set_ylabel("y (mm)")
    figure.savefig(folder / "paths.png", dpi=120)


def draw_growth(runs):
    figure, axes = figures.plt.subplots(1, 2, figsize=(11, 4.2), constrained_layout=True)
    for number, run in enumerate(runs):
        color = f"C{number}"
        start = LIVES[run.specimen][0, 1] if run.specimen in LIVES else 11.5
        axes[0].plot((run.cycles - run.cycles_at(start)) * 1e-6, run.length, color=color, label=run.name)
        ranges, rates = run.rates()
        if np.isfinite(ranges).any():
            axes[1].loglog(ranges, rates, "o", color=color, fillstyle="none", label=run.name)
    for specimen, mark in zip("234", "osv"):
        axes[0].plot(LIVES[specimen][:, 0] * 1e-6, LIVES[specimen][:, 1], "k" + mark, fillstyle="none",
                     label=f"specimen {specimen}, measured")
    for specimen in ("1", "2"):
        _, _, length, _, _, cycles = theory(specimen)
        start = LIVES[specimen][0, 1] if specimen in LIVES else 11.5
        axes[0].plot((cycles - np.interp(start, length, cycles)) * 1e-6, length, "k--", linewidth=0.8,
                     label=f"specimen {specimen}, finite elements")
    ranges = np.array([9.0, 120.0])
    axes[1].loglog(ranges, PARIS * ranges**EXPONENT, color="0.6", label="law of the deck")
    axes[0].set_xlabel("cycles (10⁶)")
    axes[0].set_ylabel("crack length from the load line (mm)")
    axes[0].set_xlim(0, 1.5)
    axes[0].set_ylim(11, 31)
    axes[1].set_xlabel("range of K by J (MPa m$^{0.5}$)")
    axes[1].set_ylabel("da/dN (m/cycle)")
    for axis in axes:
        axis.grid(alpha=0.3, which="both")
        axis.legend(fontsize=7)
    figure.savefig(folder / "growth.png", dpi=120)


all_runs = [Run(*run) for run in RUNS if (folder / f"specimen_{run[0]}_{run[1]}.csv").exists()]
for one in all_runs:
    report(one)
draw_paths(all_runs)
draw_growth(all_runs)
print(folder / "paths.png", folder / "growth.png")
