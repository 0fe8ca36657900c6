#!/usr/bin/python3
"""Scenes with breaking bonds on 1, 2 and 4 ranks: one answer; restarts, also of runs that were killed."""
import os
import signal
import subprocess
import sys
import time
import unittest

import h5py
import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import Result, SceneTest, lattice, plate_deck  # noqa: E402

LENGTH, WIDTH, SPACING, THICKNESS = 0.2, 0.1, 5e-3, 4e-3
HORIZON = 3.015 * SPACING
SATURATION = 2.65e-5
CRITICAL_STRETCH = 4e-3  # of the order of AISI 4340 at a horizon of 5 mm
# Results of another order of summation may differ by this share of a field's largest value, displacements also by what
# the rounding of coordinates (1e-16 of the length) makes of an equilibrium.
SAME = 1e-10
ROUND_OFF = 1e-13 * LENGTH

RELAXATION = {"Adaptive Dynamic Relaxation": {"Iterations Per Load Step": 1}}
NEWTON = {"QuasiStatic": {"Relative Tolerance": 1e-13}}


def hydrogen_plate(solver, final_time=1e6, pull=0.25 * CRITICAL_STRETCH * WIDTH, fields=("Concentration",), **output):
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


def dry(deck):
    """The same plate without hydrogen."""
    for name in ("Hydrogen On Lips", "Hydrogen On New Faces", "Lip Node Set"):
        del deck["Boundary Conditions"][name]
    deck["Damage Models"]["Breakage"] = {"Damage Model": "Critical Stretch", "Critical Stretch": CRITICAL_STRETCH}
    return deck


def verlet_plate(**output):
    # Pulled within 33 us, twice the time that a wave takes through the width.
    return dry(hydrogen_plate({"Verlet": {"Fixed dt": 4e-7}}, final_time=1e-4, pull=4 * CRITICAL_STRETCH * WIDTH,
                              fields=("Velocity",), **{"Output Frequency": 25, **output}))


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
            allowed = SAME * largest if label != "Displacement" else max(SAME * largest, ROUND_OFF)
            self.assertLess(np.max(np.abs(values - reference)), allowed, f"{what}: {label} at step {step}")


class Ranks(PlateTest):
    """Fields on 1, 2 and 4 ranks, with at least `least_broken` directed bonds broken in the run."""

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
        self.compare(hydrogen_plate(staggered(8, {"Method": "RKL"}, NEWTON), **{"Output Frequency": 2}),
                     ["Displacement", "Damage", "Concentration"], 20)

    def test_quasi_static_plate(self):
        deck = hydrogen_plate({"QuasiStatic": {**NEWTON["QuasiStatic"], "Load Steps": 6}}, fields=(),
                              **{"Output Frequency": 1})
        self.compare(dry(deck), ["Displacement", "Damage"], 20)

    def test_verlet_plate(self):
        self.compare(verlet_plate(), ["Displacement", "Velocity", "Damage"], 20)


