#!/usr/bin/python3
"""pipe.png: the Sherwood number of a pipe's wall against Graetz' problem; plot_pipe.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402
from scipy import sparse  # noqa: E402
from scipy.sparse.linalg import splu  # noqa: E402

RADIUS, VELOCITY, LENGTH = 0.5e-3, 0.02, 4e-3  # m, m/s, m
RUNS = {"pipe": ("Pe = 25", 8e-7, (3, 12)), "pipe_thin": ("Pe = 1000", 2e-8, (5, 40))}
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def graetz(diffusivity, rows=600, steps=6000):
    """x, mean of C over the flow, Sherwood number of the wall: by finite volumes, without axial diffusion."""
    dr, dx = RADIUS / rows, LENGTH / steps
    r, face = (np.arange(rows) + 0.5) * dr, np.arange(1, rows) * dr
    flow = 2 * VELOCITY * (1 - (r / RADIUS)**2) * r * dr
    pass_on = diffusivity * face / dr
    diagonal = np.zeros(rows)
    diagonal[:-1] -= pass_on
    diagonal[1:] -= pass_on
    diagonal[-1] -= 2 * diffusivity * RADIUS / dr
    across = sparse.diags([pass_on, diagonal, pass_on], [-1, 0, 1])
    step = splu((sparse.diags(flow / dx) - across).tocsc())
    c, mean, flux = np.ones(rows), [], []
    for _ in range(steps):
        c = step.solve(flow / dx * c)
        mean.append(np.sum(flow * c) / np.sum(flow))
        flux.append(2 * diffusivity * c[-1] / dr)
    mean, flux = np.array(mean), np.array(flux)
    return (np.arange(steps) + 1) * dx, mean, 2 * RADIUS * flux / (diffusivity * mean)


def leveque(x, diffusivity):
    """Of a layer far thinner than the radius: 1.077 (Pe D/x)^(1/3)."""
    pe = VELOCITY * 2 * RADIUS / diffusivity
    return 1.0769 * np.cbrt(pe * 2 * RADIUS / x)


def measure(name, diffusivity):
    """x of the columns, Sherwood number of what the rings beyond the wall take up."""
    results = Results(str(folder / name))
    step = results.steps[-1]
    x, c, v = results.x, results.field("Concentration", step), results.field("Velocity", step)[:, 0]
    volume = results.field("Volume", step)
    rate, fluid = results.field("Concentration_Flux_Divergence", step), results.field("Fluid", step) == 1
    spacing = np.min(np.diff(np.unique(np.round(x[:, 0], 9))))
    columns = np.unique(np.round(x[fluid, 0], 9))
    sherwood = []
    for column in columns:
        here = np.abs(x[:, 0] - column) < spacing / 4
        mean = np.sum((c * v * volume)[here & fluid]) / np.sum((v * volume)[here & fluid])
        flux = np.sum((rate * volume)[here & (x[:, 1] > RADIUS)]) / (2 * np.pi * RADIUS * spacing)
        sherwood.append(2 * RADIUS * flux / (diffusivity * mean))
    return columns, np.array(sherwood)


def draw():
    figure, axes = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    for axis, (run, (title, diffusivity, limits)) in zip(axes, RUNS.items()):
        x, _, exact = graetz(diffusivity)
        axis.plot(x / (2 * RADIUS), exact, "k-", linewidth=0.8, label="exact, no axial diffusion")
        axis.plot(x / (2 * RADIUS), leveque(x, diffusivity), "k:", linewidth=0.8, label="Lévêque")
        axis.axhline(3.657, color="0.6", linewidth=0.6)
        for color, points in zip(("C1", "C2"), (10, 20)):
            columns, sherwood = measure(f"{run}_{points}", diffusivity)
            axis.plot(columns / (2 * RADIUS), sherwood, "o", color=color, markersize=2.5,
                      label=f"{points} points a radius")
            places = (0.5, 1, 2, 3)
            errors = []
            for place in places:
                k = np.argmin(np.abs(columns - place * 2 * RADIUS))
                errors.append(100 * (sherwood[k] / np.interp(columns[k], x, exact) - 1))
            print(f"{title}, {points} points: at x/D = {places} " + " ".join(f"{e:+.1f}" for e in errors)
                  + f" %; at 3 D {sherwood[k]:.3f}, exact {np.interp(columns[k], x, exact):.3f}")
        axis.set_ylim(*limits)
        axis.set_xlabel("x/D")
        axis.set_ylabel("Sherwood number")
        axis.set_title(title, fontsize=9)
        axis.legend(fontsize=7)
    figure.savefig(folder / "pipe.png", dpi=110)
    print(folder / "pipe.png")


draw()
