#!/usr/bin/python3
"""Dissolution of a metal of several solid phases: layers, thin boundaries, a polycrystal."""
import os
import subprocess
import sys
import unittest

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, "../support"), os.path.join(here, "../../decks/grain_boundary")]
from corrosion_scene import FARADAY, SPACING, STEEL, CorrosionTest, corrosion_deck, front_speed  # noqa: E402
from shortest_paths import Paths  # noqa: E402

PDMESH = os.path.join(here, "../../meshes/pdmesh")


class PhasesTest(CorrosionTest):
    def phases_deck(self, dimension, metal, phases, time, steps, held="x < -2e-6", **solver):
        """`phases`: (block, current density, solid concentration) of the blocks beside the first."""
        deck = corrosion_deck(dimension, metal, "x > 0", held, time, steps, **solver)
        deck["Materials"]["Metal"].update({"Phase Blocks": [f"block_{p[0]}" for p in phases],
                                           "Phase Current Densities": [repr(float(p[1])) for p in phases],
                                           "Phase Solid Concentrations": [float(p[2]) for p in phases]})
        deck["Blocks"]["Body"]["Block Names"] = "default"
        return deck

    def balance(self, result):
        return float(" ".join(result.report["solver"]).split("the balance is off by ")[1].split()[0])


class Layers(PhasesTest):
    def test_blocks_of_one_kinetics_are_one_body(self):
        results = []
        for blocks in (False, True):
            self.make_lattice([40e-6, 8e-6], [-7e-6, 0.0])
            if blocks:
                self.write_mesh(self.x, self.volume, 1 + (np.round(self.x.sum(axis=1) / SPACING).astype(int) % 3 == 0))
            phases = [(2 if blocks else 1, STEEL["Current Density"], STEEL["Solid Concentration"])]
            deck = self.phases_deck(2, STEEL, phases, 120.0, 6)
            # Another order of the points of a matrix leaves what the tolerance of the linear systems does.
            deck["Solver"]["Corrosion"]["Solver Tolerance"] = 1e-12
            result = self.solve(deck)
            self.check(result, STEEL)
            results.append([result.field(label, step) for step in result.steps()
                            for label in ("Damage", "Concentration")])
        for one, two in zip(*results):
            np.testing.assert_allclose(one, two, rtol=1e-9, atol=1e-9)

    def test_films_on_phases(self):
        # A phase that bears half of a film that covers all: twice the current is as if there were none.
        self.make_lattice([24e-6], [-7e-6])
        self.write_mesh(self.x, self.volume, 2)
        current, atoms = float(STEEL["Current Density"]), STEEL["Solid Concentration"]
        results = []
        for film in (True, False):
            metal = {**STEEL, "Current Density": repr(2 * current if film else current)}
            deck = self.phases_deck(1, metal, [(2, 2 * current if film else current, atoms)], 20.0, 4)
            if film:
                deck["Materials"]["Metal"]["Phase Film Shares"] = [0.5]
                deck["Boundary Conditions"] |= {
                    "All Node Set": {"Expression": "x < 1"},
                    "Film": {"Type": "Film Coverage", "Node Set": "All Node Set", "Value": 1.0}}
            results.append(self.solve(deck))
        self.assertGreater(results[0].history()["Dissolved"][-1], 2 * SPACING)
        np.testing.assert_allclose(results[0].field("Concentration"), results[1].field("Concentration"), rtol=1e-7,
                                   atol=1e-4)
        deck["Materials"]["Metal"]["Phase Film Shares"] = [1.5]
        refused = self.run_deck(deck)
        self.assertEqual(refused.code, 2, refused.text)
        self.assertIn("lie between 0 and 1", refused.text)

    def test_front_passes_from_layer_to_layer(self):
        # 12 um of steel, then twice the current and 0.7 of the atoms: 2/0.7 times as fast. The dissolution range is 1.5
        # spacings, in which the second layer dissolves beside the first.
        self.make_lattice([60e-6], [-7e-6])
        self.write_mesh(self.x, self.volume, 1 + (self.x[:, 0] > 12e-6))
        atoms, current = 0.7 * STEEL["Solid Concentration"], 2.0 * float(STEEL["Current Density"])
        deck = self.phases_deck(1, STEEL, [(2, current, atoms)], 140.0, 28)
        deck["Boundary Conditions"]["Metal"]["Value"] = f"x > 1.2e-5 ? {atoms!r} : {STEEL['Solid Concentration']!r}"
        result = self.solve(deck)
        self.assertLess(self.balance(result), 1e-10)
        t, depth = result.history()["time"], result.history()["Dissolved"]
        first = front_speed(STEEL)
        second = current / (STEEL["Charge Number"] * FARADAY * atoms)
        exact = np.minimum(first * t, 12e-6) + second * np.maximum(t - 12e-6 / first, 0.0)
        np.testing.assert_allclose(depth, exact, atol=1.0 * SPACING)
        late = t > 12e-6 / first + 10.0
        self.assertAlmostEqual(np.polyfit(t[late], depth[late], 1)[0] / second, 1.0, delta=1e-3)


