#!/usr/bin/python3
"""A pit under a cover with one hole: the current sets its speed at first, then diffusion through the hole."""
import os
import sys
import unittest

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, "../support"), os.path.join(here, "../../decks/pitting")]
from corrosion_scene import HORIZON, SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402
from quasi_steady import CoveredPit  # noqa: E402
from scene import lattice  # noqa: E402

HOLE, COVER, HALF, DEPTH = 10e-6, 4e-6, 48e-6, 44e-6
CURRENT = 5.0 * float(STEEL["Current Density"])  # salt comes five times earlier than with the scene's


def model():
    return CoveredPit(HOLE, COVER, STEEL["Diffusivity"], STEEL["Solid Concentration"], STEEL["Saturation Concentration"],
                      CURRENT, STEEL["Charge Number"])


class QuasiSteadyModel(unittest.TestCase):
    def test_keeps_to_faraday_before_salt_and_to_the_flux_afterwards(self):
        pit = model()
        onset = pit.transition()
        times = np.array([0.2, 0.9]) * onset / pit.speed
        np.testing.assert_allclose(pit.depths(times), pit.speed * times, rtol=1e-9)
        # What diffusion then takes away, over the metal that it comes from, but for the little that the pit keeps.
        depth = 4.0 * onset
        flux = pit.diffusivity * pit.saturation / pit.resistance(depth) / pit.wall(depth)
        self.assertAlmostEqual(pit.rate(depth) * (pit.solid - pit.saturation) / flux, 1.0, delta=0.01)


class CoveredHole(CorrosionTest):
    def test_depth_is_linear_in_time_then_nearly_as_its_root(self):
        self.x = lattice([2.0 * HALF, DEPTH + COVER + HORIZON], SPACING, [-HALF, -DEPTH])
        self.volume = SPACING**2
        x, y = self.x[:, 0], self.x[:, 1]
        isCover = (y > 0) & (y < COVER) & (np.abs(x) > 0.5 * HOLE)
        self.write_mesh(self.x, self.volume, np.where(isCover, 2, 1))
        metal = {**STEEL, "Current Density": str(CURRENT), "Phase Blocks": ["block_2"], "Phase Current Densities": ["0.0"]}
        solid = f"y < 0 || (y < {COVER!r} && (x < {-0.5 * HOLE!r} || x > {0.5 * HOLE!r}))"
        deck = corrosion_deck(2, metal, solid, f"y > {COVER!r}", 100.0, 50)
        deck["Blocks"]["Body"]["Block Names"] = "block_1 block_2"
        deck["Boundary Conditions"]["Surface Node Set"] = {"Expression": f"y < 0 && y > {-SPACING!r}"}
        deck["Compute Class Parameters"]["Deepest"] = {"Compute Class": "Maximum_Depth", "Node Set": "Surface Node Set",
                                                       "Into Y": -1.0, "Measure": "Deepest"}
        deck["Output"]["Output Frequency"] = 25
        result = self.solve(deck)
        self.check(result, metal)
        cover = result.field("Damage")[isCover]
        self.assertLess(np.max(cover), 1e-5)

        history, pit = result.history(), model()
        t, depth = history["time"][1:], history["Maximum_Depth"][1:]
        # Exact would be 1 and, for a hole that is a line and resists as much at any depth, 1/2.
        early, late = t < 0.9 * pit.transition() / pit.speed, depth > 2.0 * pit.transition()
        self.assertGreater(t[late][-1], 3.0 * t[late][0])
        linear, root = (np.polyfit(np.log(t[part]), np.log(depth[part]), 1)[0] for part in (early, late))
        self.assertAlmostEqual(linear, 1.0, delta=0.03)
        self.assertAlmostEqual(root, 0.5, delta=0.03)
        # The hole is two and a half horizons wide; the model takes the pit for a half circle about it, all salt at once.
        np.testing.assert_allclose(depth[early], front_speed(metal) * t[early], rtol=0.04)
        np.testing.assert_allclose(depth[late], pit.depths(t[late]), rtol=0.08)


if __name__ == "__main__":
    unittest.main()
