#!/usr/bin/python3
"""Fatigue with a Tip Window against the same without: the same bonds fail in the same order after the same cycles."""
import sys
import unittest

import numpy as np

sys.path[:0] = [sys.path[0] + "/../support", sys.path[0] + "/../../decks/fracture_energy"]
sys.dont_write_bytecode = True
from cracked_plate import CRACK, HEIGHT, SPACING, THICKNESS, cracked_plate  # noqa: E402
from lattices import lattice_points  # noqa: E402
from scene import SceneTest, lattice  # noqa: E402

WIDTH = 110e-3  # more points than a window has
LONG = 340e-3  # more than a corridor has


def used(result):
    """(equilibria in windows, windows) of a run."""
    line = next(line for line in result.report["solver"] if "around the tip" in line)
    words = line.split()
    return int(words[1]), int(words[5])


class TipWindow(SceneTest):
    def deck(self, solver=None, columns=3.2, width=WIDTH, **more):
        deck = cracked_plate(self, width=width, solver={
            "Stop When": {"Value": "Length", "Reaches": CRACK + columns * SPACING}, "Kinematics": "Small Strain",
            "Tip Window": True, **(solver or {})}, **more)
        del deck["Solver"]["Fatigue"]["Preconditioner"]
        return deck

    def compare(self, deck, labels=("Length",), tolerance=3e-6, share=0.8):
        """Results with the window, after a look at those without."""
        with_window = self.solve(deck)
        history, damage, first, moved = (with_window.history(), *(with_window.field(label) for label in (
            "Damage", "Cycles_To_First_Break", "Displacement")))
        n_found, _ = used(with_window)
        self.assertGreater(n_found, share * len(history["time"]))
        del deck["Solver"]["Fatigue"]["Tip Window"]
        without = self.solve(deck)
        expected = without.history()
        np.testing.assert_array_equal(history["Length"], expected["Length"])
        for label in ("time", *labels):
            np.testing.assert_allclose(history[label], expected[label], rtol=tolerance, err_msg=label)
        np.testing.assert_array_equal(damage, without.field("Damage"))
        np.testing.assert_allclose(first, without.field("Cycles_To_First_Break"), rtol=tolerance)
        there = without.field("Displacement")
        np.testing.assert_allclose(moved, there, rtol=0.0, atol=tolerance * np.abs(there).max())
        return with_window

    def test_the_same_bonds_fail_on_any_lattice(self):
        square = lattice([WIDTH, HEIGHT], SPACING, origin=[0.0, -HEIGHT / 2])
        jittered = square.copy()
        jittered[:, :2] += SPACING * np.random.default_rng(3).uniform(-0.2, 0.2, (len(square), 2))
        turned, triangles = (lattice_points((0.0, -HEIGHT / 2), (WIDTH, HEIGHT / 2), name, 3 * SPACING, THICKNESS)[0]
                             for name in ("turned_20", "triangles"))
        turned, triangles = (np.column_stack([points, 0 * points[:, 0]]) for points in (turned, triangles))
        for name, points in (("square", square), ("jittered", jittered), ("turned", turned), ("triangles", triangles)):
            with self.subTest(name):
                self.compare(self.deck(points=points))

    def test_a_body_that_is_turned_is_the_same(self):
        # Its crack grows along no axis: windows and corridors are boxes along it.
        points = lattice([WIDTH, HEIGHT], SPACING, origin=[0.0, -HEIGHT / 2])
        times = [self.compare(self.deck(points=points)).history()["time"]]
        c, s = np.cos(np.radians(30.0)), np.sin(np.radians(30.0))
        turned = points.copy()
        turned[:, :2] = points[:, :2] @ [[c, s], [-s, c]]
        deck = self.deck(points=turned)
        grip, above = HEIGHT / 2 - 3 * SPACING, f"{c!r}*y - {s!r}*x"
        hold = {"Type": "Prescribed Displacement"}
        deck["Boundary Conditions"] = {
            "Top Node Set": {"Expression": f"{above} > {grip}"}, "Bottom Node Set": {"Expression": f"{above} < -{grip}"},
            **{f"{side} {axis}": {**hold, "Node Set": side + " Node Set", "Coordinate": axis, "Value": sign * value}
               for side, sign in (("Top", 1e-5), ("Bottom", -1e-5)) for axis, value in (("x", -s), ("y", c))}}
        deck["Discretization"]["Bond Filters"]["Crack"].update({
            "Normal_X": -s, "Normal_Y": c, "Lower_Left_Corner_X": -c, "Lower_Left_Corner_Y": -s,
            "Bottom_Unit_Vector_X": c, "Bottom_Unit_Vector_Y": s})
        deck["Compute Class Parameters"]["Length"].update({"Direction X": c, "Direction Y": s})
        times.append(self.compare(deck).history()["time"])
        np.testing.assert_allclose(*times, rtol=3e-6)

    def test_loads_follow_the_crack(self):
        deck = self.deck({"Load Ratio": 0.1, "Stress Intensity": {
            "Energy Release Rate": "J", "Effective Modulus": 200e9, "Range": 10e6}})
        deck["Compute Class Parameters"] = {
            "Tip": {"Compute Class": "Crack_Tip", "Start X": 0.0, "Start Y": 0.0, "Output Label": "Tip"},
            **deck["Compute Class Parameters"],
            "J": {"Compute Class": "Nonlocal_J_Integral", "Thickness": THICKNESS, "Tip Field": "Tip", "Ahead": 4e-3,
                  "Behind": 4e-3, "Above": 4e-3, "Output Label": "J"}}
        deck["Output"]["Output Variables"] += ["J", "Peak_Load", "Stress_Intensity_Range"]
        self.compare(deck, ("J", "Peak_Load", "Stress_Intensity_Range"))

    def test_computes_that_look_everywhere_see_equilibria_of_the_whole_body(self):
        deck = self.deck(columns=1.2)
        deck["Compute Class Parameters"]["Energy"] = {"Compute Class": "Strain_Energy", "Output Label": "Energy"}
        deck["Output"]["Output Variables"].append("Energy")
        self.compare(deck, ("Energy",))

    def test_the_end_of_a_body_that_carries_nothing_is_seen(self):
        deck = self.deck(crack=WIDTH - 8e-3)
        del deck["Solver"]["Fatigue"]["Stop When"]
        ends = []
        for window in (True, False):
            deck["Solver"]["Fatigue"]["Tip Window"] = window
            result = self.solve(deck)
            self.assertIn("come apart", " ".join(result.report["solver"]))
            ends.append(result.history()["time"][-1])
        self.assertAlmostEqual(ends[0] / ends[1], 1.0, delta=1e-3)

    def test_lives_outside_are_off_by_no_more_than_it_says(self):
        points = lattice([WIDTH, HEIGHT], SPACING, origin=[0.0, -HEIGHT / 2])
        points = points[np.hypot(points[:, 0] - 17e-3, points[:, 1]) > 3.1e-3]
        deck = self.deck(points=points, columns=13.2, damage={"Initiation Coefficient": 2e2, "Initiation Exponent": 3.0})
        result = self.solve(deck)
        line = next(line for line in result.report["solver"] if "around the tip" in line)
        stated = float(line.split("are off by ")[1].split()[0])
        first = result.field("Cycles_To_First_Break")
        del deck["Solver"]["Fatigue"]["Tip Window"]
        exact = self.solve(deck).field("Cycles_To_First_Break")
        broken = (exact > 0) & (first > 0)
        self.assertLess(np.max(np.abs(first - exact)[broken] / exact[broken]), stated + 1e-5)
        self.assertLess(stated, 1.0)

    def test_of_a_corridor_that_is_a_part_of_the_body_the_same_bonds_fail(self):
        self.compare(self.deck(width=LONG, columns=2.2))

    def test_what_a_corridor_leaves_may_be_held_in_place(self):
        deck = self.deck(width=0.29, columns=1.2)
        deck["Boundary Conditions"] |= {
            "End Node Set": {"Expression": "x > 0.25"},
            **{f"End {axis}": {"Type": "Prescribed Displacement", "Node Set": "End Node Set", "Coordinate": axis,
                               "Value": 0.0} for axis in "xy"},
            "Top Node Set": {"Expression": "y > 6e-3 && x < 0.25"}, "Bottom Node Set": {"Expression": "y < -6e-3 && x < 0.25"},
            "Grips Node Set": {"Expression": "abs(y) > 6e-3 && x < 0.25"}}
        self.compare(deck)

    def test_what_is_next_to_singular_has_no_windows(self):
        # The plate between the forces is held through a block of next to no stiffness alone.
        deck = self.deck(width=40e-3, columns=2.2)
        points = lattice([40e-3, HEIGHT], SPACING, origin=[0.0, -HEIGHT / 2])
        self.write_mesh(points, SPACING**2 * THICKNESS, 1 + (points[:, 0] > 30e-3))
        deck["Materials"]["Soft"] = {**deck["Materials"]["Steel"], "Young's Modulus": 0.02}
        deck["Blocks"]["Other"] = {**deck["Blocks"]["Body"], "Block Names": "block_2", "Material": "Soft"}
        conditions = deck["Boundary Conditions"]
        for name, sign in (("Up", 1.0), ("Down", -1.0)):
            conditions[name] = {"Type": "Force", "Node Set": conditions[name]["Node Set"], "Coordinate": "y",
                                "Value": 200.0 * sign}
        conditions |= {"Top Node Set": {"Expression": "y > 8e-3 && x < 0.02"},
                       "Bottom Node Set": {"Expression": "y < -8e-3 && x < 0.02"},
                       "End Node Set": {"Expression": "x > 0.0385"}, "Still": {**conditions["Still"], "Node Set": "End Node Set"},
                       "Still Y": {**conditions["Still"], "Node Set": "End Node Set", "Coordinate": "y"}}
        with_window = self.solve(deck)
        del deck["Solver"]["Fatigue"]["Tip Window"]
        np.testing.assert_allclose(with_window.history()["time"], self.solve(deck).history()["time"], rtol=1e-3)

    def test_a_run_that_goes_on_is_the_one_that_never_stopped(self):
        deck = self.deck(width=LONG)
        deck["Output2"] = {"Output Filename": "early", "Output Variables": ["Damage"], "Final Output Step": 9,
                           "Checkpoint Frequency": 9}
        whole = self.solve(deck)
        history, displacement = whole.history(), whole.field("Displacement")
        self.assertGreater(len(history["time"]), 18)
        resumed = self.solve(deck, arguments=["--restart", "early.checkpoint.h5"])
        for label, values in history.items():
            np.testing.assert_array_equal(resumed.history()[label], values, err_msg=label)
        np.testing.assert_array_equal(resumed.field("Displacement"), displacement)

    def test_where_it_cannot_be_it_is_refused(self):
        def refusal(deck, **options):
            result = self.run_deck(deck, **options)
            self.assertNotEqual(result.code, 0)
            return result.text
        deck = self.deck(width=20e-3)
        self.assertIn("several ranks", refusal(deck, ranks=2))
        deck["Materials"]["Steel"]["Poisson's Ratio"] = 0.29
        self.assertIn("more than resist along themselves", refusal(deck))
        self.assertIn("more than resist along themselves", refusal(deck, arguments=["--check"]))
        deck["Solver"]["Fatigue"]["Kinematics"] = "Finite"
        self.assertIn("is for \"Kinematics: Small Strain\"", refusal(deck))


if __name__ == "__main__":
    unittest.main()
