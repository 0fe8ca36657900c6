#!/usr/bin/python3
"""A crack that grows by fatigue: on 1, 2 and 4 ranks, and stopped and gone on with."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from cracked_plate import CRACK, SPACING, THICKNESS, cracked_plate  # noqa: E402
from scene import SceneTest  # noqa: E402


def until(columns):
    return {"Stop When": {"Value": "Length", "Reaches": CRACK + columns * SPACING}}


class Fatigue(SceneTest):
    damage = None  # that of the plate

    def run_until(self, columns, **options):
        deck = cracked_plate(self, solver=until(columns), **{"Checkpoint Frequency": 1000000})
        deck["Compute Class Parameters"]["J"] = {
            "Compute Class": "Nonlocal_J_Integral", "Thickness": THICKNESS, "Tip X": CRACK, "Ahead": 4e-3, "Behind": 4e-3,
            "Above": 4e-3, "Output Label": "J"}
        deck["Output"]["Output Variables"].append("J")
        if self.damage is not None:
            deck["Damage Models"]["Breakage"] = self.damage
        return self.solve(deck, **options)

    def test_the_same_bonds_fail_in_the_same_order_on_any_number_of_ranks(self):
        alone = self.run_until(1.4)
        lives, damage, first = alone.history(), alone.field("Damage"), alone.field("Cycles_To_First_Break")
        for ranks in (2, 4):
            result = self.run_until(1.4, ranks=ranks)
            np.testing.assert_allclose(result.history()["time"], lives["time"], rtol=1e-6, err_msg=f"{ranks} ranks")
            np.testing.assert_array_equal(result.history()["Length"], lives["Length"])
            np.testing.assert_allclose(result.history()["J"], lives["J"], rtol=1e-6)
            np.testing.assert_array_equal(result.field("Damage"), damage)
            np.testing.assert_allclose(result.field("Cycles_To_First_Break"), first, rtol=1e-6)

    def test_a_run_that_goes_on_is_the_one_that_never_stopped(self):
        whole = self.run_until(1.4)
        history, displacement = whole.history(), whole.field("Displacement")
        self.run_until(0.3)
        resumed = self.run_until(1.4, arguments=["--restart", "result.checkpoint.h5"])
        for label, values in history.items():
            np.testing.assert_array_equal(resumed.history()[label], values, err_msg=label)
        np.testing.assert_array_equal(resumed.field("Displacement"), displacement)


class Springs(SceneTest):
    def test_springs_go_on_to_the_last_bit_where_both_runs_wrote_the_checkpoint(self):
        # What conjugate gradients have of the bonds that were is renewed there, in the run that goes on as well.
        deck = cracked_plate(self, solver={**until(1.4), "Preconditioner": "Two Level"})
        deck["Output2"] = {"Output Filename": "early", "Output Variables": ["Damage"], "Final Output Step": 6,
                           "Checkpoint Frequency": 6}
        whole = self.solve(deck)
        history, displacement = whole.history(), whole.field("Displacement")
        self.assertGreater(len(history["time"]), 12)
        resumed = self.solve(deck, arguments=["--restart", "early.checkpoint.h5"])
        for label, values in history.items():
            np.testing.assert_array_equal(resumed.history()[label], values, err_msg=label)
        np.testing.assert_array_equal(resumed.field("Displacement"), displacement)
        over = self.run_deck(deck, arguments=["--check", "--restart", "early.checkpoint.h5", "--set",
                                              "Solver/Final Time=1.0"])
        self.assertEqual(over.code, 2, over.text)
        self.assertRegex(over.text, r"cycles\) lies at or beyond the end of the last increment .*Final Time 1 cycles\)")


class FatigueThatScatters(Fatigue):
    """Each bond has constants of its own, by the numbers of its ends."""

    damage = {"Damage Model": "Cumulative Fatigue", "Ductility Coefficient": 1.0, "Ductility Exponent": -0.6,
              "Strain Limit": 1e-3, "Scatter Between": "Bonds", "Random Seed": 3, "Scatter Of Limit": 0.1,
              "Scatter Of Ductility": 0.2, "Scatter Of Exponent": 0.02}


if __name__ == "__main__":
    unittest.main()
