#!/usr/bin/python3
"""A lattice whose rows are stretched to the width between the arcs of the specimen; specimen.py SPACING_IN_MM FILE"""
import sys

import numpy as np

WIDTH, THICKNESS, RADIUS = 13.44, 3.2, 107.52  # mm; of the arcs 8 widths, the least of ASTM E466
LENGTH = 40.96  # mm, the part between the grips that is modelled

spacing, file = float(sys.argv[1]), sys.argv[2]
columns, rows = round(WIDTH / spacing), 2 * round(0.5 * LENGTH / spacing)
y = (np.arange(rows) - 0.5 * (rows - 1)) * LENGTH / rows
stretch = 1 + 2 * (RADIUS - np.sqrt(RADIUS**2 - y**2)) / WIDTH
columns_of_middle = (np.arange(columns) - 0.5 * (columns - 1)) * WIDTH / columns
x = 0.5 * WIDTH + np.outer(stretch, columns_of_middle)  # x = 0: the left side
cells = np.outer(stretch, np.full(columns, WIDTH / columns * LENGTH / rows * THICKNESS))
with open(file, "w") as out:
    for row in range(rows):
        for column in range(columns):
            out.write(f"{x[row, column] * 1e-3:.9e} {y[row] * 1e-3:.9e} 0 1 {cells[row, column] * 1e-9:.9e}\n")
