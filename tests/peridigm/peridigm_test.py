#!/usr/bin/python3
"""The plug-ins inside Peridigm against pdrun: the same deck and mesh in both, on 1 and 2 ranks.

Needs a Peridigm that was built with these plug-ins (materials/README.md), which the environment variable
PERIDIGM_EXECUTABLE names. Both programs add up the same terms in another order, and follow the same step formulas:
what rounding leaves is below 1e-10 of the largest value, and 1e-8 where bonds break over 100 steps, since a change of
one bond at another step would show as 1e-3. Solvers that iterate are given tolerances below that.
"""
import os
import re
import subprocess
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
import exodus  # noqa: E402
from exodus import ExodusResult  # noqa: E402
from scene import Result, SceneTest, lattice, pdrun_path, yaml  # noqa: E402

SKIPPED = 77  # what CMakeLists.txt names as SKIP_RETURN_CODE
PERIDIGM = os.environ.get("PERIDIGM_EXECUTABLE")
MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np"]

STEEL = {"Material Model": "PDHE", "Density": 7800.0, "Young's Modulus": 200e9, "Poisson's Ratio": 0.2,
         "Volume Correction": "Ramp To Horizon"}
SPACING = 1e-3
HORIZON = 3.015 * SPACING


class InPeridigm(SceneTest):
    """Runs a deck in both programs and compares what they write last."""

    def node_set(self, name, is_member):
        """A file of node numbers, from 1."""
        with open(self.path(name), "w") as file:
            file.writelines(f"{i + 1}\n" for i in np.flatnonzero(is_member))
        return name

    def deck(self, materials, conditions, solver, variables, frequency=1):
        """`materials`: one a block."""
        return yaml({"Peridigm": {
            "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt"},
            "Materials": {f"Of block {i}": material for i, material in enumerate(materials, 1)},
            "Blocks": {f"Block {i}": {"Block Names": f"block_{i}", "Material": f"Of block {i}", "Horizon": HORIZON}
                       for i in range(1, len(materials) + 1)},
            "Boundary Conditions": conditions, "Solver": solver,
            "Output": {"Output File Type": "ExodusII", "Output Filename": "result", "Output Frequency": frequency,
                       "Output Variables": dict.fromkeys(variables, True)}}}) + "\n"

    def run_program(self, program, deck, ranks):
        """`deck`: text. Both programs read the same file."""
        with open(self.path("deck.yaml"), "w") as file:
            file.write(deck)
        for old in os.listdir(self.folder):
            if old.startswith("result.e"):
                os.remove(self.path(old))
        process = subprocess.run([*MPIRUN, str(ranks), program, "deck.yaml"], cwd=self.folder, capture_output=True,
                                 text=True, timeout=280)
        self.assertEqual(process.returncode, 0, process.stdout[-3000:] + process.stderr[-3000:])
        return process

    def compare(self, deck, tolerance, fields, histories=(), pdrun_deck=None, all_ranks=(1, 2)):
        """Decks write "result"; `pdrun_deck` where pdrun has another name for a solver of the same equations. Returns
        the fields."""
        for ranks in all_ranks:
            self.run_program(PERIDIGM, deck, ranks)
            theirs = ExodusResult(self.path("result"))
            ours = Result(self.folder, "result", self.run_program(pdrun_path(), pdrun_deck or deck, ranks))
            found = {label: (ours.field(label), theirs.field(label)) for label in fields}
            if histories:
                history = ours.history()
                found.update({label: (history[label][-1:], np.array([theirs.globals[label]])) for label in histories})
            for label, (ours_, theirs_) in found.items():
                self.assertEqual(ours_.shape, theirs_.shape, label)
                largest = np.abs(ours_).max()
                self.assertGreater(largest, 0.0, label)
                error = np.abs(ours_ - theirs_).max() / largest
                print(f"{self.id().split('.')[-1]}, {ranks} rank(s): {label} agrees to {error:.1e}", flush=True)
                self.assertLess(error, tolerance, f"{label} on {ranks} rank(s)")
        return {label: ours.field(label) for label in fields}


