"""Grains of a polycrystal and the boundaries between them: a Voronoi tessellation of points drawn at random."""
import numpy as np
from scipy.spatial import cKDTree

from .errors import MeshError
from .points import write_lines

# Mean length (area, number) of boundaries a unit area (volume, length) where grains have 1 of it in the mean: half of
# the mean perimeter (surface) of a cell, 4 and (256 pi/3)^(1/3) Gamma(5/3). Meijering, Philips Res. Rep. 8 (1953) 270.
BOUNDARY_DENSITY = {1: 1.0, 2: 2.0, 3: 2.9104}


class Grains:
    """grain [n]: of which grain each point is, counted from 0; is_boundary [n]; seeds [m, dimension]."""

    def __init__(self, grain, is_boundary, seeds):
        self.grain, self.is_boundary, self.seeds = grain, is_boundary, seeds


def make_grains(x, spacing, size, width, random, steps=None, by_share=False):
    """Splits points x [n, dimension] of `spacing` [n] into grains of mean length, area or volume size^dimension, and
    boundaries. Other points of the same body are split alike.

    A point belongs to a boundary where it is at most half the boundary's thickness away from the plane half-way between
    the seed of its grain and that of another. The thickness is `width`, and at least the spacing; points of a lattice,
    `steps` [dimension], need only max_d steps_d |n_d|, n being the normal of the plane. Then a boundary thinner than
    the spacing is just one point thick, counted along the axis that it crosses most steeply (a naive digital plane:
    Andres, Acharya & Sibata, Graph. Models Image Process. 59 (1997) 302), and keeps together: of two lattice neighbours
    in different grains at least one is marked. Where `by_share`, the thickness is the width alone, and those points are
    marked whose cells boundaries fill most, of as much volume in all as boundaries have: the share of marked points is
    that of the boundaries of these very grains at any spacing, but they lie apart where that is wider.
    """
    seeds = _seeds(x, np.max(spacing, initial=0.0) if steps is None else steps, size, random)
    tree = cKDTree(seeds)
    if by_share:
        cells = spacing if steps is None else np.tile(steps, (len(x), 1))
        grain = np.unique(tree.query(x)[1], return_inverse=True)[1]
        return Grains(grain, _fullest(x, cells, tree, seeds, width), seeds)
    grain, is_boundary = np.empty(len(x), int), np.zeros(len(x), bool)
    for begin in range(0, len(x), 100000):
        part = slice(begin, begin + 100000)
        distances, neighbors = tree.query(x[part], k=2)
        grain[part] = neighbors[:, 0]
        least = spacing[part] if steps is None else np.full(len(distances), np.max(steps))
        # A plane at distance b is that of a seed at most 2 b farther away than the nearest.
        reach = (distances[:, 0] + np.maximum(width, least)) * (1 + 1e-9)
        close = np.flatnonzero(distances[:, 1] <= reach)
        near = tree.query_ball_point(x[part][close], reach[close])
        point = np.repeat(close, np.fromiter(map(len, near), int, len(near)))
        other = np.array([seed for seeds_near in near for seed in seeds_near], int)
        point, other = point[other != grain[begin + point]], other[other != grain[begin + point]]
        here, own = x[begin + point], seeds[grain[begin + point]]
        apart = seeds[other] - own
        normal = apart / np.linalg.norm(apart, axis=1)[:, None]
        distance = np.sum(((seeds[other] + own) / 2 - here) * normal, axis=1)
        thickness = least[point]
        if steps is not None:
            thickness = np.max(steps * np.abs(normal), axis=1)
        is_boundary[begin + point[distance <= np.maximum(width, thickness) / 2]] = True
    return Grains(np.unique(grain, return_inverse=True)[1], is_boundary, seeds)


