#!/usr/bin/python3
"""paths.png: paths of the cracks beside their holes, by shares of bonds and with the hole cut out of the mesh or of the
lattice; plot.py [RESULTS]"""
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


KINDS = {"shares": ("tab:blue", "shares of bonds"), "lattice": ("tab:green", "cut out of the lattice"),
         "triangles": ("tab:red", "shares of bonds of triangles"), "cut": ("tab:orange", "cut out of triangles"),
         "fine": ("tab:purple", "cut out of half as large triangles")}
heights = sorted({int(file.stem.split("_")[1]) for file in folder.glob("shares_*.csv")})
figure, axes = figures.plt.subplots(2, (len(heights) + 1) // 2, figsize=(13, 6.4), sharex=True, sharey=True,
                                    constrained_layout=True)
for axis, height in zip(axes.ravel(), heights):
    axis.add_patch(figures.plt.Circle((HOLE_X, height), RADIUS, fill=False, color="0.4"))
    axis.plot([0, START], [0, 0], color="k", linewidth=2)
    paths = {}
    for kind, (color, label) in KINDS.items():
        if not (folder / f"{kind}_{height}.csv").exists():
            continue
        paths[kind] = path_of(f"{kind}_{height}")
        axis.plot(*paths[kind].T, color=color, linewidth=1, label=label)
        rows = rows_of(f"{kind}_{height}")
        how, nearest = fate(f"{kind}_{height}", height)
        print(f"hole at {height} mm, {label}: {how}, {nearest:.2f} mm from the rim at the nearest; last tip "
              f"{paths[kind][-1].round(2)}, {float(rows[-1]['time']):.4g} cycles, {len(rows)} equilibria")
    for kind, other in ((kind, other) for kind in list(paths)[1:] for other in ("shares", "triangles")
                        if other == "shares" or (kind == "cut" and other in paths)):
        end = min(paths[other][-1, 0], paths[kind][-1, 0])
        x = np.linspace(START, end, 200)
        apart = np.abs(np.interp(x, *paths[other].T) - np.interp(x, *paths[kind].T))
        print(f"  {KINDS[kind][1]} and {KINDS[other][1]}: paths apart by {apart.max():.2f} mm at most, {apart[-1]:.2f} at x = {end:.1f} mm, root of "
              f"the mean square {np.sqrt(np.mean(apart**2)):.2f} mm; horizon {HORIZON} mm")
    axis.set_xlim(6, 34)
    axis.set_ylim(-3, 15)
    axis.set_aspect("equal")
    axis.set_title(f"hole {height} mm over the line of the notch")
    axis.grid(alpha=0.3)
for axis in axes[-1]:
    axis.set_xlabel("x (mm)")
for axis in axes[:, 0]:
    axis.set_ylabel("y (mm)")
straight = path_of("straight")
for name in ("straight", "straight_fine"):
    path = path_of(name)
    print(f"triangles without a hole, {name}: the path leaves the line of the notch by {np.max(np.abs(path[:, 1])):.2f} mm up to "
          f"x = {path[-1, 0]:.1f} mm")
for axis in axes.ravel():
    axis.plot(*straight.T, "--", color="0.6", linewidth=1, label="triangles without a hole")
axes[0, 0].legend(fontsize=7, loc="lower right")
figure.savefig(folder / "paths.png", dpi=120)
print(folder / "paths.png")
