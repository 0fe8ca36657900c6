#!/usr/bin/python3
"""Tests of meshes/pdmesh on what Gmsh really writes: volumes and first moments against independent computations."""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import meshio
import numpy as np

PDMESH = Path(__file__).resolve().parents[2] / "meshes" / "pdmesh"
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


def ring_boundary(mesh, centre, middle_radius):
    """Area and first moment of a ring from its boundary of quadratic edges, by Green's theorem."""
    x = mesh.points[np.concatenate([b.data for b in mesh.cells if b.type == "line3"])][:, :, :2]
    # The outer edges must run anticlockwise, the inner ones clockwise.
    from_centre = x[:, 0] - centre
    turns = np.cross(from_centre, x[:, 1] - centre) > 0
    wrong = turns != (np.linalg.norm(from_centre, axis=1) > middle_radius)
    x[wrong] = x[wrong][:, [1, 0, 2]]
    area, moment = 0.0, np.zeros(2)
    for t, w in zip(*np.polynomial.legendre.leggauss(5)):
        p = x[:, 0] * t * (t - 1) / 2 + x[:, 1] * t * (t + 1) / 2 + x[:, 2] * (1 - t * t)
        d = x[:, 0] * (t - 0.5) + x[:, 1] * (t + 0.5) - 2 * t * x[:, 2]
        area += w * np.sum(p[:, 0] * d[:, 1] - p[:, 1] * d[:, 0]) / 2
        moment += w * np.array([np.sum(p[:, 0] ** 2 * d[:, 1]) / 2, -np.sum(p[:, 1] ** 2 * d[:, 0]) / 2])
    return area, moment


def surface_boundary(mesh, kind):
    """Volume and first moment of a solid from its boundary of quadratic triangles or quads, by the divergence
    theorem: V = 1/3 int x.n dS, int x_i dV = 1/2 int x_i^2 n_i dS."""
    x = mesh.points[np.concatenate([b.data for b in mesh.cells if b.type == kind])]
    volume, moment = 0.0, np.zeros(3)
    gauss, weights = np.polynomial.legendre.leggauss(6)
    gauss, weights = (gauss + 1) / 2, weights / 2
    for u, wu in zip(gauss, weights):
        for v, wv in zip(gauss, weights):
            if kind == "triangle6":
                shape, weight = triangle6(u, v * (1 - u)), wu * wv * (1 - u)
            else:
                shape, weight = quad9(u, v, x.shape[1]), wu * wv
            p, du, dv = (np.einsum("n,eni->ei", s, x) for s in shape)
            normal = np.cross(du, dv) * weight
            volume += np.sum(p * normal) / 3
            moment += np.sum(p ** 2 * normal, axis=0) / 2
    return abs(volume), moment * np.sign(volume)


def triangle6(r, s):
    t = 1 - r - s
    values = [t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * t * r, 4 * r * s, 4 * s * t]
    by_r = [1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s]
    by_s = [1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)]
    return np.array(values), np.array(by_r), np.array(by_s)


def quad9(u, v, n_nodes):
    if n_nodes == 8:
        return quad8(u, v)
    def line(t):
        return [(2 * t - 1) * (t - 1), t * (2 * t - 1), 4 * t * (1 - t)], [4 * t - 3, 4 * t - 1, 4 - 8 * t]
    (a, da), (b, db) = line(u), line(v)
    order = [(0, 0), (1, 0), (1, 1), (0, 1), (2, 0), (1, 2), (2, 1), (0, 2), (2, 2)]
    return tuple(np.array([f[i] * g[j] for i, j in order]) for f, g in ((a, b), (da, b), (a, db)))


def quad8(u, v):
    """Serendipity functions on [0, 1]^2, derivatives by complex steps (exact to round-off)."""
    def values(u, v):
        r, s = 2 * u - 1, 2 * v - 1
        corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        result = [(1 + r * a) * (1 + s * b) * (r * a + s * b - 1) / 4 for a, b in corners]
        return np.array(result + [(1 - r * r) * (1 - s) / 2, (1 - s * s) * (1 + r) / 2, (1 - r * r) * (1 + s) / 2,
                                  (1 - s * s) * (1 - r) / 2])
    h = 1e-30
    return values(u, v), values(u + 1j * h, v).imag / h, values(u, v + 1j * h).imag / h


