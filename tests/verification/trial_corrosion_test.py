#!/usr/bin/python3
"""Corrosion with the interface kernel k/|xi|^2 whose k a trial finds: plane fronts along the grid move as Faraday's law
says; what slants, or salt covers, shows what the kernel does not know."""
import os
import sys
import unittest
from math import cos, radians, sin

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, "../support"), here]
from corrosion_scene import SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402
from corrosion_test import SALTED_STEEL, stefan_number  # noqa: E402

SPEED = front_speed(STEEL)
SOLID, CAPACITY = STEEL["Solid Concentration"], STEEL["Solid Concentration"] - STEEL["Saturation Concentration"]


class TrialTest(CorrosionTest):
    def run_trial(self, dimension, solid, held, time, steps, horizon=4, rule="Deterministic", metal=STEEL,
                  kernel="Trial Calibration", **changes):
        deck = corrosion_deck(dimension, metal, solid, held, time, steps)
        deck["Materials"]["Metal"].update({"Interface Kernel": kernel, **changes})
        deck["Damage Models"]["Phases"]["Rule"] = rule
        deck["Blocks"]["Body"]["Horizon"] = horizon * SPACING
        result = self.solve(deck)
        self.check(result, metal)
        self.assertEqual(any("trial calibration" in line for line in result.report["solver"]),
                         kernel == "Trial Calibration")
        return result

    def speed_error(self, result, weights, per_layer, spacing, first, time):
        """Of the front's speed after output `first`, by the metal that `weights` of points have lost, which is
        `per_layer` of points a layer."""
        steps = result.steps()
        depth = []
        for step in steps:
            gone = SOLID - result.field("Concentration", step)
            gone[result.field("Damage", step) >= 1.0] = CAPACITY
            depth.append(np.sum(gone * weights) / CAPACITY * spacing / per_layer)
        times = np.array(steps) / steps[-1] * time
        return np.polyfit(times[first:], depth[first:], 1)[0] / SPEED - 1.0


class PlaneFronts(TrialTest):
    """Away from the sides of the body, where bonds are missing."""

    def plane(self, dimension, horizon, rule, width, length=45, time=200.0):
        self.make_lattice([length * SPACING] + [width * SPACING] * (dimension - 1), [-7 * SPACING, 0.0, 0.0])
        result = self.run_trial(dimension, "x > 0", f"x < {-2 * SPACING!r}", time, 10, horizon, rule)
        band, side = self.x[:, 0] > 0, 2 * horizon if dimension == 2 else width // 2 - 4
        for d in range(1, dimension):
            band &= np.abs(self.x[:, d] - 0.5 * width * SPACING) < (0.5 * width - side) * SPACING
        per_layer = np.sum(band) / (length - 7)
        return self.speed_error(result, band, per_layer, SPACING, 3, time)

    def test_bar(self):
        for horizon in (3, 4, 5):
            self.assertLess(abs(self.plane(1, horizon, "Deterministic", 1)), 1e-9, horizon)
            self.assertLess(abs(self.plane(1, horizon, "Stochastic", 1)), 2e-3, horizon)

    def test_strip(self):
        for horizon in (3, 4, 5):
            for rule in ("Deterministic", "Stochastic"):
                self.assertLess(abs(self.plane(2, horizon, rule, 48)), 1e-2, (horizon, rule))

    def test_block(self):
        for rule in ("Deterministic", "Stochastic"):
            self.assertLess(abs(self.plane(3, 3, rule, 28, 24, 80.0)), 1e-2, rule)

    def test_long_cells(self):
        # Across the short axis of an ellipse of 25:1.
        x, y = np.meshgrid(25 * SPACING * (np.arange(40) + 0.5), SPACING * (np.arange(45) + 0.5))
        self.x = np.column_stack([x.ravel(), y.ravel(), 0.0 * x.ravel()])
        self.write_mesh(self.x, 25 * SPACING**2)
        middle = (self.x[:, 1] > 7 * SPACING) & (np.abs(self.x[:, 0] - 500 * SPACING) < 300 * SPACING)
        for shape, rule in (("Ellipsoid", "Deterministic"), ("Box", "Deterministic"), ("Ellipsoid", "Stochastic")):
            result = self.run_trial(2, f"y > {7 * SPACING!r}", f"y < {5 * SPACING!r}", 180.0, 10, 100, rule,
                                    **{"Horizon Axes": [100 * SPACING, 4 * SPACING], "Horizon Shape": shape})
            error = self.speed_error(result, middle, np.sum(middle) / 38, SPACING, 3, 180.0)
            self.assertLess(abs(error), 1.5e-2 if rule == "Stochastic" else 1e-3, (shape, rule))


class OtherFronts(TrialTest):
    def test_slanting_front_is_faster(self):
        # By the ratio of the first moments of the bonds: 3.9 % at 45 degrees.
        side, angle, half = 60 * SPACING, radians(45.0), 16 * SPACING
        self.make_lattice([side, side])
        along = f"{cos(angle)!r}*x + {sin(angle)!r}*y"
        start = 0.5 * side * (cos(angle) + sin(angle)) - 18 * SPACING
        across = -sin(angle) * (self.x[:, 0] - 0.5 * side) + cos(angle) * (self.x[:, 1] - 0.5 * side)
        depth = cos(angle) * self.x[:, 0] + sin(angle) * self.x[:, 1] - start
        # A band with soft sides, lest it matters which points they cut.
        band = np.where((np.abs(across) < half) & (depth > 0), 0.5 + 0.5 * np.cos(np.pi * across / half), 0.0)
        errors = []
        for kernel in ("Trial Calibration", "Flux Exact"):
            result = self.run_trial(2, f"{along} > {start!r}", f"{along} < {start - 2 * SPACING!r}", 140.0, 14,
                                    kernel=kernel)
            errors.append(self.speed_error(result, band, half / SPACING, SPACING, 4, 140.0))
        a, b = np.meshgrid(np.arange(-4, 5), np.arange(-4, 5))
        square = np.where((a == 0) & (b == 0), 1, a * a + b * b)
        weight = np.clip(4.5 - np.sqrt(square), 0.0, 1.0) / square
        expected = np.sum(weight * np.abs(a + b)) / np.sqrt(2.0) / np.sum(weight * np.abs(a)) - 1.0
        self.assertGreater(expected, 0.03)
        self.assertAlmostEqual(errors[0], expected, delta=2e-3)
        self.assertLess(abs(errors[1]), 2e-3)

    def test_salt_reaches_over_a_horizon(self):
        # Ions have the less of a way by what the kernel keeps saturated: 0.8 horizons in place of 0.2.
        self.make_lattice([107e-6], [-7e-6])
        exact = 2.0 * stefan_number(SALTED_STEEL) * np.sqrt(SALTED_STEEL["Diffusivity"] * 100.0)
        ahead = {}
        for kernel in ("Trial Calibration", "Flux Exact"):
            history = self.run_trial(1, "x > 0", "x < 0", 100.0, 10, metal=SALTED_STEEL, kernel=kernel).history()
            ahead[kernel] = (history["Dissolved"][-1] - exact) / (4 * SPACING)
        self.assertGreater(ahead["Trial Calibration"], 0.5)
        self.assertLess(ahead["Trial Calibration"], 1.0)
        self.assertLess(ahead["Flux Exact"], 0.4)


if __name__ == "__main__":
    unittest.main()
