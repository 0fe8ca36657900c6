"""Points as a picture: each pixel takes the value of the nearest point, or none where no point is near."""
import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree


class Raster:
    """Pixels over the points `x` [n, 2]. spacing: of the points (m), one number or [n]. `extent` for imshow,
    `columns` and `rows` for its contour."""

    def __init__(self, x, spacing, pixels=1400, window=None):
        spacing = np.broadcast_to(spacing, len(x))
        mean = float(spacing.mean())
        low, high = (x.min(axis=0) - mean / 2, x.max(axis=0) + mean / 2) if window is None else window
        size = np.maximum(high - low, 1e-300)
        counts = np.maximum(2, np.rint(size / size.max() * pixels)).astype(int)
        pixel = size / counts
        self.extent = [low[0], high[0], low[1], high[1]]
        radius = 0.45 * mean / pixel[0]
        margin = int(radius) + 2  # pixels around the picture, for gaps that its edge cuts
        columns, rows = (low[d] + (np.arange(-margin, counts[d] + margin) + 0.5) * pixel[d] for d in (0, 1))
        inner = slice(margin, -margin)
        self.columns, self.rows = columns[inner], rows[inner]
        grid = np.stack(np.meshgrid(columns, rows), axis=-1).reshape(-1, 2)
        tree = cKDTree(x, balanced_tree=False, compact_nodes=False)
        distance, index = tree.query(grid, distance_upper_bound=1.5 * float(spacing.max()))
        found = np.isfinite(distance)
        index = np.where(found, index, 0)
        # Cells are squares; what irregular or displaced ones leave open between them is closed below.
        near = found & (np.abs(grid - x[index]).max(axis=1) < 0.55 * spacing[index])
        shape = len(rows), len(columns)
        near = _closed(near.reshape(shape), radius) & found.reshape(shape)
        self._index = np.where(near, index.reshape(shape), -1)[inner, inner]

    def image(self, values):
        """[rows, columns], masked where there is no point."""
        return np.ma.masked_where(self._index < 0, values[self._index])


def _closed(near, radius):
    """Fills gaps up to twice the radius (pixels) wide; straight edges stay where they are."""
    if near.all():
        return near
    grown = ndimage.distance_transform_edt(~near) <= radius
    return near | (grown if grown.all() else ndimage.distance_transform_edt(grown) > radius)