def _fullest(x, steps, tree, seeds, width):
    """[n] Whether a point is of those whose cells, boxes of `steps`, boundaries fill most, of as much volume as they fill
    in all. What they fill of a cell is counted on a grid in it, a finer one where there are few cells."""
    steps = np.broadcast_to(np.reshape(steps, (len(x), -1)), x.shape)
    dimension, cell = x.shape[1], np.prod(steps, axis=1)
    apart = np.diff(tree.query(x, k=2)[0], axis=1)[:, 0]  # at most twice the distance from the boundary
    close = np.flatnonzero(apart <= width + np.linalg.norm(steps, axis=1))
    if len(close) == 0:
        return np.zeros(len(x), bool)
    count = int(np.clip(np.ceil((4e4 / max(len(close), 1)) ** (1 / dimension)), 2, 16))
    offsets = (np.arange(count) + 0.5) / count - 0.5
    inside = np.stack([axis.ravel() for axis in np.meshgrid(*[offsets] * dimension, indexing="ij")], axis=1)
    share = np.zeros(len(x))
    for part in np.array_split(close, max(1, len(close) * len(inside) // 400000)):
        places = (x[part][:, None] + inside * steps[part][:, None]).reshape(-1, dimension)
        distances, neighbors = tree.query(places, k=min(4, len(seeds)))
        between = np.linalg.norm(seeds[neighbors[:, 1:]] - seeds[neighbors[:, :1]], axis=2)
        to_plane = (distances[:, 1:] ** 2 - distances[:, :1] ** 2) / (2 * between)
        share[part] = np.any(to_plane < width / 2, axis=1).reshape(len(part), -1).mean(axis=1)
    # Of cells that are filled alike, those whose points are nearest to a boundary.
    order = np.lexsort((apart, -share))
    filled = np.cumsum(cell[order]) - 0.5 * cell[order]
    chosen = np.zeros(len(x), bool)
    chosen[order[(filled < np.sum(share * cell)) & (share[order] > 0)]] = True
    return chosen


def _seeds(x, steps, size, random):
    """One in size^dimension in the mean, in a box as far beyond the cells of the points as grains reach."""
    grid = 1e-6 * size  # rounding must not make another box of the same body
    low = np.rint((x.min(axis=0) - np.asarray(steps) / 2) / grid) * grid - 4 * size
    high = np.rint((x.max(axis=0) + np.asarray(steps) / 2) / grid) * grid + 4 * size
    expected = np.prod((high - low) / size)
    if expected > 5e6:
        raise MeshError(f"--size {size:g}: {expected:.2g} grains are too many; is the size in metres?")
    return random.uniform(low, high, (max(random.poisson(expected), 1), x.shape[1]))


def lattice_steps(points):
    """[dimension] spacings along the axes where the points are of a lattice, else None."""
    steps = []
    for d in range(points.dimension):
        values = np.unique(points.x[:, d])
        gaps = np.diff(values)
        gaps = gaps[gaps > 1e-9 * np.ptp(values)]
        if len(gaps) == 0:
            return None
        steps.append(gaps.min())
    fills = np.allclose(points.volume, np.prod(steps) * points.measure, rtol=1e-6, atol=0.0)
    return np.array(steps) if fills else None


def assign_blocks(grains, block, boundary_block, phases, random):
    """[n] block of each point: `boundary_block`, that of the phase of its grain, or block [n]. `phases`: pairs of a
    block and a share of the grains."""
    n_grains = grains.grain.max() + 1
    of_grain, order, taken, share = np.zeros(n_grains, int), random.permutation(n_grains), 0, 0.0
    for number, more in phases:
        share += more
        upto = int(round(share * n_grains))
        of_grain[order[taken:upto]] = number
        taken = upto
    phase = of_grain[grains.grain]
    return np.where(grains.is_boundary, boundary_block, np.where(phase > 0, phase, block))


def write_grains(grains, chosen, n_points, file_name):
    """A line a point: its grain, from 1; 0 where it was not split."""
    numbers = np.zeros(n_points, int)
    numbers[chosen] = grains.grain + 1
    write_lines(file_name, [f"# {numbers.max()} grains: that of each point, 0 for none\n"]
                + [f"{number}\n" for number in numbers.tolist()])


def write_seeds(grains, place, file_name):
    """Seeds, also those beyond the body; `place` [3]: the coordinates that all points share."""
    seeds = np.tile(place, (len(grains.seeds), 1))
    seeds[:, :grains.seeds.shape[1]] = grains.seeds
    write_lines(file_name, [f"# seeds of grains: {len(seeds)}\n"]
                + [f"{x!r} {y!r} {z!r}\n" for x, y, z in seeds.tolist()])
