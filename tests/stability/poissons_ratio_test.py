#!/usr/bin/python3
"""Poisson's ratio up to the edge of stability of the lattice: negative tangential bond stiffness k_t."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

YOUNG, DENSITY, SPACING, THICKNESS = 200e9, 8000.0, 1e-3, 2e-3
HORIZON = 3.0 * SPACING


class PoissonsRatio(SceneTest):
    def body(self, counts, material):
        """A lattice of so many points, and a deck without conditions and solver."""
        points = lattice([n * SPACING for n in counts], SPACING)
        is_solid = len(counts) == 3
        self.write_mesh(points, SPACING**3 if is_solid else SPACING**2 * THICKNESS)
        deck = plate_deck(HORIZON, THICKNESS, {"Young's Modulus": YOUNG, "Density": DENSITY, **material})
        steel = deck["Materials"]["Steel"]
        if is_solid:
            del deck["Discretization"]["Thickness"], steel["Thickness"]
        if is_solid or "Plane Strain" in material:
            del steel["Plane Stress"]
        return points, deck

    def pull(self, material, plane_ratio):
        """A strip whose ends follow u = 1e-4 x: its Poisson's ratio in the plane, and what the run said."""
        counts = [30, 16]
        points, deck = self.body(counts, material)
        length = counts[0] * SPACING
        deck["Boundary Conditions"] = {
            "Ends Node Set": {"Expression": f"x < {HORIZON} || x > {length - HORIZON}"},
            "Foot Node Set": {"Expression": f"x < {HORIZON} && y < {SPACING}"},
            "Pull": {"Type": "Prescribed Displacement", "Node Set": "Ends Node Set", "Coordinate": "x",
                     "Value": "1e-4*x"},
            "Hold": {"Type": "Prescribed Displacement", "Node Set": "Foot Node Set", "Coordinate": "y", "Value": 0.0}}
        deck["Solver"] = {"Final Time": 1.0, "QuasiStatic": {"Relative Tolerance": 1e-8}}
        deck["Output"] = {"Output Filename": "result", "Output Variables": ["Displacement"], "Output Frequency": 1}
        result = self.solve(deck)
        u = result.field("Displacement")
        inner = np.abs(points[:, 0] - length / 2) < length / 4
        stretch = np.polyfit(points[inner, 0], u[inner, 0], 1)[0]
        shrink = np.polyfit(points[inner, 1], u[inner, 1], 1)[0]
        # Free edges (width 5 horizons) and the lattice change the ratio by some percent.
        self.assertAlmostEqual(-shrink / stretch, plane_ratio, delta=0.05)
        return result.text

    def refuse(self, counts, material):
        _, deck = self.body(counts, material)
        deck["Solver"] = {"Final Time": 1e-7, "Verlet": {"Fixed dt": 1e-7}}
        deck["Output"]["Output Variables"] = ["Displacement"]
        result = self.run_deck(deck)
        self.assertEqual(result.code, 2, result.text)
        self.assertRegex(result.text, "Poisson's ratio .* lattice unstable .* use a smaller Poisson's ratio")

    def shake(self, counts, material):
        """Energies after a kick that holds all frequencies, 1000 steps, relative to those of the kick. Where no motion
        has a negative stiffness, velocity Verlet keeps the kinetic energy below E0 / (1 - (dt/limit)^2)."""
        _, deck = self.body(counts, material)
        deck["Boundary Conditions"] = {"All Node Set": {"Expression": "x > -1"}}
        for number, axis in enumerate("xyz"[: len(counts)]):
            deck["Boundary Conditions"]["Kick " + axis] = {
                "Type": "Initial Velocity", "Node Set": "All Node Set", "Coordinate": axis,
                "Value": f"1e-6*sin(1e6*x*(1 + 0.3*{number}) + 2.7e6*y + 3.9e6*z + {number})"}
        deck["Solver"] = {"Final Time": 1e-4, "Verlet": {"Fixed dt": 1e-7}}
        deck["Compute Class Parameters"] = {
            name: {"Compute Class": name, "Output Label": name} for name in ("Strain_Energy", "Global_Kinetic_Energy")}
        deck["Output"].update({"Output Variables": ["Strain_Energy", "Global_Kinetic_Energy"], "Output Frequency": -1})
        result = self.solve(deck)
        history = result.history()
        start = history["Global_Kinetic_Energy"][0]
        return history["Global_Kinetic_Energy"] / start, history["Strain_Energy"] / start, result

    def test_plane_stress_up_to_one_half(self):
        for ratio in (1 / 3, 0.4, 0.49):
            text = self.pull({"Poisson's Ratio": ratio}, ratio)
            if ratio > 1 / 3:
                self.assertRegex(text, "warning: Poisson's ratio .* negative .* the lattice is stable")
            else:
                self.assertNotIn("warning", text)

    def test_plane_strain_up_to_the_edge(self):
        # Ratio in the plane: nu / (1 - nu).
        for ratio in (0.3, 0.34):
            text = self.pull({"Plane Strain": True, "Poisson's Ratio": ratio}, ratio / (1.0 - ratio))
            self.assertRegex(text, "warning: Poisson's ratio .* negative .* the lattice is stable")

    def test_beyond_the_edge_of_the_lattice_is_refused(self):
        self.refuse([12, 12], {"Plane Strain": True, "Poisson's Ratio": 0.4})
        self.refuse([8, 8, 8], {"Poisson's Ratio": 0.4})
        self.refuse([12, 12], {"Poisson's Ratio": 0.499, "Tangential Force": "Linear"})

    def test_free_bodies_below_the_edge_gain_no_energy(self):
        for counts, material in [([12, 12], {"Poisson's Ratio": 0.49}),
                                 ([12, 12], {"Poisson's Ratio": 0.34, "Plane Strain": True}),
                                 ([6, 6, 6], {"Poisson's Ratio": 0.33})]:
            kinetic, strain, _ = self.shake(counts, material)
            self.assertLess(np.max(kinetic), 1.15, material)  # dt is below 0.35 of the limit
            # In units of the kinetic energy at first; sums of 1e2 to 1e3 bond energies of a body at rest round to 1e-13.
            self.assertGreater(np.min(strain), -1e-12, material)

    def test_body_whose_edges_are_unstable_is_reported(self):
        # The lattice is stable, a free body of it is not: the smallest eigenvalue of its dense stiffness matrix is
        # -0.050 (plate), -0.0041 (cube) and -0.052 (cube; the linear form resists rigid rotation, negatively here) of
        # the largest, and 0 (rigid motions) in the last two bodies.
        for counts, material in [([12, 12], {"Poisson's Ratio": 0.36, "Plane Strain": True}),
                                 ([6, 6, 6], {"Poisson's Ratio": 0.34}),
                                 ([6, 6, 6], {"Poisson's Ratio": 0.29, "Tangential Force": "Linear"})]:
            kinetic, _, result = self.shake(counts, material)
            self.assertGreater(np.max(kinetic), 2.0, material)
            self.assertRegex("\n".join(result.report["solver"]), "warning: the body is unstable as it starts")
        for counts, material in [([12, 12], {"Poisson's Ratio": 0.34, "Plane Strain": True}),
                                 ([6, 6, 6], {"Poisson's Ratio": 0.33})]:
            self.assertNotIn("unstable", "\n".join(self.shake(counts, material)[2].report["solver"]))


if __name__ == "__main__":
    unittest.main()
