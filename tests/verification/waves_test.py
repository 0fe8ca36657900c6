#!/usr/bin/python3
"""Waves: their speed in a bar and a plate, and the energy of free motion."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

E, DENSITY = 207.0e9, 7850.0


class Waves(SceneTest):
    def test_pulse_in_a_bar_travels_at_the_speed_of_sound(self):
        # d'Alembert: half the pulse goes each way at c = sqrt(E/rho). Its width of 10 horizons disperses by (delta/w)^2.
        spacing, area, speed = 1e-3, 1e-6, float(np.sqrt(E / DENSITY))
        horizon, width, length = 3.015e-3, 0.03, 0.6
        self.write_mesh(lattice([length], spacing), spacing * area)
        time = 0.15 / speed
        pulse = f"exp(-((x - 0.3 - SHIFT)/{width})^2)"
        exact = (f"0.5e-6*({pulse.replace('SHIFT', f'{speed!r}*t')} + "
                 f"{pulse.replace('- SHIFT', f'+ {speed!r}*t')})")
        deck = plate_deck(
            horizon, 1.0, {"Young's Modulus": E, "Poisson's Ratio": 0.25, "Density": DENSITY, "Plane Stress": False,
                           "One Dimensional": True, "Cross Section Area": area, "Lattice Rescaling": True},
            conditions={"All Node Set": {"Expression": "x > -1"},
                        "Pulse": {"Type": "Initial Displacement", "Node Set": "All Node Set", "Coordinate": "x",
                                  "Value": exact}},
            solver={"Final Time": float(time), "Verlet": {"Safety Factor": 0.5}},
            output={"Output Variables": ["Displacement"], "Output Frequency": 1000},
            Exact_Solution={"Pulse": {"Field": "Displacement", "Coordinate": "x", "Value": exact}})
        deck["Materials"]["Steel"].pop("Thickness")
        deck["Discretization"].pop("Thickness")
        deck["Discretization"]["Cross Section Area"] = area
        self.assertLess(self.solve(deck).error("L2"), 0.01)

    def test_energy_of_a_vibrating_plate_is_bounded(self):
        spacing, thickness = 1e-3, 1e-3
        self.write_mesh(lattice([0.03, 0.02], spacing), spacing**2 * thickness)
        deck = plate_deck(
            3.015e-3, thickness, {"Young's Modulus": E, "Poisson's Ratio": 0.29, "Density": DENSITY},
            conditions={"All Node Set": {"Expression": "x > -1"},
                        "Push": {"Type": "Initial Velocity", "Node Set": "All Node Set", "Coordinate": "x",
                                 "Value": "sin(200*x)"}},
            solver={"Final Time": 1e-4, "Verlet": {"Safety Factor": 0.5}},
            Compute_Class_Parameters={"K": {"Compute Class": "Global_Kinetic_Energy", "Output Label": "K"},
                                      "W": {"Compute Class": "Strain_Energy", "Output Label": "W"}},
            output={"Output Variables": ["K", "W"], "Output Frequency": 1000})
        history = self.solve(deck).history()
        total = history["K"] + history["W"]
        # Velocity Verlet's energy oscillates with the square of the step, and does not drift.
        self.assertLess(np.max(np.abs(total / total[0] - 1.0)), 0.02)
        half = len(total) // 2
        self.assertLess(abs(np.mean(total[half:]) / np.mean(total[1:half]) - 1.0), 1e-3)


if __name__ == "__main__":
    unittest.main()
