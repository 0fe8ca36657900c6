#!/usr/bin/python3
"""Cracks and voids that points do not resolve: against fracture mechanics and elasticity, and what must not depend on them."""
import os
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

YOUNG, THICKNESS = 100.0e9, 1.0e-3
STEEL = {"Young's Modulus": YOUNG, "Poisson's Ratio": 1.0 / 3.0, "Lattice Rescaling": True,
         "Surface Correction": "Energy Method"}
SMALL_STRAIN = {"QuasiStatic": {"Load Steps": 1, "Relative Tolerance": 1e-8, "Kinematics": "Small Strain"}}


def prescribed(node_set, axis, value):
    return {"Type": "Prescribed Displacement", "Node Set": node_set, "Coordinate": axis, "Value": value}


def circle(x, y, radius):
    return {"Type": "Circle", "Center": [x, y], "Radius": radius}


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


class PorousPlate(SceneTest):
    SPACING = 1.0e-3

    def mesh(self, jitter):
        points = lattice([0.03, 0.03], self.SPACING)
        points[:, :2] += jitter * self.SPACING * np.random.default_rng(1).uniform(-1.0, 1.0, (len(points), 2))
        self.write_mesh(points, self.SPACING**2 * THICKNESS)
        return points

    def deck(self, variables, **more):
        deck = plate_deck(3.2 * self.SPACING, THICKNESS, {"Young's Modulus": YOUNG, "Poisson's Ratio": 0.25,
                                                          "Density": 8000.0},
                          output={"Output Variables": variables}, **more)
        deck["Discretization"]["Voids"] = {
            "Small": circle(8.3e-3, 8.2e-3, 0.005e-3), "Wide": circle(20.0e-3, 12.0e-3, 4.5e-3),
            "At The Side": circle(30.0e-3, 22.0e-3, 0.7e-3),
            "Overlapping": {"Type": "Ellipse", "Center": [16.0e-3, 12.0e-3], "Half Axes": [2.0e-3, 0.4e-3], "Angle": 0.3},
            "Corner": {"Type": "Polygon", "Corners": [7e-3, 20e-3, 12e-3, 21e-3, 9.2e-3, 22.1e-3, 9e-3, 25.4e-3]}}
        deck["Discretization"]["Cracks"] = {
            "From The Polygon": {"Type": "Polyline", "Points": [9e-3, 23e-3, 14.2e-3, 26.1e-3, 18.3e-3, 24.0e-3]}}
        return deck


