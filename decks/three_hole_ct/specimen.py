#!/usr/bin/python3
"""A compact tension specimen with its notch off the middle and up to three holes, for three_hole_ct.yaml;
specimen.py SPECIMEN SPACING_IN_MM FILE writes the mesh, and prints the --set options of pdrun for it, one a line.

D. Wagner, PhD thesis (2018), as digitised in the open repository CastillonMiguel/
A-Phase-Field-Approach-to-Fracture-and-Fatigue-Analysis-Bridging-Theory-and-Simulation. Another specimen is another row
of SPECIMENS.
"""
import sys

import numpy as np

WIDTH, FRONT, HALF_HEIGHT, THICKNESS = 40.0, 10.0, 24.0, 3.2  # mm: W, 0.25 W, 0.6 W, B
PINS = ((0.0, 11.0, 5.0), (0.0, -11.0, 5.0))  # x, y, radius in mm; x from the load line
HOLES = ((18.0, 10.0, 4.0), (30.0, 0.0, 2.0), (25.0, -10.0, 4.0))
SPECIMENS = {  # height of the notch above the middle (mm), holes, load (N)
    "1": (0.0, (), 1750.0),
    "2": (1.6, HOLES, 1574.0),
    "3": (0.8, HOLES, 1574.0),
    "4": (-1.6, HOLES, 1574.0),
}


def points(height, holes, spacing):
    """Centres of square cells [n, 2] in mm, the notch between two rows."""
    x = np.arange(round((WIDTH + FRONT) / spacing)) * spacing + spacing / 2 - FRONT
    rows = np.arange(np.ceil((-HALF_HEIGHT - height) / spacing), np.floor((HALF_HEIGHT - height) / spacing))
    grid = np.stack(np.meshgrid(x, height + (rows + 0.5) * spacing), axis=-1).reshape(-1, 2)
    inside = np.zeros(len(grid), dtype=bool)
    for a, b, radius in PINS + holes:
        inside |= np.hypot(grid[:, 0] - a, grid[:, 1] - b) < radius
    return grid[~inside]


def settings(specimen, spacing, file):
    """Of the deck, for a specimen on squares of three spacings a horizon."""
    height, holes, load = SPECIMENS[specimen]
    horizon = 3e-3 * spacing
    yield "Discretization/Input Mesh File", file
    for key in ("Discretization/Bond Filters/Notch/Lower_Left_Corner_Y", "Compute Class Parameters/Tip/Start Y",
                "Compute Class Parameters/Length/Start Y"):
        yield key, height * 1e-3
    yield "Boundary Conditions/Pull Up/Value", load
    yield "Boundary Conditions/Pull Down/Value", -load
    yield "Damage Models/Fatigue/Spacing", spacing * 1e-3
    for key in ("Damage Models/Fatigue/Horizon", "Blocks/Body/Horizon"):
        yield key, horizon
    for side, part in (("Ahead", 1.5), ("Behind", 1.5), ("Above", 2.0)):
        yield f"Compute Class Parameters/J/{side}", part * horizon
    yield "Compute Class Parameters/K/Inner Radius", horizon
    yield "Compute Class Parameters/K/Outer Radius", 2.5 * horizon
    if holes:
        rims = " || ".join(f"(x - {x:g}e-3)^2 + (y - {y:g}e-3)^2 < {radius + spacing:g}e-3^2" for x, y, radius in holes)
        yield "Boundary Conditions/Rims Node Set/Expression", rims
    else:  # until the crack has this length
        yield "Solver/Fatigue/Stop When", '{"Value": "Crack_Length", "Reaches": 0.030}'


def main(specimen, spacing, file):
    height, holes, _ = SPECIMENS[specimen]
    volume = spacing**2 * THICKNESS * 1e-9
    with open(file, "w") as mesh:
        for x, y in points(height, holes, spacing):
            mesh.write(f"{x * 1e-3:.9g} {y * 1e-3:.9g} 0 1 {volume:.12g}\n")
    for key, value in settings(specimen, spacing, file):
        print(f"--set\n{key}={value:.9g}" if isinstance(value, float) else f"--set\n{key}={value}")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]), sys.argv[3])
