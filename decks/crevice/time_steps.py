#!/usr/bin/python3
"""The trench with fixed time steps from 0.5 to 500 s, in a crevice of a quarter of the length, or in the whole one.

The short crevice is 3.2 mm long, its gap 20 to 10 um wide; all else is as in crevice.yaml. Attack runs to its mouth
within 1.2 hours and carves a trench of 19 um in 6. Fixed steps are of backward Euler, as those of the scene's source.
Steps in which the front would move more than twice `Front Limit` (here four spacings) are divided; a step of 500 s
takes 0.8 spacings of metal under saturated electrolyte.

Sample runs:
  time_steps.py build/pdrun                              half a minute
  time_steps.py build/pdrun --whole --steps 5 50 500    72 h of the scene, a quarter of an hour
"""
import argparse
import re
import resource
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent

import numpy as np  # noqa: E402
from crevice_run import DY, Run  # noqa: E402
from gap_averaged import HOUR, Crevice  # noqa: E402

STEPS = (0.5, 5.0, 50.0, 500.0)


@dataclass
class Case:
    crevice: Crevice
    metal: float  # m, above the mouth's half gap
    hours: int
    dx: float = 25e-6

    @property
    def horizon(self):
        """Along x, m; of the electrolyte before the mouth, where C = 0 is held, as well."""
        return 4.0 * self.dx

    def make_mesh(self, path):
        half = 0.5 * self.crevice.mouthGap
        subprocess.run([sys.executable, HERE.parents[1] / "meshes" / "pdmesh", "grid", "box", "--quiet", "-o", path,
                        "--size", repr(self.crevice.length + self.horizon), repr(half + self.metal),
                        "--spacing", repr(self.dx), repr(DY), "--origin", f"{-self.horizon:.9f}", "0",
                        "--remove", f"x < 0 and y > {half!r}"], check=True)

    def settings(self):
        """What differs from crevice.yaml."""
        c = self.crevice
        wall = f"{0.5 * c.mouthGap!r} - {0.5 * (c.mouthGap - c.endGap)!r}*x/{c.length!r}"
        sets = "Boundary Conditions/{} Node Set/Expression"
        return {sets.format("Metal"): f"x > 0 && y > {wall}",
                sets.format("Start"): f"x > {c.length - c.ignition!r} && y < {wall}",
                sets.format("Mouth"): f"x < {self.dx!r} && y < {0.5 * c.mouthGap!r}",
                "Blocks/Body/Horizon": self.horizon,
                "Materials/Alloy 625/Horizon Axes": f"[{self.horizon!r}, {4.0 * DY!r}]",
                "Solver/Final Time": self.hours * HOUR, "Solver/Corrosion/Load Steps": self.hours}


SHORT = Case(Crevice(length=3.2e-3, mouthGap=20e-6, endGap=10e-6), 35e-6, 6)
WHOLE = Case(Crevice(), 400e-6, 72)


@dataclass
class Trench:
    depth: float  # m, the largest of a column of points
    place: float  # of that column, m from the mouth
    lost: float  # metal, m2
    steps: int
    longest: float  # s
    seconds: float  # of processor time


def depths(folder):
    """m, of the columns from the mouth on, at the end of the run called `run`."""
    return Run(folder / "run").depth(-1)


def fixed(step):
    """Settings of steps of this length (s), as the source of the scene takes them."""
    return {"Solver/Corrosion/Fixed dt": float(step), "Solver/Corrosion/Method": "Backward Euler"}


def run(pdrun, case, folder, step=None):
    """The trench at the end, with fixed steps of backward Euler or the deck's adaptive ones; the mesh is in `folder`."""
    settings = {**case.settings(), "Output/Output Filename": "run"}
    if step is not None:
        settings.update(fixed(step))
    command = [pdrun, "crevice.yaml"]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    text = subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    count, longest = re.search(r"Corrosion: (\d+) steps of \S+ to (\S+) s", text).groups()
    depth = depths(folder)
    deepest = int(np.argmax(depth))
    place = (deepest + 0.5) * case.dx
    return Trench(depth[deepest], place, depth.sum() * case.dx, int(count), float(longest), seconds)


def prepare(case, folder):
    (folder / "crevice.yaml").write_text((HERE / "crevice.yaml").read_text())
    case.make_mesh(folder / "crevice.txt")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pdrun", type=lambda name: str(Path(name).resolve()))
    parser.add_argument("--whole", action="store_true", help="the scene itself, 72 h")
    parser.add_argument("--steps", type=float, nargs="+", default=STEPS, help="s; the first is the reference")
    given = parser.parse_args()
    case = WHOLE if given.whole else SHORT
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        prepare(case, folder)
        reference = None
        print("| step (s) | taken | longest (s) | depth (µm) | off by | place (mm) | metal lost, off by | processor |")
        for step in (*given.steps, None):
            found = run(given.pdrun, case, folder, step)
            reference = reference or found
            print(f"| {step or 'adaptive'} | {found.steps} | {found.longest:g} | {found.depth * 1e6:.3f} "
                  f"| {100 * (found.depth / reference.depth - 1):+.2f} % | {found.place * 1e3:.4f} "
                  f"| {100 * (found.lost / reference.lost - 1):+.2f} % | {found.seconds:.1f} s |", flush=True)


if __name__ == "__main__":
    main()
