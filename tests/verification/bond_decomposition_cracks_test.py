#!/usr/bin/python3
"""Cracks that points do not resolve, against fracture mechanics, and the damage that they are."""
import os
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from porous_plate import SMALL_STRAIN, STEEL, THICKNESS, YOUNG, prescribed  # noqa: E402
from scene import SceneTest, lattice, plate_deck  # noqa: E402


class CentreCrack(SceneTest):
    """20 mm x 40 mm, half length about 4 mm between points 0.25 mm apart, 100 MPa along y."""
    WIDTH, HEIGHT, SPACING = 20.0e-3, 40.0e-3, 0.25e-3

    def setUp(self):
        super().setUp()
        points = lattice([self.WIDTH, self.HEIGHT], self.SPACING, [-0.5 * self.WIDTH, -0.5 * self.HEIGHT])
        self.write_mesh(points, self.SPACING**2 * THICKNESS)
        self.points = points

    def deck(self, a, rule, variables):
        force = 100.0e6 * self.WIDTH * THICKNESS
        sides = "abs(y - 0.1e-3) < 0.15e-3"
        deck = plate_deck(
            4.0 * self.SPACING, THICKNESS, STEEL, solver=SMALL_STRAIN, output={"Output Variables": variables},
            conditions={"Top Node Set": {"Expression": "y > 19.6e-3"}, "Bottom Node Set": {"Expression": "y < -19.6e-3"},
                        "Left Node Set": {"Expression": f"x < -9.7e-3 && {sides}"},
                        "Sides Node Set": {"Expression": f"abs(x) > 9.7e-3 && {sides}"},
                        "Up": {"Type": "Force", "Node Set": "Top Node Set", "Coordinate": "y", "Value": force},
                        "Down": {"Type": "Force", "Node Set": "Bottom Node Set", "Coordinate": "y", "Value": -force},
                        "Held X": prescribed("Left Node Set", "x", 0.0), "Held Y": prescribed("Sides Node Set", "y", 0.0)})
        deck["Discretization"]["Cracks"] = {"Centre": {"Type": "Polyline", "Points": [-a, 0.0, a, 0.0]}}
        deck["Discretization"]["Bond Decomposition"] = {"Rule": rule}
        return deck

    def tada(self, a):
        part = 2.0 * a / self.WIDTH
        return (1 - 0.025 * part**2 + 0.06 * part**4) / np.sqrt(np.cos(0.5 * np.pi * part)) * 100.0e6 * np.sqrt(np.pi * a)

    def intensity(self, a, rule):
        """K over Tada's, and how far beyond the tip the ellipse ends, that the opening is nearest to."""
        u = self.solve(self.deck(a, rule, ["Displacement"])).field("Displacement")[:, 1]
        x, y = self.points[:, 0], self.points[:, 1]
        upper, lower = ((side * y > 0) & (np.abs(y) < self.SPACING) for side in (1, -1))
        v, x = 0.5 * (u[upper] - u[lower]), x[upper]
        near = np.abs(x) < a - 0.75e-3
        slope, square = np.polyfit(x[near]**2, v[near]**2, 1)  # v^2 = (2 K/E)^2/(pi a_e) (a_e^2 - x^2)
        effective = np.sqrt(-square / slope)
        return 0.5 * YOUNG * np.sqrt(-slope * np.pi * effective) / self.tada(a), effective - a

    def test_a_tip_is_where_the_deck_has_it(self):
        for rule, a in (("Adaptive", 3.875e-3), ("Uniform", 3.94e-3), ("Adaptive", 4.0e-3)):  # at a point ... beside cells
            ratio, shift = self.intensity(a, rule)
            self.assertAlmostEqual(ratio, 1.0, delta=0.02, msg=f"{rule}, {a}")
            self.assertLess(abs(shift), 0.3 * self.SPACING, f"{rule}, {a}")
        # Whole bonds put it half a spacing and more away.
        self.assertGreater(self.intensity(3.88e-3, "Either")[1], 0.5 * self.SPACING)


    def test_points_need_not_lie_in_rows_along_a_crack(self):
        """K by an interaction integral; cells that the crack passes through must not join its faces."""
        points = self.points.copy()
        points[:, :2] += 0.3 * self.SPACING * np.random.default_rng(1).uniform(-1.0, 1.0, (len(points), 2))
        self.write_mesh(points, self.SPACING**2 * THICKNESS)
        a = 4.0e-3
        deck = self.deck(a, "Adaptive", ["K"])
        deck["Materials"]["Steel"].pop("Lattice Rescaling")
        deck["Compute Class Parameters"] = {
            "K": {"Compute Class": "Stress_Intensity", "Plane Stress": True, "Thickness": THICKNESS, "Inner Radius": 2.0e-3,
                  "Outer Radius": 3.2e-3, "Tip X": a, "Tip Y": 0.0, "Direction X": 1.0, "Direction Y": 0.0,
                  "Output Label": "K"}}
        history = self.solve(deck).history()
        k = next(values[-1] for name, values in history.items() if name.startswith("K"))
        self.assertAlmostEqual(k / self.tada(a), 1.0, delta=0.03)


