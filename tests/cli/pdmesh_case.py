"""What the tests of pdmesh share: drawings for Gmsh, and how the programs are called."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

PDMESH = Path(__file__).resolve().parents[2] / "meshes" / "pdmesh"
sys.dont_write_bytecode = True
sys.path[:0] = [str(PDMESH.parent), str(Path(__file__).resolve().parents[1] / "support")]

from in_process import run  # noqa: E402
from pdmesh_lib.command_line import main  # noqa: E402

# Volumes are sums of at most 1e5 products in double precision: 1e-12 leaves four digits for round-off.
TOLERANCE = 1e-12

SQUARE = """
Point(1) = {0, 0, 0, 0.1}; Point(2) = {2, 0, 0, 0.1}; Point(3) = {2, 1, 0, 0.1}; Point(4) = {0, 1, 0, 0.1};
Point(5) = {1, 0, 0, 0.1}; Point(6) = {1, 1, 0, 0.1};
Line(1) = {1, 5}; Line(2) = {5, 6}; Line(3) = {6, 4}; Line(4) = {4, 1};
Line(5) = {5, 2}; Line(6) = {2, 3}; Line(7) = {3, 6};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, -2}; Plane Surface(2) = {2};
Physical Surface("soft", 7) = {1}; Physical Surface("stiff", 3) = {2};
Physical Curve("top", 11) = {3, 7}; Physical Curve("left", 12) = {4}; Physical Point("corner", 13) = {3};
"""
RING = """
SetFactory("OpenCASCADE");
Disk(1) = {0.3, -0.2, 0, 1}; Disk(2) = {0.3, -0.2, 0, 0.4};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Mesh.CharacteristicLengthMax = 0.2;
Physical Surface("ring", 1) = {3}; Physical Curve("boundary", 2) = Boundary{ Surface{3}; };
"""
BALL = """
SetFactory("OpenCASCADE");
Sphere(1) = {0.3, -0.2, 0.5, 1}; Mesh.CharacteristicLengthMax = 0.5;
Physical Volume("ball", 1) = {1}; Physical Surface("boundary", 2) = {1};
"""
# Boxes of 1 x 2 x 3 by extrusion; the layers make hexahedra, wedges or (unrecombined) tetrahedra.
BOX = """
Point(1) = {0, 0, 0, 0.4}; a[] = Extrude {1, 0, 0} { Point{1}; Layers{3}; };
b[] = Extrude {0, 2, 0} { Line{a[1]}; Layers{4}; %s };
c[] = Extrude {0, 0, 3} { Surface{b[1]}; Layers{5}; %s };
Physical Volume("box", 1) = {c[1]}; Physical Surface("top", 2) = {c[0]};
"""
BENT = """
SetFactory("OpenCASCADE");
Rectangle(1) = {1, 0, 0, 0.5, 0.7}; Transfinite Surface {1}; Recombine Surface {1};
Transfinite Curve {1, 2, 3, 4} = 4;
c[] = Extrude { {0, 1, 0}, {0, 0, 0}, Pi/2 } { Surface{1}; Layers{6}; Recombine; };
Physical Volume("bent", 1) = {c[1]}; Physical Surface("boundary", 2) = Boundary{ Volume{c[1]}; };
"""


class Result:
    def __init__(self, file_name):
        self.table = np.loadtxt(file_name, comments="#", ndmin=2)
        self.x, self.block, self.volume = self.table[:, :3], self.table[:, 3].astype(int), self.table[:, 4]
        self.total = self.volume.sum()
        self.moment = self.volume @ self.x


class PdmeshCase(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = Path(self.scratch.name)

    def tearDown(self):
        self.scratch.cleanup()

    def gmsh(self, text, dimension, *options, name="mesh.msh"):
        (self.folder / "mesh.geo").write_text(text)
        subprocess.run(["gmsh", f"-{dimension}", "mesh.geo", "-o", name, *options], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return self.folder / name

    def pdmesh(self, *arguments, expect=0):
        """Output and errors of the program."""
        code, output, errors = run(main, self.folder, arguments)
        self.assertEqual(code, expect, output + errors)
        return output, errors

    def convert(self, mesh, *arguments):
        self.pdmesh("convert", mesh, "points.txt", *arguments)
        return Result(self.folder / "points.txt")

    def node_set(self, name):
        return np.loadtxt(self.folder / f"{name}.txt", comments="#", dtype=int, ndmin=1) - 1

    def check(self, result, volume, moment):
        self.assertLess(abs(result.total / volume - 1), TOLERANCE)
        np.testing.assert_allclose(result.moment[:len(moment)], moment, rtol=TOLERANCE, atol=TOLERANCE * volume)
