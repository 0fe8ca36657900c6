#!/usr/bin/python3
"""Dissolving bodies whose fronts meet: the end of the metal, islands, pits that merge, closed pockets, steep kinetics."""
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from corrosion_scene import SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402

# Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512, eqs. 23 to 25; C in mol/L.
ALLOY = {"Diffusivity": 720e-12, "Solid Concentration": 140000.0, "Saturation Concentration": 5600.0,
         "Charge Number": 2.37, "Current Density": "1.0e4*pow(10, 1.151*exp(-0.723*pH) - 7.647)",
         "pH": "7.405*exp(-0.08036*C) - 6.498"}


class EndOfTheMetal(CorrosionTest):
    def test_front_meets_the_end_of_the_body(self):
        # 10 um at 0.169 um/s are gone after a minute; what is left diffuses out.
        for dimension, lengths in ((1, [17e-6]), (2, [17e-6, 8e-6]), (3, [17e-6, 5e-6, 5e-6])):
            self.make_lattice(lengths, [-7e-6, 0.0, 0.0])
            for solver in ({}, {"Fixed dt": 0.7}, {"Fixed dt": 10.0}):
                result = self.corrode(dimension, STEEL, "x > 0", "x < -2e-6", 200.0, 20, **solver)
                t, depth = result.history()["time"], result.history()["Dissolved"] / np.prod(lengths[1:])
                self.assertTrue(np.all(result.field("Damage") == 1.0), (dimension, solver))
                moving = t < 0.9 * 10e-6 / front_speed(STEEL)
                np.testing.assert_allclose(depth[moving], front_speed(STEEL) * t[moving], atol=0.15e-6)
                self.assertLess(np.max(result.field("Concentration")), 1e-3 * STEEL["Saturation Concentration"])

    def test_island_dissolves_from_all_sides(self):
        radius, size = 16e-6, 52e-6
        self.make_lattice([size, size], [-size / 2, -size / 2])
        inside = f"x*x + y*y < {radius**2!r}"
        result = self.corrode(2, STEEL, inside, f"x*x + y*y > {(radius + 4e-6)**2!r}", 120.0, 24)
        history = result.history()
        # Whole lattice cells make the disc.
        start = np.sum(np.sum(self.x**2, axis=1) < radius**2) * SPACING**2
        left = np.maximum(start - history["Dissolved"], 0.0)
        found = np.sqrt(left / np.pi)
        speed = (found[0] - found[12]) / history["time"][12]
        self.assertAlmostEqual(speed / front_speed(STEEL), 1.0, delta=0.02)
        self.assertTrue(np.all(result.field("Damage") == 1.0))
        # It stays round, and the same from all sides.
        solid = result.field("Damage", 12).reshape(52, 52) < 1.0
        for image in (solid[::-1], solid[:, ::-1], solid.T):
            np.testing.assert_array_equal(solid, image)
        reach = solid[26].sum() / 2.0, np.sqrt(2.0) * np.diag(solid).sum() / 2.0
        self.assertAlmostEqual(reach[0], reach[1], delta=1.5)

    def test_pits_merge(self):
        self.make_lattice([48e-6, 30e-6])
        pits = [f"(x - {x!r})*(x - {x!r}) + (y - 1.5e-5)*(y - 1.5e-5)" for x in (14e-6, 34e-6)]
        solid = " && ".join(f"{pit} > 3.6e-11" for pit in pits)
        held = " || ".join(f"{pit} < 4e-12" for pit in pits)
        result = self.corrode(2, STEEL, solid, held, 300.0, 30)
        dissolved = result.history()["Dissolved"]
        self.assertTrue(np.all(np.diff(dissolved) >= -1e-12 * dissolved[-1]))
        apart = result.field("Damage", 2).reshape(30, 48)[15, 23:25]
        self.assertTrue(np.all(apart < 1.0))
        # The bridge of 8 um between them lasts no longer than its two faces need.
        time = 4e-6 / front_speed(STEEL)
        merged = result.field("Damage", int(np.ceil(time / 10.0)) + 1).reshape(30, 48)[15, 23:25]
        self.assertTrue(np.all(merged == 1.0))
        self.assertTrue(np.all(result.field("Damage") == 1.0))
        # The same on the left and on the right.
        for step in result.steps():
            image = result.field("Damage", step).reshape(30, 48)
            np.testing.assert_allclose(image, image[:, ::-1], atol=1e-6)


