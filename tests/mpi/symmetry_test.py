#!/usr/bin/python3
"""A half, a quarter or an eighth of a body beside planes of symmetry is what it is in the whole body."""
import copy
import math
import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)) + "/../support")
from corrosion_scene import STEEL, corrosion_deck  # noqa: E402
from scene import SceneTest, lattice, plate_deck  # noqa: E402

SPACING, THICKNESS = 1e-3, 2e-3
HORIZON = 3.015 * SPACING
NEWTON = {"QuasiStatic": {"Relative Tolerance": 1e-13}}
RELAXATION = {"Adaptive Dynamic Relaxation": {"Load Steps": 2, "Relative Tolerance": 1e-11}}
STEEL_PLATE = {"Young's Modulus": 200e9, "Poisson's Ratio": 0.2, "Density": 7850.0}
# Of a field's largest value: what the tolerances of the solvers and the rounding of coordinates leave.
SAME = 1e-10


def plane(normal, point=(0.0, 0.0, 0.0)):
    return {"Point": list(point), "Normal": list(normal)}


X, Y, Z = plane([1.0, 0.0, 0.0]), plane([0.0, -2.0, 0.0]), plane([0.0, 0.0, 1.0])


def mirrored(x, planes):
    """Points of all copies, those of the part first."""
    whole = np.array(x)
    for p in planes:
        n = np.array(p["Normal"]) / np.linalg.norm(p["Normal"])
        whole = np.vstack([whole, whole - 2.0 * np.outer((whole - p["Point"]) @ n, n)])
    return whole


class SymmetryTest(SceneTest):
    def make_meshes(self, part, planes, volume):
        self.planes = {f"Plane {k}": p for k, p in enumerate(planes)}
        self.n = len(part)
        self.part, self.whole = part, mirrored(part, planes)
        self.write_mesh(self.part, volume, name="part.txt")
        self.write_mesh(self.whole, volume, name="whole.txt")

    def deck_of(self, deck, name, is_part):
        deck = copy.deepcopy(deck)
        deck["Discretization"]["Input Mesh File"] = "part.txt" if is_part else "whole.txt"
        if is_part:
            deck["Discretization"]["Symmetry"] = self.planes
        deck["Output"]["Output Filename"] = name
        return deck

    def compare(self, deck, fields, ranks=(1, 2, 4), same=SAME, floor=0.0, prepare=lambda label, values: values):
        """Fields of all steps in the whole body and in the part; returns both results."""
        whole = self.solve(self.deck_of(deck, "whole", False))
        for n in ranks:
            part = self.solve(self.deck_of(deck, f"part{n}", True), ranks=n, name="part")
            self.assertEqual(part.steps(), whole.steps())
            for label in fields:
                largest = max(np.max(np.abs(whole.field(label, step))) for step in whole.steps())
                self.assertGreater(largest, 0.0, label)
                for step in whole.steps():
                    expected, found = whole.field(label, step), part.field(label, step)
                    self.assertEqual(len(found), self.n)
                    expected, found = prepare(label, expected)[:self.n], prepare(label, found)
                    what = f"{label} of step {step} on {n} ranks"
                    if label == "Damage" and same == SAME:  # a share of broken bonds
                        np.testing.assert_array_equal(found, expected, what)
                    error = np.max(np.abs(found - expected))
                    self.assertLessEqual(error, max(same * largest, floor), what)
        return whole, part


class Plate(SymmetryTest):
    """A quarter of a plate of 24 x 16 mm."""

    def setUp(self):
        super().setUp()
        self.make_meshes(lattice([12e-3, 8e-3], SPACING), [X, Y], SPACING**2 * THICKNESS)

    def centred(self, label, values):
        """Without the translation along y, which pulling along x leaves free in the whole plate."""
        is_whole = label == "Displacement" and len(values) > self.n
        return values - [0.0, np.mean(values[:, 1]), 0.0] if is_whole else values

    def pulled(self, stretch, solver, material=STEEL_PLATE):
        pull = f"{12e-3 * stretch!r}*t"
        conditions = {"Right Node Set": {"Expression": f"x > {10e-3}"},
                      "Left Node Set": {"Expression": f"x < {-10e-3}"},
                      "Right": {"Type": "Prescribed Displacement", "Node Set": "Right Node Set", "Coordinate": "x",
                                "Value": pull},
                      "Left": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": "x",
                               "Value": "-" + pull}}
        return plate_deck(HORIZON, THICKNESS, material, None, conditions, solver,
                          {"Output Variables": ["Displacement"]})

    def deck_of(self, deck, name, is_part):
        deck = super().deck_of(deck, name, is_part)
        if is_part:  # nothing is left of the plane
            for entry in ("Left Node Set", "Left"):
                deck["Boundary Conditions"].pop(entry, None)
        return deck


