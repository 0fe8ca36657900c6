#!/usr/bin/python3
"""Initial concentrations that vary in space, and an electrolyte beyond the mesh, against exact solutions."""
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from corrosion_scene import HORIZON, SPACING, STEEL, CorrosionTest, corrosion_deck  # noqa: E402

DIFFUSIVITY, SATURATION = STEEL["Diffusivity"], STEEL["Saturation Concentration"]
# Salt covers the surface throughout: diffusion sets the speed.
SALTED = {**STEEL, "Current Density": "1.0e7"}


class InitialConcentration(CorrosionTest):
    def test_an_expression_decays_as_it_should(self):
        """A cosine in an electrolyte without metal, the ends closed: its amplitude falls by exp(-D k^2 t)."""
        length, time = 200e-6, 5.0
        self.make_lattice([length])
        deck = corrosion_deck(1, STEEL, "x >= 0", None, time, 5, **{"Relative Tolerance": 1e-5})
        deck["Boundary Conditions"]["Metal"]["Value"] = f"2000 + 1500*cos({np.pi / length!r}*x)"
        result = self.solve(deck)
        x = self.x[:, 0]
        start = 2000.0 + 1500.0 * np.cos(np.pi * x / length)
        np.testing.assert_allclose(result.field("Concentration", 0), start, rtol=1e-12)
        decay = np.exp(-DIFFUSIVITY * (np.pi / length)**2 * time)
        expected = 2000.0 + (start - 2000.0) * decay
        self.assertLess(np.max(np.abs(result.field("Concentration") - expected)), 0.01 * 1500.0)

    def test_what_no_metal_has_is_refused(self):
        self.make_lattice([12e-6])
        for value, text in (("-1.0e8*x", "concentration -50 mol/m3 at point 1"),
                            (1.5e5, "concentration 150000 mol/m3 at point 1")):
            deck = corrosion_deck(1, STEEL, "x >= 0", None, 1.0, 1)
            deck["Boundary Conditions"]["Metal"]["Value"] = value
            result = self.run_deck(deck)
            self.assertEqual(result.code, 3, result.text)
            self.assertIn(text, result.text)
            self.assertIn("look at the initial and prescribed concentrations", result.text)

    def test_box_expression_and_numbers_of_nodes(self):
        self.make_lattice([12e-6, 8e-6])
        deck = corrosion_deck(2, STEEL, "y > 4.0e-6", None, 1e-6, 1)
        deck["Boundary Conditions"].update({
            "Left Node Set": {"Box": [[0.0, 1e-6, -1.0], [6e-6, 4e-6, 1.0]]},
            "Left": {"Type": "Initial Concentration", "Node Set": "Left Node Set", "Value": "1.0e8*x + 2.0e8*y"},
            "Corner Node Set": "1 2",
            "Corner": {"Type": "Initial Concentration", "Node Set": "Corner Node Set", "Value": 77.0}})
        result = self.solve(deck)
        x, y = self.x[:, 0], self.x[:, 1]
        left = (x < 6e-6) & (y > 1e-6)
        expected = np.where(y > 4e-6, STEEL["Solid Concentration"], np.where(left, 1e8 * x + 2e8 * y, 0.0))
        expected[:2] = 77.0
        np.testing.assert_allclose(result.field("Concentration", 0), expected, rtol=1e-12)
        np.testing.assert_array_equal(result.field("Damage", 0) >= 1.0, y < 4e-6)


def quasi_steady_depths(times, distance, length):
    """Of a salt-covered front, its electrolyte `length` long at the start and `distance` more to where C = 0, the way
    between at steady state; what the length holds taken into account. Runge's midpoint rule."""
    solid = STEEL["Solid Concentration"]

    def held(s):
        # C_sat (1 - y/(s + length + distance)) from the front to the end of the mesh.
        return SATURATION * (s + length) * (1.0 - 0.5 * (s + length) / (s + length + distance))

    def speed(s):
        slope = (held(s + 1e-9) - held(s - 1e-9)) / 2e-9
        return DIFFUSIVITY * SATURATION / (s + length + distance) / (solid - slope)

    s, t, result = 0.0, 0.0, []
    # The first electrolyte is filled from the metal.
    s = held(0.0) / solid
    for end in times:
        n = 2000
        h = (end - t) / n
        for _ in range(n):
            s += h * speed(s + 0.5 * h * speed(s))
        t = end
        result.append(s)
    return np.array(result)


