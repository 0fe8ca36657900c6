#!/usr/bin/python3
"""Corrosion whose bonds break at random: what tests/mpi/corrosion_test.py asks, and the same bonds."""
import os
import sys
import unittest

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [here, os.path.join(here, "../support")]
import corrosion_test  # noqa: E402
from corroding_pits import Stochastic  # noqa: E402
from corrosion_scene import STEEL  # noqa: E402


class Ranks(Stochastic, corrosion_test.Ranks):
    ranks = (4,)  # the solver's own dependence on them is tested without random numbers
    explicit_methods = ("RKL",)
    test_fixed_steps = test_polak_ribiere = None

    def test_another_seed_differs(self):
        one = self.solve(self.deck(STEEL, 40.0, 8, "one"))
        self.seed = 8
        other = self.solve(self.deck(STEEL, 40.0, 8, "other"))
        self.assertTrue(any(np.any(one.field("Damage", step) != other.field("Damage", step)) for step in one.steps()))


class Restarts(Stochastic, corrosion_test.Restarts):
    other_numbers = ((2, 3),)


if __name__ == "__main__":
    unittest.main()
