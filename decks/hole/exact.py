#!/usr/bin/python3
"""The infinite plate with elliptic holes under tension along y (Muskhelishvili's potentials; of one hole Inglis'), and its
displacements as functions for a deck.
  exact.py HALF X Y A B ANGLE ...     two functions of x and y for the rim of a plate |x|, |y| < HALF; lengths in mm, ANGLE
                                      in degrees from x to the half axis A; five numbers a hole
"""
import math
import sys

import numpy as np

YOUNG, POISSON, STRESS = 100.0e9, 1.0 / 3.0, 100.0e6  # of the deck; tension along y
SHEAR, KAPPA = 0.5 * YOUNG / (1 + POISSON), (3 - POISSON) / (1 + POISSON)


def displacement(z, phi, dphi, psi, turn=1.0):
    """u, v, m, from potentials in axes that are turned by `turn`."""
    u = (KAPPA * phi - z * np.conj(dphi) - np.conj(psi)) / (2 * SHEAR) * turn
    return u.real, u.imag


def strain(z, dphi, ddphi, dpsi, turn=1.0):
    """xx and yy, the same."""
    mean, shear = 2 * dphi.real, (np.conj(z) * ddphi + dpsi) / turn**2  # (s_yy - s_xx)/2 + i s_xy
    xx, yy = mean - shear.real, mean + shear.real
    return (xx - POISSON * yy) / YOUNG, (yy - POISSON * xx) / YOUNG


class Ellipse:
    """z = w(zeta) = c (zeta + m/zeta) in the coordinates of the axes of the hole."""

    def __init__(self, center, a, b, angle=0.0):
        self.center, self.turn = complex(*center), np.exp(1j * angle)
        self.c, self.m, self.e = 0.5 * (a + b), (a - b) / (a + b), np.exp(2j * (0.5 * np.pi - angle))

    def rim(self, angle):
        """z at zeta = exp(i angle)."""
        zeta = np.exp(1j * np.asarray(angle))
        return self.center + self.turn * self.c * (zeta + self.m / zeta)

    def zeta(self, x, y):
        """z and zeta of places."""
        z = (np.asarray(x) + 1j * np.asarray(y) - self.center) / self.turn
        root = np.sqrt(z**2 - 4 * self.c**2 * self.m + 0j)
        root = np.where(np.real(root * np.conj(z)) < 0, -root, root)
        return z, (z + root) / (2 * self.c)

    def _potentials(self, zeta):
        """phi, phi' and phi'', psi and psi', by z."""
        c, m, e = self.c, self.m, self.e
        k, f = 0.25 * STRESS * c, 1 - m * e + m**2
        dw, ddw = c * (1 - m / zeta**2), 2 * c * m / zeta**3
        phi, dphi, ddphi = k * (zeta + (2 * e - m) / zeta), k * (1 - (2 * e - m) / zeta**2), 2 * k * (2 * e - m) / zeta**3
        top, dtop = f * zeta**2 - e, 2 * f * zeta
        bottom, dbottom = zeta**3 - m * zeta, 3 * zeta**2 - m
        psi = -2 * k * (np.conj(e) * zeta + top / bottom)
        dpsi = -2 * k * (np.conj(e) + (dtop * bottom - top * dbottom) / bottom**2)
        return phi, dphi / dw, (ddphi * dw - dphi * ddw) / dw**3, psi, dpsi / dw

    def displacement(self, x, y):
        """u, v, m; no rigid motion."""
        z, zeta = self.zeta(x, y)
        phi, dphi, _, psi, _ = self._potentials(zeta)
        return displacement(z, phi, dphi, psi, self.turn)

    def strain(self, x, y):
        """xx and yy."""
        z, zeta = self.zeta(x, y)
        _, dphi, ddphi, _, dpsi = self._potentials(zeta)
        return strain(z, dphi, ddphi, dpsi, self.turn)


