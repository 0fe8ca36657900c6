#!/usr/bin/python3
"""Corrosion on several ranks, and from their checkpoints: the same phases, depth and concentrations."""
import os
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, "../support"), os.path.join(here, "../../decks/crevice")]
from corroding_pits import FIELDS, SALTED, Plate, RestartTest  # noqa: E402
from corrosion_scene import STEEL  # noqa: E402
from gap_averaged import HOUR  # noqa: E402
from scene import Result, SceneTest, mpirun, pdrun_path  # noqa: E402
from time_steps import SHORT, prepare  # noqa: E402


class Ranks(Plate):
    ranks = (2, 4)  # where nothing else differs; else 4, which border on more of each other
    explicit_methods = ("Euler", "RKL")

    def compare(self, metal, time, least=200, ranks=(4,), **solver):
        expected = self.solve(self.deck(metal, time, 8, "one", **solver))
        self.check(expected, metal)
        dissolved = np.sum((expected.field("Damage") == 1.0) & (expected.field("Damage", 0) < 1.0))
        self.assertGreater(dissolved, least)
        for number in ranks:
            found = self.solve(self.deck(metal, time, 8, f"ranks{number}", **solver), ranks=number)
            self.check(found, metal)
            self.assert_same(found, expected, f"{number} ranks")

    def test_activation_control(self):
        self.compare(STEEL, 40.0, ranks=self.ranks)

    def test_salt(self):
        self.compare(SALTED, 4.0, ranks=self.ranks)

    def test_fixed_steps(self):
        self.compare(STEEL, 40.0, **{"Fixed dt": 1.0})

    def test_explicit_methods(self):
        for method in self.explicit_methods:
            self.compare(SALTED, 4.0, Method=method)

    def test_eight_ranks(self):
        expected, found = (self.solve(self.deck(STEEL, 10.0, 4, name), ranks=ranks)
                           for name, ranks in (("one", 1), ("eight", 8)))
        self.check(found, STEEL)
        self.assert_same(found, expected, "8 ranks")

    def test_second_order(self):
        self.overshoot = 1e-2
        self.compare(SALTED, 1.5, 100, Method="SDIRK2")

    def test_polak_ribiere(self):
        self.compare(SALTED, 0.5, 30, **{"Nonlinear Solver": "Polak Ribiere"})


class Restarts(RestartTest):
    other_numbers = ((1, 2), (4, 1), (2, 3))

    def test_on_two_ranks(self):
        self.check_restart(SALTED, 2.0, ranks=2)

    def test_before_any_point_has_turned_liquid(self):
        # Rates read at ghosts are not to be added to those of their owners.
        self.check_restart(STEEL, 4.0, ranks=2)

    def test_on_another_number_of_ranks(self):
        expected = None
        for ranks, later_ranks in self.other_numbers:
            found, expected = self.restart(SALTED, 2.0, ranks, later_ranks, expected)
            a, b = found.field("Damage", 8), expected.field("Damage", 8)
            np.testing.assert_array_equal(a == 1.0, b == 1.0, f"{ranks}, then {later_ranks} ranks")
            # Seen: 2e-10, and nothing where Damage counts bonds.
            np.testing.assert_allclose(a, b, rtol=0.0, atol=1e-8)
            np.testing.assert_allclose(found.field("Concentration", 8), expected.field("Concentration", 8), rtol=0.0,
                                       atol=1e-8 * STEEL["Solid Concentration"])


class CreviceRestarts(SceneTest):
    """A short crevice, which asks for a preconditioner and for no more than 1e-6 of saturation: electrolyte that a
    checkpoint holds may exceed it by that. In its first hour no point turns liquid."""

    def test_on_the_same_and_another_number_of_ranks(self):
        folder = Path(self.folder)
        prepare(SHORT, folder)

        def run(hours, name, ranks, *arguments, checkpoint=False):
            settings = {**SHORT.settings(), "Solver/Final Time": hours * HOUR, "Solver/Corrosion/Load Steps": hours,
                        "Output/Output Filename": name, "Output/Checkpoint Frequency": 1 if checkpoint else -1}
            sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
            process = subprocess.run([*mpirun(ranks), pdrun_path(), "crevice.yaml", "--quiet", *sets, *arguments],
                                     cwd=folder, capture_output=True, text=True, timeout=250)
            self.assertEqual(process.returncode, 0, process.stdout + process.stderr)
            return Result(self.folder, name, process)

        for ranks, later_ranks in ((1, 1), (2, 2), (2, 1)):
            if ranks == later_ranks:
                whole = run(2, "whole", ranks)
            run(1, "half", ranks, checkpoint=True)
            rest = run(2, "half", later_ranks, "--restart", "half.checkpoint.h5")
            if ranks == later_ranks:
                for label in FIELDS[:2]:
                    np.testing.assert_array_equal(rest.field(label, 2), whole.field(label, 2), f"{label}, {ranks}")
            # Of another order of summation the tolerance leaves 3e-5.
            np.testing.assert_allclose(rest.field("Damage", 2), whole.field("Damage", 2), rtol=0.0, atol=1e-3)


if __name__ == "__main__":
    unittest.main()
