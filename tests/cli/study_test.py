"""pdrun --study: tables, errors, histories and pictures of studies whose every number is known."""
import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

from pdplot_lib.study import Table, draw_histories  # noqa: E402

PDRUN = os.path.abspath(os.environ["PDRUN"])

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


HISTORIES_DECK = DECK.replace("Exact Solution:\n  Pair", """\
Compute Class Parameters:
  Highest: {Compute Class: Field_Maximum, Variable: Concentration, Output Label: Highest}
  Lowest: {Compute Class: Field_Minimum, Variable: Concentration, Output Label: Lowest}
  Corner:
    Compute Class: Node_Set_Data
    Node Set: All Node Set
    Variable: Model_Coordinates
    Calculation Type: Maximum
    Output Label: Corner
Exact Solution:
  Pair""")

HISTORIES_STUDY = """\
Deck: pair.yaml
Name: pair
Histories: [Highest, Lowest, Corner]
History Values: [Final, Maximum, Minimum, Time Of Maximum]
Series:
  - Label: Euler
    Overrides: {Solver/Diffusion/Method: Euler}
    Sweep: {Solver/Diffusion/Sub Steps: [4, 8, 16]}
"""


class StudyTest(unittest.TestCase):
    """A folder with the mesh of two points, and the means to run studies in it."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        volume = SPACING**2 * THICKNESS
        a = SPACING / math.sqrt(8.0)  # aslant, so that the body is plane
        self.write("mesh.txt", f"{-a} {-a} 0 1 {volume}\n{a} {a} 0 1 {volume}\n")
        self.write("pair.yaml", self.deck())
        self.write("study.yaml", self.study())

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

    def size_of_picture(self, name):
        with open(self.path(name), "rb") as file:
            header = file.read(24)
        self.assertEqual(header[:8], b"\x89PNG\r\n\x1a\n")
        return int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")

    def assert_mistakes(self, lines, *arguments):
        """All of them at once, each with its place; nothing has run."""
        done = self.run_study(*arguments)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for line in lines:
            self.assertIn(line, done.stderr)
        self.assertFalse(os.path.exists(self.path("pair.study.csv")))


class StudyOfErrors(StudyTest):
    def deck(self):
        return DECK

    def study(self):
        return STUDY

    def test_table_and_picture_have_every_run_with_its_error(self):
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
        self.assertIn("picture: pair.study.png", done.stdout)
        self.assertGreater(min(self.size_of_picture("pair.study.png")), 400)
        self.assertFalse(os.path.exists(self.path("pair.histories.png")))

    def test_values_of_the_command_line_reach_every_run(self):
        self.write("study.yaml", STUDY.replace("[4, 8, 16]", "[4, 2*4, 16]"))
        done = self.run_study("--quiet", "--set", f"Solver/Final Time={2.0 * TIME!r}")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertAlmostEqual(float(self.table()[0]["error"]), abs((1.0 - 2.0 / 4) ** 4 * math.e**2 - 1.0), delta=1e-8)
        self.assertEqual([row["Solver/Diffusion/Sub Steps"] for row in self.table()], ["4", "8", "16", ""])

    def test_mistakes_of_the_file_are_all_told_with_their_places(self):
        self.write("study.yaml", STUDY.replace("Label: Euler", "Labl: Euler").replace("Deck: pair", "Deck: pear")
                   .replace("Sub Steps: 10", "Sub Steps:").replace("Error: L2\n", ""))
        self.assert_mistakes(['study.yaml:1:1: the study: give at least one of "Error", "Histories"',
                              'study.yaml:1:1: the study: "Reference" needs "Error" beside it',
                              'study.yaml:1:7: Deck: there is no file "pear.yaml"',
                              'study.yaml:5:5: unknown key "Labl"',
                              "study.yaml:9:58: Series[2]/Overrides/Solver/Diffusion/Sub Steps has no value"])

    def test_mistakes_of_any_run_are_told_by_their_places_in_the_study(self):
        self.write("study.yaml", STUDY.replace("[4, 8, 16]", "[4, 8, -16]")
                   .replace("Method: Implicit Euler", "Methd: RKL"))
        self.assert_mistakes(["study.yaml:8:48: Solver/Diffusion/Sub Steps is -16", 'series "Euler"',
                              "study.yaml:10:41: unknown key \"Methd\"", 'series "Implicit, first order"'])

    def test_an_error_without_an_exact_solution_is_refused(self):
        self.write("pair.yaml", DECK[:DECK.index("Exact Solution")] + DECK[DECK.index("Output:"):])
        self.assert_mistakes(["study.yaml:4:8: Error: the deck has no section Exact Solution"], "--check")

    def test_meshes_are_read_to_check_them(self):
        self.write("mesh.txt", "0 0 0 1\n0.0005 0.0005 0 1 -1e-9\n")
        self.write("other.txt", "0 0 0 1 1e-9\n")
        self.write("study.yaml", STUDY.replace("Sweep: {Solver/Diffusion/Sub Steps: [4, 8, 16]}",
                                               "Sweep: {Discretization/Input Mesh File: [mesh.txt, other.txt]}"))
        self.assert_mistakes(["mesh.txt:1: ", "mesh.txt:2: ", "other.txt"], "--check")

    def test_a_study_without_mistakes_says_so(self):
        done = self.run_study("--check")
        self.assertEqual((done.returncode, done.stdout), (0, "study.yaml: no mistakes found, 4 runs\n"), done.stderr)

    def test_a_run_that_fails_leaves_its_error_empty_and_the_others_stand(self):
        # A step of 2.5 decay times or more is far above Euler's limit; the implicit run does not mind.
        done = self.run_study("--set", f"Solver/Final Time={40.0 * TIME!r}")
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertIn("3 of 4 runs of the study failed", done.stderr)
        self.assertEqual([row["error"] != "" for row in self.table()], [False, False, False, True])

    def test_an_error_that_names_no_single_norm_is_refused(self):
        self.write("study.yaml", STUDY.replace("Error: L2", "Error: Pair"))
        self.assert_mistakes(['study.yaml:4:8: Error: "Pair" must be part of exactly one error norm',
                              "Pair relative L2 error"])


class StudyOfHistories(StudyTest):
    def deck(self):
        return HISTORIES_DECK

    def study(self):
        return HISTORIES_STUDY

    def test_table_and_picture_have_what_the_study_asks_for(self):
        done = self.run_study()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        rows = self.table()
        self.assertNotIn("error", rows[0])
        self.assertEqual([row["Solver/Diffusion/Sub Steps"] for row in rows], ["4", "8", "16"])
        for row, n in zip(rows, (4, 8, 16)):
            factor = (1.0 - 1.0 / n) ** n  # of the amplitude, from the start at 1 to the end
            expected = {"Final Highest": factor, "Maximum Highest": 1.0, "Minimum Highest": factor,
                        "Time Of Maximum Highest": 0.0,
                        "Final Lowest": -factor, "Maximum Lowest": -factor, "Minimum Lowest": -1.0,
                        "Time Of Maximum Lowest": TIME,
                        "Final CornerX": SPACING / math.sqrt(8.0), "Final CornerZ": 0.0}
            for column, value in expected.items():
                self.assertAlmostEqual(float(row[column]), value, delta=1e-8 * max(1.0, abs(value)), msg=column)
            self.assertIn(f"{factor:.5g}", done.stdout)
        self.assertIn("picture: pair.histories.png", done.stdout)
        self.assertGreater(min(self.size_of_picture("pair.histories.png")), 1000)
        self.assertFalse(os.path.exists(self.path("pair.study.png")))
        figure = draw_histories(Table(self.path("pair.study.csv")))
        labels = {panel.get_ylabel() for panel in figure.axes}
        # The unit of a place, as the run has written it: its name says none.
        self.assertLessEqual({"CornerX (m)", "final, maximum, minimum CornerX (m)",
                              "time of maximum CornerX (s)"}, labels)

    def test_curves_are_told_apart_where_each_series_varies_something_else(self):
        self.write("study.yaml", HISTORIES_STUDY + """\
  - Label: start
    Sweep: {Boundary Conditions/Start/Value: ["x < 0 ? 1 : -1", "x < 0 ? 2 : -2"]}
