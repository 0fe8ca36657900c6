"""Points as a picture: each pixel takes the value of the nearest point, or none where no point is near."""
import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree


class Raster:
    """Pixels over the points `x` [n, 2]. spacing: of the points (m), one number or [n]. `extent` for imshow,
    `columns` and `rows` for its contour."""

    # A cell's corner is 0.71 spacings from a square's centre, 0.88 from an equilateral triangle's.
    REACH = 0.9

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
        distance, index = cKDTree(x, balanced_tree=False, compact_nodes=False).query(
            grid, distance_upper_bound=1.5 * float(spacing.max()))
        found = np.isfinite(distance)
        near = found & (distance < self.REACH * spacing[np.where(found, index, 0)])
        near = _without_specks(near.reshape(len(rows), len(columns)), (mean * counts[0] / size[0]) ** 2)
        self._index = np.where(near & found.reshape(near.shape), index.reshape(near.shape), -1)

    def image(self, values):
        """[rows, columns], masked where there is no point."""
        return np.ma.masked_where(self._index < 0, values[self._index])


def _without_specks(near, cell):
    """Fills what is empty and smaller than two cells (in pixels): corners that irregular cells have farther out."""
    labels, count = ndimage.label(~near)
    if count == 0:
        return near
    small = np.bincount(labels.ravel()) < 2 * cell
    small[0] = False
    return near | small[labels]
