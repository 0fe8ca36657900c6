"""The way from a drawing to a picture in README.md, run as it is printed there: its files, its four commands."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
PDRUN = os.path.abspath(os.environ["PDRUN"])


class Readme(unittest.TestCase):
    def test_the_crack_runs_from_the_notch_through_the_hole(self):
        text = (ROOT / "README.md").read_text().split("## From a drawing to a picture")[1].split("\n## ")[0]
        drawing, deck = (re.search(rf"```{kind}\n(.*?)```", text, re.S).group(1) for kind in ("cpp", "yaml"))
        commands = re.search(r"Four commands:\n```\n(.*?)```", text, re.S).group(1).splitlines()
        self.assertEqual([command.split()[0] for command in commands], ["gmsh", "pdmesh", "pdrun", "pdplot"])
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "plate.geo").write_text(drawing)
            (folder / "plate.yaml").write_text(deck)
            path = os.pathsep.join([str(folder / "bin"), str(ROOT / "meshes"), os.environ["PATH"]])
            (folder / "bin").mkdir()
            (folder / "bin" / "pdrun").symlink_to(PDRUN)
            for command in commands:
                done = subprocess.run(command.split(), cwd=folder, env={**os.environ, "PATH": path}, text=True,
                                      capture_output=True, timeout=280)
                self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}{done.stderr}")
                self.assertNotIn("warning", done.stdout.lower() + done.stderr.lower(), command)
            with Image.open(folder / "plate_Damage.png") as picture:
                self.assertGreater(min(picture.size), 500)
            with h5py.File(folder / "plate.h5") as results:
                x, damage = results["mesh/coordinates"][:], results["steps/000020/Damage"][:]
        # A body torn in two has damage in every column between the notch's end at 30 mm and the right edge, but for the
        # hole from 52 to 72 mm; the grips have none.
        for left in [*range(31, 50, 2), *range(74, 98, 2)]:
            column = (x[:, 0] > 1e-3 * left) & (x[:, 0] < 1e-3 * (left + 2))
            self.assertGreater(damage[column].max(), 0.3, f"from {left} mm")
        self.assertEqual(damage[(x[:, 1] < 0.01) | (x[:, 1] > 0.05)].max(), 0.0)


if __name__ == "__main__":
    if shutil.which("gmsh") is None:
        sys.exit("no gmsh: ./setup.sh test installs it")
    unittest.main()