class Mechanics(InPeridigm):
    def block(self, boundary=np.inf):
        """An irregular block, held and twisted at one end, whose other end flies off. Beyond x = `boundary` it is of
        block_2."""
        points = lattice([12e-3, 7e-3, 6e-3], SPACING)
        points += np.random.default_rng(7).uniform(-0.1, 0.1, points.shape) * SPACING
        self.write_mesh(points, SPACING ** 3, np.where(points[:, 0] < boundary, 1, 2))
        left = self.node_set("left.txt", points[:, 0] < HORIZON)
        right = self.node_set("right.txt", points[:, 0] > 12e-3 - HORIZON)
        return {"Left Node Set": left, "Right Node Set": right,
                **{f"Hold {axis}": {"Type": "Prescribed Displacement", "Node Set": "Left Node Set", "Coordinate": axis,
                                    "Value": value}
                   for axis, value in {"x": "0.0", "y": "2.0*t*z", "z": "-2.0*t*y"}.items()}}

    def fly(self, materials, boundary=np.inf):
        conditions = self.block(boundary)
        conditions["Fly"] = {"Type": "Initial Velocity", "Node Set": "Right Node Set", "Coordinate": "x",
                             "Value": "10.0"}
        fields = ["Displacement", "Force_Density", "Stored_Elastic_Energy_Density"]
        deck = self.deck(materials, conditions, {"Final Time": 1.005e-5, "Verlet": {"Fixed dt": 1e-7}},
                         fields + ["Strain_Energy"], frequency=100)
        self.compare(deck, 1e-10, fields, ["Strain_Energy"])

    def test_objective_form(self):
        self.fly([{**STEEL, "Surface Correction": "Volume Method"}])

    def test_linear_form(self):
        self.fly([{**STEEL, "Tangential Force": "Linear", "Surface Correction": "Energy Method"}])

    def test_two_blocks(self):
        corrected = {**STEEL, "Surface Correction": "Volume Method"}
        self.fly([corrected, {**corrected, "Young's Modulus": 50e9, "Density": 3000.0}], boundary=6.2e-3)

    def test_exodus_mesh(self):
        """Distorted hexahedra, and tetrahedra cut out of others. (On two ranks Peridigm wants the file in parts.)"""
        n = np.array([10, 6, 5])
        grid = np.stack(np.meshgrid(*[np.arange(k + 1) for k in n], indexing="ij"), axis=-1)
        nodes = grid.reshape(-1, 3) * SPACING
        nodes += np.random.default_rng(3).uniform(-0.15, 0.15, nodes.shape) * SPACING
        number = np.arange(len(nodes)).reshape(n + 1)
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
        hexahedra = np.stack([number[i:n[0] + i, j:n[1] + j, k:n[2] + k].ravel() for i, j, k in corners], axis=1)
        isCut = np.arange(len(hexahedra)) >= 6 * n[1] * n[2]
        # Six tetrahedra around the diagonal from corner 0 to corner 6.
        around = [1, 2, 3, 7, 4, 5, 1]
        tetrahedra = np.concatenate([hexahedra[isCut][:, [0, a, b, 6]] for a, b in zip(around, around[1:])])
        exodus.write_mesh(self.path("mesh.g"), nodes,
                          [(1, "", "HEX8", hexahedra[~isCut]), (20, "Tets_20", "TETRA", tetrahedra)],
                          {4: number[0].ravel(), 9: number[-1].ravel()})
        conditions = {name: {"Type": "Initial Velocity", "Node Set": node_set, "Coordinate": axis, "Value": value}
                      for name, node_set, axis, value in (("Left", "nodelist_4", "x", "-5.0"),
                                                          ("Right", "nodelist_9", "z", "10.0 + 1000.0*y"))}
        fields = ["Displacement", "Volume", "Number_Of_Neighbors"]
        deck = self.deck([STEEL, STEEL], conditions, {"Final Time": 1.005e-6, "Verlet": {"Fixed dt": 1e-8}}, fields, 100)
        for old, new in (("Text File", "Exodus"), ("mesh.txt", "mesh.g"), ("block_2", "Tets_20")):
            deck = deck.replace(old, new)
        self.compare(deck, 1e-10, fields, all_ranks=(1,))

    def test_quasi_static(self):
        conditions = self.block()
        for axis, value in {"x": "0.1*t", "y": "0.0", "z": "0.0"}.items():
            conditions[f"Pull {axis}"] = {"Type": "Prescribed Displacement", "Node Set": "Right Node Set",
                                          "Coordinate": axis, "Value": value}
        deck = self.deck([STEEL], conditions,
                         {"Final Time": 1e-4, "QuasiStatic": {"Number of Load Steps": 2, "Relative Tolerance": 1e-10,
                                                             "Belos Linear Solver": "BlockGMRES",
                                                             "Belos Relative Tolerance": 1e-10,
                                                             "Maximum Solver Iterations": 20}},
                         ["Displacement", "Force_Density"])
        self.compare(deck, 1e-10, ["Displacement", "Force_Density"])

    def test_finite_difference_jacobian(self):
        """Peridigm's preconditioner of 3x3 blocks probes the material point by point."""
        conditions = self.block()
        conditions["Pull"] = {"Type": "Prescribed Displacement", "Node Set": "Right Node Set", "Coordinate": "x",
                              "Value": "0.1*t"}
        fields = ["Displacement"]
        newton = {"Method": "Newton", "Newton": {"Linear Solver": {"Jacobian Operator": "Matrix-Free",
                                                                   "Preconditioner": "User Defined",
                                                                   "Tolerance": 1e-8, "Max Iterations": 500}}}
        deck = self.deck([STEEL], conditions,
                         {"Final Time": 1e-4, "Peridigm Preconditioner": "Block 3x3",
                          "NOXQuasiStatic": {"Nonlinear Solver": "Line Search Based", "Number of Load Steps": 1,
                                             "Max Solver Iterations": 100, "Relative Tolerance": 1e-9,
                                             "Direction": newton, "Line Search": {"Method": "Polynomial"}}}, fields)
        ours = self.deck([STEEL], conditions,
                         {"Final Time": 1e-4, "QuasiStatic": {"Load Steps": 1, "Relative Tolerance": 1e-10}}, fields)
        self.compare(deck, 1e-8, fields, pdrun_deck=ours)


