#!/usr/bin/python3
"""intensity.png: stress intensities of the runs over Tada's, and openings over the exact ones; penny.png: the same of round
cracks in space; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import numpy as np  # noqa: E402
import penny_openings  # noqa: E402
from openings import STRESS, YOUNG, exact, intensity, opening  # noqa: E402
from pdplot_lib import figures  # noqa: E402

RULES = {"Adaptive": "shares of bonds", "Uniform": "shares, n = 20", "Intersection": "intersection", "Both": "both",
         "Either": "either"}
COLORS = dict(zip(RULES, ("tab:blue", "black", "tab:orange", "tab:green", "tab:red")))
LINES = {"Uniform": ":"}
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
lengths = 9.875e-3 + 0.025e-3 * np.arange(11)

figure, (of_opening, of_intensity, of_error) = figures.plt.subplots(1, 3, figsize=(14, 4), constrained_layout=True)
secant, tada = exact(lengths)
of_intensity.plot(lengths * 1e3, tada * 1e-6, color="0.6", label="Tada")
print("K over Tada's - 1, %, half lengths 9.875 to 10.125 mm; secant", np.round(100 * (secant / tada - 1), 2))
for rule, label in RULES.items():
    k = np.array([intensity(*opening(folder / f"{rule}_{n}.h5"), a) for n, a in enumerate(lengths)])
    error = 100 * (k / tada - 1)
    print(f"  {rule:12}", np.round(error, 2), "monotone" if np.all(np.diff(k) > 0) else "not monotone")
    style = {"marker": "o", "fillstyle": "none", "markersize": 4, "color": COLORS[rule], "linestyle": LINES.get(rule, "-")}
    of_intensity.plot(lengths * 1e3, k * 1e-6, label=label, **style)
    of_error.plot(lengths * 1e3, error, label=label, **style)
    x, v = opening(folder / f"{rule}_8.h5")
    if rule != "Uniform":
        near = np.abs(x) < 10.6e-3
        of_opening.plot(x[near] * 1e3, v[near] * 1e6, label=label, color=COLORS[rule])
a = lengths[8]
x = np.linspace(-a, a, 401)
of_opening.plot(x * 1e3, 2 * STRESS / YOUNG * tada[8] / (STRESS * np.sqrt(np.pi * a)) * np.sqrt(a**2 - x**2) * 1e6, "--",
                color="0.3", label="exact, a = 10.075 mm")
of_opening.set_xlim(7.5, 10.8)
of_opening.set_ylim(0, 18)
of_opening.set_xlabel("x (mm)")
of_opening.set_ylabel("half the opening (µm)")
of_intensity.set_xlabel("half length of the crack (mm)")
of_intensity.set_ylabel("K (MPa √m)")
of_error.set_xlabel("half length of the crack (mm)")
of_error.set_ylabel("error of K (%)")
for axis in (of_opening, of_intensity, of_error):
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)
figure.savefig(folder / "intensity.png", dpi=150)
print(folder / "intensity.png")
penny_openings.draw(folder)
