#!/usr/bin/python3
"""What exactness of a flow costs in a channel, a cavity and round a wire: tables, and cost_SCENE.png, of errors over
processor time; cost.py PDRUN RESULTS [SCENE ...]"""
import json
import resource
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
DECKS = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(DECKS.parent / "meshes"), str(DECKS / "cavity")]

import numpy as np  # noqa: E402
from matplotlib.ticker import LogLocator, NullFormatter  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import read_history  # noqa: E402
from plot import extreme_errors  # noqa: E402

PDRUN, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
FLUIDS = {"poiseuille": "Water", "cavity": "Fluid", "mg_pin": "Fluid"}  # their materials
BLOCKS = {"poiseuille": ["Water"], "cavity": ["Fluid"], "mg_pin": ["Channel", "Walls"]}
FLOWS = {"poiseuille": "Solver/Steady Flow", "cavity": "Solver/Steady Flow",
         "mg_pin": "Solver/Staggered/Solvers/Flow/Steady Flow"}

# Series: label, points, what differs. m: spacings a horizon (that of gradients stays 1.5); c: Pressure Smoothing.
SERIES = {
    "poiseuille": [("cut bonds", (10, 20, 40), {}),
                   ("cut bonds, Transverse", (10, 20, 40), {"kernel": "Transverse"}),
                   ("reflected points, m = 3", (10, 20, 40), {"walls": "Reflected Points"}),
                   ("reflected points, m = 4", (10, 20, 40), {"walls": "Reflected Points", "m": 4}),
                   ("reflected points, m = 5", (10, 20, 40), {"walls": "Reflected Points", "m": 5}),
                   ("without Surface", (10, 20, 40), {"staircase": True})],
    "cavity": [("m = 3, c = 0.05", (24, 48, 96), {}),
               ("m = 4", (24, 48), {"m": 4}),
               ("m = 5", (24, 48), {"m": 5}),
               ("c = 0.005", (24, 48), {"c": 0.005}),
               ("c = 0.5", (24, 48), {"c": 0.5}),
               ("reflected points", (24, 48, 96), {"walls": "Reflected Points"})],
    "mg_pin": [("m = 3, c = 0.05, steps of 300 s", (8, 12), {}),
               ("steps of 900 s", (8, 12), {"step": 900.0}),
               ("steps of 100 s", (8,), {"step": 100.0}),
               ("m = 4", (8,), {"m": 4}),
               ("c = 0.5", (8,), {"c": 0.5})]}


def lattice(name, spacing, cells, origin, *more):
    path = FOLDER / f"{name}.txt"
    sizes = [repr(count * spacing) for count in cells]
    subprocess.run([DECKS.parent / "meshes/pdmesh", "grid", "box", "--quiet", "--spacing", repr(spacing), "--size", *sizes,
                    "--origin", *[repr(place * spacing) for place in origin], *more, "-o", path], check=True)
    return path


def mesh_of(scene, points):
    """(path, spacing)"""
    name = f"{scene}_{points}"
    if scene == "poiseuille":
        return lattice(name, 1e-3 / points, (2 * points + 13, points + 13), (-6.37, -6.81)), 1e-3 / points
    if scene == "cavity":
        return lattice(name, 1 / points, (points + 12, points + 12), (-6, -6)), 1 / points
    spacing = {8: 85e-6 / 8, 12: 85e-6 / 12, 17: 85e-6 / 17}[points]  # points a diameter of the wire, about
    before, rows = int(np.ceil(250e-6 / spacing)) + 4, round(425e-6 / spacing) + 4
    return lattice(name, spacing, (int(np.ceil(450e-6 / spacing)) + 4 + before, rows), (-0.3 - before, 0),
                   "--block", "2: abs(y) > 425e-6"), spacing


def overrides(scene, points, kernel="Laplacian", walls="Cut Bonds", m=3, c=0.05, staircase=False, step=None):
    path, spacing = mesh_of(scene, points)
    fluid = f"Materials/{FLUIDS[scene]}"
    values = {"Discretization/Input Mesh File": path, f"{fluid}/Gradient Horizon": 1.5075 * spacing,
              f"{fluid}/Viscous Kernel": kernel, f"{fluid}/Walls": walls, f"{FLOWS[scene]}/Pressure Smoothing": c,
              **{f"Blocks/{block}/Horizon": (m + 0.015) * spacing for block in BLOCKS[scene]}}
    if scene == "poiseuille":
        values |= {f"Compute Class Parameters/{end}/Width": 2 * spacing for end in ("In", "Out")}
    if staircase:
        values["Boundary Conditions/Walls"] = "{Type: Prescribed Velocity, Node Set: Walls Node Set}"
    if scene == "mg_pin":
        values["Materials/Fluid/Flux Horizon"] = 1.2 * spacing
    if step is not None:
        values["Solver/Staggered/Solvers/Dissolution/Corrosion/Maximum dt"] = step
    return values


def run(scene, name, values):
    """Processor time, s."""
    deck = DECKS / scene / ("channel.yaml" if scene == "poiseuille" else f"{scene}.yaml")
    command = [PDRUN, deck, "--quiet", "--set", f"Output/Output Filename={name}"]
    for path, value in values.items():
        command += ["--set", f"{path}={value}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, cwd=FOLDER, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def error_of(scene, name, points):
    """Of the velocity (L2) in the channel; the worst of the extremes of the cavity; of the loss of the wire, in parts of
    the wire, at any time."""
    if scene == "poiseuille":
        return json.loads((FOLDER / f"{name}.report.json").read_text())["error_norms"]["along relative L2 error"]
    if scene == "cavity":
        return max(abs(error) for error in extreme_errors(FOLDER / name, points).values())
    history = read_history(FOLDER / f"{name}.csv")
    share = history["Relative_Volume_Loss"] / 100
    radius = np.sqrt(2 * history["Volume_Loss"][-1] / share[-1] / np.pi)  # half of it is modelled
    t = history["time"]
    gone = 5.73 / (2 * 96485.33212 * 71508.0) * (t - 4340 * (1 - np.exp(-t / 4340)))
    return np.max(np.abs(share - 1 + (1 - gone / radius)**2))


def measure(scene):
    """Of each series the processor times and errors."""
    found = []
    for k, (label, points, changes) in enumerate(SERIES[scene]):
        found.append([])
        for n in points:
            name = f"{scene}_{k}_{n}"
            seconds = run(scene, name, overrides(scene, n, **changes))
            found[-1].append((seconds, error_of(scene, name, n)))
        print(f"| {label} | " + " | ".join(f"{error:.2e}, {seconds:.2g} s" for seconds, error in found[-1]) + " |", flush=True)
    return found


def draw(scene, found):
    figure, axis = figures.plt.subplots(figsize=(6, 4), constrained_layout=True)
    for (label, points, _), costs in zip(SERIES[scene], found):
        axis.loglog(*zip(*costs), "o-", markersize=4, label=f"{label}: {', '.join(map(str, points))}")
    axis.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.xaxis.set_major_formatter("{x:g}")
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.set_xlabel("processor time (s)")
    axis.set_ylabel({"poiseuille": "error of the velocity (L2)", "cavity": "worst error of the extremes",
                     "mg_pin": "error of the loss"}[scene])
    axis.legend(fontsize=7, title="points", title_fontsize=7)
    figure.savefig(FOLDER / f"cost_{scene}.png", dpi=110)
    print(FOLDER / f"cost_{scene}.png")


if __name__ == "__main__":
    for chosen in sys.argv[3:] or SERIES:
        draw(chosen, measure(chosen))
