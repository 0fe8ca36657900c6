"""Points as a picture: each pixel takes the value of the nearest point, or none where no point is near."""
import numpy as np
from scipy.spatial import cKDTree


class Raster:
    """Pixels over the points `x` [n, 2]; `reach`: how far a point colours (m). `extent` for matplotlib's imshow."""

    def __init__(self, x, reach, pixels=1400, window=None):
        # A point stands for half a spacing around it; reach is 0.9 of a spacing.
        margin = reach / 1.8
        low, high = (x.min(axis=0) - margin, x.max(axis=0) + margin) if window is None else window
        size = np.maximum(high - low, 1e-300)
        counts = np.maximum(2, np.rint(size / size.max() * pixels)).astype(int)
        columns = low[0] + (np.arange(counts[0]) + 0.5) * size[0] / counts[0]
        rows = low[1] + (np.arange(counts[1]) + 0.5) * size[1] / counts[1]
        self.extent = [low[0], high[0], low[1], high[1]]
        self.columns, self.rows = columns, rows
        grid = np.stack(np.meshgrid(columns, rows), axis=-1).reshape(-1, 2)
        distance, index = cKDTree(x, balanced_tree=False, compact_nodes=False).query(grid, distance_upper_bound=reach)
        self._index = np.where(np.isfinite(distance), index, -1).reshape(len(rows), len(columns))

    def image(self, values):
        """[rows, columns], masked where there is no point."""
        return np.ma.masked_where(self._index < 0, values[self._index])
