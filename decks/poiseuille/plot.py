#!/usr/bin/python3
"""profile.png, errors.png: flow in a channel against the parabola; plot.py [RESULTS]"""
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

POINTS = (10, 20, 40)
LATTICES = {"along": "along the channel", "off": "off it", "turned": "turned by 20°"}
WALLS = {"": ("o-", ""), "_reflected": ("^--", ", reflected points"), "_staircase": ("s:", ", without Surface")}
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def save(figure, name):
    figure.savefig(folder / name, dpi=110)
    print(folder / name)


def report(name):
    return json.loads((folder / f"{name}.report.json").read_text())


def slope_error(name):
    """Of the pressure's gradient between a quarter and three quarters of the channel."""
    results = Results(str(folder / name))
    step = results.steps[-1]
    x = results.x[:, 0]
    inside = (results.field("Fluid", step) == 1) & (x > 0.5e-3) & (x < 1.5e-3)
    return np.polyfit(x[inside], results.field("Pressure", step)[inside], 1)[0] / -240 - 1


def draw_errors():
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    for color, (lattice, title) in zip(("C0", "C1", "C2"), LATTICES.items()):
        for suffix, (style, walls) in WALLS.items():
            names = [f"{lattice}{suffix}_{n}" for n in POINTS]
            errors = [report(name)["error_norms"]["along relative L2 error"] for name in names]
            slopes = [slope_error(name) for name in names]
            label = title + walls
            left.loglog(POINTS, errors, style, color=color, markersize=4, label=label)
            right.loglog(POINTS, np.abs(slopes), style, color=color, markersize=4)
            print(f"{label}: L2 " + " ".join(f"{e:.2e}" for e in errors) + "  dp/dx "
                  + " ".join(f"{s:+.2e}" for s in slopes))
    for axis, title in ((left, "error of the velocity (L2)"), (right, "error of the pressure's gradient")):
        axis.set_xlabel("points across the channel")
        axis.set_ylabel(title)
        axis.set_xticks(POINTS, POINTS)
        axis.minorticks_off()
    left.legend(fontsize=7, loc=(0.02, 0.33))
    save(figure, "errors.png")


def draw_profile():
    figure, axis = figures.plt.subplots(figsize=(5, 3.8), constrained_layout=True)
    y = np.linspace(0, 1e-3, 101)
    axis.plot(120 * y / 1e-3 * (1 - y / 1e-3), y * 1e3, "k-", linewidth=0.8, label="exact")
    for color, suffix in (("C2", ""), ("C3", "_staircase")):
        results = Results(str(folder / f"turned{suffix}_10"))
        step = results.steps[-1]
        inside = (results.field("Fluid", step) == 1) & (np.abs(results.x[:, 0] - 1e-3) < 0.3e-3)
        axis.plot(results.field("Velocity", step)[inside, 0] * 1e3, results.x[inside, 1] * 1e3, ".", color=color,
                  markersize=4, label="turned lattice, 10 points" + (", without Surface" if suffix else ""))
    axis.set_xlabel("velocity (mm/s)")
    axis.set_ylabel("y (mm)")
    axis.legend(fontsize=7)
    save(figure, "profile.png")


def print_pipes():
    for lattice in ("along", "off", "jittered"):
        for suffix in ("", "_staircase"):
            errors = [report(f"pipe_{lattice}{suffix}_{n}")["error_norms"] for n in POINTS[:2]]
            print(f"pipe, {lattice}{suffix}: L2 " + " ".join(f"{e['along relative L2 error']:.2e}" for e in errors)
                  + "  pressure " + " ".join(f"{e['pressure relative L2 error']:.2e}" for e in errors))


draw_errors()
draw_profile()
print_pipes()
