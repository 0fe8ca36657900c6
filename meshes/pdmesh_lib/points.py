"""A text discretization: points with block and volume, and node sets. Reading, writing, statistics."""
import contextlib
import os
import re

import numpy as np
from scipy.spatial import cKDTree

from .errors import MeshError
from .text import number_of, read_text


class Points:
    """x [n, 3] (m), block [n], volume [n] (m3); node_sets: name -> indices from 0; `measure` is what turns a volume
    into length (cross section, 1D) or area (thickness, 2D)."""

    def __init__(self, x, block, volume, dimension, measure=1.0):
        self.x, self.block, self.volume = x, np.asarray(block, int), volume
        self.dimension, self.measure = dimension, measure
        self.node_sets = {}
        self.block_names = {}
        self.steps = None  # of a lattice, one a direction (m)

    def __len__(self):
        return len(self.x)

    def spacing(self):
        """Edge of the cube (square, segment) of each point's volume."""
        return (self.volume / self.measure) ** (1.0 / self.dimension)

    def widest_spacing(self):
        """What the horizon must span three times: the widest step of a lattice."""
        return self.spacing() if self.steps is None else np.full(len(self.x), float(max(self.steps)))


def dimension_of(x):
    """1 where all points lie on a line along x, 2 in one z plane, else 3."""
    extent = x.max(axis=0) - x.min(axis=0)
    flat = extent <= 1e-12 * max(extent.max(), 1e-300)
    if flat[2]:
        return 1 if flat[1] else 2
    return 3


def write_points(points, file_name, heading):
    lines = ["# " + line + "\n" for line in heading]
    lines.append(f"# {len(points)} points, {points.dimension}D"
                 + {1: f", cross section {points.measure!r}", 2: f", thickness {points.measure!r}", 3: ""}
                 [points.dimension] + "\n")
    for number, name in sorted(points.block_names.items()):
        lines.append(f"# block_{number}: {one_line(name)}\n")
    lines.append("# x y z block volume\n")
    x = points.x.tolist()
    rows = [f"{p[0]!r} {p[1]!r} {p[2]!r} {b} {v!r}\n"
            for p, b, v in zip(x, points.block.tolist(), points.volume.tolist())]
    write_lines(file_name, lines + rows)


def write_node_set(indices, file_name, name, n_points, mesh):
    """The heading says whose points they are: pdrun refuses a node set of a mesh with another number of points."""
    numbers = (np.asarray(indices) + 1).tolist()
    write_lines(file_name, [f"# {one_line(name)}: {len(numbers)} of the {n_points} points of {mesh}\n"]
                + [f"{i}\n" for i in numbers])


def mesh_of_node_set(file_name):
    """(number of points, name) of the mesh that a node set was written for; (None, "") where it does not say."""
    try:
        with open(file_name, encoding="utf-8", errors="replace") as file:
            found = re.match(r"# .*: \d+ of the (\d+) points of (.*)", file.readline())
    except OSError:
        found = None
    return (int(found.group(1)), found.group(2)) if found else (None, "")


def one_line(name):
    """A name for a heading: whatever it holds, the heading does not end in it."""
    return " ".join(str(name).split())


def write_lines(file_name, lines):
    """Whole or not at all, where it is a file; a link or a device is written through, since a user has named it."""
    is_file = not os.path.lexists(file_name) or (os.path.isfile(file_name) and not os.path.islink(file_name))
    unfinished = f"{file_name}.pdmesh-unfinished" if is_file else file_name
    try:
        with open(unfinished, "w", encoding="utf-8") as file:
            file.writelines(lines)
        if is_file:
            os.replace(unfinished, file_name)
    except OSError as error:
        if is_file:
            with contextlib.suppress(OSError):
                os.unlink(unfinished)
        raise MeshError(f"{file_name}: cannot be written: {error.strerror}") from None


def read_points(file_name):
    """Reads `x y z block volume` lines; the thickness (cross section) from the heading that pdmesh writes."""
    text = read_text(file_name)
    heading = "".join(line for line in text[:2000].splitlines(True) if line.startswith("#"))
    found = re.search(r"(?:thickness|cross section) ([0-9.eE+-]+)", heading)
    measure = float(found.group(1)) if found else 1.0
    rows = _data_lines(text)
    for number, row in rows:
        if len(row) != 5:
            raise MeshError(f"{file_name}:{number}: expected 5 numbers `x y z block volume`, found {len(row)} words")
    if not rows:
        raise MeshError(f"{file_name}: no points")
    try:
        table = np.array([row for _, row in rows], dtype=float)
    except ValueError:
        table = np.array([[_number(file_name, number, word, float) for word in row] for number, row in rows])
    _check_columns(file_name, [number for number, _ in rows], table)
    points = Points(table[:, :3], table[:, 3].astype(int), table[:, 4], dimension_of(table[:, :3]), measure)
    points.block_names = {int(number): name for number, name in re.findall(r"^# block_(\d+): (.*)$", heading, re.M)}
    return points


def _data_lines(text):
    """[(line number, words)] of the lines with data, as pdrun takes them: what follows a # is a comment, and so are
    lines that begin with * or /."""
    lines = enumerate((line.partition("#")[0] for line in text.split("\n")), 1)
    return [(number, line.split()) for number, line in lines if line.strip() and line.lstrip()[0] not in "*/"]


def _number(file_name, line, word, kind):
    try:
        return number_of(word, kind)
    except ValueError as error:
        raise MeshError(f"{file_name}:{line}: {error}") from None


