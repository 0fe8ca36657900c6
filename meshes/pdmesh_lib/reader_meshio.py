"""Reads what meshio reads."""
import contextlib
import io

import numpy as np

from .errors import MeshError
from .raw import RawGroup, RawMesh, groups_of_tags, known_part

_BLOCK_FIELDS = ("gmsh:physical", "block", "medit:ref", "CellEntityIds", "MaterialIds", "cell_tags", "subdomain")


def read_by_meshio(file_name, block_field=None):
    raw = _read(file_name)
    nodes = np.zeros((len(raw.points), 3))
    nodes[:, :raw.points.shape[1]] = raw.points
    parts = [known_part(file_name, block.type, np.asarray(block.data, int)) for block in raw.cells]
    field = block_field or next((name for name in _BLOCK_FIELDS if name in raw.cell_data), None)
    if block_field and block_field not in raw.cell_data:
        raise MeshError(f"{file_name}: no element data `{block_field}` (there are: "
                        f"{', '.join(raw.cell_data) or 'none'})")
    if field:
        names = {(int(tag[1]), int(tag[0])): name
                 for name, tag in raw.field_data.items() if len(np.atleast_1d(tag)) == 2}
        parts, groups = groups_of_tags(file_name, parts, raw.cell_data[field], names)
    else:
        groups = [_group(name, members) for name, members in (raw.cell_sets or {}).items()]
    node_sets = {str(name): np.asarray(members, int).ravel() for name, members in (raw.point_sets or {}).items()}
    return RawMesh(nodes, parts, groups, node_sets)


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
        remedy = "" if file_name.endswith(".msh") else (
            f"; where Gmsh can, make a .msh file of it: `gmsh {file_name} -save -format msh41 -o mesh.msh`")
        raise MeshError(f"{file_name}: meshio cannot read it: {detail.rstrip('.')}{remedy}") from None
