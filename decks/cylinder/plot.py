#!/usr/bin/python3
"""flow.png: velocity and pressure round the cylinder; prints drag, lift and pressure difference; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from scipy.interpolate import griddata  # noqa: E402

DRAG, LIFT, DIFFERENCE = 5.57953523384, 0.010618948146, 0.11752016697  # John & Matthies; Nabh
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def pressure_at(place, x, p, spacing):
    """By a quadratic fit to the fluid points near a place on the cylinder."""
    d = (x - place) / spacing
    near = np.hypot(*d.T) < 3.3
    d, weight = d[near], (1 - np.hypot(*d[near].T) / 3.3)
    basis = np.column_stack([np.ones(len(d)), d, d[:, 0]**2, d[:, 0] * d[:, 1], d[:, 1]**2])
    return np.linalg.lstsq(basis * weight[:, None], p[near] * weight, rcond=None)[0][0]


def measure(name, points):
    x, _, p = Results(str(folder / name)).of_fluid("Velocity", "Pressure")
    history = read_history(folder / f"{name}.csv")
    drag, lift = 500 * history["DragX"][-1], 500 * history["DragY"][-1]
    difference = pressure_at((0.15, 0.2), x, p, 0.1 / points) - pressure_at((0.25, 0.2), x, p, 0.1 / points)
    flow = [history[key][-1] / (0.2 * 0.41) - 1 for key in ("Flow_Before", "Flow_Behind")]
    print(f"{name}: {len(x)} points, C_D {drag:.4f} ({100 * (drag / DRAG - 1):+.2f} %), C_L {lift:.4f} ({LIFT:.4f}), "
          f"pressure difference {difference:.5f} ({100 * (difference / DIFFERENCE - 1):+.2f} %), "
          f"mass flow {100 * flow[0]:+.2f} % before and {100 * flow[1]:+.2f} % behind")


def draw(name):
    x, v, p = Results(str(folder / name)).of_fluid("Velocity", "Pressure")
    grid = np.meshgrid(np.linspace(0, 1, 501), np.linspace(0, 0.41, 206))
    beyond = np.hypot(grid[0] - 0.2, grid[1] - 0.2) < 0.05
    u, w, pressure = (np.where(beyond, np.nan, griddata(x, values, tuple(grid), "linear"))
                      for values in (v[:, 0], v[:, 1], p))
    figure, (upper, lower) = figures.plt.subplots(2, 1, figsize=(9, 7), constrained_layout=True)
    shown = upper.pcolormesh(*grid, np.hypot(u, w), cmap="viridis")
    figure.colorbar(shown, ax=upper, label="speed (m/s)")
    upper.streamplot(grid[0], grid[1], u, w, color="w", linewidth=0.5, density=(2.4, 1.2), arrowsize=0.6)
    shown = lower.pcolormesh(*grid, pressure, cmap="RdBu_r", vmin=-0.15, vmax=0.15)
    figure.colorbar(shown, ax=lower, label="pressure (Pa)")
    for axis in (upper, lower):
        axis.set_aspect("equal")
        axis.add_patch(figures.plt.Circle((0.2, 0.2), 0.05, color="0.6"))
        axis.set_xlabel("x (m)")
    figure.savefig(folder / "flow.png", dpi=110)
    print(folder / "flow.png")


for run, points in (("channel_10", 10), ("shifted_10", 10), ("askew_10", 10), ("channel_20", 20)):
    if (folder / f"{run}.h5").exists():
        measure(run, points)
draw("channel_20")
