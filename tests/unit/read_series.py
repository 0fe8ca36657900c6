"""Reads a series of field files as a user would, and checks the values that killed_output_test.cpp writes.

Usage: read_series.py NAME POINTS STEPS     NAME.h5 and NAME.xdmf list steps 0 .. STEPS-1
"""
import sys

import h5py
import meshio
import numpy as np

name, n_points, n_steps = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
ids = np.arange(n_points)


def check(step, time, damage, displacement):
    assert time == 0.5 * step, (step, time)
    np.testing.assert_array_equal(damage, step + ids / 65536.0)
    np.testing.assert_array_equal(displacement, np.stack([step * ids + k for k in range(3)], axis=1))


with h5py.File(name + ".h5", "r") as file:
    np.testing.assert_array_equal(file["mesh/coordinates"][:, 0], ids)
    np.testing.assert_array_equal(file["mesh/block_id"], 1)
    np.testing.assert_array_equal(file["mesh/volume"], 2.0)
    # The index may be one step ahead of the XDMF file, which is written after it.
    assert len(file["steps"]) in (n_steps, n_steps + 1), len(file["steps"])
    for step, (key, fields) in enumerate(sorted(file["steps"].items())):
        assert key == f"{step:06}" and fields.attrs["step"] == step
        check(step, fields.attrs["time"], fields["Damage"][:], fields["Displacement"][:])

with meshio.xdmf.TimeSeriesReader(name + ".xdmf") as reader:
    points, cells = reader.read_points_cells()
    np.testing.assert_array_equal(points[:, 0], ids)
    assert cells[0].type == "vertex" and len(cells[0].data) == n_points
    assert reader.num_steps == n_steps
    for step in range(n_steps):
        time, fields, _ = reader.read_data(step)
        check(step, time, fields["Damage"], fields["Displacement"])
