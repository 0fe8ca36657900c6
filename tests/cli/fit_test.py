"""pdrun --fit: values that are known are found again, intervals are those of certified regressions, mistakes
are told."""
import csv
import io
import json
import math
import os
import subprocess
import sys
import unittest
import warnings
from contextlib import redirect_stderr
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pdfit_lib.intervals import Judgement  # noqa: E402
from pdfit_lib.least_squares import Fit  # noqa: E402
from pdfit_lib.problem import FitError, Problem, Series, Value  # noqa: E402
from study_test import DIFFUSIVITY, HISTORIES_DECK, PDRUN, TIME, StudyTest  # noqa: E402

AMPLITUDE = 2.5
# The decay of a pair of points (study_test.py) from another amplitude, in mm^2/s and h.
FIT = """\
Deck: pair.yaml
Name: pair
Tolerance: 1.0e-6
Values:
  Amplitude: {Start: 1.5, Lowest: 0.1, Highest: 10.0}
  D: {Start: 6.0e-4, Unit: mm^2/s, Logarithmic: true}
Overrides:
  Materials/Iron/Diffusivity: "{D}"
  Boundary Conditions/Start/Value: "x < 0 ? {Amplitude} : -{Amplitude}"
Series:
  - Label: decay
    Data: decay.csv
    Time: hours
    Time Unit: h
    Value: highest
    Deviation: sd
    History: Highest
    Until: 0.6
"""


class FitTest(StudyTest):
    def deck(self):
        return HISTORIES_DECK.replace(f"Final Time: {TIME!r}", f"Final Time: {2 * TIME!r}").replace(
            "{Method: RKL}", "{Method: RKL, Load Steps: 80}")

    def study(self):
        return ""

    def setUp(self):
        super().setUp()
        rows = "".join(f"{t * TIME / 3600:.9g},{AMPLITUDE * math.exp(-t):.9g},{0.01 * AMPLITUDE}\n"
                       for t in (0.25, 0.75, 1.25, 1.75))
        self.write("decay.csv", f"# exact\nhours,highest,sd\n{rows}")
        self.write_fit(FIT)

    def write_fit(self, text):
        self.write("fit.yaml", text.replace("Until: 0.6", f"Until: {1.3 * TIME:.6g}"))

    def fit(self, *arguments):
        return subprocess.run([PDRUN, "--fit", "fit.yaml", *arguments], cwd=self.folder.name, capture_output=True,
                              text=True, timeout=120)

    def results(self):
        with open(self.path("pair.fit.json")) as file:
            return json.load(file)

    def refused(self, *lines):
        done = self.fit("--check")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for line in lines:
            self.assertIn(line, done.stderr)
        self.assertFalse(os.path.exists(self.path("pair.fit.json")))


