#!/usr/bin/python3
"""The solver Steady Flow in space: against series, exact solutions and published drag, by a factor and without one."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from flow_scene import RATIO, flow_deck, space_lattice  # noqa: E402
from scene import SceneTest  # noqa: E402


def between_pressures(along, length):
    """Conditions at the ends of a duct: a unit gradient of the pressure."""
    return {
        "In Node Set": {"Expression": f"{along} < 0"}, "Out Node Set": {"Expression": f"{along} > {length}"},
        "In": {"Type": "Outflow", "Node Set": "In Node Set", "Surface": along, "Pressure": length},
        "Out": {"Type": "Outflow", "Node Set": "Out Node Set", "Surface": f"{length} - ({along})"}}


def wall(surface, beyond, velocity=None, name="Walls"):
    return {f"{name} Node Set": {"Expression": beyond},
            name: {"Type": "Prescribed Velocity", "Node Set": f"{name} Node Set", "Surface": surface,
                   **({"Velocity": velocity} if velocity else {})}}


def duct_velocity(y, z, viscosity):
    """In a unit square under a unit gradient of the pressure (White, Viscous Fluid Flow, eq. 3-48)."""
    y, z = y - 0.5, z - 0.5
    return sum(4 / (viscosity * np.pi**3) * (-1)**((i - 1) // 2) * (1 - np.cosh(i * np.pi * z) / np.cosh(i * np.pi / 2))
               * np.cos(i * np.pi * y) / i**3 for i in range(1, 80, 2))


class SteadyFlowInSpace(SceneTest):
    def flow(self, points, spacing, conditions, ranks=1, **more):
        self.write_mesh(points, spacing**3)
        return self.solve(flow_deck(RATIO * spacing, conditions, dimension=3, **more), ranks=ranks)

    def duct_error(self, n, shift=(0.5, 0.5, 0.5), angles=(0.0, 0.0)):
        """L2 error of the velocity over the exact one."""
        length = 0.5
        points = space_lattice((0, 0, 0), (length, 1, 1), 1 / n, shift, angles)
        conditions = between_pressures("x", length) | wall("min(min(y, 1 - y), min(z, 1 - z))",
                                                           "y < 0 || y > 1 || z < 0 || z > 1")
        result = self.flow(points, 1 / n, conditions, viscosity=1.0)
        inside = result.field("Fluid") == 1.0
        exact = duct_velocity(points[inside, 1], points[inside, 2], 1.0)
        velocity = result.field("Velocity")[inside]
        return np.sqrt((np.sum((velocity[:, 0] - exact)**2) + np.sum(velocity[:, 1:]**2)) / np.sum(exact**2))

    def test_square_duct_along_off_and_across_the_lattice(self):
        coarse, fine = self.duct_error(8), self.duct_error(16)
        self.assertLess(fine, 0.002)
        self.assertGreater(np.log2(coarse / fine), 1.5)
        for shift, angles in (((0.5, 0.37, 0.81), (0.0, 0.0)), ((0.3, 0.1, 0.2), (20.0, 35.0))):
            self.assertLess(self.duct_error(8, shift, angles), 0.01, (shift, angles))

    def pipe(self, ranks=1, solver=None, viscosity=0.1, spacing=0.2):
        """Of radius 1 along (2, 1, 1), whichever way bonds meet its wall."""
        e = np.array([2.0, 1.0, 1.0]) / np.sqrt(6)
        along = f"({e[0]:.17g}*x + {e[1]:.17g}*y + {e[2]:.17g}*z)"
        surface, length = f"(1 - x^2 - y^2 - z^2 + {along}^2)", 1.0
        points = space_lattice((-1, -1, -1), (1.8, 1.4, 1.4), spacing, (0.3, 0.1, 0.2))
        x = points @ e
        radius = np.sqrt(np.maximum(np.sum(points**2, axis=1) - x**2, 0))
        points = points[(radius < 1 + 4 * spacing) & (x > -4 * spacing) & (x < length + 4 * spacing)]
        conditions = between_pressures(along, length) | wall(surface, f"{surface} < 0")
        result = self.flow(points, spacing, conditions, viscosity=viscosity, solver=solver, ranks=ranks)
        inside = result.field("Fluid") == 1.0
        x, velocity = points[inside] @ e, result.field("Velocity")[inside]
        exact = np.outer((1 - np.sum(points[inside]**2, axis=1) + x**2) / (4 * viscosity), e)
        return (np.max(np.abs(velocity - exact)) / np.max(exact),
                np.max(np.abs(result.field("Pressure")[inside] - (length - x))), result)

    def test_a_pipe_that_runs_across_the_lattice(self):
        # Velocities are quadratic and pressures linear, for which all operators are exact, wherever bonds end.
        for solver in ("Direct", "GMRES"):
            velocity, pressure, _ = self.pipe(solver={"Linear Solver": solver})
            self.assertLess(velocity, 1e-7, solver)
            self.assertLess(pressure, 1e-7, solver)

    def test_ranks_make_no_difference(self):
        one = self.pipe(solver={"Linear Solver": "GMRES"}, viscosity=0.2, spacing=0.28)[2]
        several = self.pipe(solver={"Linear Solver": "GMRES"}, ranks=3, viscosity=0.2, spacing=0.28)[2]
        for label in ("Velocity", "Pressure"):
            values = one.field(label)
            np.testing.assert_allclose(several.field(label), values, atol=1e-9 * np.max(np.abs(values)))

    def sphere(self, n, quarter=True):
        """Of radius 0.4 in a tube of radius 1, in the parabola of a unit velocity on the axis: force over 6 pi mu a U."""
        spacing, length = 1 / n, 1.5
        points = space_lattice((-length, -1, -1), (length, 1, 1), spacing, (0.5, 0.5, 0.5))
        if quarter:
            points = points[(points[:, 1] > 0) & (points[:, 2] > 0)]
        points = points[np.hypot(points[:, 1], points[:, 2]) < 1 + 4 * spacing]
        tube = "(1 - y^2 - z^2)"
        conditions = {
            **wall(tube, f"{tube} < 0"), **wall("x^2 + y^2 + z^2 - 0.16", "x^2 + y^2 + z^2 < 0.16", name="Sphere"),
            **wall(f"x + {length}", f"x < -{length}", [tube, 0.0, 0.0], "Inlet"),
            "Outlet Node Set": {"Expression": f"x > {length}"},
            "Outlet": {"Type": "Outflow", "Node Set": "Outlet Node Set", "Surface": f"{length} - x"}}
        drag = {"Compute Class": "Flow_Force", "Inner Radius": 0.4 + spacing, "Outer Radius": 1 - spacing,
                "Ring": "Spheres", "Output Label": "Drag"}
        planes = {"Symmetry": {"Middle": {"Point": [0.0, 0.0, 0.0], "Normal": [0.0, 1.0, 0.0]},
                               "Side": {"Point": [0.0, 0.0, 0.0], "Normal": [0.0, 0.0, 1.0]}}} if quarter else {}
        self.write_mesh(points, spacing**3)
        deck = flow_deck(RATIO * spacing, conditions, dimension=3, viscosity=1e3,
                         solver={"Linear Solver": "GMRES"}, variables=["Drag", "Before", "Behind"],
                         Compute_Class_Parameters={"Drag": drag, **{
                             name: {"Compute Class": "Mass_Flow", "Point X": place, "Normal X": 1.0,
                                    "Width": 2 * spacing, "Output Label": name}
                             for name, place in (("Before", -1.0), ("Behind", 1.0))}})
        deck["Discretization"] |= planes
        result = self.solve(deck)
        viscosity = deck["Materials"]["Fluid"]["Viscosity"]
        return (4 if quarter else 1) * result.history()["DragX"][-1] / (6 * np.pi * viscosity * 0.4), result

    def test_drag_of_a_sphere_in_a_tube(self):
        # 3.218: Haberman & Sayre, David Taylor Model Basin report 1143 (1958), as in Happel & Brenner, Low Reynolds
        # Number Hydrodynamics, table 7-3.3.
        drag, result = self.sphere(12)
        self.assertLess(abs(drag / 3.218 - 1), 0.01)
        history = result.history()
        self.assertLess(abs(history["Behind"][-1] / history["Before"][-1] - 1), 1e-3)
        self.assertLess(abs(history["Before"][-1] / (np.pi / 8) - 1), 1e-3)  # of a quarter of the tube


if __name__ == "__main__":
    unittest.main()