def _check_columns(file_name, lines, table):
    def is_block(values):
        return (values >= 1) & (values == np.floor(values)) & (values <= np.iinfo(np.int32).max)

    bad = np.flatnonzero(~np.isfinite(table).all(axis=1))
    if len(bad):
        raise MeshError(f"{file_name}:{lines[bad[0]]}: not all numbers are finite")
    bad = np.flatnonzero(~is_block(table[:, 3]))
    if len(bad) and is_block(table[:, 4]).all() and (table[:, 3] > 0).all():
        raise MeshError(f"{file_name}: columns 4 and 5 look exchanged: a line is `x y z block volume`")
    if len(bad):
        raise MeshError(f"{file_name}:{lines[bad[0]]}: the block number (fourth column) is a whole number of 1 or "
                        f"more, not {table[bad[0], 3]:g}; a line is `x y z block volume`")


def read_node_set(file_name, n_points):
    """Indices of its points. Refuses one that says it was written for a mesh of another number of points."""
    made_for, mesh = mesh_of_node_set(file_name)
    numbers = [(line, _number(file_name, line, word, int)) for line, words in _data_lines(read_text(file_name))
               for word in words]
    if made_for not in (None, n_points):
        raise MeshError(f"{file_name}: a node set of the {made_for} points of {mesh}, and this mesh has {n_points}; "
                        "write each mesh and its node sets into a folder of their own")
    for line, number in numbers:
        if not 1 <= number <= n_points:
            raise MeshError(f"{file_name}:{line}: node {number} is not in the mesh, which has points 1 to {n_points}")
    return np.array([number for _, number in numbers], dtype=int) - 1


def export_points(points, file_name):
    """Writes points, blocks and volumes in any format of meshio (VTU for ParaView)."""
    import meshio
    cells = [("vertex", np.arange(len(points))[:, None])]
    data = {"block": points.block, "volume": points.volume}
    for name, indices in points.node_sets.items():
        data[name] = np.isin(np.arange(len(points)), indices).astype(int)
    try:
        meshio.write(file_name, meshio.Mesh(points.x, cells, point_data=data))
    except Exception as error:  # meshio raises many kinds
        raise MeshError(f"{file_name}: meshio cannot write it: {error}") from None


def report(points, horizon=None):
    """Lines for the terminal: (facts, warnings)."""
    facts, warnings = [], []
    spacing = points.spacing()
    low, high = points.x.min(axis=0), points.x.max(axis=0)
    facts.append(f"{len(points)} points, {points.dimension}D, "
                 + " x ".join(f"[{low[i]:.6g}, {high[i]:.6g}]" for i in range(points.dimension)) + " m")
    facts.append(f"volume {points.volume.sum():.12g} m3")
    for number in np.unique(points.block):
        mask = points.block == number
        name = points.block_names.get(number)
        name = None if name == f"block_{number}" else name
        facts.append(f"block_{number}{f' ({name})' if name else ''}: {mask.sum()} points, "
                     f"{points.volume[mask].sum():.6g} m3")
    for name, indices in points.node_sets.items():
        facts.append(f"node set {name}: {len(indices)} points")
        if len(indices) == 0:
            warnings.append(f"node set {name} is empty")
    if np.any(points.volume <= 0):
        bad = np.flatnonzero(points.volume <= 0)
        warnings.append(f"{len(bad)} points have a zero or negative volume, the first is number {bad[0] + 1}")
        return facts, warnings
    tree = cKDTree(points.x)
    nearest = tree.query(points.x, k=2)[0][:, 1] if len(points) > 1 else np.array([np.inf])
    facts.append(f"spacing (from volumes) {spacing.min():.4g} .. mean {spacing.mean():.4g} .. {spacing.max():.4g} m; "
                 f"nearest neighbour {nearest.min():.4g} .. {nearest.max():.4g} m")
    # The cells of a lattice may be as flat as its steps say.
    close = 0.2 * (spacing if points.steps is None else min(points.steps))
    if np.any(nearest == 0):
        bad = np.flatnonzero(nearest == 0)
        warnings.append(f"{len(bad)} points coincide with another, the first is number {bad[0] + 1}")
    elif np.any(nearest < close):
        bad = np.flatnonzero(nearest < close)
        warnings.append(f"{len(bad)} points are nearer to a neighbour than a fifth of their spacing, the first is "
                        f"number {bad[0] + 1}: explicit steps get small there")
    widest = points.widest_spacing()
    coarse = float(np.quantile(widest, 0.99))
    facts.append(f"fitting horizon {3.015 * coarse:.4g} m (3.015 times "
                 + ("the spacing of the coarsest hundredth)" if points.steps is None else "the widest step)"))
    if horizon is not None:
        sample = np.random.default_rng(0).choice(len(points), min(len(points), 2000), replace=False)
        counts = tree.query_ball_point(points.x[sample], horizon * (1 + 1e-10), return_length=True) - 1
        facts.append(f"horizon {horizon:.6g} m: {horizon / spacing.mean():.3g} mean spacings, {counts.min()} .. mean "
                     f"{counts.mean():.1f} .. {counts.max()} neighbours")
        thin = int(np.count_nonzero(widest * 3 > horizon * (1 + 1e-9)))
        if thin > 0.01 * len(points):  # single wide cells do no harm
            warnings.append(f"the horizon is shorter than 3 spacings at {thin} points ({100 * thin / len(points):.1f} "
                            f"%): crack paths then follow the mesh; refine, or use {3.015 * coarse:.4g} m")
        if counts.min() == 0:
            warnings.append("some points have no neighbour within the horizon")
    return facts, warnings
