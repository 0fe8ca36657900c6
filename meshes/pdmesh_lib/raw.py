"""What every reader hands over: nodes, elements in VTK's node order, named groups of elements and of nodes."""
import numpy as np

from .elements import COLLAPSED, ELEMENTS, LINEAR
from .errors import MeshError


class RawGroup:
    """Elements that a file names together. members: part index -> indices of elements in it; number: that of the
    block it would make, or None; nodes: those that the file names likewise, where they belong to the elements."""

    def __init__(self, name, number=None):
        self.name, self.number, self.members = name, number, {}
        self.nodes = None

    def add(self, part, indices):
        indices = np.asarray(indices, dtype=np.int64).ravel()
        if len(indices):
            self.members[part] = np.union1d(self.members[part], indices) if part in self.members else indices


class RawMesh:
    """nodes [n, 3]; parts: list of (element type, connectivity [m, k], counted from 0); groups: RawGroup; node_sets:
    name -> node indices; sections: those groups that the file itself says are the blocks."""

    def __init__(self, nodes, parts, groups=(), node_sets=None):
        self.nodes, self.parts, self.groups = nodes, list(parts), list(groups)
        self.node_sets = node_sets or {}
        self.sections = []
        self.notes = []  # what was left out, for the report


class Skip:
    """Types of elements that a user leaves out, by the names that the file gives them."""

    def __init__(self, names=()):
        self.counts = {name.upper(): 0 for name in names}

    def wants(self, name):
        return name.upper() in self.counts

    def count(self, name, n_elements):
        self.counts[name.upper()] += n_elements


def places_of(labels, file_name):
    """A function from labels of nodes to their places among `labels`; -1 where there is none."""
    order = np.argsort(labels, kind="stable")
    ordered = labels[order]
    twice = np.flatnonzero(np.diff(ordered) == 0)
    if len(twice):
        raise MeshError(f"{file_name}: node {ordered[twice[0]]} is defined twice")
    if len(ordered) and 0 <= ordered[0] and ordered[-1] < 8 * len(ordered) + 1000:  # a table is faster than a search
        table = np.full(int(ordered[-1]) + 2, -1, dtype=np.int64)
        table[labels] = np.arange(len(labels))
        return lambda wanted: table[np.where((wanted < 0) | (wanted >= len(table)), len(table) - 1, wanted)]

    def search(wanted):
        found = np.minimum(np.searchsorted(ordered, wanted), len(ordered) - 1)
        return np.where(ordered[found] == wanted, order[found], -1)
    return search


def known_part(file_name, kind, connectivity, remedy=""):
    """(element type, connectivity) in terms of ELEMENTS; refuses what is not there."""
    if kind in COLLAPSED:
        kind, order = COLLAPSED[kind]
        return kind, connectivity[:, order]
    if kind not in ELEMENTS:
        raise MeshError(f"{file_name}: elements of type {kind} are not supported (known: "
                        f"{', '.join(sorted(list(ELEMENTS) + list(COLLAPSED)))}); mesh with first or second order "
                        f"elements, in Gmsh Mesh.ElementOrder = 1 or 2{remedy}")
    return kind, connectivity


def corner_keys(kind, connectivity):
    """A number for each element that does not depend on the order of its corners (a random sum: two elements of 1e6
    share one by chance in 1e-7 of all meshes)."""
    corners = connectivity[:, :ELEMENTS[kind].corners]
    random = np.random.default_rng(1).integers(1, 2**62, size=int(corners.max(initial=0)) + 1, dtype=np.int64)
    with np.errstate(over="ignore"):
        return random[corners].sum(axis=1)


def middles_off(kind, nodes, connectivity):
    """How far the middle nodes of second order elements lie from where their corners have them, in sizes of the
    element; curved edges give a tenth, a wrong order of nodes a half."""
    element, linear = ELEMENTS[kind], ELEMENTS[LINEAR[kind]]
    weights = linear.monomials(element.nodes) @ np.linalg.inv(linear.monomials(linear.nodes))
    sample = connectivity[:1000]
    expected = np.einsum("kc,ecd->ekd", weights, nodes[sample[:, :element.corners]])
    size = np.ptp(nodes[sample], axis=1).max(axis=1)
    return np.median(np.abs(expected - nodes[sample]).max(axis=(1, 2)) / size)


def groups_of_tags(file_name, parts, tags, names, zero_is_none=True):
    """(parts, groups) from one tag an element. Formats of this kind write an element once for each of its groups: it is
    kept once, and belongs to all of them. names: (dimension, tag) -> name; zero_is_none: tags of 0 and below are none.
    """
    merged, groups = [], {}
    for index, ((kind, connectivity), tag) in enumerate(zip(parts, tags)):
        dimension = ELEMENTS[kind].dimension
        tag = np.asarray(tag).ravel().astype(int)
        keys = corner_keys(kind, connectivity)
        _, first, place = np.unique(keys, return_index=True, return_inverse=True)
        if len(first) == len(keys):
            place = np.arange(len(keys))
        else:
            _refuse_twice_in_one_group(file_name, place, tag)
            order = np.sort(first)
            place = np.searchsorted(order, first)[place]
            connectivity = connectivity[order]
        merged.append((kind, connectivity))
        for number in np.unique(tag[tag > 0] if zero_is_none else tag).tolist():
            name = names.get((dimension, number))
            group = groups.setdefault((dimension, number), RawGroup(name or default_name(dimension, number), number))
            group.add(index, np.sort(place[tag == number]))
    return merged, [groups[key] for key in sorted(groups)]


def default_name(dimension, number):
    return f"group_{dimension}d_{number}"


def _refuse_twice_in_one_group(file_name, place, tag):
    pairs = np.unique(np.column_stack([place, tag]), axis=0)
    if len(pairs) < len(place):
        raise MeshError(f"{file_name}: {len(place) - len(pairs)} elements appear twice in one group; their volume "
                        "would count twice: remove them (Gmsh: Coherence Mesh)")