class Boundaries(PhasesTest):
    """A straight boundary in metal that does not dissolve."""

    def attack(self, width, degrees, ratio=0.0, **solver):
        """Speed of the tip over that of a plane front; what the grains have lost, in points."""
        angle, rows = np.radians(degrees), 41
        self.make_lattice([47 * SPACING, rows * SPACING], [-7e-6, -rows * SPACING / 2])
        cosine, sine = np.cos(angle), np.sin(angle)
        off = np.abs(cosine * self.x[:, 1] - sine * self.x[:, 0])
        thickness = max(width, cosine, sine) * SPACING
        inside = (off <= 0.5 * thickness * (1 - 1e-9)) & (self.x[:, 0] > 0)
        self.write_mesh(self.x, self.volume, 1 + inside)
        metal = {**STEEL, "Current Density": repr(ratio * float(STEEL["Current Density"]))}
        time, steps = 26e-6 / front_speed(STEEL), 26
        phases = [(2, STEEL["Current Density"], STEEL["Solid Concentration"])]
        result = self.solve(self.phases_deck(2, metal, phases, time, steps, **solver))
        self.assertLess(self.balance(result), 1e-10)
        along = cosine * self.x[:, 0] + sine * self.x[:, 1]
        tips = np.array([np.max(along[inside & (result.field("Damage", k) >= 1.0)], initial=0.0)
                         for k in result.steps()[6:]])
        times = time / steps * np.arange(6, steps + 1)
        left = result.field("Concentration")[~inside & (self.x[:, 0] > 0)]
        lost = np.sum(STEEL["Solid Concentration"] - left) / STEEL["Solid Concentration"]
        return np.polyfit(times, tips, 1)[0] / front_speed(STEEL), lost

    def test_speed_hardly_depends_on_direction_and_thickness(self):
        for width, degrees, least, most in ((1, 0, 0.97, 1.03), (1, 45, 0.95, 1.06), (1, 20, 0.85, 1.0),
                                            (3, 0, 0.9, 1.01), (3, 20, 0.9, 1.01), (3, 45, 0.9, 1.01)):
            speed, lost = self.attack(width, degrees)
            self.assertGreater(speed, least, (width, degrees))
            self.assertLess(speed, most, (width, degrees))
            # Nothing is taken from what has no current, but for rounding and points that hang alone.
            self.assertLess(lost, 1e-3)

    def test_speed_does_not_depend_on_steps(self):
        # Over 20 spacings, at both ends of which the tip is known to one.
        short, long = (self.attack(3, 0, **{"Front Limit": limit})[0] for limit in (0.05, 0.5))
        self.assertAlmostEqual(long / short, 1.0, delta=0.1)

    def test_grains_lose_what_their_current_takes(self):
        # Beside a boundary of 3 um that is open for the mean of half the time, on both sides, and at the mouth.
        for ratio in (1e-3, 1e-2):
            lost = self.attack(3, 0, ratio)[1] * SPACING**2
            time = 26e-6 / front_speed(STEEL)
            expected = ratio * front_speed(STEEL) * time * (2 * 0.5 * 0.9 * 26e-6 + 38e-6)
            self.assertAlmostEqual(lost / expected, 1.0, delta=0.15)


