"""A half-plane whose surface is y = A(x) = sum of a cos(k x + phase), strained along x by e: to first order in the
slopes a k.

Tractions vanish on y = A(x) where the even stress E e and the stress of the shear E e A'(x) on y = 0 add up (Gao, Int.
J. Solids Struct. 28 (1991) 703): with Airy's function -E e a y exp(k y) cos(k x + phase)

    s_xx = E e [1 - a k (2 + k y) exp(k y) cos(k x + phase)],   largest in the troughs: 1 + 2 a k.
"""
import numpy as np


def concentration(waves, x):
    """Strain along the surface over the far one."""
    return 1 + 2 * sum(-a * k * np.cos(k * x + phase) for a, k, phase in zip(*waves))