class Statics(Plate):
    def check(self, deck, **options):
        self.compare(deck, ["Displacement"], prepare=self.centred, floor=1e-13 * 12e-3, **options)

    def test_two_parameter_bonds(self):
        self.check(self.pulled(1e-3, NEWTON))

    def test_bonds_that_turn(self):
        self.check(self.pulled(5e-2, {"QuasiStatic": {**NEWTON["QuasiStatic"], "Number of Load Steps": 2}}), ranks=(1,))

    def test_linear_tangential_force(self):
        self.check(self.pulled(1e-3, NEWTON, {**STEEL_PLATE, "Tangential Force": "Linear"}), ranks=(2,))

    def test_surface_corrections(self):
        for correction in ("Volume Method", "Energy Method"):
            self.check(self.pulled(1e-3, NEWTON, {**STEEL_PLATE, "Surface Correction": correction}), ranks=(2,))

    def test_bond_based(self):
        deck = self.pulled(1e-3, NEWTON)
        deck["Materials"]["Steel"] = {"Material Model": "Elastic Bond Based", "Density": 7850.0, "Plane Stress": True,
                                      "Height": THICKNESS, "Young's Modulus": 200e9}
        self.check(deck, ranks=(4,))

    def test_relaxation(self):
        self.check(self.pulled(1e-3, RELAXATION), same=1e-9, ranks=(2,))

    def test_quarter_needs_no_further_support(self):
        self.solve(self.deck_of(self.pulled(1e-3, NEWTON), "alone", True))
        with open(self.path("alone.log")) as file:
            self.assertNotIn("held in place", file.read())


class CrackedPlate(Plate):
    """A centre crack of 8 mm along x, pulled open along y."""

    CRITICAL = 2e-3

    def deck(self, solver, final_time=1.0, **output):
        pull = f"{8e-3 * 3 * self.CRITICAL / final_time!r}*t"
        deck = plate_deck(
            HORIZON, THICKNESS, STEEL_PLATE, {"Damage Model": "Critical Stretch", "Critical Stretch": self.CRITICAL},
            {"Top Node Set": {"Expression": f"y > {6e-3}"}, "Bottom Node Set": {"Expression": f"y < {-6e-3}"},
             "Top": {"Type": "Prescribed Displacement", "Node Set": "Top Node Set", "Coordinate": "y", "Value": pull},
             "Bottom": {"Type": "Prescribed Displacement", "Node Set": "Bottom Node Set", "Coordinate": "y",
                        "Value": "-" + pull}},
            {"Final Time": final_time, **solver}, {"Output Variables": ["Displacement", "Damage"], **output})
        deck["Discretization"]["Bond Filters"] = {
            "Crack": {"Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0,
                      "Lower_Left_Corner_X": -4e-3, "Lower_Left_Corner_Y": 0.0, "Lower_Left_Corner_Z": -1.0,
                      "Bottom_Unit_Vector_X": 1.0, "Bottom_Unit_Vector_Y": 0.0, "Bottom_Unit_Vector_Z": 0.0,
                      "Bottom_Length": 8e-3, "Side_Length": 2.0, "Count In Damage": True}}
        return deck

    def deck_of(self, deck, name, is_part):
        deck = super().deck_of(deck, name, is_part)
        if is_part:
            for entry in ("Bottom Node Set", "Bottom"):
                deck["Boundary Conditions"].pop(entry, None)
            # Half of the crack: its image makes it whole.
            deck["Discretization"]["Bond Filters"]["Crack"].update({"Lower_Left_Corner_X": 0.0, "Bottom_Length": 4e-3})
        return deck

    def centred(self, label, values):
        is_whole = label == "Displacement" and len(values) > self.n
        return values - [np.mean(values[:, 0]), 0.0, 0.0] if is_whole else values


