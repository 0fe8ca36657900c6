"""Points as a picture: each pixel takes the value of the nearest point, or none where no point is near."""
import numpy as np
from scipy import ndimage
from scipy.spatial import Delaunay, QhullError, cKDTree


class Raster:
    """Pixels over the points `x` [n, 2], or over those near a plane through a solid, [n, 3], the last the height above
    it. spacing: of the points (m), one number or [n]; reach: half the width of the widest gap between points that is
    none of the body's, in spacings. `extent` for imshow, `columns` and `rows` for its contour."""

    def __init__(self, x, spacing, pixels=1400, window=None, reach=0.45):
        spacing = np.broadcast_to(spacing, len(x))
        mean = float(spacing.mean())
        low, high = window_of(x, mean) if window is None else window
        size = np.maximum(high - low, 1e-300)
        counts = np.maximum(2, np.rint(size / size.max() * pixels)).astype(int)
        pixel = size / counts
        self.extent = [low[0], high[0], low[1], high[1]]
        radius = reach * mean / pixel[0]
        margin = int(radius) + 2  # pixels around the picture, for gaps that its edge cuts
        columns, rows = (low[d] + (np.arange(-margin, counts[d] + margin) + 0.5) * pixel[d] for d in (0, 1))
        inner = slice(margin, -margin)
        self.columns, self.rows = columns[inner], rows[inner]
        grid = np.stack(np.meshgrid(columns, rows), axis=-1).reshape(-1, 2)
        grid = np.pad(grid, ((0, 0), (0, x.shape[1] - 2)))
        tree = cKDTree(x, balanced_tree=False, compact_nodes=False)
        distance, index = tree.query(grid, distance_upper_bound=(1.05 + reach) * float(spacing.max()))
        found = np.isfinite(distance)
        index = np.where(found, index, 0)
        # Cells are squares; what irregular or displaced ones leave open between them is closed below.
        near = found & (np.abs(grid - x[index]).max(axis=1) < 0.55 * spacing[index])
        shape = len(rows), len(columns)
        around = distance < (0.5 + reach) * spacing[index]
        near = _closed(near.reshape(shape), around.reshape(shape), radius) & found.reshape(shape)
        self._index = np.where(near, index.reshape(shape), -1)[inner, inner]

    def image(self, values):
        """[rows, columns], masked where there is no point."""
        return np.ma.masked_where(self._index < 0, values[self._index])

    def is_empty(self):
        return bool((self._index < 0).all())


def window_of(x, spacing):
    """(lowest corner, highest corner) of the cells of points [n, 2 or more]; of a solid's those that the plane cuts."""
    cut = x[np.abs(x[:, 2]) <= 0.51 * spacing] if x.shape[1] > 2 else x
    cut = cut if len(cut) else x
    return cut[:, :2].min(axis=0) - spacing / 2, cut[:, :2].max(axis=0) + spacing / 2


def _closed(near, around, radius):
    """Fills gaps up to twice the radius (pixels) wide; straight edges stay where they are."""
    if near.all():
        return near
    grown = around | (ndimage.distance_transform_edt(~near) <= radius)
    return near | (grown if grown.all() else ndimage.distance_transform_edt(grown) > radius)


def reach_of(x, spacings):
    """`reach` of a Raster of these points [n, d]. In a lattice no place lies farther than half a spacing from the
    nearest point along any axis; in a mesh of tetrahedra, whose centroids stand around its nodes, places do. They are
    the centres of the largest balls without points (Delaunay), here those in the middle of the body."""
    from_middle = ((x - x.mean(axis=0)) ** 2).sum(axis=1)
    region = np.argpartition(from_middle, 2999)[:3000] if len(x) > 3000 else np.arange(len(x))
    points, width = x[region], spacings[region]
    try:
        mesh = Delaunay(points)
    except (QhullError, ValueError):
        return 0.45
    corners = points[mesh.simplices]
    edges = corners[:, 1:] - corners[:, :1]
    volume = np.abs(np.linalg.det(edges))
    whole = volume > 1e-9 * volume.max()  # lattices have flat simplices
    edges, corners = edges[whole], corners[whole]
    centres = corners[:, 0] + np.linalg.solve(edges, (edges ** 2).sum(axis=2)[:, :, None] / 2)[:, :, 0]
    centres = centres[mesh.find_simplex(centres) >= 0]
    if not len(centres):
        return 0.45
    distance, index = cKDTree(points).query(centres)
    # Upper quartiles: above them are notches and holes of the body. Lattices have 0.5, jittered by 0.2 spacings 0.63,
    # meshes of tetrahedra 0.8 to 1; the widest gaps of these are about 1.15 times as wide as three quarters are.
    along_axes = np.quantile(np.abs(centres - points[index]).max(axis=1) / width[index], 0.75)
    gap = np.quantile(distance / width[index], 0.75)
    return float(np.clip(1.15 * gap - 0.4, 0.45, 1.1)) if along_axes > 0.65 else 0.45
