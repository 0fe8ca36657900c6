"""Energy and direction of a growing crack, from what runs of this scene have left."""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

HORIZON, THICKNESS, FRACTURE_ENERGY = 1.5e-3, 1e-3, 8.0  # m, m, J/m2
# First length of the crack, and displacement of either side at the time 1, m.
FIRST = {"strip": 12e-3, "beam": 14e-3, "notch": 8e-3}
UNIT = {"strip": 0.7807e-6, "beam": 5.645e-6, "notch": 1.4e-6}
# Lengths beyond the first, in horizons, whose compliance is measured.
CUTS = (-1.0, 0.5, 2.0, 3.5, 5.0)


def history(path):
    with open(path) as file:
        rows = list(csv.reader(file))
    return dict(zip(rows[0], np.array(rows[1:], float).T))


class Compliance:
    """Stiffness of a body, load over displacement of either side, by the length of a plane crack: a cubic in it."""

    def __init__(self, folder, body, lattice):
        self.first = FIRST[body]
        grown = np.array(CUTS) * HORIZON
        stiffness = []
        for cut in range(len(CUTS)):
            values = history(folder / f"{body}_{lattice}_cut_{cut}.csv")
            stiffness.append(abs(values["LoadY"][-1]) / UNIT[body])
        self.stiffness = np.polynomial.Polynomial.fit(grown, stiffness, 3)
        self.slope = self.stiffness.deriv()
        lengths = np.linspace(grown[0], grown[-1], 2000)
        self._lengths, self._values = lengths, self.stiffness(lengths)

    def grown(self, stiffness):
        """Growth, m, of the plane crack of this stiffness, which falls with it."""
        return np.interp(-stiffness, -self._values, self._lengths)

    def release(self, grown, displacement):
        """G = -dU/da at fixed grips, J/m2: U = load x displacement of both sides over two."""
        return -self.slope(grown) * displacement**2 / THICKNESS


class Growth:
    """Of one run: `grown` (m) and `energy` (G/G_c) by load step, `angle` (degrees) to the first crack."""

    def __init__(self, folder, body, lattice, model):
        compliance = Compliance(folder, body, lattice)
        name = folder / f"{body}_{lattice}_{model}"
        values = history(f"{name}.csv")
        displacement = UNIT[body] * values["time"][1:]  # the first row is before any equilibrium
        self.grown = compliance.grown(np.abs(values["LoadY"][1:]) / displacement)
        # What drives a load step is the energy at the length before it.
        before = np.concatenate([self.grown[:1], self.grown[:-1]])
        self.energy = compliance.release(before, displacement) / FRACTURE_ENERGY
        self.angle = self._angle(Results(name), compliance.first)

    def needed(self, horizons):
        """Largest G/G_c of the load steps until the crack has grown so far; NaN where it has not."""
        there = np.flatnonzero(self.grown >= horizons * HORIZON)
        return self.energy[: there[0] + 1].max() if len(there) else np.nan

    @staticmethod
    def _angle(results, first):
        """Slope of the line through what has broken, between half a horizon and four from the old tip."""
        x = results.x[:, :2]
        grown = results.field("Damage", results.steps[-1]) - results.field("Damage", results.steps[0])
        ahead = x[:, 0] - first
        weights = np.where((ahead > 0.5 * HORIZON) & (ahead < 4 * HORIZON) & (grown > 0.1), grown, 0.0)
        if np.count_nonzero(weights) < 5:
            return np.nan
        return np.degrees(np.arctan(np.polyfit(ahead, x[:, 1], 1, w=np.sqrt(weights))[0]))