class PdmeshTest(unittest.TestCase):
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
        run = subprocess.run([sys.executable, str(PDMESH), *map(str, arguments)], cwd=self.folder, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(run.returncode, expect, run.stdout + run.stderr)
        return run.stdout, run.stderr

    def cut_short(self, name, length):
        (self.folder / f"short_{name}").write_text((self.folder / name).read_text()[:length])
        return f"short_{name}"

    def with_other_nodes(self, name):
        text = re.sub(r"^(\d+ 2 2 7 1 .*) \d+$", r"\1 99999", (self.folder / name).read_text(), flags=re.M)
        (self.folder / "other.msh").write_text(text)
        return "other.msh"

    def convert(self, mesh, *arguments):
        self.pdmesh("convert", mesh, "points.txt", *arguments)
        return Result(self.folder / "points.txt")

    def node_set(self, name):
        return np.loadtxt(self.folder / f"{name}.txt", comments="#", dtype=int, ndmin=1) - 1

    def check(self, result, volume, moment):
        self.assertLess(abs(result.total / volume - 1), TOLERANCE)
        np.testing.assert_allclose(result.moment[:len(moment)], moment, rtol=TOLERANCE, atol=TOLERANCE * volume)

    # Volumes and first moments

    def test_plane_elements_fill_the_rectangle(self):
        for options in ([], ["-format", "msh22"], ["-format", "msh40"], ["-bin"], ["-format", "msh22", "-bin"],
                        ["-setnumber", "Mesh.RecombineAll", "1"]):
            for at in ("centroids", "nodes"):
                with self.subTest(options=options, at=at):
                    mesh = self.gmsh(SQUARE, 2, *options)
                    result = self.convert(mesh, "--at", at, "--thickness", 0.5)
                    self.check(result, 1.0, [1.0, 0.5, 0.0])

    def test_solid_elements_fill_the_box(self):
        for kind, recombine in (("tetra", ("", "")), ("wedge", ("", "Recombine;")),
                                ("hexahedron", ("Recombine;", "Recombine;"))):
            for at in ("centroids", "nodes"):
                with self.subTest(kind=kind, at=at):
                    mesh = self.gmsh(BOX % recombine, 3)
                    self.assertIn(kind, {block.type for block in meshio.read(mesh).cells})
                    self.check(self.convert(mesh, "--at", at), 6.0, [3.0, 6.0, 9.0])

    def test_nodes_take_the_integral_of_their_shape_function(self):
        # One distorted quad and one distorted hexahedron: the share of corner i is the integral of its (bi-, trilinear)
        # shape function, here by Gauss points of a higher order than pdmesh takes, without its shape functions.
        random = np.random.default_rng(7)
        for dimension, kind in ((2, "quad"), (3, "hexahedron")):
            turn = [(0, 0), (1, 0), (1, 1), (0, 1)]
            signs = np.array(turn if dimension == 2 else [c + (z,) for z in (0, 1) for c in turn], float)
            corners = np.zeros((len(signs), 3))
            corners[:, :dimension] = signs + random.uniform(-0.2, 0.2, signs.shape)
            meshio.write(self.folder / "one.vtu", meshio.Mesh(corners, [(kind, np.arange(len(signs))[None])]))
            expected = np.zeros(len(signs))
            gauss, weights = np.polynomial.legendre.leggauss(7)
            for index in np.ndindex(*[7] * dimension):
                xi = (gauss[list(index)] + 1) / 2
                factors = np.where(signs == 1, xi, 1 - xi)
                gradient = np.stack([(2 * signs[:, d] - 1) * np.delete(factors, d, axis=1).prod(axis=1)
                                     for d in range(dimension)])
                jacobian = gradient @ corners[:, :dimension]
                expected += factors.prod(axis=1) * np.linalg.det(jacobian) * np.prod(weights[list(index)] / 2)
            result = self.convert("one.vtu", "--at", "nodes")
            np.testing.assert_allclose(result.volume, expected, rtol=TOLERANCE)
            self.assertGreater(np.ptp(expected), 0.1 * expected.mean())  # an average would be far off

    def test_pyramids_fill_the_cube(self):
        # Six pyramids from the faces of the unit cube to its centre, one base corner moved: the bases are not planar,
        # what one face gains is taken from nothing else, so the moved cube's volume is the trilinear hexahedron's.
        corners = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
        nodes = np.vstack([corners, [[0.5, 0.5, 0.5]]])
        bases = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        cells = [("pyramid", np.array([base[::-1] + (8,) for base in bases]))]
        meshio.write(self.folder / "cube.vtu", meshio.Mesh(nodes, cells))
        self.check(self.convert("cube.vtu"), 1.0, [0.5, 0.5, 0.5])
        self.check(self.convert("cube.vtu", "--at", "nodes"), 1.0, [0.5, 0.5, 0.5])

    def test_curved_plane_elements_match_their_boundary_integral(self):
        for options in ([], ["-setnumber", "Mesh.RecombineAll", "1"],
                        ["-setnumber", "Mesh.RecombineAll", "1", "-setnumber", "Mesh.SecondOrderIncomplete", "1"]):
            with self.subTest(options=options):
                mesh = self.gmsh(RING, 2, "-order", "2", *options)
                area, moment = ring_boundary(meshio.read(mesh), [0.3, -0.2], 0.7)
                self.assertLess(abs(area / (np.pi * 0.84) - 1), 1e-3)  # the mesh is a ring at all
                self.check(self.convert(mesh), area, moment)
                self.assertLess(abs(self.convert(mesh, "--at", "nodes").total / area - 1), TOLERANCE)

    def test_curved_tetrahedra_match_their_boundary_integral(self):
        mesh = self.gmsh(BALL, 3, "-order", "2")
        volume, moment = surface_boundary(meshio.read(mesh), "triangle6")
        self.assertLess(abs(volume / (4 / 3 * np.pi) - 1), 1e-2)
        self.check(self.convert(mesh), volume, moment)
        nodes = self.convert(mesh, "--at", "nodes")
        self.assertLess(abs(nodes.total / volume - 1), TOLERANCE)
        self.assertGreater(nodes.volume.min(), 0)

    def test_curved_hexahedra_match_their_boundary_integral(self):
        for incomplete, kind in ((0, "quad9"), (1, "quad8")):
            with self.subTest(kind=kind):
                mesh = self.gmsh(BENT, 3, "-order", "2", "-setnumber", "Mesh.SecondOrderIncomplete", str(incomplete))
                volume, moment = surface_boundary(meshio.read(mesh), kind)
                # Pappus: area times the way of its centroid, a quarter turn at radius 1.25.
                self.assertLess(abs(volume / (0.35 * 1.25 * np.pi / 2) - 1), 1e-3)
                self.check(self.convert(mesh), volume, moment)

    def test_second_order_wedges_fill_the_box(self):
        for incomplete in (0, 1):
            with self.subTest(incomplete=incomplete):
                mesh = self.gmsh(BOX % ("", "Recombine;"), 3, "-order", "2", "-setnumber",
                                 "Mesh.SecondOrderIncomplete", str(incomplete))
                self.check(self.convert(mesh), 6.0, [3.0, 6.0, 9.0])

    def test_clockwise_elements_have_positive_volumes(self):
        nodes = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
        meshio.write(self.folder / "a.vtk", meshio.Mesh(np.c_[nodes, 0 * nodes[:, :1]],
                                                        [("triangle", np.array([[0, 2, 1], [0, 2, 3]]))]))
        self.assertGreater(self.convert("a.vtk").volume.min(), 0.49)

    def test_far_from_the_origin_nothing_is_lost(self):
        text = SQUARE + "Translate {1e6, -1e6, 0} { Surface{1, 2}; }\n"
        result = self.convert(self.gmsh(text, 2))
        # A coordinate of 1e6 is good to 1e-10, an edge of 0.1 to 1e-9.
        self.assertLess(abs(result.total / 2 - 1), 1e-9)

    def test_scale_acts_on_coordinates_not_on_thickness(self):
        result = self.convert(self.gmsh(SQUARE, 2), "--scale", "1e-3", "--thickness", "0.5")
        self.check(result, 1e-6, [1e-9, 0.5e-9])

    # Blocks and node sets

    def test_physical_groups_become_blocks(self):
        for options in ([], ["-format", "msh22"]):
            result = self.convert(self.gmsh(SQUARE, 2, *options))
            self.assertEqual(set(result.block), {3, 7})
            self.assertTrue(np.all((result.x[:, 0] < 1) == (result.block == 7)))
            self.assertAlmostEqual(result.volume[result.block == 3].sum(), 1.0, delta=1e-12)

    def test_groups_that_overlap_become_node_sets(self):
        # In format 2.2 Gmsh writes an element once for each of its groups.
        text = SQUARE + 'Physical Surface("both", 20) = {1, 2};\n'
        for options in ([], ["-format", "msh22"]):
            with self.subTest(options=options):
                result = self.convert(self.gmsh(text, 2, *options), "--layer-depth", "0.1")
                self.assertEqual(set(result.block), {3, 7})
                self.check(result, 2.0, [2.0, 1.0])
                np.testing.assert_array_equal(self.node_set("both"), np.arange(len(result.x)))
                result = self.convert("mesh.msh", "--blocks", "both")
                self.assertEqual(set(result.block), {20})
                np.testing.assert_array_equal(self.node_set("soft"), np.flatnonzero(result.x[:, 0] < 1))

    def test_elements_in_no_group_and_groups_without_a_name(self):
        text = SQUARE.replace('Physical Surface("stiff", 3) = {2};', "Mesh.SaveAll = 1;").replace(
            'Physical Curve("left", 12) = {4};', 'Physical Curve("soft", 30) = {-4}; Physical Curve(31) = {5};')
        result = self.convert(self.gmsh(text, 2))
        np.testing.assert_array_equal(result.block, np.where(result.x[:, 0] < 1, 7, 8))
        self.assertLess(result.x[self.node_set("soft"), 0].max(), 0.1)  # the curve, not the surface of the same name
        self.assertLess(result.x[self.node_set("group_1d_31"), 1].max(), 0.1)

    def test_mixed_element_types_in_both_formats(self):
        # Wedges on the left, hexahedra on the right of a common face.
        text = SQUARE.split("Physical")[0] + """
        Transfinite Surface {2}; Recombine Surface {2};
        c[] = Extrude {0, 0, 3} { Surface{1}; Layers{5}; Recombine; };
        d[] = Extrude {0, 0, 3} { Surface{2}; Layers{5}; Recombine; };
        Physical Volume("left", 4) = {c[1]}; Physical Volume("right", 2) = {d[1]};
        """
        tables = []
        for options in ([], ["-format", "msh22"]):
            mesh = self.gmsh(text, 3, *options)
            self.assertLessEqual({"wedge", "hexahedron"}, {block.type for block in meshio.read(mesh).cells})
            result = self.convert(mesh)
            self.check(result, 6.0, [6.0, 3.0, 9.0])
            np.testing.assert_array_equal(result.block, np.where(result.x[:, 0] < 1, 4, 2))
            tables.append(result.table[np.lexsort(result.x.T)])
        np.testing.assert_array_equal(tables[0], tables[1])

    def test_groups_become_node_sets_of_adjacent_elements(self):
        mesh = self.gmsh(SQUARE, 2, "-setnumber", "Mesh.RecombineAll", "0")
        result = self.convert(mesh)
        source = meshio.read(mesh)
        n_top = sum(np.count_nonzero(tag == 11) for tag, b in zip(source.cell_data["gmsh:physical"], source.cells)
                    if b.type == "line")
        top = self.node_set("top")
        self.assertEqual(len(top), n_top)  # one triangle on each edge
        self.assertGreater(result.x[top, 1].min(), 0.9)
        self.assertLess(result.x[self.node_set("left"), 0].max(), 0.1)
        corner = result.x[self.node_set("corner")]
        self.assertGreaterEqual(len(corner), 1)
        self.assertLess(np.abs(corner - [2, 1, 0]).max(), 0.1)

    def test_groups_become_node_sets_of_nodes(self):
        result = self.convert(self.gmsh(SQUARE, 2), "--at", "nodes")
        np.testing.assert_array_equal(self.node_set("top"), np.flatnonzero(result.x[:, 1] > 1 - 1e-9))

    def test_layers_reach_their_depth_and_no_further(self):
        result = self.convert(self.gmsh(SQUARE, 2), "--layer-depth", "0.26", "--layer-depth", "left=0.51")
        np.testing.assert_array_equal(self.node_set("top"), np.flatnonzero(result.x[:, 1] > 0.74))
        np.testing.assert_array_equal(self.node_set("left"), np.flatnonzero(result.x[:, 0] < 0.51))
        distance = np.hypot(result.x[:, 0] - 2, result.x[:, 1] - 1)
        np.testing.assert_array_equal(self.node_set("corner"), np.flatnonzero(distance < 0.26))

    def test_layers_of_surfaces(self):
        result = self.convert(self.gmsh(BOX % ("Recombine;", "Recombine;"), 3), "--layer-depth", "1.3")
        np.testing.assert_array_equal(self.node_set("top"), np.flatnonzero(result.x[:, 2] > 1.7))
        ball = self.convert(self.gmsh(BALL, 3), "--layer-depth", "0.2")
        depth = 1 - np.linalg.norm(ball.x - [0.3, -0.2, 0.5], axis=1)
        chosen = np.isin(np.arange(len(depth)), self.node_set("boundary"))
        # Facets of a size of 0.5 lie up to 0.5^2 / 6 inside the sphere.
        self.assertTrue(chosen[depth < 0.15].all())
        self.assertFalse(chosen[depth > 0.25].any())

    def test_node_sets_by_expression(self):
        result = self.convert(self.gmsh(SQUARE, 2), "--node-set", "far right: x > 1.5 and not y > 0.5",
                              "--node-set", "band: 0.4 < y < 0.6 or hypot(x, y) < 0.2")
        x, y = result.x[:, 0], result.x[:, 1]
        np.testing.assert_array_equal(self.node_set("far_right"), np.flatnonzero((x > 1.5) & (y <= 0.5)))
        np.testing.assert_array_equal(self.node_set("band"),
                                      np.flatnonzero(((y > 0.4) & (y < 0.6)) | (np.hypot(x, y) < 0.2)))

    def test_other_formats_give_the_same_points(self):
        mesh = self.gmsh(BOX % ("Recombine;", "Recombine;"), 3)
        expected = self.convert(mesh).table
        source = meshio.read(mesh)
        solid = meshio.Mesh(source.points, [b for b in source.cells if b.type == "hexahedron"])
        for name in ("box.vtu", "box.inp", "box.vtk", "box.xdmf", "box.e"):
            with self.subTest(name=name):
                solid.write(self.folder / name)
                np.testing.assert_allclose(self.convert(name).table, expected, rtol=1e-12, atol=1e-12)

    def test_exodus_blocks_node_sets_and_side_sets(self):
        import netCDF4
        # Two hexahedra of second order side by side along x, in Exodus' order of nodes: the upright edges before those
        # of the top.
        corners = np.array([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
        edges = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4)]
        one = np.vstack([corners, [(corners[i] + corners[j]) / 2 for i, j in edges]])
        with netCDF4.Dataset(self.folder / "two.exo", "w", format="NETCDF3_64BIT") as data:
            sizes = dict(num_dim=3, num_nodes=40, num_el_blk=2, side=1, node=8, twenty=20, one=1, two=2, len_name=33)
            for name, size in sizes.items():
                data.createDimension(name, size)
            for i, name in enumerate(("coordx", "coordy", "coordz")):
                data.createVariable(name, "f8", ("num_nodes",))[:] = np.concatenate([one, one + [1, 0, 0]])[:, i]
            names = data.createVariable("eb_names", "S1", ("two", "len_name"))
            names[:] = np.array([list(name.ljust(33, "\0")) for name in ("steel", "weld")], "S1")
            data.createVariable("eb_prop1", "i4", ("two",))[:] = [30, 10]
            for i in (1, 2):
                connect = data.createVariable(f"connect{i}", "i4", ("one", "twenty"))
                connect.elem_type = "HEX20"
                connect[:] = np.arange(20)[None] + 20 * (i - 1) + 1
            data.createVariable("ss_prop1", "i4", ("one",))[:] = [5]
            data.createVariable("elem_ss1", "i4", ("side",))[:] = [2]
            data.createVariable("side_ss1", "i4", ("side",))[:] = [2]  # the face at the far end along x
            data.createVariable("ns_prop1", "i4", ("one",))[:] = [4]
            data.createVariable("node_ns1", "i4", ("node",))[:] = [1, 4, 5, 8, 12, 13, 16, 20]
        result = self.convert("two.exo")
        np.testing.assert_array_equal(result.block, [30, 10])
        np.testing.assert_allclose(result.x, [[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]], atol=1e-14)
        np.testing.assert_array_equal(self.node_set("surface_5"), [1])
        np.testing.assert_array_equal(self.node_set("nodelist_4"), [0])
        self.assertIn("block_30: steel", (self.folder / "points.txt").read_text())
        result = self.convert("two.exo", "--at", "nodes")
        np.testing.assert_array_equal(np.sort(result.x[self.node_set("surface_5"), 0]), [2, 2, 2, 2])

    def test_abaqus_element_sets_become_blocks_and_node_sets_stay(self):
        (self.folder / "two.inp").write_text(
            "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 2, 0, 0\n4, 0, 1, 0\n5, 1, 1, 0\n6, 2, 1, 0\n"
            "*ELEMENT, TYPE=CPS4, ELSET=LEFT\n1, 1, 2, 5, 4\n*ELEMENT, TYPE=CPS4, ELSET=RIGHT\n2, 2, 3, 6, 5\n"
            "*NSET, NSET=ENDS\n1, 4\n")
        result = self.convert("two.inp")
        np.testing.assert_array_equal(result.block, [1, 2])
        np.testing.assert_allclose(result.x, [[0.5, 0.5, 0], [1.5, 0.5, 0]], atol=1e-15)
        np.testing.assert_array_equal(self.node_set("ENDS"), [0])

    # Reports and refusals

    def test_a_short_horizon_and_slivers_are_warned_of(self):
        mesh = self.gmsh(SQUARE, 2)
        self.assertIn("shorter than 3 spacings", self.pdmesh("convert", mesh, "p.txt", "--horizon", "0.1")[1])
        self.assertNotIn("shorter than 3", self.pdmesh("convert", mesh, "p.txt", "--horizon", "0.4")[1])
        nodes = np.array([[0, 0, 0], [1, 0, 0], [0.5, 0.01, 0], [0.5, 1, 0]])
        meshio.write(self.folder / "s.vtk", meshio.Mesh(nodes, [("triangle", np.array([[0, 1, 2], [0, 2, 3]]))]))
        self.assertIn("1 elements are slivers", self.pdmesh("convert", "s.vtk", "p.txt")[1])

    def test_refusals_say_why(self):
        overlap = SQUARE.replace('stiff", 3) = {2}', 'stiff", 3) = {1, 2}')
        tilted = SQUARE + "Rotate {{1, 0, 0}, {0, 0, 0}, 0.1} { Surface{1, 2}; }\n"
        cases = [
            (["convert", "none.msh", "p.txt"], "no such file"),
            (["convert", self.gmsh(overlap, 2, name="overlap.msh"), "p.txt"], "--blocks A,B"),
            (["convert", self.gmsh(overlap, 2, "-format", "msh22", name="twice.msh"), "p.txt"], "--blocks A,B"),
            (["convert", "twice.msh", "p.txt", "--blocks", "hard"], "no group hard of 2D elements (there are: stiff, soft)"),
            (["convert", "mesh.geo", "p.txt"], "gmsh -2 mesh.geo"),
            (["convert", self.cut_short("twice.msh", 9000), "p.txt"], "not whole"),
            (["convert", self.cut_short("overlap.msh", 9000), "p.txt"], "is it whole?"),
            (["convert", self.with_other_nodes("twice.msh"), "p.txt"], "nodes that are not there"),
            (["convert", self.gmsh(tilted, 2, name="tilted.msh"), "p.txt"], "plane z = constant"),
            (["convert", self.gmsh(SQUARE, 2, "-order", "3", name="cubic.msh"), "p.txt"], "first or second order"),
            (["convert", self.gmsh(SQUARE, 2, name="good.msh"), "p.txt", "--layer-depth", "tpo=0.1"], "no group tpo"),
            (["convert", "good.msh", "p.txt", "--node-set", "a: y >"], "expression"),
            (["convert", "good.msh", "p.txt", "--node-set", "a: height > 1"], "unknown name `height`"),
            (["convert", "good.msh", "p.txt", "--node-set", "a: y + 1"], "not a condition"),
            (["convert", "good.msh", "p.txt", "--node-set", "top: y > 1"], "group of this name"),
            (["convert", "good.msh", "top.txt"], "already taken"),
            (["convert", "good.msh", "p.txt", "--scale", "-1"], "must be positive"),
            (["convert", "good.msh", "missing/p.txt"], "cannot be written"),
            (["grid", "disc", "--spacing", "0.1", "-o", "p.txt"], "needs --radius"),
            (["grid", "box", "--size", "1", "1", "--spacing", "1e-9", "-o", "p.txt"], "too many"),
            (["grid", "box", "--size", "1", "1", "--spacing", "0.1", "-o", "p.txt", "--jitter", "0.6"], "[0, 0.5)"),
            (["grid", "box", "--size", "1", "1", "--spacing", "0.1", "-o", "p.txt", "--remove", "x > -1"], "nothing"),
        ]
        (self.folder / "bad.txt").write_text("# x y z block volume\n0 0 0 1 1\n0 0 1 1\n")
        (self.folder / "word.txt").write_text("0 0 0 1 one\n")
        cases += [(["info", "bad.txt"], "bad.txt:3: expected 5 numbers"), (["info", "word.txt"], "word.txt:1: `one`")]
        for arguments, message in cases:
            with self.subTest(arguments=arguments):
                output, errors = self.pdmesh(*arguments, expect=2)
                self.assertIn(message, errors)
                self.assertNotIn("Traceback", errors)

    def test_folded_elements_are_refused(self):
        nodes = np.array([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0.0]])
        meshio.write(self.folder / "bow.vtk", meshio.Mesh(nodes, [("quad", np.array([[0, 1, 2, 3]]))]))
        self.assertIn("fold over themselves", self.pdmesh("convert", "bow.vtk", "p.txt", expect=2)[1])

    # Lattices

    def grid(self, *arguments):
        self.pdmesh("grid", *arguments, "-o", "grid.txt")
        return Result(self.folder / "grid.txt")

    def test_boxes_in_one_two_and_three_dimensions(self):
        line = self.grid("box", "--size", 1, "--spacing", 0.1, "--thickness", 0.5)
        self.check(line, 0.5, [0.25, 0, 0])
        plane = self.grid("box", "--size", 1, 2, "--spacing", 0.1, 0.25, "--origin", 1, 1, 5, "--thickness", 0.5)
        self.assertEqual(len(plane.x), 80)
        self.check(plane, 1.0, [1.5, 2.0, 5.0])
        self.check(self.grid("box", "--size", 1, 2, 3, "--spacing", 0.3), 6.0, [3.0, 6.0, 9.0])

    def test_round_shapes(self):
        disc = self.grid("disc", "--radius", 1, "--spacing", 0.02, "--origin", 1, 2, "--fit-volume")
        self.check(disc, np.pi, [np.pi, 2 * np.pi])
        tube = self.grid("tube", "--radius", 1, "--inner-radius", 0.5, "--length", 2, "--spacing", 0.05)
        self.assertLess(abs(tube.total / (np.pi * 0.75 * 2) - 1), 0.01)
        radius = np.hypot(tube.x[:, 0], tube.x[:, 1])
        self.assertTrue(np.all((radius >= 0.5) & (radius <= 1)))

    def test_cuts_remove_what_they_name(self):
        cut = self.grid("box", "--size", 1, 1, "--spacing", 0.01, "--hole", 0.7, 0.5, 0.2, "--notch", 0, 0.5, 0.3, 0.5,
                        0.02, "--wedge", 0.1, 0, 90, 20, "--remove", "x > 0.95 and y < 0.05")
        x, y = cut.x[:, 0], cut.x[:, 1]
        self.assertFalse(np.any(np.hypot(x - 0.7, y - 0.5) < 0.2))
        self.assertFalse(np.any((x < 0.3) & (abs(y - 0.5) < 0.01)))
        self.assertFalse(np.any(abs(x - 0.1) < 0.99 * y * np.tan(np.radians(10))))
        self.assertFalse(np.any((x > 0.95) & (y < 0.05)))
        # The wedge is cut off by the left edge at x = 0, 0.1 from its axis: both halves counted whole, their overlap with
        # the notch too, so this is the most that can be lost; half of the wedge is the least.
        others = np.pi * 0.04 + 0.0025
        wedge = np.tan(np.radians(10))
        self.assertLess(cut.total, 1 - others - wedge / 2 + 0.005)
        self.assertGreater(cut.total, 1 - others - 0.3 * 0.02 - wedge - 0.005)

    def test_the_widest_step_of_a_lattice_rules_the_horizon(self):
        output, errors = self.pdmesh("grid", "box", "--size", 1, 1, "--spacing", 0.02, 0.05, "--horizon", 0.1, "-o", "a.txt")
        self.assertIn("fitting horizon 0.1508 m", output)
        self.assertIn("shorter than 3 spacings", errors)

    def test_jitter_is_bounded_and_repeats_with_its_seed(self):
        still = self.grid("box", "--size", 1, 1, "--spacing", 0.1)
        moved = self.grid("box", "--size", 1, 1, "--spacing", 0.1, "--jitter", 0.3, "--seed", 5)
        again = self.grid("box", "--size", 1, 1, "--spacing", 0.1, "--jitter", 0.3, "--seed", 5)
        other = self.grid("box", "--size", 1, 1, "--spacing", 0.1, "--jitter", 0.3, "--seed", 6)
        np.testing.assert_array_equal(moved.table, again.table)
        self.assertTrue(np.any(moved.table != other.table))
        self.assertLessEqual(np.abs(moved.x - still.x).max(), 0.03)
        self.assertTrue(np.all(moved.x[:, 2] == 0))

    def test_blocks_and_node_sets_of_a_lattice(self):
        result = self.grid("box", "--size", 1, 1, "--spacing", 0.1, "--block", "2: x > 0.5", "--node-set",
                           "right: block == 2")
        self.assertTrue(np.all((result.x[:, 0] > 0.5) == (result.block == 2)))
        np.testing.assert_array_equal(self.node_set("right"), np.flatnonzero(result.block == 2))

    def test_info_and_export(self):
        self.grid("box", "--size", 1, 2, 1, "--spacing", 0.25, "--node-set", "top: y > 1.75")
        output, errors = self.pdmesh("info", "grid.txt", "top.txt", "--horizon", "0.8")
        self.assertIn("128 points, 3D", output)
        self.assertIn("node set top: 16 points", output)
        self.pdmesh("export", "grid.txt", "grid.vtu", "--node-sets", "top.txt")
        exported = meshio.read(self.folder / "grid.vtu")
        self.assertEqual(exported.point_data["top"].sum(), 16)
        self.assertAlmostEqual(exported.point_data["volume"].sum(), 2.0, delta=1e-12)
        (self.folder / "beyond.txt").write_text("129\n")
        self.assertIn("points 1 to 128", self.pdmesh("info", "grid.txt", "beyond.txt", expect=2)[1])


if __name__ == "__main__":
    unittest.main()
