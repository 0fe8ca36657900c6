"""How far places on grain boundaries are from the surface, along boundaries: shortest paths over the edges of the
Voronoi structure of the grains. Shares nothing with pdrun; attack that runs along boundaries at one speed is there after
path / speed."""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import Voronoi


def clipped(a, b, low, high):
    """The part of the segment a b in the box, or None."""
    begin, end = 0.0, 1.0
    for d in range(2):
        step = b[d] - a[d]
        if step == 0.0:
            if not low[d] <= a[d] <= high[d]:
                return None
            continue
        first, last = sorted(((low[d] - a[d]) / step, (high[d] - a[d]) / step))
        begin, end = max(begin, first), min(end, last)
    return (a + begin * (b - a), a + end * (b - a)) if begin < end else None


class Paths:
    """seeds [m, 2]; low, high: corners of the body, whose surface is at x = low[0]."""

    def __init__(self, seeds, low, high):
        structure = Voronoi(seeds)
        edges = [clipped(*structure.vertices[ends], low, high) for ends in structure.ridge_vertices if min(ends) >= 0]
        ends = np.array([edge for edge in edges if edge is not None])
        places, number = np.unique(np.round(ends.reshape(-1, 2) / 1e-12), axis=0, return_inverse=True)
        number = number.reshape(-1, 2)
        length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        graph = coo_matrix((length, (number[:, 0], number[:, 1])), shape=(len(places), len(places)))
        at_surface = np.flatnonzero(places[:, 0] * 1e-12 <= low[0] + 1e-12)
        distance = dijkstra(graph, directed=False, indices=at_surface, min_only=True)
        self.ends, self.distance, self.length = ends, distance[number], length

    def to(self, x):
        """[n] path length to the place on a boundary nearest to each of x [n, 2], and how far away that is."""
        path, away = np.empty(len(x)), np.empty(len(x))
        along = (self.ends[:, 1] - self.ends[:, 0]) / self.length[:, None]
        for k, point in enumerate(x):
            s = np.clip(np.sum((point - self.ends[:, 0]) * along, axis=1), 0.0, self.length)
            off = np.linalg.norm(self.ends[:, 0] + s[:, None] * along - point, axis=1)
            # Where edges meet, the shortest way counts.
            near = np.flatnonzero(off <= off.min() + 1e-9)
            ways = np.minimum(self.distance[near, 0] + s[near], self.distance[near, 1] + self.length[near] - s[near])
            path[k], away[k] = ways.min(), off.min()
        return path, away
