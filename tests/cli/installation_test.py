"""What `cmake --install` leaves works by itself, without source and build folder; another project finds it and makes a
pdrun with a damage model and a condition of its own."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
from PIL import Image

HERE = Path(__file__).resolve().parent
BUILD = Path(os.environ["PD_BUILD_DIR"])


def run(*command, folder, path=None):
    environment = dict(os.environ)
    if path is not None:
        environment["PATH"] = f"{path}{os.pathsep}{environment['PATH']}"
    return subprocess.run([str(word) for word in command], cwd=folder, env=environment, text=True, capture_output=True,
                          timeout=250)


class Installation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="pd_installation_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.prefix = cls.folder / "prefix"
        done = run("cmake", "--install", BUILD, "--prefix", cls.prefix, folder=cls.folder)
        if done.returncode != 0:
            raise RuntimeError(done.stdout + done.stderr)

    def succeed(self, *command, **options):
        done = run(*command, folder=self.folder, path=self.prefix / "bin", **options)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}{done.stderr}")
        return done.stdout

    def test_no_file_knows_where_it_was_built(self):
        sources = str(HERE.parents[1])
        files = [file for file in self.prefix.rglob("*") if file.is_file()]
        self.assertGreater(len(files), 100)
        for file in files:
            content = file.read_bytes()
            self.assertNotIn(sources.encode(), content, file)
            self.assertNotIn(str(BUILD).encode(), content, file)
            self.assertTrue(file.resolve().is_relative_to(self.prefix.resolve()), file)

    def test_its_version_is_that_of_changelog_and_citation(self):
        version = self.succeed("pdrun", "--version").split()[-1]
        documents = self.prefix / "share" / "doc" / "PeridynamicDegradation"
        self.assertIn(f"\nversion: {version}\n", (documents / "CITATION.cff").read_text())
        self.assertIn(f"\n## {version}\n", (documents / "CHANGELOG.md").read_text())

    def test_studies_and_fits_find_their_tools(self):
        for file, test in (("study_test.py", "StudyOfErrors.test_table_and_picture_have_every_run_with_its_error"),
                           ("fit_test.py", "Twins.test_known_values_are_found_again_and_their_deck_runs")):
            done = subprocess.run([sys.executable, HERE / file, test], text=True, capture_output=True,
                                  env={**os.environ, "PDRUN": str(self.prefix / "bin" / "pdrun")})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_another_project_adds_a_damage_model_and_a_condition(self):
        self.succeed("cmake", "-S", HERE / "outside_project", "-B", "build", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                     "-DCMAKE_BUILD_TYPE=Release")
        self.succeed("cmake", "--build", "build")
        pdrun = self.folder / "build" / "pdrun"
        self.assertIn("  Limit", self.succeed(pdrun, "--explain", "Elongation Limit"))
        # Registered are all that are installed, and these two.
        names = set(self.succeed(pdrun, "--list").splitlines()) - set(self.succeed("pdrun", "--list").splitlines())
        self.assertEqual({name.split("  ")[1] for name in names}, {"Elongation Limit", "Weight Of Water"})

        self.succeed("pdmesh", "grid", "box", "--size", "4", "--spacing", "1", "--quiet", "-o", "bar.txt")
        moved = (HERE / "outside_project" / "bar.yaml").read_text()
        # Multigrid is a library that is loaded when it is asked for.
        solved = moved.replace("Verlet: {Fixed dt: 1.0e-3}", "QuasiStatic: {Preconditioner: Multigrid}").replace(
            "x > -1", "x < 1 || x > 3")
        self.assertNotEqual(solved, moved)
        for deck in (solved, moved):
            (self.folder / "bar.yaml").write_text(deck)
            self.succeed(pdrun, "bar.yaml", "--quiet")
            with h5py.File(self.folder / "bar.h5") as results:
                damage = list(results[f"steps/{max(results['steps'])}/Damage"][:])
            # Bonds of 2 m grow by 0.3 m and break, those of 1 m by 0.15 m. Ends have one of each, others two of 1 m.
            self.assertEqual(damage, [1 / 2, 1 / 3, 1 / 3, 1 / 2])
        self.succeed("pdplot", "bar")
        with Image.open(self.folder / "bar_Damage.png") as picture:
            self.assertGreater(min(picture.size), 100)


if __name__ == "__main__":
    unittest.main()
