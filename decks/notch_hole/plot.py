#!/usr/bin/python3
"""paths.png: paths of the cracks beside their holes, by shares of bonds and with the hole cut out of the mesh; plot.py
[RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402

HORIZON, RADIUS, HOLE_X, START = 1.5, 4.0, 20.0, 8.0  # mm, of the deck
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def rows_of(name):
    with open(folder / f"{name}.csv") as file:
        return list(csv.DictReader(file))[1:]


def path_of(name):
    """[n, 2] the tips in turn, mm, each farther along x than those before it."""
    tips = 1e3 * np.array([[float(row["Crack_TipX"]), float(row["Crack_TipY"])] for row in rows_of(name)])
    ahead = np.concatenate([[True], np.diff(np.maximum.accumulate(tips[:, 0])) > 0])
    return tips[ahead]


def fate(name, height):
    """How it ends, and how far from the rim of the hole it passes at the nearest, mm."""
    path = path_of(name)
    nearest = np.min(np.hypot(path[:, 0] - HOLE_X, path[:, 1] - height)) - RADIUS
    return "sinks" if float(rows_of(name)[-1]["Damage_Of_Rim"]) >= 0.3 else "passes", nearest


heights = sorted({int(file.stem.split("_")[1]) for file in folder.glob("shares_*.csv")})
figure, axes = figures.plt.subplots(1, len(heights), figsize=(2.9 * len(heights), 4), sharey=True,
                                    constrained_layout=True)
for axis, height in zip(axes, heights):
    axis.add_patch(figures.plt.Circle((HOLE_X, height), RADIUS, fill=False, color="0.4"))
    axis.plot([0, START], [0, 0], color="k", linewidth=2)
    paths = {}
    for kind, color, label in (("shares", "tab:blue", "shares of bonds"), ("cut", "tab:orange", "hole cut out")):
        paths[kind] = path_of(f"{kind}_{height}")
        axis.plot(*paths[kind].T, color=color, linewidth=1, label=label)
        rows = rows_of(f"{kind}_{height}")
        how, nearest = fate(f"{kind}_{height}", height)
        print(f"hole at {height} mm, {label}: {how}, {nearest:.2f} mm from the rim at the nearest; last tip "
              f"{paths[kind][-1].round(2)}, {float(rows[-1]['time']):.4g} cycles, {len(rows)} equilibria")
    end = min(paths[kind][-1, 0] for kind in paths)
    x = np.linspace(START + HORIZON, end, 100)
    apart = np.interp(x, *paths["shares"].T) - np.interp(x, *paths["cut"].T)
    print(f"  paths apart by {np.max(np.abs(apart)):.2f} mm at most up to x = {end:.1f} mm, "
          f"{np.max(np.abs(apart)) / HORIZON:.2f} horizons")
    axis.set_xlim(4, 40)
    axis.set_ylim(-6, 14)
    axis.set_aspect("equal")
    axis.set_title(f"hole {height} mm over the notch")
    axis.set_xlabel("x (mm)")
    axis.grid(alpha=0.3)
axes[0].set_ylabel("y (mm)")
axes[0].legend(fontsize=7, loc="lower left")
figure.savefig(folder / "paths.png", dpi=150)
print(folder / "paths.png")
