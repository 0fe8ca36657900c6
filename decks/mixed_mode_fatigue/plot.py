#!/usr/bin/python3
"""kinks.png: paths of the cracks, and their angles over those of the theory; and the angles as a table;
plot.py [RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from cases import ANGLES, kink  # noqa: E402
from pdplot_lib import figures  # noqa: E402

HORIZON = 1.5  # mm
MESHES = (1, 2, 3)
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def tips(angle, mesh):
    """Of a run, [steps, 2] mm."""
    with open(folder / f"crack_{angle}_{mesh}.csv") as file:
        rows = list(csv.DictReader(file))
    return np.array([[float(row["Crack_TipX"]), float(row["Crack_TipY"])] for row in rows]) * 1e3


def angle_of(path):
    """Degrees, of the way from the old tip to where the crack is two to three horizons from it."""
    distance = np.hypot(*path.T)
    far = path[(distance > 2 * HORIZON) & (distance < 3 * HORIZON)]
    return np.degrees(np.arctan2(*far.mean(axis=0)[::-1]))


figure, axes = figures.plt.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
for number, angle in enumerate(ANGLES):
    theory = kink(angle)
    found = []
    for mesh in MESHES:
        path = tips(angle, mesh)
        found.append(angle_of(path))
        axes[0].plot(*path.T, color=f"C{number}", linewidth=1, label=f"{angle}°" if mesh == 1 else None)
    ends = np.array([0, 3.2]) * HORIZON
    way = np.radians(theory)
    axes[0].plot(ends * np.cos(way), ends * np.sin(way), "--", color=f"C{number}", linewidth=0.8)
    axes[1].plot(np.full(3, -theory), -np.array(found), ".", color=f"C{number}", markersize=4)
    axes[1].plot(-theory, -np.mean(found), "o", color=f"C{number}", fillstyle="none")
    print(f"{angle:3} degrees: kink {-np.mean(found):5.1f} ± {np.std(found, ddof=1):4.1f}, theory {-theory:4.1f}; "
          f"meshes {np.round(found, 1)}")
axes[0].set_aspect("equal")
axes[0].set_xlabel("x (mm)")
axes[0].set_ylabel("y (mm)")
axes[0].legend(title="crack and load")
axes[1].plot([0, 62], [0, 62], color="0.6", label="maximum tangential stress")
axes[1].set_xlabel("kink, theory (degrees)")
axes[1].set_ylabel("kink, measured (degrees)")
axes[1].legend()
for axis in axes:
    axis.grid(alpha=0.3)
figure.savefig(folder / "kinks.png", dpi=120)
print(folder / "kinks.png")
