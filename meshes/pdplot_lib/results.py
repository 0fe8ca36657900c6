"""Reads what pdrun writes: fields in <name>.h5, histories in <name>.csv."""
import csv
import json
from pathlib import Path

import h5py
import numpy as np
from scipy.spatial import cKDTree

from .raster import reach_of
from .units import OF_THE_DECK, history_unit, printed, unit_of


class PlotError(Exception):
    """What a user of pdplot did wrong: names the file or option, and the remedy."""


class Results:
    """Fields of one run. x [n, 3] reference coordinates (m), volume [n] (m3); `steps`: numbers of the steps there."""

    def __init__(self, name):
        self.path = find_results(name)
        self.label = self.path.stem
        try:
            self._file = h5py.File(self.path, "r")
            self.x = self._file["mesh/coordinates"][:]
            self.volume = self._file["mesh/volume"][:]
            self.block = self._file["mesh/block_id"][:]
        except (OSError, KeyError) as error:
            raise PlotError(f"{self.path}: not a result file of pdrun, or its folder {self.label}.steps is missing: "
                            f"{error}") from None
        self._names = {int(name): name for name in self._file["steps"]}
        self.steps = sorted(self._names)
        extent = np.ptp(self.x, axis=0)
        flat = extent <= 1e-12 * max(extent.max(), 1e-300)
        self.dimension = 3 if not flat[2] else (1 if flat[1] else 2)
        self._spacings = self._reach = None
        if not self.steps:
            raise PlotError(f"{self.path}: no steps have been written")

    def time(self, step):
        return float(self._group(step).attrs["time"])

    def fields(self, step=None):
        return sorted(self._group(self.steps[-1] if step is None else step))

    def field(self, name, step):
        """[n] or [n, width]"""
        group = self._group(step)
        if name not in group:
            raise PlotError(f"{self.path}: step {step} has no field {name} (there are: {', '.join(sorted(group))}); "
                            "name it under Output Variables in the deck")
        return group[name][:]

    def of_fluid(self, *names):
        """Places and fields of the points that are fluid, at the last step; of vectors as many components as the body
        has dimensions."""
        step = self.steps[-1]
        inside = self.field("Fluid", step) == 1
        return [values[inside] if values.ndim == 1 else values[inside, :self.dimension]
                for values in (self.x, *(self.field(name, step) for name in names))]

    def width(self, name):
        """Numbers a point."""
        values = self._group(self.steps[-1])[name]
        return 1 if values.ndim == 1 else values.shape[1]

    def unit(self, name):
        """What the field is measured in, as it is read; empty for pure numbers. Results that do not say it of any field
        are old ones."""
        group = self._group(self.steps[-1])
        if name in group and "units" in group[name].attrs:
            unit = group[name].attrs["units"]
            return printed(unit.decode() if isinstance(unit, bytes) else str(unit))
        if any("units" in field.attrs for field in group.values()):
            return OF_THE_DECK
        return self.concentration_unit() if name == "Concentration" else unit_of(name)

    def varies(self, name):
        """Whether a field differs between points at the last step."""
        values = self.field(name, self.steps[-1])
        return bool(np.any(values != values[0]))

    def spacing(self):
        """Typical distance of neighbouring points (m)."""
        return float(np.median(self.spacings()))

    def spacings(self):
        """[n]: edge of each point's cell (m). Results do not say how thick a plane is: how many points are near some of
        them tells by how much lengths differ from roots of volumes."""
        if self._spacings is None:
            edges = self.volume ** (1 / self.dimension)
            self._spacings = edges * _spacing_by_edge(self.x[:, :self.dimension], edges)
        return self._spacings

    def reach(self):
        """That of a Raster of the points, in spacings."""
        if self._reach is None:
            self._reach = reach_of(self.x[:, :self.dimension], self.spacings()) if self.dimension > 1 else 0.45
        return self._reach

    def concentration_unit(self):
        """What the deck says: metal ions are given in mol/m3; of hydrogen its user chooses."""
        try:
            deck = self.path.with_suffix(".resolved.yaml").read_text(encoding="utf-8", errors="replace")
        except OSError:
            deck = ""
        return "mol/m³" if "Corrosion Dissolution" in deck else OF_THE_DECK

    def _group(self, step):
        try:
            return self._file["steps"][self._names[step]]
        except KeyError:
            known = ", ".join(map(str, self.steps))
            raise PlotError(f"{self.path}: no step {step} (there are: {known})") from None


