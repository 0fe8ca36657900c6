#!/usr/bin/python3
"""Values that are not numbers: refused in the deck, or the run stops and names field, point and step."""
import sys
import unittest

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

SPACING, THICKNESS = 1e-3, 2e-3


class NotFinite(SceneTest):
    def run_with(self, condition, solver, ranks=1, material=None, **more):
        self.write_mesh(lattice([10 * SPACING, 6 * SPACING], SPACING), SPACING**2 * THICKNESS)
        conditions = {"Left Node Set": {"Expression": f"x < {SPACING}"}, "All Node Set": {"Expression": "x > -1"},
                      "Strange": {"Node Set": "All Node Set", **condition}}
        if "Diffusion" not in solver:
            conditions["Hold"] = {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": "y",
                                  "Value": 0.0}
        deck = plate_deck(3.015 * SPACING, THICKNESS,
                          material or {"Young's Modulus": 200e9, "Poisson's Ratio": 0.3, "Density": 8000.0},
                          conditions=conditions, solver=solver,
                          output={"Output Variables": ["Concentration" if material else "Displacement"]}, **more)
        return self.run_deck(deck, ranks=ranks)

    def test_constant_is_refused_with_the_deck(self):
        for value in (".nan", "sqrt(-1)", "1/0", ".inf"):
            result = self.run_with({"Type": "Initial Displacement", "Value": value}, {"QuasiStatic": {}})
            self.assertEqual(result.code, 2, f"{value}: {result.text}")
            self.assertRegex(result.text, r"deck\.yaml:\d+:\d+: .*(finite|cannot understand)")

    def test_initial_displacement_of_some_points_stops_every_mechanics_solver(self):
        # Row-wise numbers: sqrt is no number for x < 2 mm, points 1 and 2 of each row of ten.
        for solver in ({"QuasiStatic": {}}, {"Adaptive Dynamic Relaxation": {}}, {"Verlet": {"Fixed dt": 1e-8}},
                       {"Verlet": {}}):
            result = self.run_with({"Type": "Initial Displacement", "Value": "1e-3*sqrt(x - 0.002)"},
                                   {"Final Time": 1e-7, **solver})
            self.assertEqual(result.code, 2, f"{solver}: {result.text}")
            self.assertRegex(result.text, r'deck.yaml:\d+:\d+: the value of .* is not a number at point 1, \(0.0005', solver)

    def test_prescribed_values_that_stop_being_numbers_stop_the_run_there(self):
        # Between the eighths of the run, at which a check tries them.
        for solver in ({"QuasiStatic": {"Load Steps": 10}}, {"Adaptive Dynamic Relaxation": {"Load Steps": 10}}):
            result = self.run_with({"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": "x",
                                    "Value": "1e-6*sqrt((t - 0.51)*(t - 0.62))"}, {"Final Time": 1.0, **solver})
            self.assertEqual(result.code, 3, f"{solver}: {result.text}")
            self.assertRegex(result.text, "is not a number at point 1, .* at t = 0.6 s", solver)
        for method in ("Euler", "RKL", "RKC", "Implicit Euler", "TR-BDF2"):
            result = self.run_with({"Type": "Prescribed Concentration", "Node Set": "Left Node Set",
                                    "Value": "sqrt((t - 510)*(t - 620))"},
                                   {"Final Time": 1000.0, "Diffusion": {"Method": method, "Load Steps": 10}},
                                   material={"Diffusivity": 1e-9})
            self.assertEqual(result.code, 3, f"{method}: {result.text}")
            self.assertRegex(result.text, r"is not a number at point 1, .* at t = [56]\d\d", method)

    def test_every_rank_stops(self):
        result = self.run_with({"Type": "Initial Displacement", "Value": "1e-3*sqrt(x - 0.002)"},
                               {"Final Time": 1e-7, "Verlet": {"Fixed dt": 1e-8}}, ranks=2)
        self.assertEqual(result.code, 2, result.text)
        self.assertIn("is not a number at point 1", result.text)


if __name__ == "__main__":
    unittest.main()