class Breakage(CrackedPlate):
    def check(self, deck, ranks):
        whole, part = self.compare(deck, ["Damage", "Displacement"], ranks, prepare=self.centred, floor=1e-12 * 8e-3)
        before, after = (np.sum(part.field("Damage", step)) for step in (part.steps()[0], part.steps()[-1]))
        self.assertGreater(before, 0.5)
        self.assertGreater(after, before + 3.0)

    def test_newton(self):
        self.check(self.deck({"QuasiStatic": {**NEWTON["QuasiStatic"], "Number of Load Steps": 6}}), (1, 2, 4))

    def test_verlet(self):
        self.check(self.deck({"Verlet": {"Fixed dt": 1e-7}}, 2e-5, **{"Output Frequency": 50}), (2,))


class CrackComputes(CrackedPlate):
    """Places and rates of a crack are those of the whole body, totals those of the part."""

    def test_crack(self):
        ring = {"Compute Class": "J_Integral", "Plane Stress": True, "Thickness": THICKNESS, "Inner Radius": 5e-3,
                "Outer Radius": 7e-3}
        tip = {"Compute Class": "Crack_Tip", "Threshold": 0.3}
        computes = {
            "Right": {**tip, "Start X": 0.0, "Start Y": 0.0}, "Left": {**tip, "Direction X": -1.0},
            "Length": {**tip, "Compute Class": "Crack_Length"}, "Fixed": {**ring, "Tip X": 4e-3},
            "Beside": {**ring, "Tip X": -4e-3, "Direction X": -1.0}, "Moving": {**ring, "Tip Field": "Right"},
            "Area": {"Compute Class": "Crack_Area", "Horizon": HORIZON, "Thickness": THICKNESS},
            "Broken": {"Compute Class": "Broken_Bonds"}, "Energy": {"Compute Class": "Strain_Energy"}}
        # Two load steps before the crack runs, and two after.
        deck = self.deck({"QuasiStatic": {**NEWTON["QuasiStatic"], "Number of Load Steps": 4}})
        deck["Solver"]["Final Time"] = 1.0 / 3.0
        deck["Compute Class Parameters"] = {name: {**keys, "Output Label": name} for name, keys in computes.items()}
        whole = self.solve(self.deck_of(deck, "whole", False)).history()
        self.assertGreater(whole["RightX"][-1], whole["RightX"][0] + SPACING)
        self.assertGreater(whole["Fixed"][2], 1.0)
        np.testing.assert_allclose(whole["LeftX"], -whole["RightX"], rtol=0.0, atol=1e-15)
        totals = ("Area", "Broken", "Energy")
        same = ("RightX", "RightY", "LeftX", "LeftY", "Length", "Fixed", "Beside", "Moving")
        for ranks in (1, 4):
            part = self.solve(self.deck_of(deck, "part", True), ranks=ranks).history()
            for name in totals + same:
                scale = np.max(np.abs(whole[name])) or SPACING
                np.testing.assert_allclose(part[name] * (4.0 if name in totals else 1.0), whole[name], rtol=0.0,
                                           atol=1e-9 * scale, err_msg=f"{name} on {ranks} ranks")


class Diffusion(Plate):
    def deck(self, solver):
        start = "1 + cos(200*x)*cos(300*y)"
        return {"Discretization": {"Type": "Text File", "Thickness": THICKNESS},
                "Materials": {"Steel": {"Material Model": "PDHE", "Diffusivity": 1e-6, "Density": 1.0,
                                        "Plane Stress": True, "Thickness": THICKNESS}},
                "Blocks": {"Body": {"Block Names": "block_1", "Material": "Steel", "Horizon": HORIZON}},
                "Boundary Conditions": {
                    "All Node Set": {"Expression": "1"},
                    "Edge Node Set": {"Expression": "abs(x) > 11e-3"},
                    "Start": {"Type": "Initial Value", "Field": "Concentration", "Node Set": "All Node Set",
                              "Value": start},
                    "Edge": {"Type": "Prescribed Value", "Field": "Concentration", "Node Set": "Edge Node Set",
                             "Value": "1 + 100*abs(y)"}},
                "Solver": {"Final Time": 10.0, **solver},
                "Output": {"Output Frequency": 1, "Output Variables": ["Concentration"]}}

    def test_explicit(self):
        deck = self.deck({"Diffusion": {"Method": "Euler", "Load Steps": 4, "Sub Steps": 100}})
        self.compare(deck, ["Concentration"], (4,))

    def test_implicit(self):
        self.compare(self.deck({"Diffusion": {"Method": "TR-BDF2", "Load Steps": 4}}), ["Concentration"], (2,))

    def test_steady(self):
        self.compare(self.deck({"ImplicitDiffusion": {"Field": "Concentration", "Relative Tolerance": 1e-12}}),
                     ["Concentration"], (1, 2))


