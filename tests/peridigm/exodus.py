"""What Peridigm writes: Exodus files, one a rank, in NetCDF's classic format."""
import glob
import os

import numpy as np
from scipy.io import netcdf_file


def _names(file, kind):
    """Labels of the variables of this kind ("nod", "elem", "glo")."""
    if f"name_{kind}_var" not in file.variables:
        return []
    rows = file.variables[f"name_{kind}_var"][:]
    return [b"".join(row).split(b"\0")[0].decode().strip() for row in rows]


class ExodusResult:
    """The last state of a run, in the order of the mesh file. `path`: name of the results without extension."""

    def __init__(self, path):
        parts = glob.glob(glob.escape(path) + ".e") or sorted(glob.glob(glob.escape(path) + ".e.*"))
        if not parts:
            raise FileNotFoundError(f"no Exodus file {path}.e")
        self.fields, self.globals, self.n_steps = {}, {}, None
        ids, values = [], {}
        for part in parts:
            with netcdf_file(part, mmap=False) as file:
                self.n_steps = len(file.variables["time_whole"][:])
                ids.append(file.variables["node_num_map"][:] - 1)
                for label, field in self._read(file).items():
                    values.setdefault(label, []).append(field)
        order = np.argsort(np.concatenate(ids))
        for label, fields in values.items():
            self.fields[label] = np.concatenate(fields)[order]

    def _read(self, file):
        """Fields of one rank's points."""
        fields = {}
        for number, label in enumerate(_names(file, "nod"), 1):
            fields[label] = file.variables[f"vals_nod_var{number}"][-1].copy()
        for number, label in enumerate(_names(file, "elem"), 1):
            field = np.zeros(file.dimensions["num_nodes"])
            for block in range(1, file.dimensions["num_el_blk"] + 1):
                if f"vals_elem_var{number}eb{block}" in file.variables:
                    points = file.variables[f"connect{block}"][:, 0] - 1
                    field[points] = file.variables[f"vals_elem_var{number}eb{block}"][-1]
            fields[label] = field
        for number, label in enumerate(_names(file, "glo")):
            self.globals[label] = float(file.variables["vals_glo_var"][-1, number])
        return fields

    def field(self, label):
        """[n], [n, 3] or [n, 9]."""
        if label in self.fields:
            return self.fields[label]
        axes = "XYZ" if label + "X" in self.fields else [row + column for row in "XYZ" for column in "XYZ"]
        return np.column_stack([self.fields[label + axis] for axis in axes])
