"""A finite element mesh as meshio reads it, sorted into cells (highest dimension) and groups below them."""
import contextlib
import io
from pathlib import Path

import numpy as np

from .elements import COLLAPSED, ELEMENTS, LINEAR
from .errors import MeshError

# meshio hands Gmsh's 18-node wedge through in Gmsh's order.
_GMSH_WEDGE18 = [0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11, 15, 17, 16]
_BLOCK_FIELDS = ("gmsh:physical", "block", "medit:ref", "CellEntityIds", "MaterialIds", "cell_tags", "subdomain")


class Group:
    """Elements below the dimension of the cells: list of (element type, connectivity), or single mesh nodes."""

    def __init__(self, name, parts=(), nodes=None):
        self.name = name
        self.parts = list(parts)
        self.nodes = nodes

    def corner_nodes(self):
        parts = [connectivity[:, :ELEMENTS[kind].corners].ravel() for kind, connectivity in self.parts]
        if self.nodes is not None:
            parts.append(self.nodes)
        return np.unique(np.concatenate(parts)) if parts else np.array([], int)


class Mesh:
    """nodes [n, 3]; cells: list of (element type, connectivity [m, k], block number [m]); groups; block names."""

    def __init__(self, nodes, cells, groups, block_names, dimension):
        self.nodes, self.cells, self.groups = nodes, cells, groups
        self.block_names, self.dimension = block_names, dimension


def read_mesh(file_name, block_field=None):
    raw = _read_raw(file_name)
    nodes = np.zeros((len(raw.points), 3))
    nodes[:, :raw.points.shape[1]] = raw.points
    if not np.isfinite(nodes).all():
        raise MeshError(f"{file_name}: node {np.flatnonzero(~np.isfinite(nodes).all(axis=1))[0] + 1} is not finite")
    parts = [_known(file_name, block.type, np.asarray(block.data, int)) for block in raw.cells]
    if not parts:
        raise MeshError(f"{file_name}: no elements")
    dimensions = [ELEMENTS[kind].dimension for kind, _ in parts]
    dimension = max(dimensions)
    if dimension == 0:
        raise MeshError(f"{file_name}: only points, no elements; a list of points needs no conversion but a volume "
                        "for each (`pdmesh grid` makes lattices)")
    numbers, names, group_members = _groups(file_name, raw, parts, dimensions, dimension, block_field)
    cells = [(kind, connectivity, number) for (kind, connectivity), number, d in zip(parts, numbers, dimensions)
             if d == dimension and len(connectivity)]
    _check_node_order(file_name, nodes, cells)
    _check_plane(file_name, nodes, cells, dimension)
    _check_repeated(file_name, cells)
    return Mesh(nodes, cells, group_members, names, dimension)


def _read_raw(file_name):
    import meshio
    if not Path(file_name).is_file():
        raise MeshError(f"{file_name}: no such file")
    # meshio 5.0 knows the 15-node wedge but not its dimension, and fails on it.
    getattr(meshio._mesh, "topological_dimension", {}).setdefault("wedge15", 3)
    chatter = io.StringIO()
    try:
        with contextlib.redirect_stderr(chatter), contextlib.redirect_stdout(chatter):
            return meshio.read(file_name)
    except ModuleNotFoundError as error:
        raise MeshError(f"{file_name}: reading this format needs the Python module {error.name} "
                        f"(Debian: apt install python3-{str(error.name).lower()})") from None
    except (Exception, SystemExit) as error:  # meshio raises many kinds, and exits on unknown formats
        detail = str(error) if not isinstance(error, SystemExit) else ""
        detail = " ".join((detail or chatter.getvalue() or type(error).__name__).split())
        raise MeshError(f"{file_name}: meshio cannot read it: {detail}") from None


def _known(file_name, kind, connectivity):
    if kind in COLLAPSED:
        kind, order = COLLAPSED[kind]
        return kind, connectivity[:, order]
    if kind not in ELEMENTS:
        raise MeshError(f"{file_name}: elements of type {kind} are not supported (known: "
                        f"{', '.join(sorted(list(ELEMENTS) + list(COLLAPSED)))}); mesh with first or second order "
                        "elements, in Gmsh Mesh.ElementOrder = 1 or 2")
    if kind == "wedge18" and str(file_name).endswith(".msh"):
        connectivity = connectivity[:, _GMSH_WEDGE18]
    return kind, connectivity


def _groups(file_name, raw, parts, dimensions, dimension, block_field):
    """Block number of each part's elements, names of blocks, groups of lower dimension and of points."""
    field = block_field or next((name for name in _BLOCK_FIELDS if name in raw.cell_data), None)
    if block_field and block_field not in raw.cell_data:
        raise MeshError(f"{file_name}: no element data `{block_field}` (there are: "
                        f"{', '.join(raw.cell_data) or 'none'})")
    sets = {name: members for name, members in (raw.cell_sets or {}).items() if not name.startswith("gmsh:")}
    names = {}
    if field:
        numbers = [np.asarray(values).ravel().astype(int) for values in raw.cell_data[field]]
        names = {int(tag): name for name, (tag, d) in _field_data(raw) if d == dimension}
        lower_names = {(int(tag), int(d)): name for name, (tag, d) in _field_data(raw)}
        if sets and field == "gmsh:physical":
            _check_overlap(file_name, sets, parts, dimensions, dimension)
        groups = _lower_from_sets(sets, parts, dimensions, dimension) or \
            _lower_from_tags(numbers, lower_names, parts, dimensions, dimension)
    elif any(_members(sets[name], i, parts).size for name in sets for i, d in enumerate(dimensions) if d == dimension):
        numbers, names = _numbers_from_sets(file_name, sets, parts, dimensions, dimension)
        groups = _lower_from_sets(sets, parts, dimensions, dimension)
    else:
        is_exodus = str(file_name).endswith((".e", ".exo", ".g", ".ex2"))
        numbers = [np.full(len(c), i + 1 if is_exodus else 1) for i, (_, c) in enumerate(parts)]
        groups = _lower_from_sets(sets, parts, dimensions, dimension)
    for name, members in (raw.point_sets or {}).items():
        groups.append(Group(str(name), nodes=np.asarray(members, int).ravel()))
    return [_without_zero(number) for number in numbers], names, groups


