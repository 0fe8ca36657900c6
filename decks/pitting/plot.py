#!/usr/bin/python3
"""pit.png, growth.png, film.png: pits under covers in 2D and 3D; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from pits import SPACING, pits  # noqa: E402
from quasi_steady import CoveredPit, exponents  # noqa: E402

SATURATION, SOLID = 4600.0, 142900.0


def save(figure, name):
    figure.savefig(folder / name, dpi=110)
    print(folder / name)


def image(first, second, values):
    """Values of points on a square lattice as rows of an array, and its edges (um)."""
    columns, rows = (np.rint((a - a.min()) / SPACING).astype(int) for a in (first, second))
    picture = np.full((rows.max() + 1, columns.max() + 1), np.nan)
    picture[rows, columns] = values
    extent = [1e6 * (edge + side * SPACING / 2) for a in (first, second) for edge, side in ((a.min(), -1), (a.max(), 1))]
    return picture, extent


def draw_electrolyte(axis, first, second, concentration, liquid):
    """Concentration in the electrolyte; the solid grey, its outline black."""
    picture, extent = image(first, second, np.where(liquid, concentration, np.nan))
    axis.set_facecolor("0.75")
    shown = axis.imshow(picture, origin="lower", extent=extent, vmin=0.0, vmax=SATURATION, cmap="viridis")
    phase, _ = image(first, second, liquid.astype(float))
    axis.contour(phase, [0.5], origin="lower", extent=extent, colors="black", linewidths=0.8)
    axis.set_xlabel("x (µm)")
    return shown


def draw_pit():
    results = Results(folder / "pit")
    x, y = results.x[:, 0], results.x[:, 1]
    figure, axes = figures.plt.subplots(2, 2, figsize=(10, 6), constrained_layout=True)
    for axis, step in zip(axes.flat, [results.steps[k] for k in (1, 3, 6, -1)]):
        liquid = results.field("Damage", step) >= 1.0
        shown = draw_electrolyte(axis, x, y, results.field("Concentration", step), liquid)
        axis.set_ylabel("y (µm)")
        axis.set_title(f"{results.time(step):.0f} s")
    figure.colorbar(shown, ax=axes, label="C in the electrolyte (mol/m³)")
    save(figure, "pit.png")


def draw_growth():
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(11, 4.4), constrained_layout=True)
    for name, current, colour in (("pit", 5.1e3, "tab:blue"), ("salted", 2.55e4, "tab:red")):
        history, model = read_history(folder / f"{name}.csv"), CoveredPit(current=current)
        t, depth = history["time"][1:], history["Maximum_Depth"][1:]
        expected, onset = model.depths(t), model.transition()
        left.loglog(t, depth * 1e6, ".", markersize=4, color=colour, label=f"depth, {current:g} A/m²")
        left.loglog(t, history["Pit_Width"][1:] * 0.5e6, "+", markersize=4, color=colour, alpha=0.5,
                    label=f"half its width below the cover, {current:g} A/m²")
        left.loglog(t, expected * 1e6, "-", linewidth=0.9, color="black")
        middles, slopes = exponents(*np.exp(every(0.15, np.log(t), np.log(depth))))
        right.semilogx(middles, slopes, ".-", linewidth=0.6, color=colour, label=f"{current:g} A/m²")
        fine = np.geomspace(t[0], t[-1], 300)
        right.semilogx(*exponents(fine, model.depths(fine)), "-", linewidth=0.9, color="black")
        print(f"{name}: salt in the model at {onset / model.speed:.1f} s, {onset * 1e6:.2f} um")
        for part, stage in ((t < 0.8 * onset / model.speed, "early"), (depth > 2.0 * onset, "late")):
            if np.sum(part) < 4:
                continue
            slope, offset = np.polyfit(np.log(t[part]), np.log(depth[part]), 1)
            left.loglog(t[part], 0.7e6 * np.exp(offset) * t[part]**slope, "--", color=colour, linewidth=0.8)
            middle = np.flatnonzero(part)[np.sum(part) // 2]
            left.annotate(f"{slope:.3f}", (t[middle], 0.62e6 * depth[middle]), color=colour, va="top")
            off = 100 * (depth[part] / expected[part] - 1)
            print(f"  {stage}: depth as t^{slope:.3f} from {t[part][0]:g} to {t[part][-1]:g} s, of the model "
                  f"t^{np.polyfit(np.log(t[part]), np.log(expected[part]), 1)[0]:.3f}; depth off by {np.min(off):+.2f} "
                  f"to {np.max(off):+.2f} %")
            if stage == "early":
                speed = np.polyfit(t[part], depth[part], 1)[0]
                print(f"  early speed {speed * 1e6:.4f} um/s, Faraday {model.speed * 1e6:.4f}, "
                      f"{100 * (speed / model.speed - 1):+.2f} %")
        for k in np.unique(np.linspace(0, len(t) - 1, 12).astype(int)):
            print(f"  {t[k]:g} s: depth {depth[k] * 1e6:.2f} um, model {expected[k] * 1e6:.2f}, "
                  f"{100 * (depth[k] / expected[k] - 1):+.2f} %; width {history['Pit_Width'][k + 1] * 1e6:.1f} um, peak "
                  f"{history['Peak_Current_Density'][k + 1]:.0f} A/m2")
    for value in (0.5, 1.0):
        right.axhline(value, color="0.6", linewidth=0.8)
    left.set_ylabel("µm; lines: quasi-steady model of the depth")
    right.set_ylabel("d ln depth / d ln t; lines: the model")
    for axis in (left, right):
        axis.set_xlabel("t (s)")
        axis.grid(alpha=0.3, which="both")
        axis.legend(fontsize=8)
    save(figure, "growth.png")


def every(step, *columns):
    """Entries that are `step` or more apart in the first, increasing column."""
    chosen = [0]
    for k, value in enumerate(columns[0]):
        if value >= columns[0][chosen[-1]] + step:
            chosen.append(k)
    return [column[chosen] for column in columns]


def draw_film():
    results, history = Results(folder / "film"), read_history(folder / "film.csv")
    x, y, z = results.x.T
    step, speed = results.steps[-1], CoveredPit().speed
    depth, liquid = results.field("Corrosion_Depth", step), results.field("Damage", step) >= 1.0
    surface = (z < 0) & (z > -SPACING)
    deepest = y[np.flatnonzero(surface)[np.argmax(depth[surface])]]
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(11, 4.6), constrained_layout=True,
                                                 gridspec_kw={"width_ratios": [1, 1.3]})
    picture, extent = image(x[surface], y[surface], depth[surface] * 1e6)
    figure.colorbar(left.imshow(picture, origin="lower", extent=extent, cmap="magma_r"), ax=left,
                    label="depth (µm)", shrink=0.8)
    for centre, radius in zip(*pits()):
        left.add_patch(figures.plt.Circle(centre * 1e6, radius * 1e6, fill=False, color="cyan", linewidth=0.9))
    left.axhline(deepest * 1e6, color="0.5", linestyle=":", linewidth=0.8)
    left.set_xlabel("x (µm)")
    left.set_ylabel("y (µm)")
    left.set_title(f"{results.time(step):.0f} s; circles: holes of the film", fontsize=10)
    cut = (np.abs(y - deepest) < 0.1 * SPACING) & (z > -20 * SPACING)
    concentration = results.field("Concentration", step)
    shown = draw_electrolyte(right, x[cut], z[cut], concentration[cut], liquid[cut])
    # Points that the last step has turned liquid are saturated; they are not what the scale is for.
    shown.set_clim(0.0, 2.0 * np.median(concentration[cut & liquid & (z < 0)]))
    figure.colorbar(shown, ax=right, label="C in the electrolyte (mol/m³)", orientation="horizontal", extend="max")
    right.set_ylabel("z (µm)")
    right.set_title(f"y = {deepest * 1e6:.1f} µm", fontsize=10)
    save(figure, "film.png")
    for k, t in enumerate(history["time"]):
        if t > 0:
            print(f"{t:.0f} s: deepest {history['Maximum_Depth'][k] * 1e6:.3f} um ({speed * t * 1e6:.3f} by Faraday), "
                  f"{history['Dissolved_Amount'][k]:.4g} mol, current {history['Total_Current'][k]:.4g} A")
    film = results.field("Damage", step)[results.block == 2]
    print(f"C in the pits: median {np.median(concentration[liquid & (z < 0)]):.0f} mol/m3; the film has lost "
          f"{np.sum(film):.2g} of its {film.size} points, of one {np.max(film):.2g} at most")


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
draw_pit()
draw_growth()
draw_film()
