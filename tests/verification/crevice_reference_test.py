#!/usr/bin/python3
"""The two models of the crevice that runs of the library are compared with, against exact solutions and each other."""
import os
import sys
import unittest
from dataclasses import replace

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "../../decks/crevice"))
from gap_averaged import FARADAY, HOUR, Crevice, alloy_625, least_factor, simulate  # noqa: E402
from trench import MappedGrid, State, Stepper, carve  # noqa: E402


def constant_current(current):
    return lambda c: (np.full_like(c, current), np.zeros_like(c))


# Straight, and of a metal so dense that the walls stay where they are. 1e-6 mol/m2/s leave each wall.
FLUX, GAP, LENGTH, DIFFUSIVITY = 1e-6, 20e-6, 2e-3, 1e-9
STRAIGHT = Crevice(length=LENGTH, mouthGap=GAP, endGap=GAP, diffusivity=DIFFUSIVITY, saturation=1e4, solid=1e12,
                   charge=1.0, ignition=0.0, current=constant_current(FLUX * FARADAY))


def modes(count=400):
    """Wave numbers of what is 0 at the mouth and flat at the closed end."""
    return (np.arange(count) + 0.5) * np.pi / LENGTH


def orders(errors):
    return np.log2(np.array(errors[:-1]) / np.array(errors[1:]))


class Diffusion(unittest.TestCase):
    def test_slab_spreads_as_its_fourier_series(self):
        # A slab at the closed end, no dissolution. Second order in space and in time.
        slab = replace(STRAIGHT, ignition=0.5e-3, saturation=1000.0, ignitionShare=0.5, current=constant_current(0.0))
        k, t = modes(), 200.0

        def exact(x):
            amplitude = 2.0 / LENGTH * np.sin(k * LENGTH) * np.sin(k * slab.ignition) / k * 500.0
            return np.sin(np.outer(x, k)) @ (amplitude * np.exp(-DIFFUSIVITY * k**2 * t))

        def error(cells, step):
            result = simulate(slab, t, cells, fixedStep=step, snapshots=1)
            return np.max(np.abs(result.concentration[-1] - exact(result.x))) / 500.0

        inSpace = [error(cells, 1.0) for cells in (20, 40, 80)]
        inTime = [error(2000, step) for step in (40.0, 20.0, 10.0)]
        self.assertGreater(np.min(orders(inSpace)), 1.9, inSpace)
        self.assertGreater(np.min(orders(inTime)), 1.9, inTime)
        self.assertLess(error(160, 1.0), 1e-4)

    def test_steady_wedge(self):
        # All that the walls beyond x give passes x: h D dC/dx = q (L - x), with h = a - b x.
        wedge = replace(STRAIGHT, mouthGap=50e-6, endGap=10e-6)
        a, b = 25e-6, 20e-6 / LENGTH
        result = simulate(wedge, 1e6, 400, snapshots=1)
        exact = FLUX / (DIFFUSIVITY * b) * (result.x + (LENGTH - a / b) * np.log(a / (a - b * result.x)))
        np.testing.assert_allclose(result.concentration[-1], exact, atol=1e-5 * exact[-1])
        self.assertAlmostEqual(result.total[-1], FLUX * FARADAY * LENGTH, delta=1e-9 * FLUX * FARADAY * LENGTH)


