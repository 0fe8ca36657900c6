"""Reference elements: shape functions, and quadrature that integrates 1 and x over any element map exactly.

Node order is meshio's (VTK's). Shape functions come from the monomials that span an element's polynomial space and the
places of its nodes, so that no formula is written out by hand: N = V^-1 m(xi), V_ij = m_j(xi_i).
"""
from functools import lru_cache
from itertools import product

import numpy as np


class Element:
    """`points` Gauss points a direction make volume and first moment exact for the element's own map."""

    def __init__(self, dimension, nodes, exponents, points, simplex_directions, corners):
        self.dimension = dimension
        self.nodes = np.array(nodes, float)
        self.exponents = np.array(exponents, int)
        self.points = points
        self.simplex_directions = simplex_directions  # 0: cube, 2: triangle x line, dimension: simplex
        self.corners = corners  # the first nodes are the corners

    def monomials(self, xi):
        return np.prod(xi[:, None, :] ** self.exponents[None, :, :], axis=2)

    def monomial_gradients(self, xi):
        """[points, monomials, direction]"""
        columns = []
        for direction in range(self.dimension):
            lowered = self.exponents.copy()
            lowered[:, direction] = np.maximum(lowered[:, direction] - 1, 0)
            columns.append(self.exponents[:, direction] * np.prod(xi[:, None, :] ** lowered[None, :, :], axis=2))
        return np.stack(columns, axis=2)


def _midpoints(corners, edges):
    corners = np.array(corners, float)
    return [tuple((corners[i] + corners[j]) / 2) for i, j in edges]


def _tensor(dimension, highest):
    return list(product(range(highest + 1), repeat=dimension))


def _serendipity(dimension):
    """Monomials of superlinear degree at most 2 (Arnold & Awanou 2011, Found. Comput. Math. 11, 337)."""
    return [e for e in _tensor(dimension, 2) if sum(i for i in e if i > 1) <= 2]


def _total(dimension, highest):
    return [e for e in _tensor(dimension, highest) if sum(e) <= highest]


def _make_elements():
    line = [(0,), (1,)]
    triangle = [(0, 0), (1, 0), (0, 1)]
    quad = [(0, 0), (1, 0), (1, 1), (0, 1)]
    tetra = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    wedge = [(x, y, z) for z in (0, 1) for x, y in triangle]
    hexahedron = [(x, y, z) for z in (0, 1) for x, y in quad]
    triangle6 = triangle + _midpoints(triangle, [(0, 1), (1, 2), (2, 0)])
    quad8 = quad + _midpoints(quad, [(0, 1), (1, 2), (2, 3), (3, 0)])
    tetra10 = tetra + _midpoints(tetra, [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)])
    wedge15 = wedge + _midpoints(
        wedge, [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)])
    wedge18 = wedge15 + [(0.5, 0, 0.5), (0.5, 0.5, 0.5), (0, 0.5, 0.5)]
    hexahedron20 = hexahedron + _midpoints(
        hexahedron, [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)])
    faces = [(0, 0.5, 0.5), (1, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 1, 0.5), (0.5, 0.5, 0), (0.5, 0.5, 1)]
    hexahedron27 = hexahedron20 + faces + [(0.5, 0.5, 0.5)]
    wedge_linear = [e + (k,) for e in _total(2, 1) for k in (0, 1)]
    wedge_serendipity = [e + (k,) for e in _total(2, 2) for k in (0, 1)] + [e + (2,) for e in _total(2, 1)]
    wedge_full = [e + (k,) for e in _total(2, 2) for k in (0, 1, 2)]
    return {
        "vertex": Element(0, [()], [()], 1, 0, 1),
        "line": Element(1, line, _tensor(1, 1), 1, 1, 2),
        "line3": Element(1, line + [(0.5,)], _tensor(1, 2), 2, 1, 2),
        "triangle": Element(2, triangle, _total(2, 1), 2, 2, 3),
        "triangle6": Element(2, triangle6, _total(2, 2), 3, 2, 3),
        "quad": Element(2, quad, _tensor(2, 1), 2, 0, 4),
        "quad8": Element(2, quad8, _serendipity(2), 3, 0, 4),
        "quad9": Element(2, quad8 + [(0.5, 0.5)], _tensor(2, 2), 3, 0, 4),
        "tetra": Element(3, tetra, _total(3, 1), 2, 3, 4),
        "tetra10": Element(3, tetra10, _total(3, 2), 4, 3, 4),
        "wedge": Element(3, wedge, wedge_linear, 2, 2, 6),
        "wedge15": Element(3, wedge15, wedge_serendipity, 4, 2, 6),
        "wedge18": Element(3, wedge18, wedge_full, 4, 2, 6),
        "hexahedron": Element(3, hexahedron, _tensor(3, 1), 2, 0, 8),
        "hexahedron20": Element(3, hexahedron20, _serendipity(3), 4, 0, 8),
        "hexahedron27": Element(3, hexahedron27, _tensor(3, 2), 4, 0, 8),
    }


