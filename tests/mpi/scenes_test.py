#!/usr/bin/python3
"""Scenes with breaking bonds on 1, 2 and 4 ranks: one answer; restarts, also of runs that were killed."""
import os
import signal
import subprocess
import sys
import time
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import Result, SceneTest, lattice, pdrun_path, plate_deck, yaml  # noqa: E402

LENGTH, WIDTH, SPACING, THICKNESS = 0.2, 0.1, 5e-3, 4e-3
HORIZON = 3.015 * SPACING
SATURATION = 2.65e-5
CRITICAL_STRETCH = 4e-3  # of the order of AISI 4340 at a horizon of 5 mm
# Of a field's largest value: results of another order of summation may differ by no more.
SAME = 1e-10

RELAXATION = {"Adaptive Dynamic Relaxation": {"Iterations Per Load Step": 1}}
NEWTON = {"QuasiStatic": {"Relative Tolerance": 1e-13}}


def hydrogen_plate(solver, final_time=6e6, pull=1.2 * CRITICAL_STRETCH * WIDTH / 2, fields=("Concentration",), **output):
    """The hydrogen plate, coarse: an edge crack of a quarter of the plate, hydrogen on its lips, top and bottom pulled
    apart within the first third of the time."""
    ramp = f"{pull!r}*min(3*t/{final_time!r}, 1)"
    deck = plate_deck(
        HORIZON, THICKNESS, {"Young's Modulus": 207e9, "Poisson's Ratio": 0.29, "Density": 7850.0,
                             "Diffusivity": 0.84e-9, "Surface Correction": "Volume Method"},
        {"Damage Model": "Hydrogen Critical Stretch", "Critical Stretch": CRITICAL_STRETCH,
         "Saturation Concentration": SATURATION},
        {"Top Node Set": {"Expression": f"y > {WIDTH - 2 * SPACING}"},
         "Bottom Node Set": {"Expression": f"y < {2 * SPACING}"},
         "Grip Node Set": {"Expression": f"y < {2 * SPACING} || y > {WIDTH - 2 * SPACING}"},
         "Lip Node Set": {"Expression": f"x < {LENGTH / 4} && abs(y - {WIDTH / 2}) < {SPACING}"},
         "Corner Node Set": {"Expression": f"x < {SPACING} && y < {SPACING}"},
         "Pull Top": {"Type": "Prescribed Displacement", "Node Set": "Top Node Set", "Coordinate": "y", "Value": ramp},
         "Pull Bottom": {"Type": "Prescribed Displacement", "Node Set": "Bottom Node Set", "Coordinate": "y",
                         "Value": "-" + ramp},
         "Hold Corner": {"Type": "Prescribed Displacement", "Node Set": "Corner Node Set", "Coordinate": "x",
                         "Value": 0.0},
         "Hydrogen On Lips": {"Type": "Prescribed Concentration", "Node Set": "Lip Node Set", "Value": SATURATION},
         "Hydrogen On New Faces": {"Type": "Saturated Crack Faces", "Field": "Concentration", "Value": SATURATION,
                                   "Threshold": 0.36},
         "Grips Do Not Break": {"Type": "No Failure", "Node Set": "Grip Node Set"}},
        {"Final Time": final_time, **solver},
        {"Output Variables": ["Displacement", "Damage", *fields, "Broken", "Pull"], "Output Frequency": 10, **output},
        Compute_Class_Parameters={"Broken": {"Compute Class": "Broken_Bonds", "Output Label": "Broken"},
                                  "Pull": {"Compute Class": "Reaction_Force", "Node Set": "Top Node Set",
                                           "Output Label": "Pull"}})
    deck["Discretization"]["Bond Filters"] = {
        "Crack": {"Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0,
                  "Lower_Left_Corner_X": -SPACING, "Lower_Left_Corner_Y": WIDTH / 2, "Lower_Left_Corner_Z": -1.0,
                  "Bottom_Unit_Vector_X": 1.0, "Bottom_Unit_Vector_Y": 0.0, "Bottom_Unit_Vector_Z": 0.0,
                  "Bottom_Length": LENGTH / 4 + SPACING, "Side_Length": 2.0, "Count In Damage": True}}
    return deck


