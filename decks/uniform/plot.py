#!/usr/bin/python3
"""depth.png: depth of the front against Faraday's law, and the difference; random.png: bonds that break at random;
plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402

FARADAY = 96485.33212
SPEEDS = {"": 5.1e3 / (2.19 * FARADAY * 142900), "_copper": 1450 / (2 * FARADAY * 141000)}
AREAS = {"bar": 1.0, "strip": 20e-6, "block": 100e-12}
SOLID, SATURATION, SPACING, WIDTH = 142900.0, 4600.0, 1e-6, 20e-6


def draw_depth():
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    for metal, title in (("", "SS304"), ("_copper", "Cu")):
        times = np.linspace(0, 300, 2)
        left.plot(times, SPEEDS[metal] * times * 1e6, "-", color="0.4", linewidth=0.9)
        for body, marker in (("bar", "o"), ("strip", "s"), ("block", "^")):
            history = read_history(folder / f"{body}{metal}.csv")
            t, depth = history["time"], history["Dissolved"] / AREAS[body]
            left.plot(t, depth * 1e6, marker, markersize=3, label=f"{title}, {body}")
            error = depth[1:] / (SPEEDS[metal] * t[1:]) - 1
            right.plot(t[1:], 100 * error, marker + "-", markersize=3, linewidth=0.7, label=f"{title}, {body}")
            print(f"{title}, {body}: {1e6 * depth[-1]:.4f} um, exact {1e6 * SPEEDS[metal] * t[-1]:.4f} um; error "
                  f"{100 * error[-1]:+.3g} % at the end, at most {100 * np.max(np.abs(error)):.3g} %")
    for axis, label in ((left, "depth (µm); lines: i t / (z F C_solid)"), (right, "error of the depth (%)")):
        axis.set_xlabel("t (s)")
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    left.legend(fontsize=7)
    figure.savefig(folder / "depth.png", dpi=110)
    print(folder / "depth.png")


def random_fronts(name):
    """Times, depths by the metal that has gone (m), and standard deviations of the front over the rows (m)."""
    results = Results(folder / name)
    metal, rows = results.x[:, 0] > 0, np.round(results.x[:, 1] / SPACING - 0.5).astype(int)
    times, depths, roughness = [], [], []
    for step in results.steps[1:]:
        c, liquid = results.field("Concentration", step), results.field("Damage", step) >= 1
        gone = np.where(liquid, 1.0, (SOLID - c) / (SOLID - SATURATION))
        times.append(results.time(step))
        depths.append(np.sum(gone[metal]) * SPACING**2 / WIDTH)
        roughness.append(np.bincount(rows[metal & liquid], minlength=rows.max() + 1).std() * SPACING)
    return np.array(times), np.array(depths), np.array(roughness)


def draw_random():
    figure, axes = figures.plt.subplots(1, 4, figsize=(13, 3.6), constrained_layout=True)
    right, rough_at = axes[3], 100.0
    for seed in (1, 2, 3):
        t, depth, roughness = random_fronts(f"random{seed}")
        error = 100 * (depth / (SPEEDS[""] * t) - 1)
        late = t > 30
        right.plot(t[late], error[late], linewidth=0.8, label=f"seed {seed}")
        print(f"seed {seed}: depth {1e6 * depth[-1]:.3f} um, error {error[-1]:+.2f} % at the end, at most "
              f"{np.max(np.abs(error[late])):.2f} % after 30 s; roughness {1e6 * np.mean(roughness[late]):.3f} um")
        if seed == 1:
            rough_at = t[np.argmax(np.where(t > 95, roughness, 0) > 0.45e-6)]
    right.set_xlabel("t (s)")
    right.set_ylabel("error of the depth (%)")
    right.grid(alpha=0.3)
    right.legend(fontsize=8)
    shown = (("strip", "Deterministic", 100.0), ("random1", "seed 1", rough_at), ("random2", "seed 2", rough_at))
    for axis, (name, title, wanted) in zip(axes, shown):
        results = Results(folder / name)
        step = min(results.steps, key=lambda s: abs(results.time(s) - wanted))
        near = np.abs(results.x[:, 0] - SPEEDS[""] * 100) < 6e-6
        x, damage = results.x[near], results.field("Damage", step)[near]
        drawn = axis.scatter(x[:, 0] * 1e6, x[:, 1] * 1e6, c=damage, s=36, marker="s", vmin=0, vmax=1)
        liquid = damage >= 1
        axis.plot(x[liquid, 0] * 1e6, x[liquid, 1] * 1e6, "k.", markersize=2)
        axis.set_title(f"Damage, {title}, {results.time(step):.1f} s; dots: liquid", fontsize=9)
        axis.set_xlabel("x (µm)")
        axis.set_ylabel("y (µm)")
        axis.set_aspect("equal")
    figure.colorbar(drawn, ax=list(axes[:3]))
    figure.savefig(folder / "random.png", dpi=110)
    print(folder / "random.png")


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
draw_depth()
draw_random()
