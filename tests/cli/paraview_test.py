"""ParaView's own reader and meshio's open what pdrun writes: points, times, fields and their ranges. ParaView's part is
skipped without pvpython."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

PDRUN = os.path.abspath(os.environ["PDRUN"])

NX, NY, SPACING = 12, 7, 1e-3
DECK = """\
Discretization: {Type: Text File, Input Mesh File: mesh.txt, Thickness: 1.0e-3}
Materials:
  Steel: {Material Model: PDHE, Density: 7850.0, Young's Modulus: 2.0e+11, Poisson's Ratio: 0.3,
          Plane Stress: true, Thickness: 1.0e-3, Diffusivity: 1.0e-9}
Blocks:
  Plate: {Block Names: block_1, Material: Steel, Horizon: 3.1e-3}
Boundary Conditions:
  All Node Set: {Expression: "x > -1"}
  Stretch X: {Type: Prescribed Displacement, Node Set: All Node Set, Coordinate: x, Value: "2*x*t"}
  Stretch Y: {Type: Prescribed Displacement, Node Set: All Node Set, Coordinate: y, Value: "-y*t"}
  Hydrogen: {Type: Prescribed Concentration, Node Set: All Node Set, Value: "1 + 100*x*t"}
Solver:
  Initial Time: 0.0
  Final Time: 0.002
  Staggered:
    Load Steps: 4
    Diffusion: {Method: RKL}
    Mechanics: {Adaptive Dynamic Relaxation: {Iterations Per Load Step: 1}}
Output: {Output Filename: my plate, Output Frequency: 2, Output Variables: [Displacement, Concentration, Volume]}
"""

# Run by pvpython, which need not have numpy.
READER = """\
import json, sys
from paraview import servermanager
from paraview.simple import OpenDataFile
reader = OpenDataFile(sys.argv[1])
found = []
for time in reader.TimestepValues:
    reader.UpdatePipeline(time)
    data = servermanager.Fetch(reader)
    while data.IsA("vtkCompositeDataSet"):
        iterator = data.NewIterator()
        iterator.InitTraversal()
        data = iterator.GetCurrentDataObject()
    fields = {}
    for i in range(data.GetPointData().GetNumberOfArrays()):
        array = data.GetPointData().GetArray(i)
        fields[array.GetName()] = [array.GetRange(c) for c in range(array.GetNumberOfComponents())]
    found.append({"time": time, "points": data.GetNumberOfPoints(), "cells": data.GetNumberOfCells(),
                  "bounds": data.GetBounds(), "fields": fields})
json.dump(found, open(sys.argv[2], "w"))
"""


class Scene(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        i, j = np.meshgrid(np.arange(NX), np.arange(NY))
        self.x, self.y = SPACING * (i.ravel() + 1), SPACING * (j.ravel() + 1)
        rows = np.column_stack([self.x, self.y, 0 * self.x, 1 + 0 * self.x, SPACING**3 + 0 * self.x])
        np.savetxt(self.path("mesh.txt"), rows, fmt=["%.17g"] * 3 + ["%d", "%.17g"])
        for name, text in (("deck.yaml", DECK), ("reader.py", READER)):
            with open(self.path(name), "w") as file:
                file.write(text)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def run_deck(self, *launcher):
        done = subprocess.run([*launcher, PDRUN, "deck.yaml", "--quiet"], cwd=self.folder.name, capture_output=True,
                              text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)

    def expected(self, time):
        """Components of the fields that the deck prescribes."""
        x, y = self.x, self.y
        return {"Displacement": [2 * x * time, -y * time, 0 * x], "Concentration": [1 + 100 * x * time],
                "Volume": [SPACING**3 + 0 * x]}


class Meshio(Scene):
    def test_points_times_and_values(self):
        import meshio
        self.run_deck()
        with meshio.xdmf.TimeSeriesReader(self.path("my plate.xdmf")) as reader:
            points, cells = reader.read_points_cells()
            np.testing.assert_allclose(points, np.column_stack([self.x, self.y, 0 * self.x]), rtol=1e-15)
            self.assertEqual([(block.type, len(block.data)) for block in cells], [("vertex", NX * NY)])
            self.assertEqual(reader.num_steps, 3)
            for step, expected_time in enumerate((0.0, 0.001, 0.002)):
                time, fields, _ = reader.read_data(step)
                self.assertAlmostEqual(time, expected_time, delta=1e-15)
                expected = self.expected(time)
                self.assertEqual(set(fields), set(expected))
                for name, components in expected.items():
                    np.testing.assert_allclose(fields[name].reshape(NX * NY, -1), np.column_stack(components),
                                               rtol=1e-12, atol=1e-18)


@unittest.skipUnless(shutil.which("pvpython"), "no pvpython: ParaView is not installed")
class ParaView(Scene):
    def run_and_read(self, *launcher):
        self.run_deck(*launcher)
        # A whole path: given the bare name, the library under ParaView looks for the tables in the wrong folder.
        done = subprocess.run(["pvpython", "--force-offscreen-rendering", self.path("reader.py"),
                               self.path("my plate.xdmf"), self.path("found.json")], capture_output=True, text=True,
                              timeout=200)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(self.path("found.json")) as file:
            return json.load(file)

    def check(self, found):
        self.assertEqual(len(found), 3)  # steps 0, 2, 4
        x, y = self.x, self.y
        for step, time in zip(found, (0.0, 0.001, 0.002)):
            self.assertAlmostEqual(step["time"], time, delta=1e-15)
            self.assertEqual((step["points"], step["cells"]), (NX * NY, NX * NY))
            np.testing.assert_allclose(step["bounds"], [x.min(), x.max(), y.min(), y.max(), 0.0, 0.0], rtol=1e-6)
            expected = self.expected(time)
            self.assertEqual(set(step["fields"]), set(expected))
            for name, components in expected.items():
                ranges = [(values.min(), values.max()) for values in components]
                np.testing.assert_allclose(step["fields"][name], ranges, rtol=1e-12, atol=1e-18,
                                           err_msg=f"{name} at {time}")

    def test_points_times_and_ranges(self):
        self.check(self.run_and_read())

    def test_results_of_two_ranks(self):
        launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", "2"]
        self.check(self.run_and_read(*launcher))


if __name__ == "__main__":
    unittest.main()
