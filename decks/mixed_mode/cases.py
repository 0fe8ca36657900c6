#!/usr/bin/python3
"""The cases of this scene: cases.py CASE [LOAD] prints the --set options of pdrun, one word a line, that make one of
dry.yaml or, with a constant LOAD (a multiple of the critical one), of hydrogen.yaml. CASE is the angle in degrees between crack
and load, or `shear` for mode II alone.

A crack of half length a at `angle` with the stress s has K_I = s sqrt(pi a) sin^2, K_II = s sqrt(pi a) sin cos.
"""
import sys

import numpy as np

YOUNG, POISSON, FRACTURE_ENERGY = 207.0e9, 0.29, 16476.0  # Pa, 1, J/m2
CASES = ("90", "75", "60", "45", "30", "shear")


def intensities(case):
    """K_I and K_II over s sqrt(pi a)."""
    if case == "shear":
        return 0.0, 1.0
    angle = np.radians(float(case))
    return np.sin(angle) ** 2, np.sin(angle) * np.cos(angle)


def kink(case):
    """Angle (degrees) to the crack in which the tangential stress is largest: K_I sin(k) + K_II (3 cos(k) - 1) = 0
    (Erdogan & Sih, J. Basic Eng. 85 (1963) 519)."""
    one, two = intensities(case)
    if abs(two) < 1e-12:
        return 0.0
    return np.degrees(2 * np.arctan((one - np.sqrt(one ** 2 + 8 * two ** 2)) / (4 * two)))


def critical_intensities(case):
    """K_I and K_II (Pa sqrt(m)) at which the largest tangential stress is that of mode I at K_I^2 = E G_c."""
    one, two = intensities(case)
    half = np.radians(kink(case)) / 2
    equivalent = np.cos(half) * (one * np.cos(half) ** 2 - 1.5 * two * np.sin(2 * half))
    return np.array([one, two]) / equivalent * np.sqrt(YOUNG * FRACTURE_ENERGY)


def displacements(case, load):
    """The field around the tip of a crack along x < 0 (Williams), u_x and u_y as functions of x and y. With kappa = (3 - nu)
    / (1 + nu) in plane stress, mu the shear modulus, r and theta about the tip, sqrt(2 r) cos(theta/2) = sqrt(r + x)."""
    shear_modulus, kappa = YOUNG / (2 * (1 + POISSON)), (3 - POISSON) / (1 + POISSON)
    one, two = critical_intensities(case) / (4 * shear_modulus * np.sqrt(np.pi))
    r, sign = "sqrt(x^2 + y^2)", "sign(y)"
    return (f"({one:.6e}*sqrt({r} + x)*({kappa:.6f} - x/{r}) + "
            f"{two:.6e}*{sign}*sqrt({r} - x)*({kappa + 2:.6f} + x/{r}))*{load}",
            f"({one:.6e}*{sign}*sqrt({r} - x)*({kappa:.6f} - x/{r}) - "
            f"{two:.6e}*sqrt({r} + x)*({kappa - 2:.6f} + x/{r}))*{load}")


if __name__ == "__main__":
    for coordinate, value in zip("XY", displacements(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "t")):
        for kind in ("Start", "Pull"):
            print(f"--set\nBoundary Conditions/{kind} {coordinate}/Value={value}")
