"""Reads Exodus files: blocks with their numbers and names, node sets, side sets.

meshio's reader gives neither numbers nor side sets, and takes the nodes of second order elements as VTK orders them.
Format: Schoof & Yarberry, EXODUS II: A Finite Element Data Model, SAND92-2137 (node orders and sides of elements).
"""
import re
import warnings
from pathlib import Path

import numpy as np

from .errors import MeshError
from .raw import RawGroup, RawMesh, known_part, middles_off

ENDINGS = (".e", ".exo", ".g", ".ex2", ".exoII", ".gen")
_KINDS = {
    ("SPHERE", 1): "vertex", ("CIRCLE", 1): "vertex", ("LINE", 2): "line", ("LINE", 3): "line3",
    ("TRI", 3): "triangle", ("TRI", 6): "triangle6", ("QUAD", 4): "quad", ("QUAD", 8): "quad8", ("QUAD", 9): "quad9",
    ("TET", 4): "tetra", ("TET", 10): "tetra10", ("WEDGE", 6): "wedge", ("WEDGE", 15): "wedge15",
    ("PYRAMID", 5): "pyramid", ("HEX", 8): "hexahedron", ("HEX", 20): "hexahedron20", ("HEX", 27): "hexahedron27"}
_SHAPES = {"TRIANGLE": "TRI", "TRISHELL": "TRI", "SHELL": "QUAD", "TETRA": "TET", "HEXAHEDRON": "HEX", "BAR": "LINE",
           "BEAM": "LINE", "TRUSS": "LINE", "EDGE": "LINE"}
# For each node in VTK's order its place in Exodus' order: upright edges come before those of the top.
_ORDERS = {"wedge15": [0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11],
           "hexahedron20": [*range(12), 16, 17, 18, 19, 12, 13, 14, 15],
           "hexahedron27": [*range(12), 16, 17, 18, 19, 12, 13, 14, 15, 23, 24, 25, 26, 21, 22, 20]}
# Corners of side 1, 2 ... of an element. The first two sides of shells are themselves.
_SIDES = {
    "TRI": [(0, 1), (1, 2), (2, 0)], "QUAD": [(0, 1), (1, 2), (2, 3), (3, 0)],
    "TRISHELL": [(0, 1, 2), (0, 2, 1), (0, 1), (1, 2), (2, 0)],
    "SHELL": [(0, 1, 2, 3), (0, 3, 2, 1), (0, 1), (1, 2), (2, 3), (3, 0)],
    "TET": [(0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)],
    "WEDGE": [(0, 1, 4, 3), (1, 2, 5, 4), (0, 3, 5, 2), (0, 2, 1), (3, 4, 5)],
    "PYRAMID": [(0, 1, 4), (1, 2, 4), (2, 3, 4), (0, 4, 3), (0, 3, 2, 1)],
    "HEX": [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)]}
_SIDE_KINDS = {2: "line", 3: "triangle", 4: "quad"}


_PIECE = re.compile(r"\.(\d+)\.(\d+)$")


def is_piece(file_name):
    """Whether a name is that of a piece of a mesh that was cut for several processes, as mesh.g.2.0."""
    return _PIECE.search(str(file_name)) is not None


def pieces_beside(file_name):
    """What to say of a mesh that is not there, but in pieces; empty where it is not."""
    path = Path(file_name)
    pieces = sorted(found.name for found in path.parent.glob(path.name + ".*") if is_piece(found.name))
    return f", but its pieces are, {pieces[0]} ...: {_JOIN.format(pieces[0])}" if pieces else ""


_JOIN = "join them by SEACAS' program, `epu -auto {}`"


def _refuse_piece(file_name, data):
    sizes = {name: len(dimension) for name, dimension in data.dimensions.items()}
    found = _PIECE.search(file_name)
    n_pieces = max(sizes.get("num_processors", 1), int(found.group(1)) if found else 1)
    if n_pieces > 1 or sizes.get("num_elems_global", 0) > sizes.get("num_elem", 0):
        raise MeshError(f"{file_name}: a piece of a mesh that was cut for {n_pieces} processes, not the whole; "
                        + _JOIN.format(Path(file_name).name))


def read_exodus(file_name, skip):
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of another numpy at its build
            import netCDF4
    except ImportError:
        raise MeshError(f"{file_name}: Exodus files need the Python module netCDF4 (Debian: apt install "
                        "python3-netcdf4)") from None
    try:
        with netCDF4.Dataset(file_name) as data:
            data.set_auto_mask(False)
            _refuse_piece(file_name, data)
            return _Reader(file_name, data, skip).mesh()
    except (OSError, KeyError, IndexError) as error:
        raise MeshError(f"{file_name}: not a whole Exodus file: {error}") from None


def _in_order(kind, nodes, connectivity):
    """In VTK's order; meshio writes that one into Exodus files, too."""
    if kind not in _ORDERS:
        return connectivity
    ordered = connectivity[:, _ORDERS[kind]]
    return min(ordered, connectivity, key=lambda candidate: middles_off(kind, nodes, candidate))


