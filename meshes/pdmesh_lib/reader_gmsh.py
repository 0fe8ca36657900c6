"""Reads .msh files: format 4 by Gmsh's own library, formats 1 and 2.2 in bulk.

meshio reads both too, but refuses a format 4 file with elements outside all physical groups, loses a name that groups
of two dimensions share, and takes one line of format 2.2 at a time. Gmsh's library in turn knows physical groups by
entity, while a line of format 2.2 may name any group.
"""
import re

import numpy as np

from .elements import ELEMENTS
from .errors import MeshError
from .raw import RawGroup, RawMesh, default_name, groups_of_tags, known_part, places_of
from .text import number_of, numbers_of, read_text

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
        head = file.read(200).removeprefix(b"\xef\xbb\xbf")
    if head.lstrip().startswith(b"$NOD"):
        return 1.0, True
    found = re.match(rb"\s*\$MeshFormat\s+([\d.]+)\s+(\d)", head)
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
    _unite_partitions(file_name, model)
    tags, coordinates, _ = model.mesh.getNodes()
    if not len(tags):
        raise MeshError(f"{file_name}: no nodes; was it meshed (gmsh -2 or -3), and not saved empty?")
    place = places_of(tags.astype(np.int64), file_name)
    parts, groups = [], {}
    for dimension, entity in model.getEntities():
        numbers = [abs(int(tag)) for tag in model.getPhysicalGroupsForEntity(dimension, entity)]
        for kind, elements, nodes in zip(*model.mesh.getElements(dimension, entity)):
            parts.append(_part(file_name, int(kind), place(nodes.astype(np.int64)).reshape(len(elements), -1)))
            for number in numbers:
                name = model.getPhysicalName(dimension, number) or default_name(dimension, number)
                group = groups.setdefault((dimension, number), RawGroup(name, number))
                group.add(len(parts) - 1, np.arange(len(elements)))
    return RawMesh(coordinates.reshape(-1, 3), parts, [groups[key] for key in sorted(groups)])


def _unite_partitions(file_name, model):
    """Makes one mesh of the partitions of a file, without their ghosts and interfaces; refuses a file of some alone."""
    partitions = [model.getPartitions(*entity).tolist() for entity in model.getEntities()]
    owners = {found[0] for found in partitions if len(found) == 1}
    _refuse_piece(file_name, owners, {number for found in partitions for number in found})
    if owners:
        model.mesh.unpartition()


def _refuse_piece(file_name, owners, named):
    if len(owners) == 1 or not named <= owners:
        raise MeshError(f"{file_name}: one piece (partition {', '.join(map(str, sorted(owners)))}) of a mesh that was "
                        "cut, not the whole; let Gmsh save one file: Mesh.PartitionSplitMeshFiles = 0")


def _part(file_name, kind, connectivity):
    if kind not in _TYPES:
        raise MeshError(f"{file_name}: elements of Gmsh's type {kind} are not supported; mesh with first or second "
                        "order elements (Mesh.ElementOrder = 1 or 2)")
    name = _TYPES[kind][0]
    if name in _ORDERS:
        connectivity = connectivity[:, _ORDERS[name]]
    return known_part(file_name, name, connectivity)


def read_msh1(file_name):
    """Format 1.0: a row of an element is `number, type, physical, elementary, number of nodes, nodes`."""
    sections = _sections(file_name, ("NOD", "ELM"))
    nodes, place = _nodes(file_name, _demanded(file_name, sections, "NOD"))
    numbers = _demanded(file_name, sections, "ELM").numbers(np.int64)
    pieces = _elements(file_name, numbers, place, counted=4, tag=2, first_node=lambda count: 5)
    return _mesh(file_name, nodes, [(kind, found, physical) for kind, found, physical, _ in pieces], {})


def read_msh2(file_name):
    """Format 2.2 as text: a row of an element is `number, type, number of tags, tags, nodes`. Tags are physical and
    elementary group, number of partitions, partitions (the first owns it, the others are negative)."""
    sections = _sections(file_name, ("PhysicalNames", "Nodes", "ParametricNodes", "Elements"))
    names = {}
    if "PhysicalNames" in sections:
        found = re.findall(r'^\s*(\d)\s+(\d+)\s+"([^"\n]*)"', sections["PhysicalNames"].text, re.M)
        names = {(int(d), int(tag)): name for d, tag, name in found}
    if "ParametricNodes" in sections:
        nodes, place = _nodes(file_name, sections["ParametricNodes"].first_columns(4))
    else:
        nodes, place = _nodes(file_name, _demanded(file_name, sections, "Nodes"))
    numbers = _demanded(file_name, sections, "Elements").numbers(np.int64)
    pieces = _elements(file_name, numbers, place, counted=2, tag=3, first_node=lambda count: 3 + count)
    owners = {int(owner) for _, _, _, rows in pieces if rows[0, 2] >= 4 for owner in np.unique(rows[:, 6])}
    _refuse_piece(file_name, owners, owners)
    return _mesh(file_name, nodes, [(kind, found, physical) for kind, found, physical, _ in pieces], names)


