"""Runs that go on from the time of a checkpoint, by each solver."""
import re
import shutil

import h5py
import numpy as np

from corrosion_scene import STEEL, corrosion_deck, front_speed
from scene import SceneTest, lattice, plate_deck

SPACING, THICKNESS, LENGTH = 5e-3, 4e-3, 0.06
STEPS, EARLY = 8, 4  # of the run, and of its checkpoint


def plate(solver, fields, conditions=None, damage=None):
    """A plate that is pulled to the right, into which something diffuses from the left."""
    ends = {"Left Node Set": {"Expression": f"x < {2 * SPACING}"},
            "Right Node Set": {"Expression": f"x > {LENGTH - 2 * SPACING}"},
            "Hold": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": "x", "Value": 0.0},
            "Keep": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": "y", "Value": 0.0},
            "Pull": {"Type": "Prescribed Displacement", "Node Set": "Right Node Set", "Coordinate": "x",
                     "Value": "2e-5*t"},
            "Feed": {"Type": "Prescribed Concentration", "Node Set": "Left Node Set", "Value": "1 + t"},
            "Sink": {"Type": "Prescribed Concentration", "Node Set": "Right Node Set", "Value": 0.0}}
    return plate_deck(
        3.015 * SPACING, THICKNESS,
        {"Young's Modulus": 207e9, "Poisson's Ratio": 0.29, "Density": 7850.0, "Diffusivity": 1e-4}, damage,
        conditions or ends, solver, {"Output Variables": [*fields, "Mean"]},
        Compute_Class_Parameters={"Mean": {"Compute Class": "Field_Mean", "Variable": fields[0], "Output Label": "Mean"}})


def only(deck, what):
    """The plate with one of its two physics."""
    other = "Concentration" if what == "Displacement" else "Displacement"
    deck["Boundary Conditions"] = {name: entry for name, entry in deck["Boundary Conditions"].items()
                                   if entry.get("Type") != "Prescribed " + other}
    if what == "Displacement":
        del deck["Materials"]["Steel"]["Diffusivity"]
    return deck


def mechanics(name, **parameters):
    return lambda steps, time: only(plate({"Final Time": time, name: {"Load Steps": steps, **parameters}},
                                          ["Displacement"]), "Displacement")


def diffusion(method, **parameters):
    return lambda steps, time: only(plate({"Final Time": time, "Diffusion": {
        "Load Steps": steps, "Method": method, **parameters}}, ["Concentration"]), "Concentration")


def steady(steps, time):
    return only(plate({"Final Time": time, "ImplicitDiffusion": {
        "Field": "Concentration", "Load Steps": steps, "Relative Tolerance": 1e-12}}, ["Concentration"]), "Concentration")


def verlet(steps, time):
    # A step is about half the critical one.
    unit = STEPS * 2e-7
    deck = only(plate({"Final Time": time * unit, "Verlet": {"Fixed dt": time * unit / steps}},
                      ["Displacement", "Velocity"]), "Displacement")
    deck["Boundary Conditions"]["Pull"]["Value"] = f"2e-5*t/{unit!r}"
    return deck


def staggered(steps, time):
    return plate({"Final Time": time, "Staggered": {
        "Load Steps": steps, "Diffusion": {"Method": "RKL"},
        "Mechanics": {"Adaptive Dynamic Relaxation": {"Relative Tolerance": 1e-8}}}}, ["Displacement", "Concentration"])


def staggered_list(steps, time):
    return plate({"Final Time": time, "Staggered": {"Load Steps": steps, "Solvers": {
        "Hydrogen": {"Diffusion": {"Method": "RKL"}, "Every": 3, "Time Scale": 0.5},
        "Equilibrium": {"QuasiStatic": {"Relative Tolerance": 1e-10},
                        "When": {"Field": "Concentration", "Has Changed By": 0.1}, "Sub Steps": 2}}}},
                 ["Displacement", "Concentration"])


def corrosion(steps, time):
    # The front moves by two spacings of the lattice.
    deck = corrosion_deck(2, STEEL, "x > 10e-6", "x < 4e-6", time * 2e-6 / front_speed(STEEL), steps)
    deck["Output"]["Output Variables"] = ["Concentration", "Damage", "Dissolved"]
    return deck


# The deck by number of increments and length of time; by how much results may differ with other increments, of the
# largest value: what their own error in time allows, or that of an equilibrium.
CASES = {"Verlet": (verlet, 0.05), "QuasiStatic": (mechanics("QuasiStatic", **{"Relative Tolerance": 1e-10}), 1e-7),
         "Adaptive Dynamic Relaxation":
             (mechanics("Adaptive Dynamic Relaxation", **{"Relative Tolerance": 1e-9}), 1e-6),
         "Euler": (diffusion("Euler"), 0.02), "RKL": (diffusion("RKL"), 1e-3),
         "Implicit Euler": (diffusion("Implicit Euler"), 0.05), "TR-BDF2": (diffusion("TR-BDF2"), 1e-3),
         "ImplicitDiffusion": (steady, 1e-9), "Corrosion": (corrosion, 0.05), "Staggered": (staggered, 1e-3),
         "Staggered list": (staggered_list, 0.1)}

