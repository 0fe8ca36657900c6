"""Outlines of the voids in an image, as polygons."""
import numpy as np
from contourpy import FillType, contour_generator
from scipy.ndimage import binary_fill_holes, gaussian_filter, label, maximum
from shapely.geometry import Polygon, box
from shapely.ops import unary_union

from .errors import MeshError


def voids_of(image, is_bright, threshold=None):
    """[rows, columns] how far each pixel is on the side of the voids, in parts of the range of grey; rows from below.

    image: grey values, the first row on top, as images are read. threshold: half-way between darkest and brightest.
    """
    grey = np.asarray(image, float)[::-1]
    low, high = grey.min(), grey.max()
    if low == high:
        raise MeshError(f"all pixels have the grey value {low:g}: there is no outline")
    level = 0.5 * (low + high) if threshold is None else threshold
    if not low < level <= high:
        raise MeshError(f"--threshold {level:g} parts nothing: grey values go from {low:g} to {high:g}")
    return (grey - level if is_bright else level - grey) / (high - low)


def smoothed(level, smooth):
    return gaussian_filter(level, smooth, mode="nearest") if smooth > 0 else level


def outlines(level, smooth, tolerance):
    """Polygons [n, 2] in pixels from the lower left corner of the image, the areas of the islands of material in each, and
    how many corners there were before they were simplified.

    Marching squares on `level` (above 0: void), smoothed by a Gaussian of `smooth` pixels; corners that move the outline
    by less than `tolerance` pixels are left out. Voids at the border of the image go on beyond it, by two pixels or less.
    """
    level = smoothed(level, smooth)
    margin = 3
    # Values of exactly 0 would make contours touch.
    level = np.pad(np.where(level == 0, -1e-12, level), 2, mode="edge")
    level = np.pad(level, 1, constant_values=-1.0)
    at = [np.arange(n) - margin + 0.5 for n in level.shape]
    found, offsets = contour_generator(at[1], at[0], level, fill_type=FillType.OuterOffset).filled(0.0, np.inf)
    polygons, islands, n_corners = [], [], 0
    for points, starts in zip(found, offsets):
        islands.append([area_of(points[first:last]) for first, last in zip(starts[1:-1], starts[2:])])
        n_corners += int(starts[1]) - 1
        outline = Polygon(points[starts[0]:starts[1]])
        simple = outline.simplify(tolerance, preserve_topology=True) if tolerance > 0 else outline
        if not simple.is_valid or simple.area == 0.0:
            raise MeshError("an outline touches itself; give more pixels to --smooth, or fewer to --tolerance")
        polygons.append(np.array(simple.exterior.coords)[:-1])
    return polygons, islands, n_corners


def area_of(polygon):
    """Of [n, 2] corners in turn; by the shoelace formula."""
    x, y = (polygon - polygon[0]).T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def reaches_border(polygon, shape):
    """Whether the polygon leaves an image of shape [rows, columns]."""
    return polygon.min() < 0 or np.any(polygon.max(axis=0) > shape[::-1])


def share_of(polygons, shape):
    """Of an image of shape [rows, columns]: what lies in several polygons counts once."""
    inside = unary_union([Polygon(polygon) for polygon in polygons]).intersection(box(0, 0, *shape[::-1]))
    return inside.area / np.prod(shape)


def share_by_pixels(level):
    """Of the image: pixels of voids, and of islands in them."""
    return np.mean(binary_fill_holes(level > 0))


def lost_voids(level, smooth):
    """Numbers of pixels of the voids of which nothing is left once they are smoothed."""
    labels, n = label(level > 0)
    highest = maximum(smoothed(level, smooth), labels, np.arange(1, n + 1))
    return np.bincount(labels.ravel(), minlength=n + 1)[1:][np.asarray(highest) <= 0]
