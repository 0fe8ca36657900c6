"""A finite element mesh: cells (elements of the highest dimension) with blocks, and groups that become node sets."""
from pathlib import Path

import numpy as np

from .elements import ELEMENTS, LINEAR
from .errors import MeshError
from .groups import blocks_and_groups
from .raw import Skip, corner_keys, middles_off
from .reader_abaqus import read_abaqus
from .reader_exodus import ENDINGS as EXODUS_ENDINGS
from .reader_exodus import is_piece, pieces_beside, read_exodus
from .reader_gmsh import read_msh1, read_msh2, read_msh4, version_of
from .reader_meshio import read_by_meshio


class Mesh:
    """nodes [n, 3]; cells: list of (element type, connectivity [m, k], block number [m]); groups; block names; notes:
    what a user should know of how the groups were understood."""

    def __init__(self, nodes, cells, groups, block_names, dimension, notes=()):
        self.nodes, self.cells, self.groups = nodes, cells, groups
        self.block_names, self.dimension, self.notes = block_names, dimension, list(notes)


def read_mesh(file_name, block_field=None, blocks=None, skip=()):
    """`block_field`: element data that numbers the blocks; `blocks`: names of the groups that are blocks, none of them
    for one block of all elements; `skip`: types of elements that are left out, as the file calls them."""
    if not Path(file_name).is_file():
        raise MeshError(f"{file_name}: no such file{pieces_beside(file_name)}")
    skip = Skip(skip)
    raw = _read_raw(str(file_name), block_field, skip)
    absent = [name for name, count in skip.counts.items() if not count]
    if absent:
        raise MeshError(f"{file_name}: --skip: no elements of type {', '.join(absent)} to leave out")
    raw.notes += [f"{count} elements of type {name} are left out" for name, count in skip.counts.items()]
    nodes = raw.nodes
    if any(len(c) and not 0 <= c.min() <= c.max() < len(nodes) for _, c in raw.parts):
        raise MeshError(f"{file_name}: elements name nodes that are not there")
    if not np.isfinite(nodes).all():
        raise MeshError(f"{file_name}: node {np.flatnonzero(~np.isfinite(nodes).all(axis=1))[0] + 1} is not finite")
    dimension = max((ELEMENTS[kind].dimension for kind, connectivity in raw.parts if len(connectivity)), default=-1)
    if dimension < 0:
        raise MeshError(f"{file_name}: no elements; mesh it first: `gmsh -2` (plane) or `gmsh -3` (solid)")
    if dimension == 0:
        raise MeshError(f"{file_name}: only points, no elements; a list of points needs no conversion but a volume "
                        "for each (`pdmesh grid` makes lattices)")
    numbers, names, groups, notes = blocks_and_groups(file_name, raw, dimension, blocks)
    notes = raw.notes + notes
    cells = [(kind, connectivity, number) for (kind, connectivity), number in zip(raw.parts, numbers)
             if ELEMENTS[kind].dimension == dimension and len(connectivity)]
    _check_node_order(file_name, nodes, cells)
    _check_plane(file_name, nodes, cells, dimension)
    _check_repeated(file_name, cells)
    return Mesh(nodes, cells, groups, names, dimension, notes)


def _read_raw(file_name, block_field, skip):
    ending = Path(file_name).suffix.lower()
    if ending == ".geo":
        raise MeshError(f"{file_name}: this is a drawing, not a mesh; mesh it first: `gmsh -2 {file_name}` (plane) or "
                        f"`gmsh -3 {file_name}` (solid) writes {file_name[:-4]}.msh")
    if is_piece(file_name) or (ending in EXODUS_ENDINGS and not block_field):
        return read_exodus(file_name, skip)
    if ending == ".inp" and not block_field:
        return read_abaqus(file_name, skip)
    version, is_text = version_of(file_name)
    if version and block_field and b"$PartitionedEntities" in Path(file_name).read_bytes():
        raise MeshError(f"{file_name}: --block-field: the mesh is cut into partitions; save it whole (Gmsh: Mesh > "
                        "Unpartition)")
    if version and not block_field:
        raw = read_msh4(file_name) if version >= 4 else None
        if raw is None and version < 4 and is_text:
            raw = read_msh1(file_name) if version < 2 else read_msh2(file_name)
        if raw is not None:
            return raw
    return read_by_meshio(file_name, block_field, skip)


def _check_node_order(file_name, nodes, cells):
    """Second order elements: a mid-side node nearer to the middle of another edge means an unknown node order."""
    for kind, connectivity, _ in cells:
        if kind in LINEAR and middles_off(kind, nodes, connectivity) > 0.2:
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
    """An element that is there twice would count twice."""
    count = 0
    for kind, connectivity, _ in cells:
        keys = corner_keys(kind, connectivity)
        count += len(keys) - len(np.unique(keys))
    if count:
        raise MeshError(f"{file_name}: {count} elements appear twice; their volume would count twice: remove the "
                        "copies (Gmsh: Coherence Mesh)")
