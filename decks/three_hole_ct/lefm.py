#!/usr/bin/python3
"""Linear elastic fracture mechanics for the specimens of this scene, by finite elements: an independent path and life
of a crack. lefm.py SPECIMEN FILE writes x, y, length (mm), K_I, K_II (MPa sqrt(m), at the load at 11.5 mm), cycles.

The crack grows by short straight steps in the direction of the largest tangential stress (Erdogan & Sih, J. Basic Eng.
85 (1963) 519), the body is meshed anew for each (quadratic triangles, gmsh), and K_I, K_II are interaction integrals
over a ring around the tip (Yau, Wang & Corten 1980, in domain form). Cycles follow by da/dN = C dK^m.
"""
import csv
import sys

import gmsh
import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

from specimen import FRONT, HALF_HEIGHT, HOLES, PINS, SPECIMENS, THICKNESS, WIDTH

YOUNG, POISSON = 211e3, 1.0 / 3.0  # MPa, 1; plane stress
SHEAR, KAPPA = YOUNG / (2 * (1 + POISSON)), (3 - POISSON) / (1 + POISSON)
HOOKE = YOUNG / (1 - POISSON**2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
PARIS, EXPONENT, RATIO, GRADIENT, START = 1.615e-8, 2.08, 0.1, 0.04, 11.5  # mm/cycle at 1 MPa sqrt(m), 1, 1, 1/mm, mm
GAUSS = ((1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3))


def mesh(crack, holes, finest):
    """Nodes [n, 2] and elements [m, 6] of a body that is cut along the line through the points `crack`, the first on
    its front."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    kernel, model = gmsh.model.occ, gmsh.model
    body = [(2, kernel.addRectangle(-FRONT, -HALF_HEIGHT, 0, WIDTH + FRONT, 2 * HALF_HEIGHT))]
    body, _ = kernel.cut(body, [(2, kernel.addDisk(x, y, 0, r, r)) for x, y, r in PINS + tuple(holes)])
    points = [kernel.addPoint(x, y, 0) for x, y in crack]
    lines = [(1, kernel.addLine(a, b)) for a, b in zip(points[:-1], points[1:])]
    _, parts = kernel.fragment(body, lines)
    kernel.synchronize()
    mouth = [tag for _, tag in model.getEntities(0) if np.allclose(model.getValue(0, tag, [])[:2], crack[0], atol=1e-6)]
    model.addPhysicalGroup(2, [tag for _, tag in model.getEntities(2)], 1)
    model.addPhysicalGroup(1, [tag for part in parts[len(body):] for dimension, tag in part if dimension == 1], 2)
    model.addPhysicalGroup(0, mouth, 3)
    x, y = crack[-1]
    model.mesh.field.add("MathEval", 1)
    model.mesh.field.setString(1, "F", f"Min(2.0, {finest} + 0.22*Sqrt((x - ({x}))^2 + (y - ({y}))^2))")
    model.mesh.field.setAsBackgroundMesh(1)
    for source in ("ExtendFromBoundary", "FromPoints", "FromCurvature"):
        gmsh.option.setNumber("Mesh.MeshSize" + source, 0)
    model.mesh.generate(2)
    model.mesh.setOrder(2)
    for key, value in (("Dimension", 1), ("PhysicalGroup", 2), ("OpenBoundaryPhysicalGroup", 3)):
        gmsh.plugin.setNumber("Crack", key, value)
    gmsh.plugin.run("Crack")
    tags, places, _ = model.mesh.getNodes()
    _, _, lists = model.mesh.getElements(2)
    gmsh.finalize()
    number = np.zeros(int(tags.max()) + 1, dtype=int)
    number[tags.astype(int)] = np.arange(len(tags))
    elements = number[np.concatenate(lists).astype(int)].reshape(-1, 6)
    used, elements = np.unique(elements, return_inverse=True)
    return places.reshape(-1, 3)[used, :2], elements.reshape(-1, 6)


def shapes(r, s):
    """Of quadratic triangles: values [6] and slopes [2, 6]."""
    t = 1 - r - s
    return (np.array([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * t * r, 4 * r * s, 4 * s * t]),
            np.array([[1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s],
                      [1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)]]))


def equilibrium(x, elements, load):
    """Displacements [n, 2] under `load` (N), and the Gauss points: weights (mm2), slopes [m, 2, 6], places [m, 2]."""
    n, m = len(x), len(elements)
    stiffness, points, bearing = np.zeros((m, 12, 12)), [], np.zeros((2, n))
    for r, s in GAUSS:
        values, slopes = shapes(r, s)
        jacobian = np.einsum("ki,eij->ekj", slopes, x[elements])
        gradient = np.linalg.inv(jacobian) @ slopes
        weight = np.linalg.det(jacobian) / 6
        strain = np.zeros((m, 3, 12))
        strain[:, 0, 0::2] = strain[:, 2, 1::2] = gradient[:, 0]
        strain[:, 1, 1::2] = strain[:, 2, 0::2] = gradient[:, 1]
        stiffness += np.einsum("eki,kl,elj,e->eij", strain, HOOKE, strain, weight) * THICKNESS
        place = np.einsum("i,eij->ej", values, x[elements])
        points.append((weight, gradient, place))
        for side, (a, b, radius) in enumerate(PINS):  # where a pin bears on its hole, as in the deck
            behind = (place[:, 1] - b) * np.sign(b)
            under = (np.hypot(place[:, 0] - a, place[:, 1] - b) < 1.2 * radius) & (behind > 0.4 * radius)
            np.add.at(bearing[side], elements[under], weight[under, None] * values)
    force = np.zeros(2 * n)
    force[1::2] = load * (bearing[0] / bearing[0].sum() - bearing[1] / bearing[1].sum())
    unknowns = np.stack([2 * elements, 2 * elements + 1], axis=-1).reshape(m, 12)
    rows, columns = np.repeat(unknowns, 12, axis=1).ravel(), np.tile(unknowns, (1, 12)).ravel()
    matrix = sparse.csc_matrix((stiffness.ravel(), (rows, columns)), shape=(2 * n, 2 * n))
    upper, lower = (np.argmin(np.hypot(x[:, 0] - WIDTH, x[:, 1] - y)) for y in (12.0, -12.0))
    free = np.setdiff1d(np.arange(2 * n), [2 * upper, 2 * upper + 1, 2 * lower])  # the loads balance: no reactions
    result = np.zeros(2 * n)
    result[free] = spsolve(matrix[free][:, free], force[free])
    return result.reshape(n, 2), points


def singular_gradient(mode, r, t):
    """u_i,j [n, 2, 2] of Williams' field for K = 1 MPa sqrt(mm), in the axes of the crack."""
    c, s, cosine, sine = np.cos(t / 2), np.sin(t / 2), np.cos(t), np.sin(t)
    if mode == 1:
        u = np.stack([c * (KAPPA - cosine), s * (KAPPA - cosine)], axis=1)
        slope = np.stack([-0.5 * s * (KAPPA - cosine) + c * sine, 0.5 * c * (KAPPA - cosine) + s * sine], axis=1)
    else:
        u = np.stack([s * (KAPPA + 2 + cosine), -c * (KAPPA - 2 + cosine)], axis=1)
        slope = np.stack([0.5 * c * (KAPPA + 2 + cosine) - s * sine, 0.5 * s * (KAPPA - 2 + cosine) + c * sine], axis=1)
    along, around = np.stack([cosine, sine], axis=1), np.stack([-sine, cosine], axis=1)
    scale = 1 / (2 * SHEAR * np.sqrt(2 * np.pi * r))
    return scale[:, None, None] * (0.5 * u[:, :, None] * along[:, None, :] + slope[:, :, None] * around[:, None, :])


def stress(gradient):
    """[n, 2, 2] of displacement gradients."""
    strain = np.stack([gradient[:, 0, 0], gradient[:, 1, 1], gradient[:, 0, 1] + gradient[:, 1, 0]], axis=1)
    s = strain @ HOOKE
    return np.stack([s[:, 0], s[:, 2], s[:, 2], s[:, 1]], axis=1).reshape(-1, 2, 2)


def intensities(crack, holes, load, finest=0.05, ring=(0.25, 0.65)):
    """K_I and K_II, MPa sqrt(m). `ring`: radii around the tip, mm."""
    x, elements = mesh(crack, holes, finest)
    displacement, points = equilibrium(x, elements, load)
    tip, back = np.array(crack[-1]), np.array(crack[-2])
    direction = (tip - back) / np.hypot(*(tip - back))
    axes = np.array([direction, [-direction[1], direction[0]]])
    sums = np.zeros(2)
    for weight, gradient, place in points:
        local = (place - tip) @ axes.T
        r = np.hypot(*local.T)
        inside = (r > ring[0]) & (r < ring[1])
        local, r, weight = local[inside], r[inside], weight[inside]
        slopes = np.einsum("ejk,ij->eik", gradient[inside], axes)
        own = np.einsum("eai,eka->eik", displacement[elements[inside]] @ axes.T, slopes)
        fall = -local / (r * (ring[1] - ring[0]))[:, None]  # the slope of q, 1 at the inner and 0 at the outer radius
        for mode in (1, 2):
            other = singular_gradient(mode, r, np.arctan2(local[:, 1], local[:, 0]))
            mutual = np.einsum("eij,eij->e", stress(own), other)
            flux = np.einsum("eij,ei,ej->e", stress(own), other[:, :, 0], fall) + np.einsum(
                "eij,ei,ej->e", stress(other), own[:, :, 0], fall)
            sums[mode - 1] += np.sum(weight * (flux - mutual * fall[:, 0]))
    return sums * YOUNG / 2 / np.sqrt(1000)


def grow(crack, holes, load, step, done):
    """Points of the crack, and K_I, K_II at each from the second on, until done(tip) or a hole is nearer than 1 mm."""
    crack, found = list(crack), []
    while True:
        wide = len(found) == 0  # the cut is long and straight
        one, two = intensities(crack, holes, load, ring=(0.4, 1.0) if wide else (0.25, 0.65))
        found.append((one, two))
        tip, back = np.array(crack[-1]), np.array(crack[-2])
        if done(tip) or any(np.hypot(tip[0] - x, tip[1] - y) - r < 1.0 for x, y, r in holes):
            return np.array(crack[1:]), np.array(found)
        kink = 2 * np.arctan((one - np.sqrt(one**2 + 8 * two**2)) / (4 * two)) if two != 0 else 0.0
        c, s = np.cos(kink), np.sin(kink)
        crack.append(tuple(tip + step * np.array([[c, -s], [s, c]]) @ (tip - back) / np.hypot(*(tip - back))))


def main(specimen, file):
    height, holes, load = SPECIMENS[specimen]
    tips, found = grow([(-FRONT, height), (8.0, height)], holes, load, 0.75, lambda tip: tip[0] > 30.0)
    lengths = 8.0 + 0.75 * np.arange(len(tips))
    ranges = (1 - RATIO) * np.hypot(*found.T) * np.exp(GRADIENT * (lengths - START))
    fine = np.linspace(lengths[0], lengths[-1], 2000)
    slowness = 1 / (PARIS * np.interp(fine, lengths, ranges)**EXPONENT)
    cycles = np.concatenate([[0], np.cumsum(0.5 * (slowness[1:] + slowness[:-1]) * np.diff(fine))])
    with open(file, "w", newline="") as out:
        rows = csv.writer(out)
        rows.writerow(["x", "y", "length", "K_I", "K_II", "cycles"])
        for tip, length, (one, two) in zip(tips, lengths, found):
            rows.writerow([f"{value:.6g}" for value in (*tip, length, one, two, np.interp(length, fine, cycles))])


if __name__ == "__main__":
    main(*sys.argv[1:])
