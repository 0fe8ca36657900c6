#!/usr/bin/python3
"""Tests of meshes/pdplot on files laid out as driver/output/field_writer.hpp says."""
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

MESHES = Path(__file__).resolve().parents[2] / "meshes"
sys.dont_write_bytecode = True
sys.path[:0] = [str(MESHES), str(Path(__file__).resolve().parents[1] / "support")]

from in_process import run  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.command_line import main  # noqa: E402
from pdplot_lib.history import history_panels  # noqa: E402
from pdplot_lib.raster import Raster  # noqa: E402
from pdplot_lib.results import PlotError, Results, find_results, read_history  # noqa: E402
from pdplot_lib.units import scaled, time_text  # noqa: E402


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
        with self.assertRaisesRegex(PlotError, "no step 7"):
            results.time(7)

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

    def test_without_options_the_damage_of_the_newest_run_is_drawn(self):
        self.assertEqual(self.pdplot()[0], ["plate_Damage.png"])
        picture = self.picture("plate_Damage.png")
        # Damage 0.5 of 1 in inferno is (188, 55, 84): a band of 4 of 10 rows, half the length.
        crack = np.abs(picture - [188, 55, 84]).sum(axis=2) < 12
        intact = picture.sum(axis=2) < 15
        share = crack.sum() / (crack.sum() + intact.sum())
        self.assertAlmostEqual(share, 0.5 * 0.2, delta=0.02)

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
        for arguments in ([], ["--deformed"]):
            self.pdplot("plate", "--animate", "a.gif", *arguments)
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
        figure = history_panels([("plate", history)], ["top_reaction"])
        self.assertEqual([axis.get_ylabel() for axis in figure.axes if axis.lines],
                         ["Top ReactionX (N)", "Top ReactionY (N)"])
        figures.plt.close(figure)
        self.pdplot("plate", "--history", "TOP_REACTIONX")

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
        self.assertEqual(scaled(2e-5, "m"), (1 / 1e-6, "µm"))
        self.assertEqual(scaled(2e-5, ""), (1.0, ""))
        self.assertEqual(time_text(18480000.0), "213.9 d")
        self.assertEqual(time_text(2e-6), "2 µs")
        self.assertEqual(time_text(0.25, 4.0), "0.25 s")


if __name__ == "__main__":
    unittest.main()
