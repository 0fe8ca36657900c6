#!/usr/bin/python3
"""Corrosion that goes on from a checkpoint of the same rank, to the last bit: each method, each rule."""
import sys
import unittest

sys.path.insert(0, sys.path[0] + "/../support")
from corroding_pits import SALTED, RestartTest, Stochastic, Trial  # noqa: E402
from corrosion_scene import STEEL  # noqa: E402


class Restarts(RestartTest):
    def test_activation_control(self):
        self.check_restart(STEEL, 40.0)

    def test_salt(self):
        self.check_restart(SALTED, 2.0)

    def test_fixed_steps(self):
        self.check_restart(STEEL, 40.0, **{"Fixed dt": 1.0})

    def test_explicit_methods(self):
        for method in ("Euler", "RKL"):
            self.check_restart(SALTED, 1.0, Method=method)

    def test_second_order(self):
        self.check_restart(SALTED, 2.0, Method="SDIRK2")

    def test_polak_ribiere(self):
        self.check_restart(SALTED, 0.5, **{"Nonlinear Solver": "Polak Ribiere"})


class StochasticRestarts(Stochastic, Restarts):
    pass


class TrialRestarts(Trial, Restarts):
    test_fixed_steps = test_explicit_methods = None  # nothing of them is the kernel's


if __name__ == "__main__":
    unittest.main()
