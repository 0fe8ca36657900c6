#!/usr/bin/python3
"""bar.yaml: the force of its springs and the life of its bonds against closed forms."""
import os
import shutil
import subprocess
import sys
import unittest

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "support"))
from scene import Result, SceneTest, mpirun, pdrun_path  # noqa: E402

SPACING, VOLUME, MICROMODULUS, STRETCH = 0.01, 0.01**3, 1.0e15, 1.0e-3
RATE, N_STEPS, DT = 5.0e5, 10, 0.1


class Bar(SceneTest):
    def run_bar(self, *changes, ranks=1):
        shutil.copy(os.path.join(HERE, "bar.yaml"), self.folder)
        options = [word for change in changes for word in ("--set", change)]
        process = subprocess.run([*mpirun(ranks), pdrun_path(), "bar.yaml", "--quiet", *options], cwd=self.folder,
                                 capture_output=True, text=True, timeout=100)
        result = Result(self.folder, "bar", process)
        self.assertEqual(result.code, 0, result.text)
        return result

    def test_force_and_life(self):
        # Three bonds cross a section: one of a spacing, two of two. Each step takes A s^2 dt = 1/20 of every life.
        for ranks in (1, 2):
            history = self.run_bar(ranks=ranks).history()
            force = 3 * MICROMODULUS * STRETCH * VOLUME**2
            np.testing.assert_allclose(history["PullX"][1:], force, rtol=1e-8)
            np.testing.assert_allclose(history["Most_Lost_Life"], RATE * STRETCH**2 * DT * np.arange(N_STEPS + 1),
                                       rtol=1e-8, atol=1e-12)

    def test_bonds_break_in_the_order_of_their_stretch(self):
        # u = a x^2 stretches the bond from x to x + l by a (2 x + l): it is broken after the step in which its life
        # ends. No bond's life ends within round-off of a step's end.
        a, exponent, rate = 0.01, 3.0, 3.1e7
        result = self.run_bar("Boundary Conditions/Pull Left/Node Set=All Node Set",
                              f"Boundary Conditions/Pull Left/Value={a}*x^2",
                              f"Boundary Conditions/Pull Right/Value={a}*x^2",
                              f"Damage Models/Tiring/Exponent={exponent}", f"Damage Models/Tiring/Rate={rate}")
        x = SPACING * (np.arange(20) + 0.5)
        for step in range(1, N_STEPS + 1):
            expected = np.zeros(20)
            for i in range(20):
                others = [j for j in (i - 2, i - 1, i + 1, i + 2) if 0 <= j < 20]
                lives = [step * DT * rate * (a * (x[i] + x[j]))**exponent for j in others]
                self.assertTrue(all(abs(life - 1.0) > 1e-6 for life in lives))
                expected[i] = np.mean([life >= 1.0 for life in lives])
            np.testing.assert_array_equal(result.field("Damage", step), expected, err_msg=f"step {step}")
        self.assertTrue(0.1 < expected.mean() < 0.9)


if __name__ == "__main__":
    unittest.main()
