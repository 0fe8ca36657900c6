#!/usr/bin/python3
"""Holes that grow and islands that shrink: their radius changes by i/(z F C_solid), as a plane front's place does."""
import os
import sys
import unittest

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "../support"))
from corrosion_scene import HORIZON, SPACING, STEEL, CorrosionTest, front_speed  # noqa: E402

# The ions are gone at once: the current alone sets the speed.
METAL = {**STEEL, "Diffusivity": 10.0 * STEEL["Diffusivity"]}
TURN = np.radians(20.0)
TURNED = np.array([[np.cos(TURN), np.sin(TURN), 0.0], [-np.sin(TURN), np.cos(TURN), 0.0], [0.0, 0.0, 1.0]])


def points(kind, dimension, radius):
    """Of a disc or ball about a place between points, a cell of each spacing^dimension."""
    count = np.arange(-int(2.0 * radius / SPACING), int(2.0 * radius / SPACING) + 1)
    x = np.stack(np.meshgrid(*[count] * dimension, indexing="ij"), axis=-1).reshape(-1, dimension).astype(float)
    if kind == "triangles":
        x = x @ np.array([[1.0, 0.0], [0.5, np.sqrt(0.75)]]) / 0.75**0.25
    x = np.hstack([x, np.zeros((len(x), 3 - dimension))])
    if kind == "turned":
        x = x @ TURNED
    x = SPACING * (x + np.array([0.2, 0.37, 0.11]) * (np.arange(3) < dimension))
    return x[np.sum(x * x, axis=1) < radius**2]


class RoundFronts(CorrosionTest):
    def check_speed(self, kind, dimension, first, last):
        """Mean speed of the front between two radii, at least two and a half horizons: within 2 % of the exact one."""
        grows = last > first
        self.x = points(kind, dimension, max(first, last) + 1.4 * HORIZON)
        self.volume = SPACING**dimension
        self.write_mesh(self.x, self.volume)
        square = "x*x + y*y + z*z"
        solid = f"{square} {'>' if grows else '<'} {first**2!r}"
        held = f"{square} < {(first - HORIZON)**2!r}" if grows else f"{square} > {(first + 0.75 * HORIZON)**2!r}"
        time = abs(last - first) / front_speed(METAL)
        history = self.corrode(dimension, METAL, solid, held, time, 4).history()
        measure = {2: np.pi, 3: 4.0 * np.pi / 3.0}[dimension]
        inside = np.sum(np.sum(self.x**2, axis=1) < first**2) * self.volume
        radius = ((inside + (1.0 if grows else -1.0) * history["Dissolved"]) / measure)**(1.0 / dimension)
        speed = abs(radius[-1] - radius[0]) / time / front_speed(METAL)
        self.assertAlmostEqual(speed, 1.0, delta=0.02, msg=f"{kind}, {dimension}D, {first} to {last}")

    def test_in_the_plane(self):
        for kind, first, last in (("square", 10e-6, 20e-6), ("turned", 20e-6, 10e-6), ("triangles", 10e-6, 16e-6)):
            self.check_speed(kind, 2, first, last)

    def test_in_space(self):
        self.check_speed("square", 3, 10e-6, 11e-6)


if __name__ == "__main__":
    unittest.main()
