#!/usr/bin/python3
"""What `pdrun --check` says of decks of bodies of revolution."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import CheckedDeck, lattice  # noqa: E402

DECK = {
    "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt", "Axis Of Revolution": "x"},
    "Materials": {"Water": {"Material Model": "Navier Stokes", "Density": 1000.0, "Viscosity": 1e-3}},
    "Blocks": {"Pipe": {"Block Names": "block_1", "Material": "Water", "Horizon": 0.3015}},
    "Boundary Conditions": {
        "Walls Node Set": {"Expression": "y > 1"}, "In Node Set": {"Expression": "x < 0"},
        "Out Node Set": {"Expression": "x > 1"},
        "Walls": {"Type": "Prescribed Velocity", "Node Set": "Walls Node Set", "Surface": "1 - y"},
        "In": {"Type": "Prescribed Velocity", "Node Set": "In Node Set", "Velocity": ["1e-6*(1 - y^2)", 0.0],
               "Surface": "x"},
        "Out": {"Type": "Outflow", "Node Set": "Out Node Set", "Surface": "1 - x"}},
    "Solver": {"Final Time": 1.0, "Steady Flow": {}},
    "Output": {"Output Filename": "result", "Output Frequency": 1, "Output Variables": ["Velocity", "Pressure"]}}


class RevolutionDecks(CheckedDeck):
    DECK = DECK

    def setUp(self):
        super().setUp()
        self.points = lattice([1.8, 1.4], 0.1, origin=[-0.4, 0.0])
        self.write_mesh(self.points, 0.01)

    def test_the_deck_is_good_whatever_is_said_of_the_plane(self):
        for more in ({}, {"Plane Strain": True}):
            result = self.check(lambda deck: deck["Materials"]["Water"].update(more))
            self.assertEqual(result.code, 0, result.text)

    def test_rings_have_no_thickness(self):
        for section in ("Discretization", "Materials/Water"):
            def thicken(deck):
                part = deck
                for name in section.split("/"):
                    part = part[name]
                part["Thickness"] = 3.0
            self.assert_refused(thicken, f"{section}/Thickness: rings of bodies of revolution", "leave it out")

    def test_the_axis_is_x_or_y(self):
        self.assert_refused(lambda deck: deck["Discretization"].update({"Axis Of Revolution": "z"}),
                            'Discretization/Axis Of Revolution "z" is not allowed here (one of "x", "y")')

    def test_the_axis_belongs_to_the_discretization(self):
        self.assert_refused(lambda deck: deck["Materials"]["Water"].update({"Axis Of Revolution": "x"}),
                            "Materials/Water gives an Axis Of Revolution, which belongs to Discretization alone")

    def test_materials_that_do_not_know_rings(self):
        for model in ("PDHE", "Elastic", "Elastic Bond Based"):
            self.assert_refused(lambda deck: deck["Materials"].update({"Steel": {
                "Material Model": model, "Density": 1.0, "Young's Modulus": 1.0, "Poisson's Ratio": 0.3}}),
                f"Materials/Steel: {model} does not know bodies of revolution",
                '"Advection Diffusion", "Corrosion Dissolution", "Diffusion", "Navier Stokes"')

    def test_computes_of_planes(self):
        self.assert_refused(lambda deck: deck.update({"Compute Class Parameters": {"Depth": {
            "Compute Class": "Mean_Depth", "Node Set": "Walls Node Set", "Into Y": -1.0}}}),
            "Compute Class Parameters/Depth: Mean_Depth is for points of a plane or of space and does not know bodies")
        self.assert_refused(lambda deck: deck.update({"Compute Class Parameters": {"Force": {
            "Compute Class": "Flow_Force", "Inner Radius": 0.4, "Outer Radius": 0.8}}}),
            'in a body of revolution take "Ring: Spheres" about a "Center" on its axis')

    def test_the_viscous_kernel(self):
        self.assert_refused(lambda deck: deck["Materials"]["Water"].update({"Viscous Kernel": "Transverse"}),
                            '"Viscous Kernel: Transverse" is for flows without divergence in the plane')

    def test_nothing_flows_across_the_axis(self):
        def slant(across):
            return lambda deck: deck["Boundary Conditions"]["In"].update({"Velocity": ["1e-6*(1 - y^2)", across]})
        for across in (1e-7, "1e-7*t"):  # that is zero at the start
            self.assert_refused(slant(across), 'condition "In"',
                                "its Velocity has a component across the Axis Of Revolution")
        self.assertEqual(self.check(slant("1e-7*y")).code, 0)

    def test_points_beyond_the_axis(self):
        self.write_mesh(self.points - [0.0, 0.2, 0.0], 0.01)
        self.assert_refused(lambda deck: None, "Discretization/Axis Of Revolution: 36 of 252 points lie at y <= 0",
                            "the point mesh.txt:1 at (-0.35, -0.15, 0)")

    def test_points_on_the_axis(self):
        self.write_mesh(self.points - [0.0, 0.04, 0.0], 0.01)
        self.assert_refused(lambda deck: None, "Discretization/Axis Of Revolution: 18 point(s) lie on the plane",
                            "than a quarter of a spacing")

    def test_meshes_in_space(self):
        self.write_mesh(np.vstack([self.points, self.points + [0.0, 0.0, 0.1]]), 0.001)
        self.assert_refused(lambda deck: None, "must lie in the x-y plane, all at one z")

    def test_planes_of_symmetry_are_across_the_axis(self):
        def mirror(normal):
            return lambda deck: deck["Discretization"].update({"Symmetry": {"Middle": {
                "Point": [1.4, 0.0, 0.0], "Normal": normal}}})
        self.assert_refused(mirror([0.0, 1.0, 0.0]), "is not perpendicular to Discretization/Axis Of Revolution")
        result = self.check(mirror([1.0, 0.0, 0.0]))
        self.assertEqual(result.code, 0, result.text)

    def test_voids(self):
        self.assert_refused(lambda deck: deck["Discretization"].update({"Voids": {"Pore": {
            "Type": "Circle", "Center": [0.5, 0.5], "Radius": 0.1}}}),
            "not of the rings of a body of revolution; cut them out of the mesh")


if __name__ == "__main__":
    unittest.main()
