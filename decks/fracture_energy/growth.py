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
FIRST = {"strip": 12e-3, "notch": 8e-3, "beam": 14e-3, "pressed": 14e-3}
UNIT = {"strip": 0.7807e-6, "notch": 1.4e-6, "beam": 5.645e-6, "pressed": 5.645e-6}
# Bodies with a load beside the displacement of their sides: the same body without it.
FREE = {"pressed": "beam"}
# Lengths beyond the first, in horizons, whose compliance is measured.
CUTS = (-1.0, 0.5, 2.0, 3.5, 5.0)


def history(path):
    with open(path) as file:
        rows = list(csv.reader(file))
    return dict(zip(rows[0], np.array(rows[1:], float).T))


class Compliance:
    """Load of a body by the displacement u of either side and the length of a plane crack: stiffness times u and, where another load
    acts, what that adds. Cubics in the length."""

    def __init__(self, folder, body, lattice):
        grown = np.array(CUTS) * HORIZON

        def cubic(values):
            return np.polynomial.Polynomial.fit(grown, values, 3)

        loads, free = (np.array([abs(history(folder / f"{name}_{lattice}_cut_{cut}.csv")["LoadY"][-1])
                                 for cut in range(len(CUTS))]) for name in (body, FREE.get(body, body)))
        self.first = FIRST[body]
        self.stiffness, self.added = cubic(free / UNIT[body]), cubic(loads - free)
        self._lengths = np.linspace(grown[0], grown[-1], 2000)

    def grown(self, load, displacement):
        """Growth, m, of the plane crack that bears `load`, which falls with it."""
        bears = self.stiffness(self._lengths) * displacement + self.added(self._lengths)
        return np.interp(-load, -bears, self._lengths)

    def release(self, grown, displacement):
        """G = -dU/da at fixed grips, J/m2. Without another load U = k u^2, load times displacement of both sides over two. Another
        one whose load at the sides is p adds 2 p u, and G is the square of one intensity: -k' (u + p'/k')^2."""
        slope = self.stiffness.deriv()(grown)
        return -slope * (displacement + self.added.deriv()(grown) / slope) ** 2 / THICKNESS


class Growth:
    """Of one run: `grown` (m) and `energy` (G/G_c) by load step, `angle` (degrees) to the first crack."""

    def __init__(self, folder, body, lattice, model):
        compliance = Compliance(folder, body, lattice)
        name = folder / f"{body}_{lattice}_{model}"
        values = history(f"{name}.csv")
        displacement = UNIT[body] * values["time"][1:]  # the first row is before any equilibrium
        self.grown = np.array([compliance.grown(*pair) for pair in zip(np.abs(values["LoadY"][1:]), displacement)])
        # What drives a load step is the energy at the length before it.
        before = np.concatenate([self.grown[:1], self.grown[:-1]])
        self.energy = compliance.release(before, displacement) / FRACTURE_ENERGY
        self.angle = self.direction(Results(name), compliance.first)

    def needed(self, horizons):
        """Largest G/G_c of the load steps until the crack has grown so far; NaN where it has not."""
        there = np.flatnonzero(self.grown >= horizons * HORIZON)
        return self.energy[: there[0] + 1].max() if len(there) else np.nan

    @staticmethod
    def direction(results, first):
        """Degrees of the line through what has broken, between half a horizon and four from the old tip."""
        x = results.x[:, :2]
        grown = results.field("Damage", results.steps[-1]) - results.field("Damage", results.steps[0])
        ahead = x[:, 0] - first
        weights = np.where((ahead > 0.5 * HORIZON) & (ahead < 4 * HORIZON) & (grown > 0.1), grown, 0.0)
        if np.count_nonzero(weights) < 5:
            return np.nan
        return np.degrees(np.arctan(np.polyfit(ahead, x[:, 1], 1, w=np.sqrt(weights))[0]))
