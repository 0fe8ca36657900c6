"""Where Abaqus puts nodes: *SYSTEM, cylindrical coordinates, and the placement of instances."""
import numpy as np

from .errors import MeshError


def cylindrical(x):
    """(r, angle in degrees, z) [n, 3] to Cartesian coordinates."""
    angle = np.radians(x[:, 1])
    return np.column_stack([x[:, 0] * np.cos(angle), x[:, 0] * np.sin(angle), x[:, 2]])


def axes_of(keyword):
    """(origin, axes [3, 3] row by row) of *SYSTEM: points a (origin), b (on the x axis), c (in the xy plane, towards
    y); without c a turn about z. None where there is no data, which ends an earlier system."""
    rows, counts = _rows(keyword, (6, 3))
    if not rows:
        return None
    a, b = rows[0][:3], rows[0][3:]
    if counts[0] <= 3:
        return a, np.eye(3)
    first = b - a
    towards = rows[1] - a if len(rows) > 1 else np.array([-first[1], first[0], 0.0])
    normal = np.cross(first, towards)
    if not np.linalg.norm(normal) > 0:
        raise MeshError(f"{keyword.place}: *SYSTEM: its points lie on a line")
    first, normal = first / np.linalg.norm(first), normal / np.linalg.norm(normal)
    return a, np.array([first, np.cross(normal, first), normal])


def moved(keyword):
    """The function that places the nodes of *INSTANCE: a translation, then a turn about the axis from a to b."""
    rows, _ = _rows(keyword, (3, 7))
    shift = rows[0] if rows else np.zeros(3)
    if len(rows) < 2:
        return lambda x: x + shift
    a, b, angle = rows[1][:3], rows[1][3:6], np.radians(rows[1][6])
    axis = b - a
    if not np.linalg.norm(axis) > 0:
        raise MeshError(f"{keyword.place_of(1)}: the axis of the turn has no length")
    axis = axis / np.linalg.norm(axis)
    cross = np.cross(np.eye(3), axis)  # v @ cross = v x axis (Rodrigues' formula)
    turn = np.eye(3) - np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)
    return lambda x: a + (x + shift - a) @ turn


def _rows(keyword, widths):
    """(the data lines as arrays of these widths, how many numbers each has); what is left out at the end is 0."""
    numbers, counts = keyword.table(float)
    if len(counts) > len(widths) or any(count > width for count, width in zip(counts, widths)):
        raise MeshError(f"{keyword.place}: *{keyword.name}: its data lines hold {widths[0]}, then {widths[1]} numbers")
    rows = np.split(numbers, np.cumsum(counts)[:-1]) if len(counts) else []
    return [np.pad(row, (0, width - len(row))) for row, width in zip(rows, widths)], counts
