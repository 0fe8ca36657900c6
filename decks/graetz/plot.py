#!/usr/bin/python3
"""sherwood.png, concentration.png: the wall's Sherwood number against Graetz' problem; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402
from scipy import sparse  # noqa: E402
from scipy.sparse.linalg import splu  # noqa: E402

HEIGHT, VELOCITY, LENGTH = 1e-3, 0.02, 4e-3  # m, m/s, m
RUNS = {"graetz": ("Pe = 200", 1e-7), "off": ("Pe = 200, off the lattice", 1e-7),
        "upwind": ("Pe = 200, upwind ends alone", 1e-7), "thin": ("Pe = 1000", 2e-8)}
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def graetz(diffusivity, rows=600, steps=6000):
    """x, mean of C over the flow, Sherwood number of the walls: by finite differences, without axial diffusion."""
    y = (np.arange(rows) + 0.5) / rows * HEIGHT
    u = 6 * VELOCITY * y / HEIGHT * (1 - y / HEIGHT)
    dx, dy = LENGTH / steps, HEIGHT / rows
    diagonal = np.full(rows, -2.0)
    diagonal[[0, -1]] = -3.0
    across = sparse.diags([np.ones(rows - 1), diagonal, np.ones(rows - 1)], [-1, 0, 1]) * diffusivity / dy**2
    step = splu((sparse.diags(u / dx) - across).tocsc())
    c, x, mean, flux = np.ones(rows), [], [], []
    for k in range(steps):
        c = step.solve(u / dx * c)
        x.append((k + 1) * dx)
        mean.append(np.sum(u * c) / np.sum(u))
        flux.append(2 * diffusivity * c[0] / dy)
    x, mean, flux = map(np.array, (x, mean, flux))
    return x, mean, 2 * HEIGHT * flux / (diffusivity * mean)


def measure(name, diffusivity):
    """x of the columns, mean of C, Sherwood number of what the points beyond both walls take up."""
    results = Results(str(folder / name))
    step = results.steps[-1]
    x, c, v = results.x, results.field("Concentration", step), results.field("Velocity", step)[:, 0]
    rate, fluid = results.field("Concentration_Flux_Divergence", step), results.field("Fluid", step) == 1
    spacing = np.min(np.diff(np.unique(np.round(x[:, 0], 9))))
    columns = np.unique(np.round(x[fluid, 0], 9))
    mean, sherwood = [], []
    for column in columns:
        here = np.abs(x[:, 0] - column) < spacing / 4
        beyond = here & ((x[:, 1] < 0) | (x[:, 1] > HEIGHT))
        mean.append(np.sum((c * v)[here & fluid]) / np.sum(v[here & fluid]))
        flux = 0.5 * np.sum(rate[beyond]) * spacing
        sherwood.append(2 * HEIGHT * flux / (diffusivity * mean[-1]))
    return columns, np.array(mean), np.array(sherwood)


def draw_sherwood():
    figure, axes = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    for axis, run in zip(axes, ("graetz", "thin")):
        x, _, exact = graetz(RUNS[run][1])
        axis.plot(x / HEIGHT, exact, "k-", linewidth=0.8, label="exact, no axial diffusion")
        for color, points in zip(("C0", "C1", "C2"), (10, 20, 40)):
            if not (folder / f"{run}_{points}.h5").exists():
                continue
            columns, _, sherwood = measure(f"{run}_{points}", RUNS[run][1])
            axis.plot(columns / HEIGHT, sherwood, "o", color=color, markersize=2.5, label=f"{points} points across")
        axis.set_ylim(5, 40 if run == "graetz" else 60)
        axis.set_xlabel("x/H")
        axis.set_ylabel("Sherwood number")
        axis.set_title(RUNS[run][0], fontsize=9)
        axis.legend(fontsize=7)
    figure.savefig(folder / "sherwood.png", dpi=110)
    print(folder / "sherwood.png")


def print_errors():
    for run, (title, diffusivity) in RUNS.items():
        x, mean, exact = graetz(diffusivity)
        for points in (10, 20, 40):
            if not (folder / f"{run}_{points}.h5").exists():
                continue
            columns, own_mean, sherwood = measure(f"{run}_{points}", diffusivity)
            whole = np.log(np.interp(columns[-1], x, mean)) / np.log(own_mean[-1])
            local = [sherwood[np.argmin(np.abs(columns - s * HEIGHT))] for s in (1, 2, 3)]
            there = [columns[np.argmin(np.abs(columns - s * HEIGHT))] for s in (1, 2, 3)]
            errors = [100 * (s / np.interp(c, x, exact) - 1) for s, c in zip(local, there)]
            print(f"{title}, {points} points: mean Sherwood number {100 * (1 / whole - 1):+.2f} %, "
                  "local at x/H = 1, 2, 3 " + " ".join(f"{e:+.2f}" for e in errors) + " %")


def draw_concentration():
    results = Results(str(folder / "thin_40"))
    step = results.steps[-1]
    fluid = results.field("Fluid", step) == 1
    x, c = results.x[fluid], results.field("Concentration", step)[fluid]
    figure, axis = figures.plt.subplots(figsize=(9, 2.6), constrained_layout=True)
    shown = axis.scatter(x[:, 0] * 1e3, x[:, 1] * 1e3, c=c, s=12, marker="s", linewidths=0, cmap="viridis", vmin=0, vmax=1)
    figure.colorbar(shown, ax=axis, label="C")
    axis.set_aspect("equal")
    axis.set_xlabel("x (mm)")
    axis.set_ylabel("y (mm)")
    figure.savefig(folder / "concentration.png", dpi=110)
    print(folder / "concentration.png")


print_errors()
draw_sherwood()
draw_concentration()