class Blocks(Plate):
    """Two blocks, of which one lies along a plane of symmetry."""

    def check(self, deck, fields, other):
        volume = SPACING**2 * THICKNESS
        for x, name in ((self.part, "part.txt"), (self.whole, "whole.txt")):
            self.write_mesh(x, volume, block=1 + (np.abs(x[:, 0]) < 2e-3), name=name)
        deck["Materials"]["Other"] = {**deck["Materials"]["Steel"], **other}
        deck["Blocks"]["Other"] = {**deck["Blocks"]["Body"], "Block Names": "block_2", "Material": "Other"}
        self.compare(deck, fields, (3,), prepare=self.centred, floor=1e-13 * 12e-3)

    def test_mechanics(self):
        self.check(self.pulled(1e-3, NEWTON), ["Displacement"], {"Young's Modulus": 50e9})

    def test_diffusion(self):
        deck = Diffusion.deck(self, {"Diffusion": {"Method": "Implicit Euler", "Load Steps": 4,
                                                   "Linear Tolerance": 1e-13}})
        self.check(deck, ["Concentration"], {"Diffusivity": 3e-7})


class Solid(SymmetryTest):
    """Half and an eighth of a block under its own stretch, with the linear peridynamic solid."""

    def deck(self, planes):
        conditions = {}
        for axis in "xyz":
            held = f"abs({axis}) > 3e-3"
            conditions[f"{axis} Node Set"] = {"Expression": held}
        conditions["Pull"] = {"Type": "Prescribed Displacement", "Node Set": "x Node Set", "Coordinate": "x",
                              "Value": "2e-3*x"}
        conditions["Squeeze"] = {"Type": "Prescribed Displacement", "Node Set": "y Node Set", "Coordinate": "y",
                                 "Value": "-1e-3*y*(1 + 1e5*x*x)"}
        conditions["Hold"] = {"Type": "Prescribed Displacement", "Node Set": "z Node Set", "Coordinate": "z",
                              "Value": "1e-4*z"}
        return {"Discretization": {"Type": "Text File"},
                "Materials": {"Steel": {"Material Model": "Elastic", "Young's Modulus": 200e9, "Poisson's Ratio": 0.3,
                                        "Density": 7850.0}},
                "Blocks": {"Body": {"Block Names": "block_1", "Material": "Steel", "Horizon": 2.2 * SPACING}},
                "Boundary Conditions": conditions,
                "Solver": {"Final Time": 1.0, **NEWTON},
                "Output": {"Output Frequency": 1, "Output Variables": ["Displacement"]}}

    def check(self, planes, lengths, ranks):
        origin = [0.0 if p in planes else -0.5 * length for p, length in zip((X, Y, Z), lengths)]
        self.make_meshes(lattice(lengths, SPACING, origin), planes, SPACING**3)
        self.compare(self.deck(planes), ["Displacement"], ranks=ranks, floor=1e-13 * 4e-3)

    def test_half(self):
        self.check([X], [4e-3, 8e-3, 8e-3], (4,))

    def test_eighth(self):
        self.check([X, Y, Z], [4e-3, 4e-3, 4e-3], (1,))


