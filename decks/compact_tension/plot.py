#!/usr/bin/python3
"""growth.png: growth rates of the runs over the law of the deck, and crack lengths over cycles; plot.py [RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402

WIDTH, THICKNESS, MODULUS, LOAD, RATIO, PARIS, RANGE = 0.04, 0.0032, 205.9e9, 1750.0, 0.1, 1.615e-11, 15.0  # of the deck
INTEGRALS = {"J": "ring", "J_Of_Bonds": "rectangle", "J_Further_Out": "larger rectangle"}
HORIZONS = ("2.25", "1.125", "0.5625")  # mm
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def history(name):
    with open(folder / f"{name}.csv") as file:
        rows = list(csv.DictReader(file))
    return {key: np.array([float(row[key]) for row in rows]) for key in ("time", "Crack_Length", *INTEGRALS)}


def standard(a):
    """K of ASTM E647, Pa m^0.5, at the largest load."""
    x = a / WIDTH
    return (LOAD / (THICKNESS * np.sqrt(WIDTH)) * (2 + x) / (1 - x)**1.5
            * (0.886 + 4.64 * x - 13.32 * x**2 + 14.72 * x**3 - 5.6 * x**4))


def life_of_law(exponent, first, last):
    a = np.linspace(first, last, 2001)
    rate = PARIS * ((1 - RATIO) * standard(a) * 1e-6)**exponent
    return np.sum(0.5 * (1 / rate[1:] + 1 / rate[:-1]) * np.diff(a))


def intensity_ratio(run, length, horizon, integral="J"):
    """K by J over that of the standard, mean over the growth by two spacings about a length: a crack goes row by row."""
    near = np.abs(run["Crack_Length"] - length) < horizon / 3
    return np.mean(np.sqrt(np.maximum(run[integral][near], 0) * MODULUS) / standard(run["Crack_Length"][near]))


def draw_growth(axis):
    """Growth at a constant range of K."""
    print("constant range of K: da/dN over the law, growth from 13.5 mm on")
    for horizon in HORIZONS:
        for kind in ("range", "conical"):
            for exponent in (2.0, 3.0, 4.0):
                if not (folder / f"{kind}_{exponent}_{horizon}.csv").exists():
                    continue
                run = history(f"{kind}_{exponent}_{horizon}")
                ok = run["Crack_Length"] > 0.0135
                a, n = run["Crack_Length"][ok], run["time"][ok]
                law = PARIS * RANGE**exponent
                print(f"  {kind} M = {exponent}, horizon {horizon} mm: {np.polyfit(n, a, 1)[0] / law:.3f}")
                if horizon == HORIZONS[1]:
                    axis.plot((n - n[0]) * law * 1e3, (a - a[0]) * 1e3, "--" if kind == "conical" else "-",
                              label=f"M = {exponent:g}" + (", conical" if kind == "conical" else ""))
    axis.plot([0, 7], [0, 7], color="0.6", label="law")
    axis.set_xlabel("growth by the law of the deck (mm)")
    axis.set_ylabel("growth (mm)")


def draw_amplitude(of_intensity, of_length):
    """K, and lives at constant amplitude."""
    print("constant amplitude: K over that of the standard at a/W = 0.35, 0.4 ... 0.7; lives from 14 mm to 28 mm over the law's")
    at = WIDTH * np.arange(0.35, 0.701, 0.05)
    for horizon in HORIZONS:
        for exponent in (2.0, 3.0, 4.0):
            if not (folder / f"amplitude_{exponent}_{horizon}.csv").exists():
                continue
            run = history(f"amplitude_{exponent}_{horizon}")
            ratios = {integral: [intensity_ratio(run, a, float(horizon) * 1e-3, integral) for a in at]
                      for integral in INTEGRALS}
            lengths, first = np.unique(run["Crack_Length"], return_index=True)
            cycles = run["time"][first]
            start, end = np.interp([0.014, 0.028], lengths, cycles)
            total = life_of_law(exponent, 0.014, 0.028)
            print(f"  M = {exponent}, horizon {horizon} mm: life {(end - start) / total:.3f}")
            for integral, name in INTEGRALS.items():
                print(f"    K, {name}: " + " ".join(f"{ratio:.3f}" for ratio in ratios[integral]))
                if exponent == 3.0 and integral != "J_Further_Out":
                    of_intensity.plot(at / WIDTH, ratios[integral], "o-" if integral == "J" else "s--", fillstyle="none",
                                      label=f"horizon {horizon} mm, {name}")
            if horizon == HORIZONS[1]:
                color = of_length.plot((cycles - start) / total, lengths * 1e3)[0].get_color()
                grid = np.linspace(0.014, 0.028, 60)
                law = [0.0] + [life_of_law(exponent, 0.014, a) for a in grid[1:]]
                of_length.plot(np.array(law) / total, grid * 1e3, "--", color=color, label=f"M = {exponent:g}, law dashed")
    of_intensity.set_xlabel("a/W")
    of_intensity.set_ylabel("K by J over ASTM E647")
    of_intensity.set_ylim(0.95, 1.05)
    of_length.set_xlabel("cycles over the life by the law, from 14 mm on")
    of_length.set_ylabel("crack length (mm)")
    of_length.set_ylim(14, 28)
    of_length.set_xlim(0, 1.2)


figure, axes = figures.plt.subplots(1, 3, figsize=(14, 4), constrained_layout=True)
draw_growth(axes[0])
draw_amplitude(axes[1], axes[2])
for axis in axes:
    axis.grid(alpha=0.3)
    axis.legend()
figure.savefig(folder / "growth.png", dpi=150)
print(folder / "growth.png")
