#!/usr/bin/python3
"""Runs that go on from the time of a checkpoint: with the deck that wrote it or another, and what is refused."""
import shutil
import sys
import unittest

import h5py
import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from restart_scene import (CASES, EARLY, LENGTH, OTHER_LENGTHS, OTHER_SHAPES, SPACING, STEPS, THICKNESS,  # noqa: E402
                           RestartTest)
from scene import lattice  # noqa: E402


class Matrix(RestartTest):
    """Each solver with each change of the deck."""

    def check(self, *cases):
        for case in cases:
            with self.subTest(case):
                deck, expected = self.start(case)
                self.go_on_with_the_same_deck(case, deck, expected)
                self.go_on_with_other_steps(case, expected)
                self.go_on_for_longer(case)

    def go_on_with_the_same_deck(self, case, deck, expected):
        result = self.go_on(deck)
        self.assert_same(self.last(result, case), expected, case)
        np.testing.assert_array_equal(self.times(result), self.whole_times)
        self.assertTrue(self.whole_steps)
        self.assertEqual(self.steps_reported(result), self.whole_steps)
        self.assertIn("those since the start", " ".join(result.report["solver"]))
        self.assertNotIn("the deck is not the one", self.log())

    def go_on_with_other_steps(self, case, expected):
        # The checkpoint of half the time lies within an increment of the new deck.
        result = self.go_on(self.make(case, 5))
        times = self.times(result)
        np.testing.assert_allclose(times[EARLY:], times[EARLY] * np.array([1.0, 1.2, 1.6, 2.0]), rtol=1e-14)
        self.assert_close(self.last(result, case), expected, CASES[case][1], case)

    def go_on_for_longer(self, case):
        shutil.copy(self.path("early.checkpoint.h5"), self.path("first.h5"))
        deck = self.make(case, 2 * STEPS, 2.0)
        expected = self.last(self.solve(deck), case)
        result = self.go_on(deck, "first.h5")
        self.assert_same(self.last(result, case), expected, case)
        self.assertEqual(len(self.times(result)), 2 * STEPS + 1)
        self.assertIn("Solver/Final Time is", self.log())

    def test_mechanics(self):
        self.check("Verlet", "QuasiStatic", "Adaptive Dynamic Relaxation")

    def test_explicit_diffusion(self):
        self.check("Euler", "RKL")

    def test_implicit_diffusion(self):
        self.check("Implicit Euler", "TR-BDF2", "ImplicitDiffusion")

    def test_several_physics(self):
        self.check("Corrosion", "Staggered", "Staggered list")

    def test_half_the_time_step(self):
        _, expected = self.start("Verlet")
        result = self.go_on(self.make("Verlet", 2 * STEPS))
        times = self.times(result)
        np.testing.assert_allclose(np.diff(times)[EARLY:], times[EARLY] / (2 * EARLY), rtol=1e-9)
        self.assertEqual(len(times), EARLY + 1 + STEPS)
        self.assert_close(self.last(result, "Verlet"), expected, CASES["Verlet"][1], "half the step")

    def test_shorter_fixed_steps_of_corrosion(self):
        deck = self.make("Corrosion")
        deck["Solver"]["Corrosion"]["Fixed dt"] = deck["Solver"]["Final Time"] / 8
        self.solve(deck)
        before = deck["Solver"]["Corrosion"]["Fixed dt"]
        deck["Solver"]["Corrosion"]["Fixed dt"] /= 4
        result = self.go_on(deck)
        self.assertIn(f"{4 + 4 * 4} steps of {before / 4:.3g} to {before:.3g} s", " ".join(result.report["solver"]))

    def test_another_material(self):
        # What was estimated of the old one does not hold: 16 times as stiff, or as diffusive, is unstable otherwise.
        for case, key, field in (("Verlet", "Young's Modulus", "Displacement"), ("Euler", "Diffusivity", "Concentration"),
                                 ("Adaptive Dynamic Relaxation", "Young's Modulus", "Displacement")):
            with self.subTest(case):
                deck = self.make(case)
                longer = 50.0 if case == "Verlet" else 1.0  # of which a stale step of Verlet takes dozens
                if case == "Verlet":
                    deck["Solver"]["Verlet"] = {}
                    deck["Solver"]["Final Time"] *= longer
                expected = self.last(self.solve(deck), case)[field]
                deck["Materials"]["Steel"][key] *= 16.0
                found = self.last(self.go_on(deck), case)[field]
                self.assertIn(f"Materials/Steel/{key} is", self.log())
                self.assertLess(np.max(np.abs(found)), 2.0 * np.max(np.abs(expected)))


    def test_what_the_deck_says_of_a_material_is_that_of_the_new_deck(self):
        deck = self.make("Corrosion")
        deck["Output"]["Output Variables"].append("Saturation_Concentration")
        self.solve(deck)
        deck["Materials"]["Metal"]["Saturation Concentration"] = 2e4
        result = self.go_on(deck)
        np.testing.assert_array_equal(result.field("Saturation_Concentration"), 2e4)
        self.assertGreater(np.max(result.field("Concentration")[result.field("Damage") >= 1.0]), 4600.0)


