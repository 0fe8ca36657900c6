#!/usr/bin/python3
"""Tests of meshes/pdplot on files laid out as driver/output/field_writer.hpp says."""
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from PIL import Image
from scipy import ndimage
from scipy.spatial import Delaunay

MESHES = Path(__file__).resolve().parents[2] / "meshes"
sys.dont_write_bytecode = True
sys.path[:0] = [str(MESHES), str(Path(__file__).resolve().parents[1] / "support")]

from in_process import run  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.components import component_of  # noqa: E402
from pdplot_lib.command_line import main  # noqa: E402
from pdplot_lib.growth import exponent_of, growth_rates  # noqa: E402
from pdplot_lib.history import history_panels  # noqa: E402
from pdplot_lib.raster import Raster  # noqa: E402
from pdplot_lib.results import PlotError, Results, find_results, history_units, read_history, read_path  # noqa: E402
from pdplot_lib.units import plain, printed, scaled, time_text  # noqa: E402


def write_run(folder, name, x, steps, fields):
    """`fields(step)`: name -> values."""
    (folder / f"{name}.steps").mkdir()
    with h5py.File(folder / f"{name}.steps" / "mesh.h5", "w") as mesh:
        mesh["coordinates"], mesh["volume"], mesh["block_id"] = x, np.ones(len(x)), np.ones(len(x), int)
    with h5py.File(folder / f"{name}.h5", "w") as index:
        index["mesh"] = h5py.ExternalLink(f"{name}.steps/mesh.h5", "/")
        index.create_group("steps")
        for step in steps:
            with h5py.File(folder / f"{name}.steps" / f"{step:06d}.h5", "w") as file:
                file.attrs["time"], file.attrs["step"] = 0.5 * step, step
                for field, values in fields(step).items():
                    file[field] = values
            index[f"steps/{step:06d}"] = h5py.ExternalLink(f"{name}.steps/{step:06d}.h5", "/")


def lattice(nx, ny, spacing):
    x, y = np.meshgrid((np.arange(nx) + 0.5) * spacing, (np.arange(ny) + 0.5) * spacing)
    return np.c_[x.ravel(), y.ravel(), 0 * x.ravel()]