class PhasesUnderFilms(PhasesTest):
    """What decides where phases meet is the current that a film leaves to each, and how fast that takes its atoms."""

    OPEN = 0.1  # of the metal around, under its film
    TIME = 14e-6 / front_speed(STEEL)

    def setUp(self):
        super().setUp()
        self.make_lattice([24e-6, 15e-6], [-4e-6, -7.5e-6])
        x, y = np.round(self.x[:, 0] / SPACING - 0.5), np.round(self.x[:, 1] / SPACING)
        self.boundary = (y == 0) & (x >= 0)
        self.particles = (x >= 0) & (x % 6 < 3) & (y % 5 < 3)

    def deck(self, inside, currents, solid=None):
        """`inside`: points of the second phase; `currents` of both."""
        self.write_mesh(self.x, self.volume, 1 + inside)
        atoms = STEEL["Solid Concentration"]
        metal = {**STEEL, "Current Density": repr(float(currents[0]))}
        deck = self.phases_deck(2, metal, [(2, currents[1], solid or atoms)], self.TIME, 14)
        deck["Solver"]["Corrosion"]["Solver Tolerance"] = 1e-12
        deck["Boundary Conditions"]["All Node Set"] = {"Expression": "x < 1"}
        return deck

    def test_a_film_is_as_good_as_less_current(self):
        # Bare beside metal under a film, and half bare; a film that comes late, too.
        current = float(STEEL["Current Density"])
        for inside, share, ratio in ((self.boundary, 0.0, 1.0), (self.particles, 0.0, 1.0), (self.particles, 0.5, 0.4)):
            left = 1.0 - share * (1.0 - self.OPEN)
            bare = self.solve(self.deck(inside, (self.OPEN * current, left * ratio * current)))
            deck = self.deck(inside, (current, ratio * current))
            deck["Materials"]["Metal"]["Phase Film Shares"] = [share]
            deck["Boundary Conditions"]["Film"] = {"Type": "Film Coverage", "Node Set": "All Node Set",
                                                   "Value": 1.0 - self.OPEN}
            film = self.solve(deck)
            self.assertGreater(np.sum(film.field("Damage") >= 1.0), 15)
            np.testing.assert_allclose(film.field("Damage"), bare.field("Damage"), atol=1e-4)
        deck["Boundary Conditions"]["Film"]["Value"] = f"t > {0.5 * self.TIME!r} ? {1.0 - self.OPEN!r} : 0"
        late, shared = (self.solve(deck, ranks=ranks) for ranks in (1, 2))
        self.assertGreater(late.history()["Dissolved"][-1], 1.2 * film.history()["Dissolved"][-1])
        np.testing.assert_allclose(shared.field("Damage"), late.field("Damage"), atol=1e-6)

    def test_fewer_atoms_are_as_good_as_more_current(self):
        # Both fronts are as fast: one front, whatever the phases.
        fewer = 0.6
        current, atoms = float(STEEL["Current Density"]), STEEL["Solid Concentration"]
        deck = self.deck(self.particles, (current, current))
        deck["Compute Class Parameters"]["Dissolved"]["Node Set"] = "All Node Set"
        one = self.solve(deck)
        deck = self.deck(self.particles, (current, fewer * current), fewer * atoms)
        metal = self.x[:, 0] > 0
        deck["Compute Class Parameters"]["Dissolved"]["Node Set"] = "All Node Set"
        deck["Boundary Conditions"] |= {
            "Metal Node Set": " ".join(map(str, np.flatnonzero(metal & ~self.particles) + 1)),
            "Particle Node Set": " ".join(map(str, np.flatnonzero(self.particles) + 1)),
            "Particles": {"Type": "Initial Concentration", "Node Set": "Particle Node Set", "Value": fewer * atoms}}
        two = self.solve(deck)
        self.assertAlmostEqual(two.history()["Dissolved"][-1] / one.history()["Dissolved"][-1], 1.0, delta=0.01)


    def test_round_fronts_pass_phases_that_are_alike_as_one(self):
        # Of one current and different shares where no film is; or as fast by a current and atoms of 0.7.
        self.make_lattice([24e-6, 24e-6])
        radius = np.hypot(self.x[:, 0], self.x[:, 1])
        metal, atoms, fewer = radius > 8e-6, STEEL["Solid Concentration"], 0.7
        x, y = np.round(self.x[:, 0] / SPACING - 0.5), np.round(self.x[:, 1] / SPACING - 0.5)
        inside, current = (x % 6 < 3) & (y % 6 < 3), float(STEEL["Current Density"])
        results = []
        for kind in ("one", "shares", "atoms"):
            factor = fewer if kind == "atoms" else 1.0
            deck = self.deck(inside, (current, factor * current), factor * atoms)
            if kind == "shares":
                deck["Materials"]["Metal"]["Phase Film Shares"] = [0.5]
                deck["Boundary Conditions"]["Film"] = {"Type": "Film Coverage", "Node Set": "All Node Set", "Value": 0.0}
            deck["Compute Class Parameters"]["Dissolved"]["Node Set"] = "All Node Set"
            deck["Solver"]["Final Time"] = 8e-6 / front_speed(STEEL)
            deck["Boundary Conditions"] |= {
                "Sea Node Set": {"Expression": "x*x + y*y < 1.6e-11"},
                "Metal Node Set": " ".join(map(str, np.flatnonzero(metal & ~inside) + 1)),
                "Particle Node Set": " ".join(map(str, np.flatnonzero(metal & inside) + 1)),
                "Particles": {"Type": "Initial Concentration", "Node Set": "Particle Node Set",
                              "Value": factor * atoms}}
            results.append(self.solve(deck).history()["Dissolved"][-1])
        self.assertAlmostEqual(results[1] / results[0], 1.0, delta=1e-6)
        self.assertAlmostEqual(results[2] / results[0], 1.0, delta=0.01)

    def test_metal_without_current_stays_where_a_film_covers_the_rest(self):
        # What points that dissolve owe others is for those to give that have a current, if they had no film.
        inside = (self.x[:, 0] > 0) & (np.round(self.x[:, 0] / SPACING - 0.5) % 3 == 1) & \
            (np.round(self.x[:, 1] / SPACING) % 3 == 0)
        for current in (0.0, 1e-9):
            deck = self.deck(inside, (float(STEEL["Current Density"]), current))
            deck["Materials"]["Metal"]["Phase Film Shares"] = [0.0]
            deck["Boundary Conditions"]["Film"] = {"Type": "Film Coverage", "Node Set": "All Node Set",
                                                   "Value": "x > 5e-6 ? 1 : 0"}
            deck["Solver"]["Corrosion"] |= {"Load Steps": 4, "Front Limit": 0.5}
            damage = self.solve(deck).field("Damage")
            self.assertGreater(np.sum(damage[~inside & (self.x[:, 0] > 0)]), 30)
            self.assertLess(np.sum(damage[inside]), 1e-3)


