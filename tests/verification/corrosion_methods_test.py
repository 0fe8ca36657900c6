#!/usr/bin/python3
"""Ways to step a dissolving body in time, against each other and exact solutions."""
import os
import re
import sys
import unittest
from math import erf, exp, pi, sqrt

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, "../support"), os.path.join(here, "../../decks/pencil")]
from corrosion_scene import HORIZON, SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402
from moving_front import depths  # noqa: E402

TIME, EXPLICIT = 60.0, ("Euler", "RKL")
# Chen & Bobaru, J. Mech. Phys. Solids 78 (2015) 352, whose lambda this is.
METAL = {"Diffusivity": 850e-12, "Solid Concentration": 143000.0, "Saturation Concentration": 5100.0,
         "Charge Number": 2.19, "Current Density": "1.0e6"}
STEFAN_NUMBER = 0.13516


class MethodTest(CorrosionTest):
    def run_pencil(self, metal=METAL, time=TIME, **solver):
        self.make_lattice([87e-6], [-7e-6])
        return self.corrode(1, metal, "x > 0", "x < 0", time, 1, **solver)

    def depth(self, *args, **solver):
        return self.run_pencil(*args, **solver).history()["Dissolved"][-1]

    def work(self, result, unit):
        return int(re.search(rf"(\d+) {unit}", " ".join(result.report["solver"])).group(1))


class Methods(MethodTest):
    def test_stefan_number(self):
        number, ratio = STEFAN_NUMBER, 5100.0 / (143000.0 - 5100.0)
        self.assertAlmostEqual(sqrt(pi) * number * exp(number**2) * erf(number), ratio, delta=1e-5)

    def test_explicit_methods_under_salt(self):
        exact = 2.0 * STEFAN_NUMBER * sqrt(METAL["Diffusivity"] * TIME)
        implicit = self.run_pencil()
        evaluations = {}
        for method in EXPLICIT:
            result = self.run_pencil(Method=method)
            depth = result.history()["Dissolved"][-1]
            self.assertAlmostEqual(depth / implicit.history()["Dissolved"][-1], 1.0, delta=2e-3, msg=method)
            # Salt keeps half a horizon saturated: the front is ahead by no more than that.
            self.assertLess(abs(depth - exact), 0.5 * HORIZON, method)
            liquid = result.field("Damage") >= 1.0
            difference = np.abs(result.field("Concentration") - implicit.field("Concentration"))
            both = liquid & (implicit.field("Damage") >= 1.0)
            self.assertLess(np.max(difference[both]), 0.02 * METAL["Saturation Concentration"], method)
            evaluations[method] = self.work(result, "evaluations")
        # Steps of the length that the front allows need s stages where Euler needs about s^2/2 sub-steps.
        self.assertLess(evaluations["RKL"], 0.25 * evaluations["Euler"])

    def test_explicit_methods_where_the_current_rules(self):
        for method in EXPLICIT:
            depth = self.depth(STEEL, 120.0, Method=method)
            self.assertAlmostEqual(depth / (front_speed(STEEL) * 120.0), 1.0, delta=1e-9, msg=method)

    def test_steps_of_rkl_that_differ_tenfold(self):
        found = [self.depth(Method="RKL", **{"Fixed dt": h}) for h in (0.05, 0.5)]
        self.assertAlmostEqual(found[1] / found[0], 1.0, delta=0.01)

    def test_second_order_in_time(self):
        """A cosine in an electrolyte without metal: halving the step divides the error of RKL by four, that of backward
        Euler by two."""
        length, wave = 200e-6, pi / 200e-6
        self.make_lattice([length])

        def amplitudes(method, h):
            deck = corrosion_deck(1, STEEL, "x >= 0", None, 4.0, 1, Method=method, **{"Fixed dt": h})
            deck["Boundary Conditions"]["Metal"]["Value"] = f"2000 + 1500*cos({wave!r}*x)"
            c = self.solve(deck).field("Concentration")
            return 2.0 * np.mean((c - 2000.0) * np.cos(wave * self.x[:, 0])) / 1500.0

        reference = amplitudes("Euler", 4.0)
        self.assertAlmostEqual(reference / exp(-STEEL["Diffusivity"] * wave**2 * 4.0), 1.0, delta=0.01)
        rkl = [abs(amplitudes("RKL", h) - amplitudes("RKL", 0.0625)) for h in (2.0, 1.0, 0.5)]
        euler = [abs(amplitudes("Backward Euler", h) - reference) for h in (2.0, 1.0, 0.5)]
        for coarse, fine in zip(rkl, rkl[1:]):
            self.assertGreater(coarse, 3.5 * fine, rkl)
        for coarse, fine in zip(euler, euler[1:]):
            self.assertAlmostEqual(coarse / fine, 2.0, delta=0.3, msg=str(euler))

    def test_far_field(self):
        self.make_lattice([60e-6], [-7e-6])
        lost = {}
        for method in ("Backward Euler", "SDIRK2", *EXPLICIT):
            deck = corrosion_deck(1, METAL, "x > 0", None, 20.0, 2, Method=method)
            deck["Boundary Conditions"].update({
                "Mouth Node Set": {"Expression": "x < -3.0e-6"},
                "Mouth": {"Type": "Far Field Concentration", "Node Set": "Mouth Node Set", "Value": 0.0,
                          "Distance": 20e-6, "Diffusivity": METAL["Diffusivity"], "Area": 1.0}})
            result = self.solve(deck)
            self.check(result, METAL)
            lost[method] = self.amount(result, 0) - self.amount(result)
        for method in ("SDIRK2", *EXPLICIT):
            self.assertAlmostEqual(lost[method] / lost["Backward Euler"], 1.0, delta=5e-3, msg=str(lost))

    def test_unknown_choices_are_refused(self):
        self.make_lattice([12e-6])
        for key, known in (("Method", ("Backward Euler", "SDIRK2", "Euler", "RKL")),
                           ("Nonlinear Solver", ("Newton Krylov", "Polak Ribiere")),
                           ("Saturation", ("Complementarity", "Pause"))):
            result = self.run_deck(corrosion_deck(1, METAL, "x > 0", None, 1.0, 1, **{key: "Sometimes"}))
            self.assertEqual(result.code, 2, result.text)
            self.assertRegex(result.text, r"deck\.yaml:\d+:\d+")
            for name in (key, "Sometimes", *known):
                self.assertIn(name, result.text)


