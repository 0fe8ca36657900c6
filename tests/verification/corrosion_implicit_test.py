#!/usr/bin/python3
"""Implicit steps of a dissolving body: order in time, bounds of concentrations, and the solvers of their equations."""
import os
import re
import sys
import unittest
from math import pi

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from corrosion_scene import SPACING, STEEL, CorrosionTest, corrosion_deck  # noqa: E402

IMPLICIT = ("Backward Euler", "SDIRK2")
SALTED = {**STEEL, "Current Density": "5.0e5*(0.2 + C)"}
POLAK = {"Nonlinear Solver": "Polak Ribiere"}


def counted(result, unit):
    return int(re.search(rf"(\d+) {unit}", " ".join(result.report["solver"])).group(1))


class OrderInTime(CorrosionTest):
    """Halving the step divides the error of backward Euler by two, that of SDIRK2 by four."""

    TIME, STEPS = 4.0, (0.5, 0.25, 0.125)

    def check_order(self, concentrations):
        """`concentrations(method, h)`: of the electrolyte at the end."""
        exact = concentrations("SDIRK2", self.STEPS[-1] / 16)
        errors = {method: [np.sqrt(np.mean((concentrations(method, h) - exact) ** 2)) for h in self.STEPS]
                  for method in IMPLICIT}
        for method, ratio, allowed in (("Backward Euler", 2.0, 0.25), ("SDIRK2", 4.0, 0.5)):
            for coarse, fine in zip(errors[method], errors[method][1:]):
                self.assertAlmostEqual(coarse / fine, ratio, delta=allowed, msg=str(errors))
        self.assertLess(errors["SDIRK2"][0], 0.2 * errors["Backward Euler"][0])

    def test_electrolyte_with_an_end_that_rises(self):
        """Fixed phases, no metal: half a cosine dies out beside an end that rises as the square of the sine does."""
        length = 100e-6
        self.make_lattice([length + 4e-6], [-4e-6])

        def concentrations(method, h):
            deck = corrosion_deck(1, STEEL, "x >= 0", "x < 0", self.TIME, 1, Method=method, **{"Fixed dt": h})
            deck["Boundary Conditions"]["Metal"]["Value"] = f"1000 - 1000*cos({pi / length!r}*x)"
            deck["Boundary Conditions"]["Sea"]["Value"] = "2000*sin(0.4*t)*sin(0.4*t)"
            return self.solve(deck).field("Concentration")

        self.check_order(concentrations)

    def test_wall_that_hardly_moves(self):
        """A metal so rich that its wall stays where it is, and gives the more the more is dissolved."""
        metal = {**STEEL, "Solid Concentration": 1.0e12, "Current Density": "2.0e3*(0.2 + C)"}
        self.make_lattice([60e-6])

        def concentrations(method, h):
            deck = corrosion_deck(1, metal, "x > 50e-6", None, self.TIME, 1, Method=method, **{"Fixed dt": h})
            result = self.solve(deck)
            liquid = self.x[:, 0] < 50e-6
            self.assertTrue(np.array_equal(result.field("Damage") >= 1.0, liquid))
            c = result.field("Concentration")[liquid]
            self.assertGreater(np.max(c), 300.0)
            self.assertLess(np.max(c), metal["Saturation Concentration"])
            return c

        self.check_order(concentrations)


