"""Reads .msh files: format 4 by Gmsh's own library, format 2.2 in bulk.

meshio reads both too, but refuses a format 4 file with elements outside all physical groups, loses a name that groups
of two dimensions share, and takes one line of format 2.2 at a time. Gmsh's library in turn knows physical groups by
entity, while a line of format 2.2 may name any group.
"""
import re

import numpy as np

from .elements import ELEMENTS
from .errors import MeshError
from .raw import RawGroup, RawMesh, default_name, groups_of_tags, known_part

# Gmsh's numbers of element types (https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format): name, number of nodes.
_TYPES = {1: ("line", 2), 2: ("triangle", 3), 3: ("quad", 4), 4: ("tetra", 4), 5: ("hexahedron", 8), 6: ("wedge", 6),
          7: ("pyramid", 5), 8: ("line3", 3), 9: ("triangle6", 6), 10: ("quad9", 9), 11: ("tetra10", 10),
          12: ("hexahedron27", 27), 13: ("wedge18", 18), 14: ("pyramid14", 14), 15: ("vertex", 1), 16: ("quad8", 8),
          17: ("hexahedron20", 20), 18: ("wedge15", 15), 19: ("pyramid13", 13)}
# Corner numbers of the edges and faces in the order of their middle nodes (ibid., "Node ordering").
_TETRA_EDGES = [(0, 1), (1, 2), (2, 0), (3, 0), (2, 3), (1, 3)]
_WEDGE_EDGES = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 4), (2, 5), (3, 4), (3, 5), (4, 5)]
_WEDGE_FACES = [(0, 1, 4, 3), (0, 3, 5, 2), (1, 2, 5, 4)]
_HEXAHEDRON_EDGES = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)]
_HEXAHEDRON_FACES = [(0, 3, 2, 1), (0, 1, 5, 4), (0, 4, 7, 3), (1, 2, 6, 5), (2, 3, 7, 6), (4, 5, 6, 7)]


def _order(name, middles):
    """For each node in VTK's order its place in Gmsh's: the nodes of the reference element sit in the middles."""
    nodes = ELEMENTS[name].nodes
    corners = range(ELEMENTS[name].corners)
    places = np.array([nodes[list(chosen)].mean(axis=0) for chosen in [(i,) for i in corners] + middles])
    return np.linalg.norm(nodes[:, None] - places[None], axis=2).argmin(axis=1)


# Types that are not here have one order.
_ORDERS = {"tetra10": _order("tetra10", _TETRA_EDGES), "wedge15": _order("wedge15", _WEDGE_EDGES),
           "wedge18": _order("wedge18", _WEDGE_EDGES + _WEDGE_FACES),
           "hexahedron20": _order("hexahedron20", _HEXAHEDRON_EDGES),
           "hexahedron27": _order("hexahedron27", _HEXAHEDRON_EDGES + _HEXAHEDRON_FACES + [tuple(range(8))])}


def version_of(file_name):
    """(version, is text) of a .msh file of Gmsh; (None, False) of anything else."""
    with open(file_name, "rb") as file:
        found = re.match(rb"\s*\$MeshFormat\s+([\d.]+)\s+(\d)", file.read(200))
    return (float(found.group(1)), found.group(2) == b"0") if found else (None, False)