class RoundCrack(SceneTest):
    def test_its_stress_intensity_is_the_exact_one(self):
        """Half as large as in decks/crack_sif, by the rim of the body as there: tilted, so that it passes through cells."""
        sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../decks/crack_sif"))
        sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../meshes"))
        import penny
        import penny_openings
        self.write_mesh(lattice([0.02, 0.02, 0.02], 1e-3, [-0.01] * 3), 1e-9)
        a, tilt = 5.5e-3, np.radians(20)
        conditions = {"Rim Node Set": {"Expression": "max(max(abs(x), abs(y)), abs(z)) > 7.9e-3"}}
        for axis, value in zip("xyz", penny.functions(a, 0.0, tilt)):
            conditions[f"Rim {axis}"] = prescribed("Rim Node Set", axis, value)
        deck = plate_deck(2.05e-3, 1.0, conditions=conditions, solver=SMALL_STRAIN, output={"Output Variables": ["Displacement"]})
        deck["Materials"]["Steel"] = {"Material Model": "PDHE", "Young's Modulus": penny.YOUNG, "Poisson's Ratio": penny.POISSON,
                                      "Lattice Rescaling": True, "Surface Correction": "Energy Method"}
        deck["Discretization"] = {
            "Type": "Text File", "Input Mesh File": "mesh.txt", "Include Partial Neighbors": False,
            "Cracks": {"Penny": {"Type": "Disk", "Center": [0.0, 0.0, 0.0], "Normal": [np.sin(tilt), 0.0, np.cos(tilt)],
                                 "Radius": a}}}
        self.solve(deck)
        by_rim, by_ellipse = penny_openings.ratios_of(Path(self.folder), "result", a, tilt=tilt)
        self.assertAlmostEqual(by_ellipse, 1.0, delta=0.05)
        self.assertAlmostEqual(by_rim, 1.0, delta=0.1)


class DamageOfCracks(SceneTest):
    def test_it_is_that_of_a_filter_but_at_the_tip(self):
        points = lattice([0.03, 0.03], 1e-3)
        self.write_mesh(points, 1e-9)
        damage = {}
        geometry = {
            "filter": {"Bond Filters": {"Edge": {
                "Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0, "Lower_Left_Corner_X": -1.0,
                "Lower_Left_Corner_Y": 15e-3, "Lower_Left_Corner_Z": -1.0, "Bottom_Unit_Vector_X": 1.0,
                "Bottom_Unit_Vector_Y": 0.0, "Bottom_Unit_Vector_Z": 0.0, "Bottom_Length": 1.0102, "Side_Length": 2.0,
                "Count In Damage": True}}},
            "shares": {"Cracks": {"Edge": {"Type": "Polyline", "Points": [-1.0, 15e-3, 10.2e-3, 15e-3]}}},
            "not counted": {"Cracks": {"Edge": {"Type": "Polyline", "Points": [-1.0, 15e-3, 10.2e-3, 15e-3]}},
                            "Bond Decomposition": {"Cracks Count In Damage": False}}}
        for name, section in geometry.items():
            deck = plate_deck(3.2e-3, THICKNESS, {"Young's Modulus": YOUNG, "Poisson's Ratio": 0.25, "Density": 8000.0},
                              damage={"Damage Model": "Critical Stretch", "Critical Stretch": 0.1},
                              solver={"Final Time": 1e-12, "Verlet": {"Fixed dt": 1e-12}}, output={"Output Variables": ["Damage"]})
            deck["Discretization"].update(section)
            damage[name] = self.solve(deck).field("Damage")
        behind, ahead = points[:, 0] < 6.4e-3, points[:, 0] > 14e-3
        np.testing.assert_allclose(damage["shares"][behind], damage["filter"][behind], rtol=0, atol=1e-12)
        self.assertGreater(damage["shares"].max(), 0.35)
        self.assertEqual(damage["shares"][ahead].max(), 0.0)
        self.assertEqual(damage["not counted"].max(), 0.0)

if __name__ == "__main__":
    unittest.main()