def _field_data(raw):
    return [(name, value) for name, value in raw.field_data.items() if len(np.atleast_1d(value)) == 2]


def _without_zero(numbers):
    """Elements in no group (0) become block 1 where nothing else is, else the next free number."""
    if not np.any(numbers == 0):
        return numbers
    return np.where(numbers == 0, numbers.max() + 1, numbers)


def _members(members, i, parts):
    """Indices within part i of a cell set, as an array."""
    if members is None or i >= len(members) or members[i] is None:
        return np.array([], int)
    return np.asarray(members[i], dtype=np.int64).ravel()


def _lower_from_sets(sets, parts, dimensions, dimension):
    groups = []
    for name, members in sets.items():
        chosen = [(kind, connectivity[_members(members, i, parts)])
                  for i, ((kind, connectivity), d) in enumerate(zip(parts, dimensions)) if d < dimension]
        chosen = [(kind, connectivity) for kind, connectivity in chosen if len(connectivity)]
        if chosen:
            groups.append(Group(name, chosen))
    return groups


def _lower_from_tags(numbers, lower_names, parts, dimensions, dimension):
    collected = {}
    for (kind, connectivity), number, d in zip(parts, numbers, dimensions):
        if d >= dimension:
            continue
        for tag in np.unique(number):
            if tag > 0:
                collected.setdefault((int(tag), d), []).append((kind, connectivity[number == tag]))
    return [Group(lower_names.get(key, f"group_{key[1]}d_{key[0]}"), chosen)
            for key, chosen in sorted(collected.items())]


def _check_overlap(file_name, sets, parts, dimensions, dimension):
    for i, d in enumerate(dimensions):
        owners = [name for name in sets if d == dimension and _members(sets[name], i, parts).size]
        if len(owners) > 1:
            raise MeshError(f"{file_name}: elements belong to the physical groups {' and '.join(owners)} at once; "
                            "a point has one block: give each surface (volume) to one group")


def _numbers_from_sets(file_name, sets, parts, dimensions, dimension):
    """Element sets (Abaqus) as blocks: the sets must not overlap; what is in none becomes a block of its own."""
    numbers = [np.zeros(len(connectivity), int) for _, connectivity in parts]
    names = {}
    for name, members in sets.items():
        number = len(names) + 1
        is_used = False
        for i, d in enumerate(dimensions):
            chosen = _members(members, i, parts)
            if d != dimension or not len(chosen):
                continue
            taken = np.unique(numbers[i][chosen])
            if taken[-1] > 0:
                raise MeshError(f"{file_name}: element sets {names[taken[-1]]} and {name} overlap; a point has one "
                                "block: keep sets that do not")
            numbers[i][chosen] = number
            is_used = True
        if is_used:
            names[number] = name
    rest = len(names) + 1
    return [np.where(number == 0, rest, number) for number in numbers], names


def _check_node_order(file_name, nodes, cells):
    """Second order elements: a mid-side node nearer to the middle of another edge means an unknown node order."""
    for kind, connectivity, _ in cells:
        if kind not in LINEAR:
            continue
        element = ELEMENTS[kind]
        linear = ELEMENTS[LINEAR[kind]]
        weights = linear.monomials(element.nodes) @ np.linalg.inv(linear.monomials(linear.nodes))
        sample = connectivity[:1000]
        expected = np.einsum("kc,ecd->ekd", weights, nodes[sample[:, :element.corners]])
        size = np.ptp(nodes[sample], axis=1).max(axis=1)
        off = np.abs(expected - nodes[sample]).max(axis=(1, 2))
        if np.median(off / size) > 0.2:
            raise MeshError(f"{file_name}: the nodes of the {kind} elements are in an order that is not understood "
                            "(mid-side nodes are not between their corners); convert with Gmsh to .msh first")


def _check_plane(file_name, nodes, cells, dimension):
    if dimension == 3:
        return
    used = np.unique(np.concatenate([connectivity.ravel() for _, connectivity, _ in cells]))
    extent = np.ptp(nodes[used], axis=0)
    limit = 1e-9 * extent.max()
    if extent[2] > limit:
        raise MeshError(f"{file_name}: the {'surface' if dimension == 2 else 'line'} elements do not lie in a plane "
                        f"z = constant (z spans {extent[2]:.3g} m); rotate the mesh, or mesh the volume")
    if dimension == 1 and extent[1] > limit:
        raise MeshError(f"{file_name}: the line elements do not lie on a line along x")


def _check_repeated(file_name, cells):
    """Gmsh writes an element once for each of its groups in format 2.2: its volume would count twice."""
    count = 0
    for kind, connectivity, _ in cells:
        corners = connectivity[:, :ELEMENTS[kind].corners]
        random = np.random.default_rng(1).integers(1, 2**62, size=int(corners.max()) + 1)
        with np.errstate(over="ignore"):
            keys = random[corners].sum(axis=1)
        count += len(keys) - len(np.unique(keys))
    if count:
        raise MeshError(f"{file_name}: {count} elements appear twice (in several physical groups?); their volume would "
                        "count twice: give each surface (volume) to one group")
