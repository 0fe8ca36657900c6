#!/usr/bin/python3
"""A scalar that a steady flow carries: the material Advection Diffusion with Steady Flow."""
import sys
import unittest

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

sys.path.insert(0, sys.path[0] + "/../support")
from flow_scene import RATIO, plane_lattice  # noqa: E402
from scene import SceneTest  # noqa: E402


def graetz(pe, length, rows=400, steps=4000):
    """Mean of C over the flow after `length`, between plates 1 apart with C = 0; without axial diffusion."""
    y = (np.arange(rows) + 0.5) / rows
    u = 6 * y * (1 - y)
    diagonal = np.full(rows, -2.0)
    diagonal[[0, -1]] = -3.0
    diffusion = sparse.diags([np.ones(rows - 1), diagonal, np.ones(rows - 1)], [-1, 0, 1]) * rows**2 / pe
    step = splu((sparse.diags(u * steps / length) - diffusion).tocsc())
    c = np.ones(rows)
    for _ in range(steps):
        c = step.solve(u * steps / length * c)
    return np.sum(u * c) / np.sum(u)


class Transport(SceneTest):
    def deck(self, spacing, length=2.0, velocity="1.0", walls="1.0", diffusivity=1e-4, solver=None, **scalar):
        """A channel of height 1; the flow enters with `velocity` between walls that move with `walls`."""
        steady = {"ImplicitDiffusion": {"Field": "Concentration", "Linear Solver": "GMRES", "Preconditioner": "ILU",
                                        "Relative Tolerance": 1e-8, "Maximum Solver Iterations": 120}}
        side = "y < 0 || y > 1"
        return {
            "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt"},
            "Materials": {
                "Fluid": {"Material Model": "Navier Stokes", "Plane Strain": True, "Density": 1.0, "Viscosity": 0.05,
                          **({"Flux Horizon": scalar.pop("flux") * spacing} if "flux" in scalar else {})},
                "Salt": {"Material Model": "Advection Diffusion", "Plane Strain": True, "Diffusivity": diffusivity,
                         **scalar.pop("material", {})}},
            "Blocks": {"Channel": {"Block Names": "block_1", "Material": ["Fluid", "Salt"],
                                   "Horizon": RATIO * spacing},
                       "Sides": {"Block Names": "block_2", "Material": "Fluid", "Horizon": RATIO * spacing}},
            "Boundary Conditions": {
                "Side Node Set": {"Expression": side}, "In Node Set": {"Expression": f"x < 0 && !({side})"},
                "Out Node Set": {"Expression": f"x > {length}"},
                "End Node Set": {"Expression": f"x > {length} && !({side})"},
                "Inside Node Set": {"Expression": f"x > 0 && x < {length} && !({side})"},
                "Sides": {"Type": "Prescribed Velocity", "Node Set": "Side Node Set", "Velocity": [walls, 0.0],
                          "Surface": "min(y, 1 - y)"},
                "In": {"Type": "Prescribed Velocity", "Node Set": "In Node Set", "Velocity": [velocity, 0.0],
                       "Surface": "x"},
                "Out": {"Type": "Outflow", "Node Set": "Out Node Set", "Surface": f"{length} - x"},
                "Salt In": {"Type": "Prescribed Concentration", "Node Set": "In Node Set",
                            "Value": scalar.pop("inflow", 1.0)},
                "Salt Out": {"Type": "Prescribed Concentration", "Node Set": "End Node Set", "Value": 0.0},
                **scalar.pop("conditions", {})},
            "Solver1": {"Final Time": 1.0, "Steady Flow": {}},
            "Solver2": {"Initial Time": 1.0, "Final Time": 2.0, **(solver or steady)},
            "Output": {"Output Filename": "result", "Output Frequency": 1,
                       "Output Variables": ["Velocity", "Fluid", "Concentration", "Concentration_Flux_Divergence"]}}

    def mesh(self, spacing, length=2.0, shift=(0.5, 0.5), angle=0.0, jitter=0.0):
        points = plane_lattice((0.0, 0.0), (length, 1.0), spacing, shift, angle)
        points[:, :2] += jitter * spacing * np.random.default_rng(5).uniform(-1, 1, (len(points), 2))
        beyond = (points[:, 1] < 0) | (points[:, 1] > 1)
        self.write_mesh(points, spacing**2, block=np.where(beyond, 2, 1))
        return points

    def test_slopes_are_limited_by_the_values_of_the_solver_at_work(self):
        # A solver that holds limits, as that of steady states may, has a field of them, which others follow, too.
        self.mesh(0.1)
        pulse = {"Pulse": {"Type": "Initial Concentration", "Node Set": "Inside Node Set", "Value": "exp(-40*(x - 0.5)^2)"}}
        found = []
        for later in (False, True):
            deck = self.deck(0.1, conditions=pulse, inflow=0.0, solver={"Diffusion": {
                "Field": "Concentration", "Method": "TR-BDF2", "Linear Solver": "GMRES", "Preconditioner": "ILU",
                "Load Steps": 4, "Relative Tolerance": 1e-3}})
            deck["Solver2"]["Final Time"] = 1.4
            if later:
                deck["Solver3"] = {"Initial Time": 1.4, "Final Time": 2.0, "ImplicitDiffusion": {
                    "Field": "Concentration", "Linear Solver": "GMRES", "Preconditioner": "ILU",
                    "Maximum Solver Iterations": 120, "Relative Tolerance": 1e-3}}
            found.append(self.solve(deck).field("Concentration", 5))
        self.assertGreater(np.max(found[0]), 0.5)
        np.testing.assert_allclose(found[1], found[0], atol=1e-6)

    def test_a_restart_is_the_same_to_the_last_bit(self):
        # Slopes that are limited make matrices that depend on the values, of which a checkpoint keeps none.
        self.mesh(0.1)
        iterative = {"Field": "Concentration", "Linear Solver": "GMRES", "Preconditioner": "ILU", "Load Steps": 4}
        solvers = [{"ImplicitDiffusion": {**iterative, "Relative Tolerance": 1e-8, "Maximum Solver Iterations": 120}},
                   *({"Diffusion": {**iterative, "Method": method, "Sub Steps": 2, "Linear Tolerance": 1e-6}}
                     for method in ("Implicit Euler", "TR-BDF2"))]
        for solver in solvers:
            with self.subTest(solver):
                deck = self.deck(0.1, walls="0.0", velocity="6*y*(1 - y)", inflow="1 + t", solver=solver,
                                 material={"Scheme": "Limited"})
                deck["Output2"] = {"Output Filename": "early", "Final Output Step": 3, "Checkpoint Frequency": 3,
                                   "Output Variables": ["Velocity"]}
                whole = self.solve(deck)
                rest = self.solve(deck, arguments=["--restart", "early.checkpoint.h5"])
                for label in ("Concentration", "Concentration_Flux_Divergence"):
                    np.testing.assert_array_equal(rest.field(label), whole.field(label), label)

    def test_walls_that_take_up_what_flows_past(self):
        # Graetz' problem at Peclet number 200: within 1 %, of which 0.4 % are diffusion along the channel.
        points = plane_lattice((0.0, 0.0), (2.0, 1.0), 0.05, (0.5, 0.5))
        self.write_mesh(points, 0.05**2)
        deck = self.deck(0.05, velocity="6*y*(1 - y)", walls="0.0", diffusivity=1 / 200, flux=1.2,
                         conditions={"Take": {"Type": "Prescribed Concentration", "Value": 0.0,
                                              "Node Set": "Side Node Set"}})
        deck["Blocks"] = {"Channel": deck["Blocks"]["Channel"]}
        result = self.solve(deck)
        c, v = result.field("Concentration"), result.field("Velocity")[:, 0]
        last = np.isclose(points[:, 0], 1.975) & (result.field("Fluid") == 1)
        mean = np.sum(c[last] * v[last]) / np.sum(v[last])
        self.assertLess(abs(np.log(mean) / np.log(graetz(200, 1.975)) - 1), 0.01)

    def test_no_wiggles_where_nothing_diffuses(self):
        # U h/D = 1e4; a step at the inlet crosses lattices that are turned, of triangles or jittered, and keeps within
        # its bounds; as much leaves as enters.
        h = 0.0625
        for angle, jitter in ((0.0, 0.0), (30.0, 0.0), (0.0, 0.2)):
            points = self.mesh(h, 1.0, (0.37, 0.41), angle, jitter)
            deck = self.deck(h, 1.0, diffusivity=h / 1e4, inflow="0.5 + 0.5*sign(y - 0.5)")
            deck["Solver2"]["ImplicitDiffusion"]["Relative Tolerance"] = 1e-6  # then slow, by kinks
            result = self.solve(deck)
            c, rate = result.field("Concentration"), result.field("Concentration_Flux_Divergence")
            fluid = result.field("Fluid") == 1
            self.assertGreater(c[fluid].min(), -1e-5)
            self.assertLess(c[fluid].max(), 1 + 1e-5)
            middle = c[fluid & (np.abs(points[:, 0] - 0.5) < h) & (np.abs(points[:, 1] - 0.5) > 0.25)]
            self.assertLess(np.min(middle), 1e-2)
            self.assertGreater(np.max(middle), 1 - 1e-2)
            held = ~fluid & (np.abs(points[:, 1] - 0.5) < 0.5)
            self.assertLess(abs(rate[held].sum()), 1e-5 * np.abs(rate[held]).sum())

    def test_a_constant_stays_one(self):
        # Flows of bonds are balanced, however the points lie.
        for angle, jitter, flux in ((0.0, 0.2, 1.5), (20.0, 0.0, 1.2)):
            self.mesh(0.1, 1.0, (0.37, 0.81), angle, jitter)
            result = self.solve(self.deck(0.1, 1.0, velocity="6*y*(1 - y)", walls="0.0", flux=flux))
            c = result.field("Concentration")[result.field("Fluid") == 1]
            np.testing.assert_allclose(c, 1.0, atol=1e-7)

    def test_a_closed_channel_beside_an_open_one(self):
        # Each part of the flow is balanced alone; the closed one lets out 0.5 % more than in, which is evened out.
        points = plane_lattice((0.0, 0.0), (1.0, 3.0), 0.1, (0.5, 0.5))
        side = "y < 0 || (y > 1 && y < 2) || y > 3"
        walls = (points[:, 1] < 0) | ((points[:, 1] > 1) & (points[:, 1] < 2)) | (points[:, 1] > 3)
        self.write_mesh(points, 0.01, block=np.where(walls, 2, 1))
        deck = self.deck(0.1, 1.0, diffusivity=1e-3, flux=1.2, material={"Scheme": "Upwind Biased"})
        below, above = "6*y*(1 - y)", "6*(y - 2)*(3 - y)"
        conditions = deck["Boundary Conditions"]
        for name in list(conditions):
            if "Node Set" not in name:
                conditions.pop(name)
        sets = {"In1": "x < 0 && y < 1.5", "In2": "x < 0 && y > 1.5",
                "Out1": "x > 1 && y < 1.5", "Out2": "x > 1 && y > 1.5"}
        conditions["Side Node Set"]["Expression"] = side
        for name, where in sets.items():
            conditions[f"{name} Node Set"] = {"Expression": f"{where} && !({side})"}
            conditions[f"{name} Salt"] = {"Type": "Prescribed Concentration", "Node Set": f"{name} Node Set",
                                          "Value": 1.0}
        conditions["Sides"] = {"Type": "Prescribed Velocity", "Node Set": "Side Node Set"}
        for name, velocity in (("In1", below), ("In2", above), ("Out2", "1.005*" + above)):
            conditions[name] = {"Type": "Prescribed Velocity", "Node Set": f"{name} Node Set",
                                "Velocity": [velocity, 0.0]}
        conditions["Out1"] = {"Type": "Outflow", "Node Set": "Out1 Node Set", "Surface": "1 - x + 9*(y > 1.5)"}
        for ranks in (1, 2):
            result = self.solve(deck, ranks=ranks)
            fluid = result.field("Fluid") == 1
            self.assertGreater(np.count_nonzero(fluid & (points[:, 1] > 2)), 50)
            np.testing.assert_allclose(result.field("Concentration")[fluid], 1.0, atol=1e-7)
        # An outflow whose Surface goes through the other channel before its own end takes its way out.
        conditions["Out1"]["Surface"] = "0.99 - x"
        result = self.run_deck(deck)
        self.assertEqual(result.code, 2, result.text)
        self.assertIn('condition "Out1": its Surface also cuts bonds of fluid around which no point of its node set lies',
                      result.text)

    def pulse_error(self, n, **material):
        """L2 of a bell that has travelled half of the channel."""
        points = self.mesh(1 / n, 1.5)
        bell = "exp(-((x - {}))^2/0.02)"
        start = {"Start": {"Type": "Initial Concentration", "Node Set": "Inside Node Set", "Value": bell.format(0.5)}}
        solver = {"Final Time": 1.5, "Diffusion": {"Method": "TR-BDF2", "Sub Steps": n, "Linear Solver": "GMRES",
                                                   "Preconditioner": "ILU"}}
        result = self.solve(self.deck(1 / n, 1.5, diffusivity=0.0, inflow=0.0, conditions=start, solver=solver,
                                      flux=1.2, material=material))
        fluid = result.field("Fluid") == 1
        exact = np.exp(-(points[fluid, 0] - 1.0)**2 / 0.02)
        return np.sqrt(np.mean((result.field("Concentration")[fluid] - exact)**2) / np.mean(exact**2))

    def test_order_of_a_travelling_bell(self):
        limited = [self.pulse_error(n) for n in (18, 36)]
        self.assertGreater(np.log2(limited[0] / limited[1]), 1.5)
        self.assertGreater(self.pulse_error(18, Scheme="Upwind Biased"), 2 * limited[0])

    def test_ranks_make_no_difference(self):
        self.mesh(0.125, 1.0, (0.3, 0.1), 20.0)
        deck = self.deck(0.125, 1.0, velocity="6*y*(1 - y)", walls="0.0", diffusivity=1e-3, inflow="y")
        one = self.solve(deck).field("Concentration")
        for ranks in (2, 4):
            np.testing.assert_allclose(self.solve(deck, ranks=ranks).field("Concentration"), one, atol=1e-7)

    def test_conjugate_gradients_and_explicit_steps_are_refused(self):
        self.mesh(0.125, 1.0)
        for solver in ({"ImplicitDiffusion": {"Field": "Concentration"}}, {"Diffusion": {"Method": "RKL"}}):
            result = self.run_deck(self.deck(0.125, 1.0, solver=solver))
            self.assertNotEqual(result.code, 0)
            self.assertIn("a flow carries \"Concentration\"", result.text)


if __name__ == "__main__":
    unittest.main()