ELEMENTS = _make_elements()
# The linear element whose shape functions share out an element's volume among its corners.
LINEAR = {"triangle6": "triangle", "quad8": "quad", "quad9": "quad", "tetra10": "tetra", "wedge15": "wedge",
          "wedge18": "wedge", "hexahedron20": "hexahedron", "hexahedron27": "hexahedron", "line3": "line"}
# Volume of the element whose edges all have length 1: triangles and tetrahedra are equilateral.
REGULAR_VOLUME = {"line": 1.0, "triangle": 3 ** 0.5 / 4, "quad": 1.0, "tetra": 2 ** 0.5 / 12, "wedge": 3 ** 0.5 / 4,
                  "hexahedron": 1.0}
# A pyramid fills the region of a hexahedron whose upper four corners have fallen together.
COLLAPSED = {"pyramid": ("hexahedron", [0, 1, 2, 3, 4, 4, 4, 4])}


@lru_cache(maxsize=None)
def edges(name):
    """Pairs of corners that an edge joins: all pairs within the simplex part, neighbours along the other directions."""
    element = ELEMENTS[LINEAR.get(name, name)]
    split = element.simplex_directions
    pairs = []
    for i, a in enumerate(element.nodes):
        for j, b in enumerate(element.nodes[:i]):
            in_simplex, elsewhere = np.any(a[:split] != b[:split]), np.count_nonzero(a[split:] != b[split:])
            if (in_simplex and elsewhere == 0) or (not in_simplex and elsewhere == 1):
                pairs.append((i, j))
    return pairs


@lru_cache(maxsize=None)
def quadrature(name):
    """Points [n, dimension] and weights [n] on the reference element. Simplices by Duffy's collapsed coordinates,
    whose Jacobian raises the degree by one for each collapsed direction."""
    element = ELEMENTS[name]
    x, w = np.polynomial.legendre.leggauss(element.points)
    x, w = (x + 1) / 2, w / 2
    points, weights = [], []
    for index in product(range(element.points), repeat=element.dimension):
        xi = np.array([x[i] for i in index])
        weight = np.prod([w[i] for i in index])
        if element.simplex_directions >= 2:
            weight *= 1 - xi[0]
            xi[1] *= 1 - xi[0]
        if element.simplex_directions == 3:
            weight *= (1 - x[index[0]]) * (1 - x[index[1]])
            xi[2] *= (1 - x[index[0]]) * (1 - x[index[1]])
        points.append(xi)
        weights.append(weight)
    return np.array(points), np.array(weights)


@lru_cache(maxsize=None)
def shapes(name, of=None):
    """Shape functions [points, nodes] and gradients [points, nodes, dimension] of element `of` (itself) at the
    quadrature points of `name`."""
    element = ELEMENTS[of or name]
    xi, _ = quadrature(name)
    inverse = np.linalg.inv(element.monomials(element.nodes))
    values = element.monomials(xi) @ inverse
    gradients = np.einsum("pmd,mn->pnd", element.monomial_gradients(xi), inverse)
    return values, gradients


def integrate(name, coordinates):
    """Volume (signed by the element's orientation), first moment and the share of each corner.

    coordinates [elements, nodes, dimension]. Returns volume [elements], centroid [elements, dimension], shares
    [elements, corners] (they sum to the volume; negative where the volume is), and whether the map folds over:
    its Jacobian changes sign within the element.
    """
    base = coordinates[:, :1, :]
    local = coordinates - base  # keeps the round-off of far-away elements out of the volume
    values, gradients = shapes(name)
    corner_values, _ = shapes(name, LINEAR.get(name, name))
    _, weights = quadrature(name)
    # As products of matrices, which numpy hands to BLAS: einsum("eni,pnd->epid") takes ten times as long.
    n_elements, n_nodes, dimension = local.shape
    flat = local.transpose(0, 2, 1).reshape(-1, n_nodes) @ gradients.transpose(1, 0, 2).reshape(n_nodes, -1)
    jacobian = flat.reshape(n_elements, dimension, len(weights), dimension).transpose(0, 2, 1, 3)
    weighted = _determinant(jacobian) * weights
    volume = weighted.sum(axis=1)
    moment = ((weighted @ values)[:, :, None] * local).sum(axis=1)
    determinant = weighted / weights
    scale = np.abs(determinant).max(axis=1)
    folds = (determinant.min(axis=1) < -1e-9 * scale) & (determinant.max(axis=1) > 1e-9 * scale)
    with np.errstate(invalid="ignore", divide="ignore"):
        centroid = base[:, 0, :] + moment / volume[:, None]
    return volume, centroid, weighted @ corner_values, folds


def _determinant(matrices):
    dimension = matrices.shape[-1]
    m = matrices
    if dimension == 1:
        return m[..., 0, 0]
    if dimension == 2:
        return m[..., 0, 0] * m[..., 1, 1] - m[..., 0, 1] * m[..., 1, 0]
    return (m[..., 0, 0] * (m[..., 1, 1] * m[..., 2, 2] - m[..., 1, 2] * m[..., 2, 1])
            - m[..., 0, 1] * (m[..., 1, 0] * m[..., 2, 2] - m[..., 1, 2] * m[..., 2, 0])
            + m[..., 0, 2] * (m[..., 1, 0] * m[..., 2, 1] - m[..., 1, 1] * m[..., 2, 0]))
