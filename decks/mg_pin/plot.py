#!/usr/bin/python3
"""loss.png, along.png, measures.png, flow.png, shape.png: the wire against measurements; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from scipy.interpolate import griddata  # noqa: E402
from wire import FILM, FIRST_SCAN, RADIUS, SPEED, draw_scans, exact_radius, off_scans  # noqa: E402

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def losses(name):
    """Hours, volume loss in % of the pristine wire and of the first scan, radius of a disc of its first area, um."""
    history = read_history(folder / f"{name}.csv")
    area = 100 * history["Volume_Loss"][-1] / history["Relative_Volume_Loss"][-1]
    whole = 2 * area if name == "mg_pin" else area  # half of it is modelled
    radius = RADIUS if name == "along" else 1e6 * np.sqrt(whole / np.pi)
    return history["time"] / 3600, history["Relative_Volume_Loss"], history["Loss_Since_Scan"], radius


def draw_loss():
    figure, axis = figures.plt.subplots(figsize=(6.4, 4.4), constrained_layout=True)
    draw_scans(axis)
    constant = (1.304, 0.0)
    breaking = (SPEED, FILM)
    for name, style, label, law in (("mg_pin", "C0-", "in the flow: 5.73 A/m² under a film that breaks up", breaking),
                                    ("still", "C2--", "the same in fluid at rest", breaking),
                                    ("no_film", "C1-", "5.0 A/m² from the start", constant)):
        if not (folder / f"{name}.csv").exists():
            continue
        t, pristine, first, radius = losses(name)
        shown = t >= FIRST_SCAN - 0.05
        axis.plot(t[shown], first[shown], style, label=label)
        off = off_scans(t, first)
        left = 1 - (RADIUS - exact_radius(t, *law)) / radius
        error = np.max(np.abs(pristine - 100 * (1 - left**2)))
        print(f"{name}: {' '.join(f'{d:+.2f}' for d in off)} sd; after 9 h {first[-1]:.1f} % of the first scan, "
              f"{pristine[-1]:.1f} % of the pristine wire; off a round wire's by at most {error:.2f} points")
    axis.set_xlabel("time (h)")
    axis.set_ylabel("volume loss (% of the first scan)")
    axis.set_xlim(0, 9.2)
    axis.legend(fontsize=8)
    figure.savefig(folder / "loss.png", dpi=110)
    print(folder / "loss.png")


def draw_measures():
    """What else laboratories measure, beside a round wire: diameter, rate since the start, hydrogen."""
    figure, axes = figures.plt.subplots(1, 3, figsize=(11, 3.4), constrained_layout=True)
    hydrogen = 71508 * 8.314462618 * 310.15 / 101325  # volume of gas a volume of metal
    measures = (("Wire_Diameter", 1e6, "diameter (µm)", lambda t, lost: 2 * exact_radius(t)),
                ("Corrosion_Rate", 1.0, "rate since the start (mm/year)", lambda t, lost: 8.76 * lost / t),
                ("Hydrogen_Gas", 1.0, "hydrogen at 37 °C (mL/cm²)", lambda t, lost: 1e-4 * hydrogen * lost))
    for axis, (column, factor, label, exact) in zip(axes, measures):
        for name, style, where in (("mg_pin", "C0-", "in the flow"), ("still", "C2--", "in fluid at rest")):
            if not (folder / f"{name}.csv").exists():
                continue
            history = read_history(folder / f"{name}.csv")
            t, values = history["time"][1:] / 3600, history[column][1:] * factor
            expected = exact(t, (RADIUS**2 - exact_radius(t)**2) / (2 * RADIUS))  # um of the first surface are lost
            axis.plot(t, values, style, label=where)
            at = [int(np.argmin(np.abs(t - hour))) for hour in (1, 3, 6, 9)]
            print(f"{column}, {name}, after 1, 3, 6, 9 h: " +
                  ", ".join(f"{values[k]:.4g} ({expected[k]:.4g})" for k in at))
        axis.plot(t, expected, "k:", label="round wire")
        axis.set(xlabel="time (h)", ylabel=label)
    figures.save_curves(figure, folder / "measures.png", axes)


def draw_along():
    """The wire along the axis of the tube."""
    figure, axis = figures.plt.subplots(figsize=(6.4, 4.4), constrained_layout=True)
    draw_scans(axis)
    t, pristine, first, _ = losses("along")
    exact = 100 * (1 - (exact_radius(t) / RADIUS)**2)
    axis.plot(t[t >= FIRST_SCAN - 0.05], first[t >= FIRST_SCAN - 0.05], "C3-", label="along the axis of the tube")
    off = off_scans(t, first)
    print(f"along: {' '.join(f'{d:+.2f}' for d in off)} sd; after 9 h {first[-1]:.1f} % of the first scan, "
          f"{pristine[-1]:.1f} % of the pristine wire; off a round wire's by at most "
          f"{np.max(np.abs(pristine - exact)):.2f} points")
    axis.set_xlabel("time (h)")
    axis.set_ylabel("volume loss (% of the first scan)")
    axis.legend(fontsize=8)
    figure.savefig(folder / "along.png", dpi=110)
    print(folder / "along.png")


def whole(results, step, label, sign=1.0):
    """x, y in um and the field of both halves; `sign` of the mirror image."""
    x, values = results.x[:, :2] * 1e6, results.field(label, step)
    return np.vstack([x, x * [1, -1]]), np.concatenate([values, sign * values])


def draw_flow():
    results = Results(str(folder / "mg_pin"))
    figure, axes = figures.plt.subplots(2, 2, figsize=(11, 7), constrained_layout=True)
    grid = np.meshgrid(np.linspace(-150, 350, 251), np.linspace(-200, 200, 201))
    for row, step in zip(axes, (results.steps[1], results.steps[-1])):
        fluid = whole(results, step, "Fluid")[1] == 1
        x, velocity = whole(results, step, "Velocity", np.array([1.0, -1.0, 1.0]))
        concentration = whole(results, step, "Concentration")[1]
        solid = x[(whole(results, step, "Damage")[1] < 1) & (np.abs(x[:, 1]) < 100)]
        beyond = np.min(np.hypot(grid[0][..., None] - solid[:, 0], grid[1][..., None] - solid[:, 1]), axis=-1) < 3.6
        u, w, c = (np.where(beyond, np.nan, griddata(x[fluid], values[fluid], tuple(grid), "linear"))
                   for values in (velocity[:, 0], velocity[:, 1], concentration))
        for axis, field, label, scale in ((row[0], np.hypot(u, w), "speed (m/s)", "viridis"),
                                          (row[1], c, "Mg²⁺ (mol/m³)", "magma")):
            shown = axis.pcolormesh(*grid, field, cmap=scale, vmin=0, vmax=np.nanpercentile(field, 99.9))
            figure.colorbar(shown, ax=axis, label=label)
            axis.plot(solid[:, 0], solid[:, 1], "s", color="0.6", markersize=2)
            axis.set_aspect("equal")
            axis.set(xlim=(-150, 350), ylim=(-200, 200))
            axis.set_title(f"{results.time(step) / 3600:.2f} h", fontsize=9)
            axis.set_xlabel("x (µm)")
        row[0].streamplot(grid[0], grid[1], u, w, color="w", linewidth=0.5, density=1.2, arrowsize=0.6)
        print(f"{results.time(step) / 3600:.2f} h: largest Mg {concentration[fluid].max():.3f} mol/m3")
    figure.savefig(folder / "flow.png", dpi=110)
    print(folder / "flow.png")


def draw_shape():
    results = Results(str(folder / "mg_pin"))
    figure, axis = figures.plt.subplots(figsize=(4.6, 4.2), constrained_layout=True)
    x, damage = whole(results, results.steps[-1], "Damage")
    near = np.hypot(*x.T) < 60
    shown = axis.scatter(x[near, 0], x[near, 1], c=1 - damage[near], s=50, marker="s", cmap="Greys", vmin=0, vmax=1,
                         linewidths=0)
    figure.colorbar(shown, ax=axis, label="metal left after 9 h")
    angle = np.linspace(0, 2 * np.pi, 200)
    for radius, style in ((RADIUS, "C1--"), (exact_radius(9.0), "C0-")):
        axis.plot(radius * np.cos(angle), radius * np.sin(angle), style, linewidth=1)
    axis.set_aspect("equal")
    axis.set_xlabel("x (µm)")
    figure.savefig(folder / "shape.png", dpi=110)
    print(folder / "shape.png")


draw_loss()
draw_measures()
draw_along()
draw_flow()
draw_shape()
