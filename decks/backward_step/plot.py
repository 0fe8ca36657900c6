#!/usr/bin/python3
"""flow.png, wall.png: flow behind a step; prints where it comes back to the wall; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from scipy.interpolate import griddata  # noqa: E402

RUNS = (("step_10", 10), ("step_20", 20), ("shifted_20", 20))
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def wall_shear(x, u, points):
    """du/dy at y = 0 behind the step, by u = a y + b y^2 through the three rows next to the wall: places, a."""
    behind = (x[:, 0] > 0.2) & (x[:, 0] < 12)
    columns = np.unique(np.round(x[behind, 0], 9))
    shear = []
    for column in columns:
        near = behind & (np.abs(x[:, 0] - column) < 1e-6) & (x[:, 1] < 3.2 / points)
        y = x[near, 1]
        shear.append(np.linalg.lstsq(np.column_stack([y, y * y]), u[near, 0], rcond=None)[0][0])
    return columns, np.array(shear)


def reattachment(columns, shear):
    """Where the shear turns positive for the last time."""
    k = np.flatnonzero((shear[:-1] < 0) & (shear[1:] >= 0))[-1]
    return columns[k] - shear[k] * (columns[k + 1] - columns[k]) / (shear[k + 1] - shear[k])


def draw_flow(name):
    x, v, _ = Results(str(folder / name)).of_fluid("Velocity", "Pressure")
    grid = np.meshgrid(np.linspace(-1.5, 8, 951), np.linspace(0.0, 2, 201))
    beyond = (grid[0] < 0) & (grid[1] < 1)
    u, w = (np.where(beyond, np.nan, griddata(x, values, tuple(grid), "linear", 0.0)) for values in v.T)
    figure, axis = figures.plt.subplots(figsize=(10, 3), constrained_layout=True)
    shown = axis.pcolormesh(*grid, u, cmap="RdBu_r", vmin=-1.5, vmax=1.5)
    figure.colorbar(shown, ax=axis, label="velocity along x (m/s)")
    axis.streamplot(grid[0], grid[1], u, w, color="k", linewidth=0.5, density=(2.4, 1.4), arrowsize=0.6)
    axis.add_patch(figures.plt.Rectangle((-1.5, 0), 1.5, 1, color="0.6"))
    axis.plot([2.89], [0.02], "k^", markersize=8, clip_on=False)
    axis.set_aspect("equal")
    axis.set_xlim(-1.5, 8)
    axis.set_xlabel("x (m)")
    figure.savefig(folder / "flow.png", dpi=110)
    print(folder / "flow.png")


figure, axis = figures.plt.subplots(figsize=(7, 4), constrained_layout=True)
for run, points in RUNS:
    if not (folder / f"{run}.h5").exists():
        continue
    x, v, _ = Results(str(folder / run)).of_fluid("Velocity", "Pressure")
    columns, shear = wall_shear(x, v, points)
    length = reattachment(columns, shear)
    history = read_history(folder / f"{run}.csv")
    flow = [100 * (history[key][-1] - 1) for key in ("Flow_Before", "Flow_Behind", "Flow_Far")]
    print(f"{run}: {len(x)} points, the flow comes back at {length:.3f} ({100 * (length / 2.89 - 1):+.1f} %), mass flow "
          f"{flow[0]:+.2f}, {flow[1]:+.2f}, {flow[2]:+.2f} % at x = -1.5, 3, 12")
    axis.plot(columns, shear, label=f"{points} points a step" + (", lattice shifted" if "shifted" in run else ""))
axis.axhline(0, color="k", linewidth=0.5)
axis.axvline(2.89, color="k", linewidth=0.5, linestyle=":")
axis.set_xlim(0, 10)
axis.set_xlabel("x (m)")
axis.set_ylabel("slope of the velocity at the wall (1/s)")
axis.legend()
figure.savefig(folder / "wall.png", dpi=110)
print(folder / "wall.png")
draw_flow("step_20")
