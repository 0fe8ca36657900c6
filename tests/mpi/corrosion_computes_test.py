#!/usr/bin/python3
"""Losses, depths and currents on several ranks, and after a restart: the same histories."""
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from corrosion_scene import STEEL, CorrosionTest, corrosion_deck  # noqa: E402

METAL = {**STEEL, "Current Density": "5.1e3*(1.0 + C)"}
SURFACE = {"Node Set": "Surface Node Set", "Into Y": 1.0}
COMPUTES = {
    "Mass": {"Compute Class": "Mass_Loss", "Molar Mass": 0.05585},
    "Depth": {"Compute Class": "Corrosion_Depth", **SURFACE},
    "Binned": {"Compute Class": "Corrosion_Depth", **SURFACE, "Column Width": 3e-6, "Output Label": "Binned_Depth"},
    "Deepest": {"Compute Class": "Maximum_Depth", **SURFACE, "Measure": "Deepest"},
    "Mean": {"Compute Class": "Mean_Depth", **SURFACE},
    "Place": {"Compute Class": "Deepest_Place", **SURFACE},
    "Width": {"Compute Class": "Pit_Width", **SURFACE},
    "Speed": {"Compute Class": "Front_Speed", **SURFACE},
    "Rate": {"Compute Class": "Corrosion_Rate", "Over": "Last Interval"},
    "Gas": {"Compute Class": "Hydrogen_Gas"},
    "Since": {"Compute Class": "Relative_Volume_Loss", "First Scan": 6.0},
    "Wire": {"Compute Class": "Wire_Diameter", "First Diameter": 1e-5, "Slice Width": 1e-6, "Of": "Smallest"},
    "Pits": {"Compute Class": "Pit_Count", **SURFACE, "Deeper Than": 1e-6},
    "Pit Depth": {"Compute Class": "Pit_Depth", **SURFACE, "Deeper Than": 1e-6},
    "Mean Current": {"Compute Class": "Mean_Current_Density"},
    "Peak Current": {"Compute Class": "Peak_Current_Density"},
    "Peak Place": {"Compute Class": "Current_Place"},
    "Current": {"Compute Class": "Total_Current"},
}
HISTORIES = ("Corrosion_Rate", "Hydrogen_Gas", "Relative_Volume_Loss", "Wire_Diameter", "Pit_Count", "Pit_Depth",
             "Mass_Loss", "Maximum_Depth", "Mean_Depth", "Deepest_PlaceX", "Deepest_PlaceY", "Pit_Width", "Front_Speed",
             "Mean_Current_Density", "Peak_Current_Density", "Current_PlaceX", "Current_PlaceY", "Total_Current")


class Histories(CorrosionTest):
    def setUp(self):
        super().setUp()
        self.make_lattice([48e-6, 20e-6])

    def deck(self, time, steps, name):
        pit = "(x - 21.3e-6)*(x - 21.3e-6) + y*y"
        deck = corrosion_deck(2, METAL, f"{pit} > 3.6e-11", f"{pit} < 4e-12", time, steps, name)
        # Results of another order of summation differ by what the tolerance of the linear systems leaves.
        deck["Solver"]["Corrosion"]["Solver Tolerance"] = 1e-12
        deck["Boundary Conditions"]["Surface Node Set"] = {"Expression": "y < 1e-6"}
        deck["Compute Class Parameters"].update(COMPUTES)
        deck["Output"]["Output Variables"] += ["Corrosion_Depth", "Binned_Depth"]
        return deck

    def test_ranks(self):
        expected = self.solve(self.deck(20.0, 8, "one"))
        one = expected.history()
        self.assertGreater(one["Maximum_Depth"][-1], 3e-6)
        for ranks in (2, 4):
            found = self.solve(self.deck(20.0, 8, f"ranks{ranks}"), ranks=ranks)
            many = found.history()
            for label in HISTORIES:
                np.testing.assert_allclose(many[label], one[label], rtol=1e-8, atol=1e-8 * np.max(np.abs(one[label])),
                                           err_msg=f"{label}, {ranks} ranks")
            for label in ("Corrosion_Depth", "Binned_Depth"):
                np.testing.assert_allclose(found.field(label), expected.field(label), rtol=0.0, atol=1e-14)

    def test_far_field(self):
        def deck(name, time=20.0, steps=8):
            deck = self.deck(time, steps, name)
            conditions = deck["Boundary Conditions"]
            # The pit's electrolyte is open where it was held.
            conditions["Sea"] = {"Type": "Far Field Concentration", "Node Set": "Sea Node Set", "Value": "10*t",
                                 "Distance": 50e-6, "Diffusivity": STEEL["Diffusivity"], "Area": 4e-6}
            return deck

        expected = self.solve(deck("open"))
        self.check(expected, METAL)
        found = self.solve(deck("open2"), ranks=2)
        self.check(found, METAL)
        for label, scale in (("Concentration", STEEL["Solid Concentration"]), ("Damage", 1.0)):
            np.testing.assert_allclose(found.field(label), expected.field(label), rtol=0.0, atol=1e-10 * scale)
        half = deck("half", 10.0, 4)
        half["Output"]["Checkpoint Frequency"] = 4
        self.solve(half)
        rest = self.solve(deck("half"), arguments=["--restart", "half.checkpoint.h5"])
        np.testing.assert_array_equal(rest.field("Concentration", 8), expected.field("Concentration", 8))

    def test_restart(self):
        whole = self.solve(self.deck(20.0, 8, "whole")).history()
        half = self.deck(10.0, 4, "half")
        half["Output"]["Checkpoint Frequency"] = 4
        self.solve(half)
        rest = self.solve(self.deck(20.0, 8, "half"), arguments=["--restart", "half.checkpoint.h5"]).history()
        for label in HISTORIES:
            np.testing.assert_array_equal(rest[label], whole[label], label)

    def test_a_scan_after_the_end_is_told_of(self):
        late = self.run_deck(self.deck(5.0, 8, "late"), arguments=["--check"])
        self.assertEqual(late.code, 0, late.text)
        self.assertIn("Since/First Scan, 6 s, is not before the end of the run, 5 s", late.text)


if __name__ == "__main__":
    unittest.main()
