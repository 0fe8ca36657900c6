"""A small plate with an edge crack between grips, whose bonds tire: for tests of fatigue."""
from scene import lattice, plate_deck

SPACING, THICKNESS = 1e-3, 2e-3
WIDTH, HEIGHT, CRACK = 20e-3, 18e-3, 8e-3


def cracked_plate(test, damage=None, solver=None, width=WIDTH, final_time=1e9, crack=CRACK, points=None, **output):
    """Writes the mesh of `test` and returns the deck; a crack from the left edge to 8 mm, upper and lower grips apart.
    `damage`, `solver`: further parameters of Remaining Life and Fatigue; `points`: in place of squares along the edges."""
    if points is None:
        points = lattice([width, HEIGHT], SPACING, origin=[0.0, -HEIGHT / 2])
    test.write_mesh(points, SPACING**2 * THICKNESS)
    grip = HEIGHT / 2 - 3 * SPACING
    hold = {"Type": "Prescribed Displacement"}
    cut = {"Type": "Rectangular_Plane", "Normal_X": 0.0, "Normal_Y": 1.0, "Normal_Z": 0.0,
           "Lower_Left_Corner_X": -1.0, "Lower_Left_Corner_Y": 0.0, "Lower_Left_Corner_Z": -1.0,
           "Bottom_Unit_Vector_X": 1.0, "Bottom_Unit_Vector_Y": 0.0, "Bottom_Unit_Vector_Z": 0.0,
           "Bottom_Length": 1.0 + crack, "Side_Length": 2.0, "Count In Damage": True}
    deck = plate_deck(
        3.015 * SPACING, THICKNESS, {"Young's Modulus": 200e9, "Poisson's Ratio": 1 / 3},
        damage={"Damage Model": "Remaining Life", "Growth Coefficient": 1e4, "Growth Exponent": 3.0, **(damage or {})},
        conditions={"Top Node Set": {"Expression": f"y > {grip}"}, "Bottom Node Set": {"Expression": f"y < -{grip}"},
                    "Grips Node Set": {"Expression": f"abs(y) > {grip}"},
                    "Up": {**hold, "Node Set": "Top Node Set", "Coordinate": "y", "Value": 1e-5},
                    "Down": {**hold, "Node Set": "Bottom Node Set", "Coordinate": "y", "Value": -1e-5},
                    "Still": {**hold, "Node Set": "Grips Node Set", "Coordinate": "x", "Value": 0.0}},
        solver={"Final Time": final_time,
                "Fatigue": {"Relative Tolerance": 1e-8, "Preconditioner": "Block Jacobi", **(solver or {})}},
        Compute_Class_Parameters={
            "Length": {"Compute Class": "Crack_Length", "Start X": 0.0, "Start Y": 0.0, "Output Label": "Length"}},
        output={"Output Frequency": 1000000, "Output Variables": ["Displacement", "Damage", "Cycles_To_First_Break",
                                                                 "Length"], **output})
    deck["Discretization"]["Bond Filters"] = {"Crack": cut}
    return deck
