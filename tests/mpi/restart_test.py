#!/usr/bin/python3
"""Runs that go on from a checkpoint on other ranks than wrote it."""
import sys
import unittest

sys.path.insert(0, sys.path[0] + "/../support")
from restart_scene import OTHER_LENGTHS, RestartTest  # noqa: E402


class OnOtherRanks(RestartTest):
    def test_each_solver_goes_on(self):
        for case in ("Verlet", "QuasiStatic", "RKL", "TR-BDF2", "Staggered list"):
            with self.subTest(case):
                deck, expected = self.start(case)
                # What an equilibrium or a linear solve to its tolerance leaves open, and rounding.
                self.assert_close(self.last(self.go_on(deck, ranks=2), case), expected, 1e-9, case)

    def test_tables_of_another_length_are_refused(self):
        deck, _ = self.start("QuasiStatic")
        self.check_tables(deck, OTHER_LENGTHS, ranks=2)


if __name__ == "__main__":
    unittest.main()
