#!/usr/bin/python3
"""The two finite-volume models of the crevice: plot_reference.py [FOLDER]; ten minutes.

reference.png: depth, concentration and active site in time, averaged over the gap; trench.png: the same in two dimensions;
gap.png, diffusivity.png, saturation.png, factor.png: other values of one parameter, in two dimensions; ignition.png: the
rate factor that a width of the starting region needs (averaged over the gap).
"""
import sys
from dataclasses import replace
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from gap_averaged import HOUR, Crevice, least_factor, simulate  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from trench import carve  # noqa: E402

# Widths of the region that starts the attack: the scene's, and one that lets it live over a wider range.
WIDTH, WIDER = 500e-6, 1000e-6


def of_gap(value):
    return {"mouthGap": value * 1e-6, "endGap": 0.2 * value * 1e-6}


# Name: axis label, title of the legend, values, what of the crevice they set.
PARAMETERS = {
    "gap": ("gap at the mouth (µm), a fifth of it at the end", "gap (µm)", (20, 30, 40, 45, 50, 60, 80, 100), of_gap),
    "diffusivity": ("D (µm²/s)", "D (µm²/s)", (360, 430, 500, 570, 640, 720, 900, 1080, 1440),
                    lambda value: {"diffusivity": value * 1e-12}),
    "saturation": ("C_sat (mol/L)", "C_sat (mol/L)", (5.0, 5.2, 5.4, 5.5, 5.6, 5.7, 5.8, 5.9),
                   lambda value: {"saturation": value * 1e3}),
    "factor": ("rate factor", "rate factor", (3, 4, 5, 6, 8, 10, 12, 14, 15, 17, 20, 25, 30),
               lambda value: {"factor": value}),
}


def trench_of(crevice, length=4e-3):
    """The trench at every hour in two dimensions, from when the active site is well within `length` of the mouth; None
    where the attack dies."""
    averaged = simulate(crevice)
    if not averaged.is_alive():
        return None
    hours = np.arange(1, 72)
    start = int(hours[np.argmax(averaged.site_at(hours * HOUR) < 0.85 * length)])
    return carve(crevice, columns=240, longest=600.0, length=length, start=start)


