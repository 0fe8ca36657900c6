#!/usr/bin/python3
"""Static tension of plates whose points are no lattice: jittered, and centroids of Gmsh's triangles."""
import os
import subprocess
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.path[0] + "/../support")
from scene import SceneTest, lattice, plate_deck  # noqa: E402

PDMESH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../meshes/pdmesh")
LENGTH, WIDTH, THICKNESS, SPACING = 0.048, 0.020, 2e-3, 1e-3
HORIZON = 4.0 * SPACING
YOUNG, STRAIN = 200e9, 1e-4

PLATE = f"""
Point(1) = {{0, 0, 0}}; Point(2) = {{{LENGTH}, 0, 0}};
Point(3) = {{{LENGTH}, {WIDTH}, 0}}; Point(4) = {{0, {WIDTH}, 0}};
Line(1) = {{1, 2}}; Line(2) = {{2, 3}}; Line(3) = {{3, 4}}; Line(4) = {{4, 1}};
Curve Loop(1) = {{1, 2, 3, 4}}; Plane Surface(1) = {{1}};
Physical Surface("plate", 1) = {{1}};
Mesh.CharacteristicLengthMin = {1.4 * SPACING}; Mesh.CharacteristicLengthMax = {1.4 * SPACING};
"""


class IrregularPlate(SceneTest):
    """Layers of a horizon at both ends follow u = strain x; in between the plate is free."""

    def pull(self, poissons_ratio=1 / 3, solver=None):
        """Young's modulus and Poisson's ratio that the plate shows; the displacement, and that of uniform strain."""
        deck = plate_deck(
            HORIZON, THICKNESS, {"Young's Modulus": YOUNG, "Poisson's Ratio": poissons_ratio},
            conditions={"Left Node Set": {"Expression": f"x < {HORIZON}"},
                        "Right Node Set": {"Expression": f"x > {LENGTH - HORIZON}"},
                        "Ends Node Set": {"Expression": f"x < {HORIZON} || x > {LENGTH - HORIZON}"},
                        "Foot Node Set": {"Expression": f"x < {HORIZON} && abs(y - {WIDTH / 2}) < {SPACING}"},
                        "Pull": {"Type": "Prescribed Displacement", "Node Set": "Ends Node Set", "Coordinate": "x",
                                 "Value": f"{STRAIN}*x"},
                        "Hold": {"Type": "Prescribed Displacement", "Node Set": "Foot Node Set", "Coordinate": "y",
                                 "Value": 0.0}},
            solver={"Final Time": 1.0, **(solver or {"QuasiStatic": {"Relative Tolerance": 1e-8}})},
            output={"Output Variables": ["Displacement", "Pull"], "Output Frequency": 1},
            Compute_Class_Parameters={"Pull": {"Compute Class": "Reaction_Force", "Node Set": "Right Node Set",
                                               "Output Label": "Pull"}})
        result = self.solve(deck)
        x = np.loadtxt(self.path("mesh.txt"), ndmin=2)[:, :2]
        u = result.field("Displacement")[:, :2]
        inner = np.abs(x[:, 0] - LENGTH / 2) < LENGTH / 4
        columns = np.column_stack([x[inner], np.ones(np.count_nonzero(inner))])
        gradient = np.linalg.lstsq(columns, u[inner], rcond=None)[0]
        force = [value for name, value in result.history().items() if name.startswith("Pull") and "x" in name.lower()]
        self.assertEqual(len(force), 1, result.history().keys())
        smooth = columns @ gradient
        roughness = np.sqrt(np.mean((u[inner] - smooth) ** 2)) / (STRAIN * LENGTH)
        return {"E": abs(force[0][-1]) / (WIDTH * THICKNESS * STRAIN), "nu": -gradient[1, 1] / gradient[0, 0],
                "strain": gradient[0, 0], "roughness": roughness}

    def check(self, found):
        # Volumes of irregular points fill the horizon unevenly: Young's modulus within 3 % of the lattice's, which is
        # 1.02 - 0.24 * horizon / width = 0.97 of the true one (free edges, m = 4).
        self.assertAlmostEqual(found["E"] / (0.97 * YOUNG), 1.0, delta=0.03)
        self.assertAlmostEqual(found["strain"] / STRAIN, 1.0, delta=0.005)
        self.assertAlmostEqual(found["nu"], 1 / 3, delta=0.02)
        self.assertLess(found["roughness"], 0.005)

    def jitter(self, share):
        shift = np.random.default_rng(7).uniform(-share * SPACING, share * SPACING, (960, 2))
        points = lattice([LENGTH, WIDTH], SPACING)
        points[:, :2] += shift
        self.write_mesh(points, SPACING**2 * THICKNESS)

    def triangulate(self):
        with open(self.path("plate.geo"), "w") as file:
            file.write(PLATE)
        for command in (["gmsh", "-2", "plate.geo", "-o", "plate.msh"],
                        ["/usr/bin/python3", PDMESH, "convert", "plate.msh", "mesh.txt", "--thickness",
                         str(THICKNESS)]):
            process = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=120)
            self.assertEqual(process.returncode, 0, process.stdout + process.stderr)

    def test_jittered_lattice(self):
        self.jitter(0.2)
        self.check(self.pull())

    def test_jittered_lattice_relaxes_to_the_same_equilibrium(self):
        self.jitter(0.2)
        newton = self.pull()
        relaxed = self.pull(solver={"Adaptive Dynamic Relaxation": {"Relative Tolerance": 1e-7}})
        for name in ("E", "strain", "nu"):
            self.assertAlmostEqual(relaxed[name] / newton[name], 1.0, delta=1e-5, msg=name)

    def test_triangles(self):
        self.triangulate()
        self.check(self.pull())

    def test_triangles_with_negative_tangential_stiffness(self):
        self.triangulate()
        found = self.pull(0.4)
        self.assertAlmostEqual(found["E"] / YOUNG, 1.0, delta=0.05)
        self.assertAlmostEqual(found["nu"], 0.4, delta=0.02)


if __name__ == "__main__":
    unittest.main()
