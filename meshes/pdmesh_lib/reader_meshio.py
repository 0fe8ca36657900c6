"""Reads what meshio reads."""
import contextlib
import io

import numpy as np

from .errors import MeshError
from .raw import RawGroup, RawMesh, groups_of_tags, known_part

# Element data that numbers the blocks: that where 0 says "none", and that where it is a number as any other.
_BLOCK_FIELDS = ("gmsh:physical", "medit:ref", "block", "CellEntityIds", "MaterialIds", "cell_tags", "subdomain")
_ZERO_IS_NONE = _BLOCK_FIELDS[:2]


def read_by_meshio(file_name, block_field, skip):
    raw = _read(file_name)
    nodes = np.zeros((len(raw.points), 3))
    nodes[:, :raw.points.shape[1]] = raw.points
    kept = [index for index, block in enumerate(raw.cells) if not skip.wants(block.type)]
    for block in raw.cells:
        if skip.wants(block.type):
            skip.count(block.type, len(block.data))
    parts = [known_part(file_name, block.type, np.asarray(block.data, int),
                        f", or leave these out by --skip {block.type}")
             for block in (raw.cells[index] for index in kept)]
    field = block_field or next((name for name in _BLOCK_FIELDS if name in raw.cell_data), None)
    if block_field and block_field not in raw.cell_data:
        raise MeshError(f"{file_name}: no element data `{block_field}` (there are: "
                        f"{', '.join(raw.cell_data) or 'none'})")
    if field:
        names = {(int(tag[1]), int(tag[0])): name
                 for name, tag in raw.field_data.items() if len(np.atleast_1d(tag)) == 2}
        tags = [_whole(file_name, field, raw.cell_data[field][index], len(raw.cells[index].data)) for index in kept]
        parts, groups = groups_of_tags(file_name, parts, tags, names, field in _ZERO_IS_NONE)
    else:
        groups = [_group(name, [members[index] for index in kept]) for name, members in (raw.cell_sets or {}).items()]
    node_sets = {str(name): np.asarray(members, int).ravel() for name, members in (raw.point_sets or {}).items()}
    return RawMesh(nodes, parts, groups, node_sets)


def _whole(file_name, field, values, n_elements):
    """Element data as whole numbers, one an element."""
    values = np.asarray(values)
    if values.size != n_elements or not np.issubdtype(values.dtype, np.number):
        raise MeshError(f"{file_name}: element data `{field}` is not one number an element; it cannot number blocks")
    values = values.ravel()
    bad = np.flatnonzero(~np.isfinite(values) | (values != np.floor(values)))
    if len(bad):
        raise MeshError(f"{file_name}: element data `{field}` is {values[bad[0]]:g} at element {bad[0] + 1}, and "
                        "blocks have whole numbers; choose another by --block-field")
    return values.astype(np.int64)


def _group(name, members):
    group = RawGroup(str(name))
    for part, indices in enumerate(members):
        if indices is not None:
            group.add(part, indices)
    return group


def _read(file_name):
    import meshio
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
        remedy = f"; where Gmsh can, make a .msh file of it: `gmsh {file_name} -save -format msh41 -o mesh.msh`"
        if file_name.lower().endswith(".msh"):
            remedy = "; save it in Gmsh's format 4.1 (Mesh.MshFileVersion = 4.1)"
        raise MeshError(f"{file_name}: meshio cannot read it: {detail.rstrip('.')}{remedy}") from None
