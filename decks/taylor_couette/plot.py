#!/usr/bin/python3
"""annulus.png: flow between cylinders against the exact one; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

POINTS = (10, 20, 40)
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def exact_velocity(r):
    return (1 / r - r) / (1 / 0.4 - 0.4)


def exact_pressure(r):
    """But for a constant: dp/dr = v^2/r."""
    factor = 1 / (1 / 0.4 - 0.4)
    return factor**2 * (r**2 / 2 - 2 * np.log(r) - 1 / (2 * r**2))


figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
errors, pressures = [], []
for n in POINTS:
    results = Results(str(folder / f"annulus_{n}"))
    step = results.steps[-1]
    inside = results.field("Fluid", step) == 1
    x, y = results.x[inside, 0], results.x[inside, 1]
    r = np.hypot(x, y)
    velocity = results.field("Velocity", step)[inside, :2]
    exact = (exact_velocity(r) / r)[:, None] * np.column_stack([-y, x])
    errors.append(np.sqrt(np.sum((velocity - exact)**2) / np.sum(exact**2)))
    pressure, known = results.field("Pressure", step)[inside], exact_pressure(r)
    known -= known.mean()
    pressures.append(np.sqrt(np.sum((pressure - pressure.mean() - known)**2) / np.sum(known**2)))
    if n == 10:
        left.plot(r, (x * velocity[:, 1] - y * velocity[:, 0]) / r, ".", markersize=4, label="10 points a radius")
radii = np.linspace(0.4, 1, 101)
left.plot(radii, exact_velocity(radii), "k-", linewidth=0.8, label="exact")
left.set_xlabel("radius (m)")
left.set_ylabel("velocity along the circle (m/s)")
left.legend(fontsize=7)
for values, label in ((errors, "velocity"), (pressures, "pressure")):
    right.loglog(POINTS, values, "o-", markersize=4, label=label)
    print(f"{label}: L2 error " + " ".join(f"{value:.2e}" for value in values))
right.loglog(POINTS, [errors[0] * (POINTS[0] / n)**2 for n in POINTS], "k:", linewidth=0.8, label="second order")
right.set_xlabel("points a radius")
right.set_ylabel("relative error (L2)")
right.set_xticks(POINTS, POINTS)
right.minorticks_off()
right.legend(fontsize=7)
figure.savefig(folder / "annulus.png", dpi=110)
print(folder / "annulus.png")