class Restarts(PlateTest):
    """A run is killed once it has written a checkpoint, and goes on from there."""

    def kill_one_rank(self, process, ranks):
        pid = process.pid
        if ranks > 1:
            with open(f"/proc/{pid}/task/{pid}/children") as file:
                pid = int(file.read().split()[-1])
        os.kill(pid, signal.SIGKILL)

    def run_until_killed(self, deck, ranks, delay):
        checkpoint = self.path("result.checkpoint.h5")
        process = subprocess.Popen(self.prepare(deck, ranks=ranks), cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 120
        while not os.path.exists(checkpoint) and process.poll() is None and time.monotonic() < deadline:
            time.sleep(1e-3)
        time.sleep(delay)
        self.assertIsNone(process.poll(), "the run ended before it could be killed")
        self.kill_one_rank(process, ranks)
        self.assertNotEqual(process.wait(timeout=60), 0)
        self.assertFalse(os.path.exists(self.path("result.report.json")))

    def check(self, deck, fields, ranks=1, ranks_after=None, delay=0.0):
        whole = {**deck, "Output": {**deck["Output"], "Output Filename": "whole"}}
        expected = self.solve(whole, ranks=ranks)
        self.run_until_killed(deck, ranks, delay)
        readable = Result(self.folder, "result", subprocess.CompletedProcess([], 0, "", "")).steps()
        self.assertGreater(len(readable), 0)
        found = self.solve(deck, ranks=ranks_after or ranks, arguments=["--restart", "result.checkpoint.h5"])
        self.assertEqual(found.steps(), expected.steps())
        if ranks_after:
            self.assert_same(self.read(found, fields), self.read(expected, fields), f"{ranks}, then {ranks_after} ranks")
            return
        for step in expected.steps():
            for label in fields:
                np.testing.assert_array_equal(found.field(label, step), expected.field(label, step),
                                              f"{label} at step {step}")
        for name, values in expected.history().items():
            np.testing.assert_array_equal(found.history()[name], values, name)

    def plate(self, diffusion="Euler", mechanics=None):
        diffusion = {"Method": "Euler", "Sub Steps": 20} if diffusion == "Euler" else {"Method": diffusion}
        return hydrogen_plate(staggered(400, diffusion, mechanics or RELAXATION),
                              **{"Output Frequency": 20, "Checkpoint Frequency": 20})

    def test_hydrogen_plate_goes_on_to_the_last_bit(self):
        self.check(self.plate(), ["Displacement", "Damage", "Concentration"])

    def test_hydrogen_plate_on_two_ranks_goes_on_to_the_last_bit(self):
        self.check(self.plate(), ["Displacement", "Damage", "Concentration"], ranks=2)

    def test_hydrogen_plate_of_two_ranks_goes_on_on_one(self):
        self.check(self.plate(), ["Displacement", "Damage", "Concentration"], ranks=2, ranks_after=1)

    def test_relaxation_of_one_rank_goes_on_on_two(self):
        # Everything is in the checkpoint: on the same rank it goes on to the last bit (above), and on two ranks it ends
        # no further away than a run on two ranks that was never interrupted. What is left is the order of sums over ranks.
        # Forces and velocities show more of it than displacements do, in proportion: a change of displacements by du
        # changes a force density by no more than the absolute row sum of the stiffness over the volume, which is
        # 4 / 1.21 of the relaxation's mass, times du (Gershgorin); a velocity is the difference of two displacements.
        deck = self.plate()
        for name, ranks in (("whole", 1), ("two_ranks", 2)):
            self.solve({**deck, "Output": {**deck["Output"], "Output Filename": name}}, ranks=ranks)
        expected, uninterrupted = self.checkpoint("whole"), self.checkpoint("two_ranks")
        self.run_until_killed(deck, 1, 0.0)
        self.solve(deck, ranks=2, arguments=["--restart", "result.checkpoint.h5"])
        restarted = self.checkpoint("result")

        change = 0.1 * ROUND_OFF  # measured: 2e-16 m, one rounding of the longest coordinate, after 400 load steps
        stiffness = 4 / 1.21 * np.max(expected["Relaxation_Mass"])
        bounds = {"Displacement": change, "Force_Density": stiffness * change, "Relaxation_Velocity": 2 * change,
                  "Relaxation_Acceleration": 4 / 1.21 * change}
        for label, bound in bounds.items():
            for found in (uninterrupted, restarted):
                self.assertLess(np.max(np.abs(found[label] - expected[label])), bound, label)
        np.testing.assert_array_equal(restarted["Damage"], expected["Damage"])
        np.testing.assert_allclose(restarted["Relaxation_Mass"], expected["Relaxation_Mass"], rtol=1e-14)

    def checkpoint(self, name):
        """Fields of points in the last checkpoint of a run."""
        with h5py.File(self.path(name + ".checkpoint.h5")) as file:
            return {label: np.array(values) for label, values in file["points"].items()}

    def test_error_controlled_diffusion_goes_on_to_the_last_bit(self):
        self.check(self.plate("RKL"), ["Displacement", "Damage", "Concentration"], delay=0.05)

    def test_quasi_static_plate_goes_on_to_the_last_bit(self):
        deck = dry(hydrogen_plate({"QuasiStatic": {**NEWTON["QuasiStatic"], "Load Steps": 20}}, fields=(),
                                  **{"Output Frequency": 2, "Checkpoint Frequency": 2}))
        self.check(deck, ["Displacement", "Damage"])

    def test_verlet_plate_goes_on_to_the_last_bit(self):
        deck = verlet_plate(**{"Checkpoint Frequency": 10})
        self.check(deck, ["Displacement", "Velocity", "Damage"], delay=0.01)


if __name__ == "__main__":
    unittest.main()
