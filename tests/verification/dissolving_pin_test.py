#!/usr/bin/python3
"""A wire that dissolves in a flow: Corrosion Dissolution and Advection Diffusion with Steady Flow and Corrosion."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from flow_scene import RATIO, plane_lattice  # noqa: E402
from scene import SceneTest  # noqa: E402


class DissolvingPin(SceneTest):
    """A wire of magnesium across a channel."""
    SPACING, RADIUS, HALF = 10e-6, 40e-6, 100e-6

    def deck(self, film="exp(-t/3600)"):
        side = f"abs(y) > {self.HALF}"
        fluid, wire = "x < 1", f"x^2 + y^2 < {self.RADIUS}^2"
        steady = {"Steady Flow": {}, "When": {"Field": "Damage", "Has Changed By": 5e-10, "Measure": "Volume",
                                              "At Start": True}}
        plane = {"Plane Strain": True}
        return {
            "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt"},
            "Materials": {
                "Fluid": {"Material Model": "Navier Stokes", **plane, "Density": 1000.0, "Viscosity": 1e-3,
                          "Flux Horizon": 1.2 * self.SPACING},
                "Ions": {"Material Model": "Advection Diffusion", **plane, "Scheme": "Upwind Biased"},
                "Wire": {"Material Model": "Corrosion Dissolution", **plane, "Diffusivity": 1e-9,
                         "Solid Concentration": 71508.0, "Saturation Concentration": 20.0, "Charge Number": 2.0,
                         "Current Density": "5.73"}},
            "Damage Models": {"Phases": {"Damage Model": "Dissolution"}},
            "Blocks": {"Channel": {"Block Names": "block_1", "Material": ["Fluid", "Ions", "Wire"],
                                   "Damage Model": "Phases", "Horizon": RATIO * self.SPACING},
                       "Sides": {"Block Names": "block_2", "Material": "Fluid", "Horizon": RATIO * self.SPACING}},
            "Boundary Conditions": {
                "All Node Set": {"Expression": fluid}, "Wire Node Set": {"Expression": wire},
                "Side Node Set": {"Expression": side}, "In Node Set": {"Expression": f"x < -100e-6 && !({side})"},
                "Out Node Set": {"Expression": "x > 160e-6"},
                "End Node Set": {"Expression": f"x > 160e-6 && !({side})"},
                "Metal": {"Type": "Initial Concentration", "Node Set": "Wire Node Set", "Value": 71508.0},
                "Film": {"Type": "Film Coverage", "Node Set": "All Node Set", "Value": film},
                "Sides": {"Type": "Prescribed Velocity", "Node Set": "Side Node Set",
                          "Surface": f"{self.HALF} - abs(y)"},
                "In": {"Type": "Prescribed Velocity", "Node Set": "In Node Set", "Surface": "x + 100e-6",
                       "Velocity": [f"0.02*(1 - (y/{self.HALF})^2)", 0.0]},
                "Out": {"Type": "Outflow", "Node Set": "Out Node Set", "Surface": "160e-6 - x"},
                "Fresh": {"Type": "Prescribed Concentration", "Node Set": "In Node Set", "Value": 0.0},
                "Drain": {"Type": "Prescribed Concentration", "Node Set": "End Node Set", "Value": 0.0}},
            "Solver": {"Final Time": 28800.0, "Staggered": {"Load Steps": 4, "Solvers": {
                "Flow": steady, "Dissolution": {"Corrosion": {"Maximum dt": 3600.0}}}}},
            "Compute Class Parameters": {"Loss": {"Compute Class": "Volume_Loss", "Output Label": "Loss"}},
            "Output": {"Output Filename": "result", "Output Frequency": 1,
                       "Output Variables": ["Velocity", "Concentration", "Damage", "Fluid", "Loss",
                                            "Relative_Volume_Loss"]}}

    def mesh(self):
        points = plane_lattice((-100e-6, -self.HALF), (160e-6, self.HALF), self.SPACING, (0.2, 0.5))
        self.write_mesh(points, self.SPACING**2, block=np.where(np.abs(points[:, 1]) > self.HALF, 2, 1))
        return points

    def end_after_two_steps(self, deck):
        deck["Solver"]["Final Time"] = 14400.0
        deck["Solver"]["Staggered"]["Load Steps"] = 2

    def lines(self, result, words):
        return [line for line in result.report["solver"] if words in line]

    def test_limited_slopes_in_steps_of_an_hour(self):
        # A million times what the flow needs to pass a cell. Newton's method goes to and fro between the kinks of the
        # limiter; with limits held after some iterations, and anew where values fall below zero, it ends, in as many
        # steps as upwind. Metal is kept, and the wake is sharper than upwind.
        points = self.mesh()
        wakes, counts = [], []
        for scheme in ("Limited", "Upwind Biased"):
            deck = self.deck()
            self.end_after_two_steps(deck)
            deck["Materials"]["Ions"]["Scheme"] = scheme
            result = self.solve(deck)
            line = self.lines(result, "the balance is off by")[0]
            self.assertLess(float(line.split("off by")[1].split()[0]), 1e-12)
            words = self.lines(result, "Newton iterations")[0].split()
            steps, newton = (int(words[words.index(word) - 1]) for word in ("steps", "Newton"))
            self.assertLess(newton, 8 * steps)
            counts.append(steps)
            c, fluid = result.field("Concentration"), result.field("Fluid") == 1
            self.assertGreater(c[fluid].min(), -1e-3 * c[fluid].max())
            wake = fluid & (np.abs(points[:, 0] - 132e-6) < 1e-7)
            wakes.append((result.history()["Loss"][-1], np.sum(c[wake]**2) / np.sum(c[wake])**2))
        self.assertEqual(*counts)
        self.assertLess(abs(wakes[0][0] / wakes[1][0] - 1), 1e-6)
        self.assertGreater(wakes[0][1], 1.1 * wakes[1][1])

    def test_what_dissolves_between_two_flows_is_at_rest_until_the_next(self):
        points = self.mesh()
        deck = self.deck(film="0.0")
        deck["Solver"]["Staggered"]["Solvers"]["Flow"]["When"]["Has Changed By"] = 1.0
        deck["Materials"]["Wire"]["Current Density"] = "12.0"
        deck["Output"]["Output Variables"].append("Pressure")
        result = self.solve(deck)
        solid = [result.field("Damage", step) < 1 for step in (1, 3, 4)]
        gone = solid[0] & ~solid[1] & (np.hypot(points[:, 0], points[:, 1]) < self.RADIUS)
        self.assertGreater(np.count_nonzero(gone), 5)
        self.assertTrue(np.all(result.field("Velocity", 3)[gone] == 0.0))
        self.assertTrue(np.all(result.field("Pressure", 3)[gone] == 0.0))
        self.assertTrue(np.all(result.field("Fluid", 3)[gone] == 0.0))
        self.assertTrue(np.all(result.field("Fluid", 4)[gone] == 1.0))
        self.assertGreater(np.abs(result.field("Velocity", 4)[gone, 0]).min(), 0.0)
        self.assertTrue(np.all(result.field("Pressure", 4)[gone] != 0.0))
        c = result.field("Concentration", 3)[gone]
        self.assertTrue(np.all((c >= 0.0) & (c <= 20.0)))

    def drag_deck(self):
        """Flows are found anew when the drag should have changed by 0.3 of itself."""
        deck = self.deck(film="0.0")
        deck["Materials"]["Wire"]["Current Density"] = "15.0"
        deck["Compute Class Parameters"]["Drag"] = {"Compute Class": "Flow_Force", "Inner Radius": 50e-6,
                                                    "Outer Radius": 95e-6, "Output Label": "Drag"}
        deck["Output"]["Output Variables"].append("Drag")
        deck["Solver"]["Staggered"]["Load Steps"] = 8
        deck["Solver"]["Staggered"]["Solvers"]["Flow"]["When"].update(
            {"Has Changed By": 4e-10, "Value": "Drag", "Value Change": 0.3})
        return deck

    def flows_by_hand(self, result):
        """Steps whose flow should have been found: from what was enough after each, and whether that was due."""
        drag = result.history()["DragX"]
        volumes = [np.sum(result.field("Damage", step)) * self.SPACING**2 for step in range(9)]
        enough, found = 4e-10, [1]
        for step in range(2, 9):
            changed = volumes[step - 1] - volumes[found[-1] - 1]
            if changed >= enough or step == 8:
                before, after, enough_before = drag[found[-1]], drag[step], enough
                found.append(step)
                part = abs(after - before) / max(abs(before), abs(after))
                if part > 1e-6:  # else no whole point has dissolved
                    enough = min(max(changed * 0.3 / part, 0.25 * enough_before), 2 * enough_before)
        return found

    def test_flows_are_found_anew_when_the_drag_should_have_changed_on_triangles(self):
        edge = self.SPACING * np.sqrt(2 / np.sqrt(3))
        rows = np.arange(-self.HALF - 4 * self.SPACING, self.HALF + 4 * self.SPACING, edge * np.sqrt(0.75))
        columns = np.arange(-100e-6 - 4 * self.SPACING, 160e-6 + 4 * self.SPACING, edge)
        points = np.array([(x + 0.5 * edge * (k % 2), y, 0.0) for k, y in enumerate(rows) for x in columns])
        self.write_mesh(points, self.SPACING**2, block=np.where(np.abs(points[:, 1]) > self.HALF, 2, 1))
        result = self.solve(self.drag_deck())
        drag = result.history()["DragX"]
        found = self.flows_by_hand(result)
        self.assertEqual([step for step in range(1, 9) if drag[step] != drag[step - 1]], found)
        self.assertGreater(len(found), 2)
        self.assertLess(len(found), 8)

    def test_flows_are_found_anew_when_the_drag_should_have_changed(self):
        self.mesh()
        deck = self.drag_deck()
        deck["Compute Class Parameters"]["Rate"] = {"Compute Class": "Corrosion_Rate", "Over": "Last Interval",
                                                    "Output Label": "Rate"}
        deck["Output2"] = {"Output Filename": "early", "Final Output Step": 4, "Checkpoint Frequency": 4,
                           "Output Variables": ["Damage"]}
        when = deck["Solver"]["Staggered"]["Solvers"]["Flow"]["When"]
        result = self.solve(deck)
        drag = result.history()["DragX"]
        runs = [step for step in range(1, 9) if drag[step] != drag[step - 1]]
        found = self.flows_by_hand(result)
        self.assertEqual(runs, found)
        self.assertGreater(len(found), 2)
        self.assertLess(len(found), 8)

        changes = [abs(drag[k] - drag[j]) / max(abs(drag[k]), abs(drag[j])) for j, k in zip(found, found[1:-1])]
        line = self.lines(result, "was enough at the end")[0]
        self.assertAlmostEqual(float(line.split("up to")[1].split()[0]) / (100 * max(changes)), 1, delta=0.01)

        # It goes on from a checkpoint, and what counts from the last output does so.
        loss, rate = result.history()["Loss"], result.history()["Rate"]
        self.assertAlmostEqual(rate[8] / rate[4] / ((loss[8] - loss[7]) / (loss[4] - loss[3])), 1, delta=1e-9)
        fields = {label: result.field(label) for label in ("Damage", "Velocity")}
        later = self.solve(deck, arguments=["--restart", "early.checkpoint.h5"])
        for label, values in fields.items():
            np.testing.assert_array_equal(later.field(label), values)

        for value, message in (("Loose", '"Loose" of When/Value is no value for the whole body'),
                               ("DragX", '"DragX" of When/Value is a component; give the vector, "Drag"'),
                               ("Rate", '"Rate" of When/Value counts from what its compute found at earlier outputs')):
            when["Value"] = value
            refused = self.run_deck(deck, arguments=["--check"])
            self.assertNotEqual(refused.code, 0)
            self.assertIn("Staggered: Flow: " + message, refused.text)

    def test_the_factor_of_the_first_flow_does_for_all(self):
        # A thin wire of which half dissolves: the present equations are solved beside it before the old factor has its
        # turn, so that a step of Newton's method takes 1.6 iterations; by the old factor alone it takes 4.
        points = self.mesh()
        deck = self.deck(film="0.0")
        wire = np.hypot(points[:, 0], points[:, 1]) < 28e-6
        deck["Boundary Conditions"]["Wire Node Set"]["Expression"] = "x^2 + y^2 < (28e-6)^2"
        deck["Materials"]["Wire"]["Current Density"] = "8.0"
        deck["Solver"]["Staggered"]["Load Steps"] = 8
        deck["Solver"]["Staggered"]["Solvers"]["Flow"]["When"]["Has Changed By"] = 1e-10
        result = self.solve(deck)
        self.assertGreater(np.count_nonzero(wire & (result.field("Fluid") == 1)), 0.5 * np.count_nonzero(wire))
        words = self.lines(result, "iterations of GMRES")[0].split()
        newton, factors, iterations = (int(words[words.index(word) - 1]) for word in ("Newton", "factors", "iterations"))
        self.assertEqual(factors, 3)  # of the first flow from rest
        self.assertLess(iterations, 2.5 * newton)

    def test_boundaries_that_change_while_metal_dissolves(self):
        # What a flow keeps from the last one, rows, factor and all, makes no difference, whatever changes: the other run
        # forgets it, since it writes checkpoints.
        points = self.mesh()
        deck = self.deck(film="0.0")
        deck["Materials"]["Wire"]["Current Density"] = "25.0"
        deck["Output"]["Output Variables"].append("Pressure")
        conditions = deck["Boundary Conditions"]
        conditions["In"]["Velocity"][0] += "*(0.2 + t/14400)"
        conditions["Sides"]["Velocity"] = ["0.005*sin(t/5000)", 0.0]
        conditions["Out"]["Pressure"] = "t/28800"
        keeping = self.solve(deck)
        deck["Output2"] = {"Output Filename": "kept", "Checkpoint Frequency": 1, "Output Variables": ["Damage"]}
        forgetting = self.solve(deck)
        wire = np.hypot(points[:, 0], points[:, 1]) < self.RADIUS
        flowing = [np.count_nonzero(wire & (keeping.field("Fluid", step) == 1)) for step in (1, 2, 4)]
        self.assertTrue(flowing[0] < flowing[1] < flowing[2])
        for step in range(1, 5):
            for label in ("Velocity", "Pressure"):
                values = forgetting.field(label, step)
                np.testing.assert_allclose(keeping.field(label, step), values, atol=1e-7 * np.abs(values).max())

    def test_a_pocket_in_the_wire_opens(self):
        # Hollow: what is inside has no way out at first, is at rest and saturated, and flows when its shell is gone.
        points = self.mesh()
        deck = self.deck(film="0.0")
        deck["Boundary Conditions"]["Wire Node Set"]["Expression"] = (
            "x^2 + y^2 < (60e-6)^2 && x^2 + y^2 > (20e-6)^2")  # thicker than the horizon: bonds do not span the shell
        deck["Materials"]["Wire"]["Current Density"] = "25.0"
        deck["Solver"]["Staggered"]["Load Steps"] = 8
        result = self.solve(deck)
        inside = np.hypot(points[:, 0], points[:, 1]) < 20e-6
        self.assertLess(np.abs(result.field("Velocity", 1)[inside]).max(), 1e-12)
        np.testing.assert_allclose(result.field("Concentration", 1)[inside], 20.0, rtol=1e-6)
        self.assertGreater(np.abs(result.field("Velocity")[inside, 0]).min(), 1e-4)
        self.assertLess(result.field("Concentration")[inside].max(), 1.0)
        line = self.lines(result, "the balance is off by")[0]
        self.assertLess(float(line.split("off by")[1].split()[0]), 1e-12)

    def test_metal_is_kept_and_the_film_slows_its_loss(self):
        h = self.SPACING
        points = self.mesh()
        losses, velocities = [], []
        for ranks in (2, 1):
            deck = self.deck()
            if ranks == 2:  # flows forget what they keep from one to the next: operators, and their factor
                deck["Output2"] = {"Output Filename": "kept", "Checkpoint Frequency": 1, "Output Variables": ["Damage"]}
            result = self.solve(deck, ranks=ranks)
            velocities.append(result.field("Velocity"))
            self.assertLess(float(self.lines(result, "the balance is off by")[0].split("off by")[1].split()[0]), 1e-12)
            losses.append(result.history()["Loss"])
        one = losses[1]
        np.testing.assert_allclose(losses[0], one, rtol=1e-8)
        np.testing.assert_allclose(velocities[0], velocities[1], atol=1e-8 * np.abs(velocities[1]).max())
        # A round wire under i (1 - F), the film of the end of each step of up to 3600 s.
        n = np.count_nonzero(np.hypot(points[:, 0], points[:, 1]) < self.RADIUS)
        first = np.sqrt(n * h * h / np.pi)
        np.testing.assert_allclose(result.history()["Relative_Volume_Loss"], 100 * one / (n * h * h), rtol=1e-12)
        gone = 5.73 / (2 * 96485.33 * 71508.0) * (28800 - 3600 * (1 - np.exp(-8.0)))
        self.assertLess(abs(one[-1] / (np.pi * (first**2 - (first - gone)**2)) - 1), 0.08)
        # What has dissolved flows.
        turned = (result.field("Fluid") == 1) & (np.hypot(points[:, 0], points[:, 1]) < self.RADIUS)
        self.assertGreater(np.count_nonzero(turned), 0)
        self.assertGreater(np.min(np.abs(result.field("Velocity")[turned, 0])), 0.0)
        self.assertGreater(result.field("Concentration")[result.field("Fluid") == 1].min(), -1e-9)

    def test_a_wire_in_space_loses_what_its_section_does(self):
        # A quarter of a square duct. Above 2000 points in space nothing is factored: multigrid and incomplete factors
        # instead, by which flows are balanced and metal is kept as well.
        h, half = self.SPACING, 4.0 * self.SPACING
        section = self.mesh()
        deck = self.deck()
        deck["Solver"]["Final Time"], deck["Solver"]["Staggered"]["Load Steps"] = 3600.0, 1
        plane = self.solve(deck).history()["Loss"][-1]
        section = section[section[:, 1] > 0]
        points = np.vstack([section + [0.0, 0.0, (k + 0.5) * h] for k in range(8)])
        side, surface = f"y > {self.HALF} || z > {half}", f"min({self.HALF} - y, {half} - z)"
        self.write_mesh(points, h**3, block=np.where((points[:, 1] > self.HALF) | (points[:, 2] > half), 2, 1))
        for material in deck["Materials"].values():
            material.pop("Plane Strain", None)
        deck["Discretization"]["Symmetry"] = {
            name: {"Point": [0.0, 0.0, 0.0], "Normal": normal}
            for name, normal in (("Middle", [0.0, -1.0, 0.0]), ("Front", [0.0, 0.0, -1.0]))}
        conditions = deck["Boundary Conditions"]
        conditions["Wire Node Set"]["Expression"] += f" && z < {half}"
        conditions["Side Node Set"]["Expression"] = side
        conditions["In Node Set"]["Expression"] = f"x < -100e-6 && !({side})"
        conditions["End Node Set"]["Expression"] = f"x > 160e-6 && !({side})"
        conditions["Sides"]["Surface"] = surface
        conditions["In"]["Velocity"] = [f"0.02*(1 - (y/{self.HALF})^2)*(1 - (z/{half})^2)", 0.0, 0.0]
        deck["Solver"]["Staggered"]["Solvers"]["Flow"]["When"]["Has Changed By"] *= 0.5 * half
        losses, velocities = [], []
        for ranks in (1, 2):
            result = self.solve(deck, ranks=ranks)
            for words, before in (("the balance is off by", "off by"), ("flows of bonds are balanced", "balanced to")):
                line = self.lines(result, words)[0]
                self.assertLess(float(line.split(before)[1].split()[0]), 1e-12)
            losses.append(result.history()["Loss"][-1] / (half / 2))
            velocities.append(result.field("Velocity"))
        self.assertLess(abs(losses[0] / plane - 1), 0.03)
        self.assertLess(abs(losses[1] / losses[0] - 1), 1e-8)
        np.testing.assert_allclose(velocities[1], velocities[0], atol=1e-6 * np.abs(velocities[0]).max())

    def test_goes_on_from_a_checkpoint(self):
        self.mesh()
        deck = self.deck()
        self.end_after_two_steps(deck)
        deck["Materials"]["Ions"]["Scheme"] = "Limited"
        deck["Output2"] = {"Output Filename": "early", "Final Output Step": 1, "Checkpoint Frequency": 1,
                           "Output Variables": ["Damage"]}
        whole = self.solve(deck)
        fields = {label: whole.field(label) for label in ("Concentration", "Damage", "Velocity")}
        later = self.solve(deck, arguments=["--restart", "early.checkpoint.h5"])
        for label, values in fields.items():
            np.testing.assert_array_equal(later.field(label), values)

    def test_a_pin_that_dissolves_wholly_leaves_the_tube_empty(self):
        points = plane_lattice((-100e-6, -self.HALF), (160e-6, self.HALF), self.SPACING, (0.2, 0.5))
        self.write_mesh(points, self.SPACING**2, block=np.where(np.abs(points[:, 1]) > self.HALF, 2, 1))
        deck = self.deck(film="0.0")
        deck["Materials"]["Wire"]["Current Density"] = "40.0"
        result = self.solve(deck)
        wire = np.hypot(points[:, 0], points[:, 1]) < self.RADIUS
        self.assertTrue(np.all(result.field("Fluid")[wire] == 1))
        # The parabola is back, within what walls between the rows leave of it, and nothing is dissolved in it.
        np.testing.assert_allclose(result.field("Velocity")[wire, 0],
                                   0.02 * (1 - (points[wire, 1] / self.HALF)**2), rtol=1e-3)
        self.assertLess(result.field("Concentration")[wire].max(), 1e-6)
        self.assertLess(abs(result.history()["Loss"][-1] / (np.count_nonzero(wire) * self.SPACING**2) - 1), 1e-9)

    def test_what_is_no_share_is_refused(self):
        points = plane_lattice((-100e-6, -self.HALF), (160e-6, self.HALF), self.SPACING, (0.2, 0.5))
        self.write_mesh(points, self.SPACING**2, block=np.where(np.abs(points[:, 1]) > self.HALF, 2, 1))
        result = self.run_deck(self.deck(film="2.0"))
        self.assertNotEqual(result.code, 0)
        self.assertIn("a share lies between 0 and 1", result.text)


if __name__ == "__main__":
    unittest.main()
