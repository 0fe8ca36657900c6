#!/usr/bin/python3
"""Diffusion with horizons of any shape, and along thin gaps: how fast a cosine decays."""
import os
import sys
import unittest
from math import cos, pi, radians, sin

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from corrosion_scene import corrosion_deck  # noqa: E402
from scene import SceneTest  # noqa: E402

D = 1e-9
IONS = {"Diffusivity": D, "Solid Concentration": 1e5, "Saturation Concentration": 1e3, "Charge Number": 2.0,
        "Current Density": "1e-20"}
SHORT = 1e-6  # spacing along y, m; horizons are four spacings long either way
WALL = 6      # spacings of solid on either side of a gap


class Diffusion(SceneTest):
    def effective(self, ratio, columns, rows, along, degrees=0.0, is_gap=False, shape="Ellipsoid"):
        """D_eff/D of a grid with spacings ratio : 1, turned, from the decay of the longest cosine along x or y."""
        wall = WALL if is_gap else 0
        x, y = np.meshgrid(ratio * SHORT * (np.arange(columns) + 0.5), SHORT * (np.arange(rows + 2 * wall) - wall + 0.5))
        x, y = x.ravel(), y.ravel()
        c, s = cos(radians(degrees)), sin(radians(degrees))
        self.write_mesh(np.column_stack([c * x - s * y, s * x + c * y, 0.0 * x]), ratio * SHORT**2)
        first, second = f"({c!r}*x + {s!r}*y)", f"({c!r}*y - {s!r}*x)"
        liquid = f"{second} > 0.0 && {second} < {rows * SHORT!r}"
        place, text, length = (x, first, ratio * SHORT * columns) if along == "x" else (y, second, SHORT * rows)

        metal = dict(IONS)
        if (ratio, degrees, shape) != (1, 0.0, "Ellipsoid"):
            metal.update({"Horizon Axes": [4.0 * ratio * SHORT, 4.0 * SHORT], "Horizon Rotation": [degrees],
                          "Horizon Shape": shape})
        decay = D * (pi / length) ** 2
        h, n = 0.05 / decay, 3
        deck = corrosion_deck(2, metal, f"{second} < 0.0 || {second} > {rows * SHORT!r}", "", n * h, n,
                              **{"Fixed dt": h})
        deck["Blocks"]["Body"]["Horizon"] = 4.0 * ratio * SHORT
        conditions = deck["Boundary Conditions"]
        conditions["Electrolyte Node Set"] = {"Expression": liquid}
        conditions["Ions"] = {"Type": "Initial Concentration", "Node Set": "Electrolyte Node Set",
                              "Value": f"500.0 + 100.0*cos({pi / length!r}*{text})"}
        if not is_gap:
            del conditions["Metal"], conditions["Metal Node Set"]
            deck["Compute Class Parameters"]["Dissolved"]["Node Set"] = "Electrolyte Node Set"
        result = self.solve(deck)
        inside = (y > 0.0) & (y < rows * SHORT)
        amplitude = [np.sum(((result.field("Concentration", k) - 500.0) * np.cos(pi * place / length))[inside])
                     for k in (0, n)]
        return ((amplitude[0] / amplitude[1]) ** (1.0 / n) - 1.0) / (h * decay)  # of backward Euler

    def test_is_the_same_in_all_directions(self):
        for ratio in (1, 5, 25):
            for shape in ("Ellipsoid", "Box"):
                for along, columns, rows in (("x", 120, 12), ("y", 12, 120)):
                    found = self.effective(ratio, columns, rows, along, shape=shape)
                    self.assertAlmostEqual(found, 1.0, delta=1e-3, msg=f"{ratio}, {shape}, {along}")
            # The axes of the horizon turned with the grid.
            self.assertAlmostEqual(self.effective(ratio, 120, 12, "x", 45.0), 1.0, delta=1e-3, msg=f"{ratio}, 45")

    def test_thin_gaps_lose_nothing(self):
        # Without correction a gap keeps 0.72, 0.86, 0.94 of D at 1, 2, 5 horizons of height.
        for ratio, degrees in ((1, 0.0), (1, 30.0), (25, 0.0)):
            for rows in (1, 4, 8, 20):
                found = self.effective(ratio, 120, rows, "x", degrees, is_gap=True)
                self.assertAlmostEqual(found, 1.0, delta=1e-3, msg=f"{ratio}, {degrees}, {rows} rows")


if __name__ == "__main__":
    unittest.main()
