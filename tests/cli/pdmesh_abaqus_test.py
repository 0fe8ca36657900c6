#!/usr/bin/python3
"""Tests of meshes/pdmesh on Abaqus input files: as Abaqus/CAE, Gmsh and people write them."""
import re
import unittest

import numpy as np
from pdmesh_case import BENT, SQUARE, TOLERANCE, PdmeshCase, Result

# Three unit squares in a row; nodes 10 to 17.
NODES = "*NODE\n" + "".join(f"{10 + i}, {x}., {y}.\n" for i, (x, y) in enumerate(
    [(0, 0), (1, 0), (2, 0), (3, 0), (0, 1), (1, 1), (2, 1), (3, 1)]))
QUADS = "*ELEMENT, TYPE=CPS4\n1, 10, 11, 15, 14\n2, 11, 12, 16, 15\n3, 12, 13, 17, 16\n"
THREE = NODES + QUADS


class Abaqus(PdmeshCase):
    def write(self, text, name="a.inp"):
        (self.folder / name).write_text(text)
        return name

    def read(self, text, *arguments):
        return self.convert(self.write(text), "--thickness", 1, *arguments)

    def refusal(self, text, *arguments):
        return self.pdmesh("convert", self.write(text), "p.txt", *arguments, expect=2)[1]

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
        for text, message in ((nodes + elements.replace("CPS4\n", "CAX4\n"), "axisymmetric elements CAX4"),
                              (nodes + nodes + elements, "node 10 is defined twice"),
                              (nodes + elements.replace("1, 10,", "1, 99,"), "nodes that are not there, as 99"),
                              (nodes + elements.replace("4, 12, 13,", "4, 12, 13, 14,"),
                               "bad.inp:17: CPS4R has 4 nodes, and this element 5"),
                              (nodes.replace("3, 1\n", "3, one\n"), "bad.inp:9: *NODE: `one` is not a number"),
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

    def test_what_is_written_elsewhere_is_read_from_there(self):
        elements = QUADS.partition("\n")[2]
        (self.folder / "sub").mkdir()
        self.write("** numbers alone\n" + elements, "elements.inc")
        self.write(NODES.partition("\n")[2], "sub/nodes.inc")
        self.write("1, 3\n", "members.inc")
        ends = "*ELSET, ELSET=Ends\n1, 3\n"
        for text in ("*NODE, INPUT=sub/nodes.inc\n*ELEMENT, TYPE=CPS4, INPUT=elements.inc\n" + ends,
                     NODES + "*Element, type=CPS4\n*include, input=elements.inc\n" + ends,
                     # Data lines before and after what is included belong to the same keyword.
                     NODES + "*Element, type=CPS4\n5, 11, 12, 16, 15\n*Include, input=five.inc\n1, 10, 11, 15, 14\n" +
                     "*ELSET, ELSET=Ends\n3\n*INCLUDE, INPUT=one.inc\n",
                     THREE + "*ELSET, ELSET=Ends\n*INCLUDE, INPUT=members.inc\n",
                     THREE + "*ELSET, ELSET=Ends, INPUT=members.inc\n"):
            self.write("3, 12, 13, 17, 16\n", "five.inc")
            self.write("1,\n", "one.inc")
            with self.subTest(text=text):
                result = self.read(text, "--one-block")
                self.check(result, 3.0, [4.5, 1.5])
                np.testing.assert_allclose(np.sort(result.x[self.node_set("Ends"), 0]), [0.5, 2.5])
        self.assertIn("a.inp:1: INPUT=none.inc: no such file", self.refusal("*NODE, INPUT=none.inc\n" + QUADS))
        self.write(THREE, "whole.inc")
        self.assertIn("whole.inc: *NODE, INPUT= reads lines of data", self.refusal("*NODE, INPUT=whole.inc\n" + QUADS))

    def test_nodes_in_other_systems_and_forms(self):
        # A quarter of a ring of 1 to 2 in one quad: corners at (1, 0), (2, 0), (0, 2), (0, 1).
        polar = "*NODE, SYSTEM=C\n1, 1., 0.\n2, 2., 0.\n3, 2., 90.\n4, 1., 90.\n"
        quad = "*ELEMENT, TYPE=CPS4\n1, 1, 2, 3, 4\n"
        for text in (polar, "\ufeff" + polar, polar.replace("2, 2., 0.", "2, 2., "),
                     polar.replace("2, 2., 0.", "2, 2."),
                     polar.replace("3, 2., 90.", "3.0, 2.D0, 9.0D+1, , 0., 0., 1."),
                     polar.replace("\n", "\r\n")):
            with self.subTest(text=text):
                self.assertAlmostEqual(self.read(text + quad).total, 1.5, delta=1e-12)
        blank = "*NODE\n1, 0., 0., 0.\n2, 1., , 0.\n3, 1., 1., 0.\n4, , 1.,\n"
        self.check(self.read(blank + quad), 1.0, [0.5, 0.5])
        # The axes of *SYSTEM: origin (10, 0, 0), x towards +y, y towards -x; an empty one ends it.
        system = "*SYSTEM\n10., 0., 0., 10., 1., 0.\n9., 0., 0.\n"
        square = "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n"
        np.testing.assert_allclose(self.read(system + square + quad).x, [[9.5, 0.5, 0.0]], atol=1e-15)
        np.testing.assert_allclose(self.read(system.rpartition("9.")[0] + square + quad).x, [[9.5, 0.5, 0]], atol=1e-15)
        np.testing.assert_allclose(self.read(system + "*SYSTEM\n" + square + quad).x, [[0.5, 0.5, 0.0]])
        for text, message in ((square.replace("3, 1., 1., 0.", "3, 1,0, 1,0, 0,0, 0,0"), "decimal points"),
                              (re.sub(r"(\d)\.", r"\1,0", square), "a.inp:2: a line of *NODE"),
                              (square.replace("*NODE", "*NODE, SYSTEM=S"), "spherical"),
                              (square.replace("*NODE", "*NODE, SYSTEM=Q"), "SYSTEM=Q"),
                              (square.replace("3, 1.", "3.5, 1."), "a.inp:4: the label"),
                              (square.replace("*NODE", "*NODE, WIDTH=2"), "the option WIDTH is not understood"),
                              ("1, 2, 3\n" + square, "before the first *KEYWORD")):
            with self.subTest(message=message):
                self.assertIn(message, self.refusal(text + quad))
        self.assertIn("a.inp:7: *ELEMENT: a field is left blank", self.refusal(square + quad.replace("2, 3", "2,, 3")))
        self.assertEqual(self.read(square + quad.replace("1, 1, 2, 3, 4", "1.0, 1., 2., 3., 4.")).total, 1.0)

    def test_keyword_lines_that_go_on_end_with_the_file(self):
        for end in ("*Boundary,", "*Boundary,\n", "*Heading,\n\n\n", "*Nset, nset=Low,\n** why\n generate\n10, 13\n"):
            self.assertEqual(self.read(THREE + end).total, 3.0)
        np.testing.assert_array_equal(self.node_set("Low"), [0, 1, 2])

    def test_high_numbers_cost_nothing(self):
        text = THREE.replace("17", "9999999999").replace("3, 12", "9999999998, 12")
        self.assertEqual(self.read(text).total, 3.0)

    def test_an_upper_case_name_is_the_same_file(self):
        self.write(THREE + "*ELSET, ELSET=Ends\n1, 3\n", "A.INP")
        np.testing.assert_array_equal(self.convert("A.INP").block, [1, 2, 1])

    def test_node_and_element_sets_of_one_name(self):
        # As CAE writes a region: elements where points are elements, nodes where they are nodes.
        pair = "*Nset, nset=Grip\n12, 13, 16, 17\n*Elset, elset=Grip\n3,\n"
        face = "*Nset, nset=End\n13, 17\n*Elset, elset=End\n3,\n"  # the nodes of a face, and what is beside it
        other = "*Nset, nset=Two\n10, 14\n*Elset, elset=Two\n3,\n"  # not the same place at all
        self.read(THREE + pair + face + other, "--one-block")
        for name, expected in (("Grip", [2]), ("End", [2]), ("Two", [2]), ("Two_nodes", [0])):
            np.testing.assert_array_equal(self.node_set(name), expected)
        result = self.read(THREE + pair + face, "--at", "nodes", "--one-block")
        np.testing.assert_array_equal(np.sort(result.x[self.node_set("End"), 0]), [3, 3])
        np.testing.assert_array_equal(np.sort(result.x[self.node_set("Grip"), 0]), [2, 2, 3, 3])
        # Elements beside a face are a condition's, no block; a layer is measured from the face.
        self.assertEqual(set(self.read(THREE + face).block), {1})
        self.read(THREE + face, "--layer-depth", "1.6")
        np.testing.assert_array_equal(self.node_set("End"), [1, 2])
        # A block keeps its node set.
        self.assertEqual(self.read(THREE + pair).block.tolist(), [2, 2, 1])
        np.testing.assert_array_equal(self.node_set("Grip"), [2])

    def test_node_sets_of_element_sets_and_surfaces_of_nodes(self):
        text = THREE + ("*ELSET, ELSET=Left\n1,\n*NSET, NSET=LeftNodes, ELSET=Left\n*NSET, NSET=Low\n10, 11, 12, 13\n"
                        "*SURFACE, NAME=Floor, TYPE=NODE\nLow, 1.\n14, 1.\n")
        result = self.read(text, "--at", "nodes", "--one-block")
        np.testing.assert_array_equal(self.node_set("LeftNodes"), np.flatnonzero(result.x[:, 0] < 1.5))
        np.testing.assert_array_equal(self.node_set("Floor"),
                                      np.flatnonzero((result.x[:, 1] == 0) | (result.x[:, 0] == 0)))

    def test_sections_say_which_sets_are_blocks(self):
        sets = ("*Elset, elset=_PickedSet2, internal\n1,\n*Elset, elset=Rest\n2, 3\n"
                "*Elset, elset=Load, generate\n1, 2\n*Elset, elset=Hold\n2, 3\n")
        sections = ("*Solid Section, elset=_PickedSet2, material=Steel\n,\n"
                    "*Solid Section, elset=Rest, material=Tin\n1.,\n")
        output, _ = self.pdmesh("convert", self.write(THREE + sets + sections), "points.txt")
        self.assertIn("blocks are the element sets of *SECTIONs", output)
        self.assertIn("block_1 (Steel): 1 points", output)
        self.assertIn("block_2 (Rest): 2 points", output)
        np.testing.assert_array_equal(self.node_set("Load"), [0, 1])
        np.testing.assert_array_equal(self.node_set("Hold"), [1, 2])
        # Without sections they overlap, and the message has the remedies; --one-block is one of them.
        message = self.refusal(THREE + sets)
        self.assertIn("--blocks A,B", message)
        self.assertIn("--one-block", message)
        self.assertEqual(set(self.read(THREE + sets, "--one-block").block), {1})
        np.testing.assert_array_equal(self.node_set("Load"), [0, 1])
        self.assertIn("leave out --blocks", self.refusal(THREE + sets, "--one-block", "--blocks", "Rest"))
        self.assertIn("no element set None", self.refusal(THREE + "*Solid Section, elset=None\n"))

    def test_elements_that_are_no_part_of_the_mesh_are_left_out_by_name(self):
        odd = ("*Element, type=COH2D4, elset=Glue\n7, 11, 12, 16,\n 15\n*Element, type=U1\n8, 10, 13\n"
               "*Element, type=CONN3D2\n9, 10,\n*Elset, elset=All\n1, 2, 3, 7, 9\n*Cohesive Section, elset=Glue\n")
        self.assertIn("elements of type COH2D4 are not supported", self.refusal(THREE + odd))
        self.assertIn("--skip U1", self.refusal(THREE + odd, "--skip", "coh2d4"))
        output, _ = self.pdmesh("convert", self.write(THREE + odd), "points.txt", "--skip", "COH2D4,U1,CONN3D2")
        self.check(Result(self.folder / "points.txt"), 3.0, [4.5, 1.5])
        self.assertIn("1 elements of type COH2D4 are left out", output)
        self.assertIn("3 quad elements", self.pdmesh("info", "a.inp", "--skip", "COH2D4,U1,CONN3D2")[0])
        self.assertIn("no elements of type S4 to leave out", self.refusal(THREE, "--skip", "S4"))
        self.assertIn("element set B names elements that are not there, as 77",
                      self.refusal(THREE + "*ELSET, ELSET=B\n1, 77\n"))

    def test_assemblies_as_cae_writes_them(self):
        part = "*Part, name=P\n" + THREE + "*Nset, nset=Tip\n13, 17\n*Elset, elset=Body, generate\n1, 3, 1\n*System\n"
        section = "*Solid Section, elset=Body, material=M\n,\n*End Part\n*Assembly, name=A\n"
        # A reference point has a node of its own, numbered from 1 again: here 10 and 1.
        point = ("*Node\n10, 5., 5., 5.\n1, 9., 9., 9.\n*Nset, nset=Point\n10,\n"
                 "*Nset, nset=Left, instance=P-1\n10, 14\n*Element, type=MASS\n1, 10\n"
                 "*Elset, elset=Far, instance=P-1\n3,\n"
                 "*Elset, elset=_Load_S2, internal, instance=P-1\n3,\n*Surface, type=ELEMENT, name=Load\n_Load_S2, S2\n"
                 "*End Assembly\n")
        result = self.read(part + section + "*Instance, name=P-1, part=P\n*End Instance\n" + point)
        self.check(result, 3.0, [4.5, 1.5])
        for name, expected in (("Left", [0]), ("Far", [2]), ("Load", [2]), ("Tip", [2])):
            np.testing.assert_array_equal(self.node_set(name), expected)
        # An independent instance holds the mesh itself.
        moved = "*Part, name=P\n*End Part\n*Assembly, name=A\n*Instance, name=P-1, part=P\n10., 0., 0.\n" + THREE
        self.check(self.read(moved + "*End Instance\n" + point), 3.0, [34.5, 1.5])
        # Two instances, the second moved by (4, 0, 0) and then turned by 90 degrees about z through (4, 0, 0).
        two = ("*Instance, name=P-1, part=P\n*End Instance\n*Instance, name=P-2, part=P\n4., 0., 0.\n"
               "4., 0., 0., 4., 0., 1., 90.\n*End Instance\n")
        sets = ("*Nset, nset=Ends, instance=P-1\n10, 14\n*Nset, nset=Ends, instance=P-2\n13, 17\n"
                "*Elset, elset=E\nP-2.3\n")
        result = self.read(part + section + two + sets)
        np.testing.assert_allclose(result.x[:, :2],
                                   [[0.5, 0.5], [1.5, 0.5], [2.5, 0.5], [3.5, 0.5], [3.5, 1.5], [3.5, 2.5]])
        np.testing.assert_array_equal(result.block, [1, 1, 1, 2, 2, 2])
        np.testing.assert_array_equal(self.node_set("Ends"), [0, 5])
        np.testing.assert_array_equal(self.node_set("E"), [5])
        np.testing.assert_array_equal(self.node_set("P-2.Tip"), [5])
        self.assertIn("# block_2: P-2.Body", (self.folder / "points.txt").read_text())
        for text, message in ((part + section + "*Instance, name=Q-1, part=Q\n", "there is no *PART, NAME=Q"),
                              (part + section + two + sets.replace("P-2.3", "P-3.3"), "there is no instance P-3"),
                              (part + section + two.replace("4., 0., 0.\n", "4., 0., 0., 1.\n"),
                               "a.inp:26: *INSTANCE: its data lines hold 3, then 7 numbers"),
                              (part + section + two.replace("1., 90.", "0., 90."), "the axis of the turn has no"),
                              (part + section + two + "*Element, type=CONN3D2\n1, P-1.10, P-2.10\n",
                               "--skip CONN3D2")):
            with self.subTest(message=message):
                self.assertIn(message, self.refusal(text))

    def test_gmsh_writes_sets_of_both_kinds(self):
        mesh = self.gmsh(SQUARE, 2, "-format", "inp", "-setnumber", "Mesh.SaveGroupsOfNodes", "1", name="mesh.inp")
        self.assertIn("*NSET,NSET=top", mesh.read_text())
        result = self.convert(mesh)
        other = self.convert(self.gmsh(SQUARE, 2))
        top = result.x[self.node_set("top")]
        self.convert("mesh.msh")
        expected = other.x[self.node_set("top")]  # those that have the curve as a side, not its neighbours by a corner
        np.testing.assert_allclose(top[np.lexsort(top.T)], expected[np.lexsort(expected.T)])


if __name__ == "__main__":
    unittest.main()
