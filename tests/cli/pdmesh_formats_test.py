#!/usr/bin/python3
"""Tests of meshes/pdmesh: formats, blocks and node sets from groups, reports and refusals."""
import re
import subprocess
import unittest

import meshio
import numpy as np
from pdmesh_case import BALL, BOX, PDMESH, SQUARE, PdmeshCase


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


class Numbers(PdmeshCase):
    """What people and programs write into text files."""

    def info(self, text, *more, name="p.txt", expect=0):
        (self.folder / name).write_text(text)
        output, errors = self.pdmesh("info", name, *more, expect=expect)
        return output if expect == 0 else errors

    def test_points_are_read_as_pdrun_reads_them(self):
        plain = "0 0 0 1 0.5\n1 0 0 2 1.5\n"
        for text in (plain, "\ufeff" + plain, plain.replace("\n", " # a comment\n"), "/ a\n* b\n\n" + plain,
                     plain.replace("1.5", "1.5D0").replace("2 ", "2.000e+00 "), plain.replace("\n", "\r\n")):
            with self.subTest(text=text):
                self.assertIn("volume 2 m3", self.info(text, name="P.TXT"))
        for text, message in (("0 0 0 1 0,5\n", "p.txt:1: `0,5` is not a number; write 0.5"),
                              (plain + "2 0 0 1.5 1\n", "p.txt:3: the block number (fourth column) is a whole number"),
                              (plain + "2 0 0 0 1\n", "p.txt:3: the block number"),
                              (plain + "2 0 0 1 nan\n", "p.txt:3: not all numbers are finite"),
                              # All blocks are where volumes should be.
                              ("0 0 0 0.5 1\n1 0 0 1.5 2\n", "p.txt: columns 4 and 5 look exchanged")):
            with self.subTest(text=text):
                self.assertIn(message, self.info(text, expect=2))

    def test_node_sets_say_whose_they_are(self):
        grid = ["grid", "box", "--size", 1, 1, "--spacing", 0.1, "--node-set", "top: y > 0.9", "--quiet", "-o"]
        self.pdmesh(*grid, "plate.txt")
        self.assertTrue((self.folder / "top.txt").read_text().startswith("# top: 10 of the 100 points of plate.txt\n"))
        self.assertEqual(self.pdmesh(*grid, "plate.txt")[1], "")
        grid[6] = 0.05
        self.assertIn("top.txt was the node set of plate.txt and now is that of fine.txt",
                      self.pdmesh(*grid, "fine.txt")[1])
        self.assertIn("a node set of the 400 points of fine.txt, and this mesh has 100",
                      self.pdmesh("info", "plate.txt", "top.txt", expect=2)[1])
        self.pdmesh("info", "fine.txt", "top.txt")
        # What is no node set of pdmesh is not written over, and then neither is the mesh.
        before = (self.folder / "plate.txt").read_text()
        for make in (lambda: (self.folder / "top.txt").write_text("1\n2\n"),
                     lambda: ((self.folder / "top.txt").unlink(), (self.folder / "top.txt").symlink_to("fine.txt"))):
            make()
            self.assertIn("top.txt is there already and is no node set that pdmesh wrote",
                          self.pdmesh(*grid, "plate.txt", expect=2)[1])
            self.assertEqual((self.folder / "plate.txt").read_text(), before)
        (self.folder / "top.txt").unlink()
        self.assertFalse(list(self.folder.glob("*unfinished")))
        # By hand, and by programs that write all numbers alike.
        (self.folder / "hand.txt").write_text("\ufeff1.000e+00 2 # two\n/ none\n3.0\n")
        self.assertIn("node set hand: 3 points", self.pdmesh("info", "plate.txt", "hand.txt")[0])
        for text, message in (("1\n0.5\n", "hand.txt:2: `0.5` is not a whole number"),
                              ("1\n101\n", "hand.txt:2: node 101 is not in the mesh"), ("1,\n", "hand.txt:1: `1,`")):
            (self.folder / "hand.txt").write_text(text)
            self.assertIn(message, self.pdmesh("info", "plate.txt", "hand.txt", expect=2)[1])

    def test_numbers_in_files_of_gmsh(self):
        self.gmsh(SQUARE, 2, "-format", "msh22")
        expected = self.convert("mesh.msh").table
        text = (self.folder / "mesh.msh").read_text()
        nodes, at, elements = text.partition("$Elements")

        def with_node(line):
            return re.sub(r"^2 2 0 0$", line, nodes, flags=re.M)

        high = [row.split() for row in elements.split("\n")]  # number, type, 2, two tags, nodes
        high = "\n".join(" ".join(row[:5] + ["9999999999" if word == "2" else word for word in row[5:]])
                         for row in high)
        for changed in ("\ufeff" + text, with_node("2.0 2.0D0 0 0") + at + elements, text.replace("\n", "\r\n"),
                        with_node("9999999999 2 0 0") + at + high):
            (self.folder / "mesh.msh").write_text(changed)
            np.testing.assert_array_equal(self.convert("mesh.msh").table, expected)
        line = text[:re.search(r"^2 2 0 0$", text, re.M).start()].count("\n") + 1
        (self.folder / "mesh.msh").write_text(with_node("2 2,0 0 0") + at + elements)
        self.assertIn(f"mesh.msh:{line}: $Nodes: `2,0` is not a number; write 2.0",
                      self.pdmesh("convert", "mesh.msh", "p.txt", expect=2)[1])

    def test_element_data_that_numbers_blocks(self):
        nodes = np.array([(x, y, 0) for y in (0, 1) for x in range(5)], float)
        quads = np.array([(i, i + 1, i + 6, i + 5) for i in range(4)])

        def write(values, name="block"):
            data = {name: [np.array(values)]}
            meshio.write(self.folder / "a.vtu", meshio.Mesh(nodes, [("quad", quads)], cell_data=data))

        write([0, -1, 2, 2], "mat")
        output, _ = self.pdmesh("convert", "a.vtu", "points.txt", "--block-field", "mat")
        np.testing.assert_array_equal(np.loadtxt(self.folder / "points.txt")[:, 3], [2, 1, 3, 3])
        self.assertIn("blocks are numbered 1, 2 ...", output)
        self.assertIn("block_1 (group_2d_-1): 1 points", output)
        write([0, 7, 2.0, 2], "block")  # a name that is looked for without being asked
        np.testing.assert_array_equal(self.convert("a.vtu").block, [1, 3, 2, 2])
        write([4, 7, 4, 7], "mat")
        np.testing.assert_array_equal(self.convert("a.vtu", "--block-field", "mat").block, [4, 7, 4, 7])
        for values, message in (([1, 1.5, 2, 2], "`mat` is 1.5 at element 2"),
                                ([1, np.nan, 2, 2], "is nan at element 2"),
                                ([[1, 2]] * 4, "not one number an element")):
            write(values, "mat")
            self.assertIn(message, self.pdmesh("convert", "a.vtu", "p.txt", "--block-field", "mat", expect=2)[1])
        (self.folder / "a.inp").write_text("*NODE\n1, 0., 0.\n")
        self.assertNotEqual(self.pdmesh("convert", "a.inp", "p.txt", "--block-field", "mat", expect=2)[1], "")


