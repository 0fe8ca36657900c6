#!/usr/bin/python3
"""Time steps just below and just above the true limit: Verlet and forward Euler."""
import re
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

YOUNG, DENSITY, DIFFUSIVITY = 200e9, 8000.0, 1e-9
SPEED = np.sqrt(YOUNG / DENSITY)
SPACING = 1e-3


def bonds_of(points, horizon):
    """Pairs within the horizon, each volume whole: from, to, bond vectors, lengths."""
    xi = points[None, :, :] - points[:, None, :]
    length = np.linalg.norm(xi, axis=2)
    i, j = np.nonzero((length > 0.0) & (length < horizon * (1.0 + 1e-9)))
    return i, j, xi[i, j], length[i, j]


def largest_frequency(points, volume, horizon, constant):
    """Of the bond-based body: the eigenvalues of its dense stiffness matrix over its density."""
    i, j, xi, length = bonds_of(points, horizon)
    dimension = 3 if np.ptp(points[:, 2]) > 0.0 else 2
    blocks = constant * volume / length[:, None, None] ** 3 * (xi[:, :dimension, None] * xi[:, None, :dimension])
    n = len(points)
    stiffness = np.zeros((n, dimension, n, dimension))
    for a in range(dimension):
        for b in range(dimension):
            np.add.at(stiffness[:, a, :, b], (i, i), blocks[:, a, b])
            np.add.at(stiffness[:, a, :, b], (i, j), -blocks[:, a, b])
    return np.sqrt(np.linalg.eigvalsh(stiffness.reshape(n * dimension, -1))[-1] / DENSITY)


def largest_rate(points, volume, horizon, constant):
    """Of bond-based diffusion: the largest eigenvalue of its dense matrix."""
    i, j, _, length = bonds_of(points, horizon)
    n = len(points)
    matrix = np.zeros((n, n))
    np.add.at(matrix, (i, i), constant * volume / length**2)
    np.add.at(matrix, (i, j), -constant * volume / length**2)
    return np.linalg.eigvalsh(matrix)[-1]


class VerletTimeStep(SceneTest):
    """A body at rest gets velocities that hold all frequencies. Of one mode of frequency w, velocity Verlet conserves
    v^2 + w^2 u^2 (1 - (w dt)^2 / 4); started at u = 0 its energy so never exceeds E0 / (1 - (dt/limit)^2). Above the
    limit the highest mode grows by mu each step, mu + 1/mu = (w dt)^2 - 2."""

    def plate(self, size, ratio=3.0):
        """Points of a square and the deck's material, and the limit of the finite plate from its dense matrix."""
        thickness, horizon = 2e-3, ratio * SPACING
        points = lattice([size * SPACING] * 2, SPACING)
        volume = SPACING**2 * thickness
        self.write_mesh(points, volume)
        constant = 9.0 * YOUNG / (np.pi * thickness * horizon**3)
        deck = plate_deck(horizon, thickness, {"Young's Modulus": YOUNG, "Poisson's Ratio": 1 / 3, "Density": DENSITY,
                                               "Volume Correction": "None"})
        return deck, 2.0 / largest_frequency(points, volume, horizon, constant)

    def solid(self, size, ratio=3.0):
        horizon = ratio * SPACING
        points = lattice([size * SPACING] * 3, SPACING)
        self.write_mesh(points, SPACING**3)
        deck = plate_deck(horizon, 1.0, {"Young's Modulus": YOUNG, "Poisson's Ratio": 0.25, "Density": DENSITY,
                                         "Volume Correction": "None"})
        del deck["Discretization"]["Thickness"]
        for key in ("Plane Stress", "Thickness"):
            del deck["Materials"]["Steel"][key]
        return deck, 2.0 / largest_frequency(points, SPACING**3, horizon, 12.0 * YOUNG / (np.pi * horizon**4))

    def shake(self, deck, step, n_steps, **options):
        kick = "1e-6*sin(1e6*x*(1 + 0.3*{0}) + 2.7e6*y + 3.9e6*z + {0})"
        deck["Boundary Conditions"] = {"All Node Set": {"Expression": "x > -1"}}
        for number, axis in enumerate("xyz" if "Plane Stress" not in deck["Materials"]["Steel"] else "xy"):
            deck["Boundary Conditions"]["Kick " + axis] = {"Type": "Initial Velocity", "Node Set": "All Node Set",
                                                           "Coordinate": axis, "Value": kick.format(number)}
        deck["Solver"] = {"Final Time": float(n_steps * step), "Verlet": {"Fixed dt": float(step), **options}}
        deck["Compute Class Parameters"] = {
            name: {"Compute Class": name, "Output Label": name} for name in ("Strain_Energy", "Global_Kinetic_Energy")}
        deck["Output"].update({"Output Variables": ["Strain_Energy", "Global_Kinetic_Energy"], "Output Frequency": -1})
        return self.run_deck(deck)

    def energies(self, result):
        self.assertEqual(result.code, 0, result.text)
        history = result.history()
        return history["Strain_Energy"] + history["Global_Kinetic_Energy"]

    def bracket(self, deck, limit):
        energy = self.energies(self.shake(deck, 0.99 * limit, 400))
        self.assertLess(np.max(energy), energy[0] / (1.0 - 0.99**2))
        self.assertGreater(np.max(energy), 1.2 * energy[0])  # the step is felt: it is near the limit

        refused = self.shake(deck, 1.005 * limit, 400)
        self.assertEqual(refused.code, 3)
        self.assertRegex(refused.text, "above the critical one.*Allow Unstable Step")

        # mu = 1.33 a step: in 100 steps any share of the highest mode above 1e-6 makes more than 1e12 of the energy.
        blown = self.shake(deck, 1.01 * limit, 100, **{"Allow Unstable Step": True})
        if blown.code == 0:
            energy = self.energies(blown)
            self.assertGreater(np.max(energy), 1e12 * energy[0])
        else:
            self.assertEqual(blown.code, 3, blown.text)

    def test_plate_is_stable_just_below_and_blows_up_just_above_the_limit(self):
        deck, limit = self.plate(20)
        self.bracket(deck, limit)

    def test_solid_is_stable_just_below_and_blows_up_just_above_the_limit(self):
        deck, limit = self.solid(7)
        self.bracket(deck, limit)

    def critical_step(self, deck):
        result = self.shake(deck, 0.1 * SPACING / SPEED, 1)
        self.assertEqual(result.code, 0, result.text)
        return float(re.search(r"critical time step (\S+) s", "\n".join(result.report["solver"])).group(1))

    def test_own_estimate_is_the_true_limit_from_below(self):
        deck, limit = self.plate(20)
        found = self.critical_step(deck)
        self.assertLessEqual(found, limit)
        self.assertGreater(found, 0.998 * limit)

    def test_limits_of_wide_plates_are_those_of_the_lattice(self):
        # 2 / omega_max of the infinite square lattice, constant micromodulus, whole volumes, in spacings / wave speed:
        # maxima of the acoustic tensor over wave vectors. Free edges only lower frequencies: by 0.1 % at 60 points.
        for ratio, expected in [(3.0, 1.864), (3.015, 1.878), (4.0, 2.524)]:
            deck, _ = self.plate(12, ratio)
            self.write_mesh(lattice([60 * SPACING] * 2, SPACING), SPACING**2 * 2e-3)
            found = self.critical_step(deck) * SPEED / SPACING
            self.assertAlmostEqual(found / expected, 1.0, delta=4e-3, msg=f"horizon/spacing {ratio}")


