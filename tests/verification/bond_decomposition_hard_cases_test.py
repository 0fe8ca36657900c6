#!/usr/bin/python3
"""Cracks and voids between points where they are hard: pores far below a spacing, at surfaces and one over the other, cracks
along bonds and through points, a mesh of tetrahedra, bonds that break, and many steps of dynamics."""
import itertools
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

SPACING, THICKNESS = 1.0e-3, 1.0e-3
STEEL = {"Young's Modulus": 100.0e9, "Poisson's Ratio": 0.25, "Density": 8000.0}
ONE_STEP = {"Final Time": 1e-12, "Verlet": {"Fixed dt": 1e-12}}
ROUGHLY = {"Tolerance": 0.01}  # where shares need not be right, only the same from both ends


def circle(x, y, radius):
    return {"Type": "Circle", "Center": [x, y], "Radius": radius}


def initial_displacement(values):
    """Of all points, by functions of place, a coordinate each."""
    conditions = {"All Node Set": {"Expression": "x > -1"}}
    for axis, value in zip("xyz", values):
        conditions[f"Initial {axis}"] = {"Type": "Initial Displacement", "Node Set": "All Node Set", "Coordinate": axis,
                                         "Value": value}
    return conditions


class Plate(SceneTest):
    def deck(self, geometry, variables, size=16, **more):
        self.points = lattice([size * SPACING, size * SPACING], SPACING)
        self.write_mesh(self.points, SPACING**2 * THICKNESS)
        deck = plate_deck(3.2 * SPACING, THICKNESS, STEEL, output={"Output Variables": variables},
                          **{"solver": ONE_STEP, **more})
        deck["Discretization"].update(geometry)
        return deck

    def test_pores_below_a_hundredth_of_a_spacing_at_surfaces_and_over_each_other(self):
        """What each takes of the body, against areas in closed form."""
        r = 0.005 * SPACING
        lens = r**2 * (2 * np.pi / 3 - 0.5 * np.sqrt(3))  # common to two circles a radius apart
        cases = {  # voids around one place, and their area in the body
            "Inside": ([(4.23e-3, 4.71e-3, r)], np.pi * r**2),
            "On A Corner Of Cells": ([(4e-3, 8e-3, r)], np.pi * r**2),
            "At A Point": ([(4.5e-3, 12.5e-3, r)], np.pi * r**2),
            "Touching The Surface": ([(8.3e-3, r, r)], np.pi * r**2),
            "Half Outside": ([(0.0, 8.37e-3, r)], 0.5 * np.pi * r**2),
            "At The Corner Of The Body": ([(16e-3, 16e-3, r)], 0.25 * np.pi * r**2),
            "Overlapping": ([(12.3e-3, 12.4e-3, r), (12.3e-3 + r, 12.4e-3, r)], 2 * np.pi * r**2 - lens),
            "Twice": ([(12.4e-3, 4.2e-3, r), (12.4e-3, 4.2e-3, r)], np.pi * r**2)}
        voids = {f"{name} {k}": circle(*place) for name, (places, _) in cases.items() for k, place in enumerate(places)}
        volume = self.solve(self.deck({"Voids": voids}, ["Volume"])).field("Volume", 0)
        self.assertEqual(len(volume), len(self.points))
        for name, (places, area) in cases.items():
            near = np.hypot(self.points[:, 0] - places[0][0], self.points[:, 1] - places[0][1]) < 1.5 * SPACING
            taken = np.sum(SPACING**2 * THICKNESS - volume[near])
            self.assertAlmostEqual(taken, area * THICKNESS, delta=0.01 * area * THICKNESS, msg=name)

    def test_points_in_a_hole_larger_than_a_horizon_are_left_out_and_it_is_said(self):
        radius = 4.4e-3
        result = self.run_deck(self.deck({"Voids": {"Hole": circle(8.1e-3, 7.9e-3, radius)}}, ["Volume"]))
        self.assertEqual(result.code, 0, result.text)
        with open(self.path("result.log")) as file:
            log = file.read()
        left = len(result.field("Volume", 0))
        self.assertIn(f"{len(self.points) - left} of the {len(self.points)} points of mesh.txt lie in Voids and are left out", log)
        area = 256 * SPACING**2 - np.pi * radius**2
        self.assertAlmostEqual(np.sum(result.field("Volume", 0)), area * THICKNESS, delta=2e-3 * np.pi * radius**2 * THICKNESS)

    def test_no_fibre_crosses_a_crack_through_points_along_bonds_or_on_edges_of_cells(self):
        """What is beyond the crack moves as a whole: nothing pulls. Cracks through points leave these on one side."""
        diagonal = "0.01*(x - y > {0})"
        cases = {"on edges": ([-1.0, 8e-3, 1.0, 8e-3], "0.01*(y > 8e-3)"),
                 "through points": ([-1.0, 8.5e-3, 1.0, 8.5e-3], "0.01*(y > 8.4e-3)"),
                 "on edges, upright": ([5e-3, -1.0, 5e-3, 1.0], "0.01*(x > 5e-3)"),
                 "along diagonal bonds": ([-1.0, -1.0, 1.0, 1.0], diagonal.format(1e-6)),
                 "between diagonal bonds": ([-1.0, -1.0 - 0.5e-3, 1.0, 1.0 - 0.5e-3], diagonal.format(1e-6))}
        for rule, (name, (crack, jump)) in itertools.product(("Adaptive", "Uniform"), cases.items()):
            deck = self.deck({"Cracks": {"Through": {"Type": "Polyline", "Points": crack}},
                              "Bond Decomposition": {"Rule": rule}}, ["Force_Density"],
                             conditions=initial_displacement((jump, jump)))
            force = self.solve(deck).field("Force_Density", 0)
            # Without the crack it would be of the order of E times the jump over the horizon squared.
            self.assertLess(np.max(np.abs(force)), 1e-9 * 100.0e9 * 0.01 / (3.2 * SPACING)**2, f"{name}, {rule}")

    def test_bonds_of_which_a_part_is_left_break_as_a_whole(self):
        """Under a stretch beyond the critical one all break, whatever their share; nothing pulls then, and all is lost."""
        geometry = {"Voids": {"Small": circle(4.3e-3, 5.2e-3, 0.4e-3), "Wide": circle(9e-3, 10e-3, 2.2e-3)},
                    "Cracks": {"Edge": {"Type": "Polyline", "Points": [0.0, 12.1e-3, 6.33e-3, 11.3e-3]}}}
        for stretch, counts in itertools.product((0.9e-3, 1.1e-3), (True, False)):
            deck = self.deck({**geometry, "Bond Decomposition": {"Cracks Count In Damage": counts}},
                             ["Damage", "Force_Density"], damage={"Damage Model": "Critical Stretch", "Critical Stretch": 1e-3},
                             conditions=initial_displacement((f"{stretch}*x", f"{stretch}*y")),
                             solver={"Final Time": 2e-12, "Verlet": {"Fixed dt": 1e-12}})
            result = self.solve(deck)
            damage, force = result.field("Damage"), result.field("Force_Density")
            if stretch > 1e-3:
                np.testing.assert_allclose(damage, 1.0, rtol=0, atol=1e-14)
                self.assertEqual(np.max(np.abs(force)), 0.0)
            else:
                self.assertEqual(np.max(damage) > 0.1, counts)
                self.assertGreater(np.max(np.abs(force)), 0.0)

    def test_dynamics_over_many_steps_keep_momentum_and_energy(self):
        geometry = {"Voids": {"Small": circle(4.3e-3, 5.2e-3, 0.4e-3), "Wide": circle(9e-3, 10e-3, 2.2e-3)},
                    "Cracks": {"Edge": {"Type": "Polyline", "Points": [0.0, 12.1e-3, 6.33e-3, 11.3e-3]}}}
        names = ("Strain_Energy", "Global_Kinetic_Energy")
        conditions = {"All Node Set": {"Expression": "x > -1"}}
        for axis, value in (("x", "3*cos(500*y) + 1"), ("y", "2*sin(400*x)")):
            conditions[f"Start {axis}"] = {"Type": "Initial Velocity", "Node Set": "All Node Set", "Coordinate": axis, "Value": value}
        deck = self.deck(geometry, ["Velocity", "Volume", *names], conditions=conditions,
                         solver={"Final Time": 3e-4, "Verlet": {"Safety Factor": 0.4}},
                         Compute_Class_Parameters={name: {"Compute Class": name, "Output Label": name} for name in names})
        deck["Output"]["Output Frequency"] = 100
        result = self.solve(deck)
        history = result.history()
        energy = sum(history[name] for name in names)
        self.assertGreater(np.max(history["Strain_Energy"]), 0.05 * energy[0])
        self.assertLess(np.ptp(energy), 1e-2 * energy[0])
        steps = result.steps()
        self.assertGreater(steps[-1], 1000)
        momentum = [result.field("Velocity", step).T @ result.field("Volume", step) for step in (steps[0], steps[-1])]
        scale = np.sum(np.abs(result.field("Velocity", 0)) * result.field("Volume", 0)[:, None])
        self.assertLess(np.max(np.abs(momentum[1] - momentum[0])), 1e-11 * scale)


