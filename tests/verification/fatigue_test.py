#!/usr/bin/python3
"""Lives by the solver Fatigue and the damage model Remaining Life, against their closed forms."""
import json
import os
import subprocess
import sys
import unittest

sys.path.insert(0, sys.path[0] + "/../support")
from scene import Result, SceneTest, pdrun_path  # noqa: E402

DECKS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../decks")


class SmoothBar(SceneTest):
    """decks/smooth_bar: a bar in uniform tension lives as long as one of its bonds."""

    def bar(self, strain, *settings):
        deck = os.path.join(DECKS, "smooth_bar/bar.yaml")
        command = [pdrun_path(), deck, "--quiet"]
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


if __name__ == "__main__":
    unittest.main()
