#!/usr/bin/python3
"""The infinite plate with an elliptic hole under tension (Inglis; Muskhelishvili's potentials), and its displacements as
functions for a deck.
  exact.py X Y A B ANGLE HALF     two functions of x and y for the rim of a plate |x|, |y| < HALF; lengths in mm, ANGLE in
                                  degrees from x to the half axis A
"""
import sys

import numpy as np

YOUNG, POISSON, STRESS = 100.0e9, 1.0 / 3.0, 100.0e6  # of the deck; tension along y
SHEAR, KAPPA = 0.5 * YOUNG / (1 + POISSON), (3 - POISSON) / (1 + POISSON)


class Ellipse:
    """z = w(zeta) = c (zeta + m/zeta) in the coordinates of the axes of the hole."""

    def __init__(self, center, a, b, angle=0.0):
        self.center, self.turn = complex(*center), np.exp(1j * angle)
        self.c, self.m, self.e = 0.5 * (a + b), (a - b) / (a + b), np.exp(2j * (0.5 * np.pi - angle))

    def _zeta(self, x, y):
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
        z, zeta = self._zeta(x, y)
        phi, dphi, _, psi, _ = self._potentials(zeta)
        u = (KAPPA * phi - z * np.conj(dphi) - np.conj(psi)) / (2 * SHEAR) * self.turn
        return u.real, u.imag

    def strain(self, x, y):
        """xx and yy."""
        z, zeta = self._zeta(x, y)
        _, dphi, ddphi, _, dpsi = self._potentials(zeta)
        mean, shear = 2 * dphi.real, (np.conj(z) * ddphi + dpsi) / self.turn**2  # (s_yy - s_xx)/2 + i s_xy
        xx, yy = mean - shear.real, mean + shear.real
        return (xx - POISSON * yy) / YOUNG, (yy - POISSON * xx) / YOUNG


def functions(ellipse, half):
    """Displacements as functions of x and y near the rim of the plate: terms of 1/z fitted to them; and the largest misfit
    in parts of the largest displacement."""
    side = np.linspace(-half, half, 81)
    layers = [sign * part * half for sign in (-1, 1) for part in (0.95, 1.0)]
    along, across = np.tile(side, len(layers)), np.repeat(layers, len(side))
    x, y = np.concatenate([along, across]), np.concatenate([across, along])
    p, q = ellipse.center.real, ellipse.center.imag
    big_x, big_y = f"(x - ({p:.17g}))", f"(y - ({q:.17g}))"
    z, r2 = x - p + 1j * (y - q), f"({big_x}^2 + {big_y}^2)"
    # conj(z)^n, real and imaginary, as text
    powers = {1: (big_x, f"(-{big_y})"),
              3: (f"({big_x}^3 - 3*{big_x}*{big_y}^2)", f"({big_y}^3 - 3*{big_x}^2*{big_y})"),
              5: (f"({big_x}^5 - 10*{big_x}^3*{big_y}^2 + 5*{big_x}*{big_y}^4)",
                  f"(10*{big_x}^2*{big_y}^3 - 5*{big_x}^4*{big_y} - {big_y}^5)")}
    terms, columns = [f"{big_x}/{half:.17g}", f"{big_y}/{half:.17g}"], [z.real / half, z.imag / half]
    for n, texts in powers.items():
        for extra in (0,) if n == 1 else (0, 2):  # z^-n and |z|^2 z^-n
            scale = half**(n - extra)
            for text, value in zip(texts, (np.real(z**-n), np.imag(z**-n))):
                terms.append(f"{scale:.17g}*{text}/{r2}^{n - extra // 2}")
                columns.append(scale * value * np.abs(z)**extra)
    matrix, texts, misfit = np.column_stack(columns), [], 0.0
    for wanted in ellipse.displacement(x, y):
        factors = np.linalg.lstsq(matrix, wanted, rcond=None)[0]
        misfit = max(misfit, np.max(np.abs(matrix @ factors - wanted)) / np.max(np.abs(wanted)))
        texts.append(" + ".join(f"({factor:.17g})*{term}" for factor, term in zip(factors, terms)))
    return texts, misfit


if __name__ == "__main__":
    center_x, center_y, half_a, half_b, degrees, half_edge = map(float, sys.argv[1:])
    hole = Ellipse((center_x * 1e-3, center_y * 1e-3), half_a * 1e-3, half_b * 1e-3, np.radians(degrees))
    print("\n".join(functions(hole, half_edge * 1e-3)[0]))
