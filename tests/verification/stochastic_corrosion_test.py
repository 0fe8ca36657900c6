#!/usr/bin/python3
"""Corrosion with bonds that break at random: Faraday's law holds, the front is rough, seeds differ."""
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from corrosion_scene import HALF_A_FILM, SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402


class PlanarFront(CorrosionTest):
    """A strip under activation control: depth = i t/(z F C_solid)."""

    COLUMNS, ROWS = 52, 40

    def strip(self, seed, time, steps, **solver):
        self.make_lattice([self.COLUMNS * SPACING, self.ROWS * SPACING], [-7e-6, 0.0])
        deck = corrosion_deck(2, STEEL, "x > 0", "x < -2e-6", time, steps, **solver)
        if seed is not None:
            deck["Damage Models"]["Phases"].update({"Rule": "Stochastic", "Random Seed": seed})
        deck["Output"]["Output Variables"].append("Loose" if seed is not None else "Volume")
        result = self.solve(deck)
        self.check(result, STEEL)
        return result

    def depth(self, result, step):
        """Metal dissolved over what solid gives, a unit of width. (The integral of Damage now counts bonds.)"""
        given = result.field("Concentration", 0) - result.field("Concentration", step)
        given[result.field("Damage", step) >= 1.0] = STEEL["Solid Concentration"] - STEEL["Saturation Concentration"]
        was_solid = self.x[:, 0] > 0
        solid = STEEL["Solid Concentration"] - STEEL["Saturation Concentration"]
        return np.sum(given[was_solid]) / solid * SPACING / self.ROWS

    def fronts(self, result, step):
        """How many points of each row have turned liquid."""
        liquid = (result.field("Damage", step) >= 1.0) & (self.x[:, 0] > 0)
        return liquid.reshape(self.ROWS, self.COLUMNS).sum(axis=1)

    def test_depth(self):
        # A rough front is longer than a plane one, and parts of it slant: 0.1 to 2.2 % with seeds and steps, 1.3 % with
        # short ones (0.05 s: 0.008 spacings).
        runs = (1, {}), (2, {}), (1, {"Front Limit": 0.1}), (1, {"Fixed dt": 0.2}), (1, {"Fixed dt": 5.0})
        for seed, solver in runs:
            result = self.strip(seed, 240.0, 4, **solver)
            for step in (2, 4):
                error = self.depth(result, step) / (front_speed(STEEL) * 60.0 * step) - 1.0
                self.assertLess(abs(error), 0.035, (seed, solver, step))

    def test_twice_the_current_under_half_a_film_is_the_same(self):
        self.make_lattice([30 * SPACING, 16 * SPACING], [-7e-6, 0.0])
        results = []
        for current, film, ranks in ((1.0, {}, 1), (2.0, HALF_A_FILM, 1), (2.0, HALF_A_FILM, 2)):
            metal = {**STEEL, "Current Density": repr(current * float(STEEL["Current Density"]))}
            deck = corrosion_deck(2, metal, "x > 0", "x < -2e-6", 60.0, 4)
            deck["Damage Models"]["Phases"].update({"Rule": "Stochastic", "Random Seed": 1})
            deck["Boundary Conditions"] |= film
            results.append(self.solve(deck, ranks=ranks))
            self.check(results[-1], STEEL)
        for result in results[1:]:
            np.testing.assert_array_equal(result.field("Damage"), results[0].field("Damage"))
            np.testing.assert_allclose(result.field("Concentration"), results[0].field("Concentration"), rtol=1e-8,
                                       atol=1e-6)

    def test_front_is_rough(self):
        def roughness(result):
            return np.mean([self.fronts(result, step).std() for step in result.steps()[40:]])

        # Plane but for the corners, where bonds are missing.
        plane, *rough = [roughness(self.strip(seed, 240.0, 240)) for seed in (None, 1, 2)]
        self.assertLess(plane, 0.02)
        self.assertGreater(min(rough), 0.05)
        self.assertLess(max(rough), 0.5)

    def test_seeds_differ_and_repeat(self):
        def run(seed):
            result = self.strip(seed, 40.0, 80)
            return [np.array([result.field(label, step) for step in result.steps()])
                    for label in ("Damage", "Concentration")]

        (damage, c), (other, _), (again, c_again) = run(3), run(4), run(3)
        np.testing.assert_array_equal(damage, again)
        np.testing.assert_array_equal(c, c_again)
        self.assertTrue(np.any((damage == 1.0) != (other == 1.0)))

    def test_damage_follows_what_has_dissolved(self):
        # Bonds break at both ends and those to liquid points are gone: Damage is above d_c. Far from the liquid nothing
        # is broken.
        result = self.strip(5, 100.0, 10)
        damage, loose = result.field("Damage", 10), result.field("Loose", 10)
        front = self.fronts(result, 10).max() * SPACING
        solid = damage < 1.0
        capacity = STEEL["Solid Concentration"] - STEEL["Saturation Concentration"]
        dissolved = (STEEL["Solid Concentration"] - result.field("Concentration", 10)) / capacity
        near = solid & (dissolved > 0.05)
        self.assertGreater(near.sum(), 15)
        self.assertGreater(np.mean(damage[near] - dissolved[near]), 0.0)
        self.assertTrue(np.all(damage[solid & (self.x[:, 0] > front + 8e-6)] == 0.0))
        self.assertTrue(np.all(loose[~solid] == 0.0))
        self.assertTrue(np.all(damage[loose > 0] > 1.0 - 1e-11))


class ClosedBodies(CorrosionTest):
    def solve_stochastic(self, dimension, solid, held, time, steps, **solver):
        deck = corrosion_deck(dimension, STEEL, solid, held, time, steps, **solver)
        deck["Damage Models"]["Phases"].update({"Rule": "Stochastic", "Random Seed": 1})
        result = self.solve(deck)
        self.check(result, STEEL)
        return result

    def test_metal_dissolves_to_its_end(self):
        for dimension, lengths in ((1, [17e-6]), (2, [17e-6, 8e-6]), (3, [17e-6, 5e-6, 5e-6])):
            self.make_lattice(lengths, [-7e-6, 0.0, 0.0])
            for solver in ({}, {"Fixed dt": 10.0}):
                result = self.solve_stochastic(dimension, "x > 0", "x < -2e-6", 200.0, 5, **solver)
                self.assertTrue(np.all(result.field("Damage") == 1.0), (dimension, solver))

    def test_island_dissolves_and_loose_bits_with_it(self):
        self.make_lattice([36e-6, 36e-6], [-18e-6, -18e-6])
        for solver in ({}, {"Fixed dt": 0.2}):
            result = self.solve_stochastic(2, "x*x + y*y < 1e-10", "x*x + y*y > 2.25e-10", 100.0, 10, **solver)
            self.assertTrue(np.all(result.field("Damage") == 1.0))

    def test_pocket_saturates(self):
        self.make_lattice([24e-6, 24e-6])
        result = self.solve_stochastic(2, "abs(x - 1.2e-5) > 4e-6 || abs(y - 1.2e-5) > 4e-6", "", 1000.0, 10)
        self.assertAlmostEqual(self.amount(result) / self.amount(result, 0), 1.0, delta=1e-12)
        liquid = result.field("Damage") >= 1.0
        np.testing.assert_allclose(result.field("Concentration")[liquid], STEEL["Saturation Concentration"], rtol=1e-7)


if __name__ == "__main__":
    unittest.main()
