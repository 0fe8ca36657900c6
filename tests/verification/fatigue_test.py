#!/usr/bin/python3
"""Lives by the solver Fatigue and the damage model Remaining Life, against their closed forms."""
import json
import os
import subprocess
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from cracked_plate import CRACK, SPACING, THICKNESS, cracked_plate  # noqa: E402
from scene import Result, SceneTest, lattice, pdrun_path, plate_deck  # noqa: E402

DECKS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../decks")


class TwoPairs(SceneTest):
    """Two bonds on their own, one stretched by a twentieth more than the other."""

    def times(self, tolerance):
        """At which bonds have broken when the body has come apart, in lives of the shorter-lived one."""
        self.write_mesh(np.array([[0.0, 0.0, 0.0], [1e-3, 0.0, 0.0], [0.0, 5e-3, 0.0], [1e-3, 5e-3, 0.0]]), 1e-9)
        hold = {"Type": "Prescribed Displacement", "Value": 0.0}
        result = self.solve(plate_deck(
            1.2e-3, 1e-3, {"Young's Modulus": 200e9, "Poisson's Ratio": 1 / 3},
            damage={"Damage Model": "Remaining Life", "Initiation Coefficient": 100.0, "Initiation Exponent": 2.0,
                    "Life Tolerance": tolerance},
            conditions={"All Node Set": {"Expression": "x < 1"}, "Left Node Set": {"Expression": "x < 5e-4"},
                        "Right Node Set": {"Expression": "x > 5e-4"},
                        "Left": {**hold, "Node Set": "Left Node Set", "Coordinate": "x"},
                        "Right": {**hold, "Node Set": "Right Node Set", "Coordinate": "x", "Value": "1e-6*(1 + 10*y)"},
                        "Along Y": {**hold, "Node Set": "All Node Set", "Coordinate": "y"}},
            solver={"Final Time": 1e6, "Fatigue": {}}, output={"Output Variables": ["Cycles_To_First_Break"]}))
        return result.field("Cycles_To_First_Break") * 100.0 * 1.05e-3**2

    def test_fail_together_when_one_has_overdrawn_what_the_other_has_left(self):
        slower = 1.05**-2  # rate of the one over that of the other: 0.093 of its life is left when the other fails
        np.testing.assert_allclose(self.times(0.09), [0.0, 0.0, 1.0, 1.0], rtol=1e-6)
        np.testing.assert_allclose(self.times(0.1), 2 / (1 + slower), rtol=1e-6)


class OneFastPairAmongSlowOnes(SceneTest):
    """Pairs of points on their own, all stretched by 1e-3, then by 0.7e-3: one wears in proportion to that, the others
    with its tenth power, by as much in the first block. They have a tenth of their lives left, and hardly wear."""

    def test_is_overdrawn_by_the_tolerance_at_most(self):
        n, strain, tolerance = 20, 1e-3, 0.1
        points = [[x, 5e-3 * pair, 0.0] for pair in range(n + 1) for x in (0.0, 1e-3)]
        self.write_mesh(np.array(points), 1e-9, np.array([2, 2] + 2 * n * [1]))
        hold = {"Type": "Prescribed Displacement", "Value": 0.0}
        law = {"Damage Model": "Remaining Life", "Life Tolerance": tolerance}
        deck = plate_deck(
            1.2e-3, 1e-3, {"Young's Modulus": 200e9, "Poisson's Ratio": 1 / 3},
            damage={**law, "Initiation Coefficient": 0.895e-3 / strain**10, "Initiation Exponent": 10.0},
            conditions={"All Node Set": {"Expression": "x < 1"}, "Left Node Set": {"Expression": "x < 5e-4"},
                        "Right Node Set": {"Expression": "x > 5e-4"},
                        "Left": {**hold, "Node Set": "Left Node Set", "Coordinate": "x"},
                        "Right": {**hold, "Node Set": "Right Node Set", "Coordinate": "x", "Value": "1e-6"},
                        "Along Y": {**hold, "Node Set": "All Node Set", "Coordinate": "y"}},
            solver={"Final Time": 1e6, "Fatigue": {"Load Blocks": {"Cycles": [1000.0, 900000.0], "Peaks": [1.0, 0.7]}}},
            output={"Output Variables": ["Cycles_To_First_Break"]})
        deck["Blocks"]["Fast"] = {"Block Names": "block_2", "Material": "Steel", "Horizon": 1.2e-3, "Damage Model": "Fast"}
        deck["Damage Models"]["Fast"] = {**law, "Initiation Coefficient": 5e-4 / strain, "Initiation Exponent": 1.0}
        found = self.solve(deck).field("Cycles_To_First_Break")
        rate = 0.7 * 5e-4  # of the fast pair in the second block, which begins with half of its life
        np.testing.assert_allclose(found, 1000.0 + (0.5 + tolerance) / rate, rtol=1e-6)


