#!/usr/bin/python3
"""Losses, depths, speeds and currents that computes report, against Faraday's law and the shape of a round pit."""
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from corrosion_scene import FARADAY, HORIZON, SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402
from scene import lattice  # noqa: E402

MOLAR_MASS = 0.05585
CURRENT = float(STEEL["Current Density"])
SURFACE = {"Node Set": "Surface Node Set", "Into Y": 1.0}
COMPUTES = {
    "Mass": {"Compute Class": "Mass_Loss", "Molar Mass": MOLAR_MASS},
    "Amount": {"Compute Class": "Dissolved_Amount"},
    "Volume": {"Compute Class": "Volume_Loss"},
    "Rate": {"Compute Class": "Corrosion_Rate"},
    "Gas": {"Compute Class": "Hydrogen_Gas"},
    "Depth": {"Compute Class": "Corrosion_Depth", **SURFACE},
    "Deepest": {"Compute Class": "Maximum_Depth", **SURFACE, "Measure": "Deepest"},
    "Mean": {"Compute Class": "Mean_Depth", **SURFACE},
    "Place": {"Compute Class": "Deepest_Place", **SURFACE},
    "Width": {"Compute Class": "Pit_Width", **SURFACE},
    "Mouth": {"Compute Class": "Pit_Width", **SURFACE, "At Depth": 0.0, "Output Label": "Mouth_Width"},
    "Speed": {"Compute Class": "Front_Speed", **SURFACE, "Depth": "Mean"},
    "Mean Current": {"Compute Class": "Mean_Current_Density"},
    "Peak Current": {"Compute Class": "Peak_Current_Density"},
    "Current": {"Compute Class": "Total_Current"},
    "Where": {"Compute Class": "Current_Place", "Of": "Centre"},
}


