#!/usr/bin/python3
"""wake.png: the wake of a cylinder in a wide flow; prints drag, length of the wake, separation; plot_wide.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from scipy.interpolate import griddata  # noqa: E402

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
SPACING = 1 / 14


def fluid(name):
    results = Results(str(folder / name))
    step = results.steps[-1]
    x = results.x[:, :2]
    inside = (results.field("Fluid", step) == 1) & (np.abs(x).max(axis=1) < 5)
    return x[inside], results.field("Velocity", step)[inside, :2]


def wake_length(x, v, spacing):
    """Where the velocity on the axis turns: from the cylinder, in diameters. Even in y, through two rows."""
    rows = np.unique(np.round(x[:, 1], 9))[:2]
    first, second = (np.abs(x[:, 1] - row) < 1e-6 for row in rows)
    places = np.intersect1d(np.round(x[first, 0], 9), np.round(x[second, 0], 9))
    places = places[places > 0.5 + spacing]
    one, two = (np.array([v[row & (np.abs(x[:, 0] - place) < 1e-6), 0][0] for place in places])
                for row in (first, second))
    middle = one - (two - one) * rows[0]**2 / (rows[1]**2 - rows[0]**2)
    k = np.flatnonzero((middle[:-1] < 0) & (middle[1:] >= 0))[-1]
    return places[k] - middle[k] * (places[k + 1] - places[k]) / (middle[k + 1] - middle[k]) - 0.5


def separation(x, v, spacing):
    """Angle from the rear at which the shear at the cylinder is none: u_t = (a + b d + c d^2) s + ... + O(s^4)."""
    r, angle = np.hypot(*x.T), np.degrees(np.arctan2(x[:, 1], x[:, 0]))
    tangential = (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0]) / r
    near = (r - 0.5 < 3.2 * spacing) & (np.abs(angle - 43) < 18)
    s, d = r[near] - 0.5, (angle[near] - 43) / 10
    basis = np.column_stack([s, s * d, s * d * d, s**2, s**2 * d, s**2 * d * d, s**3, s**3 * d])
    a, b, c = np.linalg.lstsq(basis, tangential[near], rcond=None)[0][:3]
    return 43 + 10 * min(np.roots([c, b, a]).real, key=abs)


def draw(name):
    x, v = fluid(name)
    x, v = np.vstack([x, x * [1, -1]]), np.vstack([v, v * [1, -1]])
    grid = np.meshgrid(np.linspace(-1.5, 3.5, 501), np.linspace(-1.5, 1.5, 301))
    beyond = np.hypot(*grid) < 0.5
    u, w = (np.where(beyond, np.nan, griddata(x, values, tuple(grid), "linear")) for values in v.T)
    figure, axis = figures.plt.subplots(figsize=(9, 5), constrained_layout=True)
    shown = axis.pcolormesh(*grid, u, cmap="RdBu_r", vmin=-1.2, vmax=1.2)
    figure.colorbar(shown, ax=axis, label="velocity along x (m/s)")
    axis.streamplot(grid[0], grid[1], u, w, color="k", linewidth=0.5, density=2, arrowsize=0.6)
    axis.add_patch(figures.plt.Circle((0, 0), 0.5, color="0.6"))
    axis.set_aspect("equal")
    axis.set_xlabel("x (m)")
    figure.savefig(folder / "wake.png", dpi=110)
    print(folder / "wake.png")


x, v = fluid("wide")
drag = 4 * read_history(folder / "wide.csv")["DragX"][-1]
print(f"C_D {drag:.4f}, wake {wake_length(x, v, SPACING):.3f} diameters, separation {separation(x, v, SPACING):.1f} "
      "degrees from the rear")
draw("wide")