class PdplotTest(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = Path(self.scratch.name)
        self.x = lattice(20, 10, 0.01)

        def fields(step):
            crack = ((np.abs(self.x[:, 1] - 0.05) < 0.011) & (self.x[:, 0] < 0.01 * step)).astype(float)
            return {"Damage": 0.5 * crack, "Concentration": self.x[:, 0], "Displacement": self.x * 0.01 * step}
        write_run(self.folder, "plate", self.x, [0, 5, 10], fields)
        (self.folder / "plate.csv").write_text("step,time,Crack_Length\n0,0,0.0\n5,2.5,0.05\n10,5.0,0.1\n")

    def tearDown(self):
        self.scratch.cleanup()

    def pdplot(self, *arguments, expect=0):
        code, output, errors = run(main, self.folder, arguments)
        self.assertEqual(code, expect, output + errors)
        return output.split(), errors

    def picture(self, name):
        with Image.open(self.folder / name) as image:
            return np.asarray(image.convert("RGB")).astype(int)

    def test_results_are_read_as_written(self):
        results = Results(self.folder / "plate")
        self.assertEqual(results.steps, [0, 5, 10])
        self.assertEqual(results.time(5), 2.5)
        self.assertEqual(results.dimension, 2)
        self.assertEqual(results.fields(), ["Concentration", "Damage", "Displacement"])
        np.testing.assert_array_equal(results.field("Displacement", 10), self.x * 0.01 * 10)
        self.assertAlmostEqual(results.spacing(), 0.01, delta=5e-4)
        self.assertEqual(find_results(self.folder), self.folder / "plate.h5")
        self.assertEqual([results.unit(name) for name in results.fields()],
                         ["in the deck's unit", "", "m"])  # old results do not say
        with self.assertRaisesRegex(PlotError, "no step 7"):
            results.time(7)

    def test_units_are_those_of_the_results(self):
        with h5py.File(self.folder / "plate.steps/000010.h5", "a") as file:
            file["Damage"].attrs["units"] = np.bytes_(b"1")
            file["Displacement"].attrs["units"] = "kg/m3"
        results = Results(self.folder / "plate")
        self.assertEqual([results.unit(name) for name in results.fields()], ["in the deck's unit", "", "kg/m³"])

    def test_pixels_take_the_nearest_point_and_stay_empty_far_away(self):
        x = lattice(10, 10, 1.0)[:, :2]
        hole = np.hypot(x[:, 0] - 5, x[:, 1] - 5) > 2.5
        raster = Raster(x[hole], 1.0, pixels=200)
        image = raster.image(np.arange(hole.sum()))
        for row, column in ((3, 3), (100, 20), (190, 100)):
            place = np.array([raster.columns[column], raster.rows[row]])
            nearest = np.argmin(np.linalg.norm(x[hole] - place, axis=1))
            self.assertEqual(image[row, column], nearest)
        self.assertTrue(image.mask[100, 100])
        np.testing.assert_allclose(raster.extent, [0, 10, 0, 10], atol=1e-12)

    def test_pixels_fill_the_area_of_the_points_and_no_more(self):
        # A slot of 4 spacings and a hole: the picture's share is that of the points' area. In rows shifted by half a
        # spacing, with points moved at random by up to 0.2 spacings, corners lie farther from the points: no speck is
        # left open. Cells are drawn 0.05 spacings too wide: along edges of 94 that is 0.002 of 60 x 40.
        for shift, jitter, tolerance in ((0.0, 0.0, 0.003), (0.5, 0.2, 0.02)):
            x = lattice(60, 40, 1.0)[:, :2]
            x[:, 0] += shift * (np.floor(x[:, 1]) % 2)
            x += np.random.default_rng(3).uniform(-jitter, jitter, x.shape)
            slot = (x[:, 0] < 20) & (np.abs(x[:, 1] - 20) < 2)
            kept = x[~slot & (np.hypot(x[:, 0] - 40, x[:, 1] - 20) > 8)]
            image = Raster(kept, 1.0, pixels=600, window=np.array([[0, 0], [60, 40]])).image(np.ones(len(kept)))
            self.assertAlmostEqual(1 - image.mask.mean(), len(kept) / 2400, delta=tolerance)
            inside = image.mask[20:-20, 20:-20]
            self.assertEqual(ndimage.label(inside)[1], 2)

    def solid_of_tetrahedra(self):
        """A box of 12 x 8 x 6 with a hole of radius 2 along z through it, of Delaunay tetrahedra with edges of about 1.
        Returns the points at their centroids; fields tell x, y, z."""
        random = np.random.default_rng(5)
        nodes = np.stack(np.meshgrid(np.arange(13.0), np.arange(9.0), np.arange(7.0), indexing="ij"), -1).reshape(-1, 3)
        inside = (nodes > 0).all(axis=1) & (nodes < [12, 8, 6]).all(axis=1)
        nodes[inside] += random.uniform(-0.25, 0.25, (inside.sum(), 3))
        angle = np.arange(0, 2 * np.pi, 0.4)
        rim = np.concatenate([np.column_stack([6 + 2 * np.cos(angle), 4 + 2 * np.sin(angle), np.full(len(angle), z)])
                              for z in np.arange(7.0)])
        nodes = np.concatenate([nodes[np.hypot(nodes[:, 0] - 6, nodes[:, 1] - 4) > 2.4], rim])
        corners = nodes[Delaunay(nodes).simplices]
        volume = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
        x = corners.mean(axis=1)
        kept = (volume > 1e-3) & (np.hypot(x[:, 0] - 6, x[:, 1] - 4) > 1.95)
        write_run(self.folder, "solid", x[kept], [0], lambda step: {"Damage": x[kept, 0], "Displacement": x[kept]})
        with h5py.File(self.folder / "solid.steps" / "mesh.h5", "r+") as mesh:
            mesh["volume"][...] = volume[kept]
        return x[kept]

    def test_a_slice_of_tetrahedra_shows_their_body_and_no_holes_of_its_own(self):
        x = self.solid_of_tetrahedra()
        results = Results(self.folder / "solid")
        for position in (1.3, 4.6):
            plane = figures.Plane(results, figures.View("Damage", slice=(2, position)))
            raster = plane.raster(0)
            image = raster.image(plane.points)
            # One hole, of pi 2^2, but for the ragged edge that cells of 0.1 give it; along the outer edge 2 %.
            holes, count = ndimage.label(np.pad(image.mask, 1, constant_values=True))
            self.assertEqual(count, 2)
            area = np.ptp(raster.columns) * np.ptp(raster.rows) / image.mask.size
            outside = holes[0, 0]
            self.assertAlmostEqual((holes == 3 - outside).sum() * area, np.pi * 4, delta=0.15 * np.pi * 4)
            self.assertLess((holes[1:-1, 1:-1] == outside).mean(), 0.02)
            # Every place has the colour of the nearest point in space.
            for row, column in np.random.default_rng(1).integers(0, image.shape, (30, 2)):
                if not image.mask[row, column]:
                    place = [raster.columns[column], raster.rows[row], position]
                    self.assertEqual(image[row, column], np.argmin(np.linalg.norm(x - place, axis=1)))
        self.assertIn("the body spans", self.pdplot("solid", "--slice", "z=7", expect=2)[1])
        self.pdplot("solid", "--deformed", "--slice", "y=1")

    def test_a_slice_of_a_lattice_is_that_of_its_cells(self):
        x = np.stack(np.meshgrid(*[np.arange(8.0) + 0.5] * 3, indexing="ij"), -1).reshape(-1, 3)
        x = x[(np.abs(x[:, 1] - 4) > 1) | (x[:, 0] > 3)]  # a slot of two cells
        write_run(self.folder, "cubes", x, [0], lambda step: {"Damage": 0 * x[:, 0]})
        raster = figures.Plane(Results(self.folder / "cubes"), figures.View("Damage", slice=(2, 3.2))).raster(0)
        # Cells are drawn a twentieth of a spacing too wide, and corners are round: the slot of 3 x 2 loses 0.4 to 0.8.
        self.assertAlmostEqual(raster.image(np.zeros(len(x))).mask.mean() * 64, 5.4, delta=0.2)

    def test_components_of_tensors(self):
        # Uniaxial stress, pure shear, pressure: von Mises' measure is |s|, sqrt(3) t, 0; principal values as they are.
        tensors = np.zeros((3, 3, 3))
        tensors[0, 0, 0], tensors[1, 0, 1], tensors[1, 1, 0], tensors[2] = -5.0, 2.0, 2.0, -7.0 * np.eye(3)
        turn = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))[0]
        turned = (turn @ tensors @ turn.T).reshape(3, 9)
        expected = {"von-mises": [5, 2 * 3 ** 0.5, 0], "principal1": [0, 2, -7], "principal2": [0, 0, -7],
                    "principal3": [-5, -2, -7]}
        for values in (turned, turned[:, [0, 1, 2, 4, 5, 8]]):
            for name, numbers in expected.items():
                np.testing.assert_allclose(component_of("Bond_Stress", values, name), numbers, atol=1e-14)
        np.testing.assert_array_equal(component_of("S", np.arange(9.0)[None], "yz"), [5])
        np.testing.assert_array_equal(component_of("S", np.arange(6.0)[None], "zy"), [4])
        # A strain that keeps the volume has its axial value for measure.
        strain = np.diag([0.2, -0.1, -0.1]).reshape(1, 9)
        np.testing.assert_allclose(component_of("Bond_Strain", strain, "von-mises"), [0.2])
        stress = np.tile(np.arange(9.0), (len(self.x), 1)) * self.x[:, :1]
        write_run(self.folder, "tensors", self.x, [0], lambda step: {"Bond_Stress": stress, "Bond_Strain": stress})
        results = Results(self.folder / "tensors")
        for field, name in (("Bond_Stress", "Bond_Stress von Mises"),
                            ("Bond_Strain", "Bond_Strain largest principal value")):
            self.assertEqual(figures.View(field).name(results), name)
        self.assertEqual(figures.View("Bond_Stress", "xz").name(results), "Bond_Stress xz")
        self.pdplot("tensors", "--field", "bond_stress", "--component", "XX")
        message = self.pdplot("tensors", "--field", "Bond_Stress", "--component", "y", expect=2)[1]
        self.assertIn("--component y: Bond_Stress has 9 numbers a point; choose among xx, xy", message)
        self.assertIn("choose among x, y, z", self.pdplot("plate", "--field", "Displacement", "--component", "xx",
                                                          expect=2)[1])

    def test_a_field_that_is_the_same_everywhere_says_so(self):
        results = Results(self.folder / "plate")
        self.assertIn(", 0 everywhere", figures.step_title(results, 0, figures.View("Damage")))
        self.assertNotIn("everywhere", figures.step_title(results, 10, figures.View("Damage")))
        self.pdplot("plate", "--step", "0", "--field", "Damage")
        picture = self.picture("plate_Damage.png")
        self.assertGreater((np.abs(picture - 204).max(axis=2) < 3).mean(), 0.5)  # grey 0.8, not black

    def test_concentrations_have_the_unit_of_their_deck(self):
        view, results = figures.View("Concentration"), Results(self.folder / "plate")
        self.assertEqual(view.units(results), "in the deck's unit")
        deck = "Materials:\n  M:\n    Material Model: Corrosion Dissolution\n"
        (self.folder / "plate.resolved.yaml").write_text(deck)
        self.assertEqual(view.units(results), "mol/m³")
        self.assertEqual(figures.View("Concentration", unit="ppm").units(results), "ppm")

    def test_without_options_the_damage_of_the_newest_run_is_drawn(self):
        self.assertEqual(self.pdplot()[0], ["plate_Damage.png"])
        picture = self.picture("plate_Damage.png")
        # Damage 0.5 of 1 in inferno is (188, 55, 84): a band of 4 of 10 rows, half the length.
        crack = np.abs(picture - [188, 55, 84]).sum(axis=2) < 12
        intact = picture.sum(axis=2) < 15
        share = crack.sum() / (crack.sum() + intact.sum())
        self.assertAlmostEqual(share, 0.5 * 0.2, delta=0.02)

    def test_a_picture_whose_name_nobody_gave_replaces_none_of_others(self):
        ours = self.folder / "plate_Damage.png"
        self.pdplot("plate")
        self.pdplot("plate")  # again
        ours.write_bytes(b"a picture of mine")
        self.assertIn("is no picture that pdplot made; name another file (-o)", self.pdplot("plate", expect=2)[1])
        self.assertEqual(ours.read_bytes(), b"a picture of mine")
        self.assertFalse(list(self.folder.glob("*unfinished")))
        self.pdplot("plate", "-o", "plate_Damage.png")

    def test_every_kind_of_picture_is_written(self):
        write_run(self.folder, "other", self.x, [10], lambda step: {"Damage": self.x[:, 0]})
        solid = np.stack(np.meshgrid(*[np.arange(6.0)] * 3), -1).reshape(-1, 3)
        write_run(self.folder, "solid", solid, [0], lambda step: {"Damage": solid[:, 0] / 6})
        bar = np.c_[np.arange(10.0), np.zeros((10, 2))]
        write_run(self.folder, "bar", bar, [0], lambda step: {"Temperature": bar[:, 0]})
        (self.folder / "again").mkdir()
        write_run(self.folder / "again", "plate", self.x, [0, 7], lambda step: {"Damage": self.x[:, 1]})
        for arguments in (["plate", "again/plate"], ["plate", "again/plate", "--step", "0"],
                          ["plate", "--step", "0,5,10,0,5,10,0"], ["plate", "--step", "all", "--deformed"],
                          ["plate", "--step", "all", "--crack"],
                          ["plate", "--field", "displacement", "--component", "y"],
                          ["plate", "--deformed"], ["plate", "--deformed", "3"], ["plate", "other"], ["bar"],
                          ["solid", "--slice", "x=2"], ["plate", "--history"],
                          ["plate.h5", "--history", "Crack_Length", "--against", "step"],
                          ["plate", "--range", "0", "2", "--map", "cividis", "--unit", "m", "--factor", "2"]):
            with self.subTest(arguments=arguments):
                self.assertEqual(self.pdplot(*arguments, "-o", "a.png")[0], ["a.png"])
                self.assertGreater(min(self.picture("a.png").shape[:2]), 200)
                (self.folder / "a.png").unlink()
    def test_animations_have_a_frame_for_each_step(self):
        self.pdplot("plate", "--animate", "a.gif", "--deformed")
        with Image.open(self.folder / "a.gif") as image:
            self.assertEqual(image.n_frames, 3)
        if shutil.which("ffmpeg") is None:
            self.skipTest("no ffmpeg")
        self.pdplot("plate", "--animate", "a.mp4")
        count = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames",
                                "-of", "csv=p=0", "a.mp4"], cwd=self.folder, text=True, capture_output=True, check=True)
        self.assertEqual(int(count.stdout), 3)

    def test_without_options_a_field_that_is_the_same_everywhere_is_passed_over(self):
        write_run(self.folder, "later", self.x, [1], lambda step: {"Damage": 0 * self.x[:, 0],
                                                                   "Concentration": self.x[:, 0]})
        self.assertEqual(self.pdplot("later")[0], ["later_Concentration.png"])

    def test_paths_are_drawn_over_maps(self):
        (self.folder / "plate.csv").write_text("step,time,TipX,TipY,TipZ\n0,0,0,0.05,0\n5,1,0.05,0.05,0\n"
                                               "10,2,0.1,0.08,0\n")
        (self.folder / "test.txt").write_text("x,y  # m\n0.12,0.02\n0.14, 0.03\n")
        results = Results(self.folder / "plate")
        view = figures.View("Damage")
        view.path, view.measured = "tip", read_path(self.folder / "test.txt")
        ways = [places for places, _ in view.paths(results, 5)]
        np.testing.assert_array_equal(ways[0], [[0, 0.05, 0], [0.05, 0.05, 0]])  # up to the step
        np.testing.assert_array_equal(ways[1], [[0.12, 0.02, 0], [0.14, 0.03, 0]])
        self.pdplot("plate", "--path", "Tip", "-o", "a.png")
        self.assertTrue((np.abs(self.picture("a.png") - [0, 191, 255]).sum(axis=2) < 30).any())
        (self.folder / "bad.txt").write_text("1 2\n3 x\n")
        for arguments, message in ((["--path", "Nothing"], "no vector Nothing"),
                                   (["--measured", "bad.txt"], "bad.txt:2"),
                                   (["--measured", "none.txt"], "cannot be read"),
                                   (["--path", "Tip", "--deformed"], "undeformed")):
            with self.subTest(arguments=arguments):
                self.assertIn(message, self.pdplot("plate", *arguments, expect=2)[1])

    def test_deformed_points_are_drawn_where_they_have_moved_to(self):
        # Twice as long along x and y at step 10 with a scale of 10; the window is that of both steps.
        results = Results(self.folder / "plate")
        view = figures.View("Damage", scale=10.0)
        low, high = figures.common_window([(results, 0, ""), (results, 10, "")], view)
        np.testing.assert_allclose(low, [0, 0], atol=6e-3)
        np.testing.assert_allclose(high, [0.4, 0.2], atol=1e-2)
        self.assertAlmostEqual(figures.auto_scale(results, [10]), 0.05 * 0.19 / (0.195 * 0.1), delta=0.01)

    def test_spacing_is_that_of_the_points_whatever_holes_and_thickness(self):
        x = lattice(40, 40, 0.1)
        ring = np.hypot(x[:, 0] - 2, x[:, 1] - 2) > 1.5
        write_run(self.folder, "ring", x[ring], [0], lambda step: {"Damage": x[ring, 0]})
        self.assertAlmostEqual(Results(self.folder / "ring").spacing(), 0.1, delta=0.012)

    def test_a_history_is_found_in_any_case_and_by_vector(self):
        (self.folder / "plate.csv").write_text("step,time,Top_ReactionX,Top_ReactionY,Top_ReactionZ\n0,0,0,0,0\n"
                                               "5,1,2,3,0\n")
        history = read_history(self.folder / "plate")
        figure = history_panels([("plate", history)], ["top_reaction"],
                                units=history_units(self.folder / "plate", history))
        self.assertEqual([axis.get_ylabel() for axis in figure.axes if axis.lines],
                         ["Top ReactionX (N)", "Top ReactionY (N)"])
        figures.plt.close(figure)
        self.pdplot("plate", "--history", "TOP_REACTIONX")

    def test_growth_of_a_crack_is_a_line_over_the_range_of_k(self):
        # A crack that goes by rows of 0.1 mm with da/dN = 1e-11 (dK / MPa m^0.5)^3, dK rising with its length
        lengths = np.repeat(1e-4 * np.arange(100, 161), 2)
        ranges = 10e6 * np.exp(100 * (lengths - 0.010))
        cycles = np.concatenate([[0.0], np.cumsum(np.where(np.diff(lengths) > 0, 1e-4, 0.0)
                                                  / (1e-11 * (1e-6 * ranges[:-1])**3))])
        found, rates = growth_rates(cycles, lengths, ranges)
        np.testing.assert_allclose(rates, 1e-11 * (1e-6 * found)**3, rtol=0.02)
        self.assertAlmostEqual(exponent_of(found, rates), 3.0, delta=0.02)
        self.assertIsNone(exponent_of(np.full(5, 1e7), rates[:5]))  # a range that is held
        table = np.column_stack([np.arange(len(cycles)), cycles, lengths, ranges])
        np.savetxt(self.folder / "plate.csv", table, delimiter=",", comments="",
                   header="step,time,Crack_Length,Stress_Intensity_Range")
        self.assertEqual(self.pdplot("plate", "--growth")[0], ["plate_growth.png"])
        for arguments in (["--growth", "Nothing"], ["--growth", "--against", "Nothing"]):
            self.assertIn("no column Nothing", self.pdplot("plate", *arguments, expect=2)[1])
        np.savetxt(self.folder / "plate.csv", table[:1], delimiter=",", comments="",
                   header="step,time,Crack_Length,Stress_Intensity_Range")
        self.assertIn("has not grown", self.pdplot("plate", "--growth", expect=2)[1])

    def test_mistakes_are_told_without_a_traceback(self):
        for arguments, message in ((["none"], "no such results"), (["plate", "--field", "Dmage"], "no field Dmage"),
                                   (["plate", "--step", "7"], "no step 7"), (["plate", "--step", "a"], "--step a"),
                                   (["plate", "--slice", "q=1"], "--slice"), (["plate", "--deformed", "x"], "`x`"),
                                   (["plate", "--history", "Nothing"], "no column Nothing"),
                                   (["plate", "-o", "a.nonsense"], "cannot be written"),
                                   (["plate", "--history", "-o", "none/a.png"], "cannot be written"),
                                   (["plate", "--map", "nonsense"], "viridis"),
                                   (["plate", "--range", "2", "1"], "--range"),
                                   (["plate", "--component", "z"], "not a vector"),
                                   (["plate", "--deformed", "nan"], "nan"),
                                   (["plate", "--slice", "z=0"], "is no solid"),
                                   (["plate", "--animate", "a.avi"], ".gif or .mp4"),
                                   (["plate", "--animate", "none/a.gif"], "cannot be written"),
                                   (["plate", "--animate", "a.gif", "--speed", "0"], "above zero"),
                                   (["plate", "plate", "--animate", "a.gif"], "shows one run")):
            with self.subTest(arguments=arguments):
                self.assertIn(message, self.pdplot(*arguments, expect=2)[1])

    def test_the_program_starts(self):
        run = subprocess.run([str(MESHES / "pdplot"), "none"], cwd=self.folder, text=True, stderr=subprocess.PIPE)
        self.assertEqual(run.returncode, 2)
        self.assertIn("pdplot: none: no such results", run.stderr)

    def test_history_and_units(self):
        np.testing.assert_array_equal(read_history(self.folder / "plate")["Crack_Length"], [0, 0.05, 0.1])
        self.assertEqual(history_units(self.folder / "plate", ["Crack_Length", "Of_A_Name"]),
                         {"Crack_Length": "m", "Of_A_Name": ""})  # guessed from the name: an old run
        columns = [{"name": "Crack_Length", "schema:unitText": "mm2"}, {"name": "Of_A_Name", "schema:unitText": "J/m3"},
                   {"name": "Share", "schema:unitText": "1"}, {"name": "Of_The_Deck"}]
        (self.folder / "plate.csv-metadata.json").write_text(json.dumps({"tableSchema": {"columns": columns}}))
        self.assertEqual(list(history_units(self.folder / "plate", [column["name"] for column in columns]).values()),
                         ["mm²", "J/m³", "", ""])
        self.assertEqual([printed(unit) for unit in ("mol/(m3 s)", "m2/s", "1", "1/m", "N/m4")],
                         ["mol/(m³ s)", "m²/s", "", "1/m", "N/m⁴"])
        self.assertEqual(scaled(2e-5, "m"), (1 / 1e-6, "µm"))
        self.assertEqual(scaled(2e-5, ""), (1.0, ""))
        self.assertEqual([plain(value) for value in (4030.0, 51.26, 0.00123, 4.03e9)],
                         ["4030", "51.3", "0.00123", "4.03e+09"])
        self.assertEqual(time_text(18480000.0), "213.9 d")
        self.assertEqual(time_text(2e-6), "2 µs")
        self.assertEqual(time_text(0.25, 4.0), "0.25 s")


if __name__ == "__main__":
    unittest.main()