class FarField(CorrosionTest):
    def bar(self, left, right, solid, distance, time, steps, metal=STEEL, far=0.0, ranks=1, name="result"):
        """A bar whose layer of a horizon at the left end is open."""
        self.make_lattice([right - left], [left])
        deck = corrosion_deck(1, metal, solid, None, time, steps, name)
        deck["Boundary Conditions"].update({
            "Layer Node Set": {"Expression": f"x < {left + HORIZON!r}"},
            "Open Sea": {"Type": "Far Field Concentration", "Node Set": "Layer Node Set", "Value": far,
                         "Distance": distance, "Diffusivity": DIFFUSIVITY, "Area": 1.0}})
        return deck

    def test_steady_flux(self):
        """C_sat held over the right 7 um: linear to where C is that of the sea."""
        left, right = -40e-6, 0.0
        for distance, far in ((0.0, 0.0), (20e-6, 0.0), (500e-6, 1000.0)):
            deck = self.bar(left, right + 7e-6, "x > 0", distance, 200.0, 1, far=far)
            deck["Boundary Conditions"]["Metal"].update({"Type": "Prescribed Concentration", "Value": SATURATION})
            result = self.solve(deck)
            x, c = self.x[:, 0], result.field("Concentration")
            inside = (x > left + 2 * HORIZON) & (x < right - HORIZON)
            slope = np.polyfit(x[inside], c[inside], 1)[0]
            way = (SATURATION - far) / slope
            # Seen: 0.18 to 0.20 horizons more, whatever the distance.
            self.assertLess(abs(way - (right - left + distance)), 0.25 * HORIZON)

    def test_a_front_whose_ions_leave_for_the_open(self):
        left, distance, time = -20e-6, 100e-6, 200.0
        result = self.solve(self.bar(left, 60e-6, "x > 0", distance, time, 20, SALTED))
        self.check(result, SALTED)
        history = result.history()
        expected = quasi_steady_depths(history["time"][1:], distance, -left)
        np.testing.assert_allclose(history["Dissolved"][5:], expected[4:], rtol=0.02)

    def test_ions_of_another_name_leave_alike(self):
        found = []
        for label in ("Concentration", "Ions"):
            deck = self.bar(-20e-6, 20e-6, "x > 0", 10e-6, 20.0, 2, far=100.0, name=label)
            deck["Boundary Conditions"]["Metal"].update({"Type": "Initial Value", "Field": label})
            deck["Boundary Conditions"]["Open Sea"]["Field"] = label
            for part in (deck["Materials"]["Metal"], deck["Damage Models"]["Phases"], deck["Solver"]["Corrosion"]):
                part["Concentration Field"] = label
            deck["Output"]["Output Variables"] = [label, "Damage"]
            found.append(self.solve(deck).field(label))
        np.testing.assert_array_equal(found[0], found[1])
        self.assertGreater(np.max(found[0][self.x[:, 0] < -10e-6]), 10.0)

    def test_a_far_sea_is_a_wall_and_a_near_one_a_mouth(self):
        # Closed, the electrolyte fills and the front stops.
        closed = self.solve(self.bar(-20e-6, 20e-6, "x > 0", 1e3, 100.0, 4, SALTED, name="closed"))
        self.check(closed, SALTED)
        filled = 20e-6 * SATURATION / (STEEL["Solid Concentration"] - SATURATION)
        self.assertAlmostEqual(closed.history()["Dissolved"][-1] / filled, 1.0, delta=1e-3)
        # A sea that holds more than the electrolyte feeds it.
        deck = self.bar(-40e-6, 0.0, "x < 0", 10e-6, 30.0, 4, far=3000.0, name="fed")
        deck["Boundary Conditions"]["Metal"]["Value"] = 0.0
        fed = self.solve(deck)
        np.testing.assert_allclose(fed.field("Concentration"), 3000.0, rtol=1e-3)
        self.assertIn("mol have left through prescribed points and far fields", " ".join(fed.report["solver"]))


if __name__ == "__main__":
    unittest.main()
