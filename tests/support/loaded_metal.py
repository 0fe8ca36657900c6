"""A bar of steel between two seas that dissolve it from above and from below, while it carries load."""
import numpy as np
from corrosion_scene import HORIZON, SPACING, STEEL
from scene import SceneTest, lattice

LENGTH, ROWS, SEA = 32, 16, 4  # points along the bar and across it, rows of electrolyte on either side
YOUNG, POISSON = 2e11, 0.25
MECHANICS = {"Material Model": "PDHE", "Young's Modulus": YOUNG, "Poisson's Ratio": POISSON, "Plane Strain": True}
DISSOLUTION = {"Material Model": "Corrosion Dissolution", "Plane Strain": True, **STEEL}
NEWTON = {"QuasiStatic": {"Number of Load Steps": 1, "Relative Tolerance": 1e-11}}
PULL = 1e-9  # m at either end


class LoadedMetal(SceneTest):
    def make_bar(self, rows=ROWS, sea=SEA):
        """Metal where |y| < rows / 2, at heights that are the same for all even numbers of rows."""
        height = rows + 2 * sea
        self.x = lattice([LENGTH * SPACING, height * SPACING], SPACING, [0.0, -0.5 * height * SPACING, 0.0])
        self.is_metal = np.abs(self.x[:, 1]) < 0.5 * rows * SPACING
        self.write_mesh(self.x, SPACING**2)

    def core(self, x):
        """Points that four rows off either side leave behind."""
        return np.abs(x[:, 1]) < (ROWS / 2 - 4) * SPACING


def grips(force=None):
    """The core is held at its left end; at its right it is pulled by PULL, or by a force of `force` N/m3 on two columns."""
    core = f"abs(y) < {(ROWS / 2 - 4) * SPACING!r}"
    left, right = f"x < {2 * SPACING!r} && {core}", f"x > {(LENGTH - 2) * SPACING!r} && {core}"
    conditions = {"Left Node Set": {"Expression": left}, "Right Node Set": {"Expression": right},
                  "Middle Node Set": {"Expression": f"x < {SPACING!r} && abs(y) < {SPACING!r}"},
                  "Hold": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": "x",
                           "Value": 0.0},
                  "Level": {"Type": "Prescribed Displacement", "Node Set": "Middle Node Set", "Coordinate": "y",
                            "Value": 0.0}}
    if force is None:
        conditions["Pull"] = {"Type": "Prescribed Displacement", "Node Set": "Right Node Set", "Coordinate": "x",
                              "Value": PULL}
    else:
        conditions["Pull"] = {"Type": "Body Force", "Node Set": "Right Node Set", "Coordinate": "x", "Value": force}
    return conditions


def sea(field="Concentration"):
    """Metal within |y| < ROWS / 2; beyond two rows of electrolyte on either side it is held at C = 0."""
    half = ROWS / 2 * SPACING
    return {"Metal Node Set": {"Expression": f"abs(y) < {half!r}"},
            "Sea Node Set": {"Expression": f"abs(y) > {half + 2 * SPACING!r}"},
            "Metal": {"Type": "Initial Value", "Field": field, "Node Set": "Metal Node Set",
                      "Value": STEEL["Solid Concentration"]},
            "Sea": {"Type": "Prescribed Value", "Field": field, "Node Set": "Sea Node Set", "Value": 0.0}}


def bar_deck(materials, damage_models, conditions, solvers, variables, start=0.0, **more):
    """`solvers`: (Final Time, solver) one after another from `start` on."""
    computes = {}
    if "Hold" in conditions:
        computes["Reaction"] = {"Compute Class": "Reaction_Force", "Node Set": "Left Node Set",
                                "Output Label": "Reaction"}
        variables = variables + ["Reaction"]
    deck = {
        "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt", "Thickness": 1.0},
        "Materials": materials, "Damage Models": damage_models,
        "Blocks": {"Bar": {"Block Names": "block_1", "Material": list(materials), "Horizon": HORIZON}},
        "Boundary Conditions": conditions,
        "Output": {"Output Filename": "result", "Output Frequency": 1, "Output Variables": variables}, **more}
    deck["Compute Class Parameters"] = {**computes, **more.get("Compute Class Parameters", {})}
    if damage_models:
        deck["Blocks"]["Bar"]["Damage Model"] = list(damage_models)
    for number, (end, solver) in enumerate(solvers, 1):
        deck[f"Solver{number}"] = {"Initial Time": start, "Final Time": end, **solver}
        start = end
    return deck