class Stages(RestartTest):
    """Several Solver sections."""

    def test_a_new_stage_after_the_end(self):
        # Pulled in equilibrium, then let go on by itself: another solver begins where the checkpoint ends.
        first = self.make("QuasiStatic", **{"Checkpoint Frequency": 1})
        whole = {**first, "Solver2": {"Initial Time": 1.0, "Final Time": 2.0,
                                      "Adaptive Dynamic Relaxation": {"Load Steps": 3, "Relative Tolerance": 1e-9}}}
        expected = self.last(self.solve(whole), "QuasiStatic")
        self.solve(first)
        result = self.go_on(whole, "result.checkpoint.h5")
        self.assert_same(self.last(result, "QuasiStatic"), expected, "second stage")
        np.testing.assert_allclose(self.times(result)[STEPS:], [1.0, 4 / 3, 5 / 3, 2.0], rtol=1e-15)

    def test_within_the_second_stage(self):
        deck = self.make("RKL")
        for section, start, end in (("Solver", 0.0, 0.25), ("Solver2", 0.25, 1.0)):
            deck[section] = {"Initial Time": start, "Final Time": end, "Diffusion": {"Load Steps": 3, "Method": "RKL"}}
        expected = self.last(self.solve(deck), "RKL")
        result = self.go_on(deck)
        self.assert_same(self.last(result, "RKL"), expected, "second stage")
        said = [line for line in result.report["solver"] if line.startswith("Diffusion")]
        self.assertEqual(len(said), 1, said)  # the first solver has done nothing in this run


