"""What Peridigm writes and reads: Exodus files, one a rank, in one of NetCDF's formats."""
import glob

import numpy as np
from scipy.io import netcdf_file


def _open(path):
    """The variables of a file by name, as arrays, and its dimensions."""
    with open(path, "rb") as file:
        is_classic = file.read(3) == b"CDF"
    if is_classic:
        with netcdf_file(path, mmap=False) as file:
            return {name: np.array(v[:]) for name, v in file.variables.items()}, dict(file.dimensions)
    from netCDF4 import Dataset  # for files in NetCDF 4's format alone
    with Dataset(path) as file:
        file.set_auto_mask(False)
        return ({name: np.array(v[:]) for name, v in file.variables.items()},
                {name: d.size for name, d in file.dimensions.items()})


def _names(variables, kind):
    """Labels of the variables of this kind ("nod", "elem", "glo")."""
    rows = variables.get(f"name_{kind}_var", [])
    return [b"".join(row).split(b"\0")[0].decode().strip() for row in rows]


def write_mesh(path, nodes, blocks, node_sets):
    """`blocks`: (id, name, element type, [m, k] nodes from 0); `node_sets`: id -> nodes from 0. Names may be empty."""
    with netcdf_file(path, "w", version=2) as file:
        def put(name, dimensions, values, kind):
            for dimension, size in zip(dimensions, np.shape(values)):
                if dimension not in file.dimensions:
                    file.createDimension(dimension, size)
            variable = file.createVariable(name, kind, dimensions)
            variable[:] = values
            return variable

        file.api_version, file.version = np.float32(4.98), np.float32(4.98)
        file.floating_point_word_size, file.file_size, file.title = np.int32(8), np.int32(1), "mesh"
        for name, size in (("time_step", None), ("len_string", 33), ("len_name", 33), ("len_line", 81), ("num_dim", 3), ("four", 4),
                           ("num_elem", sum(len(block[3]) for block in blocks))):
            file.createDimension(name, size)
        file.createVariable("time_whole", "d", ("time_step",))
        for d, axis in enumerate("xyz"):
            put("coord" + axis, ("num_nodes",), nodes[:, d], "d")
        put("eb_status", ("num_el_blk",), np.ones(len(blocks)), "i")
        put("eb_prop1", ("num_el_blk",), [block[0] for block in blocks], "i").name = "ID"
        characters = np.array([list(block[1].ljust(33, "\0")) for block in blocks], "S1")
        put("eb_names", ("num_el_blk", "len_name"), characters, "c")
        for number, (_, _, kind, elements) in enumerate(blocks, 1):
            put(f"connect{number}", (f"num_el_in_blk{number}", f"num_nod_per_el{number}"), elements + 1,
                "i").elem_type = kind
        put("ns_status", ("num_node_sets",), np.ones(len(node_sets)), "i")
        put("ns_prop1", ("num_node_sets",), list(node_sets), "i").name = "ID"
        for number, members in enumerate(node_sets.values(), 1):
            put(f"node_ns{number}", (f"num_nod_ns{number}",), members + 1, "i")


class ExodusSeries:
    """All states of a run, its points in the order of their numbers. `files`: one, or the parts of all ranks.

    times [m]; coordinates [n, 3]; fields: label -> [m, n], NaN where a block has no values; globals: label -> [m].
    """

    def __init__(self, files):
        ids, coordinates, values, self.globals = [], [], {}, {}
        for part in files:
            variables, dimensions = _open(part)
            self.times = variables["time_whole"]
            for number, label in enumerate(_names(variables, "glo")):
                self.globals[label] = variables["vals_glo_var"][:, number]
            n = dimensions.get("num_nodes", 0)
            ids.append(variables.get("node_num_map", np.arange(n) + 1) - 1)
            coordinates.append(self._coordinates(variables, n))
            for label, field in self._fields(variables, dimensions, n).items():
                values.setdefault(label, []).append(field)
        order = np.argsort(np.concatenate(ids))
        self.coordinates = np.concatenate(coordinates)[order]
        self.fields = {label: np.concatenate(parts, axis=1)[:, order] for label, parts in values.items()}

    @staticmethod
    def _coordinates(variables, n):
        if "coord" in variables:
            return variables["coord"].T
        return np.column_stack([variables.get("coord" + axis, np.zeros(n)) for axis in "xyz"])

    @staticmethod
    def _fields(variables, dimensions, n):
        """Fields of one rank's points, [m, n]."""
        n_steps = len(variables["time_whole"])
        fields = {}
        for number, label in enumerate(_names(variables, "nod"), 1):
            fields[label] = variables[f"vals_nod_var{number}"]
        for number, label in enumerate(_names(variables, "elem"), 1):
            field = np.full((n_steps, n), np.nan)
            for block in range(1, dimensions["num_el_blk"] + 1):
                if f"vals_elem_var{number}eb{block}" in variables:
                    points = variables[f"connect{block}"][:, 0] - 1
                    field[:, points] = variables[f"vals_elem_var{number}eb{block}"]
            fields[label] = field
        return fields


def joined(fields, label, axis=-1):
    """The field of this label, its components X, Y, Z or XX ... ZZ side by side along `axis`."""
    if label in fields:
        return fields[label]
    axes = "XYZ" if label + "X" in fields else [row + column for row in "XYZ" for column in "XYZ"]
    return np.stack([fields[label + name] for name in axes], axis=axis)


class ExodusResult:
    """The last state of a run, in the order of the mesh file. `path`: name of the results without extension."""

    def __init__(self, path):
        parts = glob.glob(glob.escape(path) + ".e") or sorted(glob.glob(glob.escape(path) + ".e.*"))
        if not parts:
            raise FileNotFoundError(f"no Exodus file {path}.e")
        series = ExodusSeries(parts)
        self.n_steps = len(series.times)
        self.fields = {label: np.nan_to_num(field[-1]) for label, field in series.fields.items()}
        self.globals = {label: float(values[-1]) for label, values in series.globals.items()}

    def field(self, label):
        """[n], [n, 3] or [n, 9]."""
        return joined(self.fields, label)
