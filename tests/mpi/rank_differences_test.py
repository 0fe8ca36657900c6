#!/usr/bin/python3
"""What another number of ranks may change in the results of each solver, at the tolerance that it has by default: what
README.md promises (Several ranks)."""
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from corrosion_scene import STEEL, corrosion_deck  # noqa: E402
from scene import SceneTest, lattice, plate_deck  # noqa: E402

SPACING, HORIZON, THICKNESS = 1e-3, 3.015e-3, 2e-3
LENGTH, WIDTH = 20e-3, 10e-3
ROUNDING = 1e-12  # of the largest value: sums of another order, in as many steps as these runs have


class RankDifferences(SceneTest):
    def setUp(self):
        super().setUp()
        points = lattice([LENGTH, WIDTH], SPACING)
        points[:, :2] += np.random.default_rng(1).uniform(-0.1, 0.1, (len(points), 2)) * SPACING
        self.write_mesh(points, SPACING**2 * THICKNESS)

    def differences(self, deck, fields):
        """The largest over all steps between one rank and three, over the largest value; by field."""
        one, three = (self.solve({**deck, "Output": {**deck["Output"], "Output Filename": f"ranks{n}"}}, ranks=n)
                      for n in (1, 3))
        self.assertEqual(three.steps(), one.steps())
        result = {}
        for label in fields:
            largest = max(np.max(np.abs(one.field(label, step))) for step in one.steps())
            self.assertGreater(largest, 0.0)
            result[label] = max(np.max(np.abs(three.field(label, step) - one.field(label, step)))
                                for step in one.steps()) / largest
        return result

    def check(self, deck, **allowed):
        found = self.differences(deck, allowed)
        print(self.id().split(".")[-1], list(deck["Solver"].values())[-1],
              ", ".join(f"{k} {v:.1e} of {allowed[k]:.1e}" for k, v in found.items()), flush=True)
        for label, difference in found.items():
            self.assertLessEqual(difference, allowed[label], f"{label}, {deck['Solver']}")

    def plate(self, solver, final_time=1.0, **material):
        """Pulled along x, held at one end; hydrogen comes in from below."""
        pull = f"{1e-3 * LENGTH / final_time!r}*t*(1 + 20*y)"
        conditions = {"All Node Set": {"Expression": "1"}, "Left Node Set": {"Expression": f"x < {2 * SPACING!r}"},
                      "Right Node Set": {"Expression": f"x > {LENGTH - 2 * SPACING!r}"},
                      "Bottom Node Set": {"Expression": f"y < {2 * SPACING!r}"},
                      **{f"Hold {k}": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set",
                                       "Coordinate": k, "Value": 0.0} for k in "xy"},
                      "Pull": {"Type": "Prescribed Displacement", "Node Set": "Right Node Set", "Coordinate": "x",
                               "Value": pull},
                      "Start": {"Type": "Initial Value", "Field": "Concentration", "Node Set": "All Node Set",
                                "Value": 0.1},
                      "Charge": {"Type": "Prescribed Value", "Field": "Concentration", "Node Set": "Bottom Node Set",
                                 "Value": "1 + 40*x"}}
        return plate_deck(HORIZON, THICKNESS, {"Young's Modulus": 200e9, "Poisson's Ratio": 0.3, "Density": 7850.0,
                                               "Diffusivity": 1e-6, **material}, None, conditions,
                          {"Final Time": final_time, **solver},
                          {"Output Variables": ["Displacement", "Concentration", "Concentration_Flux_Divergence"]})

    def test_explicit(self):
        self.check(self.plate({"Verlet": {"Fixed dt": 1e-7}}, 2e-5), Displacement=10 * ROUNDING)

    def test_static(self):
        self.check(self.plate({"QuasiStatic": {"Load Steps": 3}}), Displacement=10 * 1e-6)
        self.check(self.plate({"Adaptive Dynamic Relaxation": {"Load Steps": 3}}), Displacement=10 * 1e-5)

    def test_diffusion(self):
        # A rate is the field's difference times a weight of bonds, so that it shows what the field does, enlarged by
        # the largest over the rates that are left: here less than 100.
        for method in ("Euler", "RKC", "RKL", "Implicit Euler", "TR-BDF2"):
            self.check(self.plate({"Diffusion": {"Method": method, "Load Steps": 4}}, 20.0), Concentration=ROUNDING,
                       Concentration_Flux_Divergence=100 * ROUNDING)
        self.check(self.plate({"ImplicitDiffusion": {"Field": "Concentration"}}), Concentration=10 * 1e-6,
                   Concentration_Flux_Divergence=100 * 1e-6)

    def test_staggered(self):
        deck = self.plate({"Staggered": {"Load Steps": 4, "Solvers": {
            "Hydrogen": {"Diffusion": {"Method": "RKL"}}, "Equilibrium": {"QuasiStatic": {}}}}}, 20.0)
        self.check(deck, Displacement=10 * 1e-6, Concentration=ROUNDING, Concentration_Flux_Divergence=100 * ROUNDING)

    def test_corrosion(self):
        spacing = 1e-6
        self.write_mesh(lattice([24e-6, 12e-6], spacing), spacing**2)
        allowed = 10 * 1e-9 * STEEL["Saturation Concentration"] / STEEL["Solid Concentration"]
        for method in ({}, {"Method": "RKL"}):
            deck = corrosion_deck(2, STEEL, "(x - 1e-5)*(x - 1e-5) + y*y > 3.6e-11",
                                  "(x - 1e-5)*(x - 1e-5) + y*y < 6e-12", 10.0, 3, **method)
            self.check(deck, Concentration=allowed, Damage=allowed)


if __name__ == "__main__":
    unittest.main()
