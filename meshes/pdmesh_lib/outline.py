"""Outlines of the voids in an image, as polygons."""
import numpy as np
from contourpy import FillType, contour_generator
from scipy.ndimage import gaussian_filter
from shapely.geometry import Polygon

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


def outlines(level, smooth, tolerance):
    """Polygons [n, 2] in pixels from the lower left corner of the image, islands of material in them, and how many corners
    there were before they were simplified.

    Marching squares on `level` (above 0: void), smoothed by a Gaussian of `smooth` pixels; corners that move the outline
    by less than `tolerance` pixels are left out. Voids at the border of the image go on beyond it, by two pixels or less.
    """
    if smooth > 0:
        level = gaussian_filter(level, smooth, mode="nearest")
    margin = 3
    # Values of exactly 0 would make contours touch.
    level = np.pad(np.where(level == 0, -1e-12, level), 2, mode="edge")
    level = np.pad(level, 1, constant_values=-1.0)
    at = [np.arange(n) - margin + 0.5 for n in level.shape]
    found, offsets = contour_generator(at[1], at[0], level, fill_type=FillType.OuterOffset).filled(0.0, np.inf)
    polygons, islands, n_corners = [], 0, 0
    for points, starts in zip(found, offsets):
        islands += len(starts) - 2
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
