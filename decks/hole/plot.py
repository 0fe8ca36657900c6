#!/usr/bin/python3
"""Pictures of this scene, and errors of all runs; plot.py [RESULTS]
  strain.png       strain beside the hole while it moves under the lattice
  resolution.png   the strain at its rim by the distance of points, and by the time that a run takes
  two_holes.png    strain along both axes of two holes
"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
here = Path(__file__).resolve()
sys.path.insert(0, str(here.parent))
sys.path.insert(0, str(here.parents[2] / "meshes"))

import numpy as np  # noqa: E402
from exact import STRESS, YOUNG, Ellipse, plate_with  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402
from rim_reading import strain_at_rim  # noqa: E402

SPACING = 0.25  # mm, where no other is said; the horizon is three of them
# x and y of the centre where the hole has not moved, half axes in mm, degrees
HOLES = {"circle": (0, 0, 5.0, 5.0, 0), "ellipse_flat": (0, 0, 2.5, 5.0, 0), "ellipse_2": (0, 0, 5.0, 2.5, 30),
         "ellipse_4": (0, 0, 5.0, 1.25, 0), "two": (-4.5, 0, 3.0, 3.0, 0, 4.5, 0, 3.0, 3.0, 0)}
RULES = {"Adaptive": ("tab:blue", "shares"), "Intersection": ("tab:orange", "whole cells and bonds")}
SPACINGS = (0.5, 0.25, 0.125, 0.0625)
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
times = {name: float(seconds) for name, seconds in (line.split() for line in (folder / "times.txt").read_text().splitlines())}


class Run:
    def __init__(self, shape, name, spacing=SPACING):
        step = int(name[-1])
        self.name, self.spacing, self.horizon = name, spacing * 1e-3, 3e-3 * spacing
        self.move = 0.25 * self.spacing * step
        holes = np.reshape(np.array(HOLES[shape], float), (-1, 5))
        holes[:, 0] += self.move * 1e3
        self.holes = holes
        self.plate = plate_with(holes.ravel())[0]
        results = Results(folder / f"{name}.h5")
        self.x, self.y = results.x[:, 0], results.x[:, 1]
        self.u = results.field("Displacement", 1)[:, :2]
        self.strain = results.field("Strain", 1)[:, 4] * YOUNG / STRESS  # yy over the far one
        self.isOut, self.isClear = np.full(len(self.x), True), np.full(len(self.x), True)
        for x, y, a, b, degrees in holes:
            axes = np.exp(-1j * np.radians(degrees)) * (self.x - x * 1e-3 + 1j * (self.y - y * 1e-3))
            level = np.hypot(axes.real / a, axes.imag / b) * 1e3  # 1 on the rim
            self.isOut &= level > 1
            # One horizon away from the rim, along the ray from the centre at least.
            self.isClear &= np.abs(axes) * (1 - 1 / level) > self.horizon

    def exact(self, x=None, y=None):
        return self.plate.strain(self.x if x is None else x, self.y if y is None else y)[1] * YOUNG / STRESS

    def displacement_error(self):
        """Largest outside the hole, in parts of the largest displacement."""
        exact = np.column_stack(self.plate.displacement(self.x, self.y))
        return (np.max(np.linalg.norm((self.u - exact)[self.isOut], axis=1)) /
                np.max(np.linalg.norm(exact[self.isOut], axis=1)))

    def strain_error(self):
        return np.max(np.abs(self.strain - self.exact())[self.isClear]) / np.max(self.exact()[self.isClear])

    def along(self, axis):
        """Places along x (0) or y (1) through the middle, m, and strains there: means of the two lines of points beside it."""
        along, across = (self.x, self.y) if axis == 0 else (self.y, self.x)
        middle = 0.0 if axis == 0 else self.move
        distances = np.unique(np.round(np.abs(across - middle), 12))
        nearest = distances[:1] if distances[0] < 1e-9 else distances[:2 if distances[1] - distances[0] > 1e-9 else 1]
        places = np.unique(np.round(along, 12))
        sums, weights = np.zeros(len(places)), np.zeros(len(places))
        for distance in nearest:
            ids = np.flatnonzero(np.abs(np.abs(across - middle) - distance) < 1e-9)
            at = np.searchsorted(places, np.round(along[ids], 12))
            weight = 1.0 if len(nearest) == 1 else nearest[1 if distance == nearest[0] else 0]  # linear in between
            np.add.at(sums, at, weight * self.strain[ids])
            np.add.at(weights, at, weight)
        isThere = weights > 0
        return places[isThere], sums[isThere] / weights[isThere]

    def peak_at_rim(self, which=0):
        """Largest strain along the load at the rim of a hole, the exact one, and how far apart their places are, m, by the
        nearest of the places that have the largest."""
        ellipses = [Ellipse((x * 1e-3, y * 1e-3), a * 1e-3, b * 1e-3, np.radians(angle)) for x, y, a, b, angle in self.holes]
        rim, _, found = strain_at_rim(ellipses, which, self.x, self.y, self.u, self.horizon)
        outside = rim + 1e-9 * (rim - ellipses[which].center)
        exact, found = self.exact(outside.real, outside.imag), found * YOUNG / STRESS
        largest = exact > (1 - 1e-6) * np.max(exact)
        return np.max(found), np.max(exact), np.min(np.abs(rim[np.argmax(found)] - rim[largest]))

    def at_rim(self, radius):
        """Strain at the right end of a circle, from (R/r)^2 and (R/r)^4, which the solution has, fitted one to seven
        horizons away, or to three radii."""
        x, strain = self.along(0)
        r = x - self.move
        near = (r > radius + self.horizon) & (r < min(radius + 7 * self.horizon, 3 * radius))
        return np.polyval(np.polyfit((radius / r[near])**2, strain[near], 2), 1.0)


circles = {(rule, spacing): [Run("circle", f"circle_{rule}_{spacing}_{step}", spacing) for step in range(5)]
           for rule in RULES for spacing in SPACINGS}
figure, (of_ligament, of_moves) = figures.plt.subplots(1, 2, figsize=(12, 4.2), constrained_layout=True)
for rule, (color, label) in RULES.items():
    runs = circles[rule, SPACING]
    for run in runs:
        x, strain = run.along(0)
        r = x - run.move
        shown = (r > 4.7e-3) & (r < 10e-3)
        of_ligament.plot(r[shown] * 1e3, strain[shown], "o", color=color, fillstyle="none", markersize=4,
                         label=label if run is runs[0] else None)
    rims, peaks = [run.at_rim(5e-3) for run in runs], [np.max(run.strain) for run in runs]
    moves = np.arange(5) / 4
    of_moves.plot(moves, rims, "o-", color=color, label=f"{label}: at the rim")
    of_moves.plot(moves, peaks, "s--", color=color, fillstyle="none", label=f"{label}: largest of all points")
    places = [np.argmax(run.strain) for run in runs]
    off = [np.hypot(run.x[p] - run.move, run.y[p]) - 5e-3 for run, p in zip(runs, places)]
    print(f"{rule}: strain at the rim", np.round(rims, 3), f"range {np.ptp(rims) / np.mean(rims):.2%}; largest",
          np.round(peaks, 3), f"range {np.ptp(peaks) / np.mean(peaks):.2%}, mm from the rim", np.round(np.array(off) * 1e3, 2))
r = np.linspace(5e-3, 10e-3, 200)
of_ligament.plot(r * 1e3, Ellipse((0, 0), 5e-3, 5e-3).strain(r, 0 * r)[1] * YOUNG / STRESS, color="0.4", label="Kirsch")
of_moves.axhline(3.0, color="0.4")
of_ligament.set_xlabel("distance from the centre (mm)")
of_ligament.set_ylabel("strain along the load over that far away")
of_moves.set_xlabel("move of the hole (spacings)")
of_moves.set_ylabel("strain along the load over that far away")
figures.save_curves(figure, folder / "strain.png", (of_ligament, of_moves))

figure, (of_spacing, of_time) = figures.plt.subplots(1, 2, figsize=(12, 4.2), constrained_layout=True)
for rule, (color, label) in RULES.items():
    rims = np.array([[run.at_rim(5e-3) for run in circles[rule, spacing]] for spacing in SPACINGS])
    worst = 100 * np.max(np.abs(rims / 3 - 1), axis=1)
    ranges = 100 * np.ptp(rims, axis=1) / 3
    seconds = np.array([np.median([times[run.name] for run in circles[rule, spacing]]) for spacing in SPACINGS])
    of_spacing.loglog(SPACINGS, worst, "o-", color=color, label=f"{label}: worst of five places")
    of_spacing.loglog(SPACINGS, ranges, "s--", color=color, fillstyle="none", label=f"{label}: range over them")
    of_time.loglog(seconds, worst, "o-", color=color, label=f"{label}: worst of five places")
    fields = [np.max([run.displacement_error() for run in circles[rule, spacing]]) for spacing in SPACINGS]
    clear = [np.max([run.strain_error() for run in circles[rule, spacing]]) for spacing in SPACINGS]
    print(f"{rule}, {SPACINGS} mm: rim off by", np.round(worst, 2), "%, range", np.round(ranges, 2), "%, displacement off by",
          np.round(100 * np.array(fields), 2), "%, strain one horizon away by", np.round(100 * np.array(clear), 2),
          "%; s of the processor", np.round(seconds, 2), "; order of the displacement",
          np.round(np.log2(np.array(fields)[:-1] / fields[1:]), 2))
of_spacing.set_xticks(SPACINGS, [f"{spacing:g}" for spacing in SPACINGS])
of_time.set_xticks((0.1, 0.3, 1, 3, 10), ("0.1", "0.3", "1", "3", "10"))
for axis, ticks in ((of_spacing, (0.5, 1, 2, 5, 10, 20)), (of_time, (2, 3, 5, 10))):
    axis.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    axis.minorticks_off()
of_spacing.set_ylim(0.1)
of_spacing.set_xlabel("distance of points (mm), radius 5 mm")
of_time.set_xlabel("processor time of a run (s)")
of_spacing.set_ylabel("error of the strain at the rim (%)")
of_time.set_ylabel("error of the strain at the rim (%)")
figures.save_curves(figure, folder / "resolution.png", (of_spacing, of_time))

figure, axes = figures.plt.subplots(1, 2, figsize=(12, 4.2), constrained_layout=True)
for step in range(5):
    run = Run("two", f"two_{step}")
    for axis, of_axis in enumerate(axes):
        place, strain = run.along(axis)
        inner = np.abs(place) < 18e-3  # beside the layer whose displacements are given
        place, strain = place[inner], strain[inner]
        of_axis.plot((place - (run.move if axis == 0 else 0.0)) * 1e3, strain, "o", color="tab:blue", fillstyle="none", markersize=3,
                     label="shares, five places" if step == 0 else None)
for axis, of_axis in enumerate(axes):
    place = np.linspace(-18e-3, 18e-3, 1500)
    x, y = (place + run.move, 0 * place) if axis == 0 else (0 * place + run.move, place)
    strain = run.exact(x, y)
    isIn = (axis == 0) & (np.abs(np.abs(place) - 4.5e-3) < 3e-3)
    of_axis.plot(place * 1e3, np.where(isIn, np.nan, strain), color="0.4", label="series")
    of_axis.set_xlabel(("x (mm), through both centres", "y (mm), between the holes")[axis])
    of_axis.set_ylabel("strain along the load over that far away")
figures.save_curves(figure, folder / "two_holes.png", axes)
finer = {"ellipse_2 with points 0.125 mm apart": ("ellipse_2", "ellipse_fine"), "two with points 0.125 mm apart": ("two", "two_fine")}
for name in (*HOLES, *finer):
    shape, files = finer.get(name, (name, name))
    spacing = 0.125 if name in finer else SPACING
    runs = circles["Adaptive", SPACING] if name == "circle" else [Run(shape, f"{files}_{step}", spacing) for step in range(5)]
    largest = [np.max(run.strain) for run in runs]
    print(f"{name}: displacement off by {max(run.displacement_error() for run in runs):.2%}; strain one horizon away by "
          f"{max(run.strain_error() for run in runs):.2%} of its largest there; largest strain {np.mean(largest):.3f}, range "
          f"{np.ptp(largest) / np.mean(largest):.2%}")
    rims, exact, off = np.array([run.peak_at_rim() for run in runs]).T
    print(f"  largest at the rim {np.min(rims):.3f} to {np.max(rims):.3f}, range {np.ptp(rims) / np.mean(rims):.2%}; exact "
          f"{exact[0]:.3f}, its place off by {1e3 * np.max(off):.2f} mm at most")
rims = [run.peak_at_rim()[0] for run in circles["Intersection", SPACING]]
print(f"circle, whole cells and bonds, by the same: {np.min(rims):.3f} to {np.max(rims):.3f}, range {np.ptp(rims) / np.mean(rims):.2%}")