def draw(name):
    label, title, values, change = PARAMETERS[name]
    print(f"{name}:")
    trenches = {value: trench_of(replace(Crevice(ignition=WIDER), **change(value))) for value in values}
    rows, lives = [], []
    for value, trench in trenches.items():
        if trench is None:
            continue
        stopTime, stopPlace = trench.stop()
        rows.append((value, stopTime / HOUR, stopPlace * 1e3, trench.site[-1] * 1e3, trench.deepest()[0] * 1e6))
        lives.append(simulate(replace(Crevice(ignition=WIDTH), **change(value))).is_alive())
        print("  {:6g}: slow from {:.1f} h, {:.3f} mm on; at 72 h {:.3f} mm, {:.1f} um deep".format(*rows[-1]),
              "" if lives[-1] else f"(dies if started over {WIDTH * 1e6:g} um)")
    rows, lives = np.array(rows), np.array(lives)
    figure, (profile, place, depth) = figures.plt.subplots(1, 3, figsize=(14, 4.0), constrained_layout=True)
    shown = rows[:: max(1, len(rows) // 5), 0]
    for k, value in enumerate(shown):
        profile.plot(trenches[value].x * 1e3, trenches[value].depth[-1] * 1e6,
                     color=figures.plt.cm.viridis(k / len(shown)), label=f"{value:g}")
    for axis, column, colour, what in ((place, 2, "C1", "where it slows down, "), (place, 3, "C0", "at 72 h, "),
                                       (depth, 4, "C2", "")):
        axis.plot(rows[:, 0], rows[:, column], colour + "-", linewidth=0.9)
        for of, marker, width in ((lives, "o", WIDTH), (~lives, "x", WIDER)):
            if np.any(of):
                axis.plot(rows[of, 0], rows[of, column], colour + marker, markersize=5,
                          label=f"{what}lives if started over {width * 1e6:g} µm")
    profile.set_xlim(0, 4)
    profile.set_xlabel("x from the mouth (mm)")
    profile.set_ylabel("depth at 72 h (µm)")
    profile.legend(title=title, fontsize=8, title_fontsize=8)
    place.set_ylabel("active site, from the mouth (mm)")
    depth.set_ylabel("largest depth at 72 h (µm)")
    for axis in (place, depth):
        axis.set_xlabel(label)
        axis.set_xlim(0.95 * min(values), 1.02 * max(values))
        axis.set_ylim(0, None)
        axis.legend(fontsize=8)
    for axis in (profile, place, depth):
        axis.grid(alpha=0.3)
    save(figure, f"{name}.png")


def draw_reference():
    result = simulate(Crevice(), cells=2032)
    dying = simulate(Crevice(factor=1.0), cells=2032)
    figure, axes = figures.plt.subplots(2, 2, figsize=(11, 7), constrained_layout=True)
    (profile, concentration), (place, current) = axes
    shown = (1, 2, 5, 10, 20, 30, 50, 72)
    for k, hour in enumerate(shown):
        colour = figures.plt.cm.viridis(k / len(shown))
        profile.semilogy(result.x * 1e3, result.depth[hour] * 1e6, color=colour, label=f"{hour} h")
        concentration.plot(result.x * 1e3, result.concentration[hour] / 1e3, color=colour, label=f"{hour} h")
    for run, title, line in ((result, f"factor {result.crevice.factor:g}", "C0-"), (dying, "rates as printed", "C3--")):
        t = np.array(run.time) / HOUR
        place.plot(t, np.array(run.site) * 1e3, line, label=title)
        current.semilogy(t[1:], run.peak[1:], line, label=title)
    stopTime, stopPlace = result.stop()
    place.plot(stopTime / HOUR, stopPlace * 1e3, "C0o", label=f"drift < 1 % in 10 h from {stopTime / HOUR:.1f} h on")
    profile.set_ylim(1e-2, 1e3)
    for axis, title in ((profile, "depth (µm)"), (concentration, "C (mol/L)")):
        axis.set_xlabel("x from the mouth (mm)")
        axis.set_ylabel(title)
        axis.legend(fontsize=8, ncol=2)
    for axis, title in ((place, "active site, from the mouth (mm)"), (current, "highest current density (A/m²)")):
        axis.set_xlabel("t (h)")
        axis.set_ylabel(title)
        axis.legend(fontsize=8)
    for axis in axes.flat:
        axis.grid(alpha=0.3)
    save(figure, "reference.png")


def draw_trench():
    averaged, trench = simulate(Crevice(), cells=2032), carve()
    figure, axes = figures.plt.subplots(2, 2, figsize=(11, 7), constrained_layout=True)
    (profile, field), (place, depth) = axes
    shown = (10, 20, 30, 40, 50, 60, 72)
    for number, hour in enumerate(shown):
        colour = figures.plt.cm.viridis(number / len(shown))
        profile.plot(trench.x * 1e3, trench.depth[hour - 6] * 1e6, "-", color=colour, label=f"{hour} h")
        profile.plot(averaged.x * 1e3, averaged.depth[hour] * 1e6, ":", color=colour, linewidth=0.9)
    profile.set_title("lines: two dimensions; dotted: averaged over the gap", fontsize=9)
    h = 0.5 * (50e-6 - 40e-6 * trench.x / trench.crevice.length) + trench.depth[-1]
    y = h[:, None] * np.concatenate([[0.0], trench.eta, [1.0]])
    missing = trench.crevice.saturation - trench.concentration[-1]
    levels = [0.3, 1, 3, 10, 30, 100, 300, 1000, 3000, 6000]
    contours = field.contourf(np.repeat(trench.x[:, None], y.shape[1], axis=1) * 1e3, y * 1e6,
                              np.maximum(levels[0], np.concatenate([missing[:, :1], missing], axis=1)), levels=levels,
                              cmap="viridis_r", norm="log")
    figure.colorbar(contours, ax=field, label="C_sat - C at 72 h (mol/m³)", ticks=levels, format="%g")
    deepest = np.array([trench.deepest(k) for k in range(len(trench.times))])
    for axis, two, one in ((place, trench.site * 1e3, averaged.site_at(trench.times) * 1e3),
                           (depth, deepest[:, 0] * 1e6, averaged.depth[6:].max(axis=1) * 1e6)):
        axis.plot(trench.times / HOUR, two, "-", label="two dimensions")
        axis.plot(trench.times / HOUR, one, ":", label="averaged over the gap")
    for axis, title in ((profile, "depth (µm)"), (field, "y (µm)")):
        axis.set_xlim(0, 3)
        axis.set_xlabel("x from the mouth (mm)")
        axis.set_ylabel(title)
    for axis, title in ((place, "where saturation begins, from the mouth (mm)"), (depth, "largest depth (µm)")):
        axis.set_xlabel("t (h)")
        axis.set_ylabel(title)
    for axis in (profile, place, depth):
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    save(figure, "trench.png")


def draw_ignition():
    widths = np.array([200, 250, 300, 350, 400, 450, 500, 550, 600, 700, 800, 900, 1000])
    needed = np.array([least_factor(Crevice(ignition=width * 1e-6), high=100.0) for width in widths])
    for width, factor in zip(widths, needed):
        print(f"{width} um lives on from a rate factor of {factor:.2f} on")
    figure, axis = figures.plt.subplots(figsize=(6.4, 3.8), constrained_layout=True)
    axis.semilogy(widths, needed, "o-", markersize=4)
    axis.axhline(1.0, color="C3", linewidth=0.9, label="rates as printed")
    axis.axhline(Crevice().factor, color="0.4", linewidth=0.9, linestyle="--", label=f"factor {Crevice().factor:g}")
    axis.set_xlabel("width of the region that starts at 0.99 C_sat (µm)")
    axis.set_ylabel("least rate factor that keeps the attack alive")
    axis.grid(alpha=0.3, which="both")
    axis.legend()
    save(figure, "ignition.png")


def save(figure, name):
    figure.savefig(folder / name, dpi=100)
    print(folder / name)


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    draw_reference()
    draw_trench()
    for parameter in PARAMETERS:
        draw(parameter)
    draw_ignition()
