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


def space_lattice(low, high, spacing, shift=(0.0, 0.0, 0.0), angles=(0.0, 0.0)):
    """Points of a cubic lattice, turned by `angles` (degrees) about z, then about x, within four spacings of a box."""
    low, high = np.array(low, float), np.array(high, float)
    turned = any(angles)
    centre = 0.5 * (low + high) if turned else np.floor(0.5 * (low + high) / spacing) * spacing
    n = int(0.5 * np.linalg.norm(high - low) / spacing) + 8
    steps = np.arange(-n, n + 1)
    local = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3) + np.array(shift)
    (c, s), (d, t) = ((np.cos(a), np.sin(a)) for a in np.deg2rad(angles))
    about_z, about_x = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]), np.array([[1, 0, 0], [0, d, -t], [0, t, d]])
    points = centre + spacing * local @ (about_x @ about_z).T
    return points[np.all((points > low - 4 * spacing) & (points < high + 4 * spacing), axis=1)]


def flow_deck(horizon, conditions, dimension=2, viscosity=0.05, solver=None, **more):
    """Of one fluid of density 1 on mesh.txt."""
    fluid = {"Material Model": "Navier Stokes", "Density": 1.0, "Viscosity": viscosity}
    deck = {
        "Discretization": {"Type": "Text File", "Input Mesh File": "mesh.txt"},
        "Materials": {"Fluid": {**fluid, "Plane Strain": True} if dimension == 2 else fluid},
        "Blocks": {"Fluid": {"Block Names": "block_1", "Material": "Fluid", "Horizon": horizon}},
        "Boundary Conditions": conditions,
        "Solver": {"Final Time": 1.0, "Steady Flow": solver or {}},
        "Output": {"Output Filename": "result", "Output Frequency": 1,
                   "Output Variables": ["Velocity", "Pressure", "Fluid", *more.pop("variables", [])]}}
    for section, content in more.items():
        deck[section.replace("_", " ")] = content
    return deck