class PolycrystalTest(PhasesTest):
    """Grains of a hundredth of the current; boundaries 3 um thick, grain and sample `size` large (m)."""

    def make(self, grain, *size):
        def pdmesh(*arguments):
            subprocess.run([sys.executable, PDMESH, *map(str, arguments)], cwd=self.folder, check=True,
                           capture_output=True)

        origin = ["-0.000007", *[0] * (len(size) - 1)]
        pdmesh("grid", "box", "--spacing", SPACING, "--size", size[0] + 7e-6, *size[1:], "--origin", *origin, "-o",
               "plain.txt")
        pdmesh("grains", "plain.txt", "--size", grain, "--width", 3e-6, "--where", "x > 0", "--seed", 3, "--seeds",
               "seeds.txt", "-o", "mesh.txt")
        table = np.loadtxt(self.path("mesh.txt"), comments="#")
        self.x, self.block, self.volume = table[:, :3], table[:, 3], table[0, 4]
        self.metal = {**STEEL, "Current Density": repr(0.01 * float(STEEL["Current Density"]))}
        self.phases = [(2, STEEL["Current Density"], STEEL["Solid Concentration"])]

    def solve_exactly(self, dimension, time, steps, ranks):
        """Of residuals so small that ranks do not differ by them."""
        deck = self.phases_deck(dimension, self.metal, self.phases, time, steps)
        deck["Solver"]["Corrosion"]["Solver Tolerance"] = 1e-12
        result = self.solve(deck, ranks=ranks)
        self.check(result, self.metal)
        return result


