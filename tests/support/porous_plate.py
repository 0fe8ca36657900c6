"""What tests of cracks and voids between points share: a plate of jittered points with some of each."""
import numpy as np
from scene import SceneTest, lattice, plate_deck

YOUNG, THICKNESS = 100.0e9, 1.0e-3
STEEL = {"Young's Modulus": YOUNG, "Poisson's Ratio": 1.0 / 3.0, "Lattice Rescaling": True,
         "Surface Correction": "Energy Method"}
SMALL_STRAIN = {"QuasiStatic": {"Load Steps": 1, "Relative Tolerance": 1e-8, "Kinematics": "Small Strain"}}


def prescribed(node_set, axis, value):
    return {"Type": "Prescribed Displacement", "Node Set": node_set, "Coordinate": axis, "Value": value}


def circle(x, y, radius):
    return {"Type": "Circle", "Center": [x, y], "Radius": radius}


def assert_goes_on(test, half, final_time, whole):
    """Of `half`, a deck that writes a checkpoint at its end: what goes on from there ends as `whole`, to the last bit."""
    half["Output"]["Output Filename"] = "half"
    test.solve(half)
    half["Solver"]["Final Time"] = final_time
    half["Output"]["Output Filename"] = "rest"
    rest = test.solve(half, arguments=["--restart", "half.checkpoint.h5"])
    for label in ("Damage", "Displacement"):
        np.testing.assert_array_equal(rest.field(label), whole.field(label))


class PorousPlate(SceneTest):
    SPACING = 1.0e-3

    def mesh(self, jitter):
        points = lattice([0.03, 0.03], self.SPACING)
        points[:, :2] += jitter * self.SPACING * np.random.default_rng(1).uniform(-1.0, 1.0, (len(points), 2))
        self.write_mesh(points, self.SPACING**2 * THICKNESS)
        return points

    def deck(self, variables, **more):
        deck = plate_deck(3.2 * self.SPACING, THICKNESS, {"Young's Modulus": YOUNG, "Poisson's Ratio": 0.25,
                                                          "Density": 8000.0},
                          output={"Output Variables": variables}, **more)
        deck["Discretization"]["Voids"] = {
            "Small": circle(8.3e-3, 8.2e-3, 0.005e-3), "Wide": circle(20.0e-3, 12.0e-3, 4.5e-3),
            "At The Side": circle(30.0e-3, 22.0e-3, 0.7e-3),
            "Overlapping": {"Type": "Ellipse", "Center": [16.0e-3, 12.0e-3], "Half Axes": [2.0e-3, 0.4e-3], "Angle": 0.3},
            "Corner": {"Type": "Polygon", "Corners": [7e-3, 20e-3, 12e-3, 21e-3, 9.2e-3, 22.1e-3, 9e-3, 25.4e-3]}}
        deck["Discretization"]["Cracks"] = {
            "From The Polygon": {"Type": "Polyline", "Points": [9e-3, 23e-3, 14.2e-3, 26.1e-3, 18.3e-3, 24.0e-3]}}
        return deck
