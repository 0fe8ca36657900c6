"""From a finite element mesh to points with volumes, and from its groups to node sets."""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.spatial import cKDTree

from .elements import ELEMENTS, LINEAR, REGULAR_VOLUME, edges, integrate
from .errors import MeshError
from .points import Points

_CHUNK = 50000


class Conversion:
    """Points made of a mesh, and what is needed to find node sets on them."""

    def __init__(self, points, mesh, at_nodes, element_of_point, mesh_volume):
        self.points, self.mesh, self.at_nodes = points, mesh, at_nodes
        self.mesh_node_of_point = element_of_point if at_nodes else None
        self.mesh_volume = mesh_volume  # signed by nothing, thickness included
        self.slivers = 0
        self.stretch, self.longest_edge = 1.0, 0.0  # median over the elements; what 99 % of them do not exceed (m)


def convert(mesh, at_nodes=False, thickness=None, scale=1.0):
    """Points at element centroids, or at mesh nodes. `thickness` (m) is the cross section (m2) of a 1D mesh."""
    if mesh.dimension == 3 and thickness is not None:
        raise MeshError("--thickness is for plane meshes; this mesh has volume elements")
    measure = 1.0 if thickness is None else thickness
    nodes = mesh.nodes * scale
    volumes, centroids, shares = [], [], []
    slivers, stretches, longest = 0, [], []
    for kind, connectivity, _ in mesh.cells:
        part = [_integrate_part(kind, connectivity[i:i + _CHUNK], nodes, i)
                for i in range(0, len(connectivity), _CHUNK)]
        volumes.append(np.concatenate([p[0] for p in part]) * measure)
        centroids.append(np.concatenate([p[1] for p in part]))
        shares.append(np.concatenate([p[2] for p in part]) * measure)
        slivers += sum(p[3] for p in part)
        stretches += [p[4] for p in part]
        longest += [p[5] for p in part]
    blocks = [block for _, _, block in mesh.cells]
    total = float(sum(volume.sum() for volume in volumes))
    z = nodes[mesh.cells[0][1][0, 0]]
    if at_nodes:
        x, block, volume, used = _points_at_nodes(mesh, nodes, shares)
    else:
        centroid = np.concatenate(centroids)
        x = np.tile(z, (len(centroid), 1))
        x[:, :mesh.dimension] = centroid
        block, volume, used = np.concatenate(blocks), np.concatenate(volumes), None
    points = Points(x, block, volume, mesh.dimension, measure)
    points.block_names = {number: name for number, name in mesh.block_names.items() if number in set(np.unique(block))}
    result = Conversion(points, mesh, at_nodes, used, total)
    result.slivers, result.nodes = slivers, nodes
    result.stretch = float(np.median(np.concatenate(stretches)))
    result.longest_edge = float(np.quantile(np.concatenate(longest), 0.99))
    return result


def _integrate_part(kind, connectivity, nodes, first):
    dimension = ELEMENTS[kind].dimension
    coordinates = nodes[connectivity][:, :, :dimension]
    volume, centroid, share, folds = integrate(kind, coordinates)
    if folds.any():
        raise MeshError(f"{np.count_nonzero(folds)} {kind} elements fold over themselves, the first is number "
                        f"{first + int(np.flatnonzero(folds)[0]) + 1} of its kind; repair the mesh")
    longest = np.zeros(len(coordinates))
    for i, j in edges(kind):
        np.maximum(longest, np.linalg.norm(coordinates[:, i] - coordinates[:, j], axis=1), out=longest)
    size = np.abs(volume) / REGULAR_VOLUME[LINEAR.get(kind, kind)]
    empty = ~(size > 1e-14 * longest ** dimension)
    if empty.any():
        raise MeshError(f"{np.count_nonzero(empty)} {kind} elements have no volume, the first is number "
                        f"{first + int(np.flatnonzero(empty)[0]) + 1} of its kind; remove them")
    # 1 where all edges are equal.
    stretch = longest / size ** (1 / dimension)
    sign = np.sign(volume)
    return volume * sign, centroid, share * sign[:, None], int((stretch ** dimension > 20).sum()), stretch, longest


def _points_at_nodes(mesh, nodes, shares):
    """Each corner node gets its share of the adjacent elements, and the block that gives it most."""
    n_nodes = len(nodes)
    volume = np.zeros(n_nodes)
    numbers = np.unique(np.concatenate([block for _, _, block in mesh.cells]))
    by_block = np.zeros((len(numbers), n_nodes))
    for (kind, connectivity, block), share in zip(mesh.cells, shares):
        corners = connectivity[:, :ELEMENTS[kind].corners]
        volume += np.bincount(corners.ravel(), share.ravel(), n_nodes)
        for i, number in enumerate(numbers):
            mine = block == number
            by_block[i] += np.bincount(corners[mine].ravel(), share[mine].ravel(), n_nodes)
    used = np.flatnonzero(volume != 0)
    return nodes[used].copy(), numbers[by_block[:, used].argmax(axis=0)], volume[used], used


