#!/usr/bin/python3
"""Tests of meshes/pdmesh: formats, blocks and node sets from groups, reports and refusals."""
import re
import subprocess
import unittest

import meshio
import numpy as np
from pdmesh_case import BALL, BENT, BOX, PDMESH, SQUARE, TOLERANCE, PdmeshCase


class Groups(PdmeshCase):
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

    def test_abaqus_sets_surfaces_and_parts(self):
        nodes = "*NODE\n" + "".join(f"{10 + i}, {x}, {y}\n" for i, (x, y) in enumerate(
            [(0, 0), (1, 0), (2, 0), (3, 0), (0, 1), (1, 1), (2, 1), (3, 1)]))
        # Two kinds of elements in one set, and a first block in none.
        elements = ("*ELEMENT, TYPE=CPS4\n1, 10, 11, 15, 14\n*ELEMENT, TYPE=CPE3, ELSET=Right\n2, 11, 12, 16\n"
                    "3, 11, 16, 15\n*ELEMENT, TYPE=CPS4R,\n ELSET=Right\n4, 12, 13,\n 17, 16\n")
        sets = ("** a comment\n*ELSET, ELSET=Ends\n1, 4\n*ELSET, ELSET=All, GENERATE\n1, 4, 1\n*NSET, NSET=Low, "
                "GENERATE\n10, 13, 1\n*NSET, NSET=Both\nLow, 14\n*SURFACE, NAME=Far, TYPE=ELEMENT\nEnds, S2\n2, S3\n")
        (self.folder / "flat.inp").write_text("*HEADING\nx\n" + nodes + elements + sets)
        part = "*PART, NAME=P\n" + nodes + elements + "*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=P-1, PART=P\n"
        (self.folder / "part.inp").write_text(part + "*END INSTANCE\n" + sets.replace("\n2, S3", "\nP-1.2, S3"))
        (self.folder / "nodes.inc").write_text(nodes)
        (self.folder / "more.inp").write_text("*INCLUDE, INPUT=nodes.inc\n" + elements + sets)
        for name in ("flat.inp", "part.inp", "more.inp"):
            with self.subTest(name=name):
                result = self.convert(name, "--blocks", "Right")
                np.testing.assert_array_equal(result.block, [2, 1, 1, 1])
                np.testing.assert_allclose(result.x[:, 0], [0.5, 5 / 3, 4 / 3, 2.5])
                self.check(result, 3.0, [4.5, 1.5])
                np.testing.assert_array_equal(self.node_set("Ends"), [0, 3])
                np.testing.assert_array_equal(self.node_set("All"), [0, 1, 2, 3])
                # Far: the edges 11-15 and 13-17, and 16-11 within the middle.
                np.testing.assert_array_equal(self.node_set("Far"), [0, 1, 2, 3])
                self.convert(name, "--at", "nodes", "--blocks", "Right")
                np.testing.assert_array_equal(self.node_set("Both"), [0, 1, 2, 3, 4])
                np.testing.assert_array_equal(self.node_set("Far"), [1, 3, 5, 6, 7])
        for text, message in ((part + "1, 0, 0\n*END INSTANCE\n", "several or moved instances"),
                              (nodes + elements.replace("CPS4\n", "CAX4\n"), "axisymmetric elements CAX4"),
                              (nodes + nodes + elements, "node 10 is defined twice"),
                              (nodes + elements.replace("1, 10,", "1, 99,"), "nodes that are not there, as 99"),
                              (nodes + elements.replace("4, 12, 13,", "4, 12, 13, 14,"), "do not hold whole elements"),
                              (nodes.replace("3, 1\n", "3, one\n"), "bad.inp:1: a line of *NODE"),
                              (nodes + elements + "*ELSET, ELSET=B\nNone\n", "no set None")):
            with self.subTest(message=message):
                (self.folder / "bad.inp").write_text(text)
                self.assertIn(message, self.pdmesh("convert", "bad.inp", "p.txt", expect=2)[1])

    def test_what_gmsh_writes_for_abaqus(self):
        mesh = self.gmsh(SQUARE, 2, "-order", "2", "-format", "inp", name="mesh.inp")
        result = self.convert(mesh)
        self.check(result, 2.0, [2.0, 1.0])
        names = dict(re.findall(r"# block_(\d): (\w+)", (self.folder / "points.txt").read_text()))
        soft = next(int(number) for number, name in names.items() if name == "soft")
        np.testing.assert_array_equal(result.x[:, 0] < 1, result.block == soft)
        self.assertGreater(result.x[self.node_set("top"), 1].min(), 0.9)
        mesh = self.gmsh(BENT, 3, "-order", "2", "-setnumber", "Mesh.SecondOrderIncomplete", "1", "-format", "inp",
                         name="mesh.inp")
        total = self.convert(mesh).total
        self.assertLess(abs(total / self.convert(self.gmsh(
            BENT, 3, "-order", "2", "-setnumber", "Mesh.SecondOrderIncomplete", "1")).total - 1), TOLERANCE)


class Refusals(PdmeshCase):
    def test_the_program_starts(self):
        for arguments, code, text in ((["--help"], 0, "sample runs"), (["info", "none.txt"], 2, "pdmesh: none.txt")):
            run = subprocess.run([str(PDMESH), *arguments], cwd=self.folder, text=True, capture_output=True)
            self.assertEqual(run.returncode, code)
            self.assertIn(text, run.stdout + run.stderr)

    def cut_short(self, name, length):
        (self.folder / f"short_{name}").write_text((self.folder / name).read_text()[:length])
        return f"short_{name}"

    def with_other_nodes(self, name):
        text = re.sub(r"^(\d+ 2 2 7 1 .*) \d+$", r"\1 99999", (self.folder / name).read_text(), flags=re.M)
        (self.folder / "other.msh").write_text(text)
        return "other.msh"

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
            (["convert", "twice.msh", "p.txt", "--blocks", "hard"], "no group hard of 2D elements (there are: stiff"),
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


if __name__ == "__main__":
    unittest.main()
