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
        columns = low[0] + (np.arange(counts[0]) + 0.5) * size[0] / counts[0]
        rows = low[1] + (np.arange(counts[1]) + 0.5) * size[1] / counts[1]
        self.extent = [low[0], high[0], low[1], high[1]]
        self.columns, self.rows = columns, rows
        grid = np.stack(np.meshgrid(columns, rows), axis=-1).reshape(-1, 2)
        tree = cKDTree(x, balanced_tree=False, compact_nodes=False)
        distance, index = tree.query(grid, distance_upper_bound=1.5 * float(spacing.max()))
        found = np.isfinite(distance)
        index = np.where(found, index, 0)
        # Cells are squares; what irregular or displaced ones leave open between them is closed below.
        near = found & (np.abs(grid - x[index]).max(axis=1) < 0.55 * spacing[index])
        near = _closed(near.reshape(len(rows), len(columns)), 0.45 * mean * counts[0] / size[0])
        self._index = np.where(near & found.reshape(near.shape), index.reshape(near.shape), -1)

    def image(self, values):
        """[rows, columns], masked where there is no point."""
        return np.ma.masked_where(self._index < 0, values[self._index])


def _closed(near, radius):
    """Fills gaps up to twice the radius (pixels) wide; straight edges stay where they are."""
    if near.all():
        return near
    margin = int(radius) + 2  # what lies outside the picture is empty, too
    padded = np.pad(near, margin)
    grown = ndimage.distance_transform_edt(~padded) <= radius
    closed = ndimage.distance_transform_edt(grown) > radius
    return near | closed[margin:-margin, margin:-margin]
