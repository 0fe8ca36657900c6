#!/usr/bin/python3
"""Corrosion whose bonds break at random: what tests/mpi/corrosion_test.py asks, and the same bonds."""
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import corrosion_test  # noqa: E402


class Stochastic:
    seed = 7

    def deck(self, *args, **kwargs):
        deck = super().deck(*args, **kwargs)
        deck["Damage Models"]["Phases"].update({"Rule": "Stochastic", "Random Seed": self.seed})
        deck["Output"]["Output Variables"].append("Loose")
        return deck

    def assert_same(self, found, expected, what, allowed=1e-8):
        super().assert_same(found, expected, what, allowed)
        for step in expected.steps():
            # Damage counts broken bonds.
            for label in ("Damage", "Loose"):
                np.testing.assert_array_equal(found.field(label, step), expected.field(label, step), f"{what}: {label}")


class Ranks(Stochastic, corrosion_test.Ranks):
    ranks = (4,)  # the solver's own dependence on them is tested without random numbers

    def test_another_seed_differs(self):
        one = self.solve(self.deck(corrosion_test.STEEL, 40.0, 8, "one"))
        self.seed = 8
        other = self.solve(self.deck(corrosion_test.STEEL, 40.0, 8, "other"))
        self.assertTrue(any(np.any(one.field("Damage", step) != other.field("Damage", step)) for step in one.steps()))


class Restarts(Stochastic, corrosion_test.Restarts):
    test_salt = None  # test_on_two_ranks asks it of the same deck


if __name__ == "__main__":
    unittest.main()