def group_points(conversion, group, depth=None):
    """Indices of the points of a group: within `depth` of its elements, or, without a depth, its nodes (points at
    nodes) or the points of the elements that have one of its elements as a side. Solid groups: of their elements."""
    if depth is not None and not group.is_solid:
        return _within(conversion.points.x, _simplices(conversion.nodes, group), depth)
    if conversion.at_nodes:
        return np.flatnonzero(np.isin(conversion.mesh_node_of_point, group.corner_nodes()))
    return _adjacent_elements(conversion.mesh, group)


def _adjacent_elements(mesh, group):
    n_nodes = len(mesh.nodes)
    elements, columns, offset = [], [], 0
    for kind, connectivity, _ in mesh.cells:
        corners = connectivity[:, :ELEMENTS[kind].corners]
        elements.append(np.repeat(np.arange(len(corners)) + offset, corners.shape[1]))
        columns.append(corners.ravel())
        offset += len(corners)
    elements, columns = np.concatenate(elements), np.concatenate(columns)
    incidence = coo_matrix((np.ones(len(elements), np.int32), (elements, columns)), (offset, n_nodes)).tocsr()
    incidence.data[:] = 1  # collapsed elements name a node more than once
    sides = [connectivity[:, :ELEMENTS[kind].corners] for kind, connectivity in group.parts]
    if not sides:
        sides.append(np.asarray(group.nodes)[:, None])
    found = []
    for corners in sides:
        rows = np.repeat(np.arange(len(corners)), corners.shape[1])
        facet = coo_matrix((np.ones(corners.size, np.int32), (rows, corners.ravel())), (len(corners), n_nodes)).tocsr()
        shared = (incidence @ facet.T).tocoo()
        found.append(shared.row[shared.data == corners.shape[1]])
    return np.unique(np.concatenate(found)) if found else np.array([], int)


def _simplices(nodes, group):
    """The group's elements as points, segments and triangles: list of [m, k, 3]; its nodes, where it has no sides."""
    if group.is_face or not group.parts:
        return [nodes[group.nodes][:, None, :]]
    result = []
    for kind, connectivity in group.parts:
        kind = LINEAR.get(kind, kind)
        corners = nodes[connectivity[:, :ELEMENTS[kind].corners]]
        result += [corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]] if kind == "quad" else [corners]
    return result


def _within(x, simplices, depth):
    tree = cKDTree(x)
    chosen = np.zeros(len(x), bool)
    limit = depth * (1 + 1e-9)
    for corners in simplices:
        centers = corners.mean(axis=1)
        radii = np.linalg.norm(corners - centers[:, None], axis=2).max(axis=1) + limit
        for first in range(0, len(corners), 2000):
            part = slice(first, first + 2000)
            lists = tree.query_ball_point(centers[part], radii[part])
            counts = np.array([len(found) for found in lists])
            if counts.sum() == 0:
                continue
            candidates = np.concatenate([np.array(found, int) for found in lists if found])
            of = np.repeat(corners[part], counts, axis=0)
            chosen[candidates[_distance(x[candidates], of) <= limit]] = True
    return np.flatnonzero(chosen)


def _distance(x, corners):
    """Distance of each point to its point, segment or triangle [n, k, 3]."""
    if corners.shape[1] == 1:
        return np.linalg.norm(x - corners[:, 0], axis=1)
    if corners.shape[1] == 2:
        return _to_segment(x, corners[:, 0], corners[:, 1])
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    area = np.einsum("ij,ij->i", normal, normal)
    height = np.einsum("ij,ij->i", x - a, normal)
    foot = x - normal * (height / area)[:, None]
    inside = np.ones(len(x), bool)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("ij,ij->i", np.cross(q - p, foot - p), normal) >= 0
    edges = np.minimum(np.minimum(_to_segment(x, a, b), _to_segment(x, b, c)), _to_segment(x, c, a))
    return np.where(inside, np.abs(height) / np.sqrt(area), edges)


def _to_segment(x, a, b):
    direction = b - a
    along = np.einsum("ij,ij->i", x - a, direction) / np.einsum("ij,ij->i", direction, direction)
    foot = a + np.clip(along, 0, 1)[:, None] * direction
    return np.linalg.norm(x - foot, axis=1)
