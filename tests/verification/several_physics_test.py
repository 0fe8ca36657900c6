#!/usr/bin/python3
"""Several physics on the same points: metal that dissolves while it carries load, hydrogen and metal ions, blocks that
dissolve beside blocks that do not."""
import os
import re
import sys
import unittest

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, "../support")]
from corrosion_scene import HORIZON, SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402
from loaded_metal import (DISSOLUTION, LENGTH, MECHANICS, NEWTON, POISSON, PULL, ROWS, YOUNG, LoadedMetal,  # noqa: E402
                          bar_deck, grips, sea)

# When a front is in the middle of the fifth row: four are liquid on either side, and half of the section is left.
HALF_GONE = 4.5 * SPACING / front_speed(STEEL)
LIMIT = 1.5 * 20.0 * PULL / ((LENGTH - 2) * SPACING)  # stretch that only corners of the grips reach
CORRODE = {"Corrosion": {"Load Steps": 1}}


class DissolvingBar(LoadedMetal):
    def dissolve(self, force=None, damage_models=None, pull=None, **more):
        self.make_bar()
        conditions = {**grips(force), **sea()}
        if pull is not None:
            conditions["Pull"]["Value"] = pull
        solvers = [(1.0, NEWTON), (1.0 + HALF_GONE, CORRODE), (2.0 + HALF_GONE, NEWTON)]
        deck = bar_deck({"Steel": MECHANICS, "Electrolyte": DISSOLUTION},
                        damage_models or {"Phases": {"Damage Model": "Dissolution"}}, conditions, solvers,
                        ["Displacement", "Damage", "Concentration", *more.get("Compute Class Parameters", [])], **more)
        result = self.solve(deck)
        self.liquid = result.field("Damage", 2) >= 1.0
        # Kept, since the next run writes over the files.
        self.displacement = {step: result.field("Displacement", step) for step in (1, 3)}
        self.reaction = result.history().get("ReactionX")
        return result

    def core_alone(self, force=None):
        """The half that is left, from the start: eight rows."""
        self.make_bar(ROWS // 2, 0)
        result = self.solve(bar_deck({"Steel": MECHANICS}, {}, grips(force), [(1.0, NEWTON)], ["Displacement"]))
        return result, self.x

    def check_displacements(self, x, core, x_core):
        left = np.abs(x[:, 1]) < 0.25 * ROWS * SPACING
        np.testing.assert_allclose(x[left], x_core, rtol=0, atol=1e-9 * SPACING)
        u, u_core = self.displacement[3][left], core.field("Displacement")
        self.assertLess(np.max(np.abs(u - u_core)), 1e-7 * np.max(np.abs(u_core)))

    def test_held_by_its_ends_loses_reaction_with_half_of_its_section(self):
        self.dissolve()
        x = self.x
        np.testing.assert_array_equal(self.liquid, np.abs(x[:, 1]) > 0.25 * ROWS * SPACING)
        core, x_core = self.core_alone()
        self.check_displacements(x, core, x_core)
        reaction, alone = self.reaction, core.history()["ReactionX"]
        self.assertAlmostEqual(reaction[-1] / alone[-1], 1.0, delta=1e-7)
        # Half of the section goes, but the grips hold its core: what goes was pulled less near them.
        self.assertGreater(reaction[-1] / self.reaction[1], 0.5)
        self.assertLess(reaction[-1] / self.reaction[1], 0.65)
        strain = PULL / ((LENGTH - 2) * SPACING)
        expected = YOUNG / (1.0 - POISSON**2) * strain * ROWS / 2 * SPACING  # a strip under plane strain, N
        self.assertAlmostEqual(abs(reaction[-1]) / expected, 1.0, delta=0.15)  # rows at the sides are softer

    def test_under_a_constant_force_its_stress_doubles(self):
        force = 1e13
        self.dissolve(force)
        x = self.x
        core, x_core = self.core_alone(force)
        self.check_displacements(x, core, x_core)
        # Strain of the middle third of the core.
        gauge = [np.abs(x[:, 0] - at * LENGTH * SPACING) < 0.6 * SPACING for at in (1 / 3, 2 / 3)]
        in_core = np.abs(x[:, 1]) < 0.25 * ROWS * SPACING

        def strain(step):
            u = self.displacement[step][:, 0]
            ends = [np.mean(u[near & in_core]) for near in gauge]
            return (ends[1] - ends[0]) / (LENGTH / 3 * SPACING)

        self.assertAlmostEqual(strain(3) / strain(1), 2.0, delta=0.12)
        # The force is on two columns of eight points.
        stress = force * 2 * SPACING
        # The two rows at either side of eight are softer.
        self.assertAlmostEqual(strain(3) * YOUNG / (1.0 - POISSON**2) / stress, 1.0, delta=0.2)

    def test_breaks_as_what_is_left_of_it_would_alone(self):
        harder = 1.0 + HALF_GONE  # s; from then on the bar is pulled 20 times as far
        pull = f"{PULL!r}*(1 + 19*min(max(t - {harder!r}, 0), 1))"
        breakage = {"Damage Model": "Critical Stretch", "Critical Stretch": LIMIT}
        counts = {"Compute Class Parameters": {"N": {"Compute Class": "Number_Of_Neighbors", "Output Label": "N"}}}

        def broken(result, step):
            return np.rint(result.field("Damage", step) * result.field("N", step)).astype(int), result.field("N", step)

        self.make_bar(ROWS // 2, 0)
        conditions = grips()
        conditions["Pull"]["Value"] = 20.0 * PULL
        core, n_core = broken(self.solve(bar_deck({"Steel": MECHANICS}, {"Breakage": breakage}, conditions,
                                                  [(1.0, NEWTON)], ["Damage", "N"], **counts)), 1)
        self.assertGreater(np.count_nonzero(core), 10)
        self.assertLess(np.count_nonzero(core), len(core) // 2)
        models = {"Phases": {"Damage Model": "Dissolution"}, "Breakage": breakage}
        for order in (["Phases", "Breakage"], ["Breakage", "Phases"]):
            whole, n_whole = broken(self.dissolve(None, {name: models[name] for name in order}, pull, **counts), 3)
            left = np.abs(self.x[:, 1]) < 0.25 * ROWS * SPACING
            # What has dissolved has taken its bonds along.
            np.testing.assert_array_equal(whole[left] - (n_whole[left] - n_core), core)


class HydrogenAndIons(LoadedMetal):
    """Each of two scalars on the same points does what it does alone, to the last bit."""
    HYDROGEN = {"Material Model": "PDHE", "Plane Strain": True, "Diffusivity": 2e-12, "Diffusing Field": "Hydrogen"}
    CONDITIONS = {"Charged Node Set": {"Expression": f"x < {3 * SPACING!r}"},
                  "Charge": {"Type": "Prescribed Value", "Field": "Hydrogen", "Node Set": "Charged Node Set",
                             "Value": 1.0}}
    DIFFUSE = {"Diffusion": {"Field": "Hydrogen", "Method": "RKL", "Load Steps": 2}}

    def ions(self, field):
        return ({**DISSOLUTION, "Concentration Field": field},
                {"Phases": {"Damage Model": "Dissolution", "Concentration Field": field}},
                {"Corrosion": {"Load Steps": 2, "Concentration Field": field}})

    def test_live_on_the_same_points(self):
        self.make_bar()
        loss = {"Loss": {"Compute Class": "Volume_Loss", "Output Label": "Loss"}}
        metal, phases, corrode = self.ions("Concentration")
        alone = self.solve(bar_deck({"Metal": metal}, phases, sea(), [(10.0, corrode)],
                                    ["Concentration", "Damage", "Loss"], **{"Compute Class Parameters": loss}))
        c, damage, lost = alone.field("Concentration"), alone.field("Damage"), alone.history()["Loss"][-1]
        # From 10 s on, as below: times are rounded.
        dry = self.solve(bar_deck({"Steel": self.HYDROGEN}, {}, self.CONDITIONS, [(20.0, self.DIFFUSE)], ["Hydrogen"],
                                  start=10.0))
        hydrogen = dry.field("Hydrogen")
        metal, phases, corrode = self.ions("Ions")
        loss["Loss"]["Concentration Field"] = "Ions"
        both = self.solve(bar_deck({"Steel": self.HYDROGEN, "Metal": metal}, phases,
                                   {**sea("Ions"), **self.CONDITIONS}, [(10.0, corrode), (20.0, self.DIFFUSE)],
                                   ["Ions", "Hydrogen", "Damage", "Loss"], **{"Compute Class Parameters": loss}))
        np.testing.assert_array_equal(both.field("Ions"), c)
        np.testing.assert_array_equal(both.field("Damage"), damage)
        np.testing.assert_array_equal(both.field("Hydrogen"), hydrogen)
        self.assertEqual(both.history()["Loss"][-1], lost)
        self.assertGreater(np.max(hydrogen[self.x[:, 0] > 3 * SPACING]), 0.1)

    def test_a_solver_and_a_material_that_name_different_ions_are_told_so(self):
        self.make_bar()
        metal, phases, _ = self.ions("Ions")
        result = self.run_deck(bar_deck({"Metal": metal}, phases, sea("Ions"), [(1.0, CORRODE)], ["Ions"]))
        self.assertEqual(result.code, 2, result.text)
        self.assertIn('Corrosion: it does not advance "Ions", into which the metal of Materials/Metal dissolves', result.text)


class BlocksBesideEachOther(CorrosionTest):
    TIME = 60.0

    def corrode_beside(self, dimension, is_inert, **solver):
        """As corrosion_deck, but points of `is_inert` are of a block that does not dissolve."""
        self.write_mesh(self.x, self.volume, np.where(is_inert, 2, 1))
        deck = corrosion_deck(dimension, STEEL, "x > 0", "x < -2e-6", self.TIME, 6, **solver)
        deck["Materials"]["Rock"] = {"Material Model": "PDHE", "Diffusivity": 1e-12, "Diffusing Field": "Water",
                                     **({"One Dimensional": True} if dimension == 1 else {"Plane Strain": True})}
        deck["Blocks"]["Wall"] = {"Block Names": "block_2", "Material": "Rock", "Horizon": HORIZON}
        result = self.solve(deck)
        balance = re.search(r"the balance is off by (\S+) of it", " ".join(result.report["solver"]))
        self.assertLess(float(balance.group(1)), 1e-10)
        for step in result.steps():
            self.assertEqual(np.max(np.abs(result.field("Damage", step)[is_inert])), 0.0)
        return result

    def test_a_wall_behind_the_metal_changes_nothing_until_the_front_is_there(self):
        self.make_lattice([40e-6], [-7e-6, 0.0, 0.0])
        alone = self.corrode(1, STEEL, "x > 0", "x < -2e-6", self.TIME, 6)
        damage, c = alone.field("Damage"), alone.field("Concentration")
        is_inert = self.x[:, 0] > 20e-6
        beside = self.corrode_beside(1, is_inert)
        np.testing.assert_array_equal(beside.field("Damage")[~is_inert], damage[~is_inert])
        np.testing.assert_array_equal(beside.field("Concentration")[~is_inert], c[~is_inert])

    def test_metal_is_gone_up_to_the_wall_and_no_further(self):
        self.make_lattice([20e-6], [-7e-6, 0.0, 0.0])
        is_inert = self.x[:, 0] > 6e-6
        result = self.corrode_beside(1, is_inert)
        np.testing.assert_array_equal(result.field("Damage")[~is_inert], 1.0)

    def test_a_front_along_a_wall_keeps_its_speed(self):
        self.make_lattice([27e-6, 12e-6], [-7e-6, 0.0, 0.0])
        is_inert = self.x[:, 1] < 5e-6
        result = self.corrode_beside(2, is_inert)
        c, x = result.field("Concentration"), self.x
        gone = np.where(x[:, 0] > 0, (STEEL["Solid Concentration"] - c) /
                        (STEEL["Solid Concentration"] - STEEL["Saturation Concentration"]), 0.0)
        gone = np.where(result.field("Damage") >= 1.0, x[:, 0] > 0, gone)
        for row in np.unique(x[~is_inert, 1]):
            depth = np.sum(gone[x[:, 1] == row]) * SPACING
            self.assertAlmostEqual(depth / (front_speed(STEEL) * self.TIME), 1.0, delta=0.03)

    def test_without_any_block_that_dissolves_the_solver_says_so(self):
        self.make_lattice([8e-6], [0.0, 0.0, 0.0])
        deck = corrosion_deck(1, STEEL, "x > 1e-6", "x < 1e-6", 1.0, 1)
        deck["Materials"]["Metal"] = {"Material Model": "PDHE", "Diffusivity": 1e-12, "One Dimensional": True}
        del deck["Damage Models"], deck["Blocks"]["Body"]["Damage Model"]
        deck["Compute Class Parameters"] = {}
        deck["Output"]["Output Variables"] = ["Concentration"]
        result = self.run_deck(deck)
        self.assertEqual(result.code, 2, result.text)
        self.assertRegex(result.text, 'Solver/Corrosion: nothing in this deck provides .*"Corrosion Dissolution"')


if __name__ == "__main__":
    unittest.main()