class Tetrahedra(SceneTest):
    """Points of a mesh of tetrahedra of unequal volumes: six to a box, between nodes that are moved at random."""

    def mesh(self, n, edge):
        nodes = np.stack(np.meshgrid(*3 * [np.arange(n + 1)], indexing="ij"), axis=-1) * edge
        inside = np.all((nodes > 0.1 * edge) & (nodes < (n - 0.1) * edge), axis=-1)
        nodes = nodes + 0.2 * edge * np.random.default_rng(4).uniform(-1.0, 1.0, nodes.shape) * inside[..., None]
        corners = []
        for order in itertools.permutations(range(3)):  # Kuhn's: from one corner of a box to the other by its edges
            ways = np.cumsum([np.eye(3, dtype=int)[axis] for axis in order], axis=0)
            corners.append([nodes[w[0]:w[0] + n, w[1]:w[1] + n, w[2]:w[2] + n].reshape(-1, 3) for w in ((0, 0, 0), *ways)])
        a, b, c, d = (np.concatenate([of_order[k] for of_order in corners]) for k in range(4))
        volume = np.abs(np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a)) / 6
        points = 0.25 * (a + b + c + d)
        self.assertAlmostEqual(np.sum(volume), (n * edge)**3, delta=1e-9 * (n * edge)**3)
        self.write_mesh(points, volume)
        return points

    def test_forces_are_balanced_and_rigid_motions_make_none(self):
        n, edge = 4, 1.0e-3
        points = self.mesh(n, edge)
        shapes = {"Stretched": ("0.01*y^2/0.004", "0.002*sin(300*x)", "0.003*z*x/0.004"),
                  "Turned": ("-0.5*x - 0.8660254037844386*y - x", "0.8660254037844386*x - 0.5*y - y", "1e-3")}
        materials = {"Elastic": {"Material Model": "Elastic", "Density": 8000.0, "Bulk Modulus": 1.0e11, "Shear Modulus": 0.4e11},
                     "PDHE": {"Material Model": "PDHE", "Density": 8000.0, "Young's Modulus": 1.0e11, "Poisson's Ratio": 0.25,
                              "Tangential Force": "Objective"}}
        for material, parameters in materials.items():
            forces = {}
            for name, values in shapes.items():
                deck = plate_deck(1.3 * edge, 1.0, conditions=initial_displacement(values), solver=ONE_STEP,
                                  output={"Output Variables": ["Force_Density", "Volume", "Model_Coordinates"]})
                deck["Materials"]["Steel"] = parameters
                deck["Discretization"] = {
                    "Type": "Text File", "Input Mesh File": "mesh.txt", "Bond Decomposition": ROUGHLY,
                    "Voids": {"Pore": {"Type": "Sphere", "Center": [1.6e-3, 2.3e-3, 1.7e-3], "Radius": 0.9e-3}},
                    "Cracks": {"Flat": {"Type": "Polygon", "Corners": [0.0, 0.0, 2.7e-3, 4e-3, 0.0, 2.9e-3, 4e-3, 2.3e-3, 2.9e-3,
                                                                       0.0, 2.1e-3, 2.7e-3]}}}
                result = self.solve(deck)
                volume = result.field("Volume", 0)
                forces[name] = result.field("Force_Density", 0) * volume[:, None]
            place = result.field("Model_Coordinates", 0)
            scale = np.sum(np.abs(forces["Stretched"]))
            self.assertLess(np.max(np.abs(np.sum(forces["Stretched"], axis=0))), 1e-12 * scale, material)
            self.assertLess(np.sum(np.abs(forces["Turned"])), 1e-13 * scale, material)  # rounding of places alone: 6e-15
            self.assertLess(len(volume), len(points))
            self.assertGreater(np.min(np.linalg.norm(place - [1.6e-3, 2.3e-3, 1.7e-3], axis=1)), 0.5e-3)


if __name__ == "__main__":
    unittest.main()
