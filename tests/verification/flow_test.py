#!/usr/bin/python3
"""The solver Steady Flow against exact solutions and those of other methods."""
import re
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from flow_scene import RATIO, flow_deck, plane_lattice  # noqa: E402
from scene import SceneTest  # noqa: E402


class SteadyFlow(SceneTest):
    def deck(self, spacing, conditions, **more):
        return flow_deck(RATIO * spacing, conditions, **more)

    def channel(self, spacing, walls=True, **more):
        """Of height 1 and length 2, with a parabola of mean 2/3 at its inlet: dp/dx = -8 viscosity."""
        parabola = "4*y*(1 - y)"
        conditions = {
            "Walls Node Set": {"Expression": "y < 0 || y > 1"}, "Inlet Node Set": {"Expression": "x < 0"},
            "Outlet Node Set": {"Expression": "x > 2"},
            "Walls": {"Type": "Prescribed Velocity", "Node Set": "Walls Node Set",
                      **({"Surface": "min(y, 1 - y)"} if walls else {})},
            "Inlet": {"Type": "Prescribed Velocity", "Node Set": "Inlet Node Set", "Velocity": [parabola, 0.0],
                      "Surface": "x"},
            "Outlet": {"Type": "Outflow", "Node Set": "Outlet Node Set", "Surface": "2 - x"}}
        return self.deck(spacing, conditions, **more)

    def channel_errors(self, points, result, viscosity=0.05):
        """Of the velocity (L2 over that of the parabola) and of the pressure's gradient between the ends."""
        inside = result.field("Fluid") == 1.0
        x, y = points[inside, 0], points[inside, 1]
        velocity, pressure = result.field("Velocity")[inside], result.field("Pressure")[inside]
        exact = 4 * y * (1 - y)
        error = np.sqrt(np.sum((velocity[:, 0] - exact)**2 + velocity[:, 1]**2) / np.sum(exact**2))
        middle = (x > 0.5) & (x < 1.5)
        fit = np.polyfit(x[middle], pressure[middle], 1)
        return error, fit[0] / (-8 * viscosity) - 1

    def test_channel_along_off_and_across_the_lattice(self):
        # Operators are exact for parabolas, those of the pressure for lines, wherever bonds end: rounding alone is left.
        for shift, angle in (((0.5, 0.5), 0.0), ((0.37, 0.81), 0.0), ((0.3, 0.1), 20.0)):
            points = plane_lattice((0.0, 0.0), (2.0, 1.0), 0.1, shift, angle)
            self.write_mesh(points, 0.1**2)
            result = self.solve(self.channel(0.1))
            error, slope = self.channel_errors(points, result)
            self.assertLess(error, 1e-7, (shift, angle))
            self.assertLess(abs(slope), 1e-7, (shift, angle))

    def test_channel_of_jittered_points(self):
        points = plane_lattice((0.0, 0.0), (2.0, 1.0), 0.1, (0.5, 0.5))
        points[:, :2] += 0.02 * np.random.default_rng(3).uniform(-1, 1, (len(points), 2))
        self.write_mesh(points, 0.1**2)
        error, slope = self.channel_errors(points, self.solve(self.channel(0.1)))
        self.assertLess(error, 1e-7)
        self.assertLess(abs(slope), 1e-7)

    def test_a_filter_beside_points_with_equal_surroundings(self):
        # It cuts bonds of neighbours, of which fits of the pressure there are made. Points that are jittered by more than
        # rounding share no rows.
        low = {f"Lower_Left_Corner_{axis}": value for axis, value in zip("XYZ", (0.94, 0.5, -1.0))}
        along = {f"Bottom_Unit_Vector_{axis}": value for axis, value in zip("XYZ", (1.0, 0.0, 0.0))}
        normal = {f"Normal_{axis}": value for axis, value in zip("XYZ", (0.0, 1.0, 0.0))}
        found = []
        for jitter in (0.0, 1e-10):
            points = plane_lattice((0.0, 0.0), (2.0, 1.6), 0.1, (0.5, 0.5))
            points[:, :2] += jitter * np.random.default_rng(0).uniform(-1, 1, (len(points), 2))
            self.write_mesh(points, 0.1**2)
            deck = self.channel(0.1)
            conditions = deck["Boundary Conditions"]
            conditions["Walls Node Set"]["Expression"] = "y < 0 || y > 1.6"
            conditions["Walls"]["Surface"] = "min(y, 1.6 - y)"
            conditions["Inlet"]["Velocity"] = ["sin(3*y)*sin(3*y)*y*(1.6 - y)", 0.0]
            deck["Discretization"]["Bond Filters"] = {"Cut": {
                "Type": "Rectangular_Plane", **normal, **low, **along, "Bottom_Length": 0.02, "Side_Length": 2.0}}
            result = self.solve(deck)
            found.append([result.field(label) for label in ("Velocity", "Pressure")])
        for shared, own in zip(*found):
            np.testing.assert_allclose(shared, own, rtol=0.0, atol=1e-7 * np.abs(own).max())

    def test_reflected_points(self):
        # What is linear goes on beyond a wall as it is, and Couette's flow is exact; a parabola turns round there: wrong by
        # something in the viscous force as far as a horizon, of which an error of second order is left.
        for shift, angle in (((0.5, 0.5), 0.0), ((0.37, 0.81), 0.0), ((0.3, 0.1), 20.0)):
            errors = []
            for spacing in (0.1, 0.05):
                points = plane_lattice((0.0, 0.0), (2.0, 1.0), spacing, shift, angle)
                self.write_mesh(points, spacing**2)
                deck = self.channel(spacing)
                deck["Materials"]["Fluid"]["Walls"] = "Reflected Points"
                errors.append(self.channel_errors(points, self.solve(deck))[0])
            self.assertLess(errors[1], 0.008, (shift, angle))
            self.assertLess(abs(np.log2(errors[0] / errors[1]) - 2), 0.2, (shift, angle))
            conditions = deck["Boundary Conditions"]
            conditions["Walls"]["Velocity"] = conditions["Inlet"]["Velocity"] = ["y", 0.0]
            result = self.solve(deck, ranks=2)
            inside = result.field("Fluid") == 1.0
            np.testing.assert_allclose(result.field("Velocity")[inside, 0], points[inside, 1], atol=1e-7)

    def assert_ranks_agree(self, deck):
        one = self.solve(deck)
        fields = {label: one.field(label) for label in ("Velocity", "Pressure")}
        for ranks in (2, 4):
            several = self.solve(deck, ranks=ranks)
            for label, values in fields.items():
                np.testing.assert_allclose(several.field(label), values, atol=1e-9)

    def test_ranks_make_no_difference(self):
        points = plane_lattice((0.0, 0.0), (2.0, 1.0), 0.125, (0.3, 0.1), 20.0)
        self.write_mesh(points, 0.125**2)
        self.assert_ranks_agree(self.channel(0.125))

    def test_ranks_make_no_difference_to_a_closed_flow(self):
        self.assert_ranks_agree(self.cavity(16)[1])

    def test_walls_half_way_to_the_next_point(self):
        # Without surfaces walls lie between the rows: here where they should.
        points = plane_lattice((0.0, 0.0), (2.0, 1.0), 0.1, (0.5, 0.5))
        self.write_mesh(points, 0.1**2)
        error, slope = self.channel_errors(points, self.solve(self.channel(0.1, walls=False)))
        self.assertLess(error, 1e-3)
        self.assertLess(abs(slope), 1e-2)

    def test_half_a_channel_beside_its_line_of_symmetry(self):
        points = plane_lattice((0.0, 0.0), (2.0, 1.0), 0.1, (0.5, 0.5))
        points = points[points[:, 1] < 0.5]
        self.write_mesh(points, 0.1**2)
        deck = self.channel(0.1)
        deck["Boundary Conditions"]["Walls Node Set"]["Expression"] = "y < 0"
        deck["Boundary Conditions"]["Walls"]["Surface"] = "y"
        deck["Discretization"]["Symmetry"] = {"Middle": {"Point": [0.0, 0.5, 0.0], "Normal": [0.0, 1.0, 0.0]}}
        error, slope = self.channel_errors(points, self.solve(deck, ranks=2))
        self.assertLess(error, 1e-7)
        self.assertLess(abs(slope), 1e-7)

    def test_fluid_that_enters_through_an_outflow_is_told_of(self):
        # u = 1.5 y - 0.5 between walls that move: 1/12 comes in through the outflow and 1/3 leaves, and nothing drives it.
        def words(points, spacing, profile):
            self.write_mesh(points, spacing**2)
            deck = self.channel(spacing)
            conditions = deck["Boundary Conditions"]
            conditions["Walls"]["Velocity"] = conditions["Inlet"]["Velocity"] = [profile, 0.0]
            self.solve(deck)
            with open(self.path("result.log")) as log:
                return [line for line in log if "fluid enters through this outflow" in line]
        for shift, angle, error in (((0.5, 0.5), 0.0, 0.03), ((0.3, 0.1), 20.0, 0.1)):
            points = plane_lattice((0.0, 0.0), (2.0, 1.0), 0.05, shift, angle)
            line, = words(points, 0.05, "1.5*y - 0.5")
            self.assertIn('condition "Outlet"', line)
            entering, leaving, fastest = (float(line.split(before)[1].split()[0]) for before in
                                          ("outflow, ", "while ", "fastest is "))
            self.assertAlmostEqual(entering * 12, 1.0, delta=error)
            self.assertAlmostEqual(leaving * 3, 1.0, delta=error)
            y = float(re.search(r" at \(([^,]+), ([^,]+),", line).group(2))
            self.assertAlmostEqual(fastest, 0.5 - 1.5 * y, delta=0.01)
        self.assertEqual(words(points, 0.05, "4*y*(1 - y)"), [])

    def test_square_duct_between_two_pressures(self):
        # Flow rate of a unit square under dp/dx = -1: 0.035144/viscosity (White, Viscous Fluid Flow).
        n = 8
        s = (np.arange(n + 6) - 2.5) / n
        points = np.stack(np.meshgrid(s, s, s, indexing="ij"), axis=-1).reshape(-1, 3)
        self.write_mesh(points, 1 / n**3)
        conditions = {
            "Walls Node Set": {"Expression": "y < 0 || y > 1 || z < 0 || z > 1"},
            "In Node Set": {"Expression": "x < 0"}, "Out Node Set": {"Expression": "x > 1"},
            "Walls": {"Type": "Prescribed Velocity", "Node Set": "Walls Node Set",
                      "Surface": "min(min(y, 1 - y), min(z, 1 - z))"},
            "In": {"Type": "Outflow", "Node Set": "In Node Set", "Surface": "x", "Pressure": 1.0},
            "Out": {"Type": "Outflow", "Node Set": "Out Node Set", "Surface": "1 - x"}}
        flow = {"Compute Class": "Mass_Flow", "Point X": 0.5, "Normal X": 1.0, "Width": 2 / n, "Output Label": "Flow"}
        deck = self.deck(1 / n, conditions, viscosity=0.1, variables=["Flow"],
                         Compute_Class_Parameters={"Flow": flow})
        deck["Materials"]["Fluid"].pop("Plane Strain")
        self.assertLess(abs(self.solve(deck).history()["Flow"][-1] / 0.35144 - 1), 0.025)

    def test_flow_between_cylinders_one_of_which_turns(self):
        errors = []
        for n in (10, 20):
            points = plane_lattice((-1.0, -1.0), (1.0, 1.0), 1 / n, (0.37, 0.81))
            self.write_mesh(points, 1 / n**2)
            conditions = {
                "Inner Node Set": {"Expression": "x^2 + y^2 < 0.4^2"},
                "Outer Node Set": {"Expression": "x^2 + y^2 > 1"},
                "Inner": {"Type": "Prescribed Velocity", "Node Set": "Inner Node Set", "Velocity": ["-y/0.4", "x/0.4"],
                          "Surface": "sqrt(x^2 + y^2) - 0.4"},
                "Outer": {"Type": "Prescribed Velocity", "Node Set": "Outer Node Set",
                          "Surface": "1 - sqrt(x^2 + y^2)"}}
            result = self.solve(self.deck(1 / n, conditions))
            inside = result.field("Fluid") == 1.0
            x, y = points[inside, 0], points[inside, 1]
            factor = (1 / (x**2 + y**2) - 1) / (1 / 0.4 - 0.4)
            exact = np.column_stack([-y * factor, x * factor])
            errors.append(np.sqrt(np.sum((result.field("Velocity")[inside, :2] - exact)**2) / np.sum(exact**2)))
        self.assertLess(errors[1], 5e-3)
        self.assertGreater(np.log2(errors[0] / errors[1]), 1.7)

    def cavity(self, n, **more):
        points = plane_lattice((0.0, 0.0), (1.0, 1.0), 1 / n, (0.5, 0.5))
        self.write_mesh(points, 1 / n**2)
        conditions = {
            "Walls Node Set": {"Expression": "x < 0 || x > 1 || y < 0"}, "Lid Node Set": {"Expression": "y > 1"},
            "Walls": {"Type": "Prescribed Velocity", "Node Set": "Walls Node Set",
                      "Surface": "min(min(x, 1 - x), y)"},
            "Lid": {"Type": "Prescribed Velocity", "Node Set": "Lid Node Set", "Velocity": [1.0, 0.0],
                    "Surface": "1 - y"}}
        return points, self.deck(1 / n, conditions, viscosity=0.01, **more)

    def test_cavity_against_converged_solutions(self):
        # Marchi, Suero & Araki, J. Braz. Soc. Mech. Sci. Eng. 31 (2009) 186; the lowest u on x = 1/2.
        points, deck = self.cavity(24)
        result = self.solve(deck)
        column = (result.field("Fluid") == 1.0) & (np.abs(points[:, 0] - 0.5) < 0.55 / 24)
        y, u = points[column, 1], result.field("Velocity")[column, 0]
        middle = np.array([np.mean(u[np.abs(y - value) < 1e-6]) for value in np.unique(y.round(9))])
        k = int(np.argmin(middle))
        a, b, c = np.polyfit([-1, 0, 1], middle[k - 1:k + 2], 2)
        self.assertLess(abs(c - b * b / (4 * a) + 0.2140417), 1e-2)

    def test_alternating_pressures_are_seen_by_the_smoothing_alone(self):
        def roughness(smoothing):
            points, deck = self.cavity(16, solver={"Pressure Smoothing": smoothing})
            result = self.run_deck(deck)
            if result.code != 0:
                self.assertIn("singular", result.text)
                return np.inf
            inside = result.field("Fluid") == 1.0
            grid = np.full((16, 16), np.nan)
            i, j = np.floor(points[inside, :2] * 16).astype(int).T
            grid[i, j] = result.field("Pressure")[inside]
            wave = grid[1:-1, 1:-1] - 0.25 * (grid[2:, 1:-1] + grid[:-2, 1:-1] + grid[1:-1, 2:] + grid[1:-1, :-2])
            return np.max(np.abs(wave[3:-3, 3:-3]))
        self.assertLess(roughness(0.05), 0.01)  # what the pressure bends by itself
        self.assertGreater(roughness(0.0), 0.1)

    def test_a_pocket_that_is_cut_off_has_its_own_pressure(self):
        # A wall across the channel's end, and a lid that drives what is behind it.
        points = plane_lattice((0.0, 0.0), (3.0, 1.0), 0.1, (0.5, 0.5))
        self.write_mesh(points, 0.1**2)
        deck = self.channel(0.1)
        conditions = deck["Boundary Conditions"]
        conditions["Outlet Node Set"]["Expression"] = "x > 2 && x < 2.2"
        conditions["Outlet"]["Surface"] = "max(2 - x, x - 2.2)"
        conditions["Lid Node Set"] = {"Expression": "y > 1 && x > 2.4 && x < 3"}
        conditions["Walls Node Set"]["Expression"] = "y < 0 || y > 1 && x < 2.4 || x > 3 || x > 2.2 && x < 2.4"
        conditions["Walls"].pop("Surface")
        conditions["Lid"] = {"Type": "Prescribed Velocity", "Node Set": "Lid Node Set", "Velocity": [0.1, 0.0]}
        result = self.solve(deck)
        x = points[:, 0]
        behind = (result.field("Fluid") == 1.0) & (x > 2.4)
        self.assertLess(abs(np.mean(result.field("Pressure")[behind])), 1e-9)
        self.assertGreater(np.max(np.abs(result.field("Velocity")[behind])), 1e-2)
        before = (result.field("Fluid") == 1.0) & (x < 2)
        self.assertGreater(np.mean(result.field("Pressure")[before]), 0.1)

    def test_load_steps_start_from_the_last_flow(self):
        points, deck = self.cavity(16, solver={"Load Steps": 2})
        deck["Boundary Conditions"]["Lid"]["Velocity"] = ["t", 0.0]
        stepped = self.solve(deck)
        at_once = self.solve(self.cavity(16)[1])
        np.testing.assert_allclose(stepped.field("Velocity"), at_once.field("Velocity"), atol=1e-6)

    def test_a_run_goes_on_from_a_checkpoint(self):
        _, deck = self.cavity(16, solver={"Load Steps": 2})
        deck["Boundary Conditions"]["Lid"]["Velocity"] = ["t", 0.0]
        deck["Output"]["Checkpoint Frequency"] = 1
        whole = self.solve(deck)
        velocity = whole.field("Velocity", 2)
        deck["Output"]["Output Filename"] = "half"
        deck["Solver"]["Final Time"], deck["Solver"]["Steady Flow"]["Load Steps"] = 0.5, 1
        self.solve(deck)
        deck["Output"]["Output Filename"] = "rest"
        deck["Solver"]["Final Time"], deck["Solver"]["Steady Flow"]["Load Steps"] = 1.0, 2
        rest = self.solve(deck, arguments=["--restart", "half.checkpoint.h5"])
        np.testing.assert_allclose(rest.field("Velocity", 2), velocity, atol=1e-7)
        self.assertIn("Steady Flow: 2 load steps", " ".join(rest.report["solver"]))

    def test_a_flow_that_is_not_found_ends_the_run(self):
        _, deck = self.cavity(12, solver={"Maximum Solver Iterations": 6})
        deck["Materials"]["Fluid"]["Viscosity"] = 1e-6
        result = self.run_deck(deck)
        self.assertEqual(result.code, 3, result.text)
        self.assertIn("no steady flow", result.text)


if __name__ == "__main__":
    unittest.main()