class ClosedPockets(CorrosionTest):
    def test_pocket_saturates_and_the_attack_stops(self):
        for dimension, lengths in ((1, [40e-6]), (2, [24e-6, 24e-6]), (3, [12e-6, 12e-6, 12e-6])):
            self.make_lattice(lengths)
            middle = lengths[0] / 2
            solid = " || ".join(f"abs({axis} - {middle!r}) > 4e-6" for axis in "xyz"[:dimension])
            for solver in ({}, {"Fixed dt": 5.0}):
                result = self.corrode(dimension, STEEL, solid, "", 1000.0, 10, **solver)
                before, after = self.amount(result, 0), self.amount(result)
                self.assertAlmostEqual(after / before, 1.0, delta=1e-12)
                c, liquid = result.field("Concentration"), result.field("Damage") >= 1.0
                np.testing.assert_allclose(c[liquid], STEEL["Saturation Concentration"], rtol=1e-7)
                # C_sat V_liquid comes from the metal: 3.2 % of the first volume, 3.3 % with what has dissolved.
                first = result.field("Damage", 0) >= 1.0
                pocket = first.sum() * STEEL["Saturation Concentration"]
                ratio = STEEL["Solid Concentration"] - STEEL["Saturation Concentration"]
                self.assertAlmostEqual(result.history()["Dissolved"][-1] / (pocket / ratio * self.volume), 1.0, delta=1e-6)

    def test_front_opens_a_pocket(self):
        # Sea, a wall of 6 um, a pocket of 6 um that is soon saturated, metal.
        self.make_lattice([60e-6], [-7e-6])
        result = self.corrode(1, STEEL, "x > 0 && (x < 6e-6 || x > 12e-6)", "x < -2e-6", 200.0, 40)
        depth = result.history()["Dissolved"]
        self.assertGreater(depth[-1], 6e-6 + front_speed(STEEL) * 100.0)
        self.assertTrue(np.all(np.diff(depth) >= -1e-15))

    def test_nothing_dissolves_in_saturated_electrolyte(self):
        self.make_lattice([30e-6])
        deck = corrosion_deck(1, STEEL, "x > 1e-5", "", 1e4, 4)
        deck["Boundary Conditions"]["All Node Set"] = {"Expression": "x < 1e-5"}
        deck["Boundary Conditions"]["Brine"] = {"Type": "Initial Concentration", "Node Set": "All Node Set",
                                                "Value": STEEL["Saturation Concentration"]}
        result = self.solve(deck)
        self.check(result, STEEL)
        np.testing.assert_allclose(result.field("Concentration"), result.field("Concentration", 0), rtol=1e-9)


class SteepKinetics(CorrosionTest):
    """Metal behind an electrolyte that starts near saturation, where the current is thousands of times that at C = 0."""

    def crevice(self, metal, time, steps, **solver):
        self.make_lattice([80e-6], [-40e-6])
        deck = corrosion_deck(1, metal, "x > 0", "x < -36e-6", time, steps, **solver)
        deck["Boundary Conditions"]["Inside Node Set"] = {"Expression": "x > -36e-6 && x < 0"}
        deck["Boundary Conditions"]["Inside"] = {"Type": "Initial Concentration", "Node Set": "Inside Node Set",
                                                 "Value": 0.99 * metal["Saturation Concentration"]}
        result = self.solve(deck)
        self.check(result, metal)
        return result.history()["Dissolved"]

    def test_alloy_625(self):
        # The attack dies out: at most what saturated electrolyte would dissolve, no less than fresh one.
        depth = self.crevice(ALLOY, 3600.0, 12)
        self.assertLess(depth[-1], front_speed(ALLOY, 3.2421) * 3600.0)
        self.assertGreater(depth[-1], front_speed(ALLOY, 8.92e-4) * 3600.0)

    def test_current_over_nine_decades(self):
        metal = {**ALLOY, "Current Density": "pow(10.0, -6.0 + 9.0*C/5.6)"}
        del metal["pH"]
        depth = self.crevice(metal, 1e4, 10)
        self.assertGreater(depth[-1], 0.0)
        self.assertTrue(np.all(np.diff(depth) >= 0.0))

    def test_current_that_sustains_itself(self):
        # 2e5 A/m2 at saturation, where 36 um of electrolyte carry 2.6e4: the surface stays above 0.9 C_sat.
        metal = {**ALLOY, "Current Density": "pow(10.0, -3.7 + 9.0*C/5.6)"}
        del metal["pH"]
        deep = self.crevice(metal, 50.0, 10)
        # Quasi-steady: l dl = D C_sat/(C_solid - C_sat) dt from l = 36 um on, D C_sat/(...) = 30 um2/s.
        exact = np.sqrt((36e-6)**2 + 2 * 720e-12 * 5600.0 / 134400.0 * 50.0) - 36e-6
        self.assertAlmostEqual(deep[-1] / exact, 1.0, delta=0.05)
        for solver in ({"Fixed dt": 0.5}, {"Fixed dt": 20.0}):
            self.assertAlmostEqual(self.crevice(metal, 50.0, 10, **solver)[-1] / deep[-1], 1.0, delta=0.02)


if __name__ == "__main__":
    unittest.main()
