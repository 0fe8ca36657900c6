"""Two pits that grow and merge: the scene of tests on several ranks and of restarts, with each of the rules of corrosion."""
import numpy as np

from corrosion_scene import SPACING, STEEL, CorrosionTest, corrosion_deck

# Salt covers the surface most of the time.
SALTED = {**STEEL, "Current Density": "5.0e5*(0.2 + C)"}
PITS = " && ".join(f"(x - {x!r})*(x - {x!r}) + y*y > 3.6e-11" for x in (11.2e-6, 30.7e-6))
HELD = " || ".join(f"(x - {x!r})*(x - {x!r}) + y*y < 4e-12" for x in (11.2e-6, 30.7e-6))
FIELDS = ("Concentration", "Damage", "Salt_Coverage")


class Plate(CorrosionTest):
    """Two pits of different distance to the sides that grow and merge."""

    def setUp(self):
        super().setUp()
        self.make_lattice([48e-6, 20e-6])

    def deck(self, metal, time, steps, name="result", **solver):
        deck = corrosion_deck(2, metal, PITS, HELD, time, steps, name, **solver)
        # Results of another order of summation differ by what the tolerance of the linear systems leaves.
        deck["Solver"]["Corrosion"]["Solver Tolerance"] = 1e-12
        return deck

    def assert_same(self, found, expected, what, allowed=1e-8):
        self.assertEqual(found.steps(), expected.steps())
        for step in expected.steps():
            a, b = found.field("Damage", step), expected.field("Damage", step)
            np.testing.assert_array_equal(a == 1.0, b == 1.0, f"{what}: phases of step {step}")
            np.testing.assert_allclose(a, b, rtol=0.0, atol=allowed, err_msg=f"{what}: Damage of step {step}")
            np.testing.assert_allclose(found.field("Concentration", step), expected.field("Concentration", step),
                                       rtol=0.0, atol=allowed * STEEL["Solid Concentration"], err_msg=what)
        depths = found.history()["Dissolved"], expected.history()["Dissolved"]
        np.testing.assert_allclose(depths[0], depths[1], rtol=allowed, atol=allowed * SPACING**2, err_msg=what)


class RestartTest(Plate):
    """A run that ends early, then goes on from its checkpoint, ends as one that ran through, to the last bit."""

    def restart(self, metal, time, ranks, later_ranks, whole=None, **solver):
        """Of one run: the whole on `ranks`, unless it is there, and half of it, then the rest on `later_ranks`."""
        expected = whole or self.solve(self.deck(metal, time, 8, "whole", **solver), ranks=ranks)
        half = self.deck(metal, time / 2, 4, "half", **solver)
        half["Output"]["Checkpoint Frequency"] = 4
        self.solve(half, ranks=ranks)
        found = self.solve(self.deck(metal, time, 8, "half", **solver), ranks=later_ranks,
                           arguments=["--restart", "half.checkpoint.h5"])
        self.assertEqual(found.steps()[-1], 8)
        return found, expected

    def check_restart(self, metal, time, ranks=1, **solver):
        found, expected = self.restart(metal, time, ranks, ranks, **solver)
        for label in FIELDS:
            np.testing.assert_array_equal(found.field(label, 8), expected.field(label, 8), label)


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
