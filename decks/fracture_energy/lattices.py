#!/usr/bin/python3
"""Points of a body of this scene on a lattice: lattices.py BODY LATTICE FILE. The lattice is cut off by the body's sides as it
comes, and each point has the volume of one of its cells."""
import sys

import numpy as np

HORIZON, THICKNESS = 1.5e-3, 1e-3  # m
# Lower left and upper right corner, m. The crack comes in along y = 0.
BODIES = {
    "strip": ((0.0, -7.5e-3), (30e-3, 7.5e-3)),
    "beam": ((0.0, -9e-3), (36e-3, 9e-3)),
    "pressed": ((0.0, -9e-3), (36e-3, 9e-3)),
    "notch": ((0.0, -21.5e-3), (24e-3, 21.5e-3)),
}
# Spacings a horizon, turn of the rows (degrees), jitter (spacings), angle between rows (degrees).
LATTICES = {
    "square_3": (3, 0, 0.0, 90),
    "square_4": (4, 0, 0.0, 90),
    "square_5": (5, 0, 0.0, 90),
    "turned_20": (3, 20, 0.0, 90),
    "turned_45": (3, 45, 0.0, 90),
    "jittered": (3, 0, 0.25, 90),
    "triangles": (3, 0, 0.0, 60),
}


def lattice_points(low, high, lattice, horizon=HORIZON, thickness=THICKNESS):
    """[n, 2] coordinates and the volume of each point, in the rectangle between two corners. No row of points lies on y = 0."""
    low, high = np.array(low), np.array(high)
    ratio, turn, jitter, angle = LATTICES[lattice]
    spacing, turn, angle = horizon / ratio, np.radians(turn), np.radians(angle)
    edge = spacing / np.sqrt(np.sin(angle))  # of a cell of the area spacing^2
    rows = edge * np.array([[1.0, 0.0], [np.cos(angle), np.sin(angle)]])
    reach = int(3 * max(np.linalg.norm(low), np.linalg.norm(high)) / edge)
    counts = np.stack(np.meshgrid(*[np.arange(-reach, reach + 1)] * 2), axis=-1).reshape(-1, 2)
    x = counts @ rows @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    # Half the distance of rows along the crack; where there are none, any shift.
    x += [0.5 * edge, 0.5 * edge * (np.sin(angle) if turn == 0.0 else np.sqrt(0.5))]
    x += jitter * spacing * np.random.default_rng(1).uniform(-1, 1, x.shape)
    x = x[np.all((x > low) & (x < high), axis=1)]
    return x[np.lexsort((x[:, 1], np.round(x[:, 0] / (1e-6 * spacing))))], spacing**2 * thickness


if __name__ == "__main__":
    coordinates, volume = lattice_points(*BODIES[sys.argv[1]], sys.argv[2])
    np.savetxt(sys.argv[3], [[*point, 0.0, 1, volume] for point in coordinates], fmt=["%.12g"] * 3 + ["%d", "%.12g"])