class EulerTimeStep(SceneTest):
    """Forward Euler of diffusion: modes of rate r are multiplied by 1 - r dt each step."""

    def setUp(self):
        super().setUp()
        self.horizon, thickness = 3.015 * SPACING, 2e-3
        points, volume = lattice([20 * SPACING] * 2, SPACING), SPACING**2 * thickness
        self.write_mesh(points, volume)
        self.limit = 2.0 / largest_rate(points, volume, self.horizon,
                                        4.0 * DIFFUSIVITY / (np.pi * thickness * self.horizon**2))
        self.deck = plate_deck(
            self.horizon, thickness, {"Diffusivity": DIFFUSIVITY, "Volume Correction": "None"},
            conditions={"All Node Set": {"Expression": "x > -1"},
                        "Start": {"Type": "Initial Concentration", "Node Set": "All Node Set",
                                  "Value": "1 + 0.5*sin(1e6*x + 2.7e6*y)"}},
            output={"Output Variables": ["Concentration"], "Output Frequency": 1})

    def spread(self, step, n_steps, **options):
        self.deck["Solver"] = {"Final Time": float(n_steps * step),
                               "Diffusion": {"Method": "Euler", "Time Step": float(step), **options}}
        return self.run_deck(self.deck)

    def test_decays_just_below_and_is_refused_and_blows_up_just_above_the_limit(self):
        below = self.spread(0.995 * self.limit, 1000)
        self.assertEqual(below.code, 0, below.text)
        # The fastest mode shrinks by 1 - 2 * 0.995 = -0.99 a step, to 4e-5; the slowest, D (pi/L)^2 t = 29, vanishes;
        # the mean stays.
        start, end = below.field("Concentration", 0), below.field("Concentration")
        self.assertLess(np.ptp(end), 1e-3 * np.ptp(start))
        self.assertAlmostEqual(np.mean(end), np.mean(start), delta=1e-12)

        refused = self.spread(1.005 * self.limit, 1000)
        self.assertEqual(refused.code, 3)
        self.assertRegex(refused.text, "above the stability limit.*of forward Euler.*Allow Unstable Step")

        blown = self.spread(1.02 * self.limit, 1000, **{"Allow Unstable Step": True})  # 1.04^1000 = 1e17
        if blown.code == 0:
            self.assertGreater(np.ptp(blown.field("Concentration")), 1e6)
        else:
            self.assertEqual(blown.code, 3, blown.text)


if __name__ == "__main__":
    unittest.main()
