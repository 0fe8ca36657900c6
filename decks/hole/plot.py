#!/usr/bin/python3
"""strain.png: strain beside the hole while it moves under the lattice, and errors of all runs; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
here = Path(__file__).resolve()
sys.path.insert(0, str(here.parent))
sys.path.insert(0, str(here.parents[2] / "meshes"))

import numpy as np  # noqa: E402
from exact import STRESS, YOUNG, Ellipse  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

SPACING, HORIZON = 0.25e-3, 0.75e-3  # of the deck
HOLES = {"circle_Adaptive": (5.0, 5.0, 0.0), "circle_Intersection": (5.0, 5.0, 0.0), "ellipse_flat": (2.5, 5.0, 0.0),
         "ellipse_2": (5.0, 2.5, 30.0), "ellipse_4": (5.0, 1.25, 0.0)}  # half axes in mm, degrees
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


class Run:
    def __init__(self, name, step):
        a, b, degrees = HOLES[name]
        self.move = 0.25 * SPACING * step
        self.hole = Ellipse((self.move, 0.0), a * 1e-3, b * 1e-3, np.radians(degrees))
        results = Results(folder / f"{name}_{step}.h5")
        self.x, self.y = results.x[:, 0], results.x[:, 1]
        self.u = results.field("Displacement", 1)[:, :2]
        self.strain = results.field("Strain", 1)[:, 4] * YOUNG / STRESS  # yy over the far one
        axes = np.exp(-1j * np.radians(degrees)) * (self.x - self.move + 1j * self.y)
        self.level = np.hypot(axes.real / a, axes.imag / b) * 1e3  # 1 on the rim
        # One horizon away from the rim, along the ray from the centre at least.
        self.isClear = np.abs(axes) * (1 - 1 / self.level) > HORIZON

    def exact(self):
        return self.hole.strain(self.x, self.y)[1] * YOUNG / STRESS

    def displacement_error(self):
        """Largest outside the hole, in parts of the largest displacement."""
        exact = np.column_stack(self.hole.displacement(self.x, self.y))
        out = self.level > 1
        return np.max(np.linalg.norm((self.u - exact)[out], axis=1)) / np.max(np.linalg.norm(exact[out], axis=1))

    def ligament(self):
        """Distances from the centre along +x, and strains there: means of the rows above and below."""
        rows = [(np.abs(self.y - side * 0.5 * SPACING) < 0.1 * SPACING) & (self.x > self.move) for side in (-1, 1)]
        order = [np.flatnonzero(row)[np.argsort(self.x[row])] for row in rows]
        return self.x[order[0]] - self.move, 0.5 * (self.strain[order[0]] + self.strain[order[1]])

    def at_rim(self, radius):
        """Strain at the rim of a circle, from (R/r)^2 and (R/r)^4, which the solution has, fitted one to seven horizons away."""
        r, strain = self.ligament()
        near = (r > radius + HORIZON) & (r < radius + 7 * HORIZON)
        return np.polyval(np.polyfit((radius / r[near])**2, strain[near], 2), 1.0)


figure, (of_ligament, of_moves) = figures.plt.subplots(1, 2, figsize=(12, 4.2), constrained_layout=True)
for rule, color, label in (("Adaptive", "tab:blue", "shares"), ("Intersection", "tab:orange", "whole cells and bonds")):
    rims, peaks = [], []
    for step in range(5):
        run = Run(f"circle_{rule}", step)
        r, strain = run.ligament()
        shown = (r > 4.7e-3) & (r < 10e-3)
        of_ligament.plot(r[shown] * 1e3, strain[shown], "o", color=color, fillstyle="none", markersize=4,
                         label=label if step == 0 else None)
        rims.append(run.at_rim(5e-3))
        peaks.append(np.max(run.strain))
    moves = np.arange(5) / 4
    of_moves.plot(moves, rims, "o-", color=color, label=f"{label}: at the rim")
    of_moves.plot(moves, peaks, "s--", color=color, fillstyle="none", label=f"{label}: largest of all points")
    print(f"{rule}: strain at the rim", np.round(rims, 3), f"range {np.ptp(rims) / np.mean(rims):.2%}; largest",
          np.round(peaks, 3), f"range {np.ptp(peaks) / np.mean(peaks):.2%}")
r = np.linspace(5e-3, 10e-3, 200)
of_ligament.plot(r * 1e3, Ellipse((0, 0), 5e-3, 5e-3).strain(r, 0 * r)[1] * YOUNG / STRESS, color="0.4", label="Kirsch")
of_moves.axhline(3.0, color="0.4")
of_ligament.set_xlabel("distance from the centre (mm)")
of_ligament.set_ylabel("strain along the load over that far away")
of_moves.set_xlabel("move of the hole (spacings)")
of_moves.set_ylabel("strain along the load over that far away")
for axis in (of_ligament, of_moves):
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)
figure.savefig(folder / "strain.png", dpi=150)
print(folder / "strain.png")
for name in HOLES:
    runs = [Run(name, step) for step in range(5)]
    clear = [np.max(np.abs(run.strain - run.exact())[run.isClear]) / np.max(run.exact()[run.isClear]) for run in runs]
    largest = [np.max(run.strain) for run in runs]
    print(f"{name}: displacement off by {max(run.displacement_error() for run in runs):.2%}; strain one horizon away by "
          f"{max(clear):.2%} of its largest there; largest strain {np.mean(largest):.3f}, range {np.ptp(largest) / np.mean(largest):.2%}")