class Breakage(InPeridigm):
    """The deck of materials/README.md: a plate with an edge crack is torn apart within 100 steps."""

    def tear(self, changes=(), fields=("Displacement", "Damage", "Temperature"), histories=("Crack_Area",),
             size=(50e-3, 30e-3), damaged=(0.3, 20)):
        """`damaged`: more Damage than the first number at as many points as the second at least."""
        width = size[1]
        points = lattice(size, SPACING, [0.0, -width / 2])
        self.write_mesh(points, SPACING ** 2, name="plate.txt")
        self.node_set("top.txt", points[:, 1] > width / 2 - HORIZON)
        self.node_set("bottom.txt", points[:, 1] < -width / 2 + HORIZON)
        self.node_set("all.txt", points[:, 1] < width)
        with open(sys.path[0] + "/../../materials/README.md") as file:
            deck = re.search(r"```yaml\n(Peridigm:.*?)```", file.read(), re.DOTALL).group(1)
        for old, new in (("Output Filename: plate", "Output Filename: result"), *changes):
            self.assertIn(old, deck)
            deck = deck.replace(old, new)
        found = self.compare(deck, 1e-8, fields, histories)
        if "Damage" in found:
            self.assertGreaterEqual(np.count_nonzero(found["Damage"] > damaged[0]), damaged[1])

    def test_hydrogen_critical_stretch(self):
        self.tear()

    def test_critical_stretch(self):
        """Peridigm knows a damage model of this name itself, so it is Peridigm's against ours."""
        self.tear([("Damage Model: Hydrogen Critical Stretch\n", "Damage Model: Critical Stretch\n"),
                   ("      Concentration Field: Temperature\n", ""), ("      Saturation Concentration: 1.0\n", "")])

    def test_quasi_static(self):
        """The first bonds at the tip. Peridigm tests bonds in every iterate of Newton's method, settled or not: where
        more of them break, the two programs part."""
        held = "".join(f"    {name}:\n      Type: Prescribed Displacement\n      Node Set: {where} Node Set\n"
                       f"      Coordinate: {axis}\n      Value: \"0.0\"\n"
                       for name, where, axis in (("Plane", "All", "z"), ("Top X", "Top", "x"), ("Bottom X", "Bottom", "x")))
        steps = ("    Final Time: 1.0\n    QuasiStatic:\n      Number of Load Steps: 4\n"
                 "      Relative Tolerance: 1.0e-10\n      Maximum Solver Iterations: 50\n"
                 "      Belos Linear Solver: BlockGMRES\n      Belos Relative Tolerance: 1.0e-10\n")
        self.tear([("    Final Time: 1.505e-5\n    Verlet:\n      Fixed dt: 1.5e-7\n", steps),
                   ("20.0*t", "4.0e-5*t"), ("    Pull Top:\n", held + "    Pull Top:\n"),
                   ("Output Frequency: 10", "Output Frequency: 1")], size=(30e-3, 20e-3), damaged=(0.0, 2))

    def test_computes(self):
        """All that Peridigm has not itself and that see this scene."""
        plain = ["Strain_Energy", "Broken_Bonds", "Stored_Elastic_Energy_Density", "Bond_Strain"]
        computes = {
            "Coverage": {"Variable": "Temperature", "Saturation Concentration": 0.7},
            "Crack_Length": {"Block": "block_1"},
            "Field_Integral": {"Variable": "Damage"},
            "Field_Maximum": {"Variable": "Velocity", "Component": "Y"},
            "Field_Mean": {"Variable": "Displacement"},
            "Field_Minimum": {"Variable": "Displacement", "Component": "Y"},
            "J_Integral": {"Thickness": 1.0, "Inner Radius": 6.5e-3, "Outer Radius": 9.5e-3, "Tip X": 16.3e-3,
                           "Plane Stress": True},
            "Bond_Stress": {"Plane Stress": True}}
        section = "  Compute Class Parameters:\n"
        entries = yaml({"The " + name: {"Compute Class": name, **keys} for name, keys in computes.items()}, 2) + "\n"
        names = "".join(f"      {name}: true\n" for name in plain + list(computes))
        fields = ["Stored_Elastic_Energy_Density", "Bond_Strain", "Coverage", "Bond_Stress"]
        self.tear([(section, section + entries), ("      Crack_Area: true\n", names)], fields,
                  [name for name in plain + list(computes) if name not in fields])