def _spacing_by_edge(x, edges):
    n_points, dimension = x.shape
    # Full shells of a lattice; the ball reaches half the way to the next shell. `exact` makes lattices come out right.
    count, shells = {1: (4, (2, 3)), 2: (20, (5 ** 0.5, 8 ** 0.5)), 3: (32, (2, 5 ** 0.5))}[dimension]
    exact = (_ball(sum(shells) / 2, dimension) / (count + 1)) ** (1 / dimension)
    if n_points <= count + 1:
        extent = np.ptp(x, axis=0).max()
        return (extent / max(1.0, n_points ** (1 / dimension) - 1) if extent > 0 else 1.0) / edges.mean()
    sample = np.random.default_rng(0).choice(n_points, min(n_points, 2000), replace=False)
    distances = cKDTree(x, balanced_tree=False, compact_nodes=False).query(x[sample], k=count + 2)[0]
    radius = distances[:, -2:].mean(axis=1)
    # Near a boundary the ball is partly empty: the fifth that is fullest lies inside.
    return np.quantile((_ball(radius, dimension) / (count + 1)) ** (1 / dimension) / exact / edges[sample], 0.2)


def _ball(radius, dimension):
    return {1: 2 * radius, 2: np.pi * radius ** 2, 3: 4 / 3 * np.pi * radius ** 3}[dimension]


def find_results(name=None):
    """The .h5 file of `name` (with or without its ending, or a folder); of the newest run here where there is none."""
    path = Path(name) if name else Path(".")
    if path.is_dir():
        found = sorted((file for file in path.glob("*.h5") if (path / (file.stem + ".steps")).is_dir()),
                       key=lambda file: file.stat().st_mtime)
        if not found:
            raise PlotError(f"{path.resolve()}: no results of pdrun here (a .h5 file with its .steps folder)")
        return found[-1]
    for candidate in (path, path.with_name(path.name + ".h5"), path.with_suffix(".h5")):
        if candidate.is_file() and candidate.suffix == ".h5":
            return candidate
    raise PlotError(f"{name}: no such results (expected {path.with_name(path.name + '.h5')})")


def read_history(name):
    """Columns of the CSV file of a run: name -> [rows]."""
    path = history_file(name)
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
    except OSError as error:
        raise PlotError(f"{path}: no history: {error.strerror}") from None
    header, body = rows[0], [row for row in rows[1:] if len(row) == len(rows[0])]
    if not body:
        raise PlotError(f"{path}: the history has no rows yet")
    table = np.array(body, dtype=float)
    return {column.strip(): table[:, i] for i, column in enumerate(header)}


def vector_columns(history, label):
    """Names of the three columns of a vector in a history, in any case of letters."""
    found = [next((name for name in history if name.lower() == f"{label}{axis}".lower()), None) for axis in "XYZ"]
    if None in found:
        raise PlotError(f"no vector {label} in the history (there are: {', '.join(history)}); name a Crack_Tip under "
                        "Output Variables")
    return found


def read_path(name):
    """Places [n, 2] of a file of two numbers a row, with commas or without; # and words at its head are passed over."""
    places = []
    try:
        lines = Path(name).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise PlotError(f"{name}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    for number, line in enumerate(lines, start=1):
        words = line.split("#")[0].replace(",", " ").split()
        try:
            if words:
                places.append([float(word) for word in words[:2]])
        except ValueError:
            if places:
                raise PlotError(f"{name}:{number}: expected two numbers, x and y in m") from None
    if not places or any(len(place) < 2 for place in places):
        raise PlotError(f"{name}: expected two numbers a row, x and y in m")
    return np.array(places)


def history_units(name, columns):
    """Of the columns of that file: name -> unit as it is read; empty where only the deck knows. Guessed from the names
    where the run has not written units beside it."""
    try:
        described = json.loads(Path(f"{history_file(name)}-metadata.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {column: history_unit(column) for column in columns}
    known = {column["name"]: column.get("schema:unitText", "1") for column in described["tableSchema"]["columns"]}
    return {column: printed(known.get(column, "1")) for column in columns}


def history_file(name):
    path = Path(name)
    if path.suffix == ".csv":
        return path
    path = find_results(name).with_suffix(".csv") if path.is_dir() else path.with_suffix("").with_name(
        path.name[:-3] if path.name.endswith(".h5") else path.name)
    return path if path.suffix == ".csv" else path.with_name(path.name + ".csv")
