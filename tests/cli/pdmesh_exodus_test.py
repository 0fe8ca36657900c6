#!/usr/bin/python3
"""Tests of meshes/pdmesh on Exodus files: blocks, node sets, side sets, shells, and meshes that were cut."""
import unittest
import warnings

import numpy as np
from pdmesh_case import PdmeshCase

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # of another numpy at its build
    import netCDF4

CUBE = np.array([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)


def write_exodus(path, nodes, blocks, node_sets=(), side_sets=(), dimensions=None):
    """blocks: [(name, type, connectivity from 1)]; node_sets: [(name, nodes)]; side_sets: [(name, elements, sides)]."""
    with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT") as data:
        nodes = np.asarray(nodes, float)
        sizes = {"len_name": 33, "num_nodes": len(nodes), "num_dim": nodes.shape[1], "num_el_blk": len(blocks),
                 "num_elem": sum(len(rows) for _, _, rows in blocks), **(dimensions or {})}
        for name, size in sizes.items():
            data.createDimension(name, size)
        for i, values in enumerate(nodes.T):
            data.createVariable("coord" + "xyz"[i], "f8", ("num_nodes",))[:] = values
        for prefix, things, dimension in (("eb", blocks, "num_el_blk"), ("ns", node_sets, "num_node_sets"),
                                          ("ss", side_sets, "num_side_sets")):
            if not things:
                continue
            if dimension not in data.dimensions:
                data.createDimension(dimension, len(things))
            data.createVariable(f"{prefix}_prop1", "i4", (dimension,))[:] = np.arange(len(things)) + 1
            names = data.createVariable(f"{prefix}_names", "S1", (dimension, "len_name"))
            names[:] = np.array([list(name.ljust(33, "\0")) for name, *_ in things], "S1")
        for i, (_, kind, rows) in enumerate(blocks, 1):
            data.createDimension(f"num_el_in_blk{i}", len(rows))
            data.createDimension(f"num_nod_per_el{i}", len(rows[0]))
            connect = data.createVariable(f"connect{i}", "i4", (f"num_el_in_blk{i}", f"num_nod_per_el{i}"))
            connect.elem_type, connect[:] = kind, rows
        for i, (_, members) in enumerate(node_sets, 1):
            data.createDimension(f"num_nod_ns{i}", len(members))
            data.createVariable(f"node_ns{i}", "i4", (f"num_nod_ns{i}",))[:] = members
        for i, (_, elements, sides) in enumerate(side_sets, 1):
            data.createDimension(f"num_side_ss{i}", len(sides))
            for name, values in (("elem", elements), ("side", sides)):
                data.createVariable(f"{name}_ss{i}", "i4", (f"num_side_ss{i}",))[:] = values


class Exodus(PdmeshCase):
    def test_blocks_node_sets_and_side_sets_of_second_order(self):
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

    def two_cubes(self, name="a.exo", **more):
        """Cubes side by side along x in one block."""
        nodes = np.vstack([CUBE, CUBE[[1, 2, 5, 6]] + [1, 0, 0]])
        cubes = [[1, 2, 3, 4, 5, 6, 7, 8], [2, 9, 10, 3, 6, 11, 12, 7]]
        write_exodus(self.folder / name, nodes, [("metal", "HEX8", cubes)], **more)
        return name

    def test_sets_of_one_name(self):
        # A node set and a side set of the same face are one; others are kept apart.
        self.two_cubes(node_sets=[("end", [9, 10, 11, 12]), ("other", [1, 4])], side_sets=[("end", [2], [2]),
                                                                                          ("other", [2], [2])])
        output, _ = self.pdmesh("convert", "a.exo", "points.txt")
        np.testing.assert_array_equal(self.node_set("end"), [1])  # nodes alone would take what touches them
        np.testing.assert_array_equal(self.node_set("other"), [1])
        np.testing.assert_array_equal(self.node_set("other_nodes"), [0])
        self.assertIn("of nodes, is other_nodes", output)
        self.two_cubes(node_sets=[("metal", [1, 4]), ("end", [9]), ("end", [1, 4])])
        self.assertEqual(set(self.convert("a.exo").block), {1})  # a block stays one whatever else is called so
        np.testing.assert_array_equal(self.node_set("metal"), [0])
        np.testing.assert_array_equal(self.node_set("end"), [1])
        np.testing.assert_array_equal(self.node_set("end_3"), [0])
        self.two_cubes(node_sets=[("far", [99])])
        self.assertIn("node set far names nodes that are not there",
                      self.pdmesh("convert", "a.exo", "p.txt", expect=2)[1])
        self.two_cubes(side_sets=[("far", [9], [1])])
        self.assertIn("side set far names elements that are not there",
                      self.pdmesh("convert", "a.exo", "p.txt", expect=2)[1])

    def test_sides_of_shells_and_of_triangles_in_space(self):
        # Two squares (four triangles) side by side along x: sides 1 and 2 are the faces, then come the edges. Of plane
        # elements in two dimensions, and of quads everywhere, there are edges alone.
        flat = np.array([(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0)], float)
        quads = [[1, 2, 5, 4], [2, 3, 6, 5]]
        triangles = [[1, 2, 5], [1, 5, 4], [2, 3, 6], [2, 6, 5]]
        for kind, rows, axes, end, face in (("SHELL4", quads, 3, (2, 4), (1, 1)), ("QUAD4", quads, 3, (2, 2), None),
                                            ("QUAD4", quads, 2, (2, 2), None), ("TRI3", triangles, 2, (3, 2), None),
                                            ("TRI3", triangles, 3, (3, 4), (1, 2)),
                                            ("TRISHELL3", triangles, 3, (3, 4), (1, 1)),
                                            ("SHELL3", triangles, 3, (3, 4), (1, 1))):
            with self.subTest(kind=kind, axes=axes):
                sides = [("end", [end[0]], [end[1]])] + ([("face", [face[0]], [face[1]])] if face else [])
                write_exodus(self.folder / "a.exo", flat[:, :axes], [("plate", kind, rows)], side_sets=sides)
                self.assertAlmostEqual(self.convert("a.exo", "--thickness", 1).total, 2.0, delta=1e-14)
                np.testing.assert_array_equal(self.node_set("end"), [end[0] - 1])
                if face:
                    np.testing.assert_array_equal(self.node_set("face"), [face[0] - 1])
                result = self.convert("a.exo", "--thickness", 1, "--at", "nodes")
                np.testing.assert_array_equal(result.x[self.node_set("end"), 0], [2, 2])
        write_exodus(self.folder / "a.exo", flat, [("plate", "QUAD4", quads)], side_sets=[("end", [2], [5])])
        self.assertIn("side set end names side 5 of a QUAD element",
                      self.pdmesh("convert", "a.exo", "p.txt", expect=2)[1])

    def test_pieces_are_not_the_whole(self):
        self.two_cubes("mesh.g.2.0")
        self.two_cubes("mesh.g.1.0")
        self.two_cubes("half.g", dimensions={"num_elems_global": 4})
        self.two_cubes("third.g", dimensions={"num_processors": 3})
        for name, message in (("mesh.g", "no such file, but its pieces are, mesh.g.1.0 ...: join them"),
                              ("mesh.g.2.0", "a piece of a mesh that was cut for 2 processes"),
                              ("half.g", "not the whole"), ("third.g", "cut for 3 processes")):
            with self.subTest(name=name):
                self.assertIn(message, self.pdmesh("convert", name, "p.txt", expect=2)[1])
        self.assertEqual(self.convert("mesh.g.1.0").total, 2.0)

    def test_blocks_of_other_elements_are_left_out_by_name(self):
        nodes = np.vstack([CUBE, CUBE[[1, 2, 5, 6]] + [1, 0, 0]])
        write_exodus(self.folder / "A.EXO", nodes, [("odd", "NFACED", [[1, 2, 3]]), ("metal", "HEX", [range(1, 9)])],
                     side_sets=[("end", [2, 1], [2, 1])])
        self.assertIn("--skip NFACED", self.pdmesh("convert", "A.EXO", "p.txt", expect=2)[1])
        self.assertEqual(self.convert("A.EXO", "--skip", "nfaced").total, 1.0)
        np.testing.assert_array_equal(self.node_set("end"), [0])


if __name__ == "__main__":
    unittest.main()
