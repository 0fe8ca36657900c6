#!/usr/bin/python3
"""depth.png, profile.png, transition.png: the pencil electrode against exact solutions; plot.py [RESULTS]"""
import sys
from math import erf, exp, pi, sqrt
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from moving_front import depths  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402

HORIZON, FARADAY = 4e-6, 96485.33212
STEEL = {"diffusivity": 850e-12, "solid": 143000.0, "saturation": 5100.0}
COPPER = {"diffusivity": 1297e-12, "solid": 141000.0, "saturation": 5000.0}
FINITE = {"diffusivity": 860e-12, "solid": 142900.0, "saturation": 4600.0}
SPEED = 5.1e3 / (2.19 * FARADAY * FINITE["solid"])


def stefan_number(metal):
    """lambda of sqrt(pi) lambda exp(lambda^2) erf(lambda) = C_sat/(C_solid - C_sat), by bisection."""
    target, low, high = metal["saturation"] / (metal["solid"] - metal["saturation"]), 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        isBelow = sqrt(pi) * middle * exp(middle**2) * erf(middle) < target
        low, high = (middle, high) if isBelow else (low, middle)
    return 0.5 * (low + high)


def stefan_depth(metal, t):
    return 2 * stefan_number(metal) * np.sqrt(metal["diffusivity"] * t)


def save(figure, name):
    figure.savefig(folder / name, dpi=110)
    print(folder / name)


def draw_depth():
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    for name, title, metal in (("pencil", "SS304", STEEL), ("copper", "Cu", COPPER)):
        history = read_history(folder / f"{name}.csv")
        t, depth = history["time"][1:], history["Dissolved"][1:]
        exact = stefan_depth(metal, t)
        dots, = left.plot(np.sqrt(t), depth * 1e6, ".", markersize=4, label=f"{title}, λ = {stefan_number(metal):.5f}")
        left.plot(np.sqrt(t), exact * 1e6, "-", linewidth=0.9, color=dots.get_color())
        error = 100 * (depth / exact - 1)
        right.plot(depth / HORIZON, error, ".-", markersize=4, linewidth=0.7, label=title)
        for reach in (10, 20, 40, 60):
            k = np.argmax(exact >= reach * HORIZON)
            print(f"{title}: at {exact[k] / HORIZON:.1f} horizons ({t[k]:.0f} s) {error[k]:+.2f} %")
        print(f"{title}: at the end {depth[-1] * 1e6:.2f} um, exact {exact[-1] * 1e6:.2f} um, {error[-1]:+.2f} %")
    left.set_xlabel("√t (√s)")
    left.set_ylabel("depth (µm); lines: 2 λ √(D t)")
    right.set_xlabel("depth / horizon")
    right.set_ylabel("error of the depth (%)")
    right.set_ylim(0, 5)
    for axis in (left, right):
        axis.grid(alpha=0.3)
        axis.legend()
    save(figure, "depth.png")


def draw_profile():
    results = Results(folder / "pencil")
    x = results.x[:, 0]
    figure, axis = figures.plt.subplots(figsize=(6.4, 3.8), constrained_layout=True)
    number = stefan_number(STEEL)
    for wanted in (50, 200, 1000):
        step = min(results.steps, key=lambda s: abs(results.time(s) - wanted))
        t = results.time(step)
        liquid = (results.field("Damage", step) >= 1) & (x > 0)
        c = results.field("Concentration", step)[liquid]
        exact = STEEL["saturation"] * np.array([erf(v) for v in x[liquid] / (2 * sqrt(STEEL["diffusivity"] * t))]) / erf(number)
        dots, = axis.plot(x[liquid] * 1e6, c, ".", markersize=3, label=f"{t:.0f} s")
        fine = np.linspace(0, stefan_depth(STEEL, t), 100)
        axis.plot(fine * 1e6, STEEL["saturation"] / erf(number)
                  * np.array([erf(v) for v in fine / (2 * sqrt(STEEL["diffusivity"] * t))]), "-", linewidth=0.9,
                  color=dots.get_color())
        print(f"profile at {t:.0f} s: off by at most {np.max(np.abs(c - exact)) / STEEL['saturation'] * 100:.2f} % of C_sat")
    axis.set_xlabel("x (µm)")
    axis.set_ylabel("C in the electrolyte (mol/m³)")
    axis.set_title("points: peridynamics; lines: C_sat erf(x / 2√(D t)) / erf λ", fontsize=9)
    axis.grid(alpha=0.3)
    axis.legend()
    save(figure, "profile.png")


def draw_transition():
    history = read_history(folder / "finite.csv")
    t, depth = history["time"][1:], history["Dissolved"][1:]
    reference = depths(t, speed=SPEED, **FINITE)
    figure, axis = figures.plt.subplots(figsize=(6.4, 3.8), constrained_layout=True)
    axis.loglog(t, depth * 1e6, ".", markersize=4, label="peridynamics")
    axis.loglog(t, reference * 1e6, "-", linewidth=0.9, label="finite volumes that move with the front")
    axis.loglog(t, SPEED * t * 1e6, "--", linewidth=0.8, label="i t / (z F C_solid)")
    axis.loglog(t, stefan_depth(FINITE, t) * 1e6, ":", linewidth=1.2, label="2 λ √(D t)")
    axis.axhline(2.19 * FARADAY * FINITE["diffusivity"] * FINITE["saturation"] / 5.1e3 * 1e6, color="0.6", linewidth=0.8)
    axis.set_xlabel("t (s)")
    axis.set_ylabel("depth (µm); grey: z F D C_sat / i")
    axis.grid(alpha=0.3, which="both")
    axis.legend(fontsize=8)
    error = 100 * (depth / reference - 1)
    print(f"finite current: against finite volumes {error[0]:+.3f} % at {t[0]:.0f} s, at most {np.max(np.abs(error)):.3f} %, "
          f"at the end {depth[-1] * 1e6:.2f} um and {reference[-1] * 1e6:.2f} um")
    slow = np.argmax(np.diff(depth) < 0.95 * SPEED * np.diff(t))
    print(f"the front slows down at {t[slow]:.0f} s, {depth[slow] * 1e6:.1f} um; by finite volumes at "
          f"{reference[np.argmax(np.diff(reference) < 0.95 * SPEED * np.diff(t))] * 1e6:.1f} um")
    save(figure, "transition.png")


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
draw_depth()
draw_profile()
draw_transition()
