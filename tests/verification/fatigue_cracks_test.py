#!/usr/bin/python3
"""Fatigue cracks in awkward places: tips and cuts on points, other lattices, holes, steep laws, loads at a point.
Separation, two cracks that meet, load ratios and blocks that are too long: fatigue_test.py; ranks and restarts:
mpi/fatigue_test.py."""
import sys
import unittest

import numpy as np

sys.path[:0] = [sys.path[0] + "/../support", sys.path[0] + "/../../decks/fracture_energy"]
sys.dont_write_bytecode = True
from cracked_plate import CRACK, HEIGHT, SPACING, THICKNESS, WIDTH, cracked_plate  # noqa: E402
from lattices import lattice_points  # noqa: E402
from scene import SceneTest, lattice  # noqa: E402

END = 14e-3  # m, length at which runs stop: growth by two horizons


class FatigueCracks(SceneTest):
    def deck(self, solver=None, isFinite=False, **more):
        deck = cracked_plate(self, solver={"Stop When": {"Value": "Length", "Reaches": END}, **(solver or {})}, **more)
        if not isFinite:
            deck["Solver"]["Fatigue"]["Kinematics"] = "Small Strain"
            del deck["Solver"]["Fatigue"]["Preconditioner"]
        return deck

    def grown(self, deck):
        """History and damage of a run whose crack has reached the end."""
        result = self.solve(deck)
        self.assertIn("Length has reached", " ".join(result.report["solver"]))
        return result.history(), result.field("Damage")

    def assert_mirrored(self, points, values):
        """As above, so below y = 0."""
        order, mirrored = (np.lexsort((np.round(sign * points[:, 1], 9), np.round(points[:, 0], 9)))
                           for sign in (1, -1))
        np.testing.assert_allclose(values[order], values[mirrored], rtol=1e-5)

    def test_tips_before_on_and_past_a_column_of_points(self):
        column = CRACK + 0.5 * SPACING
        lives, starts = {}, {}
        for name, tip in (("between", CRACK), ("before", column - 1e-9), ("on", column), ("past", column + 1e-9)):
            history, _ = self.grown(self.deck(crack=tip))
            lives[name], starts[name] = history["time"][-1], history["Length"][0]
            self.assertAlmostEqual(starts[name], tip, delta=1.2 * SPACING, msg=name)
        # A tip on points is one past them, to the last bit; one before them leaves the bonds that end there.
        self.assertEqual(lives["on"], lives["past"])
        self.assertLess(lives["on"], lives["before"])
        self.assertLess(lives["before"], lives["between"])
        self.assertGreater(lives["on"], 0.9 * lives["between"])  # half a spacing of six is 8 %

    def test_cuts_through_points(self):
        # The row on the cut keeps the bonds along itself alone: a fibre in compression, which nothing holds sideways.
        straight = lattice([WIDTH, HEIGHT + SPACING], SPACING, origin=[0.0, -(HEIGHT + SPACING) / 2])
        i, j = (n.ravel() * np.sqrt(0.5) * SPACING for n in np.meshgrid(np.arange(60), np.arange(-30, 30)))
        turned = np.column_stack([i + j + 1e-6, i - j - 30 * np.sqrt(0.5) * SPACING, 0 * i])
        turned[:, 1] -= turned[np.argmin(np.abs(turned[:, 1])), 1]  # a row at y = 0
        turned = turned[(turned[:, 0] > 0) & (turned[:, 0] < WIDTH) & (np.abs(turned[:, 1]) < HEIGHT / 2)]
        for name, points, tolerance, tolerances in (("along rows", straight, 1e-8, (1e-3, 1e-9)),
                                                    ("along diagonals", turned, 1e-6, (1e-9,))):
            with self.subTest(name):
                history, damage = self.grown(self.deck(points=points))
                self.assert_mirrored(points, damage)
                # The fibre buckles by as much as its points move, which differs with each bond that breaks elsewhere.
                for lives in tolerances:
                    finite, _ = self.grown(self.deck({"Relative Tolerance": tolerance}, points=points, isFinite=True,
                                                     damage={"Life Tolerance": lives}))
                    self.assertAlmostEqual(finite["time"][-1] / history["time"][-1], 1.0, delta=0.01)

    def test_lattices_give_a_crack_the_same_life_and_path(self):
        lives = {}
        for name in ("square_3", "turned_20", "turned_45", "triangles"):
            points, _ = lattice_points((0.0, -HEIGHT / 2), (WIDTH, HEIGHT / 2), name, 3 * SPACING, THICKNESS)
            history, damage = self.grown(self.deck(points=np.column_stack([points, 0 * points[:, 0]])))
            lives[name] = history["time"][-1]
            new = (points[:, 0] > CRACK + SPACING) & (points[:, 0] < END) & (damage > 0.3)
            self.assertLess(np.abs(points[new, 1]).max(), 3 * SPACING, name)  # a horizon
        for name, life in lives.items():
            self.assertAlmostEqual(life / lives["square_3"], 1.0, delta=0.1, msg=name)

    def test_a_crack_enters_a_hole_and_starts_again_on_its_far_side(self):
        points = lattice([24e-3, HEIGHT], SPACING, origin=[0.0, -HEIGHT / 2])
        points = points[np.hypot(points[:, 0] - 13.5e-3, points[:, 1]) > 2.4e-3]
        initiation = {"Initiation Coefficient": 1e3, "Initiation Exponent": 3.0}  # a tenth of the rate beside cracks
        deck = self.deck(points=points, damage=initiation)
        del deck["Solver"]["Fatigue"]["Stop When"]
        result = self.solve(deck)
        self.assertIn("come apart", " ".join(result.report["solver"]))
        first = result.field("Cycles_To_First_Break")
        self.assert_mirrored(points, first)
        middle = (np.abs(points[:, 1]) < SPACING) & (points[:, 1] > 0)
        x, cycles = points[middle, 0], first[middle]
        self.assertGreater(cycles[x > CRACK].min(), 0.0)  # all of the plane has broken
        before, behind = cycles[(x > CRACK) & (x < 11e-3)], cycles[x > 16e-3]
        self.assertGreater(behind.min(), before.max())    # in the hole first
        self.assertEqual(np.argmin(behind), 0)            # at the hole's rim
        np.testing.assert_array_equal(np.sort(behind[1:-1]), behind[1:-1])  # and on through the ligament
        # Phase I alone: without it the crack ends in the hole
        for key in initiation:
            del deck["Damage Models"]["Breakage"][key]
        deck["Solver"]["Final Time"] = behind.min() * 2
        alone = self.solve(deck).field("Damage")
        self.assertEqual(alone[points[:, 0] > 19e-3].max(), 0.0)

    def test_a_steep_law_breaks_the_same_bonds_at_any_load(self):
        runs = []
        for load in (1e-6, 2e-6):
            deck = self.deck(damage={"Growth Coefficient": 1e20, "Growth Exponent": 6.5})
            deck["Boundary Conditions"]["Up"]["Value"], deck["Boundary Conditions"]["Down"]["Value"] = load, -load
            runs.append(self.grown(deck))
        (one, damage), (two, other_damage) = runs
        np.testing.assert_array_equal(one["Length"], two["Length"])
        self.assertAlmostEqual(one["time"][-1] / two["time"][-1] / 2**6.5, 1.0, delta=0.01)
        np.testing.assert_array_equal(damage, other_damage)

    def test_a_crack_under_the_limit_stands(self):
        deck = self.deck(damage={"Fatigue Limit": 0.1, "Fatigue Limit In Growth": True}, final_time=1e9)
        result = self.solve(deck)
        self.assertIn("run-out", " ".join(result.report["solver"]))
        self.assertEqual(result.history()["time"][-1], 1e9)
        self.assertEqual(result.field("Cycles_To_First_Break").max(), 0.0)

    def test_loads_at_single_points_are_no_crack(self):
        deck = self.deck()
        corner = f"abs(x - {SPACING / 2}) < 1e-4 && abs(y {{}} {HEIGHT / 2 - SPACING / 2}) < 1e-4"
        force = {"Type": "Force", "Coordinate": "y"}
        hold = {"Type": "Prescribed Displacement", "Node Set": "Far Node Set", "Value": 0.0}
        deck["Boundary Conditions"] = {
            "Top Node Set": {"Expression": corner.format("-")}, "Bottom Node Set": {"Expression": corner.format("+")},
            "Far Node Set": {"Expression": f"x > {WIDTH - SPACING} && abs(y) < {SPACING}"},
            "Up": {**force, "Node Set": "Top Node Set", "Value": 50.0},
            "Down": {**force, "Node Set": "Bottom Node Set", "Value": -50.0},
            "X": {**hold, "Coordinate": "x"}, "Y": {**hold, "Coordinate": "y"}}
        _, damage = self.grown(deck)
        points = lattice([WIDTH, HEIGHT], SPACING, origin=[0.0, -HEIGHT / 2])
        self.assertEqual(damage[np.abs(points[:, 1]) > 3 * SPACING].max(), 0.0)
        self.assert_mirrored(points, damage)


if __name__ == "__main__":
    unittest.main()