def in_order(table):
    """Rows by their places, which files in binary and in text hold with different last digits."""
    return table[np.lexsort(np.round(table[:, :3], 6).T)]


class Partitions(PdmeshCase):
    def test_a_mesh_that_was_cut_is_whole_or_refused(self):
        whole = self.convert(self.gmsh(BOX % ("", ""), 3)).table
        top = self.node_set("top")
        for options in ([], ["-part_ghosts"], ["-part_ghosts", "-bin"], ["-format", "msh40"],
                        ["-part_ghosts", "-format", "msh22"]):
            with self.subTest(options=options):
                result = self.convert(self.gmsh(BOX % ("", ""), 3, "-part", "3", *options, name="cut.msh"))
                np.testing.assert_allclose(in_order(result.table), in_order(whole), rtol=1e-12, atol=1e-12)
                self.assertEqual(len(self.node_set("top")), len(top))
                self.assertFalse((self.folder / "group_2d_1.txt").exists())  # what lies between partitions
        for options in ([], ["-part_ghosts"], ["-format", "msh22"]):
            with self.subTest(split=options):
                subprocess.run(["gmsh", "-3", "mesh.geo", "-part", "3", "-part_split", "-o", "split.msh", *options],
                               cwd=self.folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                self.assertIn("one piece (partition 2) of a mesh that was cut",
                              self.pdmesh("convert", "split_2.msh", "p.txt", expect=2)[1])

    def test_old_and_rare_formats_of_gmsh(self):
        expected = self.convert(self.gmsh(SQUARE, 2)).table
        for options in (["-format", "msh1"], ["-format", "msh22", "-save_parametric"], ["-save_parametric"]):
            with self.subTest(options=options):
                result = self.convert(self.gmsh(SQUARE, 2, *options))
                np.testing.assert_allclose(in_order(result.table), in_order(expected), rtol=1e-12, atol=1e-12)
        self.gmsh(SQUARE, 2, "-part", "2", "-part_split", "-format", "msh22", "-bin", name="split.msh")
        self.assertIn("save it in Gmsh's format 4.1", self.pdmesh("convert", "split_1.msh", "p.txt", expect=2)[1])


class Names(PdmeshCase):
    def test_groups_of_one_name_keep_apart(self):
        text = SQUARE.replace('Physical Point("corner", 13)', 'Physical Point("top", 13)')
        output, _ = self.pdmesh("convert", self.gmsh(text, 2), "points.txt")
        self.assertIn("two groups are called top", output)
        sizes = sorted([len(self.node_set("top")), len(self.node_set("top_1d"))])
        self.assertGreater(sizes[1], 4 * sizes[0])  # a corner, and a side of twenty elements

    def test_upper_case_endings(self):
        self.gmsh(SQUARE, 2)
        (self.folder / "mesh.msh").rename(self.folder / "MESH.MSH")
        self.check(self.convert("MESH.MSH"), 2.0, [2.0, 1.0])
        (self.folder / "MESH.GEO").write_text(SQUARE)
        self.assertIn("this is a drawing", self.pdmesh("convert", "MESH.GEO", "p.txt", expect=2)[1])


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
