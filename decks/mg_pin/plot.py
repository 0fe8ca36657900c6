#!/usr/bin/python3
"""loss.png, flow.png, shape.png: the wire against measurements; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from scipy.interpolate import griddata  # noqa: E402

RADIUS, SPEED, FILM = 40.0, 1.494, 4340 / 3600  # um, um/h = i/(zF C_solid) of 5.73 A/m2, h
FIRST_SCAN = 0.687  # h
hours, measured, deviation = np.loadtxt(Path(__file__).parent / "measured.csv", delimiter=",", skiprows=3).T
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def exact_radius(t, speed=SPEED, film=FILM):
    """Of a round wire, um."""
    return RADIUS - speed * (t - film * (1 - np.exp(-t / film)) if film > 0 else t)


def losses(name):
    """Hours, volume loss in % of the pristine wire and of the first scan."""
    history = read_history(folder / f"{name}.csv")
    results = Results(str(folder / name))
    solid = results.field("Damage", results.steps[0]) < 1
    x = results.x[solid]
    spacing = np.min(np.diff(np.unique(np.round(x[:, 0], 9))))
    share = history["Volume_Loss"] / (np.count_nonzero(solid) * spacing**2)
    t = history["time"] / 3600
    left = np.interp(FIRST_SCAN, t, 1 - share)
    return t, 100 * share, 100 * (1 - (1 - share) / left)


def draw_loss():
    figure, axis = figures.plt.subplots(figsize=(6.4, 4.4), constrained_layout=True)
    axis.errorbar(hours, measured, yerr=deviation, fmt="ko", markersize=4, capsize=2, label="measured, with 1 sd")
    for name, color, label in (("mg_pin", "C0", "5.73 A/m² under a film that breaks up in 1.2 h"),
                               ("no_film", "C1", "5.0 A/m² from the start")):
        if not (folder / f"{name}.csv").exists():
            continue
        t, pristine, first = losses(name)
        shown = t >= FIRST_SCAN - 0.05
        axis.plot(t[shown], first[shown], color=color, label=label)
        off = (np.interp(hours, t, first) - measured)[1:] / deviation[1:]
        exact = 100 * (1 - (exact_radius(t, *((SPEED, FILM) if name == "mg_pin" else (1.304, 0.0))) / RADIUS)**2)
        print(f"{name}: {' '.join(f'{d:+.2f}' for d in off)} sd; after 9 h {first[-1]:.1f} % of the first scan, "
              f"{pristine[-1]:.1f} % of the pristine wire; off a round wire's by at most "
              f"{np.max(np.abs(pristine - exact)):.2f} points")
    axis.set_xlabel("time (h)")
    axis.set_ylabel("volume loss (% of the first scan)")
    axis.set_xlim(0, 9.2)
    axis.legend(fontsize=8)
    figure.savefig(folder / "loss.png", dpi=110)
    print(folder / "loss.png")


def draw_flow():
    results = Results(str(folder / "mg_pin"))
    figure, axes = figures.plt.subplots(2, 2, figsize=(11, 7), constrained_layout=True)
    for row, step in zip(axes, (results.steps[1], results.steps[-1])):
        fluid = results.field("Fluid", step) == 1
        x, v = results.x[fluid, :2] * 1e6, results.field("Velocity", step)[fluid, :2]
        c = results.field("Concentration", step)[fluid]
        grid = np.meshgrid(np.linspace(-150, 350, 301), np.linspace(-200, 200, 241))
        solid = results.x[results.field("Damage", step) < 1, :2] * 1e6
        beyond = np.min(np.hypot(grid[0][..., None] - solid[::7, 0], grid[1][..., None] - solid[::7, 1]), axis=-1) < 6
        u, w, values = (griddata(x, f, tuple(grid), "linear") for f in (v[:, 0], v[:, 1], c))
        for axis, field, label, scale in ((row[0], np.hypot(u, w), "speed (m/s)", "viridis"),
                                          (row[1], values, "Mg²⁺ (mol/m³)", "magma")):
            field = np.where(beyond, np.nan, field)
            shown = axis.pcolormesh(*grid, field, cmap=scale,
                                    **({"vmax": np.nanpercentile(field, 99.8)} if axis is row[1] else {}))
            figure.colorbar(shown, ax=axis, label=label)
            axis.plot(solid[:, 0], solid[:, 1], "s", color="0.6", markersize=2)
            axis.set_aspect("equal")
            axis.set_title(f"{results.time(step) / 3600:.2f} h" if hasattr(results, "time") else "", fontsize=9)
            axis.set_xlabel("x (µm)")
        row[0].streamplot(grid[0], grid[1], np.where(beyond, np.nan, u), np.where(beyond, np.nan, w), color="w",
                          linewidth=0.5, density=1.2, arrowsize=0.6)
    figure.savefig(folder / "flow.png", dpi=110)
    print(folder / "flow.png")


def draw_shape():
    results = Results(str(folder / "mg_pin"))
    figure, axis = figures.plt.subplots(figsize=(4.6, 4.2), constrained_layout=True)
    near = np.hypot(*results.x[:, :2].T) < 60e-6
    x = results.x[near, :2] * 1e6
    step = results.steps[-1]
    shown = axis.scatter(x[:, 0], x[:, 1], c=1 - results.field("Damage", step)[near], s=60, marker="s", cmap="Greys",
                         vmin=0, vmax=1)
    figure.colorbar(shown, ax=axis, label="metal left after 9 h")
    angle = np.linspace(0, 2 * np.pi, 200)
    for radius, style in ((RADIUS, "C1--"), (exact_radius(9.0), "C0-")):
        axis.plot(radius * np.cos(angle), radius * np.sin(angle), style, linewidth=1)
    axis.set_aspect("equal")
    axis.set_xlabel("x (µm)")
    figure.savefig(folder / "shape.png", dpi=110)
    print(folder / "shape.png")


draw_loss()
draw_flow()
draw_shape()
