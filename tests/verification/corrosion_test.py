#!/usr/bin/python3
"""Corrosion against Faraday's law, the Stefan solution and finite volumes that move with the front."""
import os
import sys
import unittest
from math import erf, exp, pi, sqrt

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, "../support"), os.path.join(here, "../../decks/pencil")]
from corrosion_scene import (COPPER, HALF_A_FILM, HORIZON, SPACING, STEEL, CorrosionTest,  # noqa: E402
                             corrosion_deck, front_speed)
from moving_front import depths  # noqa: E402

# Chen & Bobaru, J. Mech. Phys. Solids 78 (2015) 352; the current is far more than diffusion takes away.
SALTED_STEEL = {"Diffusivity": 850e-12, "Solid Concentration": 143000.0, "Saturation Concentration": 5100.0,
                "Charge Number": 2.19, "Current Density": "1.0e6"}


def stefan_number(metal):
    """lambda of sqrt(pi) lambda exp(lambda^2) erf(lambda) = C_sat/(C_solid - C_sat), by bisection."""
    saturation, solid = metal["Saturation Concentration"], metal["Solid Concentration"]
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        if sqrt(pi) * middle * exp(middle**2) * erf(middle) < saturation / (solid - saturation):
            low = middle
        else:
            high = middle
    return middle


class ActivationControl(CorrosionTest):
    """Depth = i t/(z F C_solid)."""

    def check_depth(self, dimension, metal, lengths, tolerance, **solver):
        self.make_lattice(lengths, [-7e-6, 0.0, 0.0])
        area = np.prod(lengths[1:])
        history = self.corrode(dimension, metal, "x > 0", "x < -2e-6", 240.0, 6, **solver).history()
        depth = history["Dissolved"][1:] / area
        error = depth / (front_speed(metal) * history["time"][1:]) - 1.0
        self.assertLess(np.max(np.abs(error[2:])), tolerance, error)
        self.assertLess(np.max(np.abs(error * depth)), 0.5 * SPACING)

    def test_bar_is_exact(self):
        for metal in (STEEL, COPPER):
            self.check_depth(1, metal, [52e-6], 1e-9)

    def test_strip(self):
        for metal in (STEEL, COPPER):
            self.check_depth(2, metal, [52e-6, 20e-6], 1.5e-2)
            # Of a front that does not stay plane, which part turns liquid a step earlier matters less in short steps.
            self.check_depth(2, metal, [52e-6, 20e-6], 2e-3, **{"Front Limit": 0.1})

    def test_block(self):
        self.check_depth(3, STEEL, [52e-6, 8e-6, 8e-6], 1e-2)

    def test_front_moves_alike_with_steps_that_differ_a_hundredfold(self):
        # 0.05 s: 0.008 spacings; 5 s: 0.84 spacings.
        for h in (0.05, 0.5, 5.0):
            self.check_depth(1, STEEL, [52e-6], 1e-2, **{"Fixed dt": h})
            self.check_depth(2, STEEL, [52e-6, 8e-6], 1e-2, **{"Fixed dt": h})


class Barrier(CorrosionTest):
    def test_a_wall_in_space_dissolves_from_both_sides_and_through(self):
        # 8 um between two electrolytes, 2 um in each step, the last of which opens it; and under half a film.
        self.make_lattice([22e-6, 6e-6, 6e-6], [-11e-6, 0.0, 0.0])
        step = 1e-6 / front_speed(STEEL)
        for current, film in ((1.0, {}), (2.0, HALF_A_FILM)):
            metal = {**STEEL, "Current Density": repr(current * float(STEEL["Current Density"]))}
            deck = corrosion_deck(3, metal, "abs(x) < 4e-6", "abs(x) > 8e-6", 5 * step, 5)
            deck["Boundary Conditions"] |= film
            result = self.solve(deck)
            self.check(result, STEEL)
            depth = result.history()["Dissolved"] / 36e-12
            np.testing.assert_allclose(depth[:4], [0.0, 2e-6, 4e-6, 6e-6], atol=1e-3 * SPACING)
            np.testing.assert_allclose(depth[4:], 8e-6, atol=0.01 * SPACING)
            self.assertEqual(np.min(result.field("Damage")[np.abs(self.x[:, 0]) < 4e-6]), 1.0)


class DiffusionControl(CorrosionTest):
    """Depth = 2 lambda sqrt(D t), C = 0 up to the original surface, the ratio of current to diffusion large."""

    def run_pencil(self, length, time, steps, metal=SALTED_STEEL, **solver):
        self.make_lattice([length + 7e-6], [-7e-6])
        return self.corrode(1, metal, "x > 0", "x < 0", time, steps, **solver)

    def test_depth_and_profile(self):
        result = self.run_pencil(270e-6, 1000.0, 40)
        history, d = result.history(), SALTED_STEEL["Diffusivity"]
        number = stefan_number(SALTED_STEEL)
        self.assertAlmostEqual(number, 0.13516, delta=1e-5)
        exact = 2.0 * number * np.sqrt(d * history["time"][1:])
        error = history["Dissolved"][1:] / exact - 1.0
        self.assertLess(np.max(np.abs(error[exact >= 10 * HORIZON])), 0.025)
        self.assertLess(np.max(np.abs(error[exact >= 60 * HORIZON])), 0.005)
        # Salt keeps half a horizon saturated: the front is ahead by no more than that.
        self.assertLess(np.max(np.abs(error * exact)), 0.5 * HORIZON)
        x = self.x[:, 0]
        liquid = (result.field("Damage") >= 1.0) & (x > 0)
        profile = np.array([erf(v) for v in x[liquid] / (2.0 * sqrt(d * 1000.0))]) / erf(number)
        c = result.field("Concentration")[liquid] / SALTED_STEEL["Saturation Concentration"]
        self.assertLess(np.max(np.abs(c - profile)), 0.01)

    def test_steps_that_differ_a_hundredfold(self):
        # By the original surface's layer of half a horizon no more than that is known of the depth.
        found = [self.run_pencil(90e-6, 100.0, 1, **{"Fixed dt": h}).history()["Dissolved"][-1]
                 for h in (0.05, 0.5, 5.0)]
        exact = 2.0 * stefan_number(SALTED_STEEL) * sqrt(SALTED_STEEL["Diffusivity"] * 100.0)
        for depth in found:
            self.assertAlmostEqual(depth / found[0], 1.0, delta=0.01, msg=str(found))
            self.assertAlmostEqual(depth / exact, 1.0, delta=0.025, msg=str(found))

    def test_from_one_control_to_the_other(self):
        # The transition of the quasi-steady pencil is at z F D C_sat / i = 163.9 um.
        result = self.run_pencil(300e-6, 2000.0, 20, STEEL)
        history = result.history()
        t, depth = history["time"][1:], history["Dissolved"][1:]
        reference = depths(t, STEEL["Diffusivity"], STEEL["Solid Concentration"], STEEL["Saturation Concentration"],
                           front_speed(STEEL), growth=0.008)
        np.testing.assert_allclose(depth, reference, rtol=3e-3)
        self.assertAlmostEqual(depth[8] / (front_speed(STEEL) * 900.0), 1.0, delta=1e-3)
        self.assertLess(depth[-1], 0.9 * front_speed(STEEL) * 2000.0)


if __name__ == "__main__":
    unittest.main()
