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
    points = _triples(keyword, 2, (3, 6))
    if not points:
        return None
    a, b = points[0][:3], points[0][3:]
    if not len(b):
        return a, np.eye(3)
    first = b - a
    towards = points[1] - a if len(points) > 1 else np.array([-first[1], first[0], 0.0])
    normal = np.cross(first, towards)
    if not np.linalg.norm(normal) > 0:
        raise MeshError(f"{keyword.place}: *SYSTEM: its points lie on a line")
    first, normal = first / np.linalg.norm(first), normal / np.linalg.norm(normal)
    return a, np.array([first, np.cross(normal, first), normal])


def moved(keyword):
    """The function that places the nodes of *INSTANCE: a translation, then a turn about the axis from a to b."""
    rows = _triples(keyword, 2, (3, 7))
    shift = rows[0][:3] if rows else np.zeros(3)
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


def _triples(keyword, most, widths):
    """The data lines as arrays of numbers. Fields at the end of a line may be left out: they are 0."""
    numbers, counts = keyword.table(float)
    rows = np.split(numbers, np.cumsum(counts)[:-1]) if len(counts) else []
    if len(rows) > most or any(len(row) > widths[-1] for row in rows):
        raise MeshError(f"{keyword.place}: *{keyword.name}: its data are not understood")
    width = widths[0] if rows and len(rows[0]) <= 3 else widths[-1]
    return [np.pad(row, (0, max(0, (width if i == 0 else 3) - len(row)))) for i, row in enumerate(rows)]