class Holes:
    """Several elliptic holes. phi = S z/4 + sum of a_jk zeta_j^-k and psi = S z/2 + sum of b_jk zeta_j^-k over the holes j,
    with zeta_j as of Ellipse: the terms are those that make phi + z conj(phi') + conj(psi), the force that the material
    passes on from its start on a rim, constant along each rim, by least squares. `residual`: how far it is from that, in
    parts of the load on half a hole."""

    def __init__(self, holes, n_terms=40):
        self.holes, self.n_terms = holes, n_terms
        n_places = 8 * n_terms
        z = [hole.rim(2 * np.pi * (np.arange(n_places) + 0.5) / n_places) for hole in holes]
        where, of_hole = np.concatenate(z), np.repeat(np.eye(len(holes)), n_places, axis=0)
        f, df, _ = self._terms(where)
        along = where[:, None] * np.conj(df)
        columns = np.hstack([f + along, 1j * (f - along), np.conj(f), -1j * np.conj(f), -of_hole, -1j * of_hole])
        wanted = -(0.25 * STRESS * 2 * where + 0.5 * STRESS * np.conj(where))
        matrix, right = np.vstack([columns.real, columns.imag]), np.concatenate([wanted.real, wanted.imag])
        scale = np.linalg.norm(matrix, axis=0)
        found = np.linalg.lstsq(matrix / scale, right, rcond=1e-15)[0] / scale
        self.residual = np.max(np.abs(matrix @ found - right)) / (STRESS * max(abs(hole.rim(0.0) - hole.center) for hole in holes))
        n = f.shape[1]
        self.a, self.b = found[:n] + 1j * found[n:2 * n], found[2 * n:3 * n] + 1j * found[3 * n:4 * n]

    def _terms(self, z):
        """zeta_j^-k and its two derivatives by z: [places, holes times terms]."""
        k = np.arange(1, self.n_terms + 1)
        columns = ([], [], [])
        for hole in self.holes:
            zeta = hole.zeta(z.real, z.imag)[1][..., None]
            dw, ddw = hole.c * (1 - hole.m / zeta**2) * hole.turn, 2 * hole.c * hole.m / zeta**3 * hole.turn
            first, second = -k * zeta**(-k - 1.0), k * (k + 1) * zeta**(-k - 2.0)
            columns[0].append(zeta**(-1.0 * k))
            columns[1].append(first / dw)
            columns[2].append((second - first * ddw / dw) / dw**2)
        return [np.concatenate(column, axis=-1) for column in columns]

    def _potentials(self, z):
        f, df, ddf = self._terms(z)
        return (0.25 * STRESS * z + f @ self.a, 0.25 * STRESS + df @ self.a, ddf @ self.a, 0.5 * STRESS * z + f @ self.b,
                0.5 * STRESS + df @ self.b)

    def displacement(self, x, y):
        z = np.asarray(x) + 1j * np.asarray(y)
        phi, dphi, _, psi, _ = self._potentials(z)
        return displacement(z, phi, dphi, psi)

    def strain(self, x, y):
        z = np.asarray(x) + 1j * np.asarray(y)
        _, dphi, ddphi, _, dpsi = self._potentials(z)
        return strain(z, dphi, ddphi, dpsi)


def conjugate_power(n, x, y):
    """(x - iy)^n, real and imaginary part, as text."""
    parts = ([], [])
    for k in range(n + 1):
        sign = (1, -1, -1, 1)[k % 4]  # of (-i)^k
        parts[k % 2].append(f"{sign * math.comb(n, k):+d}*{x}^{n - k}*{y}^{k}")
    return ["(" + "".join(part) + ")" for part in parts]


def functions(plate, center, half, order=9):
    """Displacements as functions of x and y near the rim of the plate: terms of 1/z fitted to them; and the largest misfit
    in parts of the largest displacement."""
    side = np.linspace(-half, half, 81)
    layers = [sign * part * half for sign in (-1, 1) for part in (0.95, 1.0)]
    along, across = np.tile(side, len(layers)), np.repeat(layers, len(side))
    x, y = np.concatenate([along, across]), np.concatenate([across, along])
    p, q = center.real, center.imag
    big_x, big_y = f"(x - ({p:.17g}))", f"(y - ({q:.17g}))"
    z, r2 = x - p + 1j * (y - q), f"({big_x}^2 + {big_y}^2)"
    terms, columns = [f"{big_x}/{half:.17g}", f"{big_y}/{half:.17g}"], [z.real / half, z.imag / half]
    for n in range(1, order + 1):
        for extra in (0,) if n < 3 else (0, 2):  # z^-n and |z|^2 z^-n
            scale = half**(n - extra)
            for text, value in zip(conjugate_power(n, big_x, big_y), (np.real(z**-n), np.imag(z**-n))):
                terms.append(f"{scale:.17g}*{text}/{r2}^{n - extra // 2}")
                columns.append(scale * value * np.abs(z)**extra)
    matrix, texts, misfit = np.column_stack(columns), [], 0.0
    for wanted in plate.displacement(x, y):
        factors = np.linalg.lstsq(matrix, wanted, rcond=None)[0]
        misfit = max(misfit, np.max(np.abs(matrix @ factors - wanted)) / np.max(np.abs(wanted)))
        least = 1e-10 * np.max(np.abs(factors))
        texts.append(" + ".join(f"({factor:.17g})*{term}" for factor, term in zip(factors, terms) if abs(factor) > least))
    return texts, misfit


def plate_with(numbers):
    """The plate with holes of five numbers each, in mm and degrees, and the middle of the holes."""
    holes = [Ellipse((x * 1e-3, y * 1e-3), a * 1e-3, b * 1e-3, np.radians(degrees))
             for x, y, a, b, degrees in np.reshape(numbers, (-1, 5))]
    return holes[0] if len(holes) == 1 else Holes(holes), np.mean([hole.center for hole in holes])


if __name__ == "__main__":
    half_edge, *numbers = map(float, sys.argv[1:])
    print("\n".join(functions(*plate_with(numbers), half_edge * 1e-3)[0]))
