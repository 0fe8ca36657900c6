"""Runs of pdrun on meshes and decks that a test makes: what the verification and stability tests stand on."""
import copy
import csv
import json
import os
import shutil
import subprocess
import tempfile
import unittest
import weakref

import h5py
import numpy as np


def pdrun_path():
    """The program under test: the environment variable PDRUN, which ctest sets."""
    path = os.environ.get("PDRUN")
    if not path:
        raise unittest.SkipTest("set PDRUN to the pdrun to test")
    return path


def mpirun(ranks):
    """What a command on so many ranks begins with."""
    if ranks == 1:
        return []
    return ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)]


def lattice(lengths, spacing, origin=None):
    """Centres of the cells of a box, x fastest: [n, 3]. `lengths`: 1 to 3 of them; the other coordinates are 0."""
    axes = []
    for d in range(3):
        n = int(round(lengths[d] / spacing)) if d < len(lengths) else 1
        start = 0.0 if origin is None or d >= len(lengths) else origin[d]
        axes.append(start + spacing * (np.arange(n) + 0.5) if d < len(lengths) else np.zeros(1))
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    return np.column_stack([x.ravel(), y.ravel(), z.ravel()])


def yaml(value, indent=0):
    """A deck as text, from dictionaries, lists and values."""
    pad = "  " * indent
    if isinstance(value, dict):
        lines = []
        for key, entry in value.items():
            if isinstance(entry, dict) and entry:
                lines.append(f"{pad}{key}:\n{yaml(entry, indent + 1)}")
            else:
                lines.append(f"{pad}{key}: {yaml(entry)}")
        return "\n".join(lines)
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(yaml(entry) for entry in value) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (float, np.floating)):
        text = repr(float(value))
        return text if "." in text or "n" in text else text.replace("e", ".0e")
    if isinstance(value, str):
        return json.dumps(value)
    return str(value)


class Result:
    """What a run wrote, also after another of the same name has taken its place. Fields are in the order of the mesh
    file."""

    def __init__(self, folder, name, process):
        self.folder, self.name, self.process = folder, name, process
        self.text = process.stdout + process.stderr
        self.code = process.returncode

    def keep(self):
        """Copies what the run wrote to a folder of its own."""
        folder = tempfile.mkdtemp(prefix="pd_kept_")
        weakref.finalize(self, shutil.rmtree, folder)
        for ending in (".h5", ".steps", ".csv", ".report.json"):
            path = os.path.join(self.folder, self.name + ending)
            if os.path.exists(path):
                (shutil.copytree if os.path.isdir(path) else shutil.copy)(path, os.path.join(folder, self.name + ending))
        self.folder = folder

    def _open(self):
        return h5py.File(os.path.join(self.folder, self.name + ".h5"), "r")

    def steps(self):
        with self._open() as file:
            return [int(key) for key in file["steps"]]

    def field(self, label, step=None):
        with self._open() as file:
            keys = sorted(file["steps"])
            key = keys[-1] if step is None else f"{step:06d}"
            return np.array(file["steps"][key][label])

    @property
    def report(self):
        with open(os.path.join(self.folder, self.name + ".report.json")) as file:
            return json.load(file)

    def error(self, norm):
        """The error norm of the report whose name contains `norm`."""
        norms = self.report["error_norms"]
        found = [value for name, value in norms.items() if norm in name]
        if len(found) != 1:
            raise AssertionError(f"no single error norm {norm!r} in {norms}")
        return found[0]

    def history(self):
        """Columns of the CSV file by name, as arrays."""
        with open(os.path.join(self.folder, self.name + ".csv")) as file:
            rows = list(csv.DictReader(file))
        return {key: np.array([float(row[key]) for row in rows]) for key in rows[0]}


class SceneTest(unittest.TestCase):
    """A test case with a folder of its own and the means to run decks in it."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="pd_scene_")
        self.addCleanup(shutil.rmtree, self.folder)
        self._results = weakref.WeakSet()

    def path(self, name):
        return os.path.join(self.folder, name)

    def write_mesh(self, points, volume, block=1, name="mesh.txt"):
        volume = np.broadcast_to(np.asarray(volume, float), len(points))
        block = np.broadcast_to(np.asarray(block), len(points))
        with open(self.path(name), "w") as file:
            for p, b, v in zip(points, block, volume):
                file.write(f"{p[0]:.17g} {p[1]:.17g} {p[2]:.17g} {b} {v:.17g}\n")

    def prepare(self, deck, name="deck", ranks=1, arguments=()):
        """Writes the deck; the command that runs it in the folder."""
        with open(self.path(name + ".yaml"), "w") as file:
            file.write(yaml(deck) + "\n")
        command = [pdrun_path(), name + ".yaml", "--quiet", *arguments]
        return [*mpirun(ranks), *command]

    def run_deck(self, deck, timeout=280, **options):
        """Writes the deck and runs it, with the options of prepare(); does not ask how it ended."""
        name = deck.get("Output", {}).get("Output Filename", "dump")
        for earlier in [result for result in self._results if result.name == name and result.folder == self.folder]:
            earlier.keep()  # the test may look at it once more
        command = self.prepare(deck, **options)
        process = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=timeout)
        result = Result(self.folder, name, process)
        self._results.add(result)
        return result

    def solve(self, deck, **options):
        """As run_deck, but the run must succeed."""
        result = self.run_deck(deck, **options)
        self.assertEqual(result.code, 0, result.text)
        return result


class CheckedDeck(SceneTest):
    """What `pdrun --check` says of changes to a good deck, `DECK`, whose mesh setUp() writes."""

    def check(self, change):
        deck = copy.deepcopy(self.DECK)
        change(deck)
        return self.run_deck(deck, arguments=["--check"])

    def assert_refused(self, change, *messages):
        result = self.check(change)
        self.assertEqual(result.code, 2, result.text)
        for message in messages:
            self.assertIn(message, result.text)


def plate_deck(horizon, thickness, material=None, damage=None, conditions=None, solver=None, output=None, **more):
    """A plane-stress deck of one block with material PDHE; `damage`: parameters of a damage model."""
    deck = {
        "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt", "Thickness": thickness},
        "Materials": {"Steel": {"Material Model": "PDHE", "Plane Stress": True, "Thickness": thickness,
                                **(material or {})}},
        "Blocks": {"Body": {"Block Names": "block_1", "Material": "Steel", "Horizon": horizon}},
        "Boundary Conditions": conditions or {},
        "Solver": {"Final Time": 1.0, **(solver or {})},
        "Output": {"Output Filename": "result", "Output Frequency": 1, **(output or {})},
    }
    if damage:
        deck["Damage Models"] = {"Breakage": damage}
        deck["Blocks"]["Body"]["Damage Model"] = "Breakage"
    for section, content in more.items():
        deck[section.replace("_", " ")] = content
    return deck
