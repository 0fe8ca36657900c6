#!/usr/bin/python3
"""A compact tension specimen of square cells, for compact_tension.yaml; specimen.py SPACING_IN_MM FILE"""
import sys

import numpy as np

WIDTH, FRONT, HALF_HEIGHT, THICKNESS = 40.0, 10.0, 24.0, 3.2  # mm: W, 0.25 W, 0.6 W, B
PIN_HEIGHT, PIN_RADIUS = 11.0, 5.0  # mm: holes at x = 0, y = +- 0.275 W, of 0.25 W across

spacing = float(sys.argv[1])
x = np.arange(round((WIDTH + FRONT) / spacing)) * spacing + spacing / 2 - FRONT
half = np.arange(round(HALF_HEIGHT / spacing)) * spacing + spacing / 2
y = np.concatenate([-half[::-1], half])  # the crack lies between two rows
with open(sys.argv[2], "w") as file:
    for b in y:
        for a in x[np.hypot(x, abs(b) - PIN_HEIGHT) > PIN_RADIUS]:
            file.write(f"{a * 1e-3:.9g} {b * 1e-3:.9g} 0 1 {spacing**2 * THICKNESS * 1e-9:.12g}\n")