class _Section:
    """Lines between $NAME and $EndNAME; `line` is the number of the first."""

    def __init__(self, file_name, name, text, line):
        self.file_name, self.name, self.text, self.line = file_name, name, text, line

    def numbers(self, kind):
        """All numbers of the section."""
        found = numbers_of(self.text, kind, " ")
        if found is not None and len(found):
            return found
        values = []
        for line, row in enumerate(self.text.split("\n"), self.line):
            for word in row.split():
                try:
                    values.append(number_of(word, kind))
                except ValueError as error:
                    raise MeshError(f"{self.file_name}:{line}: ${self.name}: {error}") from None
        if not values:
            raise MeshError(f"{self.file_name}:{self.line}: ${self.name} is empty")
        return np.array(values, dtype=kind)

    def first_columns(self, count):
        """The section without what follows the first `count` numbers of each line."""
        text = "\n".join(" ".join(row.split()[:count]) for row in self.text.split("\n"))
        return _Section(self.file_name, self.name, text, self.line)


def _sections(file_name, names):
    """{name: section} of those of `names` that are there."""
    text, found = read_text(file_name), {}
    for name in names:
        start = re.search(rf"^\s*\${name}\b", text, re.M)
        end = re.compile(rf"\$End{name}\b", re.I).search(text, start.end()) if start else None
        if start and not end:
            raise MeshError(f"{file_name}: ${name} does not end; the file is not whole")
        if start:
            found[name] = _Section(file_name, name, text[start.end():end.start()], 1 + text.count("\n", 0, start.end()))
    return found


def _demanded(file_name, sections, name):
    if name not in sections:
        raise MeshError(f"{file_name}: no ${name}; was it meshed (gmsh -2 or -3) before it was saved?")
    return sections[name]


def _nodes(file_name, section):
    """(coordinates [n, 3], function from numbers of nodes to places)"""
    table = section.numbers(float)
    n_nodes = int(table[0])
    if n_nodes < 1 or len(table) != 1 + 4 * n_nodes:
        raise MeshError(f"{file_name}: ${section.name} announces {n_nodes} nodes, but holds {(len(table) - 1) / 4:g}; "
                        "the file is not whole")
    table = table[1:].reshape(-1, 4)
    return np.ascontiguousarray(table[:, 1:]), places_of(table[:, 0].astype(np.int64), file_name)


def _mesh(file_name, nodes, pieces, names):
    by_kind = {}
    for kind, found, physical in pieces:
        by_kind.setdefault(kind, []).append((found, physical))
    parts = [_part(file_name, kind, np.concatenate([found for found, _ in rows])) for kind, rows in by_kind.items()]
    tags = [np.concatenate([physical for _, physical in rows]) for rows in by_kind.values()]
    parts, groups = groups_of_tags(file_name, parts, tags, names)
    return RawMesh(nodes, parts, groups)


def _elements(file_name, numbers, place, counted, tag, first_node):
    """[(type, nodes, physical group, rows)]. counted: column of the number of tags (nodes); tag: that of the group,
    where there is one; first_node(count): that of the first node.

    Rows of one type and number of tags have one length, so that a run of them is a table: as long as the rows before
    are right, a row that begins with the same type and number of tags is one."""
    n_elements, at, done = int(numbers[0]), 1, 0
    pieces = []
    while done < n_elements:
        head = numbers[at:at + 5]
        kind, count = (int(head[1]), int(head[counted])) if len(head) > counted else (0, 0)
        if kind not in _TYPES or count < 0:
            raise MeshError(f"{file_name}: element {done + 1} is not whole, or of type {kind}, which is not supported; "
                            "mesh with first or second order elements (Mesh.ElementOrder = 1 or 2)")
        first = first_node(count)
        width = first + _TYPES[kind][1]
        rows = _run(numbers[at:at + (n_elements - done) * width], width, {1: kind, counted: count})
        if not len(rows):
            raise MeshError(f"{file_name}: $Elements announces {n_elements} elements, but holds {done}; the file is "
                            "not whole")
        nodes = place(rows[:, first:])
        if (nodes < 0).any():
            raise MeshError(f"{file_name}: elements name nodes that are not there")
        pieces.append((kind, nodes, np.abs(rows[:, tag]) if count else np.zeros(len(rows), np.int64), rows))
        at, done = at + rows.size, done + len(rows)
    return pieces


def _run(numbers, width, same, window=64):
    """The longest table of rows at the head of `numbers` that hold the values `same` in its columns; looks in ever
    larger windows, so that many short runs cost no more than a long one."""
    length, n_rows = 0, len(numbers) // width
    while length < n_rows:
        rows = numbers[length * width:min(n_rows, length + window) * width].reshape(-1, width)
        other = np.flatnonzero(np.any([rows[:, column] != value for column, value in same.items()], axis=0))
        if len(other):
            length += int(other[0])
            break
        length, window = length + len(rows), 4 * window
    return numbers[:length * width].reshape(-1, width)
