#!/usr/bin/python3
"""couette.png, womersley.png, vortices.png: flows that start, oscillate and decay, against exact ones; plot.py [RESULTS]"""
import cmath
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
TABLE = {2: ((0.5208, 60.86), (0.5268, 57.16)), 5: ((0.0843, 91.21), (0.1044, 80.67))}  # amplitude, lag: middle, mean


def save(figure, name):
    figure.savefig(folder / name, dpi=110)
    print(folder / name)


def relative(values, exact):
    return np.sqrt(np.sum((values - exact)**2) / np.sum(exact**2))


def report(name):
    return json.loads((folder / f"{name}.report.json").read_text())


def loglog(axis, x, ticks_title, series):
    for (label, values), style in zip(series.items(), ("o-", "s--", "^-", "v--")):
        axis.loglog(x, values, style, markersize=4, label=label)
        orders = np.log2(np.array(values[:-1]) / values[1:])
        print(f"{label}: " + " ".join(f"{value:.2e}" for value in values) + "  orders "
              + " ".join(f"{order:.2f}" for order in orders))
    first = max(values[0] for values in series.values())
    axis.loglog(x, first * (x[0] / np.array(x))**2, "k:", linewidth=0.8, label="second order")
    axis.set_xlabel(ticks_title)
    axis.set_xticks(x, x)
    axis.minorticks_off()
    axis.legend(fontsize=7)


def series(y, t):
    n = np.arange(1, 100)[:, None]
    terms = 2 / (n * np.pi) * (-1.0)**n * np.exp(-n**2 * np.pi**2 * t) * np.sin(n * np.pi * y)
    return y + terms.sum(axis=0)


def draw_couette():
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    points, times = (10, 20, 40), (0.01, 0.03, 0.1, 0.5)
    errors = {f"{label}, t = {t:g} s": [] for label in ("lattice", "jittered") for t in (0.03, 0.1)}
    for n in points:
        for name, label in (("couette", "lattice"), ("couette_jittered", "jittered")):
            results = Results(str(folder / f"{name}_{n}"))
            for t, step in zip(times, results.steps[-4:]):
                inside = results.field("Fluid", step) == 1
                y, u = results.x[inside, 1], results.field("Velocity", step)[inside, 0]
                if f"{label}, t = {t:g} s" in errors:
                    errors[f"{label}, t = {t:g} s"].append(relative(u, series(y, t)))
                if n == 20 and label == "jittered":
                    left.plot(u, y, ".", markersize=3, label=f"t = {t:g} s")
    y = np.linspace(0, 1, 201)
    for t in times:
        left.plot(series(y, t), y, "k-", linewidth=0.8)
    left.set_xlabel("velocity (m/s)")
    left.set_ylabel("y (m)")
    left.legend(fontsize=7)
    loglog(right, points, "points across", errors)
    right.set_ylabel("relative error of the velocity (L2)")
    save(figure, "couette.png")


def womersley(number, y):
    """Complex amplitude of the velocity over the quasi-steady one in the middle; y from 0 to 1."""
    root = cmath.sqrt(1j) * number
    return 2 / (1j * number**2) * (1 - np.cosh(root * (2 * y - 1)) / np.cosh(root))