class Polycrystal(PolycrystalTest):
    SIZE = 60e-6

    def setUp(self):
        super().setUp()
        self.make(20e-6, self.SIZE, self.SIZE)

    def test_attack_follows_the_shortest_paths(self):
        time, steps = 50e-6 / front_speed(STEEL), 100
        result = self.solve(self.phases_deck(2, self.metal, self.phases, time, steps))
        self.check(result, self.metal)
        arrival = np.full(len(self.x), np.nan)
        for step in result.steps():
            arrival[(result.field("Damage", step) >= 1.0) & np.isnan(arrival)] = step * time / steps
        seeds = np.loadtxt(self.path("seeds.txt"))[:, :2]
        inside = np.flatnonzero((self.block == 2) & (self.x[:, 0] > 0))
        path, away = Paths(seeds, np.zeros(2), np.full(2, self.SIZE)).to(self.x[inside, :2])
        middle = (away < 0.8e-6) & np.isfinite(path)
        there = middle & np.isfinite(arrival[inside]) & (path > 5e-6)
        self.assertGreater(there.sum(), 200)
        speed, start = np.polyfit(arrival[inside][there], path[there], 1)
        # As along a single one of three points.
        self.assertAlmostEqual(speed / front_speed(STEEL), 0.94, delta=0.06)
        rest = path[there] - start - speed * arrival[inside][there]
        # Boundaries 3 um thick that meet at a small angle are one for some way.
        self.assertLess(rest.std(), 2.5e-6)
        self.assertLess(np.quantile(np.abs(rest), 0.9), 4e-6)
        self.assertFalse(np.any(middle & (path < 0.9 * speed * time) & np.isnan(arrival[inside])))

    def test_two_ranks_find_the_same(self):
        results = []
        for ranks in (1, 2):
            result = self.solve_exactly(2, 120.0, 6, ranks)
            results.append([result.field(label, step) for step in result.steps()
                            for label in ("Damage", "Concentration")])
        self.assertGreater(np.sum(results[0][-2] >= 1.0), 600)
        for one, two in zip(*results):
            np.testing.assert_array_equal(two == 1.0, one == 1.0)
            # What rounding leaves of residuals at 1e-12 or a little above.
            np.testing.assert_allclose(two, one, rtol=1e-6, atol=1e-6)


class PolycrystalInSpace(PolycrystalTest):
    def test_boundaries_dissolve_and_grains_stay(self):
        self.make(10e-6, 16e-6, 14e-6, 14e-6)
        results = []
        for ranks in (1, 2):
            result = self.solve_exactly(3, 60.0, 3, ranks)
            results.append((result.field("Damage"), result.field("Concentration")))
        damage, x = results[0][0], self.x[:, 0]
        boundary, grain = (self.block == 2) & (x > 0), (self.block == 1) & (x > 0)
        self.assertGreater(boundary.sum(), 800)
        self.assertGreater(grain.sum(), 800)
        reach = front_speed(STEEL) * 60.0
        # Ways lead inwards at a slant: all is gone up to 0.6 of the reach, nothing beyond it.
        self.assertTrue(np.all(damage[boundary & (x < 0.6 * reach)] >= 1.0))
        self.assertFalse(np.any(damage[boundary & (x > reach + SPACING)] >= 1.0))
        # Grains lose 0.1 um of each of their faces.
        self.assertFalse(np.any(damage[grain] >= 1.0))
        self.assertGreater(np.max(damage[grain]), 0.01)
        np.testing.assert_array_equal(results[1][0] >= 1.0, damage >= 1.0)
        np.testing.assert_allclose(results[1][1], results[0][1], rtol=1e-6, atol=1e-6)


if __name__ == "__main__":
    unittest.main()
