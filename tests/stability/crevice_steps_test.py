#!/usr/bin/python3
"""Time steps that differ a hundredfold carve the same trench in a crevice, where finite volumes have it; a thousandfold:
decks/crevice/time_steps.py."""
import os
import sys
import unittest
from math import ceil
from pathlib import Path

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, "../support"), os.path.join(here, "../../decks/crevice")]
from gap_averaged import HOUR  # noqa: E402
from scene import SceneTest, pdrun_path  # noqa: E402
from time_steps import SHORT, STEPS, prepare, run  # noqa: E402
from trench import carve  # noqa: E402


class TimeSteps(SceneTest):
    def test_five_seconds_to_five_hundred(self):
        folder = Path(self.folder)
        prepare(SHORT, folder)
        found = {step: run(pdrun_path(), SHORT, folder, step) for step in (*STEPS[1:], None)}
        reference = found[STEPS[1]]
        # A trench, not what attack has left behind on its way to the mouth.
        self.assertGreater(reference.depth, 15e-6)
        self.assertLess(reference.place, 0.4 * SHORT.crevice.length)
        for step, trench in found.items():
            self.assertLessEqual(abs(trench.place - reference.place), 1.01 * SHORT.dx, step)
            self.assertAlmostEqual(trench.depth / reference.depth, 1.0, delta=0.03, msg=step)
            self.assertAlmostEqual(trench.lost / reference.lost, 1.0, delta=0.03, msg=step)
            if step is not None:
                # None was divided. Those of an hour end with it.
                self.assertEqual(trench.steps, SHORT.hours * ceil(HOUR / step))
        # From a state averaged over the gap at 1 h on: 20.8 um; of 160, 320 and 640 columns 20.9, 20.8 and 20.6.
        exact = carve(SHORT.crevice, hours=SHORT.hours, length=SHORT.crevice.length, start=1)
        depth, place = exact.deepest()[:2]
        self.assertAlmostEqual(reference.depth / depth, 1.0, delta=0.1)
        self.assertLessEqual(abs(reference.place - place), 1.01 * SHORT.dx)


if __name__ == "__main__":
    unittest.main()