class Computes(CorrosionTest):
    def run_plate(self, size, origin, solid, held, surface, time, steps):
        self.x = lattice(size, SPACING, origin)
        self.volume = SPACING**2
        self.write_mesh(self.x, self.volume)
        deck = corrosion_deck(2, STEEL, solid, held, time, steps)
        deck["Boundary Conditions"]["Surface Node Set"] = {"Expression": surface}
        deck["Compute Class Parameters"].update(COMPUTES)
        deck["Output"]["Output Variables"].append("Corrosion_Depth")
        result = self.solve(deck)
        self.check(result, STEEL)
        return result

    def test_a_plane_front_obeys_faradays_law(self):
        length, time, steps = 40e-6, 40.0, 8
        result = self.run_plate([length, 16e-6], [0.0, -6e-6], "y > 0", "y < -3.0e-6", f"y > 0 && y < {SPACING}",
                                time, steps)
        h = result.history()
        charge = CURRENT * length * h["time"]  # a metre thick
        amount = charge / (STEEL["Charge Number"] * FARADAY)
        # The sides, where the front leaves the layers of the grid, take part to less than a thousandth.
        nearly = 1e-3
        dissolved, depth = h["Dissolved_Amount"], h["Mean_Depth"]
        np.testing.assert_allclose(dissolved, amount, rtol=nearly)
        # What has left the metal as ions is C_solid - C_sat of a point until it turns liquid, and that is what is taken
        # for its share; so these agree exactly.
        np.testing.assert_allclose(h["Mass_Loss"], MOLAR_MASS * dissolved, rtol=1e-8)
        np.testing.assert_allclose(h["Volume_Loss"], dissolved / STEEL["Solid Concentration"], rtol=1e-8)
        np.testing.assert_allclose(depth, h["Volume_Loss"] / length, rtol=1e-8)
        year = 8760 * 3600e3  # in seconds, of millimetres
        np.testing.assert_allclose(h["Corrosion_Rate"][1:], front_speed(STEEL) * year, rtol=2e-3)
        np.testing.assert_allclose(h["Hydrogen_Gas"], amount / length * 24465.4e-4, rtol=2e-3)  # 24.4654 L/mol
        np.testing.assert_allclose(h["Front_Speed"][1:], np.diff(depth) / np.diff(h["time"]), rtol=1e-8)
        self.assertEqual(h["Front_Speed"][0], 0.0)
        np.testing.assert_allclose(h["Mean_Current_Density"], CURRENT, rtol=1e-8)
        np.testing.assert_allclose(h["Peak_Current_Density"], CURRENT, rtol=1e-8)
        np.testing.assert_allclose(h["Total_Current"], CURRENT * length, rtol=nearly)
        np.testing.assert_allclose(h["Current_PlaceX"], 0.5 * length, rtol=nearly)
        # Seen in the electrolyte within the dissolution range, half a horizon; points turn liquid a spacing at a time.
        front = front_speed(STEEL) * h["time"]
        behind = front - h["Current_PlaceY"]
        self.assertTrue(np.all((behind > 0.0) & (behind < 0.5 * HORIZON + SPACING)), behind)
        # The sides differ a little from the middle.
        np.testing.assert_allclose(h["Maximum_Depth"][1:], front[1:], rtol=1e-2)
        np.testing.assert_allclose(h["Pit_Width"][1:], length, rtol=1e-8)
        surface = (self.x[:, 1] > 0) & (self.x[:, 1] < SPACING)
        depth = result.field("Corrosion_Depth")
        np.testing.assert_allclose(depth[surface], front[-1], rtol=1e-2)
        self.assertTrue(np.all(depth[~surface] == 0.0))

    def test_a_round_pit(self):
        """A half circle of electrolyte whose radius grows by the speed of the front."""
        radius, time, centre = 6e-6, 40.0, 24.2e-6
        pit = f"(x - {centre!r})*(x - {centre!r}) + y*y"
        result = self.run_plate([48e-6, 20e-6], [0.0, 0.0], f"{pit} > {radius**2!r}", f"{pit} < 4e-12",
                                f"y < {SPACING}", time, 8)
        h = result.history()
        grown = front_speed(STEEL) * h["time"]
        # Below the surface it is deepest in the middle; most is eaten where the pit had its rim.
        np.testing.assert_allclose(h["Maximum_Depth"], radius + grown, atol=SPACING)
        rim = np.sqrt((radius + grown)**2 - radius**2)
        np.testing.assert_allclose(h["Deepest_PlaceY"][1:], rim[1:], atol=1.5 * SPACING)
        np.testing.assert_allclose(np.abs(h["Deepest_PlaceX"][1:] - centre), radius, atol=SPACING)
        np.testing.assert_allclose(h["Mouth_Width"][-1], 2.0 * (radius + grown[-1]), atol=3.0 * SPACING)
        self.assertLess(abs(h["Current_PlaceX"][-1] - centre), 0.25 * SPACING)
        # A pit of a horizon and a half, counted in whole points of electrolyte.
        ring = 0.5 * np.pi * ((radius + grown[-1])**2 - radius**2)
        self.assertAlmostEqual(h["Volume_Loss"][-1] / ring, 1.0, delta=0.1)
        np.testing.assert_allclose(h["Total_Current"], CURRENT * np.pi * (radius + grown), rtol=0.15)

    def test_ph_follows_the_concentration(self):
        """Where there is electrolyte, at the time of the output."""
        self.x = lattice([40e-6, 16e-6], SPACING, [0.0, -6e-6])
        self.volume = SPACING**2
        self.write_mesh(self.x, self.volume)
        metal = {**STEEL, "pH": "7.405*exp(-0.08036*C) - 6.498", "Current Density": "5.1e3 + 0*pH"}
        deck = corrosion_deck(2, metal, "y > 0", "y < -5.0e-6", 40.0, 4)
        deck["Output"]["Output Variables"].append("pH")
        deck["Compute Class Parameters"]["Lowest"] = {"Compute Class": "Field_Minimum", "Variable": "pH"}
        result = self.solve(deck)
        for step in result.steps():
            c, liquid = result.field("Concentration", step), result.field("Damage", step) >= 1.0
            ph = result.field("pH", step)
            expected = 7.405 * np.exp(-0.08036e-3 * c) - 6.498
            np.testing.assert_allclose(ph[liquid], expected[liquid], rtol=1e-9, err_msg=f"step {step}")
            self.assertTrue(np.all(np.isnan(ph[~liquid])))
            self.assertGreater(np.sum(~liquid), 0)
            lowest = result.history()["Field_Minimum"][step]
            self.assertAlmostEqual(lowest, np.min(expected[liquid]), delta=1e-9)
        self.assertLess(lowest, 0.8)


if __name__ == "__main__":
    unittest.main()