class BrokenFromOneEnd(SceneTest):
    """Three points in a row. The first has a damage model of its own, and breaks its bond to the second, which keeps it."""

    def deck(self, kinematics):
        self.write_mesh(np.array([[x, y, 0.0] for y in (0.0, 5e-3) for x in (0.0, 1e-3, 2e-3)]), 1e-9,
                        np.array(2 * [2, 1, 1]))
        hold = {"Type": "Prescribed Displacement"}
        law = {"Damage Model": "Remaining Life", "Initiation Exponent": 2.0}
        deck = plate_deck(
            1.2e-3, 1e-3, {"Young's Modulus": 200e9, "Poisson's Ratio": 1 / 3},
            damage={**law, "Initiation Coefficient": 1e-2},
            conditions={"All Node Set": {"Expression": "x < 1"}, "Ends Node Set": {"Expression": "abs(x - 1e-3) > 5e-4"},
                        "X": {**hold, "Node Set": "Ends Node Set", "Coordinate": "x", "Value": "1e-3*x"},
                        "Y": {**hold, "Node Set": "All Node Set", "Coordinate": "y", "Value": 0.0}},
            solver={"Final Time": 3e4, "Fatigue": {"Kinematics": kinematics}}, output={"Output Variables": ["Displacement"]})
        deck["Blocks"]["Fast"] = {"Block Names": "block_2", "Material": "Steel", "Horizon": 1.2e-3, "Damage Model": "Fast"}
        deck["Damage Models"]["Fast"] = {**law, "Initiation Coefficient": 100.0}
        return deck

    def test_keeps_half_its_force_or_is_refused(self):
        moved = self.solve(self.deck("Finite")).field("Displacement")[1, 0]
        self.assertAlmostEqual(moved / 2e-6, 2 / 3, delta=1e-3)  # springs of 1/2 and 1 in series
        for ranks in (1, 2):
            result = self.run_deck(self.deck("Small Strain"), ranks=ranks)
            self.assertNotEqual(result.code, 0)
            self.assertIn("need \"Kinematics: Finite\"", result.text)


