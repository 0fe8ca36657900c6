#!/usr/bin/python3
"""flow.png, lines.png: the lid-driven cavity against the converged solution; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

# Extremes of u on x = 1/2 and of v on y = 1/2: Marchi, Suero & Araki, J. Braz. Soc. Mech. Sci. Eng. 31 (2009) 186.
EXTREMES = {"u_min": -0.2140417, "v_max": 0.1795728, "v_min": -0.2538030}
# Converged values on these lines, by finite differences with Richardson's extrapolation.
Y = (.0547, .0625, .0703, .1016, .1719, .2813, .4531, .5, .6172, .7344, .8516, .9531, .9609, .9688, .9766)
U = (-.03722, -.04196, -.04660, -.06441, -.10171, -.15763, -.21394, -.20912, -.13879, .00417, .23649, .69092, .74036,
     .79183, .84364)
X = (.0625, .0703, .0781, .0938, .1563, .2266, .2344, .5, .8047, .8594, .9063, .9453, .9531, .9609, .9688)
V = (.09477, .10355, .11171, .12638, .16477, .17931, .17951, .05754, -.25350, -.23365, -.17705, -.10852, -.09338,
     -.07797, -.06219)
POINTS = (24, 48, 96)
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")  # of draw_lines() and draw_flow()


def save(figure, name):
    figure.savefig(folder / name, dpi=110)
    print(folder / name)


def grid(name, n, field, component=None):
    """[n, n] by x, y."""
    results = Results(str(name))
    step = results.steps[-1]
    inside = results.field("Fluid", step) == 1
    values = results.field(field, step)[inside]
    array = np.full((n, n), np.nan)
    i, j = np.floor(results.x[inside, :2] * n).astype(int).T
    array[i, j] = values if component is None else values[:, component]
    return array


def middle(array):
    """On the line between the two middle rows of points, by cubics."""
    k = len(array) // 2
    return (-array[k - 2] + 9 * array[k - 1] + 9 * array[k] - array[k + 1]) / 16


def extreme(values, sign):
    k = int(np.clip(np.argmax(sign * values), 2, len(values) - 3))
    fit = np.polyfit(np.arange(-2, 3), values[k - 2:k + 3], 4)
    return sign * np.max(sign * np.polyval(fit, np.linspace(-1, 1, 401)))


def middle_lines(name, n):
    """u on x = 1/2, v on y = 1/2."""
    return middle(grid(name, n, "Velocity", 0)), middle(grid(name, n, "Velocity", 1).T)


def extreme_errors(name, n):
    """Of a run with n points across."""
    u, v = middle_lines(name, n)
    found = {"u_min": extreme(u, -1), "v_max": extreme(v, 1), "v_min": extreme(v, -1)}
    return {key: value - EXTREMES[key] for key, value in found.items()}


def draw_lines():
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    errors = {key: [] for key in EXTREMES}
    for n in POINTS:
        for key, error in extreme_errors(folder / f"cavity_{n}", n).items():
            errors[key].append(abs(error))
        if n == 48:
            u, v = middle_lines(folder / f"cavity_{n}", n)
            s = (np.arange(n) + 0.5) / n
            left.plot(s, u, "-", label="u on x = 1/2")
            left.plot(s, v, "-", label="v on y = 1/2")
    left.plot(Y + X, U + V, "k.", markersize=4, label="converged")
    left.set_xlabel("y, x")
    left.set_ylabel("velocity over that of the lid, 48 points across")
    left.legend(fontsize=7)
    for key, values in errors.items():
        right.loglog(POINTS, values, "o-", markersize=4, label=key)
        print(key, " ".join(f"{value:.2e}" for value in values))
    right.set_xlabel("points across")
    right.set_ylabel("error of the extremes")
    right.set_xticks(POINTS, POINTS)
    right.set_yticks([5e-4, 1e-3, 2e-3, 4e-3], ["0.0005", "0.001", "0.002", "0.004"])
    right.minorticks_off()
    right.legend(fontsize=7)
    save(figure, "lines.png")


def draw_flow(n=96):
    name = folder / f"cavity_{n}"
    u, v, p = grid(name, n, "Velocity", 0), grid(name, n, "Velocity", 1), grid(name, n, "Pressure")
    s = (np.arange(n) + 0.5) / n
    figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    speed = left.pcolormesh(s, s, np.hypot(u, v).T, cmap="viridis", vmax=1)
    figure.colorbar(speed, ax=left, label="speed over that of the lid")
    left.streamplot(s, s, u.T, v.T, color="w", linewidth=0.5, density=1.6, arrowsize=0.6)
    limit = np.percentile(np.abs(p), 99)
    pressure = right.pcolormesh(s, s, p.T, cmap="RdBu_r", vmin=-limit, vmax=limit)
    figure.colorbar(pressure, ax=right, label="pressure over ρ U²")
    for axis in (left, right):
        axis.set_aspect("equal")
    save(figure, "flow.png")


if __name__ == "__main__":
    draw_lines()
    draw_flow()
