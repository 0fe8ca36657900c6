#!/usr/bin/python3
"""pdmesh grains: amounts of boundaries against theory and against the tessellation itself; what coarse grids make of
thin boundaries."""
import unittest

import numpy as np
from pdmesh_case import PdmeshCase, Result
from scipy.ndimage import label
from scipy.spatial import Voronoi

from pdmesh_lib.errors import MeshError
from pdmesh_lib.grains import make_grains

# Mean length (area) of boundaries of a Poisson-Voronoi tessellation, a unit area (volume), of cells of size 1: Okabe,
# Boots, Sugihara & Chiu, Spatial Tessellations (2000), tables 5.5.1 and 5.5.2: half of perimeters 4 and surfaces 5.821.
DENSITY = {2: 2.0, 3: 2.910}


def lattice(n, dimension):
    """[n^dimension, dimension] of unit spacing, the last direction fastest."""
    axes = np.meshgrid(*[np.arange(n) + 0.5] * dimension, indexing="ij")
    return np.stack([axis.ravel() for axis in axes], axis=1)


def on_lattice(n, dimension, size, width, seed, is_thin=True):
    """Grains on a lattice of unit spacing; (grains, labels, marks), the last two as [n, n(, n)]."""
    x = lattice(n, dimension)
    made = make_grains(x, np.ones(len(x)), size, width, np.random.default_rng(seed), np.ones(dimension), not is_thin)
    shape = (n,) * dimension
    return made, made.grain.reshape(shape), made.is_boundary.reshape(shape)


class FixedSeeds:
    """Stands for the random generator: these seeds."""

    def __init__(self, seeds):
        self.seeds = np.array(seeds, float)

    def poisson(self, _):
        return len(self.seeds)

    def uniform(self, *_):
        return self.seeds


