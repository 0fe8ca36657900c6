#!/usr/bin/python3
"""line.png: strain ranges over the lives of the runs, and the law of the deck; plot.py [RESULTS]"""
import csv
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from scipy.stats import linregress, t  # noqa: E402

COEFFICIENT, EXPONENT, LIMIT, RUN_OUT = 426.0, 2.77, 1.86e-3, 1e10  # of bar.yaml; the last of run.sh

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
figure, axis = figures.plt.subplots(figsize=(6, 4), constrained_layout=True)
ranges = LIMIT + np.logspace(-4.6, -2.1, 100)
axis.plot(1 / (COEFFICIENT * (ranges - LIMIT) ** EXPONENT), ranges, color="0.6", label="law of the deck")
axis.axhline(LIMIT, color="0.6", linestyle=":", label="limit")
worst = 0.0
for ratio, marker in (("-1", "o"), ("0", "x"), ("0.5", "+")):
    lives, strains = [], []
    for file in sorted(folder.glob(f"R{ratio}_*.csv")):
        with open(file) as text:
            last = list(csv.DictReader(text))[-1]
        strain, life = float(file.stem.split("_")[1]), float(last["time"])
        broke = float(last["Largest_Damage"]) == 1.0
        assert broke == (strain > LIMIT), file
        if broke:
            worst = max(worst, abs(life * COEFFICIENT * (strain - LIMIT) ** EXPONENT - 1))
        else:
            assert life == RUN_OUT and float(last["Largest_Damage"]) == 0.0, file
        lives.append(life)
        strains.append(strain)
    axis.plot(lives, strains, marker, fillstyle="none", label=f"R = {ratio}")
print(f"largest relative error of a life: {worst:.1e}")
axis.set_xscale("log")
axis.set_yscale("log")
axis.set_xlabel("cycles to failure (at 1e10: run-out)")
axis.set_ylabel("strain range")
axis.grid(alpha=0.3, which="both")
axis.legend()
figure.savefig(folder / "line.png", dpi=150)
print(folder / "line.png")

# The fit of fit.yaml beside a straight line through logarithms, ln N = -ln A1 - m1 ln(e - e_limit).
amplitude, cycles = np.loadtxt(Path(__file__).parent / "lives.csv", delimiter=",", skiprows=2).T
line = linregress(np.log(2 * amplitude - LIMIT), np.log(cycles))
student = t.ppf(0.975, len(cycles) - 2)
m1 = [-line.slope + side * student * line.stderr for side in (0, -1, 1)]
A1 = [np.exp(-line.intercept + side * student * line.intercept_stderr) for side in (0, -1, 1)]
with open(folder / "strain_life.fit.json") as text:
    for value, exact in zip(json.load(text)["values"], (A1, m1)):
        fitted = (value["value"], *value["interval"])
        print(f"{value['name']}: fitted {' '.join(f'{number:.6g}' for number in fitted)}, regression "
              f"{' '.join(f'{number:.6g}' for number in exact)}")
