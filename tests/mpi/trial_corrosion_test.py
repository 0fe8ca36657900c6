#!/usr/bin/python3
"""Corrosion with the interface kernel of a trial calibration: what tests/mpi/corrosion_test.py asks, with both rules."""
import os
import sys
import unittest

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [here, os.path.join(here, "../support")]
import corrosion_test  # noqa: E402
import stochastic_corrosion_test  # noqa: E402
from corroding_pits import Trial  # noqa: E402


class Ranks(Trial, corrosion_test.Ranks):
    ranks = (4,)  # of two as well in corrosion_test.py
    test_fixed_steps = test_explicit_methods = None  # nothing of them is the kernel's


class StochasticRanks(Trial, stochastic_corrosion_test.Ranks):
    test_another_seed_differs = test_explicit_methods = test_eight_ranks = None


class Restarts(Trial, corrosion_test.Restarts):
    other_numbers = ((2, 3),)


if __name__ == "__main__":
    unittest.main()
