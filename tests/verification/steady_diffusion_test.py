#!/usr/bin/python3
"""The material Diffusion and the solver ImplicitDiffusion against exact solutions on cubic lattices."""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice  # noqa: E402

RATIO = 3.015  # horizon over spacing
COEFFICIENT = 2.5e-5  # m2/s


def lattice_diffusivity(ratio):
    """D of the infinite cubic lattice in parts of Coefficient: half the second moment of 6/(pi delta^4 |xi|)."""
    n = np.arange(-int(ratio), int(ratio) + 1)
    x, y, z = np.meshgrid(n, n, n)
    r = np.sqrt(x**2 + y**2 + z**2)
    isNeighbor = (r > 0) & (r <= ratio)
    return 0.5 * np.sum(6.0 / (np.pi * ratio**4 * r[isNeighbor]) * x[isNeighbor] ** 2)


class Diffusion(SceneTest):
    def deck(self, horizon, held, value, initial="0.0"):
        """Holds `value` where `held`, an expression, is true."""
        return {
            "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt", "Include Partial Neighbors": False},
            "Materials": {"Solid": {"Material Model": "Diffusion", "Coefficient": COEFFICIENT}},
            "Blocks": {"Body": {"Block Names": "block_1", "Material": "Solid", "Horizon": horizon}},
            "Boundary Conditions": {
                "All Node Set": {"Expression": "x > -1000"}, "Held Node Set": {"Expression": held},
                "Start": {"Type": "Initial Temperature", "Node Set": "All Node Set", "Value": initial},
                "Hold": {"Type": "Prescribed Temperature", "Node Set": "Held Node Set", "Value": value}},
            "Solver": {"Final Time": 1.0, "ImplicitDiffusion": {"Load Steps": 2, "Relative Tolerance": 1e-12}},
            "Output": {"Output Filename": "result", "Output Frequency": 1,
                       "Output Variables": ["Temperature", "Flux_Divergence"]}}

    def test_profile_between_held_ends_is_linear(self):
        # Exact, also at free faces: for each neighbour ahead there is one behind.
        points = lattice([0.3, 0.05, 0.06], 0.01)
        self.write_mesh(points, 0.01**3)
        value = "300 + t*(2 + 40*x)"
        result = self.solve(self.deck(RATIO * 0.01, "x < 0.031 || x > 0.269", value, initial="300"))
        for step, time in ((1, 0.5), (2, 1.0)):
            np.testing.assert_allclose(result.field("Temperature", step), 300 + time * (2 + 40 * points[:, 0]),
                                       rtol=1e-11)

    def test_harmonic_quadratic(self):
        # x^2 - 2 y^2 + z^2: the second moments of the lattice are the same along all axes.
        points = lattice([0.16, 0.12, 0.13], 0.01)
        self.write_mesh(points, 0.01**3)
        collar = "x < 0.04 || x > 0.12 || y < 0.04 || y > 0.08 || z < 0.04 || z > 0.09"
        result = self.solve(self.deck(RATIO * 0.01, collar, "100*(x^2 - 2*y^2 + z^2)"), ranks=2)
        x, y, z = points.T
        np.testing.assert_allclose(result.field("Temperature"), 100 * (x**2 - 2 * y**2 + z**2), atol=1e-10)

    def test_flux_converges_with_the_square_of_the_horizon(self):
        # Of cos(kx), all of it held: -D k^2 cos(kx) (1 - c (k delta)^2), D that of the lattice.
        k, errors = 2.0 * np.pi, []
        for n in (12, 24):  # points a wave length
            spacing = 1.0 / n
            points = lattice([2.0, 7 * spacing, 7 * spacing], spacing)
            self.write_mesh(points, spacing**3)
            result = self.solve(self.deck(RATIO * spacing, "x > -1000", f"cos({k!r}*x)"))
            expected = -COEFFICIENT * lattice_diffusivity(RATIO) * k**2 * np.cos(k * points[:, 0])
            hasAllNeighbors = np.all(np.abs(points - [1.0, 3.5 * spacing, 3.5 * spacing])
                                     < [0.6, 0.1 * spacing, 0.1 * spacing], axis=1)
            error = (result.field("Flux_Divergence") - expected)[hasAllNeighbors]
            errors.append(np.max(np.abs(error)) / np.max(np.abs(expected)))
        self.assertAlmostEqual(np.log2(errors[0] / errors[1]), 2.0, delta=0.1, msg=errors)
        self.assertLess(errors[1], 0.05)

    def test_fitted_weights_know_quadratic_fields_anywhere(self):
        # On an irregular mesh, faces, edges and corners included. The temperature is held: only its flux is looked at.
        points = lattice([0.1, 0.08, 0.07], 0.01)
        points += np.random.default_rng(2).uniform(-0.2, 0.2, points.shape) * 0.01
        self.write_mesh(points, 0.01**3)
        deck = self.deck(RATIO * 0.01, "x > -1000", "5 + x - 3*y + 100*(x^2 + 2*y^2 - z^2) + 50*x*y - 20*y*z")
        deck["Materials"]["Solid"]["Use Improved Quadrature"] = True
        flux = self.solve(deck).field("Flux_Divergence")
        np.testing.assert_allclose(flux, COEFFICIENT * 100 * (2 + 4 - 2), rtol=1e-9)
        deck["Materials"]["Solid"]["Use Improved Quadrature"] = False
        self.assertGreater(np.max(np.abs(self.solve(deck).field("Flux_Divergence") / COEFFICIENT - 400)), 400)


if __name__ == "__main__":
    unittest.main()
