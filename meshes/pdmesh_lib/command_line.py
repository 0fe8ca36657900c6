"""The command line of pdmesh."""
import argparse
import os
import re
import sys
from pathlib import Path

import numpy as np

from . import lattice
from .command_options import add_common, finish, measure_of, positive
from .convert import convert, group_points
from .errors import MeshError
from .expressions import named, select, variables_of
from .grains_command import add_grains
from .mesh import read_mesh
from .outline_command import add_outline
from .points import export_points, read_node_set, read_points, report

_EPILOG = """sample runs
  pdmesh convert plate.msh plate.txt --thickness 0.004 --layer-depth 0.005 --horizon 0.005
      points at the centroids of the elements of a Gmsh mesh; every physical line group becomes a node set: the points
      within 5 mm of it
  pdmesh convert part.inp part.txt --at nodes --scale 1e-3
      points at the nodes of an Abaqus mesh in millimetres
  pdmesh grid box --size 0.2 0.1 --spacing 0.001 --thickness 0.004 --node-set "top: y > 0.097" -o plate.txt
  pdmesh grid disc --radius 0.05 --spacing 0.001 --notch 0 0 0.05 0 0.004 --horizon 0.003015 -o disc.txt
  pdmesh grid tube --radius 0.02 --inner-radius 0.01 --length 0.1 --spacing 0.001 -o tube.txt
  pdmesh grains plate.txt --size 2e-5 --width 1e-6 -o polycrystal.txt
      grains of block 1 in a Voronoi structure; their boundaries become block 2
  pdmesh outline section.png --pixel 2e-6 -o voids.txt
      outlines of the dark parts of an image, for `Voids` of a deck
  pdmesh info plate.txt top.txt bottom.txt --horizon 0.005
  pdmesh export plate.txt plate.vtu

A text discretization has one point a line, `x y z block volume` (m, m3); a node set has point numbers, counted from 1.
"""