def read_msh4(file_name):
    """Format 4.x. None where Gmsh's Python library is not installed."""
    try:
        import gmsh
    except ImportError:
        return None
    gmsh.initialize(readConfigFiles=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        try:
            gmsh.open(str(file_name))
            return _from_model(file_name, gmsh.model)
        except MeshError:
            raise
        except Exception as error:  # the library raises nothing narrower
            raise MeshError(f"{file_name}: Gmsh cannot read it ({error}); is it whole? Make it again with "
                            "`gmsh -2` (plane) or `gmsh -3` (solid)") from None
    finally:
        gmsh.finalize()


def _from_model(file_name, model):
    tags, coordinates, _ = model.mesh.getNodes()
    if not len(tags):
        raise MeshError(f"{file_name}: no nodes; was it meshed (gmsh -2 or -3), and not saved empty?")
    place = np.full(int(tags.max()) + 1, -1, dtype=np.int64)
    place[tags] = np.arange(len(tags))
    parts, groups = [], {}
    for dimension, entity in model.getEntities():
        numbers = [abs(int(tag)) for tag in model.getPhysicalGroupsForEntity(dimension, entity)]
        for kind, elements, nodes in zip(*model.mesh.getElements(dimension, entity)):
            parts.append(_part(file_name, int(kind), place[nodes.astype(np.int64)].reshape(len(elements), -1)))
            for number in numbers:
                name = model.getPhysicalName(dimension, number) or default_name(dimension, number)
                group = groups.setdefault((dimension, number), RawGroup(name, number))
                group.add(len(parts) - 1, np.arange(len(elements)))
    return RawMesh(coordinates.reshape(-1, 3), parts, [groups[key] for key in sorted(groups)])


def _part(file_name, kind, connectivity):
    if kind not in _TYPES:
        raise MeshError(f"{file_name}: elements of Gmsh's type {kind} are not supported; mesh with first or second "
                        "order elements (Mesh.ElementOrder = 1 or 2)")
    name = _TYPES[kind][0]
    if name in _ORDERS:
        connectivity = connectivity[:, _ORDERS[name]]
    return known_part(file_name, name, connectivity)


def read_msh2(file_name):
    """Format 2.2 as text."""
    try:
        with open(file_name, encoding="latin-1") as file:
            sections = _sections(file_name, file.read())
    except OSError as error:
        raise MeshError(f"{file_name}: cannot be read: {error.strerror}") from None
    names = {(int(d), int(tag)): name
             for d, tag, name in re.findall(r'^\s*(\d)\s+(\d+)\s+"([^"\n]*)"', sections.get("PhysicalNames", ""), re.M)}
    table = _numbers(file_name, "Nodes", sections, float)
    n_nodes = int(table[0])
    if n_nodes < 1 or len(table) != 1 + 4 * n_nodes:
        raise MeshError(f"{file_name}: $Nodes announces {n_nodes} nodes, but holds {(len(table) - 1) / 4:g}; the file "
                        "is not whole")
    table = table[1:].reshape(-1, 4)
    tags = table[:, 0].astype(np.int64)
    place = np.full(int(tags.max()) + 1, -1, dtype=np.int64)
    place[tags] = np.arange(n_nodes)
    parts, physical = _elements(file_name, _numbers(file_name, "Elements", sections, np.int64), place)
    parts, groups = groups_of_tags(file_name, parts, physical, names)
    return RawMesh(np.ascontiguousarray(table[:, 1:]), parts, groups)


def _sections(file_name, text):
    found = {}
    for name in ("PhysicalNames", "Nodes", "Elements"):
        first = text.find(f"${name}")
        last = text.find(f"$End{name}", first)
        if first >= 0 and last < 0:
            raise MeshError(f"{file_name}: ${name} does not end; the file is not whole")
        if first >= 0:
            found[name] = text[first + len(name) + 1:last]
    return found


def _numbers(file_name, name, sections, kind):
    if name not in sections:
        raise MeshError(f"{file_name}: no ${name}; was it meshed (gmsh -2 or -3) before it was saved?")
    text = sections.pop(name)
    try:
        # An error of the text ends the conversion early with a mere warning in numpy 1.24.
        numbers = np.fromstring(text, dtype=kind, sep=" ")
    except ValueError:
        numbers = np.array([])
    if not len(numbers):
        raise MeshError(f"{file_name}: ${name} holds something else than numbers")
    return numbers


def _elements(file_name, numbers, place):
    """Parts and their physical tags. Lines of one type and number of tags have one length, so that a run of them is a
    table: as long as the rows before are right, a row that begins with the same type and number of tags is one."""
    n_elements, at, done = int(numbers[0]), 1, 0
    pieces = {}
    while done < n_elements:
        kind, n_tags = (int(number) for number in (numbers[at + 1:at + 3] if at + 3 <= len(numbers) else (0, 0)))
        if kind not in _TYPES:
            raise MeshError(f"{file_name}: element {done + 1} is not whole, or of type {kind}, which is not supported; "
                            "mesh with first or second order elements (Mesh.ElementOrder = 1 or 2)")
        width = 3 + n_tags + _TYPES[kind][1]
        rows = _run(numbers[at:at + (n_elements - done) * width], width, kind, n_tags)
        if not len(rows):
            raise MeshError(f"{file_name}: $Elements announces {n_elements} elements, but holds {done}; the file is "
                            "not whole")
        nodes = rows[:, 3 + n_tags:]
        if nodes.min() < 0 or nodes.max() >= len(place) or (place[nodes] < 0).any():
            raise MeshError(f"{file_name}: elements name nodes that are not there")
        tags = rows[:, 3] if n_tags else np.zeros(len(rows), np.int64)
        pieces.setdefault(kind, []).append((place[nodes], np.abs(tags)))
        at, done = at + rows.size, done + len(rows)
    parts = [_part(file_name, kind, np.concatenate([nodes for nodes, _ in found])) for kind, found in pieces.items()]
    return parts, [np.concatenate([tags for _, tags in found]) for found in pieces.values()]


def _run(numbers, width, kind, n_tags, window=64):
    """The longest table of rows of this kind at the head of `numbers`; looks in ever larger windows, so that many short
    runs cost no more than a long one."""
    length, n_rows = 0, len(numbers) // width
    while length < n_rows:
        rows = numbers[length * width:min(n_rows, length + window) * width].reshape(-1, width)
        other = np.flatnonzero((rows[:, 1] != kind) | (rows[:, 2] != n_tags))
        if len(other):
            length += int(other[0])
            break
        length, window = length + len(rows), 4 * window
    return numbers[:length * width].reshape(-1, width)
