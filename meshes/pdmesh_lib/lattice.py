"""Lattices of points in simple shapes, and what is cut out of them."""
import numpy as np

from .errors import MeshError
from .points import Points

# Of a spacing: what mesh generators leave of a lattice, far below what anybody moves a point by on purpose.
_ROUNDING = 1e-8


def lattice(size, spacing, origin, measure=1.0):
    """Cell centres of a box; `spacing` is adjusted so that a whole number of cells fits each edge."""
    size, spacing = np.asarray(size, float), np.asarray(spacing, float)
    if np.any(size <= 0) or np.any(spacing <= 0):
        raise MeshError("sizes and spacings must be positive")
    counts = np.maximum(1, np.rint(size / spacing)).astype(int)
    if np.prod(counts.astype(float)) > 2e8:
        raise MeshError(f"{' x '.join(map(str, counts))} points are too many; is the spacing in metres?")
    steps = size / counts
    axes = [origin[d] + (np.arange(counts[d]) + 0.5) * steps[d] for d in range(len(size))]
    # x runs fastest: neighbours along x sit next to each other.
    grid = np.meshgrid(*reversed(axes), indexing="ij")
    x = np.zeros((int(np.prod(counts)), 3))
    for d in range(len(size)):
        x[:, d] = grid[len(size) - 1 - d].ravel()
    for d in range(len(size), 3):
        x[:, d] = origin[d]
    volume = np.full(len(x), float(np.prod(steps)) * measure)
    points = Points(x, np.ones(len(x), int), volume, len(size), measure)
    points.steps = steps
    return points, steps


def onto_lattice(points):
    """Moves points that are on a lattice but for rounding, as those of Gmsh's transfinite meshes are, onto it: only
    bonds that are equal to some 1e-12 take the quick loops of pdrun. Returns the largest motion in spacings; None where
    the points are on no lattice, and stay."""
    d = points.dimension
    spacing = float(np.median(points.volume) / points.measure) ** (1 / d)
    if not spacing > 0.0:
        return None
    moved = np.empty((len(points), d))
    for k in range(d):
        axis = _onto_rows(points.x[:, k], spacing)
        if axis is None:
            return None
        moved[:, k] = axis
    largest = float(np.abs(moved - points.x[:, :d]).max() / spacing)
    points.x[:, :d] = moved
    least = _ROUNDING * float(np.median(points.volume))
    evened = _evened(points.volume, least)[0]
    points.volume = np.where(np.abs(evened - points.volume) <= least, evened, points.volume)
    return largest


def _onto_rows(values, spacing):
    """Coordinates that form equidistant rows but for rounding, on the rows; else None."""
    on_rows, rows = _evened(values, 1e-3 * spacing)
    if np.abs(on_rows - values).max() > _ROUNDING * spacing:
        return None
    middle, step = (rows[0] + rows[-1]) / 2, (rows[-1] - rows[0]) / max(1, len(rows) - 1)
    even = middle + (np.arange(len(rows)) - (len(rows) - 1) / 2) * step
    if np.abs(even - rows).max() > _ROUNDING * spacing:
        return None
    return even[np.searchsorted((even[1:] + even[:-1]) / 2, values)]


def _evened(values, gap):
    """Values less than `gap` from the next are replaced by their mean; and these means, rising."""
    order = np.argsort(values, kind="stable")
    number = np.concatenate([[0], np.cumsum(np.diff(values[order]) > gap)])
    means = np.bincount(number, values[order]) / np.bincount(number)
    evened = np.empty_like(values)
    evened[order] = means[number]
    return evened, means


def keep(points, mask):
    kept = Points(points.x[mask], points.block[mask], points.volume[mask], points.dimension, points.measure)
    kept.steps = points.steps
    if len(kept) == 0:
        raise MeshError("nothing is left of the shape: everything was cut away")
    return kept


def round_shape(radius, inner, length, spacing, centre, measure):
    """Disc or ring (length None), cylinder or tube along z from the centre's z."""
    if inner >= radius:
        raise MeshError(f"the inner radius {inner:g} must be smaller than the radius {radius:g}")
    size = [2 * radius, 2 * radius] + ([] if length is None else [length])
    origin = [centre[0] - radius, centre[1] - radius, centre[2]]
    points, steps = lattice(size, spacing[:len(size)], origin, measure)
    distance = np.hypot(points.x[:, 0] - centre[0], points.x[:, 1] - centre[1])
    exact = np.pi * (radius ** 2 - inner ** 2) * (measure if length is None else length)
    return keep(points, (distance <= radius) & (distance >= inner)), steps, exact


def in_hole(x, hole):
    return np.hypot(x[:, 0] - hole[0], x[:, 1] - hole[1]) < hole[2]


def in_notch(x, notch):
    """Slot of a width around the segment (x0, y0) - (x1, y1), with square ends."""
    x0, y0, x1, y1, width = notch
    length = np.hypot(x1 - x0, y1 - y0)
    if length == 0:
        raise MeshError("a notch needs two different ends")
    along = ((x[:, 0] - x0) * (x1 - x0) + (x[:, 1] - y0) * (y1 - y0)) / length
    across = np.abs((x[:, 0] - x0) * (y1 - y0) - (x[:, 1] - y0) * (x1 - x0)) / length
    return (along >= 0) & (along <= length) & (across < width / 2)


def in_wedge(x, wedge):
    """Sector with its tip at (x, y), opening `angle` degrees about `direction` degrees from the x axis."""
    tip_x, tip_y, direction, angle = wedge
    heading = np.arctan2(x[:, 1] - tip_y, x[:, 0] - tip_x) - np.radians(direction)
    return np.abs((heading + np.pi) % (2 * np.pi) - np.pi) < np.radians(angle) / 2


def turn(points, centre, degrees):
    """Turns the points about the z axis through `centre`, anticlockwise."""
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    x, y = points.x[:, 0] - centre[0], points.x[:, 1] - centre[1]
    points.x[:, 0], points.x[:, 1] = centre[0] + cosine * x - sine * y, centre[1] + sine * x + cosine * y


def jitter(points, steps, amplitude, seed):
    """Moves each point by a uniform random share (at most `amplitude`) of the spacing in each direction of the mesh."""
    if not 0 <= amplitude < 0.5:
        raise MeshError("--jitter must be in [0, 0.5): beyond half a spacing points may meet")
    random = np.random.default_rng(seed)
    d = points.dimension
    points.x[:, :d] += random.uniform(-amplitude, amplitude, (len(points), d)) * np.asarray(steps)[:d]
