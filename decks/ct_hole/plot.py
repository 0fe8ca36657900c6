#!/usr/bin/python3
"""cracks.png: paths of the runs beside their holes, over those of finite elements, and lengths over cycles; and what the
README states of them; plot.py [RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402

RADIUS, RATE = 3.5, 3.5e-8  # mm; m/cycle of the deck's law at its range of K
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
runs = sorted(folder.glob("hole_*_*_*.csv"))
figure, axes = figures.plt.subplots(1, 2, figsize=(11, 4.4), constrained_layout=True)
for number, file in enumerate(runs):
    _, x, y, spacing = file.stem.split("_")
    hole = np.array([float(x), float(y)])
    with open(file) as lines:
        rows = list(csv.DictReader(lines))[1:]
    tips = np.array([[float(row["Crack_TipX"]), float(row["Crack_TipY"])] for row in rows]) * 1e3
    cycles, length = (np.array([float(row[key]) for row in rows]) for key in ("time", "Crack_Length"))
    theory = np.loadtxt(folder / f"lefm_{x}_{y}.csv", delimiter=",", skiprows=1)
    color = f"C{number}"
    label = f"hole at ({x}, {y}) mm, horizon {3 * float(spacing):g} mm"
    axes[0].add_patch(figures.plt.Circle(hole, RADIUS, fill=False, color=color, linewidth=0.8))
    axes[0].plot(*tips.T, color=color, linewidth=1, label=label)
    axes[0].plot(*theory.T, "--", color=color, linewidth=0.8)
    axes[1].plot(cycles * 1e-3, length * 1e3, color=color, label=label)
    ahead = np.maximum.accumulate(tips[:, 0])
    distance = np.hypot(*(tips - hole).T) - RADIUS
    away = (length > 8.5e-3) & (distance > 3.0)
    slope = np.polyfit(cycles[away], length[away], 1)
    off = 1e3 * np.abs(np.polyval(slope, cycles[away]) - length[away]).max()
    shown = theory[(theory[:, 0] > 8.5) & (theory[:, 0] < ahead.max())]
    first = np.concatenate([[True], np.diff(ahead) > 0])
    apart = np.interp(shown[:, 0], ahead[first], tips[first, 1]) - shown[:, 1]
    print(f"{label}: last tip {tips[-1].round(2)}, {distance[-1]:.2f} mm from the rim, nearest {distance.min():.2f}; "
          f"da/dN {slope[0]:.3g} m/cycle to 3 mm from the rim, off the straight line by {off:.2f} mm at most; "
          "y less that of finite elements: "
          + " ".join(f"{a:.1f}:{b:+.2f}" for a, b in zip(shown[::2, 0], apart[::2])))
axes[0].set_xlim(7, 22)
axes[0].set_ylim(-1, 11)
axes[0].set_aspect("equal")
axes[0].set_xlabel("x (mm)")
axes[0].set_ylabel("y (mm)")
n = np.array([0.0, 350.0])
axes[1].plot(n, 7.5 + n * 1e3 * RATE * 1e3, color="0.6", label="law of the deck")
axes[1].set_xlabel("cycles (10³)")
axes[1].set_ylabel("crack length from the load line (mm)")
axes[1].set_ylim(7, 20)
for axis in axes:
    axis.grid(alpha=0.3)
    axis.legend(fontsize=7)
figure.savefig(folder / "cracks.png", dpi=120)
print(folder / "cracks.png")
