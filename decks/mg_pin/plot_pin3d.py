#!/usr/bin/python3
"""pin3d.png: the wire across the round tube; plot_pin3d.py [RESULTS] [NAME]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from wire import FIRST_SCAN, RADIUS, draw_scans, exact_radius, off_scans  # noqa: E402

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
name = sys.argv[2] if len(sys.argv) > 2 else "pin3d"
results, history = Results(str(folder / name)), read_history(folder / f"{name}.csv")
x, spacing = 1e6 * results.x, 1e6 * results.volume.min()**(1 / 3)
last = results.steps[-1]


def section(axis, level, across, values):
    """Of the lattice in the layer next to `level`: coordinates of columns and rows, and values [rows, columns]."""
    layer = np.flatnonzero(np.abs(x[:, axis] - level) < 0.51 * spacing)
    columns, rows = (np.unique(np.round(x[layer, a], 3)) for a in across)
    field = np.full((len(rows), len(columns)), np.nan)
    column, row = (np.searchsorted(edges, np.round(x[layer, a], 3)) for edges, a in zip((columns, rows), across))
    field[row, column] = values[layer]
    return columns, rows, field


def draw_loss(axis):
    draw_scans(axis)
    t, first, pristine = history["time"] / 3600, history["Loss_Since_Scan"], history["Relative_Volume_Loss"]
    shown = t >= FIRST_SCAN - 0.05
    axis.plot(t[shown], first[shown], "C0-", label="in space")
    off = off_scans(t, first)
    volume = history["Volume_Loss"][-1] / pristine[-1] * 100  # of a quarter of the wire, m3
    radius = 1e6 * np.sqrt(2 * volume / (np.pi * 425e-6))
    error = np.max(np.abs(pristine - 100 * (1 - (1 - (RADIUS - exact_radius(t)) / radius)**2)))
    print(f"{name}: {' '.join(f'{d:+.2f}' for d in off)} sd; after {t[-1]:.2f} h {pristine[-1]:.2f} % of the pristine "
          f"wire; off a round wire's by at most {error:.2f} points")
    if (folder / "mg_pin.csv").exists():
        plane = read_history(folder / "mg_pin.csv")
        axis.plot(plane["time"] / 3600, plane["Loss_Since_Scan"], "C1--", label="plane section")
        there = np.interp(t, plane["time"] / 3600, plane["Relative_Volume_Loss"])
        print(f"off the plane section's by at most {np.max(np.abs(pristine - there)):.2f} points")
    axis.set(xlim=(FIRST_SCAN - 0.1, t[-1] + 0.1), ylim=(-0.5, None), xlabel="time (h)",
             ylabel="volume loss (% of the first scan)")
    axis.legend(fontsize=8)


figure, axes = figures.plt.subplots(2, 2, figsize=(11, 7.4), constrained_layout=True)
draw_loss(axes[0, 0])
velocity, fluid = results.field("Velocity", last), results.field("Fluid", last)
speed = np.where(fluid == 1, np.hypot(np.hypot(*velocity.T[:2]), velocity[:, 2]), np.nan)
concentration = np.where(fluid == 1, results.field("Concentration", last), np.nan)
for axis, (normal, level, across, values, label, colours, labels) in zip(axes.ravel()[1:], (
        (2, 0.5 * spacing, (0, 1), speed, "speed beside z = 0 (m/s)", "viridis", "xy"),
        (1, 0.5 * spacing, (0, 2), speed, "speed beside y = 0 (m/s)", "viridis", "xz"),
        (1, 0.5 * spacing, (0, 2), concentration, "Mg²⁺ beside y = 0 (mol/m³)", "magma", "xz"))):
    columns, rows, field = section(normal, level, across, values)
    shown = axis.pcolormesh(columns, rows, field, cmap=colours, vmin=0, vmax=np.nanpercentile(field, 99.5))
    figure.colorbar(shown, ax=axis, label=label)
    axis.set_aspect("equal")
    axis.set(xlabel=f"{labels[0]} (µm)", ylabel=f"{labels[1]} (µm)", xlim=(-150, 250), ylim=(0, 425))
figure.savefig(folder / "pin3d.png", dpi=110)
print(folder / "pin3d.png")
before, behind = (history[label][1:] for label in ("Before", "Behind"))
print(f"mass flow of the quarter: {before[-1]:.5g} before and {behind[-1]:.5g} kg/s behind the wire, 1 mL/min is "
      f"{1e-3 / 60 / 4:.5g}; largest Mg {np.nanmax(concentration):.3f} mol/m3")