class SecondOrderUnderSalt(CorrosionTest):
    overshoot = 1e-2

    def gap(self, method, metal=SALTED, time=2.0, **solver):
        """A closed gap that fills from one end, where the electrolyte is saturated to begin with."""
        self.make_lattice([80e-6, 6e-6])
        deck = corrosion_deck(2, metal, "y > 3e-6", "x < 4e-6 && y < 3e-6", time, 2, Method=method, **solver)
        deck["Boundary Conditions"].update({
            "Start Node Set": {"Expression": "x > 70e-6 && y < 3e-6"},
            "Start": {"Type": "Initial Concentration", "Node Set": "Start Node Set", "Value": 4500.0}})
        result = self.solve(deck)
        self.check(result, metal)
        return result

    def test_closer_than_backward_euler(self):
        """Saturation spreads along a gap whose walls hardly move."""
        metal = {**STEEL, "Solid Concentration": 1.0e9, "Current Density": "1.0e3*(0.2 + C)"}

        def concentrations(method, h):
            result = self.gap(method, metal, 1.0, **{"Fixed dt": h})
            self.assertGreater(np.count_nonzero(result.field("Salt_Coverage")), 10)
            return result.field("Concentration")[self.x[:, 1] < 3e-6] / metal["Saturation Concentration"]

        exact = concentrations("SDIRK2", 0.0025)
        errors = {(method, h): np.sqrt(np.mean((concentrations(method, h) - exact) ** 2))
                  for method in IMPLICIT for h in (0.1, 0.0125)}
        self.assertLess(errors["Backward Euler", 0.0125], 0.2 * errors["Backward Euler", 0.1], errors)
        self.assertLess(errors["SDIRK2", 0.1], 0.5 * errors["Backward Euler", 0.1], errors)
        self.assertLess(errors["SDIRK2", 0.0125], 0.5 * errors["Backward Euler", 0.0125], errors)

    def test_same_depth(self):
        depths = [self.gap(method).history()["Dissolved"][-1] for method in IMPLICIT]
        self.assertGreater(depths[0], 20 * SPACING**2)
        self.assertAlmostEqual(depths[1] / depths[0], 1.0, delta=0.02)

    def test_long_steps_beside_a_jump(self):
        """Where SDIRK2 would leave less than nothing, backward Euler takes its place."""
        self.make_lattice([60e-6])
        deck = corrosion_deck(1, STEEL, "x > 4e-6", "x < 4e-6", 20.0, 1, Method="SDIRK2", **{"Fixed dt": 10.0})
        deck["Boundary Conditions"]["Metal"]["Value"] = "x > 50e-6 ? 4500 : 0"
        result = self.solve(deck)
        self.check(result, STEEL)
        self.assertGreater(counted(result, "steps of backward Euler instead"), 0)


class NonlinearSolvers(CorrosionTest):
    """Newton's method and Polak and Ribiere's come to the same."""

    def both(self, metal, steps, **solver):
        self.make_lattice([40e-6, 8e-6])
        evaluations, fields = [], []
        for choice in ({}, POLAK):
            deck = corrosion_deck(2, metal, "y > 4e-6", "x < 4e-6 && y < 4e-6", 1.0, steps, **choice, **solver)
            deck["Solver"]["Corrosion"].setdefault("Solver Tolerance", 1e-10)
            result = self.solve(deck)
            self.check(result, metal)
            evaluations.append(counted(result, "evaluations"))
            fields.append([result.field(name) for name in ("Damage", "Concentration", "Salt_Coverage")])
        for name, one, other, scale in zip(("Damage", "Concentration", "Salt"), *fields,
                                           (1.0, metal["Solid Concentration"], 1.0)):
            np.testing.assert_allclose(one, other, rtol=0.0, atol=1e-6 * scale, err_msg=name)
        self.assertGreater(np.sum(fields[0][0] == 1.0), 40 * 4)
        return evaluations

    def test_salt(self):
        for method in IMPLICIT:
            self.overshoot = 1e-2 if method == "SDIRK2" else 1e-8
            newton, polak = self.both(SALTED, 4, Method=method)
            # On square cells and in a body as small as this one neither is far ahead.
            self.assertLess(newton, 1.1 * polak)

    def test_rate_that_grows_quickly(self):
        """A thousandfold from C = 0 to saturation: what long steps minimise is not convex."""
        self.both({**STEEL, "Current Density": "2.0e4*exp(1.5*C)"}, 2, **{"Fixed dt": 0.1})

    def check_pausing(self, result, metal):
        match = re.search(r"the balance is off by (\S+) of it", " ".join(result.report["solver"]))
        self.assertLess(float(match.group(1)), 1e-10)
        self.assertTrue(np.any(result.field("Salt_Coverage") == 1.0))

    def test_pausing_surfaces(self):
        self.check = self.check_pausing
        for method in IMPLICIT:
            self.both({**STEEL, "Current Density": "5.0e4*(0.5 + C)"}, 1, Saturation="Pause", Method=method,
                      **{"Fixed dt": 5e-3})

    def test_refused_with_explicit_methods(self):
        self.make_lattice([12e-6])
        result = self.run_deck(corrosion_deck(1, STEEL, "x > 0", None, 1.0, 1, Method="RKL", **POLAK))
        self.assertEqual(result.code, 2, result.text)
        for word in ("Nonlinear Solver", "RKL", "Backward Euler", "SDIRK2"):
            self.assertIn(word, result.text)
        self.assertRegex(result.text, r"deck\.yaml:\d+:\d+")


if __name__ == "__main__":
    unittest.main()
