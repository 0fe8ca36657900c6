#!/usr/bin/python3
"""materials/YOUR_OWN_MODEL.md shows files of this folder whole, each below a comment that names it: are they the same text?

page_test.py --write puts the files' text into the page.
"""
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "materials" / "YOUR_OWN_MODEL.md"
BLOCK = re.compile(r"(<!-- (tests/own_model/\S+) -->\n```\w*\n)(.*?)(^```$)", re.S | re.M)


class Page(unittest.TestCase):
    def test_code_is_that_of_the_files(self):
        blocks = {name: text for _, name, text, _ in BLOCK.findall(PAGE.read_text())}
        plugins = {str(path.relative_to(ROOT)) for path in (ROOT / "tests" / "own_model").glob("*.cpp")
                   if "\nPD_REGISTER_" in path.read_text() and not path.name.endswith("_test.cpp")}
        self.assertGreaterEqual(len(plugins), 3)
        self.assertLessEqual(plugins, set(blocks), "plug-ins that the page does not show")
        for name, text in blocks.items():
            self.assertEqual(text, (ROOT / name).read_text(), f"{name}: run page_test.py --write")

    def test_a_plug_in_fits_on_a_screen(self):
        for _, name, text, _ in BLOCK.findall(PAGE.read_text()):
            if name.endswith(".cpp"):
                self.assertLess(text.count("\n"), 90, name)

    def test_files_that_it_names_are_there(self):
        for name in re.findall(r"`((?:tests|materials|compute|driver)/[\w/]+\.\w+)`", PAGE.read_text()):
            self.assertTrue((ROOT / name).exists(), name)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        PAGE.write_text(BLOCK.sub(lambda block: block[1] + (ROOT / block[2]).read_text() + block[4], PAGE.read_text()))
    else:
        unittest.main()
