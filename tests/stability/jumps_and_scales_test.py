#!/usr/bin/python3
"""Jumps of 1 : 1000 and of the horizon between blocks, and bodies of 1e-9 m and of 1e3 m."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

NEWTON = {"QuasiStatic": {"Relative Tolerance": 1e-10}}
RELAXATION = {"Adaptive Dynamic Relaxation": {"Relative Tolerance": 1e-8}}


def horizon_of(size):
    return 3.015 * size / 24


class JumpBetweenBlocks(SceneTest):
    """A strip whose right half is 1000 times softer, or lets 1000 times less through, than its left half."""

    length, width, spacing, thickness = 0.060, 0.012, 1e-3, 2e-3
    horizon = 3.015 * spacing

    def setUp(self):
        super().setUp()
        self.x = lattice([self.length, self.width], self.spacing)
        is_right = self.x[:, 0] > self.length / 2
        self.write_mesh(self.x, self.spacing**2 * self.thickness, 1 + is_right)

    def deck(self, left, right, conditions, solver, variables, **more):
        sets = {"Left Node Set": {"Expression": f"x < {self.horizon}"},
                "Right Node Set": {"Expression": f"x > {self.length - self.horizon}"}}
        deck = plate_deck(self.horizon, self.thickness, left, conditions={**sets, **conditions}, solver=solver,
                          output={"Output Variables": variables}, **more)
        deck["Materials"]["Other"] = {**deck["Materials"]["Steel"], **right}
        deck["Blocks"]["Other"] = {"Block Names": "block_2", "Material": "Other", "Horizon": self.horizon}
        return deck

    def slope(self, values, start, end):
        inner = (self.x[:, 0] > start * self.length) & (self.x[:, 0] < end * self.length)
        return np.polyfit(self.x[inner, 0], values[inner], 1)[0]

    def test_stress_is_that_of_springs_in_series(self):
        young, stretch = 200e9, 6e-5
        ends = {end + axis: {"Type": "Prescribed Displacement", "Node Set": end + " Node Set", "Coordinate": axis,
                             "Value": stretch if end + axis == "Rightx" else 0.0}
                for end in ("Left", "Right") for axis in "xy"}
        forces = {end: {"Compute Class": "Reaction_Force", "Node Set": end + " Node Set", "Output Label": end}
                  for end in ("Left", "Right")}
        for solver in (NEWTON, RELAXATION):
            deck = self.deck({"Young's Modulus": young, "Poisson's Ratio": 1 / 3}, {"Young's Modulus": young / 1000},
                             ends, solver, ["Displacement", "Left", "Right"], Compute_Class_Parameters=forces)
            result = self.solve(deck)
            last = {name: values[-1] for name, values in result.history().items()}
            left, right = (np.array([v for k, v in last.items() if k.startswith(end)]) for end in ("Left", "Right"))
            self.assertLess(np.max(np.abs(left + right)), 1e-6 * np.max(np.abs(right)))
            u = result.field("Displacement")[:, 0]
            stiff, soft = self.slope(u, 0.1, 0.4), self.slope(u, 0.6, 0.9)
            # The same stress in both: strains as 1 : 1000.
            self.assertAlmostEqual(soft / stiff / 1000.0, 1.0, delta=0.05)
            # Springs in series between the held layers; the bonds that cross the interface stiffen half a horizon of
            # the soft half, which is 6 % of it.
            free = self.length / 2 - self.horizon
            series = young * stretch / (free * (1.0 + 1000.0)) * self.width * self.thickness
            self.assertAlmostEqual(np.max(np.abs(right)) / series, 1.0, delta=0.12)

    def test_flux_is_that_of_resistances_in_series(self):
        fast, time = 1e-6, 40.0 * self.length**2 / 1e-9
        conditions = {"From": {"Type": "Prescribed Concentration", "Node Set": "Left Node Set", "Value": 1.0},
                      "To": {"Type": "Prescribed Concentration", "Node Set": "Right Node Set", "Value": 0.0}}
        deck = self.deck({"Diffusivity": fast}, {"Diffusivity": fast / 1000}, conditions,
                         {"Final Time": time, "Diffusion": {"Method": "TR-BDF2"}}, ["Concentration"])
        value = self.solve(deck).field("Concentration").ravel()
        self.assertGreater(np.min(value), -1e-6)
        self.assertLess(np.max(value), 1.0 + 1e-6)
        self.assertAlmostEqual(self.slope(value, 0.6, 0.9) / self.slope(value, 0.1, 0.4) / 1000.0, 1.0, delta=0.05)

    def test_mass_is_conserved_across_the_jump(self):
        conditions = {"Start": {"Type": "Initial Concentration", "Node Set": "Left Node Set", "Value": 1.0}}
        for method in ("Euler", "RKL", "TR-BDF2"):
            deck = self.deck({"Diffusivity": 1e-6}, {"Diffusivity": 1e-9}, conditions,
                             {"Final Time": 1000.0, "Diffusion": {"Method": method, "Load Steps": 4}},
                             ["Concentration", "Total"],
                             Compute_Class_Parameters={"Total": {"Compute Class": "Field_Integral",
                                                                 "Variable": "Concentration", "Output Label": "Total"}})
            total = self.solve(deck).history()["Total"]
            # Explicit: to round-off. Implicit: to the tolerance of its linear solver.
            self.assertLess(np.max(np.abs(total / total[0] - 1.0)), 1e-8 if method == "TR-BDF2" else 1e-12, method)


class JumpOfTheHorizon(SceneTest):
    """A free plate whose halves have different horizons, so that their lists of neighbours differ at the border."""

    def test_momentum_is_conserved_across_it(self):
        spacing, thickness = 1e-3, 2e-3
        x = lattice([0.040, 0.012], spacing)
        self.write_mesh(x, spacing**2 * thickness, 1 + (x[:, 0] > 0.020))
        for form, poissons_ratio in (("Objective", 0.2), ("Objective", 1 / 3), ("Linear", 0.2)):
            deck = plate_deck(
                3.015 * spacing, thickness,
                {"Young's Modulus": 200e9, "Poisson's Ratio": poissons_ratio, "Density": 7800.0,
                 "Tangential Force": form},
                conditions={"All Node Set": {"Expression": "x > -1"},
                            "Start": {"Type": "Initial Velocity", "Node Set": "All Node Set", "Coordinate": "x",
                                      "Value": "20*sin(150*x)"}},
                solver={"Final Time": 2e-5, "Verlet": {}},
                output={"Output Variables": ["Velocity"], "Output Frequency": 1000})
            deck["Blocks"]["Other"] = {"Block Names": "block_2", "Material": "Steel", "Horizon": 4.015 * spacing}
            expected = None
            for ranks in (1, 2):
                result = self.solve(deck, ranks=ranks)
                start, end = result.field("Velocity", 0), result.field("Velocity")
                self.assertGreater(np.max(np.abs(end - start)), 10.0)  # waves have crossed the border
                change = np.max(np.abs(np.sum(end - start, axis=0))) / np.sum(np.abs(start))
                self.assertLess(change, 1e-11, f"{form}, {poissons_ratio}, {ranks} ranks")
                if expected is not None:
                    self.assertLess(np.max(np.abs(end - expected)), 1e-10 * np.max(np.abs(expected)))
                expected = end


class Scales(SceneTest):
    """All lengths times L: displacements / L, damage and concentrations must be the same."""

    def body(self, size, solver, fields, time=1.0, damage=None, material=None):
        spacing = size / 24
        horizon, thickness = horizon_of(size), 0.05 * size
        self.write_mesh(lattice([size, size / 2], spacing), spacing**2 * thickness)
        layer = 3 * spacing
        deck = plate_deck(
            horizon, thickness, {"Young's Modulus": 200e9, "Poisson's Ratio": 0.3, "Density": 8000.0,
                                 "Diffusivity": 1e-9, **(material or {})}, damage,
            {"Left Node Set": {"Expression": f"x < {layer!r}"},
             "Right Node Set": {"Expression": f"x > {size - layer!r}"},
             "Hold": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": "x", "Value": 0.0},
             "Pull": {"Type": "Prescribed Displacement", "Node Set": "Right Node Set", "Coordinate": "x",
                      "Value": f"{2e-3 * size!r}*min(1, 2*t/{time!r})*(1 + y/{size!r})"},
             "Fill": {"Type": "Prescribed Concentration", "Node Set": "Left Node Set", "Value": 1.0}},
            {"Final Time": time, **solver}, {"Output Variables": fields})
        if not any(name in solver for name in ("Diffusion", "Staggered")):
            for name in ("Diffusivity",):
                del deck["Materials"]["Steel"][name]
            del deck["Boundary Conditions"]["Fill"]
        result = self.solve(deck)
        return {label: result.field(label) / (size if label == "Displacement" else 1.0) for label in fields}

    def compare(self, solver, fields, time=lambda size: 1.0, **options):
        expected = None
        for size in (1.0, 1e-9, 1e3):
            more = {key: value(size) for key, value in options.items()}
            found = self.body(size, solver(size), fields, time(size), **more)
            if expected is None:
                expected = found
                continue
            for label in fields:
                if label == "Damage":
                    np.testing.assert_array_equal(found[label], expected[label])
                    continue
                difference = np.max(np.abs(found[label] - expected[label])) / np.max(np.abs(expected[label]))
                self.assertLess(difference, 1e-9, f"{label} of a plate of {size} m")
        return expected

    def test_static_plate(self):
        self.compare(lambda size: {"QuasiStatic": {"Relative Tolerance": 1e-12}}, ["Displacement"])

    def test_relaxed_plate(self):
        self.compare(lambda size: {"Adaptive Dynamic Relaxation": {"Iterations Per Load Step": 200}}, ["Displacement"])

    def test_breaking_plate(self):
        # The fracture energy grows with the size: the critical stretch is the same.
        damage = lambda size: {"Damage Model": "Critical Stretch", "Fracture Energy": 3e5 * size,  # noqa: E731
                               "Young's Modulus": 200e9, "Poisson's Ratio": 0.3, "Plane Stress": True,
                               "Horizon": horizon_of(size)}
        found = self.compare(lambda size: {"Adaptive Dynamic Relaxation": {"Load Steps": 60,
                                                                           "Iterations Per Load Step": 5}},
                             ["Displacement", "Damage"], damage=damage)
        self.assertGreater(np.max(found["Damage"]), 0.1)

    def test_moving_plate(self):
        self.compare(lambda size: {"Verlet": {}}, ["Displacement"], lambda size: 1e-3 * size)

    def test_diffusion(self):
        for method in ({"Method": "Euler"}, {"Method": "RKL", "Relative Tolerance": 1e-4}, {"Method": "TR-BDF2"}):
            self.compare(lambda size: {"Diffusion": method}, ["Concentration"], lambda size: 1e7 * size**2)


if __name__ == "__main__":
    unittest.main()