class Fatigue(InPeridigm):
    """A compact tension specimen (ASTM E647, W = 40 mm) whose bonds tire by a number of cycles each load step."""

    def specimen(self):
        """Points 1.25 mm apart; x = 0 is the load line. Returns the conditions: pins that move apart, steadily."""
        spacing, height, radius = 1.25e-3, 11e-3, 5e-3
        points = lattice([50e-3, 47.5e-3], spacing, [-10e-3, -23.75e-3])
        above, below = (np.hypot(points[:, 0], points[:, 1] - y) for y in (height, -height))
        points = points[(above > radius) & (below > radius)]
        self.write_mesh(points, spacing**2)
        pins = {name: np.hypot(points[:, 0], points[:, 1] - y) < 1.5 * radius
                for name, y in (("Upper", height), ("Lower", -height))}
        hold = {"Type": "Prescribed Displacement"}
        conditions = {"All Node Set": self.node_set("all.txt", points[:, 0] < 1.0)}
        for name, speed in (("Upper", "2.0e-5*t"), ("Lower", "-2.0e-5*t")):
            node_set = f"{name} Pin Node Set"
            conditions[node_set] = self.node_set(f"{name}.txt", pins[name])
            conditions[f"{name} Y"] = {**hold, "Node Set": node_set, "Coordinate": "y", "Value": speed}
            conditions[f"{name} X"] = {**hold, "Node Set": node_set, "Coordinate": "x", "Value": "0.0"}
        return {**conditions, "Plane": {**hold, "Node Set": "All Node Set", "Coordinate": "z", "Value": "0.0"}}

    def tire(self, damage, steps):
        """Both programs on the specimen with that damage model, whose bonds bear 900 cycles each of some load steps."""
        deck = {"Peridigm": {
            "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt", "Bond Filters": {"Notch": {
                "Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0,
                "Lower_Left_Corner_X": -1.0, "Lower_Left_Corner_Y": 1e-4, "Lower_Left_Corner_Z": -1.0,
                "Bottom_Unit_Vector_X": 1.0, "Bottom_Unit_Vector_Y": 0.0, "Bottom_Unit_Vector_Z": 0.0,
                "Bottom_Length": 1.0151, "Side_Length": 2.0}}},
            "Materials": {"Steel": {**STEEL, "Poisson's Ratio": 1 / 3, "Plane Stress": True,
                                    "Volume Correction": "Ramp To Horizon"}},
            "Damage Models": {"Tiring": {**damage, "Cycles Per Step": 900.0, "Load Ratio": 0.1}},
            "Blocks": {"Body": {"Block Names": "block_1", "Material": "Steel", "Damage Model": "Tiring",
                                "Horizon": 3.015 * 1.25e-3}},
            "Boundary Conditions": self.specimen(),
            "Solver": {"Final Time": steps / 12, "QuasiStatic": {
                "Number of Load Steps": steps, "Relative Tolerance": 1e-10, "Maximum Solver Iterations": 50,
                "Belos Linear Solver": "BlockGMRES", "Belos Relative Tolerance": 1e-10}},
            "Output": {"Output File Type": "ExodusII", "Output Filename": "result", "Output Frequency": 1,
                       "Output Variables": {"Displacement": True, "Damage": True}}}}
        found = self.compare(yaml(deck) + "\n", 1e-8, ["Displacement", "Damage"], all_ranks=(1,))
        return np.count_nonzero(found["Damage"])

    def test_remaining_life(self):
        """Bonds break at the tip of a cut, away from cracks first, then beside one. Peridigm exchanges nothing before it asks for
        damage: one rank. It breaks bonds in iterates of Newton's method, too, which may save others from breaking: from the
        thirteenth step on one pair of bonds holds there that breaks in equilibrium here."""
        damage = {"Damage Model": "Remaining Life", "Initiation Coefficient": 2e4, "Initiation Exponent": 2.77,
                  "Growth Coefficient": 2e5, "Growth Exponent": 3.0, "Growth Damage": 0.07}
        self.assertGreaterEqual(self.tire(damage, 12), 10)

    def test_cumulative_fatigue(self):
        """The relation by which bonds away from cracks tire above, as one of strain and life."""
        damage = {"Damage Model": "Cumulative Fatigue", "Ductility Coefficient": 2e4**(-1 / 2.77),
                  "Ductility Exponent": -1 / 2.77, "Strain Measure": "Range"}
        self.assertGreaterEqual(self.tire(damage, 12), 4)


