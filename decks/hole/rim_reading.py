"""The strain at the rim of a hole, from displacements of points outside: what a lattice can say of a rim between its points."""
import numpy as np
from exact import Ellipse, displacement, strain

ORDERS = [k for k in range(-5, 6) if k != 0]


def free_hole(hole, places, order, factor):
    """z, phi, phi', phi'', psi and psi' by z at complex places: phi = factor zeta^order, and the psi that leaves the rim free,
    phi + w conj(phi'/w') + conj(psi) = 0 at |zeta| = 1, where conj(zeta) = 1/zeta (Muskhelishvili). With all orders, of both
    signs, any field beside a hole that nothing else touches is a sum of these."""
    z, zeta = hole.zeta(places.real, places.imag)
    c, m = hole.c, hole.m
    dw, ddw = c * (1 - m / zeta**2), 2 * c * m / zeta**3
    slope, bend = factor * order * zeta**(order - 1.0), factor * order * (order - 1) * zeta**(order - 2.0)
    dphi, mirrored, dmirrored = slope / dw, c * (1 / zeta + m * zeta), c * (m - 1 / zeta**2)
    ddphi = (bend * dw - slope * ddw) / dw**3
    psi = -np.conj(factor) * zeta**(-1.0 * order) - mirrored * dphi
    dpsi = (np.conj(factor) * order * zeta**(-order - 1.0) - dmirrored * dphi) / dw - mirrored * ddphi
    return z, factor * zeta**(1.0 * order), dphi, ddphi, psi, dpsi


def rim_of(hole, n=720):
    return hole.rim(2 * np.pi * np.arange(n) / n)


def distance_from(places, rim, farthest):
    """From the rim, m; of those that may be farther away than `farthest` only that they are."""
    result = np.full(len(places), np.inf)
    middle = np.mean(rim)
    near = np.abs(places - middle) < np.max(np.abs(rim - middle)) + farthest
    result[near] = np.min(np.abs(places[near][:, None] - rim[None]), axis=1)
    return result


def strain_at_rim(holes, which, x, y, u, reach):
    """Places on the rim of holes[which], and strains xx and yy there [n each]: of the field of a free hole whose displacements are
    the nearest to `u`, of points that are from one to three times `reach` away from it and as far from other holes."""
    hole, places = holes[which], x + 1j * y
    apart = [distance_from(places, rim_of(each), 4 * reach) for each in holes]
    used = (np.min(apart, axis=0) > reach) & (apart[which] < 3 * reach)
    terms = [(order, factor) for order in ORDERS for factor in (1.0, 1.0j)]
    size = 2 * hole.c
    away = (places[used] - hole.center) / size
    one, zero = np.ones(len(away)), np.zeros(len(away))
    columns = []
    for term in terms:
        z, phi, dphi, _, psi, _ = free_hole(hole, places[used], *term)
        columns.append(np.concatenate(displacement(z, phi, dphi, psi, hole.turn)))
    columns += [np.concatenate(rigid) for rigid in ((one, zero), (zero, one), (-away.imag, away.real))]
    matrix = np.column_stack(columns)
    scale = np.linalg.norm(matrix, axis=0)
    found = np.linalg.lstsq(matrix / scale, np.concatenate(u[used].T), rcond=1e-12)[0] / scale
    rim = rim_of(hole)
    xx, yy = np.zeros(len(rim)), np.zeros(len(rim))
    for amount, term in zip(found, terms):
        z, _, dphi, ddphi, _, dpsi = free_hole(hole, hole.center + (rim - hole.center) * (1 + 1e-9), *term)
        of_term = strain(z, dphi, ddphi, dpsi, hole.turn)
        xx, yy = xx + amount * of_term[0], yy + amount * of_term[1]
    return rim, xx, yy
