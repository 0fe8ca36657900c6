"""A block that public codes can run too: 46^3 points on a simple cubic lattice, horizon 3.015 spacings, pulled apart by
its initial velocity for 100 Verlet steps, in decks that Peridigm and pdrun read."""
import os
import sys
import time
from pathlib import Path
from subprocess import run

import h5py
import numpy as np

import scenes

for folder in ("peridigm", "support"):
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / folder))
from exodus import ExodusResult  # noqa: E402
from scene import yaml  # noqa: E402

HORIZON = 3.015
STEPS = 100
_DENSITY, _YOUNG, _BULK, _SHEAR = 7800.0, 200e9, 133.3e9, 80e9
_TIME_STEP = 1e-7  # about 0.6 of the critical one
_MATERIALS = {
    "bond_based": {"Material Model": "Elastic Bond Based", "Density": _DENSITY, "Young's Modulus": _YOUNG,
                   "Plane Strain": False, "Plane Stress": False},
    "elastic": {"Material Model": "Elastic", "Density": _DENSITY, "Bulk Modulus": _BULK, "Shear Modulus": _SHEAR}}

# Name: material, critical stretch. The block is strained by 0.0013 a step: with 0.004 two thirds of its bonds break,
# with 1 all are tested and none breaks.
CASES = {"bond_based": ("bond_based", 0.004), "bond_based_unbroken": ("bond_based", 1.0),
         "bond_based_plain": ("bond_based", None), "elastic": ("elastic", None),
         "elastic_breaking": ("elastic", 0.004)}


class Block:
    """The block of `n` points along each edge, in `folder`."""

    def __init__(self, folder, n):
        self.folder, self.n = folder, n
        scenes.write_lattice(folder / "block.txt", (n, n, n))
        (folder / "all.txt").write_text("".join(f"{i + 1}\n" for i in range(n**3)))
        across = range(-3, 4)
        offsets = [(a, b, c) for a in across for b in across for c in across if 0 < a * a + b * b + c * c < HORIZON**2]
        self.bonds = sum((n - abs(a)) * (n - abs(b)) * (n - abs(c)) for a, b, c in offsets)

    def _deck(self, name, steps):
        material, stretch = CASES[name]
        half = 0.5 * self.n * scenes.SPACING
        damage = {} if stretch is None else {"Damage Model": "Breakage"}
        deck = {
            "Discretization": {"Type": "Text File", "Input Mesh File": "block.txt"},
            "Materials": {"Steel": _MATERIALS[material]},
            "Blocks": {"Block": {"Block Names": "block_1", "Material": "Steel", "Horizon": HORIZON * scenes.SPACING,
                                 **damage}},
            "Boundary Conditions": {
                "All Node Set": "all.txt",
                "Pull": {"Type": "Initial Velocity", "Node Set": "All Node Set", "Coordinate": "x",
                         "Value": f"300.0*(x/{half!r} - 1.0)"}},
            "Solver": {"Verbose": False, "Initial Time": 0.0, "Final Time": (steps + 0.5) * _TIME_STEP,
                       "Verlet": {"Fixed dt": _TIME_STEP}},
            "Output": {"Output File Type": "ExodusII", "Output Filename": "run", "Output Frequency": steps,
                       "Output Variables": {"Displacement": True}}}
        if stretch is not None:
            deck["Damage Models"] = {"Breakage": {"Damage Model": "Critical Stretch", "Critical Stretch": stretch}}
        return yaml({"Peridigm": deck}) + "\n"

    def _seconds(self, program, name, steps, ranks):
        for old in self.folder.glob("run.*"):
            if old.is_file():
                old.unlink()
        (self.folder / "deck.yaml").write_text(self._deck(name, steps))
        command = scenes.mpi(ranks) + [str(program), "deck.yaml"]
        start = time.perf_counter()
        process = run(command, cwd=self.folder, capture_output=True, text=True, check=False)
        if process.returncode != 0:
            raise RuntimeError(f"{' '.join(command)} ended with code {process.returncode}:\n"
                               f"{process.stdout[-2000:]}{process.stderr[-2000:]}")
        return time.perf_counter() - start

    def rates(self, programs, name, rank_counts=(1,), repetitions=2):
        """{(program, ranks): directed bond-updates/s}, of the steps beyond the first: the start of a program, its
        set-up and the writing of results are in the time of one step as in that of all. Programs run in turn; the best
        of `repetitions` counts."""
        best = {}
        for _ in range(repetitions):
            for program in programs:
                for ranks in rank_counts:
                    for steps in (1, 1 + STEPS):
                        key = program, ranks, steps
                        best[key] = min(best.get(key, np.inf), self._seconds(program, name, steps, ranks))
        return {(program, ranks): STEPS * self.bonds / (best[program, ranks, 1 + STEPS] - best[program, ranks, 1])
                for program in programs for ranks in rank_counts}

    def difference(self, pdrun, peridigm, name):
        """Of the displacements after all steps, in their largest."""
        self._seconds(peridigm, name, 1 + STEPS, 1)
        theirs = ExodusResult(str(self.folder / "run")).field("Displacement")
        self._seconds(pdrun, name, 1 + STEPS, 1)
        with h5py.File(self.folder / "run.h5", "r") as file:
            ours = np.array(file["steps"][max(file["steps"])]["Displacement"])
        return np.abs(ours - theirs).max() / np.abs(theirs).max()


def peridigm_executable():
    """A Peridigm to be measured beside; None where the environment names none."""
    return os.environ.get("PERIDIGM_EXECUTABLE")