class Refusals(RestartTest):
    def test_times(self):
        deck, _ = self.start("RKL")
        deck["Solver"]["Final Time"] = 0.5
        self.refused(deck, "nothing is left to run", "later Final Time")
        deck["Solver"].update({"Initial Time": 0.75, "Final Time": 2.0})
        self.refused(deck, "before the Initial Time of Solver, 0.75 s")

    def test_another_solver_or_method(self):
        self.start("QuasiStatic")
        self.refused(self.make("Adaptive Dynamic Relaxation"), 'was written by the solver "QuasiStatic"',
                     'has "Adaptive Dynamic Relaxation"', "a section of its own that begins there")
        self.start("RKL")
        self.refused(self.make("Euler"), "another kind of state", "RKL/proposed step", "Euler/largest eigenvalue")
        self.start("Staggered")
        self.refused(self.make("Staggered list"), "another kind of state", "Hydrogen/", "Mechanics/")

    def test_a_check_says_what_a_restart_would_refuse(self):
        def check(deck, *words, code=2):
            result = self.run_deck(deck, arguments=["--check", "--restart", "early.checkpoint.h5"])
            self.assertEqual(result.code, code, result.text)
            for word in words:
                self.assertIn(word, result.text)
        deck, _ = self.start("RKL")
        check(deck, "going on from step 4 (t = 0.5 s)", "no mistakes found", code=0)
        self.assertEqual(len(self.times(self.go_on(deck))), STEPS + 1)  # the check has left all as it was
        check(self.make("Euler"), "another kind of state")
        deck["Solver"]["Final Time"] = 0.5
        check(deck, "nothing is left to run")

    def test_another_mesh(self):
        deck, _ = self.start("RKL")
        self.write_mesh(lattice([LENGTH, LENGTH / 2], SPACING), 2 * SPACING**2 * THICKNESS)
        self.refused(deck, "another mesh")
        self.write_mesh(lattice([LENGTH, LENGTH / 2], SPACING), SPACING**2 * THICKNESS)
        deck["Blocks"]["Body"]["Horizon"] *= 0.7
        self.refused(deck, "other neighbourhoods")

    def test_other_cracks_and_voids(self):
        crack = {"Edge": {"Type": "Polyline", "Points": [-1.0, 0.4 * LENGTH / 2, 0.3 * LENGTH, 0.4 * LENGTH / 2]}}

        def deck_with(cracks, **more):
            deck = self.make("QuasiStatic")
            deck["Discretization"].update({**({"Cracks": cracks} if cracks else {}), **more})
            return deck
        deck = deck_with(crack)
        expected = self.last(self.solve(deck), "QuasiStatic")
        self.assert_same(self.last(self.go_on(deck), "QuasiStatic"), expected, "the same cracks")
        shifted = {"Edge": {**crack["Edge"], "Points": [*crack["Edge"]["Points"][:2], 0.32 * LENGTH, 0.4 * LENGTH / 2]}}
        for other in (deck_with(shifted), deck_with(crack, **{"Bond Decomposition": {"Rule": "Uniform", "Partitions": 3}}),
                      deck_with(crack, **{"Bond Decomposition": {"Cracks Count In Damage": False}})):
            self.refused(other, "other ", "Cracks", "Voids")
        # One whose tip takes parts of bonds, and no bond as a whole.
        self.solve(deck_with(None))
        tip = {"Tip": {"Type": "Polyline", "Points": [0.5 * LENGTH, 0.41 * LENGTH / 2, 0.502 * LENGTH, 0.41 * LENGTH / 2]}}
        self.refused(deck_with(tip), "other shares of bonds and cells", "Cracks, Voids or Bond Decomposition")
        self.solve(deck_with(tip))
        self.refused(deck_with(None), "other shares of bonds and cells")

    def test_what_is_missing(self):
        deck, _ = self.start("QuasiStatic")
        for table in ("points/Displacement", "points/Displacement_Increment", "points/Volume", "solver/state",
                      "solver/names", "bonds/neighbor", "deck"):
            def remove(file, name=table):
                del file[name]
            self.changed(remove)
            self.refused(deck, table.split("/")[-1], checkpoint="changed.h5")
        self.changed(lambda file: file.attrs.__delitem__("checkpoint"))
        self.refused(deck, "is no checkpoint", checkpoint="changed.h5")

    def test_tables_of_another_shape_or_kind(self):
        deck, _ = self.start("QuasiStatic")
        self.check_tables(deck, [*OTHER_SHAPES, *OTHER_LENGTHS])

        def grow(file):
            del file["points/Displacement"]
            file.create_dataset("points/Displacement", shape=(2**50, 3), chunks=(2**10, 3), dtype="f8")
        self.changed(grow)
        self.refused(deck, "which the file does not hold", checkpoint="changed.h5")

    def test_values_that_no_run_has(self):
        deck = self.make("QuasiStatic")
        deck["Damage Models"] = {"Breakage": {"Damage Model": "Critical Stretch", "Critical Stretch": 1.0}}
        deck["Blocks"]["Body"]["Damage Model"] = "Breakage"
        self.solve(deck)

        def setting(name, value):
            def change(file):
                values = np.array(file[name])
                values.flat[0] = value
                file[name][...] = values
            return change

        for change, word in ((setting("points/Damage", 5.0), "values of Damage that are not from 0 to 1"),
                             (setting("bonds/Bond_Damage", -1.0), "values of Bond_Damage that are not from 0 to 1"),
                             (setting("points/Volume", 0.0), "another mesh"),
                             (lambda file: file.attrs.modify("time", np.inf), "t = inf"),
                             (lambda file: file.attrs.modify("step", np.int64(-3)), "step -3")):
            self.changed(change)
            self.refused(deck, word, checkpoint="changed.h5")

    def test_what_is_damaged(self):
        deck, _ = self.start("QuasiStatic")
        with open(self.path("early.checkpoint.h5"), "rb") as file:
            content = bytearray(file.read())
        with h5py.File(self.path("early.checkpoint.h5")) as file:
            values = np.array(file["points/Displacement"])
        at = bytes(content).find(values[-1].tobytes())
        self.assertGreater(at, 0)
        content[at + 3] ^= 1
        with open(self.path("flipped.h5"), "wb") as file:
            file.write(content)
        self.refused(deck, "read table", "checksum", checkpoint="flipped.h5")
        with open(self.path("cut.h5"), "wb") as file:
            file.write(content[:len(content) // 2])
        self.refused(deck, "truncated", checkpoint="cut.h5")

    def test_a_field_of_conditions_that_are_new(self):
        deck, _ = self.start("QuasiStatic")
        deck["Damage Models"] = {"Breakage": {"Damage Model": "Critical Stretch", "Critical Stretch": 1.0}}
        deck["Blocks"]["Body"]["Damage Model"] = "Breakage"
        self.refused(deck, "lacks", "Damage", "materials, damage models and solvers of the run that wrote it")


if __name__ == "__main__":
    unittest.main()