class Pores(PorousPlate):
    def test_forces_are_balanced_and_a_rigid_motion_makes_none(self):
        points = self.mesh(0.3)
        for form in ("Objective", "Linear"):
            shapes = {"Stretched": ("0.01*y^2/0.03 + 0.002*sin(300*x)", "0.003*cos(200*x*y/0.03)"),
                      "Turned": ("-1.5*x - 0.8660254037844386*y", "0.8660254037844386*x - 1.5*y")}  # by 120 degrees
            forces = {}
            for name, (u, v) in shapes.items():
                conditions = {"All Node Set": {"Expression": "x > -1"}}
                for axis, value in (("x", u), ("y", v)):
                    conditions[f"Initial {axis}"] = {"Type": "Initial Displacement", "Node Set": "All Node Set",
                                                     "Coordinate": axis, "Value": value}
                deck = self.deck(["Force_Density", "Volume"], conditions=conditions,
                                 solver={"Final Time": 1e-12, "Verlet": {"Fixed dt": 1e-12}})
                deck["Materials"]["Steel"]["Tangential Force"] = form
                result = self.solve(deck)
                forces[name] = result.field("Force_Density", 0) * result.field("Volume", 0)[:, None]
            scale = np.sum(np.abs(forces["Stretched"]))
            self.assertLess(np.max(np.abs(np.sum(forces["Stretched"], axis=0))), 1e-12 * scale, form)
            if form == "Objective":
                self.assertLess(np.sum(np.abs(forces["Turned"])), 1e-12 * scale)
        self.assertLess(len(result.field("Volume", 0)), len(points))

    def test_in_space_too(self):
        points = lattice([0.008, 0.008, 0.008], self.SPACING)
        points += 0.2 * self.SPACING * np.random.default_rng(1).uniform(-1.0, 1.0, points.shape)
        self.write_mesh(points, self.SPACING**3)
        shapes = {"Stretched": ("0.01*y^2/0.008", "0.002*sin(300*x)", "0.003*z*x/0.008"),
                  "Turned": ("-0.5*x - 0.8660254037844386*y", "0.8660254037844386*x - 0.5*y", "z")}
        forces = {}
        for name, values in shapes.items():
            conditions = {"All Node Set": {"Expression": "x > -1"}}
            for axis, value in zip("xyz", values):
                own = f"({value}) - {axis}" if name == "Turned" else value
                conditions[f"Initial {axis}"] = {"Type": "Initial Displacement", "Node Set": "All Node Set",
                                                 "Coordinate": axis, "Value": own}
            deck = plate_deck(1.5e-3, 1.0, conditions=conditions, output={"Output Variables": ["Force_Density", "Volume"]},
                              solver={"Final Time": 1e-12, "Verlet": {"Fixed dt": 1e-12}})
            deck["Materials"]["Steel"] = {"Material Model": "Elastic", "Density": 8000.0, "Bulk Modulus": 1.0e11,
                                          "Shear Modulus": 0.4e11}
            deck["Discretization"] = {
                "Type": "Text File", "Input Mesh File": "mesh.txt",
                "Voids": {"Pore": {"Type": "Sphere", "Center": [2.7e-3, 5.2e-3, 4.1e-3], "Radius": 0.8e-3}},
                "Cracks": {"Penny": {"Type": "Disk", "Center": [5.6e-3, 3e-3, 3.9e-3], "Normal": [0.2, 0.1, 1.0],
                                     "Radius": 1.7e-3}}}
            result = self.solve(deck)
            volume = result.field("Volume", 0)
            forces[name] = result.field("Force_Density", 0) * volume[:, None]
        scale = np.sum(np.abs(forces["Stretched"]))
        self.assertLess(np.max(np.abs(np.sum(forces["Stretched"], axis=0))), 1e-12 * scale)
        self.assertLess(np.sum(np.abs(forces["Turned"])), 1e-13 * scale)
        pore = 4.0 / 3.0 * np.pi * 0.8e-3**3
        self.assertLess(np.sum(volume), 0.008**3 - 0.9 * pore)  # cells of jittered points overlap

    def test_ranks_find_the_same_shares(self):
        self.mesh(0.3)
        conditions = {"Top Node Set": {"Expression": "y > 26.8e-3"}, "Bottom Node Set": {"Expression": "y < 3.2e-3"},
                      "Up": prescribed("Top Node Set", "y", "1.0e-5*t"), "Down": prescribed("Bottom Node Set", "y", 0.0),
                      "Top Stays": prescribed("Top Node Set", "x", 0.0), "Stays": prescribed("Bottom Node Set", "x", 0.0)}
        deck = self.deck(["Displacement", "Damage", "Volume"], conditions=conditions, solver=SMALL_STRAIN,
                         damage={"Damage Model": "Critical Stretch", "Critical Stretch": 1.0})
        results = [self.solve({**deck, "Output": {**deck["Output"], "Output Filename": f"on_{n}"}}, ranks=n) for n in (1, 2, 4)]
        one = results[0]
        self.assertGreater(one.field("Damage").max(), 0.4)
        for other in results[1:]:
            np.testing.assert_array_equal(one.field("Volume"), other.field("Volume"))
            # Sums over neighbours, whose order is another one.
            np.testing.assert_allclose(one.field("Damage"), other.field("Damage"), rtol=0, atol=1e-14)
            u, v = one.field("Displacement"), other.field("Displacement")
            self.assertLess(np.max(np.abs(u - v)), 1e-7 * np.max(np.abs(u)))

    def test_two_hundred_ellipses_take_their_area(self):
        self.mesh(0.0)
        random = np.random.default_rng(3)
        deck = self.deck(["Volume"], solver={"Final Time": 1e-12, "Verlet": {"Fixed dt": 1e-12}})
        del deck["Discretization"]["Cracks"]
        voids, area = {}, 0.0
        for row in range(10):
            for column in range(20):  # apart from each other
                half = random.uniform(0.1e-3, 0.6e-3), random.uniform(0.01e-3, 0.5e-3)
                voids[f"Pore {20 * row + column}"] = {
                    "Type": "Ellipse", "Center": [(column + 0.5) * 1.5e-3, (row + 0.5) * 3e-3], "Half Axes": list(half),
                    "Angle": random.uniform(0.0, 3.0)}
                area += np.pi * half[0] * half[1]
        deck["Discretization"]["Voids"] = voids
        deck["Blocks"]["Body"]["Horizon"] = 1.2 * self.SPACING  # few bonds: cells matter
        volume = np.sum(self.solve(deck).field("Volume", 0))
        self.assertAlmostEqual(volume, (0.03**2 - area) * THICKNESS, delta=1e-3 * area * THICKNESS)

    def test_bonds_break_and_a_run_goes_on(self):
        self.mesh(0.3)
        conditions = {"Top Node Set": {"Expression": "y > 26.8e-3"}, "Bottom Node Set": {"Expression": "y < 3.2e-3"},
                      "Up": prescribed("Top Node Set", "y", "20.0*t"), "Down": prescribed("Bottom Node Set", "y", "-20.0*t")}
        deck = self.deck(["Displacement", "Damage"], conditions=conditions,
                         damage={"Damage Model": "Critical Stretch", "Critical Stretch": 0.01},
                         solver={"Final Time": 2e-5, "Verlet": {"Fixed dt": 1e-7}})
        deck["Output"].update({"Output Frequency": 100, "Checkpoint Frequency": 100})
        whole = self.solve(deck)
        before, after = whole.field("Damage", 0), whole.field("Damage")
        self.assertTrue(np.all(after >= before))
        self.assertGreater(np.max(after - before), 0.2)
        deck["Output"].update({"Output Frequency": 200, "Output Filename": "half"})
        deck["Solver"]["Final Time"] = 1e-5
        self.solve(deck)
        deck["Solver"]["Final Time"] = 2e-5
        deck["Output"]["Output Filename"] = "rest"
        rest = self.solve(deck, arguments=["--restart", "half.checkpoint.h5"])
        for label in ("Damage", "Displacement"):
            np.testing.assert_array_equal(rest.field(label), whole.field(label))


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


