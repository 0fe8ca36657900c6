#!/usr/bin/python3
"""grains.png: what grain boundaries and a second phase do to the wire: shape, loss, roughness; plot_grains.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from wire import FIRST_SCAN, RADIUS, draw_scans, off_scans  # noqa: E402

SECTORS = 36
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
RUNS = (("grains", "C3-", "boundaries 5 × as fast, particles a tenth, 1 µm"), ("grains_coarse", "C3--", "the same, 2 µm"),
        ("grains_alone", "C0-", "grains alone"))


def roughness(results):
    """Hours; root mean square of radii about their mean, um: those of sectors of the area that is left in each, each
    over that at the start."""
    x = results.x * 1e6
    inside = np.hypot(x[:, 0], x[:, 1]) < RADIUS
    sector = ((np.arctan2(x[:, 1], x[:, 0]) / (2 * np.pi) + 1) * SECTORS).astype(int)[inside] % SECTORS
    whole = np.bincount(sector, minlength=SECTORS)
    times, rough = [], []
    for step in results.steps:
        left = np.bincount(sector, weights=1 - results.field("Damage", step)[inside], minlength=SECTORS)
        radius = RADIUS * np.sqrt(left / whole)
        times.append(results.time(step) / 3600)
        rough.append(np.std(radius))
    return np.array(times), np.array(rough)


def draw_wire(axis, results, step):
    x = results.x * 1e6
    columns, rows = (np.unique(np.round(x[:, axis], 3)) for axis in (0, 1))
    order = np.lexsort((x[:, 0], x[:, 1]))
    left = np.where(np.hypot(x[:, 0], x[:, 1]) < RADIUS, 1 - results.field("Damage", step), 0.0)
    shown = np.choose(results.block - 1, [0.55, 0.25, 0.95])
    grid = np.ma.masked_less(left, 0.02) * 0 + shown
    axis.pcolormesh(columns, rows, grid[order].reshape(len(rows), len(columns)), cmap="gray", vmin=0, vmax=1)
    angle = np.linspace(0, 2 * np.pi, 200)
    axis.plot(RADIUS * np.cos(angle), RADIUS * np.sin(angle), "C1--", linewidth=0.8)
    axis.set_aspect("equal")
    axis.set_title(f"{results.time(step) / 3600:.1f} h", fontsize=9)


figure, axes = figures.plt.subplots(2, 3, figsize=(10.5, 7), constrained_layout=True)
shaped = Results(str(folder / "grains"))
for axis, step in zip(axes[0], (shaped.steps[0], shaped.steps[len(shaped.steps) // 2], shaped.steps[-1])):
    draw_wire(axis, shaped, step)
loss, rough, share = axes[1]
draw_scans(loss, markersize=3, label="measured")
for name, style, label in RUNS:
    results, history = Results(str(folder / name)), read_history(folder / f"{name}.csv")
    t, gone = history["time"] / 3600, history["Relative_Volume_Loss"] / 100
    first = 100 * (1 - (1 - gone) / np.interp(FIRST_SCAN, t, 1 - gone))
    loss.plot(t[t > 0.6], first[t > 0.6], style, label=label)
    times, values = roughness(results)
    rough.plot(times, values, style)
    wire = np.hypot(*results.x[:, :2].T) * 1e6 < RADIUS
    of_boundaries = [np.mean((results.block == 2)[wire] * (results.field("Damage", step)[wire] < 1)) /
                     max(np.mean(results.field("Damage", step)[wire] < 1), 1e-9) for step in results.steps]
    share.plot(times, 100 * np.array(of_boundaries), style)
    off = off_scans(t, first)
    print(f"{name}: {' '.join(f'{d:+.1f}' for d in off)} sd; after 9 h {first[-1]:.1f} % of the first scan, "
          f"{100 * gone[-1]:.1f} % of the wire; roughness {np.interp(4.2, times, values):.2f} um after 4.2 h, "
          f"{values[-1]:.2f} um after 9 h; boundaries {100 * np.mean((results.block == 2)[wire]):.2f} % of the points")
loss.set(xlabel="time (h)", ylabel="volume loss (% of the first scan)")
loss.legend(fontsize=7)
rough.set(xlabel="time (h)", ylabel="roughness of the outline (µm)")
share.set(xlabel="time (h)", ylabel="share of boundaries in what is left (%)")
figure.savefig(folder / "grains.png", dpi=100)
print(folder / "grains.png")