class PausingSurfaces(MethodTest):
    """Surfaces that dissolve freely or not at all, in steps in which they do not fill the electrolyte far beyond
    saturation."""

    # Diffusion takes over at z F D C_sat/i = 18 um. A step of 5 ms of the bare surface takes 0.8 % of a point.
    METAL = {**METAL, "Current Density": "5.0e4"}
    STEP = 5e-3
    is_paused = True

    def check(self, result, metal):
        """Where surfaces pause, electrolyte may hold more than saturation, and salt is all or nothing."""
        if not self.is_paused:
            super().check(result, metal)
            return
        match = re.search(r"the balance is off by (\S+) of it", " ".join(result.report["solver"]))
        self.assertLess(float(match.group(1)), 1e-10)
        saturation = metal["Saturation Concentration"]
        c, liquid = result.field("Concentration"), result.field("Damage") >= 1.0
        self.assertGreaterEqual(np.min(c), -1e-8 * saturation)
        self.assertLess(np.max(c[liquid]), 1.3 * saturation)
        self.assertTrue(np.all(np.isin(result.field("Salt_Coverage")[liquid], (0.0, 1.0))))

    def test_same_depth_as_with_complementarity(self):
        """At the small step; complementarity at a hundred times the step as well."""
        t = np.array([TIME])
        reference = depths(t, self.METAL["Diffusivity"], self.METAL["Solid Concentration"],
                           self.METAL["Saturation Concentration"], front_speed(self.METAL))[0]
        self.is_paused = False
        robust = [self.depth(self.METAL, **solver) for solver in ({"Fixed dt": 100.0 * self.STEP}, {})]
        self.is_paused = True
        paused = [self.depth(self.METAL, Saturation="Pause", Method=method, **{"Fixed dt": self.STEP})
                  for method in ("Backward Euler", "SDIRK2", *EXPLICIT)]
        for depth in robust + paused:
            self.assertAlmostEqual(depth / robust[0], 1.0, delta=0.02, msg=f"{robust} {paused}")
            self.assertAlmostEqual(depth / reference, 1.0, delta=0.02, msg=f"{robust} {paused} {reference}")

    def test_same_depth_in_a_plane(self):
        """The same, of points that wander by a tenth of a spacing: salt comes at 11 s, in one row before the next."""
        width, time = 6e-6, 30.0
        reference = depths(np.array([time]), self.METAL["Diffusivity"], self.METAL["Solid Concentration"],
                           self.METAL["Saturation Concentration"], front_speed(self.METAL))[0]
        for jitter in (0.0, 0.1):
            self.make_lattice([60e-6, width], [-7e-6, 0.0])
            wander = jitter * SPACING * np.random.default_rng(1).uniform(-1.0, 1.0, (len(self.x), 2))
            self.write_mesh(self.x + np.column_stack([wander, np.zeros(len(self.x))]), self.volume)
            for method in ("Backward Euler", "Euler"):
                result = self.corrode(2, self.METAL, "x > 0", "x < 0", time, 1, Saturation="Pause", Method=method,
                                      **{"Fixed dt": self.STEP})
                depth = result.history()["Dissolved"][-1] / width
                self.assertAlmostEqual(depth / reference, 1.0, delta=0.03, msg=f"{jitter}, {method}")

    def test_current_of_a_surface_under_salt_is_none(self):
        self.make_lattice([27e-6], [-7e-6])
        deck = corrosion_deck(1, self.METAL, "x > 0", None, 10.0, 10, Saturation="Pause", **{"Fixed dt": self.STEP})
        deck["Output"]["Output Variables"].append("Current_Density")
        result = self.solve(deck)
        self.check(result, self.METAL)
        # The closed electrolyte has filled, and every surface pauses.
        salted = result.field("Salt_Coverage") == 1.0
        self.assertTrue(np.any(salted))
        self.assertTrue(np.all(result.field("Current_Density")[salted] == 0.0))
        filled = self.amount(result) - self.amount(result, 0)
        self.assertAlmostEqual(filled, 0.0, delta=1e-10 * self.amount(result, 0))


if __name__ == "__main__":
    unittest.main()