class CracksAndVoids(InPeridigm):
    """Cracks and voids between points, as a part of a material there, and of the mesh in pdrun."""

    def both(self, points, volume, steel, gaps, velocity):
        """A body that flies apart at this velocity, on what pdrun leaves of the mesh."""
        def write(points, volume):
            self.write_mesh(points, volume)
            self.node_set("all.txt", points[:, 0] < 1.0)

        write(points, volume)
        fields = ["Displacement", "Damage"]
        deck = {
            "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt", **gaps},
            "Materials": {"Steel": steel},
            "Damage Models": {"Breakage": {"Damage Model": "Hydrogen Critical Stretch", "Critical Stretch": 0.01,
                                           "Concentration Field": "Temperature", "Saturation Concentration": 1.0}},
            "Blocks": {"Body": {"Block Names": "block_1", "Material": "Steel", "Damage Model": "Breakage",
                                "Horizon": HORIZON}},
            "Boundary Conditions": {"All Node Set": "all.txt", "Fly": {
                "Type": "Initial Velocity", "Node Set": "All Node Set", "Coordinate": velocity.split("(")[1][0],
                "Value": velocity}, "Hydrogen": {"Type": "Initial Temperature", "Node Set": "All Node Set", "Value": "0.1"}},
            "Solver": {"Final Time": 1.005e-5, "Verlet": {"Fixed dt": 1e-7}},
            "Output": {"Output File Type": "ExodusII", "Output Filename": "result", "Output Frequency": 100,
                       "Output Variables": dict.fromkeys([*fields, "Model_Coordinates", "Volume"], True)}}
        in_mesh = Result(self.folder, "result", self.run_program(pdrun_path(), yaml({"Peridigm": deck}) + "\n", 1))
        kept = {label: in_mesh.field(label) for label in fields}
        self.assertLess(len(kept["Damage"]), len(points))
        self.assertGreater(np.max(kept["Damage"]), 0.4)
        write(in_mesh.field("Model_Coordinates"), in_mesh.field("Volume"))
        for key in gaps:
            del deck["Discretization"][key]
        part = {"Material Model": "Bond Decomposition", "Cell Volume": volume, **gaps}
        deck["Materials"] = {"Porous": {"Material Model": "Combined", "Materials": ["Steel", "Gaps"], "Steel": steel,
                                        "Gaps": part}}
        deck["Blocks"]["Body"]["Material"] = "Porous"
        found = self.compare(yaml({"Peridigm": deck}) + "\n", 1e-8, fields)
        for label in fields:
            error = np.max(np.abs(found[label] - kept[label])) / np.max(np.abs(kept[label]))
            print(f"{label} by the part of the material and by the mesh: {error:.1e}", flush=True)
            self.assertLess(error, 1e-10, label)

    def test_in_a_plate(self):
        points = lattice([20e-3, 20e-3], SPACING)
        points[:, :2] += np.random.default_rng(4).uniform(-0.2, 0.2, (len(points), 2)) * SPACING
        gaps = {"Cracks": {"Edge": {"Type": "Polyline", "Points": [-1e-3, 9.3e-3, 4e-3, 9.6e-3, 7.3e-3, 10.4e-3]}},
                "Voids": {"Hole": {"Type": "Circle", "Center": [13.2e-3, 12.1e-3], "Radius": 2.2e-3}}}
        steel = {**STEEL, "Plane Stress": True, "Surface Correction": "Energy Method"}
        self.both(points, SPACING ** 2, steel, gaps, "40.0*(y/0.02 - 0.5)")

    def test_in_a_block(self):
        points = lattice([9e-3, 8e-3, 10e-3], SPACING)
        points += np.random.default_rng(4).uniform(-0.2, 0.2, points.shape) * SPACING
        gaps = {"Cracks": {"Penny": {"Type": "Disk", "Center": [3e-3, 4e-3, 4.8e-3], "Normal": [0.1, 0.2, 1.0], "Radius": 2.3e-3}},
                "Voids": {"Pore": {"Type": "Ellipsoid", "Center": [6.4e-3, 4.3e-3, 6.2e-3], "Half Axes": [1.6e-3, 1.5e-3, 1.4e-3]}}}
        self.both(points, SPACING ** 3, {**STEEL, "Material Model": "Elastic", "Volume Correction": "None"}, gaps,
                  "25.0*(z/0.01 - 0.5)")