class Surfaces(SceneTest):
    """A pore as triangles in an STL file, in a body of 10 x 10 x 10 jittered points."""
    SPACING = 1.0e-3
    CENTER, HALF = np.array([5.2e-3, 4.7e-3, 5.1e-3]), np.array([2.1e-3, 1.3e-3, 1.6e-3])

    def setUp(self):
        super().setUp()
        points = lattice([0.01, 0.01, 0.01], self.SPACING)
        points += 0.2 * self.SPACING * np.random.default_rng(1).uniform(-1.0, 1.0, points.shape)
        self.write_mesh(points, self.SPACING**3)

    @staticmethod
    def divided_octahedron(times):
        """[n, 3, 3] triangles on the unit ball, corners against the clock from outside."""
        faces = np.array([[[a, 0, 0], [0, b, 0], [0, 0, c]] for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)], float)
        turned = np.linalg.det(faces) < 0
        faces[turned] = faces[turned][:, [0, 2, 1]]
        for _ in range(times):
            a, b, c = faces.transpose(1, 0, 2)
            ab, bc, ca = 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)
            faces = np.concatenate([np.stack(t, axis=1) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
        return faces / np.linalg.norm(faces, axis=2, keepdims=True)

    def write_stl(self, faces):
        text = "solid pore\n"
        for corners in faces:
            text += "facet normal 0 0 0\nouter loop\n"
            text += "".join(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in corners.tolist()) + "endloop\nendfacet\n"
        with open(self.path("pore.stl"), "w") as file:
            file.write(text + "endsolid pore\n")

    def deck(self, pore, solver=SMALL_STRAIN, pull="1.0e-6", **output):
        conditions = {"Top Node Set": {"Expression": "z > 7.6e-3"}, "Bottom Node Set": {"Expression": "z < 2.4e-3"},
                      "Up": prescribed("Top Node Set", "z", pull), "Down": prescribed("Bottom Node Set", "z", 0.0),
                      "Top X": prescribed("Top Node Set", "x", 0.0), "Bottom X": prescribed("Bottom Node Set", "x", 0.0),
                      "Top Y": prescribed("Top Node Set", "y", 0.0), "Bottom Y": prescribed("Bottom Node Set", "y", 0.0)}
        deck = plate_deck(1.5e-3, 1.0, conditions=conditions, solver=solver,
                          damage={"Damage Model": "Critical Stretch", "Critical Stretch": 0.01},
                          output={"Output Variables": ["Displacement", "Volume", "Damage"], **output})
        deck["Materials"]["Steel"] = {"Material Model": "PDHE", "Young's Modulus": YOUNG, "Poisson's Ratio": 0.25,
                                      "Density": 8000.0}
        deck["Discretization"] = {"Type": "Text File", "Input Mesh File": "mesh.txt", "Voids": {"Pore": pore}}
        return deck

    SURFACE = {"Type": "Surface", "File Name": "pore.stl", "Scale": 1e-3, "Shift": [5.2e-3, 4.7e-3, 5.1e-3]}

    def test_a_body_with_it_is_that_with_the_ellipsoid(self):
        faces = self.divided_octahedron(3)
        volume = np.sum(np.linalg.det(faces)) / 6
        self.write_stl(faces * (4 / 3 * np.pi / volume)**(1 / 3) * self.HALF * 1e3)
        pores = {"surface": self.SURFACE,
                 "ellipsoid": {"Type": "Ellipsoid", "Center": self.CENTER.tolist(), "Half Axes": self.HALF.tolist()},
                 "speck": {"Type": "Sphere", "Center": self.CENTER.tolist(), "Radius": 1e-8}}
        results = {name: self.solve(self.deck(pore, **{"Output Filename": name})) for name, pore in pores.items()}
        self.assertAlmostEqual(np.sum(results["surface"].field("Volume")) / np.sum(results["ellipsoid"].field("Volume")), 1.0,
                               delta=2e-4)
        n = len(results["ellipsoid"].field("Volume"))
        self.assertEqual(len(results["surface"].field("Volume")), n)
        u, v = (results[name].field("Displacement") for name in ("surface", "ellipsoid"))
        self.assertLess(np.max(np.abs(u - v)), 4e-9)  # of 1e-6; at points with little material beside the pore
        self.assertLess(n, len(results["speck"].field("Volume")))

    def test_ranks_and_restarts(self):
        # With a dent, so that it is not convex.
        faces = self.divided_octahedron(2)
        faces[faces[:, :, 0] > 0.8] *= 0.5
        self.write_stl(faces * self.HALF * 1e3)
        results = [self.solve(self.deck(self.SURFACE, **{"Output Filename": f"on_{n}"}), ranks=n) for n in (1, 2, 4)]
        for other in results[1:]:
            np.testing.assert_array_equal(results[0].field("Volume"), other.field("Volume"))
            u, v = results[0].field("Displacement"), other.field("Displacement")
            self.assertLess(np.max(np.abs(u - v)), 1e-6 * np.max(np.abs(u)))
        steps = {"Final Time": 4e-6, "Verlet": {"Fixed dt": 1e-7}}
        whole = self.solve(self.deck(self.SURFACE, steps, "20.0*t", **{"Output Frequency": 20, "Checkpoint Frequency": 20}))
        self.assertGreater(np.max(whole.field("Damage")), 0.1)
        half = self.deck(self.SURFACE, {**steps, "Final Time": 2e-6}, "20.0*t", **{"Output Frequency": 20, "Checkpoint Frequency": 20,
                                                                        "Output Filename": "half"})
        self.solve(half)
        half["Solver"]["Final Time"] = 4e-6
        half["Output"]["Output Filename"] = "rest"
        rest = self.solve(half, arguments=["--restart", "half.checkpoint.h5"])
        for label in ("Damage", "Displacement"):
            np.testing.assert_array_equal(rest.field(label), whole.field(label))


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
