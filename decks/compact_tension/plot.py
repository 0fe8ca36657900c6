#!/usr/bin/python3
"""growth.png: growth rates of the runs over the law of the deck, and crack lengths over cycles; plot.py [RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402

WIDTH, THICKNESS, YOUNG, LOAD, RATIO, PARIS, RANGE = 0.04, 0.0032, 211e9, 1750.0, 0.1, 1.615e-11, 15.0  # of the deck
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def history(name):
    with open(folder / f"{name}.csv") as file:
        rows = list(csv.DictReader(file))
    return {key: np.array([float(row[key]) for row in rows]) for key in ("time", "Crack_Length", "J")}


def standard(a):
    """K of ASTM E647, Pa m^0.5, at the largest load."""
    x = a / WIDTH
    return (LOAD / (THICKNESS * np.sqrt(WIDTH)) * (2 + x) / (1 - x)**1.5
            * (0.886 + 4.64 * x - 13.32 * x**2 + 14.72 * x**3 - 5.6 * x**4))


def cycles_between(a, n, first, last):
    return np.interp(last, a, n) - np.interp(first, a, n)


def life_of_law(exponent, first, last):
    a = np.linspace(first, last, 2001)
    rate = PARIS * ((1 - RATIO) * standard(a) * 1e-6)**exponent
    return np.sum(0.5 * (1 / rate[1:] + 1 / rate[:-1]) * np.diff(a))


figure, axes = figures.plt.subplots(1, 3, figsize=(14, 4), constrained_layout=True)
print("constant range of K: da/dN over the law, growth from 13.5 mm on")
for name, exponent, mark in (("range_2.0", 2.0, "-"), ("range_3.0", 3.0, "-"), ("range_4.0", 4.0, "-"),
                             ("range_conical", 3.0, "--")):
    run = history(name)
    ok = run["Crack_Length"] > 0.0135
    a, n = run["Crack_Length"][ok], run["time"][ok]
    law = PARIS * RANGE**exponent
    print(f"  {name}: {np.polyfit(n, a, 1)[0] / law:.3f}")
    axes[0].plot((n - n[0]) * law * 1e3, (a - a[0]) * 1e3, mark, label=name.replace("range_", "").replace("_", " "))
axes[0].plot([0, 7], [0, 7], color="0.6", label="law")
axes[0].set_xlabel("growth by the law of the deck (mm)")
axes[0].set_ylabel("growth (mm)")
print("constant amplitude: K by J over that of the standard at a/W = 0.35, 0.4 ... 0.7; lives from 14 mm to 28 mm over the law's")
for exponent in (2.0, 3.0, 4.0):
    run = history(f"amplitude_{exponent}")
    lengths, first = np.unique(run["Crack_Length"], return_index=True)
    at = WIDTH * np.arange(0.35, 0.701, 0.05)
    intensity = np.sqrt(np.maximum(run["J"], 0) * YOUNG)
    nearest = [np.argmin(np.abs(run["Crack_Length"] - a)) for a in at]
    ratios = intensity[nearest] / standard(run["Crack_Length"][nearest])
    cycles = run["time"][first]
    life = cycles_between(lengths, cycles, 0.014, 0.028) / life_of_law(exponent, 0.014, 0.028)
    print(f"  M = {exponent}: K " + " ".join(f"{ratio:.3f}" for ratio in ratios) + f"; life {life:.3f}")
    axes[1].plot(at / WIDTH, ratios, "o-", fillstyle="none", label=f"M = {exponent:g}")
    grid = np.linspace(0.014, 0.028, 60)
    law = np.array([0.0] + [life_of_law(exponent, 0.014, a) for a in grid[1:]])
    total = law[-1]
    color = axes[2].plot((cycles - np.interp(0.014, lengths, cycles)) / total, lengths * 1e3)[0].get_color()
    axes[2].plot(law / total, grid * 1e3, "--", color=color, label=f"M = {exponent:g}, law dashed")
axes[1].set_xlabel("a/W")
axes[1].set_ylabel("K by J over ASTM E647")
axes[2].set_xlabel("cycles over the life by the law, from 14 mm on")
axes[2].set_ylabel("crack length (mm)")
axes[2].set_ylim(14, 28)
axes[2].set_xlim(0, 1.2)
for axis in axes:
    axis.grid(alpha=0.3)
    axis.legend()
figure.savefig(folder / "growth.png", dpi=150)
print(folder / "growth.png")
