#!/usr/bin/python3
"""Static equilibria with bonds as springs: against sparse LU of assembled tangents, and what small strains are."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

SPACING, THICKNESS = 1e-3, 1e-3
GLASS = {"Young's Modulus": 70.0e9, "Poisson's Ratio": 0.2}


def plate(solver, damage, pull=1.0e-5):
    """30 mm x 24 mm between grips, with a crack from the left edge to the middle."""
    crack = {"Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0,
             "Lower_Left_Corner_X": -1.0, "Lower_Left_Corner_Y": 12e-3, "Lower_Left_Corner_Z": -1.0,
             "Bottom_Unit_Vector_X": 1.0, "Bottom_Unit_Vector_Y": 0.0, "Bottom_Unit_Vector_Z": 0.0,
             "Bottom_Length": 1.012, "Side_Length": 2.0}

    def moved(node_set, axis, value):
        return {"Type": "Prescribed Displacement", "Node Set": node_set, "Coordinate": axis, "Value": value}

    deck = plate_deck(
        3.2 * SPACING, THICKNESS, GLASS,
        conditions={"Top Node Set": {"Expression": "y > 20.7e-3"}, "Bottom Node Set": {"Expression": "y < 3.3e-3"},
                    "Up": moved("Top Node Set", "y", f"{pull}*t"), "Down": moved("Bottom Node Set", "y", f"{-pull}*t"),
                    "Top Does Not Slide": moved("Top Node Set", "x", 0.0),
                    "Bottom Does Not Slide": moved("Bottom Node Set", "x", 0.0)},
        solver={"QuasiStatic": {"Load Steps": 2, "Relative Tolerance": 1e-8, **solver}},
        output={"Output Variables": ["Displacement"] + (["Damage"] if damage else [])})
    deck["Discretization"]["Bond Filters"] = {"Crack": crack}
    if damage:
        deck["Damage Models"] = {"Limit": {"Damage Model": "Critical Stretch", "Critical Stretch": 1.0e-3}}
        block = next(iter(deck["Blocks"].values()))
        block["Damage Model"] = "Limit"
    return deck


class CrackedPlate(SceneTest):
    def setUp(self):
        super().setUp()
        points = lattice([0.03, 0.024], SPACING)
        points[:, :2] += 0.15 * SPACING * np.random.default_rng(1).uniform(-1.0, 1.0, (len(points), 2))
        self.write_mesh(points, SPACING**2 * THICKNESS)

    def test_breaks_the_bonds_that_it_breaks_with_a_direct_solver(self):
        springs = self.solve(plate({}, True))
        with open(self.path("result.log")) as log:
            self.assertIn(" 0 tangents", log.read())
        direct = self.solve(plate({"Linear Solver": "Direct"}, True))
        self.assertGreater(direct.field("Damage").max(), 0.5)
        np.testing.assert_array_equal(springs.field("Damage"), direct.field("Damage"))
        u, exact = springs.field("Displacement"), direct.field("Displacement")
        self.assertLess(np.max(np.abs(u - exact)), 1e-7 * np.max(np.abs(exact)))  # 10 times the tolerance

    def test_small_strain_is_the_limit_of_small_displacements(self):
        small, smaller = ({"Kinematics": "Small Strain"}, 1.0e-5), ({}, 1.0e-9)
        a, b = (self.solve(plate(solver, False, pull)).field("Displacement") / pull for solver, pull in (small, smaller))
        # Strains of the latter are some 1e-7, and so is what is not linear in them; the tolerance is 1e-8.
        self.assertLess(np.max(np.abs(a - b)), 1e-6 * np.max(np.abs(b)))

    def test_small_strain_grows_with_its_loads(self):
        """Where all of them grow alike nothing is solved for anew: a load of nothing, which could be another, prevents it."""
        nothing = {"Type": "Body Force", "Node Set": "All Node Set", "Coordinate": "x", "Value": 0.0}
        for down in ("-1.0e-5*t", "-1.0e-5*t*t"):
            found, solved = [], []
            for load in (None, nothing):
                deck = plate({"Kinematics": "Small Strain", "Load Steps": 10}, True)
                conditions = deck["Boundary Conditions"]
                conditions["Down"]["Value"] = down
                conditions["All Node Set"] = {"Expression": "x > 0"}
                if load:
                    conditions["Nothing"] = load
                found.append(self.solve(deck))
                with open(self.path("result.log")) as log:
                    words = next(line for line in log if "linear iterations" in line).split()
                solved.append(int(words[words.index("linear") - 1]))
            self.assertGreater(found[0].field("Damage").max(), 0.5)
            np.testing.assert_array_equal(found[0].field("Damage"), found[1].field("Damage"))
            u, exact = (result.field("Displacement") for result in found)
            self.assertLess(np.max(np.abs(u - exact)), 1e-7 * np.max(np.abs(exact)))
            (self.assertEqual if "t*t" in down else self.assertLess)(*solved)

    def test_small_strain_of_large_displacements_is_warned_of(self):
        # The plate is 24 mm high: a twentieth of that, and a hundredth of a percent.
        for pull, is_warned in ((1.2e-3, True), (2.4e-6, False)):
            self.solve(plate({"Kinematics": "Small Strain"}, False, pull))
            with open(self.path("result.log")) as log:
                self.assertEqual("too much for Kinematics: Small Strain" in log.read(), is_warned)


class PlateThatComesApart(SceneTest):
    def test_halves_that_nothing_holds_along_x_carry_their_loads(self):
        """Pulled apart along y by grips that slide along x, under forces along x that balance in each row."""
        half_width, load = 15e-3, 1.2e11  # m; N/m4
        self.write_mesh(lattice([2.0 * half_width, 24e-3], SPACING), SPACING**2 * THICKNESS)
        for ranks in (1, 2):
            deck = plate({"Load Steps": 10, "Kinematics": "Small Strain"}, True)
            conditions = deck["Boundary Conditions"]
            del conditions["Top Does Not Slide"], conditions["Bottom Does Not Slide"]
            conditions["All Node Set"] = {"Expression": "x > 0"}
            conditions["Apart"] = {"Type": "Body Force", "Node Set": "All Node Set", "Coordinate": "x",
                                   "Value": f"{load}*(x - {half_width})"}
            result = self.solve(deck, ranks=ranks)
            with open(self.path("result.log")) as log:
                self.assertIn("2 part(s) of 720 points", log.read())
            u = result.field("Displacement")[:, 0].reshape(24, 30)
            longer = (u[:, -1] - u[:, 0]) / (u[:, 15] - u[:, 14])
            # E u' = load (a^2 - (x - a)^2)/2, a: half of the width; between points 29 spacings and one apart.
            strain = np.polynomial.Polynomial([half_width**2 / 2, 0.0, -0.5]).integ()
            exact = strain(14.5 * SPACING) / strain(0.5 * SPACING)
            self.assertAlmostEqual(np.mean(longer), exact, delta=0.03 * exact)


class Refusals(SceneTest):
    def test_what_needs_a_matrix_does_not_go_with_springs(self):
        self.write_mesh(lattice([0.03, 0.024], SPACING), SPACING**2 * THICKNESS)
        for solver in ({"Linear Solver": "GMRES", "Preconditioner": "Two Level"},
                       {"Kinematics": "Small Strain", "Preconditioner": "Multigrid"}):
            result = self.run_deck(plate(solver, False))
            self.assertEqual(result.code, 2, result.text)
            self.assertIn("without a matrix", result.text)

    def test_bonds_that_one_end_alone_has_broken(self):
        # Pulled apart, the left half breaks its bonds to the right one, which keeps them; on two ranks these are bonds
        # between the ranks.
        points = lattice([0.03, 0.024], SPACING)
        self.write_mesh(points, SPACING**2 * THICKNESS, block=np.where(points[:, 0] < 15e-3, 1, 2))
        deck = plate_deck(
            3.2 * SPACING, THICKNESS, GLASS,
            conditions={"Left Node Set": {"Expression": "x < 3.3e-3"}, "Right Node Set": {"Expression": "x > 26.7e-3"},
                        "Hold": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Value": 0.0},
                        "Keep": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": "y",
                                 "Value": 0.0},
                        "Pull": {"Type": "Prescribed Displacement", "Node Set": "Right Node Set", "Value": "3e-5*t"}},
            solver={"QuasiStatic": {"Load Steps": 2, "Kinematics": "Small Strain"}},
            output={"Output Variables": ["Displacement"]})
        limit = {"Damage Model": "Critical Stretch", "Critical Stretch": 8.0e-4}
        deck["Damage Models"] = {"Weak": limit, "Strong": {**limit, "Critical Stretch": 1.0}}
        deck["Blocks"]["Body"]["Damage Model"] = "Weak"
        deck["Blocks"]["Other"] = {**deck["Blocks"]["Body"], "Block Names": "block_2", "Damage Model": "Strong"}
        for ranks in (1, 2):
            result = self.run_deck(deck, ranks=ranks)
            self.assertEqual(result.code, 3, result.text)
            self.assertIn("has broken its bond to that at", result.text)
            self.assertIn("Kinematics: Finite", result.text)


if __name__ == "__main__":
    unittest.main()