def main(arguments=None):
    parser = _parser()
    options = parser.parse_args(arguments)
    try:
        options.run(options)
    except MeshError as error:
        print(f"pdmesh: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


class _Parser(argparse.ArgumentParser):
    """Takes -5e-05 for a number; argparse by itself takes it for an option."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self._negative_number_matcher = re.compile(r"-(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


def _parser():
    parser = _Parser(prog="pdmesh", description="Meshes for pdrun.", epilog=_EPILOG,
                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, metavar="convert | grid | grains | outline | info | export")
    _add_convert(commands)
    _add_grid(commands)
    add_grains(commands)
    add_outline(commands)
    info = commands.add_parser("info", help="what a mesh or a text discretization holds")
    info.add_argument("mesh", help="text discretization (.txt) or any mesh that meshio reads")
    info.add_argument("node_sets", nargs="*", help="node set files to check against it")
    info.add_argument("--horizon", type=float, help="horizon (m) to judge the spacing by")
    _add_reading(info)
    info.set_defaults(run=_info)
    export = commands.add_parser("export", help="write points for ParaView or any format of meshio")
    export.add_argument("mesh", help="text discretization")
    export.add_argument("output", help="file, format by extension: .vtu, .vtk, .msh, .xdmf ...")
    export.add_argument("--node-sets", nargs="*", default=[], metavar="FILE", help="node sets to mark by 0 and 1")
    export.set_defaults(run=_export)
    return parser


def _add_convert(commands):
    command = commands.add_parser(
        "convert", help="finite element mesh to points with volumes",
        description="Points at element centroids, with exact volumes (curved second order elements too), or at nodes, "
                    "with their exact share of the adjacent elements (corner nodes of second order elements). Blocks "
                    "are physical groups, element blocks, or the element sets that have a *SECTION (without sections: "
                    "all sets that do not overlap); other groups become node sets. Points of a mesh that is a lattice "
                    "but for rounding (1e-8 of its spacing) are put onto it: pdrun is quicker there.")
    command.add_argument("mesh", help="anything meshio reads: .msh (2.2, 4.1), .vtu, .inp (Abaqus), .e (Exodus) ...")
    command.add_argument("output", help="text discretization to write")
    command.add_argument("--at", choices=["centroids", "nodes"], default="centroids", help="where the points are")
    command.add_argument("--scale", type=float, default=1.0, metavar="S", help="factor on coordinates: 1e-3 from mm")
    command.add_argument("--layer-depth", action="append", default=[], metavar="[GROUP=]D",
                         help="node sets of groups take the points within D metres of the group; without it those of "
                              "the elements that have the group as a side (--at nodes: its nodes)")
    _add_reading(command)
    add_common(command)
    command.set_defaults(run=_convert)


def _add_reading(command):
    command.add_argument("--blocks", metavar="GROUP,GROUP...",
                         help="groups that are blocks; the others become node sets")
    command.add_argument("--one-block", action="store_true",
                         help="all elements are one block, and all groups become node sets")
    command.add_argument("--block-field", metavar="NAME", help="element data that numbers the blocks")
    command.add_argument("--skip", metavar="TYPE,TYPE...",
                         help="types of elements that are left out, as the file calls them: COH3D8, CONN3D2 ...")


def _add_grid(commands):
    command = commands.add_parser(
        "grid", help="lattice of points in a box, disc, ring, cylinder or tube",
        description="Points at the centres of lattice cells. Round shapes take the cells whose centres are inside; "
                    "--fit-volume makes their volumes add up to the exact one.")
    command.add_argument("shape", choices=["box", "disc", "ring", "cylinder", "tube"])
    command.add_argument("-o", "--output", required=True, help="text discretization to write")
    command.add_argument("--spacing", type=float, nargs="+", required=True, metavar="DX",
                         help="one, or one a direction; adjusted so that whole cells fit")
    command.add_argument("--size", type=float, nargs="+", metavar="L", help="box: edges; one makes it 1D, two 2D")
    command.add_argument("--origin", type=float, nargs="+", default=[0.0], metavar="X",
                         help="box: lowest corner; round shapes: centre (z: lower end); default 0 0 0")
    command.add_argument("--radius", type=float, metavar="R")
    command.add_argument("--inner-radius", type=float, metavar="R")
    command.add_argument("--length", type=float, metavar="L", help="cylinder, tube: length along z")
    command.add_argument("--hole", type=float, nargs=3, action="append", default=[], metavar=("X", "Y", "R"),
                         help="remove a circular hole (through z)")
    command.add_argument("--notch", type=float, nargs=5, action="append", default=[],
                         metavar=("X0", "Y0", "X1", "Y1", "WIDTH"), help="remove a slot between two points")
    command.add_argument("--wedge", type=float, nargs=4, action="append", default=[],
                         metavar=("X", "Y", "DIRECTION", "ANGLE"),
                         help="remove the sector with its tip at X Y that opens ANGLE degrees about DIRECTION degrees")
    command.add_argument("--remove", action="append", default=[], metavar="EXPRESSION", help="remove by a condition")
    command.add_argument("--block", action="append", default=[], metavar="'NUMBER: EXPRESSION'",
                         help="give points another block than 1, as '2: x > 0.1'")
    command.add_argument("--jitter", type=float, default=0.0, metavar="A",
                         help="move points by up to A spacings at random, A < 0.5; volumes stay")
    command.add_argument("--seed", type=int, default=1, help="of the jitter")
    command.add_argument("--turn", type=float, default=0.0, metavar="DEGREES",
                         help="turn the finished lattice about z through --origin; rows of points then favour other "
                              "directions. Expressions see it before")
    command.add_argument("--fit-volume", action="store_true", help="round shapes: scale volumes to the exact sum")
    add_common(command)
    command.set_defaults(run=_grid)


def _convert(options):
    positive(options, "scale", "thickness", "horizon")
    depths = _layer_depths(options.layer_depth)
    mesh = _read(options)
    result = convert(mesh, options.at == "nodes", options.thickness, options.scale)
    points = result.points
    largest_motion = lattice.onto_lattice(points)
    unknown = set(depths) - {None} - {group.name for group in mesh.groups}
    if unknown:
        raise MeshError(f"--layer-depth: {options.mesh} has no group {', '.join(sorted(unknown))} (there are: "
                        f"{', '.join(group.name for group in mesh.groups) or 'none'})")
    for group in mesh.groups:
        points.node_sets[group.name] = group_points(result, group, depths.get(group.name, depths.get(None)))
    facts = [f"mesh volume {result.mesh_volume:.12g} m3, points' volume differs by "
             f"{abs(points.volume.sum() / result.mesh_volume - 1):.1e} of it"] + mesh.notes
    if largest_motion:
        facts.append(f"points are on a lattice to {largest_motion:.1e} of its spacing: put onto it")
    warnings = []
    if result.slivers:
        warnings.append(f"{result.slivers} elements are slivers (volume below a twentieth of that of an element with "
                        "equal edges as long as their longest); points there lie close together, and stable steps get "
                        "small: mesh more evenly")
    if result.stretch > 2:
        warnings.append(f"elements are stretched (edges up to {result.longest_edge:.4g} m): points lie farther apart "
                        f"along them than their volumes tell, 3 spacings need a horizon of "
                        f"{3 * result.longest_edge:.4g} m")
    if mesh.dimension == 2 and options.thickness is None:
        warnings.append("no --thickness given: the volumes are those of a plate 1 m thick")
    finish(options, points, facts, warnings,
            f"from {os.path.basename(options.mesh)} (points at {options.at}, scale {options.scale!r})")


def _read(options):
    if options.one_block and (options.blocks or options.block_field):
        raise MeshError("--one-block has no blocks to name; leave out --blocks and --block-field")
    blocks = [] if options.one_block else _words_of(options.blocks)
    return read_mesh(options.mesh, options.block_field, blocks, _words_of(options.skip) or [])


def _grid(options):
    positive(options, "thickness", "horizon", "radius", "inner_radius", "length")
    origin = (options.origin + [0.0, 0.0, 0.0])[:3]
    measure = 1.0 if options.thickness is None else options.thickness
    exact = None
    if options.shape == "box":
        if not options.size or len(options.size) > 3:
            raise MeshError("a box needs --size with one to three edges")
        spacing = _spacings(options.spacing, len(options.size))
        points, steps = lattice.lattice(options.size, spacing, origin, measure_of(options, len(options.size)))
    else:
        is_long = options.shape in ("cylinder", "tube")
        needed = ["radius"] + (["length"] if is_long else []) + \
            (["inner_radius"] if options.shape in ("ring", "tube") else [])
        for name in needed:
            if getattr(options, name) is None:
                raise MeshError(f"a {options.shape} needs --{name.replace('_', '-')}")
        dimension = 3 if is_long else 2
        measure = measure_of(options, dimension)
        points, steps, exact = lattice.round_shape(
            options.radius, options.inner_radius or 0.0, options.length if is_long else None,
            _spacings(options.spacing, dimension), origin, measure)
    whole = points.volume.sum()
    points, warnings = _cut(points, options)
    facts = ["spacing " + " x ".join(f"{step:.6g}" for step in steps) + " m"]
    if exact is not None:
        facts.append(f"lattice volume of the whole shape {whole:.8g} m3, exact {exact:.8g} m3 "
                     f"({100 * (whole / exact - 1):+.3f} %)" + (", volumes scaled to it" if options.fit_volume else ""))
        if options.fit_volume:
            points.volume *= exact / whole
    for text in options.block:
        number, expression = named(text)
        if not re.fullmatch(r"[1-9]\d*", number):
            raise MeshError(f"--block `{text}`: `{number}` is not a positive whole number")
        points.block[select(expression, variables_of(points))] = int(number)
    # Node sets and blocks are chosen on the regular lattice, so that a jitter does not change them.
    sets = {name: select(expression, variables_of(points)) for name, expression in map(named, options.node_set)}
    if options.jitter:
        lattice.jitter(points, steps, options.jitter, options.seed)
        facts.append(f"jittered by {options.jitter:g} spacings, seed {options.seed}")
    if options.turn:
        if points.dimension == 1:
            raise MeshError("--turn is for plane and solid lattices")
        lattice.turn(points, origin, options.turn)
    points.node_sets = sets
    finish(options, points, facts, warnings, f"lattice: {options.shape}", from_grid=True)


def _cut(points, options):
    """(what is left of the points, warnings)"""
    cuts = [(f"hole {_words(hole)}", lattice.in_hole(points.x, hole)) for hole in options.hole]
    cuts += [(f"notch {_words(notch)}", lattice.in_notch(points.x, notch)) for notch in options.notch]
    cuts += [(f"wedge {_words(wedge)}", lattice.in_wedge(points.x, wedge)) for wedge in options.wedge]
    cuts += [(f"remove `{text}`", np.isin(np.arange(len(points)), select(text, variables_of(points))))
             for text in options.remove]
    warnings = [f"--{name} removes no point: it lies between them, or beside the body" for name, gone in cuts
                if not gone.any()]
    warnings += [f"--notch {_words(notch)} is narrower than the horizon: bonds span it; widen it, or cut them by a "
                 "bond filter in the deck" for notch in options.notch if options.horizon and notch[4] < options.horizon]
    gone = np.any([gone for _, gone in cuts], axis=0) if cuts else np.zeros(len(points), bool)
    return lattice.keep(points, ~gone), warnings


def _words(numbers):
    return " ".join(f"{number:g}" for number in numbers)


def _info(options):
    positive(options, "horizon")
    if options.mesh.lower().endswith(".txt"):
        if options.one_block or options.blocks or options.block_field or options.skip:
            raise MeshError(f"{options.mesh}: points have their blocks; --blocks, --one-block, --block-field and "
                            "--skip are for meshes of elements")
        points = read_points(options.mesh)
        for file in options.node_sets:
            points.node_sets[Path(file).stem] = read_node_set(file, len(points))
    else:
        mesh = _read(options)
        for kind, connectivity, _ in mesh.cells:
            print(f"{len(connectivity)} {kind} elements")
        for group in mesh.groups:
            count = sum(len(c) for _, c in group.parts) + (0 if group.nodes is None else len(group.nodes))
            print(f"group {group.name}: {count} elements or nodes")
        points = convert(mesh).points
    facts, warnings = report(points, options.horizon)
    print("\n".join(facts))
    for warning in warnings:
        print(f"pdmesh: warning: {warning}", file=sys.stderr)


def _export(options):
    points = read_points(options.mesh)
    for file in options.node_sets:
        points.node_sets[Path(file).stem] = read_node_set(file, len(points))
    export_points(points, options.output)


def _words_of(text):
    return None if text is None else [word.strip() for word in text.split(",") if word.strip()]


def _layer_depths(texts):
    depths = {}
    for text in texts:
        group, equals, value = text.rpartition("=")
        try:
            depth = float(value)
        except ValueError:
            raise MeshError(f"--layer-depth {text}: `{value}` is not a number") from None
        if not depth > 0:
            raise MeshError(f"--layer-depth {text}: the depth must be positive")
        depths[group if equals else None] = depth
    return depths


def _spacings(spacing, dimension):
    if len(spacing) not in (1, dimension):
        raise MeshError(f"--spacing takes one number or {dimension}, not {len(spacing)}")
    return (spacing * dimension)[:dimension]