def draw_womersley():
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    points, errors = (10, 20, 40), {f"Wo = {number}": [] for number in TABLE}
    for number in TABLE:
        for n in points:
            results = Results(str(folder / f"womersley_{number}_{n}"))
            inside = results.field("Fluid", results.steps[-1]) == 1
            rows, index = np.unique(results.x[inside, 1].round(9), return_inverse=True)
            counts = np.bincount(index)
            u = np.array([np.bincount(index, results.field("Velocity", step)[inside, 0]) / counts
                          for step in results.steps[-32:]])
            phase = np.exp(2j * np.pi * np.arange(1, 33) / 32)
            amplitude = 2 / 32 * np.sum(u / phase[:, None], axis=0)
            exact = womersley(number, rows)
            errors[f"Wo = {number}"].append(np.sqrt(np.sum(abs(amplitude - exact)**2) / np.sum(abs(exact)**2)))
            m = len(rows) // 2
            middle = (9 * (amplitude[m - 1] + amplitude[m]) - amplitude[m - 2] - amplitude[m + 1]) / 16
            mean = 1.5 * amplitude.mean()
            print(f"Wo = {number}, {n} points: " + ", ".join(
                f"{name} {abs(z):.4f} ({known[0]}) {-np.rad2deg(cmath.phase(z)):.2f} ({known[1]})"
                for name, z, known in zip(("middle", "mean"), (middle, mean), TABLE[number])))
            if n == 20:
                color = "C0" if number == 2 else "C1"
                for k in (7, 15, 23, 31):
                    left.plot(u[k], rows, ".", color=color, markersize=4,
                              label=f"Wo = {number}, four times of a period" if k == 7 else None)
                    y = np.linspace(0, 1, 201)
                    left.plot((womersley(number, y) * phase[k]).real, y, "k-", linewidth=0.6)
    left.set_xlabel("velocity over the quasi-steady one")
    left.set_ylabel("y (m)")
    left.legend(fontsize=7)
    loglog(right, points, "points across", errors)
    right.set_ylabel("relative error of the complex amplitude (L2)")
    save(figure, "womersley.png")


def norm(name, which):
    return report(name)["error_norms"][which + " relative L2 error"]


def draw_vortices():
    figure, axes = figures.plt.subplots(1, 3, figsize=(14, 3.8), constrained_layout=True)
    points = (16, 32, 64)
    loglog(axes[1], points, "points across", {
        f"{label}, {title}": [norm(f"{name}_{n}", which) for n in points]
        for name, label in (("vortices", "lattice"), ("vortices_jittered", "jittered"))
        for which, title in (("u", "velocity"), ("p", "pressure"))})
    axes[1].set_ylabel("relative error at t = 4 s (L2)")
    for n in (16, 64):
        results = Results(str(folder / f"vortices_{n}"))
        inside = results.field("Fluid", results.steps[-1]) == 1
        energy = [np.sum(results.field("Velocity", step)[inside]**2) for step in results.steps[-16:]]
        t = 4 * np.arange(1, 17) / 16
        ratio = np.array(energy) / (0.5 * np.count_nonzero(inside)) / np.exp(-0.4 * t)
        axes[0].plot(t, 100 * (ratio - 1), ".-", label=f"{n} points across")
        print(f"energy with {n} points: off by {100 * (ratio[-1] - 1):.2f} % at t = 4 s")
    axes[0].set_xlabel("t (s)")
    axes[0].set_ylabel("kinetic energy over exp(−4 ν k² t), less 1 (%)")
    axes[0].legend(fontsize=7)
    for speed, name in ((6, "vortices_sound_6"), (10, "vortices_sound_10"), (15, "vortices_32"),
                        (30, "vortices_sound_30")):
        steps = int(report(name)["solver"][0].split(": ")[1].split()[0])
        axes[2].loglog(steps, norm(name, "u"), "o", label=f"Sound Speed {speed} m/s, velocity")
        axes[2].loglog(steps, norm(name, "p"), "s", color=axes[2].lines[-1].get_color(), label=f"{speed}, pressure")
        print(f"sound speed {speed}: {steps} steps, u {norm(name, 'u'):.2e}, p {norm(name, 'p'):.2e}")
    for speed in (30, 60):
        name = f"vortices_64_sound_{speed}"
        print(f"64 points, sound speed {speed}: u {norm(name, 'u'):.2e}, p {norm(name, 'p'):.2e}")
    axes[2].set_xlabel("steps")
    axes[2].set_ylabel("relative error at t = 4 s (L2)")
    axes[2].legend(fontsize=6)
    save(figure, "vortices.png")


draw_couette()
draw_womersley()
draw_vortices()