def staggered(load_steps, diffusion, mechanics):
    return {"Staggered": {"Load Steps": load_steps, "Diffusion": diffusion, "Mechanics": mechanics}}


class PlateTest(SceneTest):
    def setUp(self):
        super().setUp()
        self.write_mesh(lattice([LENGTH, WIDTH], SPACING), SPACING**2 * THICKNESS)

    def read(self, result, labels):
        return {(label, step): result.field(label, step) for step in result.steps() for label in labels}

    def assert_same(self, fields, expected, what):
        self.assertEqual(fields.keys(), expected.keys())
        for (label, step), values in fields.items():
            reference = expected[label, step]
            if label == "Damage":
                np.testing.assert_array_equal(values, reference, f"{what}: Damage at step {step}")
                continue
            largest = max(np.max(np.abs(v)) for (name, _), v in expected.items() if name == label)
            difference = np.max(np.abs(values - reference)) / largest
            self.assertLess(difference, SAME, f"{what}: {label} at step {step}")


class Ranks(PlateTest):
    def compare(self, deck, fields, least_broken):
        expected = None
        for ranks in (1, 2, 4):
            result = self.solve(deck, ranks=ranks)
            found, history = self.read(result, fields), result.history()
            if expected is None:
                expected, first = found, history
                self.assertGreater(history["Broken"][-1] - history["Broken"][0], least_broken)
                continue
            self.assert_same(found, expected, f"{ranks} ranks")
            np.testing.assert_array_equal(history["Broken"], first["Broken"])
            pull = next(name for name in first if name.startswith("Pull") and "y" in name.lower())
            np.testing.assert_allclose(history[pull], first[pull], rtol=0, atol=1e-9 * np.max(np.abs(first[pull])))

    def test_hydrogen_plate_as_in_the_seed(self):
        self.compare(hydrogen_plate(staggered(60, {"Method": "Euler", "Sub Steps": 20}, RELAXATION)),
                     ["Displacement", "Damage", "Concentration"], 20)

    def test_hydrogen_plate_with_error_control_and_newton(self):
        self.compare(hydrogen_plate(staggered(12, {"Method": "RKL", "Relative Tolerance": 1e-4}, NEWTON),
                                    **{"Output Frequency": 2}),
                     ["Displacement", "Damage", "Concentration"], 20)

    def test_quasi_static_plate(self):
        deck = hydrogen_plate({"QuasiStatic": {**NEWTON["QuasiStatic"], "Load Steps": 12}}, fields=(),
                              **{"Output Frequency": 2})
        for name in ("Hydrogen On Lips", "Hydrogen On New Faces", "Lip Node Set"):
            del deck["Boundary Conditions"][name]
        deck["Damage Models"]["Breakage"] = {"Damage Model": "Critical Stretch", "Critical Stretch": CRITICAL_STRETCH}
        self.compare(deck, ["Displacement", "Damage"], 20)

    def test_verlet_plate(self):
        # Pulled within 33 us, twice the time that a wave takes through the width.
        deck = hydrogen_plate({"Verlet": {"Fixed dt": 4e-7}}, final_time=1e-4, pull=4 * CRITICAL_STRETCH * WIDTH,
                              fields=("Velocity",), **{"Output Frequency": 25})
        for name in ("Hydrogen On Lips", "Hydrogen On New Faces", "Lip Node Set"):
            del deck["Boundary Conditions"][name]
        deck["Damage Models"]["Breakage"] = {"Damage Model": "Critical Stretch", "Critical Stretch": CRITICAL_STRETCH}
        self.compare(deck, ["Displacement", "Velocity", "Damage"], 20)


if __name__ == "__main__":
    unittest.main()