class Saturation(unittest.TestCase):
    def test_closed_end_saturates_at_its_time(self):
        # C(L, t) under a constant current, by the series; saturation is what it comes to at 600 s.
        k = modes()
        steady = FLUX * LENGTH**2 / (GAP * DIFFUSIVITY)  # q L^2/(2 h D), h the half gap
        amplitude = 2.0 / LENGTH * 2.0 * FLUX / (GAP * DIFFUSIVITY * k**3)
        saturation = steady - np.sum(amplitude * np.exp(-DIFFUSIVITY * k**2 * 600.0) * np.sin(k * LENGTH))
        self.assertLess(saturation, 0.9 * steady)
        result = simulate(replace(STRAIGHT, saturation=saturation), 700.0, 400, tolerance=1e-5, snapshots=1)
        total = np.array(result.total) / (FLUX * FARADAY * LENGTH)
        covered = np.argmax(total < 1.0 - 1e-6)
        self.assertGreater(covered, 0)
        self.assertAlmostEqual(result.time[covered], 600.0, delta=5.0)
        self.assertLess(result.time[covered - 1], 601.0)

    def test_attack_keeps_to_where_diffusion_takes_the_metal_away(self):
        # Bare up to X, saturated and flat beyond: C_sat = q X^2/(2 h D).
        place = 0.6 * LENGTH
        # That rises a little with C, so that it is highest at the edge.
        limited = replace(STRAIGHT, saturation=FLUX * place**2 / (GAP * DIFFUSIVITY),
                          current=lambda c: (FLUX * FARADAY * (1.0 + 1e-9 * c), np.full_like(c, 1e-9 * FLUX * FARADAY)))
        result = simulate(limited, 1e5, 200, snapshots=1)
        self.assertAlmostEqual(result.site[-1], place, delta=1e-3 * LENGTH)
        self.assertAlmostEqual(result.total[-1], FLUX * FARADAY * place, delta=1e-3 * FLUX * FARADAY * LENGTH)
        x, h = result.x, 0.5 * GAP
        exact = np.where(x < place, FLUX / (h * DIFFUSIVITY) * (place * x - 0.5 * x**2), limited.saturation)
        np.testing.assert_allclose(result.concentration[-1], exact, atol=1e-4 * limited.saturation)

    def test_still_electrolyte_dissolves_until_it_is_full(self):
        # Far from the mouth h C = h0 C0 + C_solid s, up to C_sat; walls that move, at a speed that does not depend on C.
        p = Crevice(mouthGap=20e-6, endGap=20e-6, ignition=12.7e-3, ignitionShare=0.5, current=constant_current(10.0))
        h, c0 = 10e-6, 0.5 * p.saturation
        speed, full = 10.0 / (p.charge * FARADAY * p.solid), h * (p.saturation - c0) / (p.solid - p.saturation)
        end = 2.0 * full / speed
        result = simulate(p, end, 200, snapshots=8)
        s = np.minimum(speed * result.times, full)
        np.testing.assert_allclose(result.depth[:, -1], s, rtol=1e-9, atol=1e-15)
        np.testing.assert_allclose(result.concentration[:, -1], (h * c0 + p.solid * s) / (h + s), rtol=1e-9)


class Alloy625(unittest.TestCase):
    def test_current_density(self):
        # pH and log10 i by hand from the two formulas.
        for c, ph, power in ((0.0, 0.907, -7.050), (3000.0, -0.679, -5.766), (5600.0, -1.776, -3.489)):
            i, slope = alloy_625(1.0)(np.array(c))
            self.assertAlmostEqual(np.log10(i / 1e4), power, delta=2e-3)
            self.assertAlmostEqual(1.151 * np.exp(-0.723 * ph) - 7.647, power, delta=2e-3)
            nearby = alloy_625(1.0)(np.array([c - 0.1, c + 0.1]))[0]
            self.assertAlmostEqual(slope / ((nearby[1] - nearby[0]) / 0.2), 1.0, delta=1e-6)

    def test_attack_dies_with_the_printed_rates(self):
        result = simulate(Crevice(factor=1.0), cells=508, snapshots=12)
        self.assertFalse(result.is_alive())
        self.assertLess(result.trench[0], 0.1e-6)
        self.assertLess(result.peak[-1], 2e-3)
        self.assertLess(result.massError, 1e-10)

    def test_attack_lives_with_fifteen_times_the_rates(self):
        found = []
        for cells, tolerance in ((508, 3e-3), (1016, 1e-3)):
            result = simulate(Crevice(), cells=cells, tolerance=tolerance)
            self.assertTrue(result.is_alive())
            self.assertLess(result.massError, 1e-10)
            saturation = result.crevice.saturation
            fastest = result.crevice.speed(saturation)[0]
            self.assertLessEqual(np.max(result.depth - fastest * result.times[:, None]), 1e-15)
            self.assertGreaterEqual(np.min(np.diff(result.depth, axis=0)), -1e-15)
            self.assertGreaterEqual(np.min(result.concentration), 0.0)
            self.assertLessEqual(np.max(result.concentration), saturation * (1.0 + 1e-10))
            # From the closed end to near the mouth.
            self.assertGreater(result.site_at(600.0), 0.95 * result.crevice.length)
            self.assertTrue(np.all(np.diff(result.site_at(np.arange(1, 72) * HOUR)) < 0.0))
            found.append((*result.trench, result.site_at(5 * HOUR), *result.stop()))
        np.testing.assert_allclose(found[0], found[1], rtol=0.02)
        np.testing.assert_allclose(found[0][2:], found[1][2:], rtol=5e-3)

    def test_second_order_in_time(self):
        # Of a start that is not saturated: where cells fill up, they do so at a point in time.
        p = Crevice(ignitionShare=0.9)
        ends = [simulate(p, 600.0, 254, fixedStep=step, snapshots=1).depth[-1] for step in (40.0, 20.0, 10.0, 1.0)]
        errors = [np.max(np.abs(depth - ends[-1])) / np.max(ends[-1]) for depth in ends[:-1]]
        self.assertGreater(np.min(orders(errors)), 1.8, errors)

    def test_second_order_in_space(self):
        # Of the active site and of the metal lost, while the attack runs to the mouth.
        ends = [simulate(Crevice(), 2 * HOUR, cells, snapshots=1) for cells in (127, 254, 508, 2032)]
        for found in ([r.site[-1] for r in ends], [np.mean(r.depth[-1]) for r in ends]):
            errors = np.abs(np.array(found[:-1]) / found[-1] - 1.0)
            self.assertGreater(np.mean(orders(errors)), 1.8, errors)
            self.assertLess(errors[-1], 1e-3)

    def test_less_than_500_um_need_far_more(self):
        expected = np.array([21.7, 14.37])  # of a grid four times as fine
        needed = [least_factor(Crevice(ignition=width), low=0.9 * factor, high=1.1 * factor, precision=0.03, cells=254,
                               tolerance=5e-3)
                  for width, factor in zip((400e-6, 500e-6), expected)]
        np.testing.assert_allclose(needed, expected, rtol=0.05)
        self.assertTrue(needed[1] < 15.0 < needed[0])


