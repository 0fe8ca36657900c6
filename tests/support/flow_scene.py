"""Lattices on which flows are tested."""
import numpy as np

RATIO = 3.015  # horizon over spacing


def plane_lattice(low, high, spacing, shift=(0.0, 0.0), angle=0.0):
    """Lattice points, turned by `angle` degrees, within four spacings of a box: [n, 3]."""
    centre, reach = 0.5 * (np.array(low) + high), 0.5 * np.hypot(*(np.array(high) - low)) + 6 * spacing
    n = int(reach / spacing)
    i, j = np.meshgrid(np.arange(-n, n + 1), np.arange(-n, n + 1))
    base = np.floor(centre / spacing) * spacing if angle == 0.0 else centre
    local = np.column_stack([(i.ravel() + shift[0]) * spacing, (j.ravel() + shift[1]) * spacing])
    c, s = np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))
    points = base + local @ np.array([[c, s], [-s, c]])
    near = np.all((points > np.array(low) - 4 * spacing) & (points < np.array(high) + 4 * spacing), axis=1)
    return np.column_stack([points[near], np.zeros(np.count_nonzero(near))])
