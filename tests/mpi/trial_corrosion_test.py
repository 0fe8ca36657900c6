#!/usr/bin/python3
"""Corrosion with the interface kernel of a trial calibration: what tests/mpi/corrosion_test.py asks, with both rules."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import corrosion_test  # noqa: E402
import stochastic_corrosion_test  # noqa: E402


class Trial:
    def deck(self, *args, **kwargs):
        deck = super().deck(*args, **kwargs)
        deck["Materials"]["Metal"]["Interface Kernel"] = "Trial Calibration"
        return deck

    def outcome(self, result):
        """What the report says of the trial, once."""
        lines = [line for line in result.report["solver"] if "trial calibration" in line]
        self.assertEqual(len(lines), 1)
        return lines[0]

    def assert_same(self, found, expected, what, allowed=1e-8):
        super().assert_same(found, expected, what, allowed)
        self.assertEqual(self.outcome(found), self.outcome(expected))

    test_fixed_steps = test_explicit_methods = None  # nothing of them is the kernel's


class Ranks(Trial, corrosion_test.Ranks):
    ranks = (4,)  # of two as well in corrosion_test.py


class StochasticRanks(Trial, stochastic_corrosion_test.Ranks):
    test_another_seed_differs = None


class Restarts(Trial, corrosion_test.Restarts):
    test_activation_control = test_salt = None


if __name__ == "__main__":
    unittest.main()
