"""Lattices and decks of the benchmark's own runs, in SI units."""
import json
import os
import subprocess

import numpy as np

SPACING = 1e-3
_CRITICAL_STRETCH = 0.01


def write_lattice(path, counts, jitter=0.0):
    """A text discretization of the centres of counts[0] x counts[1] x counts[2] cells; one layer is a plane at z = 0.
    Places are moved by up to `jitter` spacings, in the plane."""
    axes = [SPACING * (np.arange(n) + 0.5) for n in counts]
    if counts[2] == 1:
        axes[2][:] = 0.0
    z, y, x = (axis.ravel() for axis in np.meshgrid(axes[2], axes[1], axes[0], indexing="ij"))
    ones = np.ones(len(x))
    if jitter > 0.0:
        x, y = (axis + SPACING * jitter * np.random.default_rng(1).uniform(-1.0, 1.0, len(x)) for axis in (x, y))
    np.savetxt(path, np.column_stack([x, y, z, ones, SPACING**3 * ones]), fmt=["%.10g"] * 3 + ["%d", "%.10g"])


def deck(is_plane, solver, final_time, horizon, extra_material=None, damage=None, conditions=None, filters=None):
    """A deck of one block of steel on the lattice lattice.txt; `horizon` in spacings."""
    plane = {"Thickness": SPACING} if is_plane else {}
    # The Poisson's ratios at which every tangential stiffness is positive: below 1/3 in plane stress, 1/4 in 3D.
    material = {"Material Model": "PDHE", "Density": 7850.0, "Young's Modulus": 207.0e9,
                "Poisson's Ratio": 0.29 if is_plane else 0.2, "Plane Stress": is_plane, **plane, **(extra_material or {})}
    result = {
        "Discretization": {"Type": "Text File", "Input Mesh File": "lattice.txt", **plane,
                           "Bond Filters": filters or {}},
        "Materials": {"Steel": material},
        "Blocks": {"Body": {"Block Names": "block_1", "Material": "Steel", "Horizon": horizon * SPACING}},
        "Boundary Conditions": conditions or {},
        "Solver": {"Final Time": final_time, **solver},
        "Output": {"Output Filename": "run", "Output Variables": ["Volume"], "Output Frequency": -1,
                   "History Frequency": -1},
    }
    if damage:
        result["Damage Models"] = {"Breakage": damage}
        result["Blocks"]["Body"]["Damage Model"] = "Breakage"
    return result