class TrenchGrid(unittest.TestCase):
    def residuals(self, columns, layers):
        """Of C = sin(k x) cosh(k y), harmonic, 0 at the mouth, flat at y = 0, under a wavy wall: what the cells gain, per
        volume, and how far the flux of the wall is off; without the columns at the closed end, where C is not flat."""
        k = 2.0
        grid = MappedGrid(replace(STRAIGHT, diffusivity=1.0), 1.0, columns, layers)
        h, slope = 0.4 + 0.1 * np.sin(3.0 * grid.x), 0.3 * np.cos(3.0 * grid.x)
        y = h[:, None] * np.append(grid.eta, 1.0)
        values = np.sin(k * grid.x)[:, None] * np.cosh(k * y)
        gain = (grid.diffusion(h) @ values.ravel()).reshape(values.shape)
        flux = k * (np.sin(k * grid.x) * np.sinh(k * h) - slope * np.cos(k * grid.x) * np.cosh(k * h))
        gain[:, -2] += grid.dx * flux  # what the wall gives to the cells next to it
        inside = slice(2, -2)
        return (np.sqrt(np.mean((gain[inside, :-1] / (grid.dx * h[inside, None] / layers)) ** 2)),
                np.max(np.abs(gain[inside, -1] + flux[inside])))

    def test_a_harmonic_field_is_at_rest(self):
        coarse, fine, finest = (np.array(self.residuals(n, n // 2)) for n in (20, 40, 80))
        self.assertGreater(np.min(np.log2(coarse / fine)), 0.9, (coarse, fine, finest))
        self.assertGreater(np.min(np.log2(fine / finest)), 0.9, (coarse, fine, finest))
        self.assertTrue(np.all(finest < 0.1), finest)

    def test_parabola_across_a_gap_that_fills_up(self):
        # No gradient along x: C(wall) - mean C = (C_solid - C) ds/dt h/(3 D), once diffusion across has had its time.
        p = Crevice(mouthGap=200e-6, endGap=200e-6, current=constant_current(20.0))
        grid = MappedGrid(p, 12.7e-3, 30, 20)
        stepper = Stepper(grid)
        state = State(np.full((30, 21), 1000.0), np.zeros(30), np.full(30, 1000.0 - p.saturation), np.zeros(30))
        for _ in range(60):
            state = stepper.step(state, 5.0)
        h, speed = 100e-6 + state.depth[-1], 20.0 / (p.charge * FARADAY * p.solid)
        self.assertAlmostEqual(state.depth[-1], 300.0 * speed, delta=1e-12)
        wall, mean = state.values[-1, -1], np.mean(state.values[-1, :-1])
        self.assertAlmostEqual(mean, (100e-6 * 1000.0 + p.solid * state.depth[-1]) / h, delta=1e-6)
        self.assertAlmostEqual((wall - mean) / ((p.solid - wall) * speed * h / (3.0 * p.diffusivity)), 1.0, delta=0.02)


class Trench(unittest.TestCase):
    def test_both_models_agree_while_the_trench_is_shallow(self):
        averaged, trench = simulate(Crevice(), 12 * HOUR, snapshots=12), carve(hours=12, columns=160)
        self.assertLess(trench.massError, 1e-10)
        fastest = trench.crevice.speed(trench.crevice.saturation)[0]
        self.assertLessEqual(np.max(trench.depth.max(axis=1) - fastest * trench.times), 0.0)
        self.assertLessEqual(trench.concentration.max(), trench.crevice.saturation * (1.0 + 1e-9))
        self.assertGreaterEqual(trench.concentration.min(), 0.0)
        for hour in (8, 10, 12):
            k = hour - 6
            deepest = averaged.depth[hour].max()
            self.assertAlmostEqual(trench.deepest(k)[0] / deepest, 1.0, delta=0.05)
            self.assertAlmostEqual(trench.site[k], averaged.site_at(hour * HOUR), delta=0.003 * averaged.crevice.length)
        self.assertLess(trench.deepest()[0], averaged.depth[12].max())  # the bottom saturates first


if __name__ == "__main__":
    unittest.main()