# Tables of a checkpoint, how to change their shape or kind, and what the message says then.
OTHER_SHAPES = (
    ("points/Displacement", lambda values: np.repeat(values[:, :, None], 5, axis=2), "3 dimensions"),
    ("points/Volume", lambda values: values[:, None, None], "3 dimensions"),
    ("points/Displacement", lambda values: values[:, :2], "2 values a row"),
    ("points/Displacement", lambda values: np.full(values.shape, np.nan), "Displacement"),
    ("points/Displacement", lambda values: values.astype("S8"), "read table"),
    ("solver/state", lambda values: np.float64(1.0), "0 dimensions"),
    ("bonds/neighbor", lambda values: values[::-1], "other neighbourhoods"))
# Those of which ranks have unequal shares.
OTHER_LENGTHS = (
    ("points/Displacement", lambda values: values[:-1], "rows"),
    ("solver/state", lambda values: values[:-1], "numbers and"),
    ("bonds/count", lambda values: values + 1, "other neighbourhoods"),
    ("bonds/count", lambda values: np.zeros_like(values), "other neighbourhoods"),
    ("bonds/neighbor", lambda values: values[:-1], "other neighbourhoods"))


class RestartTest(SceneTest):
    def make(self, case, steps=STEPS, time=1.0, **output):
        """The deck of a case, with a checkpoint of its step EARLY that later ones do not replace."""
        deck = CASES[case][0](steps, time)
        if case == "Corrosion":
            self.write_mesh(lattice([24e-6, 4e-6], 1e-6), 1e-12)
        else:
            self.write_mesh(lattice([LENGTH, LENGTH / 2], SPACING), SPACING**2 * THICKNESS)
        deck["Output"].update({"Output Filename": "result", **output})
        deck["Output2"] = {"Output Filename": "early", "Final Output Step": EARLY, "Checkpoint Frequency": EARLY,
                                "Output Variables": ["Mean" if "Mean" in deck["Output"]["Output Variables"]
                                                     else "Dissolved"]}
        return deck

    def fields(self, case):
        return [label for label in self.make(case)["Output"]["Output Variables"] if label not in ("Mean", "Dissolved")]

    def start(self, case, **changes):
        """The run that writes early.checkpoint.h5; its deck and its last fields."""
        deck = self.make(case, **changes)
        result = self.solve(deck)
        self.whole_times = self.times(result)
        self.whole_steps = self.steps_reported(result)
        return deck, self.last(result, case)

    def last(self, result, case):
        return {label: result.field(label) for label in self.fields(case)}

    def go_on(self, deck, checkpoint="early.checkpoint.h5", **options):
        return self.solve(deck, arguments=["--restart", checkpoint], **options)

    def assert_same(self, found, expected, what):
        for label, values in expected.items():
            np.testing.assert_array_equal(found[label], values, f"{what}: {label}")

    def assert_close(self, found, expected, share, what):
        for label, values in expected.items():
            allowed = share * np.max(np.abs(values))
            self.assertLessEqual(np.max(np.abs(found[label] - values)), allowed, f"{what}: {label}")

    def times(self, result):
        """Times of the history by step, which rise by one from row to row."""
        history = result.history()
        np.testing.assert_array_equal(history["step"], np.arange(len(history["step"])))
        self.assertTrue(np.all(np.diff(history["time"]) > 0.0), history["time"])
        return history["time"]

    def steps_reported(self, result):
        """What the solvers' lines of the report begin with: numbers of steps and load steps."""
        return re.findall(r"\d+ (?:load )?steps(?: \(\d+ rejected\))?", "\n".join(result.report["solver"]))

    def log(self):
        with open(self.path("result.log")) as file:
            return file.read()

    def refused(self, deck, *words, checkpoint="early.checkpoint.h5", ranks=1):
        result = self.run_deck(deck, arguments=["--restart", checkpoint], ranks=ranks, timeout=60)
        self.assertEqual(result.code, 3, result.text)
        self.assertNotIn("HDF5: infinite loop", result.text)
        for word in (checkpoint, *words):
            self.assertIn(word, result.text)

    def changed(self, change):
        """A copy of the checkpoint, changed."""
        shutil.copy(self.path("early.checkpoint.h5"), self.path("changed.h5"))
        with h5py.File(self.path("changed.h5"), "r+") as file:
            change(file)

    def check_tables(self, deck, tables, ranks=1):
        """early.checkpoint.h5 with each of these tables changed is refused."""
        for name, make, word in tables:
            def change(file):
                values = np.array(file[name])
                del file[name]
                file[name] = make(values)
            self.changed(change)
            with self.subTest(name, word=word, ranks=ranks):
                self.refused(deck, word, checkpoint="changed.h5", ranks=ranks)
