#!/usr/bin/python3
"""The cases of this scene: cases.py ANGLE prints the --set options of pdrun, one word a line, that make one of
mixed_mode_fatigue.yaml; ANGLE is that between crack and load in degrees.

A crack of half length a at ANGLE with the stress s has K_I = s sqrt(pi a) sin^2, K_II = s sqrt(pi a) sin cos. All cases
have the same K_I^2 + K_II^2, and so the same energy release rate of the crack as cut.
"""
import sys

import numpy as np

YOUNG, POISSON, INTENSITY = 207.0e9, 1.0 / 3.0, 20.0e6  # Pa, 1, Pa sqrt(m)
ANGLES = (90, 75, 60, 45, 30)


def intensities(angle):
    """K_I and K_II, Pa sqrt(m)."""
    angle = np.radians(float(angle))
    return INTENSITY * np.array([np.sin(angle), np.cos(angle)])


def kink(angle):
    """Angle (degrees) to the crack in which the tangential stress is largest: K_I sin(k) + K_II (3 cos(k) - 1) = 0
    (Erdogan & Sih, J. Basic Eng. 85 (1963) 519)."""
    one, two = intensities(angle)
    if abs(two) < 1e-9 * one:
        return 0.0
    return np.degrees(2 * np.arctan((one - np.sqrt(one ** 2 + 8 * two ** 2)) / (4 * two)))


def displacements(angle):
    """The field around the tip of a crack along x < 0 (Williams), u_x and u_y as functions of x and y; with r and theta
    about the tip, sqrt(2 r) cos(theta/2) = sqrt(r + x)."""
    shear_modulus, kappa = YOUNG / (2 * (1 + POISSON)), (3 - POISSON) / (1 + POISSON)
    one, two = intensities(angle) / (4 * shear_modulus * np.sqrt(np.pi))
    r, sign = "sqrt(x^2 + y^2)", "sign(y)"
    return (f"{one:.6e}*sqrt({r} + x)*({kappa:.6f} - x/{r}) + {two:.6e}*{sign}*sqrt({r} - x)*({kappa + 2:.6f} + x/{r})",
            f"{one:.6e}*{sign}*sqrt({r} - x)*({kappa:.6f} - x/{r}) - {two:.6e}*sqrt({r} + x)*({kappa - 2:.6f} + x/{r})")


if __name__ == "__main__":
    for coordinate, value in zip("XY", displacements(sys.argv[1])):
        print(f"--set\nBoundary Conditions/Pull {coordinate}/Value={value}")
