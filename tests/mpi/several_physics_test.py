#!/usr/bin/python3
"""Steel that bears load, takes up hydrogen, breaks and dissolves, all on the same points, on 1, 2 and 4 ranks."""
import os
import sys
import unittest

import numpy as np

sys.path[:0] = [os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support")]
from corrosion_scene import SPACING, STEEL, front_speed  # noqa: E402
from loaded_metal import DISSOLUTION, MECHANICS, NEWTON, LoadedMetal, bar_deck, grips, sea  # noqa: E402

SAME = 1e-10  # of the largest value: sums in another order


class OnRanks(LoadedMetal):
    FIELDS = ["Displacement", "Damage", "Ions", "Hydrogen"]

    def deck(self, rule):
        end = 1.0 + 2.5 * SPACING / front_speed(STEEL)
        charge = {"Charged Node Set": {"Expression": f"x < {3 * SPACING!r}"},
                  "Charge": {"Type": "Prescribed Value", "Field": "Hydrogen", "Node Set": "Charged Node Set",
                             "Value": 1.0}}
        return bar_deck(
            {"Steel": {**MECHANICS, "Diffusivity": 2e-12, "Diffusing Field": "Hydrogen"},
             "Metal": {**DISSOLUTION, "Concentration Field": "Ions"}},
            {"Breakage": {"Damage Model": "Hydrogen Critical Stretch", "Concentration Field": "Hydrogen",
                          "Saturation Concentration": 1.0, "Critical Stretch": 1.6e-4},
             "Phases": {"Damage Model": "Dissolution", "Concentration Field": "Ions", "Rule": rule}},
            {**grips(), **sea("Ions"), **charge},
            [(1.0, NEWTON), (end, {"Corrosion": {"Load Steps": 1, "Concentration Field": "Ions"}}),
             (end + 5.0, {"Diffusion": {"Field": "Hydrogen", "Method": "Implicit Euler", "Load Steps": 3}}),
             (end + 6.0, NEWTON)], self.FIELDS)

    def check(self, rule):
        self.make_bar()
        expected = None
        for ranks in (1, 2, 4):
            result = self.solve(self.deck(rule), ranks=ranks)
            fields = {label: result.field(label) for label in self.FIELDS}
            if expected is None:
                expected = fields
                self.assertGreaterEqual(np.count_nonzero(fields["Damage"] >= 1.0), 2 * 32 * (4 + 2))  # sea, and two rows
            np.testing.assert_array_equal(fields["Damage"], expected["Damage"])
            for label in self.FIELDS:
                worst = np.max(np.abs(fields[label] - expected[label])) / np.max(np.abs(expected[label]))
                self.assertLess(worst, 1e-8 if label == "Displacement" else SAME, f"{label}, {ranks} ranks")

    def test_phases_follow_the_metal(self):
        self.check("Deterministic")

    def test_bonds_break_at_random_too(self):
        self.check("Stochastic")


if __name__ == "__main__":
    unittest.main()
