#!/usr/bin/python3
"""Tests of meshes/pdmesh on what Gmsh really writes: volumes and first moments against independent computations; and of
its lattices."""
import unittest
from pathlib import Path

import meshio
import numpy as np
from pdmesh_case import BALL, BENT, BOX, RING, SQUARE, TOLERANCE, PdmeshCase, Result

from pdmesh_lib.lattice import onto_lattice
from pdmesh_lib.points import Points


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


DECKS = Path(__file__).resolve().parents[2] / "decks"


class Volumes(PdmeshCase):
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


class Lattices(PdmeshCase):
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

    def test_negative_numbers_with_an_exponent(self):
        small = self.grid("box", "--size", 2e-4, 1e-4, "--spacing", 1e-5, "--origin", -5e-05, -1e-05)
        np.testing.assert_allclose(small.x.min(axis=0)[:2], [-4.5e-5, -5e-6])

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
        # The wedge is cut off by the left edge at x = 0, 0.1 from its axis: both halves counted whole, their overlap
        # with the notch too, so this is the most that can be lost; half of the wedge is the least.
        others = np.pi * 0.04 + 0.0025
        wedge = np.tan(np.radians(10))
        self.assertLess(cut.total, 1 - others - wedge / 2 + 0.005)
        self.assertGreater(cut.total, 1 - others - 0.3 * 0.02 - wedge - 0.005)

    def test_the_widest_step_of_a_lattice_rules_the_horizon(self):
        output, errors = self.pdmesh("grid", "box", "--size", 1, 1, "--spacing", 0.02, 0.05, "--horizon", 0.1, "-o",
                                     "a.txt")
        self.assertIn("fitting horizon 0.1508 m", output)
        self.assertIn("shorter than 3 spacings", errors)

    def test_cuts_that_do_nothing_and_notches_that_bonds_span_are_warned_of(self):
        arguments = ["grid", "box", "--size", 1, 1, "--spacing", 0.1, "-o", "a.txt", "--horizon", 0.301]
        errors = self.pdmesh(*arguments, "--notch", 0, 0.5, 0.5, 0.5, 0.05, "--hole", 3, 3, 1)[1]
        self.assertIn("--notch 0 0.5 0.5 0.5 0.05 removes no point", errors)
        self.assertIn("--notch 0 0.5 0.5 0.5 0.05 is narrower than the horizon", errors)
        self.assertIn("--hole 3 3 1 removes no point", errors)
        self.assertEqual(self.pdmesh(*arguments, "--notch", 0, 0.5, 0.5, 0.5, 0.4)[1], "")

    def test_a_turned_lattice_is_the_same_body_elsewhere(self):
        common = ["box", "--size", 2, 1, "--spacing", 0.1, "--origin", 1, 1, "--node-set", "right: x > 2.9"]
        still = self.grid(*common)
        chosen = np.loadtxt(self.folder / "right.txt", comments="#")
        turned = self.grid(*common, "--turn", 90)
        np.testing.assert_array_equal(np.loadtxt(self.folder / "right.txt", comments="#"), chosen)
        np.testing.assert_array_equal(turned.volume, still.volume)
        x, y = still.x[:, 0] - 1, still.x[:, 1] - 1
        np.testing.assert_allclose(turned.x, np.column_stack([1 - y, 1 + x, 0 * x]), atol=1e-14)

    def test_flat_cells_are_no_points_too_close(self):
        self.assertEqual(self.pdmesh("grid", "box", "--size", 1, 1, "--spacing", 0.25, 0.01, "-o", "a.txt")[1], "")

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

    def test_structured_meshes_are_put_onto_their_lattice_and_no_others(self):
        # Nodes of a transfinite mesh are some 1e-10 spacings beside their places.
        mesh = self.gmsh((DECKS / "hydrogen_plate" / "plate.geo").read_text(), 2)
        result = self.convert(mesh, "--thickness", 0.004)
        rows = (result.x[:, :2] - [0.0, -0.05]) / (0.2 / 148) - 0.5
        self.assertLess(np.abs(rows - np.rint(rows)).max(), 1e-8)
        self.assertEqual([len(np.unique(result.x[:, d])) for d in (0, 1)], [148, 74])
        self.assertEqual(len(np.unique(result.volume)), 1)
        self.check(result, 8e-5, [8e-6, 0.0])

    def test_a_lattice_is_one_to_a_hundred_millionth_of_its_spacing(self):
        exact = np.array([[i + 0.5, j + 0.5, 0.0] for j in range(5) for i in range(8)])
        for jitter, is_one in ((3e-9, True), (3e-8, False), (1e-2, False)):
            x = exact.copy()
            x[:, :2] += jitter * (np.random.default_rng(1).random((len(x), 2)) - 0.5)
            points = Points(x.copy(), np.ones(len(x), int), np.ones(len(x)), 2, 1.0)
            found = onto_lattice(points)
            self.assertEqual(found is not None, is_one, jitter)
            self.assertLess(np.abs(points.x - (exact if is_one else x)).max(), jitter if is_one else 1e-300)

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
        self.assertIn("beyond.txt:1: node 129 is not in the mesh, which has points 1 to 128",
                      self.pdmesh("info", "grid.txt", "beyond.txt", expect=2)[1])


if __name__ == "__main__":
    unittest.main()
