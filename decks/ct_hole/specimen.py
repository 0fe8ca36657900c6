#!/usr/bin/python3
"""A compact tension specimen with a hole beside the path of its crack, for ct_hole.yaml; specimen.py X Y SPACING POINTS
FILE writes the mesh, and prints the --set options of pdrun for it, one word a line. X, Y: centre of the hole in mm;
POINTS: spacings a horizon.
"""
import sys

import numpy as np

WIDTH, THICKNESS, RADIUS = 29.5, 8.0, 3.5  # mm: W, B, of the hole
FRONT, HALF_HEIGHT, PIN_HEIGHT, PIN_RADIUS = 0.25 * WIDTH, 0.6 * WIDTH, 0.275 * WIDTH, 0.125 * WIDTH  # ASTM E647


def main(x, y, spacing, points, file):
    columns = np.arange(np.floor((WIDTH + FRONT) / spacing)) * spacing + spacing / 2 - FRONT
    half = np.arange(np.floor(HALF_HEIGHT / spacing)) * spacing + spacing / 2
    volume = spacing**2 * THICKNESS * 1e-9
    with open(file, "w") as mesh:
        for b in np.concatenate([-half[::-1], half]):  # the cut lies between two rows
            for a in columns:
                if np.hypot(a - x, b - y) >= RADIUS and np.hypot(a, abs(b) - PIN_HEIGHT) >= PIN_RADIUS:
                    mesh.write(f"{a * 1e-3:.9g} {b * 1e-3:.9g} 0 1 {volume:.12g}\n")
    horizon = points * spacing
    rim = f"(x - {x:g}e-3)^2 + (y - {y:g}e-3)^2 < {RADIUS + spacing:g}e-3^2"
    for key, value in (("Discretization/Input Mesh File", file), ("Boundary Conditions/Rim Node Set/Expression", rim),
                       ("Damage Models/Fatigue/Spacing", f"{spacing:.9g}e-3"),
                       ("Damage Models/Fatigue/Horizon", f"{horizon:.9g}e-3"),
                       ("Blocks/Body/Horizon", f"{horizon:.9g}e-3"),
                       *((f"Compute Class Parameters/J/{side}", f"{part * horizon:.9g}e-3")
                         for side, part in (("Ahead", 1.5), ("Behind", 1.5), ("Above", 2.0)))):
        print(f"--set\n{key}={value}")


if __name__ == "__main__":
    main(*map(float, sys.argv[1:5]), sys.argv[5])
