"""pdrun --study: table, errors and picture of a study whose every number is known."""
import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest

PDRUN = None

DIFFUSIVITY, SPACING, HORIZON, THICKNESS = 1e-9, 1e-3, 1.6e-3, 1e-3
# Two points: their mean stays, their difference decays at twice the rate of the one bond,
# 4 D / (pi h delta^2) V / r^2 (inverse-square kernel in the plane; the neighbour counts whole).
RATE = 2.0 * 4.0 * DIFFUSIVITY / (math.pi * THICKNESS * HORIZON**2) * (SPACING**2 * THICKNESS) / SPACING**2
TIME = 1.0 / RATE

DECK = f"""\
Discretization: {{Type: Text File, Input Mesh File: mesh.txt, Thickness: {THICKNESS}}}
Materials:
  Iron: {{Material Model: PDHE, Plane Stress: true, Thickness: {THICKNESS}, Diffusivity: {DIFFUSIVITY:.17e}}}
Blocks:
  Pair: {{Block Names: block_1, Material: Iron, Horizon: {HORIZON}}}
Boundary Conditions:
  All Node Set: {{Expression: "x > -1"}}
  Start: {{Type: Initial Concentration, Node Set: All Node Set, Value: "x < 0 ? 1 : -1"}}
Solver:
  Final Time: {TIME!r}
  Diffusion: {{Method: RKL}}
Exact Solution:
  Pair: {{Field: Concentration, Value: "(x < 0 ? 1 : -1)*exp(-{RATE!r}*t)"}}
Output: {{Output Filename: pair, Output Variables: [Concentration]}}
"""

STUDY = """\
Deck: pair.yaml
Name: pair
Reference: decay of a pair
Error: L2
Series:
  - Label: Euler
    Overrides: {Solver/Diffusion/Method: Euler}
    Sweep: {Solver/Diffusion/Sub Steps: [4, 8, 16]}
  - Label: "Implicit, first order"
    Overrides: {Solver/Diffusion/Method: Implicit Euler, Solver/Diffusion/Sub Steps: 10}
"""


class Study(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        volume = SPACING**2 * THICKNESS
        a = SPACING / math.sqrt(8.0)  # aslant, so that the body is plane
        self.write("mesh.txt", f"{-a} {-a} 0 1 {volume}\n{a} {a} 0 1 {volume}\n")
        self.write("pair.yaml", DECK)
        self.write("study.yaml", STUDY)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def run_study(self, *arguments):
        return subprocess.run([PDRUN, "--study", "study.yaml", *arguments], cwd=self.folder.name, capture_output=True,
                              text=True, timeout=120)

    def table(self):
        with open(self.path("pair.study.csv"), newline="") as file:
            return list(csv.DictReader(file))

    def test_table_has_every_run_with_its_error(self):
        done = self.run_study()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn('pair: error "L2" against decay of a pair', done.stdout)
        rows = self.table()
        self.assertEqual([row["label"] for row in rows], 3 * ["Euler"] + ["Implicit, first order"])
        self.assertEqual(rows[1]["overrides"], "Solver/Diffusion/Method=Euler; Solver/Diffusion/Sub Steps=8")
        # Amplification of one step of length T/n with rate * T = 1, against exp(-1).
        factors = [(1.0 - 1.0 / n) ** n for n in (4, 8, 16)] + [(1.0 + 1.0 / 10) ** -10]
        for row, factor in zip(rows, factors):
            self.assertAlmostEqual(float(row["error"]), abs(factor * math.e - 1.0), delta=1e-8, msg=str(row))
            self.assertGreater(float(row["seconds"]), 0.0)
        # An Euler step evaluates both directed bonds once; so does the start and the estimate of the limit, at most.
        updates = [int(row["bond_updates"]) for row in rows[:3]]
        self.assertEqual(updates[2] - updates[1], 2 * (updates[1] - updates[0]))
        self.assertEqual(updates[1] - updates[0], 2 * 4)

    def test_picture_is_drawn(self):
        done = self.run_study()
        self.assertIn("picture: pair.study.png", done.stdout)
        with open(self.path("pair.study.png"), "rb") as file:
            header = file.read(24)
        self.assertEqual(header[:8], b"\x89PNG\r\n\x1a\n")
        width, height = int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")
        self.assertGreater(min(width, height), 400)

    def test_values_of_the_command_line_reach_every_run(self):
        done = self.run_study("--quiet", "--set", f"Solver/Final Time={2.0 * TIME!r}")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertAlmostEqual(float(self.table()[0]["error"]), abs((1.0 - 2.0 / 4) ** 4 * math.e**2 - 1.0), delta=1e-8)

    def test_mistakes_of_any_run_stop_the_study_before_it_starts(self):
        self.write("study.yaml", STUDY.replace("[4, 8, 16]", "[4, 8, -16]").replace("Label: Euler", "Labl: Euler"))
        done = self.run_study()
        self.assertEqual(done.returncode, 2)
        self.assertIn('study.yaml:6:5: unknown key "Labl"', done.stderr)
        self.write("study.yaml", STUDY.replace("[4, 8, 16]", "[4, 8, -16]"))
        done = self.run_study()
        self.assertEqual(done.returncode, 2)
        self.assertIn("Sub Steps", done.stderr)
        self.assertIn('series "Euler"', done.stderr)
        self.assertFalse(os.path.exists(self.path("pair.study.csv")))

    def test_a_run_that_fails_leaves_its_error_empty_and_the_others_stand(self):
        # A step of 2.5 decay times or more is far above Euler's limit; the implicit run does not mind.
        done = self.run_study("--set", f"Solver/Final Time={40.0 * TIME!r}")
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertIn("3 of 4 runs of the study failed", done.stderr)
        self.assertEqual([row["error"] != "" for row in self.table()], [False, False, False, True])

    def test_an_error_that_names_no_single_norm_is_refused(self):
        self.write("study.yaml", STUDY.replace("Error: L2", "Error: Pair"))
        done = self.run_study()
        self.assertEqual(done.returncode, 2)
        self.assertIn('"Pair" must be part of exactly one error norm', done.stderr)
        self.assertIn("Pair relative L2 error", done.stderr)


if __name__ == "__main__":
    PDRUN = os.path.abspath(sys.argv.pop(1))
    unittest.main()
