#!/usr/bin/python3
"""Fronts of 2.5 horizons of radius and more, hollow and bulging, in the plane and in space, against Faraday's law."""
import os
import sys
import unittest
from math import pi

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "../support"))
from corrosion_scene import HORIZON, SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402


def rotation(*degrees):
    """About z, then about x."""
    turn = np.eye(3)
    for axis, angle in zip((2, 0), np.radians(degrees)):
        a, b = (axis + 1) % 3, (axis + 2) % 3
        once = np.eye(3)
        once[a, a] = once[b, b] = np.cos(angle)
        once[a, b], once[b, a] = -np.sin(angle), np.sin(angle)
        turn = once @ turn
    return turn


def grid(dimension, reach, *degrees):
    """Points of a grid of unit spacing that has no point at the centre, turned about it."""
    n = int(1.8 * reach) + 2
    axes = np.meshgrid(*[np.arange(-n, n) + 0.5] * dimension)
    x = np.zeros((axes[0].size, 3))
    for d, values in enumerate(axes):
        x[:, d] = values.ravel()
    return x @ rotation(*degrees).T


def triangles(reach):
    """Points of equilateral triangles whose cells have the area 1."""
    n, side = 2 * int(reach), np.sqrt(2.0 / np.sqrt(3.0))
    i, j = np.meshgrid(np.arange(-n, n), np.arange(-n, n))
    return side * np.column_stack([(i + 0.5 * (j % 2) + 0.13).ravel(), (0.5 * np.sqrt(3.0) * j + 0.07).ravel(),
                                   np.zeros(i.size)])


class RoundFronts(CorrosionTest):
    def check_loss(self, x, dimension, start, end, horizon, tolerance):
        """Of a hole whose radius grows from `start` to `end`, or a pillar or ball that shrinks; lengths in spacings."""
        reach, grows = max(start, end) + 2.5 * horizon, end > start
        x = x[np.linalg.norm(x, axis=1) < reach]
        r, content = np.linalg.norm(x, axis=1), (1.0, 2.0, pi, 4.0 * pi / 3.0)[dimension]
        self.write_mesh(x * SPACING, SPACING**dimension)
        square, sea = "x*x + y*y + z*z", start - 2 if grows else start + 2
        ahead, behind = (">", "<") if grows else ("<", ">")
        deck = corrosion_deck(dimension, STEEL, f"{square} {ahead} {(start * SPACING)**2!r}",
                              f"{square} {behind} {(sea * SPACING)**2!r}",
                              abs(end - start) * SPACING / front_speed(STEEL), 4)
        deck["Blocks"]["Body"]["Horizon"] = horizon * SPACING
        result = self.solve(deck)
        self.check(result, STEEL)
        # Whole points make the front of the start.
        radius = (np.sum(r < start) / content)**(1.0 / dimension)
        was_solid = r > start if grows else r < start
        given = STEEL["Solid Concentration"] - STEEL["Saturation Concentration"]
        errors = []
        for step, time in zip(result.steps(), result.history()["time"]):
            if step == 0:
                continue
            gone = np.where(result.field("Damage", step) >= 1.0, 1.0,
                            (STEEL["Solid Concentration"] - result.field("Concentration", step)) / given)
            way = front_speed(STEEL) * time / SPACING * (1.0 if grows else -1.0)
            faraday = content * abs((radius + way)**dimension - radius**dimension)
            errors.append(np.sum(gone[was_solid]) / faraday - 1.0)
        print(dimension, start, end, len(x), np.round(errors, 4), file=sys.stderr)
        self.assertLess(np.max(np.abs(errors)), tolerance, errors)

    def test_holes_and_pillars(self):
        for x in (grid(2, 32), grid(2, 32, 20.0), triangles(32)):
            for start, end in ((10.0, 20.0), (20.0, 10.0)):
                self.check_loss(x, 2, start, end, 4.0, 0.02)

    def test_holes_and_balls(self):
        for x in (grid(3, 17), grid(3, 17, 20.0, 30.0)):
            for start, end in ((7.5, 9.5), (9.5, 7.5)):
                self.check_loss(x, 3, start, end, 3.0, 0.02)


if __name__ == "__main__":
    unittest.main()
