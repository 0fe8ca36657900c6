#!/usr/bin/python3
"""Bodies that come apart: cracks through the whole plate, points without bonds, a jump of the coverage."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

YOUNG, SPACING, THICKNESS = 200e9, 1e-3, 2e-3
HORIZON = 3.015 * SPACING
WIDTH, HEIGHT = 0.024, 0.020
LAYER = 3.0 * SPACING  # of the grips

NEWTON = {"QuasiStatic": {"Relative Tolerance": 1e-8}}
RELAXATION = {"Adaptive Dynamic Relaxation": {"Relative Tolerance": 1e-7}}
CRITICAL_STRETCH = 2e-3
ROUND_OFF = 1e-15  # m: what rounding of coordinates near 0.02 m makes of displacements


def cut(width, y=HEIGHT / 2):
    """A bond filter: from the left edge to x = width."""
    return {"Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0,
            "Lower_Left_Corner_X": -SPACING, "Lower_Left_Corner_Y": y, "Lower_Left_Corner_Z": -1.0,
            "Bottom_Unit_Vector_X": 1.0, "Bottom_Unit_Vector_Y": 0.0, "Bottom_Unit_Vector_Z": 0.0,
            "Bottom_Length": width + SPACING, "Side_Length": 2.0}


class Plate(SceneTest):
    def setUp(self):
        super().setUp()
        self.x = lattice([WIDTH, HEIGHT], SPACING)
        self.write_mesh(self.x, SPACING**2 * THICKNESS)
        self.top, self.bottom = self.x[:, 1] > HEIGHT / 2, self.x[:, 1] < HEIGHT / 2

    def deck(self, solver, conditions, cracks=(), damage=None, material=None, **output):
        sets = {"Top Node Set": {"Expression": f"y > {HEIGHT - LAYER}"},
                "Bottom Node Set": {"Expression": f"y < {LAYER}"},
                "Grip Node Set": {"Expression": f"y < {LAYER} || y > {HEIGHT - LAYER}"},
                "All Node Set": {"Expression": "x > -1"}}
        deck = plate_deck(HORIZON, THICKNESS, {"Young's Modulus": YOUNG, "Poisson's Ratio": 0.3, "Density": 8000.0,
                                               **(material or {})},
                          damage, {**sets, **conditions}, {"Final Time": 1.0, **solver},
                          {"Output Variables": ["Displacement"], "Output Frequency": 1, **output})
        if cracks:
            deck["Discretization"]["Bond Filters"] = {f"Crack {n}": crack for n, crack in enumerate(cracks)}
        return deck

    def hold(self, where, axis, value):
        return {f"{where} {axis}": {"Type": "Prescribed Displacement", "Node Set": f"{where} Node Set",
                                    "Coordinate": axis, "Value": value}}


class CrackThroughThePlate(Plate):
    def test_halves_follow_their_grips_without_force(self):
        conditions = {**self.hold("Top", "y", "1e-5*t"), **self.hold("Top", "x", "5e-6*t"),
                      **self.hold("Bottom", "y", 0.0), **self.hold("Bottom", "x", 0.0)}
        for solver in (NEWTON, RELAXATION):
            u = self.solve(self.deck(solver, conditions, [cut(WIDTH + SPACING)])).field("Displacement")
            # A tolerance of 1e-8 or 1e-7 of the forces that bring the halves along.
            self.assertLess(np.max(np.abs(u[self.bottom])), 1e-12, solver)
            self.assertLess(np.max(np.abs(u[self.top] - [5e-6, 1e-5, 0.0])), 1e-10, solver)

    def test_half_that_nothing_holds_stays_where_it_is(self):
        # u = 1e-4 (y, x, 0) - simple shear of the held half, a linear field that its layer prescribes.
        conditions = {**self.hold("Bottom", "x", "1e-4*y*t"), **self.hold("Bottom", "y", "1e-4*x*t")}
        for solver in (NEWTON, RELAXATION):
            u = self.solve(self.deck(solver, conditions, [cut(WIDTH + SPACING)])).field("Displacement")
            self.assertLess(np.max(np.abs(u[self.top])), ROUND_OFF, solver)
            self.assertTrue(np.all(np.isfinite(u)))
            self.assertLess(np.max(np.abs(u[self.bottom])), 4e-6)
            self.assertGreater(np.max(np.abs(u[self.bottom])), 1e-6)

    def test_loose_piece_between_two_cracks_does_not_hinder_the_rest(self):
        conditions = {**self.hold("Top", "y", "1e-5*t"), **self.hold("Top", "x", 0.0),
                      **self.hold("Bottom", "y", 0.0), **self.hold("Bottom", "x", 0.0)}
        cracks = [cut(WIDTH + SPACING, HEIGHT / 2 - 2 * SPACING), cut(WIDTH + SPACING, HEIGHT / 2 + 2 * SPACING)]
        middle = np.abs(self.x[:, 1] - HEIGHT / 2) < 2 * SPACING
        for solver in (NEWTON, RELAXATION):
            u = self.solve(self.deck(solver, conditions, cracks)).field("Displacement")
            self.assertLess(np.max(np.abs(u[middle])), ROUND_OFF, solver)
            self.assertLess(np.max(np.abs(u[self.top & ~middle] - [0.0, 1e-5, 0.0])), 1e-10, solver)

    def test_crack_that_runs_through_during_the_run_unloads_both_halves(self):
        conditions = {**self.hold("Top", "y", f"{3 * CRITICAL_STRETCH * HEIGHT!r}*t"), **self.hold("Top", "x", 0.0),
                      **self.hold("Bottom", "y", 0.0), **self.hold("Bottom", "x", 0.0),
                      "Grips": {"Type": "No Failure", "Node Set": "Grip Node Set"}}
        damage = {"Damage Model": "Critical Stretch", "Critical Stretch": CRITICAL_STRETCH}
        end = 3 * CRITICAL_STRETCH * HEIGHT
        for solver in (NEWTON, RELAXATION):
            name = next(iter(solver))
            deck = self.deck({name: {**solver[name], "Load Steps": 30}}, conditions, [cut(WIDTH / 3)], damage,
                             **{"Output Variables": ["Displacement", "Damage", "Pull"]})
            deck["Compute Class Parameters"] = {"Pull": {"Compute Class": "Reaction_Force",
                                                         "Node Set": "Top Node Set", "Output Label": "Pull"}}
            result = self.solve(deck)
            pull = np.abs(next(v for k, v in result.history().items() if k.startswith("Pull") and "y" in k.lower()))
            u = result.field("Displacement")
            self.assertLess(pull[-1], 1e-6 * np.max(pull), name)
            far = np.abs(self.x[:, 1] - HEIGHT / 2) > HEIGHT / 2 - LAYER - SPACING
            self.assertLess(np.max(np.abs(u[self.bottom & far])), 1e-5 * end, name)
            self.assertLess(np.max(np.abs(u[self.top & far] - [0.0, end, 0.0])), 1e-5 * end, name)


class PointWithoutBonds(Plate):
    """The corner point of the right top is torn out."""

    damage = {"Damage Model": "Critical Stretch", "Critical Stretch": 0.02}

    def setUp(self):
        super().setUp()
        self.lost = int(np.argmax(self.x[:, 0] + self.x[:, 1]))
        self.sets = {"Lost Node Set": {"Expression": f"x > {WIDTH - SPACING} && y > {HEIGHT - SPACING}"}}

    def check(self, result):
        damage, u = result.field("Damage").ravel(), result.field("Displacement")
        rest = np.arange(len(self.x)) != self.lost
        self.assertEqual(damage[self.lost], 1.0)
        self.assertLess(np.max(damage[rest]), 0.2)  # of neighbours, which have lost one bond of 10 or more
        self.assertTrue(np.all(np.isfinite(u)))
        return u, rest

    def test_static_plate_springs_back(self):
        conditions = {**self.sets, **self.hold("Bottom", "y", 0.0), **self.hold("Bottom", "x", 0.0),
                      **self.hold("Lost", "y", f"{1.5 * SPACING}*t"), **self.hold("Lost", "x", 0.0)}
        for solver in (NEWTON, RELAXATION):
            name = next(iter(solver))
            result = self.solve(self.deck({name: {**solver[name], "Load Steps": 20}}, conditions, damage=self.damage,
                                          **{"Output Variables": ["Displacement", "Damage"]}))
            u, rest = self.check(result)
            self.assertAlmostEqual(u[self.lost, 1] / (1.5 * SPACING), 1.0, delta=1e-12)
            self.assertLess(np.max(np.abs(u[rest])), 1e-9, name)  # of the 1.5e-3 that the corner went

    def test_flies_on_at_its_velocity(self):
        conditions = {**self.sets,
                      "Jump": {"Type": "Initial Displacement", "Node Set": "Lost Node Set", "Coordinate": "y",
                               "Value": SPACING},
                      "Flight": {"Type": "Initial Velocity", "Node Set": "Lost Node Set", "Coordinate": "x",
                                 "Value": 123.0}}
        deck = self.deck({"Verlet": {}}, conditions, damage=self.damage,
                         **{"Output Variables": ["Displacement", "Velocity", "Damage"]})
        deck["Solver"]["Final Time"] = 1e-5
        result = self.solve(deck)
        u, rest = self.check(result)
        self.assertAlmostEqual(u[self.lost, 0], 123.0 * 1e-5, delta=1e-15)
        self.assertAlmostEqual(u[self.lost, 1], SPACING, delta=1e-15)
        self.assertEqual(result.field("Velocity")[self.lost, 0], 123.0)
        self.assertLess(np.max(np.abs(u[rest])), ROUND_OFF)  # the bonds broke before they pulled

    def test_keeps_its_hydrogen_where_broken_bonds_carry_none(self):
        conditions = {**self.sets, **self.hold("Bottom", "y", 0.0), **self.hold("Bottom", "x", 0.0),
                      **self.hold("Lost", "y", f"{1.5 * SPACING}*min(1, 1.25*t)"), **self.hold("Lost", "x", 0.0),
                      "Full": {"Type": "Prescribed Concentration", "Node Set": "Bottom Node Set", "Value": 1.0}}
        deck = self.deck({"Staggered": {"Load Steps": 25, "Diffusion": {"Method": "RKL"}, "Mechanics": NEWTON}},
                         conditions, damage=self.damage,
                         material={"Diffusivity": 1e-4, "Diffusion Stops At Broken Bonds": True},
                         **{"Output Variables": ["Displacement", "Damage", "Concentration"]})
        result = self.solve(deck)
        _, rest = self.check(result)
        torn, last = result.field("Concentration", 20).ravel(), result.field("Concentration").ravel()
        self.assertEqual(last[self.lost], torn[self.lost])  # its last bond breaks in step 20 or before
        self.assertGreater(np.min(last[rest]), 0.1)


class CoverageJump(Plate):
    def test_saturation_at_once_breaks_the_strained_part_at_once(self):
        # Strain 0.3 of the critical stretch; at saturation a bond breaks at 1 - 1.0467 + 0.1687 = 0.122 of it. Rows in
        # the middle of an empty plate jump to saturation at t = 0.5.
        saturation = 2.65e-5
        away = np.abs(self.x[:, 1] - HEIGHT / 2) > 2 * SPACING + HORIZON + SPACING
        conditions = {**self.hold("Top", "y", f"{0.3 * CRITICAL_STRETCH * HEIGHT!r}*min(1, 10*t)"),
                      **self.hold("Bottom", "y", 0.0),
                      "Middle Node Set": {"Expression": f"abs(y - {HEIGHT / 2}) < {2 * SPACING}"},
                      "Hydrogen": {"Type": "Prescribed Concentration", "Node Set": "Middle Node Set",
                                   "Value": {"Table": [[0.0, 0.0], [0.5, 0.0], [0.5, saturation], [1.0, saturation]]}},
                      "Grips": {"Type": "No Failure", "Node Set": "Grip Node Set"},
                      "Sources": {"Type": "Saturated Crack Faces", "Field": "Concentration", "Value": saturation,
                                  "Threshold": 0.36}}
        damage = {"Damage Model": "Hydrogen Critical Stretch", "Critical Stretch": CRITICAL_STRETCH,
                  "Saturation Concentration": saturation}
        expected = None
        for diffusion in ("RKL", "RKC", "Euler"):
            for mechanics in (NEWTON, RELAXATION):
                deck = self.deck({"Staggered": {"Load Steps": 10, "Diffusion": {"Method": diffusion},
                                                "Mechanics": mechanics}},
                                 conditions, damage=damage, material={"Diffusivity": 1e-7},
                                 **{"Output Variables": ["Displacement", "Damage", "Concentration"]})
                result, label = self.solve(deck), f"{diffusion}, {mechanics}"
                self.assertEqual(np.max(result.field("Damage", 4)), 0.0, label)
                broken = result.field("Damage", 5).ravel()
                self.assertGreater(np.min(broken[~away & (np.abs(self.x[:, 1] - HEIGHT / 2) < 2 * SPACING)]), 0.3)
                self.assertEqual(np.max(broken[away]), 0.0, label)
                if expected is None:
                    expected = broken
                for step in (5, 10):  # at once, and then no more
                    np.testing.assert_array_equal(result.field("Damage", step).ravel(), expected, label)
                concentration = result.field("Concentration")
                # A stabilised step of a jump may over- and undershoot by its tolerance, 1e-4.
                self.assertGreaterEqual(np.min(concentration), -1e-4 * saturation, label)
                self.assertLessEqual(np.max(concentration), (1.0 + 1e-4) * saturation, label)
                self.assertEqual(np.max(np.abs(result.field("Concentration", 4))), 0.0, label)


if __name__ == "__main__":
    unittest.main()
