#!/usr/bin/python3
"""studies.png and a table: K of a crack of 0.5 W against processor time, over horizon, spacings a horizon,
micromodulus and surface correction; life of a crack that grows by 4 mm over cycles a block, over the tolerance that
lumps failures, and over that of equilibria. studies.py PDRUN FOLDER makes some thirty small runs in FOLDER: two minutes
of processor time."""
import csv
import os
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
here = Path(__file__).resolve().parent
sys.path.insert(0, str(here.parents[1] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402

WIDTH, THICKNESS, LOAD, HALF, YOUNG = 0.04, 0.0032, 1750.0, 0.02, 211e9  # m, m, N, m, Pa: W, B, load, crack, E
PDRUN, FOLDER = sys.argv[1], Path(sys.argv[2])
TIRES = "{Damage Model: Remaining Life, Growth Coefficient: 1.0, Growth Exponent: 3.0}"  # nothing, in one cycle
CONICAL = "max(1 - zeta/horizon, 0)"
STANDARD = LOAD / (THICKNESS * WIDTH**0.5) * 2.5 / 0.5**1.5 * (0.886 + 2.32 - 3.33 + 1.84 - 0.35)  # ASTM E647, a = W/2


def effective_modulus(points, is_conical):
    """E' of G = K^2/E' (Pa) of squares with so many spacings a horizon, E along the axes (Sih, Paris & Irwin 1965)."""
    x, y = (n.ravel() for n in np.meshgrid(np.arange(-points, points + 1), np.arange(-points, points + 1)))
    x, y = x[(x != 0) | (y != 0)], y[(x != 0) | (y != 0)]
    length = np.hypot(x, y)
    influence = np.maximum(1 - length / points, 0) if is_conical else 1
    stiffness = length * np.clip(points + 0.5 - length, 0, 1) * influence
    c11, c12 = np.sum(stiffness * x**4 / length**4), np.sum(stiffness * x**2 * y**2 / length**4)
    a11, a12 = c11 / (c11**2 - c12**2), -c12 / (c11**2 - c12**2)
    return YOUNG / np.sqrt(0.5 * (1 + (2 * a12 + 1 / c12) / (2 * a11)))


def run(name, horizon, points, settings):
    """History (columns as lists) and processor time (s). `horizon` in mm, `points`: a horizon."""
    spacing, mesh = horizon / points, FOLDER / f"study_{horizon}_{points}.txt"
    if not mesh.exists():
        subprocess.run([here / "specimen.py", str(spacing), mesh], check=True)
    of_horizon = {"Blocks/Body/Horizon": 1, "Compute Class Parameters/J/Inner Radius": 2,
                  "Compute Class Parameters/J/Outer Radius": 3.1}
    if "Damage Models/Fatigue" not in settings:
        of_horizon.update({"Damage Models/Fatigue/Horizon": 1, "Damage Models/Fatigue/Spacing": 1 / points})
    for integral, behind, above in (("J Of Bonds", 2, 2), ("J Of Bonds Further Out", 3, 4.5)):
        for side, part in (("Ahead", 2), ("Behind", behind), ("Above", above)):
            of_horizon[f"Compute Class Parameters/{integral}/{side}"] = part
    options = {"Discretization/Input Mesh File": mesh.resolve(), "Output/Output Filename": name,
               **{key: f"{part * horizon} mm" for key, part in of_horizon.items()}, **settings}
    command = [PDRUN, here / "compact_tension.yaml", "--quiet"]
    for key, value in options.items():
        command += ["--set", f"{key}={value}"]
    before = os.times()
    subprocess.run(command, cwd=FOLDER, check=True)
    seconds = os.times().children_user - before.children_user
    with open(FOLDER / f"{name}.csv") as file:
        rows = list(csv.DictReader(file))
    return {key: [float(row[key]) for row in rows] for key in rows[0]}, seconds


def intensity(axis):
    """K by J of the bonds over the rectangle, on lattices that W, height and crack are multiples of."""
    still = {"Solver/Final Time": 1.0, "Damage Models/Fatigue": TIRES,
             "Discretization/Bond Filters/Notch/Bottom_Length": 1.0 + HALF}
    conical = {**still, "Discretization/Influence Function": CONICAL}
    correction = "Materials/Steel/Surface Correction"
    series = {
        "3 spacings a horizon, energy method": (3, still, (3.0, 1.5, 0.75)),
        "4 spacings, energy method": (4, still, (4.0, 2.0, 1.0)),
        "5 spacings, energy method": (5, still, (2.5, 1.25)),
        "3 spacings, conical micromodulus, energy method": (3, conical, (3.0, 1.5, 0.75)),
        "3 spacings, volume method": (3, {**still, correction: "Volume Method"}, (3.0, 1.5, 0.75)),
        "3 spacings, no surface correction": (3, {**still, correction: "None"}, (3.0, 1.5, 0.75)),
    }
    print(f"K of a crack of W/2 over the standard's, {STANDARD * 1e-6:.3f} MPa m^0.5: horizon in mm, K, processor time")
    for number, (name, (points, settings, horizons)) in enumerate(series.items()):
        errors, times = [], []
        for horizon in horizons:
            history, seconds = run(f"study_k_{number}_{horizon}", horizon, points, settings)
            modulus = effective_modulus(points, "Influence" in str(settings))
            ratio = (history["J_Of_Bonds"][-1] * modulus)**0.5 / STANDARD
            print(f"  {name}: {horizon} mm {ratio:.4f}, {seconds:.2f} s")
            errors.append(abs(ratio - 1.0))
            times.append(seconds)
        axis.loglog(times, errors, "o-", label=name)
    axis.set_xlabel("processor time (s)")
    axis.set_ylabel("error of K at a = W/2")


def life(axis):
    """Cycles from the cut on to 16 mm, M = 3, horizon 2.25 mm, against a run by single failures."""
    until = {"Solver/Fatigue/Stop When/Reaches": 0.016}

    def grown(name, settings):
        history, seconds = run(name, 2.25, 3, {**until, **settings})
        return history["time"][-1], len(history["time"]) - 1, seconds

    lump, tolerance = "Damage Models/Fatigue/Life Tolerance", "Solver/Fatigue/Relative Tolerance"
    exact, number, seconds = grown("study_exact", {lump: 1e-9, tolerance: 1e-10})
    print(f"cycles to 16 mm by single failures, equilibria to 1e-10: {exact:.6g}, {number} equilibria, {seconds:.2f} s")
    series = {
        "cycles a block, over the life": ("Solver/Fatigue/Cycles Per Block", [exact * part for part in
                                                                               (0.1, 0.03, 0.01, 0.003, 0.001)], exact),
        "tolerance of lives": (lump, [0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-6], 1.0),
        "tolerance of equilibria": (tolerance, [5e-3, 1e-3, 1e-4, 1e-6], 1.0),
    }
    for index, (name, (key, values, unit)) in enumerate(series.items()):
        errors, counts = [], []
        for value in values:
            settings = {key: value, **({"Solver/Final Time": 4 * exact} if "Block" in key else {})}
            cycles, number, seconds = grown(f"study_n_{index}_{value / unit:.4g}", settings)
            error = cycles / exact - 1.0
            print(f"  {name} {value / unit:.3g}: cycles {error:+.2e}, {number} equilibria, {seconds:.2f} s")
            errors.append(max(abs(error), 1e-9))
            counts.append(number)
        axis.loglog([value / unit for value in values], errors, "o-", label=name)
    axis.set_xlabel("cycles a block over the life; tolerance")
    axis.set_ylabel("error of the life to 16 mm")


figure, axes = figures.plt.subplots(1, 2, figsize=(11, 4.2), constrained_layout=True)
intensity(axes[0])
life(axes[1])
axes[0].set_ylim(bottom=1e-4)  # room for the legend
for panel in axes:
    panel.grid(alpha=0.3, which="both")
    panel.legend(fontsize=7)
figure.savefig(FOLDER / "studies.png", dpi=120)
print(FOLDER / "studies.png")
