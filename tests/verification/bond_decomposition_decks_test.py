#!/usr/bin/python3
"""Cracks and voids as a part of a material, and what is refused of them."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from porous_plate import SMALL_STRAIN, THICKNESS, YOUNG, PorousPlate, circle, prescribed  # noqa: E402
from scene import SceneTest, lattice, plate_deck  # noqa: E402

# 4 mm x 0.5 nm, beside the axes: wider than that along each of them.
THIN = {"Type": "Ellipse", "Center": [0.0151, 0.0148], "Half Axes": [2e-3, 2.5e-10], "Angle": 0.7}


class AsAPartOfAMaterial(PorousPlate):
    """What hosts without a place in the deck for cracks and voids do: they are a part of the material."""

    def pull(self, **output):
        conditions = {"Top Node Set": {"Expression": "y > 26.8e-3"}, "Bottom Node Set": {"Expression": "y < 3.2e-3"},
                      "Up": prescribed("Top Node Set", "y", "20.0*t"), "Down": prescribed("Bottom Node Set", "y", "-20.0*t")}
        deck = self.deck(["Model_Coordinates", "Displacement", "Damage", "Volume"], conditions=conditions,
                         damage={"Damage Model": "Critical Stretch", "Critical Stretch": 0.01},
                         solver={"Final Time": 2e-5, "Verlet": {"Fixed dt": 1e-7}})
        deck["Output"].update({"Output Frequency": 200, **output})
        # Neighbours do not depend on the volumes of the mesh.
        deck["Discretization"]["Include Partial Neighbors"] = False
        deck["Materials"]["Steel"].update({"Surface Correction": "Energy Method", "Volume Correction": "Ramp To Horizon"})
        return deck

    @staticmethod
    def as_a_part(deck, **more):
        section = deck["Discretization"]
        deck["Materials"]["Gaps"] = {"Material Model": "Bond Decomposition", "Thickness": THICKNESS,
                                     "Cracks": section.pop("Cracks"), "Voids": section.pop("Voids"), **more}
        deck["Blocks"]["Body"]["Material"] = ["Steel", "Gaps"]
        return deck

    def test_it_is_as_in_the_mesh(self):
        self.mesh(0.3)
        expected = self.solve(self.pull())
        volume = expected.field("Volume")
        self.write_mesh(expected.field("Model_Coordinates"), volume)
        found = self.solve(self.as_a_part(self.pull(**{"Output Filename": "parts"}),
                                          **{"Cell Volume": self.SPACING**2 * THICKNESS}), ranks=2)
        self.assertGreater(np.max(expected.field("Damage")), 0.4)
        for label, tolerance in (("Displacement", 1e-11), ("Damage", 1e-12)):
            there = expected.field(label)
            self.assertLess(np.max(np.abs(found.field(label) - there)), tolerance * np.max(np.abs(there)), label)

    def test_meshes_of_whole_cells_have_the_same_equilibrium(self):
        points = self.mesh(0.3)
        solutions = {}
        for kind in ("mesh", "part"):
            deck = self.pull(**{"Output Filename": kind})
            deck["Solver"] = {"Final Time": 1e-6, **SMALL_STRAIN}
            # Mirrors of each other, but for the free side: nothing slides away.
            deck["Boundary Conditions"].update({"Top X": prescribed("Top Node Set", "x", 0.0),
                                                "Bottom X": prescribed("Bottom Node Set", "x", 0.0)})
            del deck["Materials"]["Steel"]["Surface Correction"]  # sums of volumes of material
            if kind == "part":
                kept = {tuple(np.round(x, 12)) for x in solutions["mesh"].field("Model_Coordinates")}
                self.write_mesh(np.array([x for x in points if tuple(np.round(x, 12)) in kept]), self.SPACING**2 * THICKNESS)
                self.as_a_part(deck)
            solutions[kind] = self.solve(deck)
        u, v = (solutions[kind].field("Displacement") for kind in ("mesh", "part"))
        self.assertLess(np.max(np.abs(u - v)), 1e-6 * np.max(np.abs(u)))

    def test_what_is_wrong_is_said(self):
        self.mesh(0.0)
        edge = {"Edge": {"Type": "Polyline", "Points": [0.0, 0.0151, 0.0102, 0.0151]}}
        disk = {"Type": "Disk", "Center": [0.01, 0.01, 0.0], "Normal": [0.0, 0.0, 1.0], "Radius": 1e-3}
        for gaps, message in (({"Cracks": {"One": {"Type": "Polyline", "Points": [0.01, 0.01]}}}, "2 numbers for each of 2 places"),
                              ({"Cracks": {**edge, "Disk": disk}}, "a body has one dimension"),
                              ({"Cracks": {"Edge": {"Type": "Polyline"}}}, "Points"),
                              ({}, "at least one of"),
                              ({"Voids": {"Pore": {**circle(0.0101, 0.01, 1e-3), "Angle": 1.0}}}, "Angle"),
                              ({"Cracks": edge, "Thickness": THICKNESS, "Cell Volume": 1e-9}, "has the Volume Correction Ramp Beyond")):
            deck = self.pull()
            del deck["Materials"]["Steel"]["Volume Correction"]
            del deck["Discretization"]["Cracks"], deck["Discretization"]["Voids"]
            deck["Materials"]["Gaps"] = {"Material Model": "Bond Decomposition", **gaps}
            deck["Blocks"]["Body"]["Material"] = ["Gaps", "Steel"]
            result = self.run_deck(deck, arguments=["--check"])
            self.assertEqual(result.code, 2, message + "\n" + result.text)
            self.assertIn(message, result.text)
        for gaps, message in (({"Voids": {"Pore": circle(0.0105, 0.0105, 2e-3)}}, "next to no material"),
                              ({"Cracks": edge, "Cell Volume": 1.0}, "see the unit"),
                              ({"Cracks": {"Long": {"Type": "Polyline", "Points": [-1e6, 0.0151, 0.0102, 0.0151]}}},
                               "Cracks/Long is 1e+06 m long, more than 1e+06 spacings"),
                              ({"Voids": {"Speck": circle(0.0101, 0.01, 1e-12)}}, "Voids/Speck is too small"),
                              ({"Voids": {"Slit": {**THIN, "Center": [0.0101, 0.01]}}}, "Voids/Slit is too small"),
                              ({"Cracks": edge, "also": edge}, "give all of them in one place")):
            deck = self.pull()
            del deck["Discretization"]["Cracks"], deck["Discretization"]["Voids"]
            deck["Discretization"]["Cracks"] = gaps.pop("also", {})
            deck["Materials"]["Gaps"] = {"Material Model": "Bond Decomposition", "Thickness": THICKNESS, **gaps}
            deck["Blocks"]["Body"]["Material"] = ["Steel", "Gaps"]
            result = self.run_deck(deck)
            self.assertNotEqual(result.code, 0, message)
            self.assertIn(message, result.text)

    def test_blocks_have_the_same(self):
        points = self.mesh(0.0)
        self.write_mesh(points, self.SPACING**2 * THICKNESS, block=1 + (points[:, 0] > 0.015))
        edge = {"Type": "Polyline", "Points": [0.0, 0.0151, 0.0102, 0.0151]}
        left = {"Material Model": "Bond Decomposition", "Thickness": THICKNESS, "Cracks": {"Edge": edge}}
        for right, message in ((left, None), ({**left, "Rule": "Uniform"}, "a material of block_2 has other Cracks and Voids"),
                               (None, "those of block_2 have not")):
            deck = self.pull()
            del deck["Discretization"]["Cracks"], deck["Discretization"]["Voids"]
            deck["Materials"].update({"Left Gaps": left, "Right Gaps": right or left})
            deck["Blocks"]["Right"] = {**deck["Blocks"]["Body"], "Block Names": "block_2", "Horizon": 3.1 * self.SPACING,
                                       "Material": ["Steel", "Right Gaps"] if right else "Steel"}
            deck["Blocks"]["Body"].update({"Block Names": "block_1", "Material": ["Steel", "Left Gaps"]})
            result = self.run_deck(deck, arguments=["--check"])
            self.assertEqual(result.code, 0 if message is None else 2, result.text)
            self.assertIn(message or "", result.text)


class Refusals(SceneTest):
    def test_what_is_wrong_is_said_with_its_place(self):
        self.write_mesh(lattice([0.03, 0.03], 1e-3), 1e-9)
        good = {"Cracks": {"Edge": {"Type": "Polyline", "Points": [0.0, 0.0151, 0.0102, 0.0151]}}}
        material = {"Young's Modulus": YOUNG, "Poisson's Ratio": 0.25}
        diffusing = {"Diffusivity": 1.0, "Solid Concentration": 1.0, "Saturation Concentration": 0.5, "Charge Number": 2.0,
                     "Current Density": "1.0"}
        cases = [
            ({"Voids": {"Far": circle(0.05, 0.01, 1e-3)}}, {}, "Voids/Far meets no cell and no bond of the body"),
            ({"Cracks": {"Far": {"Type": "Polyline", "Points": [0.05, 0.0, 0.06, 0.0]}}}, {}, "Cracks/Far meets no cell"),
            ({"Voids": {"All": circle(0.015, 0.015, 0.1)}}, {}, "leave nothing of the body"),
            ({"Voids": {"Ball": {"Type": "Sphere", "Center": [0.01, 0.01, 0.0], "Radius": 1e-3}}}, {}, "a form in space"),
            ({"Cracks": {"One": {"Type": "Polyline", "Points": [0.01, 0.01]}}}, {}, "2 numbers for each of 2 places"),
            ({"Bond Decomposition": {"Rule": "Uniform"}}, {}, "has neither"),
            ({**good, "Bond Decomposition": {"Partitions": 10}}, {}, "Partitions is of the rule Uniform"),
            ({"Voids": {"Bow": {"Type": "Polygon", "Corners": [0.01, 0.01, 0.02, 0.02, 0.02, 0.01, 0.01, 0.02]}}}, {},
             "crosses or touches itself: its sides 1 and 3"),
            ({"Voids": {"Flat": {"Type": "Polygon", "Corners": [0.01, 0.01, 0.02, 0.01, 0.025, 0.01]}}}, {},
             "goes back on itself at its corner 3"),
            ({"Voids": {"Grip": {"Type": "Polygon", "Corners": [-1.0, 0.025, 1.0, 0.025, 1.0, 1.0, -1.0, 1.0]}}}, {},
             "all points of node set \"Grip Node Set\" lie in Voids"),
            ({**good, "Symmetry": {"Plane": {"Point": [0, 0, 0], "Normal": [1, 0, 0]}}}, {}, "do not go with planes of symmetry"),
            ({"Cracks": {"Long": {"Type": "Polyline", "Points": [-1.0e4, 0.0151, 0.0102, 0.0151]}}}, {},
             "let it end just outside of the body"),
            ({"Voids": {"Degrees": {"Type": "Ellipse", "Center": [0.01, 0.01], "Half Axes": [2e-3, 1e-3], "Angle": 30.0}}}, {},
             "Voids/Degrees/Angle is 30, must be in"),
            ({"Voids": {"Slit": THIN}}, {}, "Voids/Slit is too small: half of its smallest width must be 1e-06 of the spacing"),
            ({"Cracks": {"Through A Point": {"Type": "Polyline", "Points": [0.01, 0.0155, 0.02, 0.0155]}},
              "Bond Decomposition": {"Rule": "Intersection"}}, {}, "or set `Rule: Adaptive`"),
            (good, {"Material Model": "Corrosion Dissolution", **diffusing, "damage": {"Damage Model": "Dissolution"}},
             "Interaction_Share"),
            (good, {"damage": {"Damage Model": "Nodal Energy", "Fracture Energy": 10.0, "Plane Stress": True, "Horizon": 3.2e-3,
                               "Thickness": THICKNESS, **material}}, "whole bonds only"),
        ]
        for geometry, change, message in cases:
            change = dict(change)
            damage = change.pop("damage", None)
            corrodes = "Material Model" in change
            deck = plate_deck(3.2e-3, THICKNESS, {} if corrodes else material, damage=damage,
                              conditions={"Grip Node Set": {"Expression": "y > 0.026"}}, solver={"QuasiStatic": {"Load Steps": 1}}, output={"Output Variables": ["Volume"]})
            deck["Materials"]["Steel"].update(change)
            if corrodes:
                deck["Solver"] = {"Final Time": 1.0, "Corrosion": {"Load Steps": 1}}
            deck["Discretization"].update(geometry)
            result = self.run_deck(deck, arguments=["--check"])
            self.assertEqual(result.code, 2, message + "\n" + result.text)
            self.assertIn(message, result.text)

if __name__ == "__main__":
    unittest.main()