class Twins(FitTest):
    def test_known_values_are_found_again_and_their_deck_runs(self):
        done = self.fit()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        results = self.results()
        amplitude, diffusivity = results["values"]
        self.assertAlmostEqual(amplitude["value"], AMPLITUDE, delta=1e-3 * AMPLITUDE)
        self.assertAlmostEqual(diffusivity["value"], 1e6 * DIFFUSIVITY, delta=1e-3 * 1e6 * DIFFUSIVITY)
        self.assertTrue(results["converged"])
        # Least squares by hand: A exp(-r t), derivatives exp(-r t) and -A t exp(-r t) to A and ln(r).
        t = np.array([0.25, 0.75, 1.25])
        jacobian = np.stack([np.exp(-t), -AMPLITUDE * t * np.exp(-t)], axis=1) / (0.01 * AMPLITUDE)
        half = 1.959964 * np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian)))
        self.assertAlmostEqual((amplitude["interval"][1] - amplitude["interval"][0]) / (2 * half[0]), 1.0, delta=0.02)
        ratio = math.log(diffusivity["interval"][1] / diffusivity["interval"][0]) / (2 * half[1])
        self.assertAlmostEqual(ratio, 1.0, delta=0.02)
        # The row after Until was not fitted; it is met all the same.
        with open(self.path("pair.fit.residuals.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["fitted"] for row in rows], ["true", "true", "true", "false"])
        self.assertTrue(all(abs(float(row["residual"])) < 0.1 for row in rows), rows)
        self.assertEqual(rows[3]["place"], "decay.csv:6")
        self.assertGreater(min(self.size_of_picture("pair.fit.png")), 400)
        with open(self.path("pair.fit.csv"), newline="") as file:
            table = list(csv.DictReader(file))
        self.assertEqual(float(table[0]["D (mm^2/s)"]), 6e-4)
        self.assertEqual(float(table[-1]["Amplitude"]), round(amplitude["value"], 8))
        self.check_deck()
        # A second fit takes the runs of the first; a file that the deck names has changed: none of them.
        again = self.fit("--quiet")
        self.assertEqual((again.returncode, again.stdout), (0, ""), again.stderr)
        self.assertEqual((self.results()["runs"], self.results()["values"]), (0, results["values"]))

    def check_deck(self):
        """That of the fit runs, from another folder too, and gives the fitted history."""
        with open(self.path("pair.fitted.yaml")) as file:
            self.assertIn("#   Amplitude: 2.5", file.read())
        os.mkdir(self.path("elsewhere"))
        done = subprocess.run([PDRUN, self.path("pair.fitted.yaml"), "--quiet"], cwd=self.path("elsewhere"),
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("elsewhere/pair_fitted.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertAlmostEqual(float(rows[0]["Highest"]), AMPLITUDE, delta=1e-3 * AMPLITUDE)
        self.assertAlmostEqual(float(rows[-1]["Highest"]), AMPLITUDE * math.exp(-2), delta=1e-3 * AMPLITUDE)

    def test_a_run_for_each_row(self):
        rows = "".join(f"{t * TIME:.9g},{math.exp(-t):.9g}\n" for t in (0.5, 1.5))
        self.write("ends.csv", f"end,highest\n{rows}")
        self.write_fit(f"""\
Deck: pair.yaml
Name: pair
Values:
  D: {{Start: {0.9 * DIFFUSIVITY}}}
Series:
  - Label: ends
    Data: ends.csv
    Value: highest
    History: Highest
    History Value: Final
    Logarithmic: true
    Overrides: {{Solver/Final Time: "{{end}}", Materials/Iron/Diffusivity: "{{D}}"}}
""")
        done = self.fit()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertAlmostEqual(self.results()["values"][0]["value"], DIFFUSIVITY, delta=1e-3 * DIFFUSIVITY)

    def test_a_run_in_which_nothing_happens_is_no_life(self):
        # The highest value of a decay is that of the start.
        self.write("ends.csv", f"end,life\n{0.5 * TIME:.9g},1\n")
        self.write_fit(f"""\
Deck: pair.yaml
Name: pair
Values:
  D: {{Start: {DIFFUSIVITY}}}
Series:
  - {{Label: lives, Data: ends.csv, Value: life, History: Highest, History Value: Time Of Maximum,
     Overrides: {{Solver/Final Time: "{{end}}", Materials/Iron/Diffusivity: "{{D}}"}}}}
""")
        done = self.fit()
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        self.assertRegex(done.stderr, 'with the values of Start ends.csv:2 \\(run pair.fit/.*the maximum of "Highest" '
                         "is reached at the start: nothing happened; set a later Final Time or leave the row out")

    def test_what_the_runs_tell_is_told(self):
        self.write_fit(FIT.replace("  D: {", "  E: {Start: 3.0e9, Lowest: 1.0e9, Highest: 1.0e10}\n  D: {").replace(
            "Overrides:\n", "Overrides:\n  Materials/Iron/Young's Modulus: \"{E}\"\n"
            "  Materials/Iron/Poisson's Ratio: 0.33\n"))
        done = self.fit()
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        self.assertIn("E has no influence on any fitted point", done.stderr)
        # Steps of 5 decay times are far above Euler's limit.
        self.write_fit(FIT)
        done = self.fit("--set", "Solver/Diffusion/Method=Euler", "--set", "Solver/Diffusion/Sub Steps=1", "--set",
                        f"Solver/Final Time={400 * TIME!r}")
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        self.assertIn("with the values of Start a run failed", done.stderr)


class Mistakes(FitTest):
    def test_a_good_fit_says_so(self):
        done = self.fit("--check")
        self.assertEqual((done.returncode, done.stdout), (0, "fit.yaml: no mistakes found, 2 values, 1 runs a step\n"),
                         done.stderr)

    def test_of_the_file(self):
        # Of all parts at once, and of the deck as far as its values are known.
        self.write_fit(FIT.replace("Lowest: 0.1, Highest: 10.0", "Lowest: 10.0, Highest: 0.1")
                       .replace("Unit: mm^2/s", "Unit: mn^2/s").replace("-{Amplitude}", "-{Amplitud}")
                       .replace('"{D}"', "{D}").replace("Value: highest", "Value: higest"))
        self.refused('fit.yaml:5:35: Values/Amplitude: Lowest 10.0 must be below Highest 0.1',
                     'there is no unit "mn^2/s"', 'has no column "higest" (did you mean "highest"?)',
                     'nothing is called "Amplitud" (did you mean "Amplitude"?)',
                     'write names in braces in quotes: "{D}"')
        self.write_fit(FIT.replace("Data: decay.csv", "Data: decai.csv").replace("History: Highest", "History: Higest")
                       .replace("Iron/Diffusivity", "Irn/Diffusivity") + "  - {Labl: decay, Data: decay.csv}\n")
        self.refused('Series[1]/Data: there is no file "decai.csv"', 'unknown key "Labl"',
                     'the deck has no "Irn" in Materials (did you mean "Iron"?)')
        self.write_fit(FIT.replace("Data: decay.csv", "Data: decai.csv").replace("History: Highest", "History: Higest"))
        self.refused('there is no file "decai.csv"', 'no run writes "Higest" (did you mean "Highest"?)')
        self.write_fit(FIT.replace("{D}", "1.0e-9"))
        self.refused('fit.yaml:6:3: "D" stands in no override')
        self.write_fit(FIT.replace("Start: 1.5", "Start: 11.0").replace("Start: 6.0e-4", "Start: -6.0e-4"))
        self.refused("Start 11.0 must lie between", "of a Logarithmic value Start and Lowest must be above 0")

    def test_of_the_data(self):
        self.write("decay.csv", "hours,highest,sd\n0.1,2.0,0\n0.2,x,0.1\n0.3,2\n")
        self.refused("decay.csv:4: has 2 cells, but there are 3 columns")
        self.write("decay.csv", "hours,highest,sd\n0.1,2.0,0\n0.2,x,0.1\n")
        self.refused("decay.csv:2: the standard deviation must be above 0", 'decay.csv:3: "x" in column "highest"')
        self.write("decay.csv", f"hours,highest,sd\n0.0,2.0,0.1\n{TIME / 1800 * 1.2:.6g},2.0,0.1\n")
        self.write("fit.yaml", FIT.replace("    Until: 0.6\n", ""))
        self.refused("decay.csv:3: time", "lies outside of the run of series \"decay\"")
        self.write("decay.csv", "hours,highest,sd\n0.0,2.0,0.1\n")
        self.refused("1 measured points cannot tell 2 values")

    def test_of_the_decks(self):
        self.write_fit(FIT.replace("Iron/Diffusivity", "Irn/Diffusivity"))
        self.refused('fit.yaml:8:30: the deck has no "Irn" in Materials (did you mean "Iron"?)')
        self.write_fit(FIT.replace("History: Highest", "History: Higest"))
        self.refused('History: no run writes "Higest" (did you mean "Highest"?)')
        self.write_fit(FIT.replace("History: Highest", "History: Corner"))
        self.refused('name one: "CornerX", "CornerY", "CornerZ"')
        self.write_fit(FIT.replace("History: Highest", "History: CornerX\n    Unit: h"))
        self.refused('Unit: "h" does not convert to that of the history "CornerX", which is m')
        self.write_fit(FIT.replace("Unit: mm^2/s", "Unit: mm/s"))
        self.refused("fit.yaml:8:31: Materials/Iron/Diffusivity", "mm/s does not convert to")
        self.write_fit(FIT.replace("Unit: mm^2/s, Logarithmic: true", "Unit: mm^2/s, Lowest: -1.0"))
        self.refused('with "D" at its bound -1')

    def test_of_the_command_line(self):
        for arguments, words in ((["pair.yaml"], "a fit names its deck itself"), (["--study", "s.yaml"], "two things")):
            done = self.fit(*arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)
        self.write("pair.fit.csv", "mine\n")
        self.refused("pair.fit.csv")


class Stub:
    """Runs in place of pdrun: a function of the values that returns a history."""

    def __init__(self, problem, model, time):
        self.problem, self.model, self.time = problem, model, np.asarray(time)

    def histories(self, sets):
        return [None if (y := self.model(self.time, *values)) is None else {0: {"time": self.time, "Y": y}}
                for values in sets]

    def why(self, values):
        return "too much" if self.model(self.time, *values) is None else ""

    def name(self, run, values):
        return f"stub {run}"


class StubProblem:
    tolerance, difference_step, is_central, max_iterations, is_quiet = 1e-8, 1e-4, True, 100, True

    def __init__(self, values, x, y, deviation=0.0, logarithmic=False):
        keys = {"unit": "", "factor": 1.0, "lowest": None, "highest": None, "logarithmic": False}
        self.values = [Value({**keys, "scale": abs(value["start"]), **value}) for value in values]
        points = [{"run": 0, "time": t, "measured": m, "deviation": deviation, "fitted": True,
                   "place": f"data.csv:{k}"} for k, (t, m) in enumerate(zip(x, y), 2)]
        self.series = [Series({"label": "s", "column": "Y", "value": "", "factor": 1.0, "unit": "", "time unit": "",
                               "time factor": 1.0, "logarithmic": logarithmic, "points": points})]

    has_deviations = property(lambda self: self.series[0].has_deviations)

    text = Problem.text

    def unscaled(self, scaled):
        return [value.unscaled(u) for value, u in zip(self.values, scaled)]

    def judge(self, model):
        x = self.series[0].time
        return Judgement(self, Fit(self, Stub(self, model, x), lambda values, squares: None).run())


# Misra1a of NIST's Statistical Reference Datasets: dental research, monomolecular adsorption.
MISRA_Y = [10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78]
MISRA_X = [77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0]


class Numbers(unittest.TestCase):
    def test_a_certified_regression(self):
        t95 = 2.178812830  # of Student's distribution with 12 degrees of freedom, 97.5 %
        for logarithmic in (False, True):
            problem = StubProblem([{"name": "b1", "start": 250.0}, {"name": "b2", "start": 5e-4,
                                                                    "logarithmic": logarithmic}], MISRA_X, MISRA_Y)
            judgement = problem.judge(lambda x, b1, b2: b1 * (1.0 - np.exp(-b2 * x)))
            certified = [(238.94212918, 2.7070075241), (5.5015643181e-4, 7.2668688436e-6)]
            for judged, (value, deviation) in zip(judgement.values, certified):
                self.assertAlmostEqual(judged.number / value, 1.0, delta=1e-7)
                width = 0.5 * (judged.interval[1] - judged.interval[0])
                self.assertAlmostEqual(width / (t95 * deviation), 1.0, delta=1e-3)
                self.assertIn("goes with", judged.note)
            self.assertAlmostEqual(judgement.sum_of_squares / 0.12455138894, 1.0, delta=1e-7)
            self.assertEqual(judgement.degrees, 12)

    def test_deviations_that_are_given_count(self):
        x = np.arange(6.0)
        y = 2.0 + 3.0 * x
        values = [{"name": "a", "start": 1.0}, {"name": "b", "start": 1.0}]
        # As good as they say: the normal distribution; worse: the scatter, by Student's.
        judgement = StubProblem(values, x, y, 0.5).judge(lambda x, a, b: a + b * x)
        width = 0.5 * (judgement.values[1].interval[1] - judgement.values[1].interval[0])
        self.assertAlmostEqual(width, 1.959963985 * 0.5 / np.sqrt(17.5), delta=1e-6)
        rough = y + np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])
        judgement = StubProblem(values, x, rough, 0.5).judge(lambda x, a, b: a + b * x)
        slope, offset = np.polyfit(x, rough, 1)
        variance = np.sum((rough - slope * x - offset) ** 2) / 4
        width = 0.5 * (judgement.values[1].interval[1] - judgement.values[1].interval[0])
        self.assertAlmostEqual(width, 2.776445105 * np.sqrt(variance / 17.5), delta=1e-5)

    def test_what_is_not_determined_is_told(self):
        x = np.arange(1.0, 7.0)
        values = [{"name": "a", "start": 1.0}, {"name": "b", "start": 2.0}]
        # Only the product matters.
        judgement = StubProblem(values, x, 6.0 * x).judge(lambda x, a, b: a * b * x)
        self.assertAlmostEqual(judgement.values[0].number * judgement.values[1].number, 6.0, delta=1e-5)
        for judged in judgement.values:
            self.assertTrue(judged.note.startswith("not determined: the points do not tell it"), judged.text())
        bounded = StubProblem([{"name": "a", "start": 1.0, "lowest": 0.5, "highest": 2.0}, values[1]], x, 3.0 + 6.0 * x)
        judgement = bounded.judge(lambda x, a, b: b + a * x)
        self.assertIn("at its bound Highest", judgement.values[0].note)
        self.assertIsNotNone(judgement.values[1].interval)
        judgement = StubProblem(values, [1.0, 2.0], [5.0, 7.0]).judge(lambda x, a, b: b + a * x)
        self.assertIn("as many values as points", judgement.values[0].text())

    def test_histories_with_too_few_rows_are_told(self):
        time = np.linspace(0.0, 4.0, 17)
        for at, expected in ((np.arange(0.375, 3.0, 0.5), math.exp(-0.375) * 0.25**2 / 8), (time[2:9], 0.0)):
            series = StubProblem([], at, np.exp(-at)).series[0]
            error = series.interpolation_error({0: {"time": time, "Y": np.exp(-time)}})
            # What linear interpolation is off by half way between rows, to leading order.
            self.assertAlmostEqual(error, expected, delta=0.2 * expected)

    def test_runs_that_fail_on_the_way_are_stepped_back_from(self):
        x = np.linspace(0.0, 3.0, 8)
        values = [{"name": "rate", "start": 0.2}]
        judgement = StubProblem(values, x, np.exp(-x)).judge(lambda x, k: np.exp(-k * x) if k < 1.05 else None)
        self.assertAlmostEqual(judgement.values[0].number, 1.0, delta=1e-6)
        with self.assertRaisesRegex(FitError, "Start a run failed: too much"):
            StubProblem(values, x, np.exp(-x)).judge(lambda x, k: None)

    def test_a_fit_gives_up_after_as_many_steps_as_the_file_says(self):
        x = np.linspace(0.0, 3.0, 8)
        problem = StubProblem([{"name": "rate", "start": 0.2}], x, np.exp(-x))
        errors = []
        for problem.max_iterations in (1, 2):
            fitted = Fit(problem, Stub(problem, lambda x, k: np.exp(-k * x), x), lambda values, squares: None).run()
            self.assertFalse(fitted.is_converged)
            errors.append(abs(problem.unscaled(fitted.scaled)[0] - 1.0))
        self.assertLess(errors[0], 0.8)  # of the start
        self.assertLess(errors[1], errors[0])

    def test_logarithms_need_values_above_zero(self):
        x = np.linspace(0.0, 3.0, 8)

        def fit(start):
            values = [{"name": "rate", "start": start}]
            model = lambda x, k: np.exp(-k * x) if k < 1.05 else 0.0 * x  # noqa: E731
            return StubProblem(values, x, np.exp(-2 * x), logarithmic=True).judge(model)

        with warnings.catch_warnings(), redirect_stderr(io.StringIO()) as said:
            warnings.simplefilter("error")
            self.assertLess(fit(0.2).values[0].number, 1.05)
            with self.assertRaisesRegex(FitError, 'Start data.csv:2 .run stub 0.: "Y" is 0, which has no logarithm'):
                fit(2.0)
        self.assertRegex(said.getvalue(), 'failed with rate 1.[0-9]+:\n  data.csv:2 .run stub 0.: "Y" is 0, which')



if __name__ == "__main__":
    unittest.main()
