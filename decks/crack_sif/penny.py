#!/usr/bin/python3
"""A round crack in an infinite body under tension across it, and its displacements as functions for a deck.
  penny.py RADIUS HEIGHT TILT     three functions of x, y and z: radius and height of the middle over the origin in mm,
                                  angle from z to the normal, in the plane of x and z, in degrees

Fabrikant, Applications of Potential Theory in Mechanics (1989), section 3.5, for pressure on the crack, and the even
strain: l1 and l2 are the half axes of the spheroids around the crack, rho the distance from its axis.
"""
import sys

import numpy as np

YOUNG, POISSON, STRESS = 100.0e9, 0.25, 100.0e6  # of the deck
SHEAR = 0.5 * YOUNG / (1 + POISSON)


def displacement(a, rho, z):
    """Along rho and along z, m, z >= 0; a, rho, z in m."""
    far, near = np.sqrt((a + rho)**2 + z**2), np.sqrt((a - rho)**2 + z**2)
    l1, l2 = np.minimum(0.5 * (far - near), a), np.maximum(0.5 * (far + near), a)
    inner, outer, angle = np.sqrt(a**2 - l1**2), np.sqrt(l2**2 - a**2), np.arcsin(a / l2)
    along = STRESS * rho / (2 * np.pi * SHEAR) * (
        (1 - 2 * POISSON) * (a * outer / l2**2 - angle) + 2 * a**2 * z * inner / (l2**2 * (l2**2 - l1**2)))
    across = STRESS / (np.pi * SHEAR) * (
        2 * (1 - POISSON) * (inner - z * angle) + z * (angle - a * outer / (l2**2 - l1**2)))
    return along - POISSON * STRESS / YOUNG * rho, across + STRESS / YOUNG * z


def intensity(a):
    """K all around, Pa m^0.5."""
    return 2 * STRESS * np.sqrt(a / np.pi)


def half_opening(a, rho):
    return 4 * (1 - POISSON**2) * STRESS / (np.pi * YOUNG) * np.sqrt(np.maximum(0, a**2 - rho**2))


def functions(a, height, tilt):
    """u_x, u_y and u_z as text. Away from the rim of the crack, where nothing is divided by 0."""
    c, s = f"{np.cos(tilt):.17g}", f"{np.sin(tilt):.17g}"
    n = f"({s}*x + {c}*z - ({height * np.cos(tilt):.17g}))"  # over the crack
    t = f"({c}*x - {s}*z + ({height * np.sin(tilt):.17g}))"  # along it
    rho, z = f"sqrt({t}^2 + y^2)", f"abs({n})"
    far, near = f"sqrt(({a:.17g} + {rho})^2 + {z}^2)", f"sqrt(({a:.17g} - {rho})^2 + {z}^2)"
    l1, l2 = f"min(0.5*({far} - {near}), {a:.17g})", f"max(0.5*({far} + {near}), {a:.17g})"
    inner, outer, angle = f"sqrt({a * a:.17g} - {l1}^2)", f"sqrt({l2}^2 - {a * a:.17g})", f"asin({a:.17g}/{l2})"
    along = (f"({STRESS / (2 * np.pi * SHEAR):.17g}*({1 - 2 * POISSON:.17g}*({a:.17g}*{outer}/{l2}^2 - {angle}) + "
             f"{2 * a * a:.17g}*{z}*{inner}/({l2}^2*({l2}^2 - {l1}^2))) - {POISSON * STRESS / YOUNG:.17g})")
    across = (f"({STRESS / (np.pi * SHEAR):.17g}*({2 * (1 - POISSON):.17g}*({inner} - {z}*{angle}) + "
              f"{z}*({angle} - {a:.17g}*{outer}/({l2}^2 - {l1}^2))) + {STRESS / YOUNG:.17g}*{z})*sign({n})")
    return [f"{c}*{along}*{t} + {s}*{across}", f"{along}*y", f"{c}*{across} - {s}*{along}*{t}"]


if __name__ == "__main__":
    radius, over, degrees = map(float, sys.argv[1:])
    print("\n".join(functions(radius * 1e-3, over * 1e-3, np.radians(degrees))))
