#!/usr/bin/python3
"""attack.png: the electrolyte that eats along the boundaries; paths.png: when it arrives where, against shortest paths;
plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402
from shortest_paths import Paths  # noqa: E402

SPEED = 5.1e3 / (2.19 * 96485.33212 * 142900)  # of a plane front through the material of boundaries, m/s
SIZE = 120e-6


def arrivals(results):
    """[n] time at which each point turned liquid; nan: not yet."""
    times = np.full(len(results.x), np.nan)
    for step in results.steps:
        turned = (results.field("Damage", step) >= 1) & np.isnan(times)
        times[turned] = results.time(step)
    return times


def against_paths(name, paths):
    """Path lengths (m) and times (s) of points in the middle of boundaries, and the speed of a line through them."""
    results = Results(folder / name)
    times = arrivals(results)
    inside = np.flatnonzero((results.block == 2) & (results.x[:, 0] > 0))
    path, away = paths.to(results.x[inside, :2])
    time, middle = times[inside], (away < 0.8e-6) & np.isfinite(path)
    # Nearer to the surface, a boundary is not thin against its depth.
    there = middle & np.isfinite(time) & (path > 5e-6)
    speed, start = np.polyfit(time[there], path[there], 1)
    rest = path[there] - start - speed * time[there]
    late = middle & (path < 0.9 * speed * results.time(results.steps[-1])) & ~np.isfinite(time)
    print(f"{name}: speed {speed / SPEED:.3f} of i/(z F C_solid), paths scatter by {1e6 * rest.std():.2f} um (at most "
          f"{1e6 * np.max(np.abs(rest)):.1f}), {there.sum()} points; {late.sum()} not reached in time")
    return path[there], time[there], speed


def draw_attack():
    results = Results(folder / "grain_boundary")
    figure, axes = figures.plt.subplots(1, 4, figsize=(14, 3.7), constrained_layout=True, sharey=True)
    order = np.lexsort((results.x[:, 0], results.x[:, 1]))
    n_rows = len(np.unique(np.round(results.x[:, 1] / 1e-9)))
    (left, bottom), (right, top) = results.x[:, :2].min(axis=0), results.x[:, :2].max(axis=0)
    extent = 1e6 * np.array([left, right, bottom, top])
    for axis, wanted in zip(axes, (100, 250, 400, 600)):
        step = min(results.steps, key=lambda s: abs(results.time(s) - wanted))
        liquid = results.field("Damage", step) >= 1
        shown = np.where(liquid, results.field("Concentration", step) / 4600.0, np.nan)
        metal = np.where(results.block == 2, 0.75, 0.9)[order].reshape(n_rows, -1)
        axis.imshow(metal, origin="lower", extent=extent, cmap="gray", vmin=0, vmax=1)
        drawn = axis.imshow(shown[order].reshape(n_rows, -1), origin="lower", extent=extent, vmin=0, vmax=1)
        axis.set_title(f"{results.time(step):.0f} s")
        axis.set_xlabel("x (µm)")
    axes[0].set_ylabel("y (µm)")
    figure.colorbar(drawn, ax=list(axes), label="C / C_sat in the electrolyte")
    figure.savefig(folder / "attack.png", dpi=110)
    print(folder / "attack.png")


def draw_paths():
    seeds = np.loadtxt(Path(__file__).resolve().parent / "seeds.txt")[:, :2]
    paths = Paths(seeds, np.zeros(2), np.full(2, SIZE))
    figure, axes = figures.plt.subplots(1, 3, figsize=(12, 3.8), constrained_layout=True, sharey=True)
    for axis, name, title in zip(axes, ("grain_boundary", "fine", "thin"),
                                 ("3 µm, three points thick", "3 µm, six points thick", "one point thick")):
        path, time, speed = against_paths(name, paths)
        axis.plot(time, path * 1e6, ".", markersize=2)
        t = np.array([0.0, 600.0])
        axis.plot(t, SPEED * t * 1e6, "k-", linewidth=0.8, label="i t/(z F C_solid)")
        axis.plot(t, speed * t * 1e6, "r--", linewidth=0.8, label=f"{speed / SPEED:.2f} of it")
        axis.set_title(title, fontsize=10)
        axis.set_xlabel("time of arrival (s)")
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    axes[0].set_ylabel("way along boundaries (µm)")
    figure.savefig(folder / "paths.png", dpi=110)
    print(folder / "paths.png")


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
draw_paths()
draw_attack()
