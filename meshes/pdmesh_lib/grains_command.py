"""The command `pdmesh grains`."""
import os
import re
from itertools import count

import numpy as np

from . import grains
from .command_options import add_common, finish, measure_of, positive
from .errors import MeshError
from .expressions import select, variables_of
from .points import read_points


def add_grains(commands):
    command = commands.add_parser(
        "grains", help="split a block into grains and their boundaries",
        description="A Voronoi structure of seeds drawn at random in a text discretization: points near the plane "
                    "between two grains get the block of boundaries. Where boundaries are thinner than the spacing "
                    "they are made one point thick, so that they hold together and are marked no thicker than that; "
                    "their share of the volume is then larger than theirs in the metal. The points stay as they are, "
                    "and so do node sets of theirs.")
    command.add_argument("mesh", help="text discretization")
    command.add_argument("-o", "--output", required=True, help="text discretization to write")
    command.add_argument("--size", type=float, required=True, metavar="D",
                         help="grain size (m): grains have D^2 of the plane (D^3 of the volume) in the mean")
    command.add_argument("--width", type=float, required=True, metavar="W",
                         help="thickness of boundaries (m), may be 0")
    command.add_argument("--split", type=int, metavar="BLOCK", help="block to split; needed where there are several")
    command.add_argument("--where", metavar="EXPRESSION", help="only points where this holds, as 'x > 0'")
    command.add_argument("--boundary-block", type=int, metavar="NUMBER", help="default: the next number that is free")
    command.add_argument("--phase", action="append", default=[], metavar="BLOCK=SHARE",
                         help="grains of a second phase: that share of the grains becomes this block; may be repeated")
    command.add_argument("--by-share", action="store_true",
                         help="mark the points whose cells boundaries fill most, of as much volume as boundaries have. The "
                              "share is right at any spacing, but where boundaries are thinner, marked points lie apart")
    command.add_argument("--grains", metavar="FILE", help="write the number of each point's grain")
    command.add_argument("--seeds", metavar="FILE", help="write the points about which grains are, x y z a line")
    command.add_argument("--seed", type=int, default=1, help="of the random numbers")
    add_common(command)
    command.set_defaults(run=_grains)


def _grains(options):
    positive(options, "size", "thickness", "horizon")
    if not (options.width >= 0 and np.isfinite(options.width)):
        raise MeshError(f"--width must not be negative, but is {options.width:g}")
    points = read_points(options.mesh)
    if options.thickness is not None:
        points.measure = measure_of(options, points.dimension)
    chosen = _points_to_split(points, options)
    phases = [_phase(text) for text in options.phase]
    boundary_block = options.boundary_block
    if boundary_block is None:
        of_phases = [number for number, _ in phases]
        boundary_block = next(number for number in count(int(points.block.max()) + 1) if number not in of_phases)
    if min([boundary_block] + [number for number, _ in phases]) < 1:
        raise MeshError("blocks have numbers from 1 on")
    if sum(share for _, share in phases) > 1 + 1e-9:
        raise MeshError("--phase: the shares add up to more than 1")
    if boundary_block in [number for number, _ in phases]:
        raise MeshError(f"--boundary-block {boundary_block} is the block of a --phase: boundaries could not be told "
                        "from its grains")
    if boundary_block in points.block[chosen]:
        raise MeshError(f"--boundary-block {boundary_block} is the block to split: boundaries could not be told from "
                        "grains")
    random = np.random.default_rng(options.seed)
    dimension, spacing, steps = points.dimension, points.spacing(), grains.lattice_steps(points)
    made = grains.make_grains(points.x[chosen, :dimension], spacing[chosen], options.size, options.width, random, steps,
                              options.by_share)
    volume = points.volume[chosen]
    share = volume[made.is_boundary].sum() / volume.sum()
    expected = options.width * grains.BOUNDARY_DENSITY[dimension] / options.size
    points.steps = steps
    points.block[chosen] = grains.assign_blocks(made, points.block[chosen], boundary_block, phases, random)
    points.block_names[boundary_block] = "grain boundaries"
    facts = [f"{made.grain.max() + 1} grains of mean size {options.size:g} m, seed {options.seed}",
             f"boundaries have {share:.4g} of the volume; {expected:.4g} is that of boundaries {options.width:g} m "
             "thick, in the mean and without their overlap"]
    warnings = []
    mean_spacing = spacing[chosen].mean()
    if options.width < mean_spacing * (1 - 1e-6) and not options.by_share:
        excess = f": {share / expected:.3g} times their share of the volume" if expected > 0 else ""
        warnings.append(f"boundaries are thinner than the spacing of {mean_spacing:.4g} m and were made one point thick"
                        + excess)
    if 0 < options.width and options.size < 4 * mean_spacing:
        warnings.append("grains are smaller than four spacings: hardly anything of them is left between boundaries")
    if options.grains:
        grains.write_grains(made, chosen, len(points), options.grains)
    if options.seeds:
        grains.write_seeds(made, points.x[0], options.seeds)
    finish(options, points, facts, warnings, f"grains in {os.path.basename(options.mesh)}")


def _points_to_split(points, options):
    blocks = np.unique(points.block)
    if options.split is None and len(blocks) > 1:
        raise MeshError(f"{options.mesh} has the blocks {', '.join(map(str, blocks))}: name the one to split by "
                        "--split")
    if options.split is not None and options.split not in blocks:
        raise MeshError(f"--split {options.split}: {options.mesh} has no such block (there are: "
                        f"{', '.join(map(str, blocks))})")
    chosen = np.ones(len(points), bool) if options.split is None else points.block == options.split
    if options.where:
        chosen &= np.isin(np.arange(len(points)), select(options.where, variables_of(points)))
    if not chosen.any():
        raise MeshError("no points to split: --where holds for none of the block")
    return np.flatnonzero(chosen)


def _phase(text):
    found = re.fullmatch(r"\s*(\d+)\s*=\s*(\S+)\s*", text)
    try:
        number, share = int(found.group(1)), float(found.group(2))
    except (AttributeError, ValueError):
        raise MeshError(f"--phase {text}: expected BLOCK=SHARE, for example 3=0.2") from None
    if not 0 < share <= 1:
        raise MeshError(f"--phase {text}: the share must be above 0 and at most 1")
    return number, share