class Amounts(unittest.TestCase):
    def test_share_is_width_times_length(self):
        # 2 x 800 to 2500 grains; the length of their boundaries scatters by less than 1/sqrt(grains). Boundaries
        # overlap where they meet: a corner of angle a takes (width/2)^2 cot(a/2) away, six of them a grain; with
        # a = 2 pi/3 that is 0.22 of the square of the share, and more with angles that differ.
        for n, size, width in ((560, 20.0, 1.0), (560, 20.0, 0.1), (280, 10.0, 0.3), (560, 20.0, 2.0)):
            share = np.mean([on_lattice(n, 2, size, width, seed, False)[2].mean() for seed in (1, 2)])
            expected = width * DENSITY[2] / size
            self.assertAlmostEqual(share / expected, 1 - 0.25 * expected, delta=0.02, msg=str((n, size, width)))

    def test_share_in_a_solid(self):
        for size, width in ((9.0, 1.0), (9.0, 0.2), (6.0, 0.5)):
            share = on_lattice(54, 3, size, width, 1, False)[2].mean()
            expected = width * DENSITY[3] / size
            self.assertAlmostEqual(share / expected, 1 - 0.25 * expected, delta=0.03, msg=str((size, width)))

    def test_share_does_not_depend_on_the_spacing(self):
        # The same structure, ever coarser: from 4 points across a boundary to a fifth of one.
        shares, seeds = [], []
        for step in (1, 4, 20):
            x = lattice(800 // step, 2) * step
            made = make_grains(x, np.full(len(x), step), 80.0, 4.0, np.random.default_rng(3), np.full(2, step), True)
            shares.append(made.is_boundary.mean())
            seeds.append(made.seeds)
        np.testing.assert_allclose(shares, shares[0], rtol=0.05)
        for others in seeds[1:]:
            np.testing.assert_array_equal(others, seeds[0])

    def test_share_of_few_grains_in_a_round_wire(self):
        # 80 um with grains of 40 um: points marked at spacings of 5 to 1 um, over the area at 0.2 um.
        def share(spacing, width, seed, by_share):
            n = int(np.ceil(45.0 / spacing))
            x = (lattice(2 * n, 2) - n) * spacing
            x = x[np.hypot(*x.T) < 40.0]
            steps = np.full(2, spacing)
            # The box of the wire, not that of its points, says where seeds are.
            box = np.array([[-45.0, -45.0], [45.0, 45.0]])
            seeds = FixedSeeds(np.random.default_rng(seed).uniform(box[0] - 160, box[1] + 160, (105, 2)))
            return make_grains(x, np.full(len(x), spacing), 40.0, width, seeds, steps, by_share).is_boundary.mean()

        for width, seed in ((2.0, 1), (5.0, 2), (1.0, 3)):
            area = share(0.2, width, seed, False)
            for spacing in (5.0, 2.5, 1.0):
                self.assertLess(abs(share(spacing, width, seed, True) / area - 1), 0.1, (width, seed, spacing))

    def test_share_is_that_of_the_ridges_of_this_tessellation(self):
        n, width = 600, 1.0
        made, _, marks = on_lattice(n, 2, n / 12, width, 4, False)
        structure = Voronoi(made.seeds)
        length = 0.0
        for a, b in structure.ridge_vertices:
            if a < 0:
                continue
            # What of the ridge lies in the window, by many short pieces.
            t = (np.arange(4000) + 0.5) / 4000
            points = structure.vertices[a] + t[:, None] * (structure.vertices[b] - structure.vertices[a])
            inside = np.all((points > 0) & (points < n), axis=1).mean()
            length += inside * np.linalg.norm(structure.vertices[b] - structure.vertices[a])
        expected = width * length / n**2
        self.assertAlmostEqual(marks.mean() / expected, 1 - 0.25 * expected, delta=0.01)

    def test_grain_size(self):
        for dimension, n, size in ((1, 100000, 50.0), (2, 500, 10.0), (3, 50, 5.0)):
            made = on_lattice(n, dimension, size, 1.0, 5)[0]
            inside = np.all((made.seeds > 0) & (made.seeds < n), axis=1).sum()
            expected = (n / size)**dimension
            self.assertAlmostEqual(inside, expected, delta=4 * np.sqrt(expected))

    def test_each_point_belongs_to_its_nearest_seed(self):
        made = on_lattice(60, 2, 12.0, 1.0, 6)[0]
        x = lattice(60, 2)
        nearest = np.argmin(np.sum((x[:, None] - made.seeds)**2, axis=2), axis=1)
        pairs = {(a, b) for a, b in zip(nearest, made.grain)}
        self.assertEqual(len(pairs), len(np.unique(nearest)))
        self.assertEqual(len(pairs), made.grain.max() + 1)


class ThinBoundaries(unittest.TestCase):
    def test_single_boundary_is_one_point_thick(self):
        # Whatever its direction and place: one point in each row of lattice points that it crosses most steeply.
        random = np.random.default_rng(8)
        x, n = lattice(31, 2), 31
        for angle in np.linspace(0.03, np.pi + 0.03, 20):
            for width in (0.0, 0.5):
                normal = np.array([np.cos(angle), np.sin(angle)])
                middle = np.array([15.5, 15.5]) + random.uniform(-0.5, 0.5, 2)
                seeds = [middle - 5 * normal, middle + 5 * normal]
                made = make_grains(x, np.ones(len(x)), 10.0, width, FixedSeeds(seeds), np.ones(2))
                marks = made.is_boundary.reshape(n, n)
                axis = int(abs(normal[1]) > abs(normal[0]))
                across = marks.sum(axis=axis)
                # Rows that the boundary leaves by the side of the lattice have none.
                place = middle[axis] + (middle[1 - axis] - np.arange(n) - 0.5) * normal[1 - axis] / normal[axis]
                np.testing.assert_array_equal(across[(place > 0.51) & (place < n - 0.51)], 1, err_msg=str(angle))

    def test_grains_are_separated(self):
        for dimension, n, size in ((2, 300, 12.0), (2, 300, 4.0), (3, 50, 9.0)):
            _, grain, marks = on_lattice(n, dimension, size, 0.0, 9)
            for axis in range(dimension):
                first, second = [slice(None)] * dimension, [slice(None)] * dimension
                first[axis], second[axis] = slice(0, -1), slice(1, None)
                first, second = tuple(first), tuple(second)
                self.assertFalse(np.any((grain[first] != grain[second]) & ~marks[first] & ~marks[second]))

    def test_boundaries_hold_together(self):
        marks = on_lattice(400, 2, 25.0, 0.0, 10)[2]
        pieces, _ = label(marks, structure=np.ones((3, 3)))
        # At corners of the lattice a boundary may come in and go out again.
        self.assertGreater(np.max(np.bincount(pieces[marks])) / marks.sum(), 0.98)
        by_share = on_lattice(400, 2, 25.0, 0.2, 10, False)[2]
        self.assertGreater(label(by_share, structure=np.ones((3, 3)))[1], 100)

    def test_they_are_marked_no_thicker(self):
        # Mean of max |n_d| over all directions: 2 sqrt(2)/pi in the plane; in space by quadrature.
        random = np.random.default_rng(11).normal(size=(400000, 3))
        mean = {2: 2 * np.sqrt(2) / np.pi, 3: np.mean(np.max(np.abs(random), axis=1) / np.linalg.norm(random, axis=1))}
        for dimension, n, size in ((2, 600, 24.0), (3, 80, 16.0)):
            share = np.mean([on_lattice(n, dimension, size, 0.0, seed)[2].mean() for seed in (1, 2)])
            expected = mean[dimension] * DENSITY[dimension] / size
            self.assertAlmostEqual(share / expected, 1 - 0.25 * expected, delta=0.04, msg=str(dimension))

    def test_spacings_that_differ(self):
        # 5 : 1. One point thick along the axis where that is the thinner in points.
        steps = np.array([5.0, 1.0])
        x = lattice(1000, 2)[:200000] * steps
        made = make_grains(x, np.full(len(x), 5**0.5), 50.0, 0.0, np.random.default_rng(12), steps)
        grain, marks = made.grain.reshape(200, 1000), made.is_boundary.reshape(200, 1000)
        for a, b in ((np.s_[:-1, :], np.s_[1:, :]), (np.s_[:, :-1], np.s_[:, 1:])):
            self.assertFalse(np.any((grain[a] != grain[b]) & ~marks[a] & ~marks[b]))
        angle = np.linspace(0, np.pi / 2, 10001)
        thickness = np.mean(np.maximum(5 * np.cos(angle), np.sin(angle)))
        expected = thickness * DENSITY[2] / 50
        self.assertAlmostEqual(marks.mean() / expected, 1 - 0.25 * expected, delta=0.06)


class Command(PdmeshCase):
    def setUp(self):
        super().setUp()
        self.pdmesh("grid", "box", "--size", 1e-4, 8e-5, "--spacing", 1e-6, "--thickness", 0.01, "-o", "plain.txt")

    def grains(self, *arguments, output="made.txt"):
        self.output, self.errors = self.pdmesh("grains", "plain.txt", "--size", 2e-5, *arguments, "-o", output)
        return Result(self.folder / output)

    def test_blocks_and_files(self):
        plain = Result(self.folder / "plain.txt")
        made = self.grains("--width", 2e-6, "--grains", "numbers.txt", "--node-set", "faces: block == 2")
        np.testing.assert_array_equal(made.x, plain.x)
        np.testing.assert_array_equal(made.volume, plain.volume)
        self.assertEqual(set(made.block), {1, 2})
        np.testing.assert_array_equal(self.node_set("faces"), np.flatnonzero(made.block == 2))
        numbers = np.loadtxt(self.folder / "numbers.txt", comments="#", dtype=int)
        self.assertEqual(len(numbers), len(plain.x))
        self.assertEqual(set(numbers), set(range(1, numbers.max() + 1)))
        share = np.mean(made.block == 2)
        self.assertIn(f"{numbers.max()} grains", self.output)
        self.assertIn(f"boundaries have {share:.4g} of the volume; 0.2 is that", self.output)
        self.assertEqual(self.errors, "")
        self.assertIn("thickness 0.01", (self.folder / "made.txt").read_text())

    def test_seeds_make_the_same_grains(self):
        self.grains("--width", 1e-6, "--grains", "numbers.txt", "--seeds", "seeds.txt")
        numbers = np.loadtxt(self.folder / "numbers.txt", comments="#", dtype=int)
        seeds = np.loadtxt(self.folder / "seeds.txt", comments="#")
        x = Result(self.folder / "made.txt").x
        nearest = np.argmin(np.sum((x[:, None, :2] - seeds[:, :2])**2, axis=2), axis=1)
        self.assertEqual(len(set(zip(nearest, numbers))), numbers.max())
        self.assertTrue(np.all(seeds[:, 2] == x[0, 2]))

    def test_seed_of_the_random_numbers(self):
        one, again = self.grains("--width", 1e-6), self.grains("--width", 1e-6)
        other = self.grains("--width", 1e-6, "--seed", 2)
        np.testing.assert_array_equal(one.block, again.block)
        self.assertTrue(np.any(one.block != other.block))

    def test_phases(self):
        made = self.grains("--width", 1e-6, "--phase", "7=0.25", "--phase", "4=0.25", "--boundary-block", 9, "--grains",
                           "numbers.txt")
        self.assertEqual(set(made.block), {1, 4, 7, 9})
        numbers = np.loadtxt(self.folder / "numbers.txt", comments="#", dtype=int)
        inner = made.block != 9
        of_grain = {}
        for number, block in zip(numbers[inner], made.block[inner]):
            self.assertEqual(of_grain.setdefault(number, block), block)
        counts = np.bincount(list(of_grain.values()), minlength=8)
        self.assertAlmostEqual(counts[7], 0.25 * numbers.max(), delta=3)
        self.assertAlmostEqual(counts[4], 0.25 * numbers.max(), delta=3)

        self.assertEqual(set(self.grains("--width", 1e-6, "--phase", "2=0.5").block), {1, 2, 3})

    def test_only_a_part(self):
        made = self.grains("--width", 2e-6, "--where", "x > 5e-5")
        self.assertTrue(np.all(made.block[made.x[:, 0] < 5e-5] == 1))
        made = self.grains("--width", 2e-6, "--where", "x^2 + y^2 < (5e-5)^2")
        is_far = np.hypot(made.x[:, 0], made.x[:, 1]) > 5e-5
        self.assertEqual(set(made.block[is_far]), {1})
        self.assertAlmostEqual(np.mean(made.block[~is_far] == 2), 0.2, delta=0.06)
        self.pdmesh("grid", "box", "--size", 1e-4, 1e-4, "--spacing", 2e-6, "--block", "3: y > 5e-5", "-o", "plain.txt")
        made = self.grains("--width", 4e-6, "--split", 3)
        below = made.x[:, 1] < 5e-5
        self.assertTrue(np.all(made.block[below] == 1))
        self.assertEqual(set(made.block[~below]), {3, 4})
        self.assertIn("--split", self.pdmesh("grains", "plain.txt", "--size", 2e-5, "--width", 1e-6, "-o", "b.txt",
                                             expect=2)[1])

    def test_thin_boundaries_are_spoken_of(self):
        thin = self.grains("--width", 2e-7)
        self.assertIn("made one point thick: 4.", self.errors)
        by_share = self.grains("--width", 2e-7, "--by-share")
        self.assertEqual(self.errors, "")
        self.assertLess(np.mean(by_share.block == 2), 0.5 * np.mean(thin.block == 2))
        self.pdmesh("grains", "plain.txt", "--size", 3e-6, "--width", 1e-6, "-o", "b.txt")
        self.assertIn("smaller than four spacings",
                      self.pdmesh("grains", "plain.txt", "--size", 3e-6, "--width", 1e-6, "-o", "b.txt")[1])

    def test_points_without_a_lattice(self):
        self.pdmesh("grid", "box", "--size", 1e-4, 1e-4, "--spacing", 1e-6, "--jitter", 0.3, "-o", "plain.txt")
        made = self.grains("--width", 2e-6)
        self.assertAlmostEqual(np.mean(made.block == 2), 0.2, delta=0.04)
        # At least as thick as the mean spacing: no thinner than on the lattice, where it is 0.9 of it.
        thin = self.grains("--width", 0.0)
        self.assertAlmostEqual(np.mean(thin.block == 2), 0.1, delta=0.02)

    def test_mistakes(self):
        good = ["--size", 2e-5, "--width", 0]
        for arguments, message in ((["--size", 0, "--width", 1e-6], "--size must be positive"),
                                   (["--size", 2e-5, "--width", -1], "--width must not be negative"),
                                   (["--size", 1e-12, "--width", 0], "too many"),
                                   ([*good, "--phase", "2"], "expected BLOCK=SHARE"),
                                   ([*good, "--phase", "2=1.5"], "at most 1"),
                                   ([*good, "--phase", "2=.7", "--phase", "3=.7"], "more than 1"),
                                   ([*good, "--boundary-block", 0], "from 1 on"),
                                   ([*good, "--boundary-block", 1], "is the block to split"),
                                   ([*good, "--boundary-block", 3, "--phase", "3=.7"], "the block of a --phase"),
                                   ([*good, "--split", 4], "no such block"),
                                   ([*good, "--where", "x > 1"], "no points to split")):
            self.assertIn(message, self.pdmesh("grains", "plain.txt", *arguments, "-o", "b.txt", expect=2)[1])
        with self.assertRaises(MeshError):
            make_grains(lattice(10, 2), np.ones(100), 1e-9, 0.0, np.random.default_rng(1))


if __name__ == "__main__":
    unittest.main()