class _Reader:
    def __init__(self, file_name, data, skip):
        self.file_name, self.data, self.skip = file_name, data, skip
        self.blocks = []  # (shape, connectivity as in the file, number of the part; None where it is left out)

    def mesh(self):
        nodes = self._nodes()
        if "eb_prop1" not in self.data.variables:
            raise MeshError(f"{self.file_name}: no element blocks")
        parts, groups = [], []
        for index, (number, name) in enumerate(zip(*self._named("eb", "block"))):
            variable = self.data.variables.get(f"connect{index + 1}")
            if variable is None or not len(variable):
                continue
            connectivity = variable[:].astype(np.int64) - 1
            if self.skip.wants(variable.elem_type.strip()):
                self.skip.count(variable.elem_type.strip(), len(connectivity))
                self.blocks.append(("", connectivity, None))
                continue
            shape, kind = self._kind(variable.elem_type, connectivity.shape[1])
            self.blocks.append((shape, connectivity, len(parts)))
            ordered = _in_order(kind, nodes, connectivity)
            group = RawGroup(name, number)
            group.add(len(parts), np.arange(len(connectivity)))
            parts.append(known_part(self.file_name, kind, ordered))
            groups.append(group)
        sections = list(groups)
        for i, (_, name) in enumerate(zip(*self._named("ss", "surface"))):
            group = RawGroup(name)
            for sides in self._sides(i + 1, group):
                group.add(len(parts), np.arange(len(sides)))
                parts.append((_SIDE_KINDS[sides.shape[1]], sides))
            groups.append(group)
        mesh = RawMesh(nodes, parts, [group for group in groups if group.members], self._node_sets(len(nodes)))
        mesh.sections = sections
        return mesh

    def _node_sets(self, n_nodes):
        sets = {}
        for i, (number, name) in enumerate(zip(*self._named("ns", "nodelist"))):
            if f"node_ns{i + 1}" not in self.data.variables:
                continue
            nodes = self.data.variables[f"node_ns{i + 1}"][:].astype(np.int64) - 1
            if len(nodes) and not 0 <= nodes.min() <= nodes.max() < n_nodes:
                raise MeshError(f"{self.file_name}: node set {name} names nodes that are not there")
            sets[f"{name}_{number}" if name in sets else name] = nodes
        return sets

    def _nodes(self):
        variables = self.data.variables
        if "coord" in variables:
            found = [row for row in variables["coord"][:]]
        else:
            found = [variables[name][:] for name in ("coordx", "coordy", "coordz") if name in variables]
        nodes = np.zeros((len(found[0]), 3))
        nodes[:, :len(found)] = np.column_stack(found)
        return nodes

    def _named(self, prefix, default):
        """Numbers and names of the blocks (eb), node sets (ns) or side sets (ss)."""
        variables = self.data.variables
        if f"{prefix}_prop1" not in variables:
            return [], []
        numbers = variables[f"{prefix}_prop1"][:].astype(int).tolist()
        names = [""] * len(numbers)
        if f"{prefix}_names" in variables:
            names = [b"".join(row).split(b"\0")[0].decode("utf-8", "replace").strip()
                     for row in variables[f"{prefix}_names"][:]]
        return numbers, [name or f"{default}_{number}" for name, number in zip(names, numbers)]

    def _kind(self, text, n_nodes):
        """(shape, as its sides are numbered, element type of ELEMENTS)"""
        name = re.sub(r"[\d_]+$", "", text.strip().upper())
        shape = _SHAPES.get(name, name)
        if shape == "QUAD" and n_nodes in (3, 6):  # shells with three sides
            shape = "TRI"
        if (shape, n_nodes) not in _KINDS:
            raise MeshError(f"{self.file_name}: elements {text} with {n_nodes} nodes are not supported; mesh with "
                            "first or second order triangles, quads, tetrahedra, wedges, pyramids or hexahedra, or "
                            f"leave these out by --skip {text.strip()}")
        kind = _KINDS[shape, n_nodes]
        # In space the sides of triangles are those of shells; quads have edges alone (ex_get_side_set_node_list).
        if shape == "TRI" and (name in ("SHELL", "TRISHELL") or len(self.data.dimensions["num_dim"]) == 3):
            return "TRISHELL", kind
        return ("SHELL" if name == "SHELL" else shape), kind

    def _sides(self, number, group):
        """Corner nodes of a side set: [m, 2], [m, 3] and [m, 4], those that there are. Faces of shells are the shells:
        they go to the group."""
        if f"elem_ss{number}" not in self.data.variables:
            return []
        elements = self.data.variables[f"elem_ss{number}"][:].astype(np.int64) - 1
        sides = self.data.variables[f"side_ss{number}"][:].astype(np.int64) - 1
        first, found = 0, {}
        for shape, connectivity, part in self.blocks:
            mine = (elements >= first) & (elements < first + len(connectivity))
            for side in np.unique(sides[mine]) if part is not None else []:
                if not 0 <= side < len(_SIDES.get(shape, [])):
                    raise MeshError(f"{self.file_name}: side set {group.name} names side {side + 1} of a {shape} "
                                    "element")
                if shape in ("SHELL", "TRISHELL") and side < 2:
                    group.add(part, elements[mine & (sides == side)] - first)
                    continue
                corners = connectivity[elements[mine & (sides == side)] - first][:, _SIDES[shape][side]]
                found.setdefault(corners.shape[1], []).append(corners)
            first += len(connectivity)
        if len(elements) and not 0 <= elements.min() <= elements.max() < first:
            raise MeshError(f"{self.file_name}: side set {group.name} names elements that are not there")
        return [np.concatenate(corners) for corners in found.values()]
