"""What the commands of pdmesh that write a text discretization have in common: options, files, report."""
import os
import re
import sys
from pathlib import Path

import numpy as np

from .errors import MeshError
from .expressions import named, select, variables_of
from .points import mesh_of_node_set, report, write_node_set, write_points


def add_common(command):
    command.add_argument("--thickness", type=float, metavar="T",
                         help="thickness of a plane mesh, m (1D: cross section, m2); default 1")
    command.add_argument("--node-set", action="append", default=[], metavar="'NAME: EXPRESSION'",
                         help="node set by a condition in x, y, z, r, block, volume, as 'top: y > 0.099 and x < 0.1'; "
                              "written to NAME.txt beside the mesh; may be repeated")
    command.add_argument("--horizon", type=float, metavar="H", help="horizon (m) to judge the spacing by")
    command.add_argument("--quiet", action="store_true", help="no report; warnings stay")


def finish(options, points, facts, warnings, heading, from_grid=False):
    """Node sets by expression, files, report: what convert and grid have in common."""
    if not from_grid:
        for text in options.node_set:
            name, expression = named(text)
            if name in points.node_sets:
                raise MeshError(f"--node-set {name}: the mesh has a group of this name; choose another")
            points.node_sets[name] = select(expression, variables_of(points))
    folder = Path(options.output).parent
    files = {}
    for name in points.node_sets:
        file = folder / (re.sub(r"[^\w.-]+", "_", name) + ".txt")
        if file == Path(options.output) or file in files.values():
            raise MeshError(f"node set {name}: its file {file} is already taken; rename the group or the mesh")
        # Its name is that of a group of the mesh, which nobody has thought of as a file.
        if os.path.lexists(file) and (file.is_symlink() or mesh_of_node_set(file)[0] is None):
            raise MeshError(f"node set {name}: {file} is there already and is no node set that pdmesh wrote; move it "
                            "away, or write the mesh into a folder of its own")
        files[name] = file
    # repr gives the shortest text that reads back to the same number, so nothing is lost in the file.
    write_points(points, options.output, [f"pdmesh {heading}"])
    mesh = Path(options.output).name
    for name, file in files.items():
        _, other = mesh_of_node_set(file)
        if other not in ("", mesh) and (folder / other).is_file():
            warnings = warnings + [f"{file} was the node set of {other} and now is that of {mesh}; write each mesh "
                                   "into a folder of its own"]
        write_node_set(points.node_sets[name], file, name, len(points), mesh)
    more_facts, more_warnings = report(points, options.horizon)
    if not options.quiet:
        print("\n".join([f"{options.output}: pdmesh {heading}"] + ["  " + fact for fact in facts + more_facts]))
        if files:
            print("  written: " + ", ".join(str(file) for file in [options.output, *files.values()]))
    for warning in warnings + more_warnings:
        print(f"pdmesh: warning: {warning}", file=sys.stderr)


def positive(options, *names):
    for name in names:
        value = getattr(options, name, None)
        if value is not None and not (value > 0 and np.isfinite(value)):
            raise MeshError(f"--{name.replace('_', '-')} must be positive, not {value:g}")


def measure_of(options, dimension):
    if dimension == 3 and options.thickness is not None:
        raise MeshError("--thickness is for plane meshes; this one is three-dimensional")
    return 1.0 if options.thickness is None else options.thickness