""")
        self.assertEqual(self.run_study().returncode, 0)
        figure = draw_histories(Table(self.path("pair.study.csv")))
        labels = figure.axes[0].get_legend_handles_labels()[1]
        self.assertEqual(len(labels), 5)
        self.assertEqual(len(set(labels)), 5, labels)
        self.assertIn("start, Start/Value x < 0 ? 2 : -2", labels)

    def test_errors_and_histories_go_together(self):
        self.write("study.yaml", HISTORIES_STUDY.replace("Histories: [", "Error: L2\nReference: decay\nHistories: [")
                   .replace("History Values: [Final, Maximum, Minimum, Time Of Maximum]\n", "")
                   .replace("[4, 8, 16]", "[4]"))
        done = self.run_study()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        row = self.table()[0]
        self.assertAlmostEqual(float(row["error"]), abs((1.0 - 1.0 / 4) ** 4 * math.e - 1.0), delta=1e-8)
        self.assertAlmostEqual(float(row["Final Highest"]), (1.0 - 1.0 / 4) ** 4, delta=1e-8)
        self.assertNotIn("Maximum Highest", row)
        for picture in ("pair.study.png", "pair.histories.png"):
            self.assertGreater(min(self.size_of_picture(picture)), 400)

    def test_histories_that_no_run_writes_are_refused(self):
        self.write("study.yaml", HISTORIES_STUDY.replace("Highest", "Higest").replace("Minimum", "Mean"))
        self.assert_mistakes(['study.yaml:4:34: History Values', '"Mean" is not allowed here',
                              'study.yaml:3:13: Histories: no run writes "Higest" (did you mean "Highest"?); '
                              'there are: "Highest", "Lowest", "Corner"'], "--check")
        self.write("study.yaml", HISTORIES_STUDY)
        self.write("pair.yaml", HISTORIES_DECK + "Output2: {Output Filename: two, Output Variables: [Lowest]}\n")
        self.assert_mistakes(['study.yaml:3:22: Histories: no run writes "Lowest"'], "--check")
        self.write("pair.yaml", HISTORIES_DECK.replace("[Concentration]", "[Concentration], History Frequency: -1"))
        self.assert_mistakes(["pair.yaml:23:", "History Frequency"], "--check")


if __name__ == "__main__":
    unittest.main()
