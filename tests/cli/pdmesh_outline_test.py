#!/usr/bin/python3
"""pdmesh outline: areas and places of voids in images against what was drawn, and what is refused."""
import unittest

import numpy as np
from pdmesh_case import PdmeshCase
from PIL import Image


def pixels(columns, rows):
    """x and y of the middles of pixels, from the lower left corner, as [rows, columns] with the first row on top."""
    return np.meshgrid(np.arange(columns) + 0.5, rows - 0.5 - np.arange(rows))


class Outlines(PdmeshCase):
    def image(self, is_void, name="image.png", dark=0, bright=255, kind=np.uint8):
        Image.fromarray(np.where(is_void, dark, bright).astype(kind)).save(self.folder / name)
        return name

    def outline(self, image, *arguments, expect=0):
        """Polygons, output and errors."""
        output, errors = self.pdmesh("outline", image, "-o", "outline.txt", *arguments, expect=expect)
        if expect:
            return [], output, errors
        table = np.loadtxt(self.folder / "outline.txt", ndmin=2)
        return [table[table[:, 0] == number, 1:] for number in np.unique(table[:, 0])], output, errors

    @staticmethod
    def area(polygon):
        x, y = polygon.T
        return 0.5 * abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))

    def test_discs_are_where_they_were_drawn(self):
        x, y = pixels(120, 80)
        discs = ((30.2, 20.1, 15.0), (80.7, 55.3, 12.0))
        is_void = np.any([np.hypot(x - a, y - b) < r for a, b, r in discs], axis=0)
        for void, name in (("dark", self.image(is_void)), ("bright", self.image(~is_void, "other.tif"))):
            polygons, output, errors = self.outline(name, "--pixel", 2e-6, "--origin", -1e-4, 3e-4, "--void", void)
            self.assertEqual(errors, "")
            self.assertIn("2 polygons", output)
            for polygon, (a, b, r) in zip(sorted(polygons, key=lambda p: p[0, 0]), discs):
                self.assertLess(len(polygon), 60)
                # Smoothing by s pixels takes s^2/2r of a radius, the tolerance of 0.1 some of that.
                self.assertAlmostEqual(self.area(polygon) / (np.pi * (2e-6 * r)**2), 1, delta=1 / r**2 + 0.15 / r)
                middle = np.array([-1e-4 + 2e-6 * a, 3e-4 + 2e-6 * b])
                self.assertLess(np.max(np.abs(np.linalg.norm(polygon - middle, axis=1) - 2e-6 * r)), 0.8 * 2e-6)

    def test_grey_edges_tell_of_parts_of_pixels(self):
        # 16 bits, an edge that rises over two pixels: at 12.3 it is half-way.
        x, _ = pixels(40, 10)
        grey = np.clip((x - 12.3) / 2 + 0.5, 0, 1) * 60000
        Image.fromarray(grey.astype(np.uint16)).save(self.folder / "edge.tif")
        polygons, _, _ = self.outline("edge.tif", "--pixel", 1, "--smooth", 0)
        inner = polygons[0][(polygons[0][:, 1] > 1) & (polygons[0][:, 1] < 9)]
        corners = polygons[0] if len(inner) == 0 else inner
        self.assertAlmostEqual(np.max(corners[:, 0]), 12.3, delta=0.02)
        # Void at the border goes on beyond it.
        self.assertLess(polygons[0].min(), -1)
        self.assertGreater(polygons[0][:, 1].max(), 11)

    def test_rows_are_read_from_above(self):
        _, y = pixels(30, 20)
        polygons, _, _ = self.outline(self.image(y > 14), "--pixel", 1e-3)
        self.assertEqual(len(polygons), 1)
        self.assertAlmostEqual(polygons[0][:, 1].min(), 14e-3, delta=1e-5)

    def test_a_saw_tooth_keeps_its_teeth_within_the_tolerance(self):
        x, y = pixels(200, 60)
        tooth = 30 + 8 * np.abs((x / 40) % 2 - 1)
        exact = np.sum(tooth[0] - 30) + 30 * 200
        for tolerance, least in ((0, 200), (0.1, 5), (1.0, 5)):
            polygons, _, _ = self.outline(self.image(y > tooth), "--pixel", 1, "--smooth", 0.7, "--tolerance", tolerance)
            self.assertGreater(len(polygons[0]), least)
            below = 200 * 60 - self.area(np.clip(polygons[0], 0, [200, 60]))
            self.assertAlmostEqual(below / exact, 1, delta=0.01)

    def test_islands_and_small_voids_are_told(self):
        x, y = pixels(60, 60)
        ring = (np.hypot(x - 30, y - 30) < 20) & (np.hypot(x - 30, y - 30) > 8)
        polygons, _, errors = self.outline(self.image(ring), "--pixel", 1)
        self.assertEqual(len(polygons), 1)
        self.assertIn("1 islands of material within voids are left out", errors)
        specks = self.image((np.hypot(x - 20, y - 20) < 10) | (np.hypot(x - 50, y - 50) < 2))
        polygons, _, errors = self.outline(specks, "--pixel", 1, "--smallest", 50)
        self.assertEqual(len(polygons), 1)
        self.assertIn("1 voids of less than 50 pixels are left out", errors)

    def test_a_specimen_in_void_is_no_island(self):
        x, y = pixels(60, 60)
        outside = (np.abs(x - 30) > 20) | (np.abs(y - 30) > 20)
        hole = np.hypot(x - 30, y - 30) < 6
        _, _, errors = self.outline(self.image(outside | hole), "--pixel", 1, expect=2)
        self.assertIn("void that reaches the border of the image is all around material of", errors)
        self.assertIn("cut the image to the specimen", errors)
        # A crumb in a notch is left out.
        notch = (x < 30) & (np.hypot(x - 12, y - 30) > 3)
        _, _, errors = self.outline(self.image(notch), "--pixel", 1)
        self.assertIn("1 islands of material within voids are left out", errors)

    def test_voids_in_islands_count_once(self):
        x, y = pixels(100, 100)
        r = np.hypot(x - 50, y - 50)
        polygons, output, _ = self.outline(self.image((r < 10) | ((r > 20) & (r < 40))), "--pixel", 1)
        self.assertEqual(len(polygons), 2)
        share = float(output.split("voids have ")[1].split()[0])
        self.assertAlmostEqual(share, np.pi * 0.16, delta=0.005)

    def test_voids_that_smoothing_loses_are_told(self):
        x, y = pixels(60, 60)
        is_void = (np.hypot(x - 30, y - 30) < 12) | ((np.abs(x - 5) < 1) & (np.abs(y - 4.5) < 0.6))
        _, _, errors = self.outline(self.image(is_void), "--pixel", 1)
        self.assertIn("1 voids of pixels have no polygon, the largest of 2 pixels", errors)
        _, _, errors = self.outline(self.image(is_void), "--pixel", 1, "--smooth", 0)
        self.assertNotIn("no polygon", errors)
        _, _, errors = self.outline(self.image((x % 10 < 4) & (y % 10 < 4)), "--pixel", 1, "--smooth", 1.2)
        self.assertIn("polygons have 0.", errors)

    def test_one_of_several_images_of_a_file(self):
        x, _ = pixels(20, 20)
        frames = [Image.fromarray(np.where(x < edge, 0, 255).astype(np.uint8)) for edge in (5, 12)]
        frames[0].save(self.folder / "stack.tif", save_all=True, append_images=frames[1:])
        for frame, edge in ((1, 5), (2, 12)):
            polygons, _, _ = self.outline("stack.tif", "--pixel", 1, "--frame", frame)
            self.assertAlmostEqual(polygons[0][:, 0].max(), edge, delta=0.01)
        _, _, errors = self.outline("stack.tif", "--pixel", 1, "--frame", 3, expect=2)
        self.assertIn("--frame 3: stack.tif has 2 images", errors)

    def test_what_is_refused(self):
        x, _ = pixels(20, 20)
        (self.folder / "text.png").write_text("no image")
        good, plain = self.image(x < 10), self.image(x < 0, "plain.png")
        for arguments, message in (
                (("missing.png", "--pixel", 1), "missing.png: cannot be read: No such file or directory"),
                (("text.png", "--pixel", 1), "text.png: no image that Pillow can read"),
                ((plain, "--pixel", 1), "all pixels have the grey value 255: there is no outline"),
                ((good, "--pixel", 0), "--pixel must be positive"),
                ((good, "--pixel", 1e300), "--pixel 1e+300 is more than 1e6 m"),
                ((good, "--pixel", 1, "--origin", "nan", 0), "--origin must be two finite numbers"),
                ((good, "--pixel", 1, "-o", good), "is the image itself"),
                ((good, "--pixel", 1, "-o", "nowhere/list.txt"), "cannot be written: No such file or directory"),
                ((good, "--pixel", 1, "--threshold", 300), "--threshold 300 parts nothing: grey values go from 0 to 255"),
                ((good, "--pixel", 1, "--smooth", -1), "--smooth must not be negative"),
                ((good, "--pixel", 1, "--smallest", 1000), "has no void of 1000 pixels or more")):
            _, _, errors = self.outline(*arguments, expect=2)
            self.assertIn(message, errors)
            self.assertFalse((self.folder / "outline.txt").exists())
        with Image.open(self.folder / good) as image:
            self.assertEqual(image.size, (20, 20))


if __name__ == "__main__":
    unittest.main()