class Turned(SymmetryTest):
    """A quarter of a plate that is turned by 20 degrees and lies away from the origin."""

    def setUp(self):
        super().setUp()
        angle = math.radians(20.0)
        self.turn = np.array([[math.cos(angle), -math.sin(angle), 0.0], [math.sin(angle), math.cos(angle), 0.0],
                              [0.0, 0.0, 1.0]])
        self.origin = np.array([3e-3, -5e-3, 0.0])
        planes = [plane(self.turn @ normal, self.origin) for normal in ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])]
        part = lattice([10e-3, 6e-3], SPACING) @ self.turn.T + self.origin
        self.make_meshes(part, planes, SPACING**2 * THICKNESS)

    def deck(self, solver, damage=None, stretch=1e-3):
        c, s = self.turn[0, 0], self.turn[1, 0]
        along = f"({c!r}*(x - {self.origin[0]!r}) + {s!r}*(y - {self.origin[1]!r}))"
        conditions = {"Grip Node Set": {"Expression": f"abs{along} > 8e-3"}}
        for axis, share in (("x", c), ("y", s)):
            conditions[f"Pull {axis}"] = {"Type": "Prescribed Displacement", "Node Set": "Grip Node Set",
                                          "Coordinate": axis,
                                          "Value": f"{share * stretch * 10e-3!r}*t*{along}/abs{along}"}
        return plate_deck(HORIZON, THICKNESS, STEEL_PLATE, damage, conditions, solver,
                          {"Output Variables": ["Displacement"] + (["Damage"] if damage else [])})

    def test_newton(self):
        self.compare(self.deck(NEWTON), ["Displacement"], (1, 4), floor=1e-13 * 12e-3)

    def test_relaxation(self):
        self.compare(self.deck(RELAXATION), ["Displacement"], (2,), same=1e-9)

    def test_verlet(self):
        self.compare(self.deck({"Final Time": 1e-5, "Verlet": {"Fixed dt": 1e-7}}, stretch=1e3), ["Displacement"],
                     ranks=(2,), floor=1e-13 * 12e-3)


class Pit(SymmetryTest):
    """Half of a pit under a plane surface."""

    def setUp(self):
        super().setUp()
        spacing = 1e-6
        self.make_meshes(lattice([16e-6, 14e-6], spacing), [X], spacing**2)

    def deck(self, steps=6, **solver):
        deck = corrosion_deck(2, STEEL, "x*x + y*y > 3.6e-11", "x*x + y*y < 6e-12", 20.0, steps, **solver)
        deck["Solver"]["Corrosion"]["Solver Tolerance"] = 1e-12
        return deck

    def check(self, deck, ranks):
        whole, part = self.compare(deck, ["Concentration", "Damage"], ranks=ranks, same=1e-8)
        for step in whole.steps():
            np.testing.assert_array_equal(part.field("Damage", step) == 1.0,
                                          whole.field("Damage", step)[:self.n] == 1.0)
        self.assertGreater(np.sum(part.field("Damage") == 1.0) - np.sum(part.field("Damage", 0) == 1.0), 30)
        dissolved = [result.history()["Dissolved"][-1] for result in (part, whole)]
        self.assertAlmostEqual(2.0 * dissolved[0] / dissolved[1], 1.0, delta=1e-9)

    def test_implicit(self):
        self.check(self.deck(), (1, 4))

    def test_explicit(self):
        self.check(self.deck(Method="RKL"), (2,))

    def test_random_bonds_do_not_depend_on_ranks(self):
        """Bonds to images and what these mirror break together; a whole body draws other numbers on the other side."""
        deck = self.deck()
        deck["Damage Models"]["Phases"].update({"Rule": "Stochastic", "Random Seed": 5})
        one = self.solve(self.deck_of(deck, "one", True))
        found = self.solve(self.deck_of(deck, "more", True), ranks=4)
        for step in one.steps():
            np.testing.assert_array_equal(found.field("Damage", step), one.field("Damage", step))
        self.assertGreater(np.sum(one.field("Damage") == 1.0) - np.sum(one.field("Damage", 0) == 1.0), 30)


class Restarts(CrackedPlate):
    def test_go_on_on_the_same_and_another_number_of_ranks(self):
        deck = self.deck({"Verlet": {"Fixed dt": 1e-7}}, 2e-5, **{"Output Frequency": 100, "Checkpoint Frequency": 100})
        through = self.solve(self.deck_of(deck, "through", True), ranks=2)
        half = copy.deepcopy(deck)
        half["Solver"]["Final Time"] = 1e-5
        for ranks in (2, 3):
            self.solve(self.deck_of(half, "again", True), ranks=2)
            found = self.solve(self.deck_of(deck, "again", True), ranks=ranks,
                               arguments=("--restart", "again.checkpoint.h5"))
            for label in ("Displacement", "Damage"):
                a, b = found.field(label, 200), through.field(label, 200)
                if ranks == 2 or label == "Damage":
                    np.testing.assert_array_equal(a, b)
                else:
                    np.testing.assert_allclose(a, b, rtol=0.0, atol=SAME * np.max(np.abs(b)))


if __name__ == "__main__":
    unittest.main()