STEADY = {"Solve For Displacement": False, "Solve For Temperature": True,
          "ImplicitDiffusion": {"Number of Load Steps": 2, "Relative Tolerance": 1e-13,
                                "Belos Linear Solver": "BlockGMRES", "Belos Relative Tolerance": 1e-12},
          "Final Time": 1.0}


class SteadyDiffusion(InPeridigm):
    def between_ends(self, points, length):
        """Conditions that drive a flux along x."""
        return {"Left Node Set": self.node_set("left.txt", points[:, 0] < HORIZON),
                "Right Node Set": self.node_set("right.txt", points[:, 0] > length - HORIZON),
                "Left": {"Type": "Prescribed Temperature", "Node Set": "Left Node Set", "Value": "1.0 + 50.0*t*y"},
                "Right": {"Type": "Prescribed Temperature", "Node Set": "Right Node Set", "Value": "0.5"}}

    def test_hydrogen(self):
        points = lattice([30e-3, 20e-3], SPACING)
        self.write_mesh(points, SPACING ** 2)
        material = {"Material Model": "PDHE", "Density": 7800.0, "Diffusivity": 1e-9,
                    "Diffusing Field": "Temperature", "Plane Stress": True, "Volume Correction": "Ramp To Horizon"}
        self.compare(self.deck([material], self.between_ends(points, 30e-3), STEADY, ["Temperature"]), 1e-10,
                     ["Temperature"])

    def steady_temperature(self, coefficients, boundary=np.inf):
        """Peridigm's material Diffusion against ours, in an irregular block."""
        points = lattice([16e-3, 8e-3, 7e-3], SPACING)
        points += np.random.default_rng(5).uniform(-0.1, 0.1, points.shape) * SPACING
        self.write_mesh(points, SPACING ** 3, np.where(points[:, 0] < boundary, 1, 2))
        materials = [{"Material Model": "Diffusion", "Coefficient": value}
                     for value in coefficients]
        fields = ["Temperature", "Flux_Divergence"]
        self.compare(self.deck(materials, self.between_ends(points, 16e-3), STEADY, fields), 1e-10, fields)

    def test_diffusion(self):
        self.steady_temperature([1e-6])

    def test_diffusion_in_two_blocks(self):
        self.steady_temperature([1e-6, 3e-6], boundary=8.1e-3)


if __name__ == "__main__":
    if not PERIDIGM:
        print("SKIPPED: PERIDIGM_EXECUTABLE names no Peridigm built with these plug-ins (materials/README.md)")
        sys.exit(SKIPPED)
    unittest.main()