class TornOffByAForce(SceneTest):
    """A row of points at the end of a plate, to which a force is given: their bonds fail first."""

    def test_ends_with_its_life(self):
        self.write_mesh(lattice([20e-3, 6e-3], 1e-3), 1e-9)
        hold = {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Value": 0.0}
        for kinematics in ("Finite", "Small Strain"):
            result = self.solve(plate_deck(
                3.015e-3, 1e-3, {"Young's Modulus": 200e9, "Poisson's Ratio": 1 / 3},
                damage={"Damage Model": "Remaining Life", "Initiation Coefficient": 1e3, "Initiation Exponent": 3.0},
                conditions={"Left Node Set": {"Expression": "x < 0.003"}, "Right Node Set": {"Expression": "x > 0.019"},
                            "Hold X": {**hold, "Coordinate": "x"}, "Hold Y": {**hold, "Coordinate": "y"},
                            "Pull": {"Type": "Force", "Node Set": "Right Node Set", "Coordinate": "x", "Value": 1200.0}},
                solver={"Final Time": 1e9, "Fatigue": {"Kinematics": kinematics}},
                output={"Output Variables": ["Displacement", "Cycles_To_First_Break"]}))
            self.assertIn("come apart", " ".join(result.report["solver"]))
            self.assertGreater(np.max(result.field("Cycles_To_First_Break")), 0.0)
            self.assertTrue(np.all(np.isfinite(result.field("Displacement"))))


class SmoothBar(SceneTest):
    """decks/smooth_bar: a bar in uniform tension lives as long as one of its bonds."""

    def bar(self, strain, *settings, restart=None):
        deck = os.path.join(DECKS, "smooth_bar/bar.yaml")
        command = [pdrun_path(), deck, "--quiet", *(["--restart", restart] if restart else [])]
        for setting in (*(f"Boundary Conditions/{side} Grip/Value={strain}*x" for side in ("Left", "Right")), *settings):
            command += ["--set", setting]
        process = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        result = Result(self.folder, "smooth_bar", process)
        self.assertEqual(result.code, 0, result.text)
        return result

    def life(self, strain, *settings):
        result = self.bar(strain, *settings)
        self.assertEqual(result.history()["Largest_Damage"][-1], 1.0)
        self.assertIn("come apart", " ".join(result.report["solver"]))
        return result.history()["time"][-1]

    def test_life_is_that_of_the_law_at_any_load_ratio(self):
        for ratio in (-1.0, 0.0, 0.7):
            strain_range = 4.0e-3
            exact = 1 / (426.0 * (strain_range - 1.86e-3) ** 2.77)
            found = self.life(strain_range / (1 - ratio), f"Solver/Fatigue/Load Ratio={ratio}")
            self.assertAlmostEqual(found / exact, 1.0, delta=1e-8, msg=f"R = {ratio}")

    def test_below_the_limit_nothing_happens(self):
        result = self.bar(0.92e-3)
        self.assertEqual(result.history()["time"][-1], 1e7)
        self.assertEqual(result.history()["Largest_Damage"][-1], 0.0)
        self.assertIn("run-out", " ".join(result.report["solver"]))

    def test_blocks_a_thousand_lives_long_are_halved(self):
        exact = 1 / (426.0 * (4.0e-3 - 1.86e-3) ** 2.77)
        life = self.life(2.0e-3, f"Solver/Fatigue/Cycles Per Block={1e3 * exact}", f"Solver/Final Time={1e5 * exact}")
        self.assertGreaterEqual(life / exact, 0.999)
        self.assertLess(life / exact, 1.11)  # halved until a bond that has failed is loaded for a tenth of a life at most

    def test_a_table_gives_its_lives(self):
        table = {"Damage Model": "Remaining Life", "Lives": [1e3, 1e5, 1e6], "Strain Ranges": [1e-2, 4e-3, 2e-3]}
        life = self.life(2.0e-3, "Damage Models/Fatigue=" + json.dumps(table))
        self.assertAlmostEqual(life / 1e5, 1.0, delta=1e-8)

    def test_loads_that_grow_are_followed_by_intervals_or_a_word_is_said(self):
        growth, limit, coefficient, exponent = 4.0e-7, 1.86e-3, 426.0, 2.77  # of the strain range in a cycle
        exact = (limit + (growth * (exponent + 1) / coefficient) ** (1 / (exponent + 1))) / growth
        for intervals, error in ((1000, 0.01), (10, 0.3)):
            result = self.bar("2.0e-7*t", "Solver/Final Time=1e5", f"Solver/Fatigue/Intervals={intervals}")
            self.assertAlmostEqual(result.history()["time"][-1] / exact, 1.0, delta=error)
            self.assertEqual("loads changed within steps" in " ".join(result.report["solver"]), intervals == 10)

    def test_what_was_misjudged_before_a_checkpoint_is_told_after_it(self):
        def told(end, intervals, *more, restart=None):
            result = self.bar("2.0e-7*t", f"Solver/Final Time={end}", f"Solver/Fatigue/Intervals={intervals}", *more,
                              restart=restart)
            return next((line for line in result.report["solver"] if "loads changed within steps" in line), None)
        whole = told(1.8e4, 12)
        self.assertIsNotNone(whole)
        self.assertIsNotNone(told(1.5e4, 10, "Output/Checkpoint Frequency=10"))
        self.assertEqual(told(1.8e4, 12, restart="smooth_bar.checkpoint.h5"), whole)

    def test_as_a_part_of_staggered_time_scale_is_the_frequency(self):
        solver = {"Final Time": 1e4, "Staggered": {"Load Steps": 20, "Solvers": {"Cycles": {
            "Fatigue": {"Load Ratio": -1.0}, "Time Scale": 10.0}}}}
        history = self.bar(2.0e-3, "Solver=" + json.dumps(solver)).history()
        # 58 256 cycles at 10 a second, seen at the ends of load steps
        self.assertEqual(history["time"][np.argmax(history["Largest_Damage"] == 1.0)], 6000.0)


class CrackedPlate(SceneTest):
    """A crack that grows through a small plate, bond by bond."""

    grown = {"Stop When": {"Value": "Length", "Reaches": CRACK + 1.9 * SPACING}}

    def life(self, solver=None, **more):
        """Cycles until the crack has grown by two columns."""
        result = self.solve(cracked_plate(self, solver={**self.grown, **(solver or {})}, **more))
        self.assertIn("Length has reached", " ".join(result.report["solver"]))
        return result.history()["time"][-1]

    def test_lives_go_as_a_power_of_the_range_at_any_load_ratio(self):
        lives = {ratio: self.life({"Load Ratio": ratio}) for ratio in (-1.0, 0.0, 0.7)}
        for ratio, life in lives.items():
            self.assertAlmostEqual(life * (1 - ratio) ** 3 / lives[0.0], 1.0, delta=1e-9, msg=f"R = {ratio}")

    def test_ends_by_a_value_that_no_history_shows(self):
        def end(**output):
            result = self.solve(cracked_plate(self, solver=self.grown, **output))
            return next(line for line in result.report["solver"] if "Length has reached" in line)
        self.assertEqual(end(**{"History Frequency": -1}), end())

    def test_steps_of_fixed_length_find_the_same_life(self):
        life = self.life()
        short = self.life({"Cycles Per Block": life / 300}, final_time=2 * life)
        self.assertAlmostEqual(short / life, 1.0, delta=0.05)
        # A thousand times as long as a life between failures: halved, not believed.
        result = self.solve(cracked_plate(self, solver={**self.grown, "Cycles Per Block": 10 * life}, final_time=1e3 * life))
        self.assertAlmostEqual(result.history()["time"][-1] / life, 1.0, delta=0.15)
        self.assertNotIn(" 0 blocks halved", " ".join(result.report["solver"]))

    def test_blocks_of_cycles_add_up(self):
        # Of 2 cycles one has twice the range: (1 + 2^3)/2 of the life that one takes at peak 1. Blocks are short beside
        # a bond's life, and the last may end up to one of them later.
        cycles = 50.0
        life, mixed = self.life(), self.life({"Load Blocks": {"Cycles": [cycles, cycles], "Peaks": [1.0, 2.0]}},
                                            final_time=1e5)
        self.assertAlmostEqual(mixed * 4.5 / life, 1.0, delta=0.02)

    def test_loads_keep_the_range_of_k_that_the_deck_asks_for_until_the_toughness(self):
        intensity = {"Energy Release Rate": "J", "Effective Modulus": 200e9, "Crack Length": "Length",
                     "Range": "10e6*(1 + 100*(a - 0.008))", "Fracture Toughness": 10e6 * 1.1 / 0.9}
        deck = cracked_plate(self, solver={"Load Ratio": 0.1, "Stress Intensity": intensity})
        deck["Compute Class Parameters"]["J"] = {
            "Compute Class": "J_Integral", "Plane Stress": True, "Thickness": THICKNESS, "Tip X": CRACK,
            "Inner Radius": 3e-3, "Outer Radius": 6e-3, "Output Label": "J"}
        deck["Output"]["Output Variables"] += ["J", "Stress_Intensity_Range"]
        result = self.solve(deck)
        history = result.history()
        np.testing.assert_allclose(history["Stress_Intensity_Range"][1:],
                                   10e6 * (1 + 100 * (history["Length"][1:] - 0.008)), rtol=1e-9)
        self.assertIn("fracture toughness", " ".join(result.report["solver"]))
        self.assertGreaterEqual(history["Length"][-1], 0.009)  # where the range is 1.1 times the first
        self.assertLess(history["Length"][-2], 0.009)

    def test_loads_follow_the_present_tip_wherever_the_deck_names_it(self):
        tip = {"Compute Class": "Crack_Tip", "Start X": 0.0, "Start Y": 0.0, "Output Label": "Tip"}
        ring = {"Compute Class": "J_Integral", "Plane Stress": True, "Thickness": THICKNESS, "Tip Field": "Tip",
                "Inner Radius": 3e-3, "Outer Radius": 6e-3, "Output Label": "J"}
        lives = []
        for computes in ({"Tip": tip, "J": ring}, {"J": ring, "Tip": tip}):
            deck = cracked_plate(self, solver={
                "Stress Intensity": {"Energy Release Rate": "J", "Effective Modulus": 200e9, "Range": 10e6},
                "Stop When": {"Value": "Length", "Reaches": CRACK + 3.9 * SPACING}})
            deck["Compute Class Parameters"] = {**computes, **deck["Compute Class Parameters"]}
            deck["Output"]["History Frequency"] = 1000
            lives.append(self.solve(deck).history()["time"][-1])
        self.assertEqual(*lives)

    def test_thresholds_that_no_law_of_bonds_meets_are_refused(self):
        deck = cracked_plate(self)
        deck["Damage Models"]["Breakage"] = {
            "Damage Model": "Remaining Life", "Paris Coefficient": 1e-11, "Paris Exponent": 12.0, "Paris Threshold": 5.0,
            "Horizon": 3.015 * SPACING, "Spacing": SPACING, "Young's Modulus": 200e9, "Poisson's Ratio": 1 / 3,
            "Plane Stress": True, "Thickness": THICKNESS}
        done = self.run_deck(deck, arguments=["--check"])
        self.assertEqual(done.code, 2, done.text)
        self.assertIn("no law of bonds makes the growth", done.text)

    def test_a_crack_stands_at_the_threshold_and_grows_as_the_range_exceeds_it(self):
        damage = {"Damage Model": "Remaining Life", "Paris Coefficient": 1e-11, "Paris Exponent": 2.0, "Paris Threshold": 5.0,
                  "Horizon": 3.015 * SPACING, "Spacing": SPACING, "Young's Modulus": 200e9, "Poisson's Ratio": 1 / 3,
                  "Plane Stress": True, "Thickness": THICKNESS}

        def history(range_of_k):
            intensity = {"Energy Release Rate": "J", "Effective Modulus": 200e9, "Range": range_of_k}
            deck = cracked_plate(self, solver={"Stress Intensity": intensity,
                                               "Stop When": {"Value": "Length", "Reaches": CRACK + 5.9 * SPACING}})
            deck["Damage Models"]["Breakage"] = damage
            deck["Compute Class Parameters"]["Tip"] = {"Compute Class": "Crack_Tip", "Start X": 0.0, "Start Y": 0.0,
                                                       "Output Label": "Tip"}
            deck["Compute Class Parameters"]["J"] = {
                "Compute Class": "J_Integral", "Plane Stress": True, "Thickness": THICKNESS, "Tip Field": "Tip",
                "Inner Radius": 3e-3, "Outer Radius": 6e-3, "Output Label": "J"}
            deck["Output"]["Output Variables"] += ["J", "Tip"]
            return self.solve(deck).history()

        def rate(range_of_k):
            found = history(range_of_k)
            grown = np.interp([0.010, 0.013], found["Length"], found["time"])
            return 0.003 / (grown[1] - grown[0])

        # 20 times as fast at twice the range, 4 times without a threshold; a plate of six horizons between its grips
        self.assertAlmostEqual(rate(14e6) / rate(7e6) / (9.0 / 2.0)**2, 1.0, delta=0.15)
        standing = history(3.5e6)["Length"]
        self.assertEqual(standing[-1], standing[0])

    def test_loads_follow_the_length_of_the_crack(self):
        peak = {"Crack Length": "Length", "Peak": "exp(200*(a - 0.008))"}
        deck = cracked_plate(self, solver={**self.grown, "Load By Crack Length": peak})
        deck["Output"]["Output Variables"] += ["Peak_Load"]
        history = self.solve(deck).history()
        np.testing.assert_allclose(history["Peak_Load"][1:], np.exp(200 * (history["Length"][1:] - 0.008)), rtol=1e-9)
        # Between failures the load stays: cycles go as the inverse third power of it.
        steps = np.diff(history["time"]) * history["Peak_Load"][:-1] ** 3
        constant = self.solve(cracked_plate(self, solver=self.grown)).history()
        self.assertAlmostEqual(steps[1:].sum() / np.diff(constant["time"])[1:].sum(), 1.0, delta=0.05)
        deck["Solver"]["Fatigue"]["Load By Crack Length"]["Peak"] = "0.0075 - a"
        result = self.run_deck(deck)
        self.assertNotEqual(result.code, 0)
        self.assertIn("must be above 0 at every length", result.text)

    def test_ends_when_the_plate_has_come_apart(self):
        result = self.solve(cracked_plate(self, width=12e-3))
        self.assertIn("come apart", " ".join(result.report["solver"]))
        self.assertLess(result.history()["time"][-1], 1e9)
        broken = result.field("Cycles_To_First_Break")
        self.assertGreater(broken.max(), broken[broken > 0].min())

    def test_ends_when_a_force_has_torn_the_ligament(self):
        # The last bonds of which let the upper half turn.
        for kinematics in ("Finite", "Small Strain"):
            deck = cracked_plate(self, solver={"Kinematics": kinematics, "Relative Tolerance": 1e-6}, width=11e-3)
            if kinematics == "Small Strain":
                del deck["Solver"]["Fatigue"]["Preconditioner"]
            conditions = deck["Boundary Conditions"]
            conditions["Up"] = {"Type": "Force", "Node Set": "Top Node Set", "Coordinate": "y", "Value": 2000.0}
            conditions["Still"]["Node Set"] = "Bottom Node Set"
            result = self.solve(deck)
            self.assertIn("come apart", " ".join(result.report["solver"]))
            self.assertTrue(np.all(np.isfinite(result.field("Displacement"))))
        self.assertIn("no equilibrium: the linear solver", " ".join(result.report["solver"]))
        deck["Solver"]["Fatigue"]["Maximum Solver Iterations"] = 2  # which end sooner than what bears the load
        result = self.run_deck(deck)
        self.assertEqual(result.code, 3, result.text)
        self.assertIn("the iterations are used up", result.text)

    def test_a_force_tears_the_ligament_beside_a_larger_one_on_another_body(self):
        width, far = 11e-3, 30e-3
        deck = cracked_plate(self, solver={"Kinematics": "Small Strain", "Relative Tolerance": 1e-6}, width=width)
        plate = lattice([width, 18e-3], SPACING, origin=[0.0, -9e-3])
        points = np.concatenate([plate, plate + [far, 0.0, 0.0]])
        self.write_mesh(points, SPACING**2 * THICKNESS, block=np.where(points[:, 0] > 20e-3, 2, 1))
        del deck["Solver"]["Fatigue"]["Preconditioner"]
        deck["Discretization"]["Bond Filters"]["Crack"]["Bottom_Length"] = 1.0 + CRACK
        deck["Materials"]["Stiff"] = {**deck["Materials"]["Steel"], "Young's Modulus": 2e15}
        deck["Blocks"]["Body"]["Block Names"] = "block_1"
        deck["Blocks"]["Far"] = {**deck["Blocks"]["Body"], "Block Names": "block_2", "Material": "Stiff"}
        conditions = deck["Boundary Conditions"]
        conditions["Still"]["Node Set"] = "Bottom Node Set"
        conditions["Top Node Set"] = {"Expression": "y > 6e-3 && x < 20e-3"}
        conditions["Far Node Set"] = {"Expression": "y > 6e-3 && x > 20e-3"}
        conditions["Up"] = {"Type": "Force", "Node Set": "Top Node Set", "Coordinate": "y", "Value": 2000.0}
        conditions["Other"] = {**conditions["Up"], "Node Set": "Far Node Set", "Value": 1e5}

        def end(**options):
            lines = self.solve(deck, **options).report["solver"]
            return next(line for line in lines if "ended since" in line).split(", and now")[0]

        whole = end()
        self.assertIn("a load moved", whole)
        deck["Solver"]["Final Time"] = 30.0
        deck["Output"]["Checkpoint Frequency"] = 1000000
        self.solve(deck)
        deck["Solver"]["Final Time"] = 1e9
        self.assertEqual(end(arguments=["--restart", "result.checkpoint.h5"]), whole)

    def test_two_cracks_meet(self):
        width = 13e-3
        deck = cracked_plate(self, width=width)
        other = dict(deck["Discretization"]["Bond Filters"]["Crack"], Lower_Left_Corner_X=width - 2 * SPACING)
        deck["Discretization"]["Bond Filters"]["Other"] = other
        result = self.solve(deck)
        self.assertIn("come apart", " ".join(result.report["solver"]))
        rows = result.field("Cycles_To_First_Break").reshape(-1, 13)[7:11]  # two on either side
        np.testing.assert_allclose(rows, rows[::-1], rtol=1e-6)             # as many cycles above as below
        middle = rows[1, 8:11]
        self.assertGreater(middle.min(), 0.0)
        self.assertGreater(middle[1], min(middle[0], middle[2]))  # both tips went for it

    def test_the_growth_coefficient_follows_from_paris_law_or_is_refused(self):
        material = {"Young's Modulus": 200e9, "Poisson's Ratio": 1 / 3, "Plane Stress": True, "Thickness": 2e-3}
        damage = {"Damage Model": "Remaining Life", "Paris Coefficient": 1e-11, "Paris Exponent": 3.0,
                  "Horizon": 3.015 * SPACING, "Spacing": SPACING, **material}
        deck = cracked_plate(self, solver={"Intervals": 1}, final_time=1.0)
        deck["Damage Models"]["Breakage"] = damage
        note = next(line for line in self.solve(deck).report["solver"] if "growth coefficient" in line)
        numbers = {key: float(note.split(key)[1].split()[0].rstrip(",")) for key in (" A2 = ", " B = ", "E' = ")}
        # da/dN = B A2 delta (dK/(E' sqrt(delta)))^M at 1 MPa sqrt(m)
        horizon = damage["Horizon"]
        rate = numbers[" B = "] * numbers[" A2 = "] * horizon * (1e6 / (numbers["E' = "] * horizon**0.5))**3
        self.assertAlmostEqual(rate / 1e-11, 1.0, delta=2e-3)  # four digits are printed
        self.assertAlmostEqual(numbers[" B = "] / 0.207, 1.0, delta=0.05)  # of an independent prototype
        deck["Discretization"]["Influence Function"] = "1 - zeta/horizon"  # bonds reach beyond the horizon
        result = self.run_deck(deck)
        self.assertEqual(result.code, 2)
        self.assertIn("influence function is negative", result.text)


class CompactTension(SceneTest):
    """decks/compact_tension, with twice its horizon."""

    def grown(self, more):
        """History of growth at dK = 15 MPa sqrt(m) from 13.5 mm on."""
        scene, horizon = os.path.join(DECKS, "compact_tension"), 2.25
        mesh = self.path("specimen.txt")
        subprocess.run([os.path.join(scene, "specimen.py"), str(horizon / 3), mesh], check=True)
        settings = {"Discretization/Input Mesh File": mesh, "Blocks/Body/Horizon": f"{horizon} mm",
                    "Damage Models/Fatigue/Horizon": f"{horizon} mm", "Damage Models/Fatigue/Spacing": f"{horizon / 3} mm",
                    "Compute Class Parameters/J/Inner Radius": f"{2 * horizon} mm",
                    "Compute Class Parameters/J/Outer Radius": f"{3.1 * horizon} mm",
                    "Solver/Fatigue/Stress Intensity/Range": "15.0e6", "Solver/Fatigue/Stop When/Reaches": "0.019", **more}
        for integral, behind, above in (("J Of Bonds", 2, 2), ("J Of Bonds Further Out", 3, 4.5)):
            for side, part in (("Ahead", 2), ("Behind", behind), ("Above", above)):
                settings[f"Compute Class Parameters/{integral}/{side}"] = f"{part * horizon} mm"
        command = [pdrun_path(), os.path.join(scene, "compact_tension.yaml"), "--quiet"]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        result = Result(self.folder, "compact_tension",
                        subprocess.run(command, cwd=self.folder, capture_output=True, text=True))
        self.assertEqual(result.code, 0, result.text)
        history = result.history()
        grown = history["Crack_Length"] > 0.0135
        return {key: values[grown] for key, values in history.items()}

    def test_paris_law_and_the_k_of_the_standard_come_out(self):
        history = self.grown({})
        length = history["Crack_Length"]
        # da/dN = C dK^M of the deck, in the specimen that it names
        self.assertAlmostEqual(np.polyfit(history["time"], length, 1)[0] / (1.615e-11 * 15.0**3), 1.0, delta=0.03)
        x = length / 0.04
        standard = (1750.0 / (0.0032 * 0.04**0.5) * (2 + x) / (1 - x)**1.5
                    * (0.886 + 4.64 * x - 13.32 * x**2 + 14.72 * x**3 - 5.6 * x**4))
        for label in ("J_Of_Bonds", "J_Further_Out"):
            ratio = np.sqrt(history[label] * 205.9e9) / standard
            self.assertAlmostEqual(ratio.mean(), 1.0, delta=0.02, msg=label)

    def test_neighbours_without_stiffness_tire_too(self):
        # The conical micromodulus is 0 at the horizon and beyond; where the trial leaves those bonds out growth is 1.1.
        history = self.grown({"Discretization/Influence Function": "max(1 - zeta/horizon, 0)",
                              "Solver/Fatigue/Stress Intensity/Effective Modulus": "204.4e9",
                              "Damage Models/Fatigue/Paris Exponent": "2.0"})
        rate = np.polyfit(history["time"], history["Crack_Length"], 1)[0]
        self.assertAlmostEqual(rate / (1.615e-11 * 15.0**2), 1.0, delta=0.03)

    def test_specimens_without_a_use_or_a_trial_are_refused(self):
        scene = os.path.join(DECKS, "compact_tension/compact_tension.yaml")
        fatigue = "Damage Models/Fatigue"
        without_use = "{Damage Model: Remaining Life, Growth Coefficient: 1.0, Growth Exponent: 3.0, Specimen Width: 40 mm}"
        for setting, message in ((f"{fatigue}={without_use}", "Specimen Width"),
                                 (f"{fatigue}/Specimen Width=10 mm", "8.888889 horizons"),
                                 (f"{fatigue}/Specimen Width=100 mm", "266.666667 spacings")):
            process = subprocess.run([pdrun_path(), scene, "--check", "--set", setting], cwd=self.folder,
                                     capture_output=True, text=True)
            self.assertEqual(process.returncode, 2)
            self.assertIn(message, process.stdout + process.stderr)


class InclinedCrack(SceneTest):
    """decks/mixed_mode_fatigue: a crack at 60 degrees to the load turns by 43.2 degrees (maximum tangential stress)."""

    def test_turns_as_the_largest_tangential_stress_has_it(self):
        def run(*command):
            return subprocess.run(command, cwd=self.folder, capture_output=True, text=True)

        scene = os.path.join(DECKS, "mixed_mode_fatigue")
        mesh = run(os.path.join(DECKS, "../meshes/pdmesh"), "grid", "disc", "--radius", "0.02", "--spacing", "0.0005",
                   "--thickness", "0.004", "--quiet", "-o", "disc.txt")
        self.assertEqual(mesh.returncode, 0, mesh.stderr)
        options = run(os.path.join(scene, "cases.py"), "60").stdout.splitlines()
        process = run(pdrun_path(), os.path.join(scene, "mixed_mode_fatigue.yaml"), "--quiet", *options, "--set",
                      f"Discretization/Input Mesh File={self.folder}/disc.txt")
        result = Result(self.folder, "mixed_mode_fatigue", process)
        self.assertEqual(result.code, 0, result.text)
        history = result.history()
        # K_I and K_II of the rim, by interaction integrals around the crack as cut
        found = [history["K_Of_The_Cut" + axis][1] for axis in "XY"]
        np.testing.assert_allclose(found, 20e6 * np.array([0.75**0.5, 0.5]), rtol=0.05)
        x, y = history["Crack_TipX"], history["Crack_TipY"]
        far = np.hypot(x, y) > 3.0e-3  # two horizons of the three that the branch is long
        kink = np.degrees(np.arctan2(y[far].mean(), x[far].mean()))
        self.assertAlmostEqual(kink, -43.2, delta=8.0)  # one spacing to the side is 6 degrees


if __name__ == "__main__":
    unittest.main()