def breaking_body(counts, steps):
    """A notched body that flies apart: stretched close to the limit at rest, so that the crack runs at once."""
    is_plane = counts[2] == 1
    height, width = SPACING * counts[1], SPACING * counts[0]
    # A tenth of the time a wave needs through the spacing is well below the critical step of either dimension.
    time_step = 0.1 * SPACING / np.sqrt(207.0e9 / 7850.0)
    notch = {"Notch": {"Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0,
                       "Lower_Left_Corner_X": -1.0, "Lower_Left_Corner_Y": SPACING * (counts[1] // 2),
                       "Lower_Left_Corner_Z": -1.0, "Bottom_Unit_Vector_X": 1.0, "Bottom_Unit_Vector_Y": 0.0,
                       "Bottom_Unit_Vector_Z": 0.0, "Bottom_Length": 1.0 + 0.3 * width, "Side_Length": 2.0}}
    conditions = {"Everything Node Set": {"Expression": "x > -1"},
                  "Stretched": {"Type": "Initial Displacement", "Node Set": "Everything Node Set", "Coordinate": "y",
                                "Value": f"{0.9 * _CRITICAL_STRETCH!r}*(y - {0.5 * height!r})"}}
    return deck(is_plane, {"Verlet": {"Fixed dt": float(time_step)}}, float(steps * time_step), 3.015,
                damage={"Damage Model": "Critical Stretch", "Critical Stretch": _CRITICAL_STRETCH},
                conditions=conditions, filters=notch)


def crack_opening(counts):
    """For opened_plate(): the crack grows by a few spacings, in some thirty equilibria of a plate of 104 x 104 points."""
    return 0.005 * counts[0]


def opened_plate(counts, opening):
    """A plate with a notch from its left edge, whose mouth is opened by `opening` spacings in one load step: bonds break
    in front of the notch, equilibrium by equilibrium, until the crack is so long that it stops."""
    height, width = SPACING * counts[1], SPACING * counts[0]
    middle = SPACING * (counts[1] // 2)
    notch = {"Notch": {"Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0,
                       "Lower_Left_Corner_X": -1.0, "Lower_Left_Corner_Y": middle,
                       "Lower_Left_Corner_Z": -1.0, "Bottom_Unit_Vector_X": 1.0, "Bottom_Unit_Vector_Y": 0.0,
                       "Bottom_Unit_Vector_Z": 0.0, "Bottom_Length": 1.0 + 0.3 * width, "Side_Length": 2.0}}
    left = f"x < {6.0 * SPACING!r}"
    conditions = {"Upper Node Set": {"Expression": f"{left} && y > {middle!r}"},
                  "Lower Node Set": {"Expression": f"{left} && y < {middle!r}"},
                  "Right Node Set": {"Expression": f"x > {width - 4.0 * SPACING!r}"},
                  "Mouth Node Set": {"Expression": left}}
    for name, nodes, axis, value in (("Up", "Upper", "y", opening), ("Down", "Lower", "y", -opening),
                                     ("Still", "Right", "x", 0.0), ("Level", "Right", "y", 0.0)):
        conditions[name] = {"Type": "Prescribed Displacement", "Node Set": nodes + " Node Set", "Coordinate": axis,
                            "Value": f"{0.5 * SPACING * value!r}*t"}
    # The mouth and its grips hold together.
    conditions["Whole"] = {"Type": "No Failure", "Node Set": "Mouth Node Set"}
    solver = {"QuasiStatic": {"Kinematics": "Small Strain", "Relative Tolerance": 1e-5, "Load Steps": 1}}
    return deck(True, solver, 1.0, 4.015, damage={"Damage Model": "Critical Stretch", "Critical Stretch": _CRITICAL_STRETCH},
                conditions=conditions, filters=notch)


def tiring_plate(counts, n_bonds):
    """The plate of opened_plate() under cycles of load: bonds tire in front of the notch, one event after another, until
    `n_bonds` are broken, those of the notch among them. Opened so little that none breaks at once."""
    result = opened_plate(counts, 0.2)
    # A life of some ten thousand cycles at the strains of a tip. It is the order of failures that counts here.
    result["Damage Models"]["Breakage"] = {"Damage Model": "Remaining Life", "Growth Coefficient": 1e4,
                                           "Growth Exponent": 2.0, "Critical Stretch": 1.0}
    result["Boundary Conditions"]["Up"]["Value"] = f"{0.1 * SPACING!r}"
    result["Boundary Conditions"]["Down"]["Value"] = f"{-0.1 * SPACING!r}"
    result["Discretization"]["Bond Filters"]["Notch"]["Count In Damage"] = True
    result["Solver"] = {"Final Time": 1e12,
                        "Fatigue": {"Kinematics": "Small Strain", "Relative Tolerance": 1e-5,
                                    "Stop When": {"Value": "Broken", "Reaches": n_bonds}}}
    result["Compute Class Parameters"] = {"Broken": {"Compute Class": "Broken_Bonds", "Output Label": "Broken"}}
    return result


def diffusing_plate(counts, steps):
    """A plate, half of it full: `steps` steps of Euler's method. Its material has no stiffness, so no force is found."""
    conditions = {"Half Node Set": {"Expression": f"x < {0.5 * SPACING * counts[0]!r}"},
                  "Full": {"Type": "Initial Concentration", "Node Set": "Half Node Set", "Value": 1.0}}
    result = deck(True, {"Diffusion": {"Method": "Euler", "Sub Steps": steps}}, float(steps), 3.015,
                  {"Diffusivity": 1e-9}, conditions=conditions)
    for key in ("Density", "Young's Modulus", "Poisson's Ratio"):
        del result["Materials"]["Steel"][key]
    return result


def driven_cavity(counts, steps):
    """Fluid that a lid starts to drive round, in a box of walls four spacings deep: `steps` Runge-Kutta steps."""
    edges = [SPACING * count for count in counts]
    low, high = 4 * SPACING, [edge - 4 * SPACING for edge in edges]
    axes = "xy" if counts[2] == 1 else "xyz"
    surface = f"y - {low!r}"
    for axis, end in zip(axes, high):
        if axis != "y":
            surface = f"min({surface}, min({axis} - {low!r}, {end!r} - {axis}))"
    conditions = {"Walls Node Set": {"Expression": f"({surface}) < 0"},
                  "Lid Node Set": {"Expression": f"y > {high[1]!r}"},
                  "Walls": {"Type": "Prescribed Velocity", "Node Set": "Walls Node Set", "Surface": surface},
                  "Lid": {"Type": "Prescribed Velocity", "Node Set": "Lid Node Set", "Velocity": [0.01, 0.0],
                          "Surface": f"{high[1]!r} - y"}}
    time_step = 0.2 * SPACING / 0.1
    plane, thickness = ({"Plane Strain": True}, {"Thickness": SPACING}) if counts[2] == 1 else ({}, {})
    return {
        "Discretization": {"Type": "Text File", "Input Mesh File": "lattice.txt", **thickness},
        "Materials": {"Water": {"Material Model": "Navier Stokes", "Density": 1000.0, "Viscosity": 1e-2, **plane,
                                **thickness}},
        "Blocks": {"Water": {"Block Names": "block_1", "Material": "Water", "Horizon": 3.015 * SPACING}},
        "Boundary Conditions": conditions,
        "Solver": {"Final Time": steps * time_step,
                   "Weakly Compressible Flow": {"Sound Speed": 0.1, "Time Step": time_step}},
        "Output": {"Output Filename": "run", "Output Variables": ["Volume"], "Output Frequency": -1,
                   "History Frequency": -1},
    }


def write_pin(path, spacing):
    """The whole section of `decks/mg_pin`: a tube of 0.85 mm, its walls a horizon thick, the wire at the origin."""
    x = spacing * (np.arange(-np.ceil(250e-6 / spacing) - 3, np.ceil(450e-6 / spacing) + 4) + 0.2)
    rows = round(425e-6 / spacing) + 4
    y = spacing * (np.arange(-rows, rows) + 0.5)
    y, x = (axis.ravel() for axis in np.meshgrid(y, x, indexing="ij"))
    block = np.where(np.abs(y) < 425e-6, 1, 2)
    np.savetxt(path, np.column_stack([x, y, np.zeros(len(x)), block, np.full(len(x), spacing**2)]),
               fmt=["%.10g"] * 3 + ["%d", "%.10g"])


def mpi(ranks):
    """What a command on `ranks` ranks begins with."""
    if ranks == 1:
        return []
    has_cores = (os.cpu_count() or 1) >= ranks
    binding = ["--bind-to", "core"] if has_cores else ["--oversubscribe", "--bind-to", "none"]
    return ["mpirun", "--allow-run-as-root", *binding, "-np", str(ranks)]


def run(pdrun, deck_file, folder, ranks=1, overrides=()):
    """Runs a deck in `folder` and returns its report. Its results are called `run`."""
    command = [pdrun, str(deck_file), "--quiet"]
    for path, value in {"Output/Output Filename": "run", **dict(overrides)}.items():
        command += ["--set", f"{path}={value}"]
    command = mpi(ranks) + command
    process = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if process.returncode != 0:
        raise RuntimeError(f"{' '.join(command)} ended with code {process.returncode}:\n"
                           f"{process.stdout}{process.stderr}")
    return json.loads((folder / "run.report.json").read_text())


def run_own(pdrun, content, folder, **options):
    """Runs a deck made here; YAML reads JSON."""
    (folder / "deck.yaml").write_text(json.dumps(content))
    return run(pdrun, "deck.yaml", folder, **options)
