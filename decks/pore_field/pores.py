#!/usr/bin/python3
"""Pores of a specimen, drawn at random: pores.py SEED FILE writes a line `x y z radius` each.

The number of pores is fixed; middles are even over the volume, so that some are cut by a side, as of a specimen that was
machined; radii are lognormal.
"""
import sys

import numpy as np

WIDTH, LENGTH = 2.0, 3.6  # mm, of the part with pores
NUMBER, MEDIAN, SCATTER = 100, 0.030, 0.45  # pores; mm; deviation of the logarithm of the radius


def pores(seed):
    """[n, 3] middles and [n] radii, mm; x = y = z = 0 is the middle of the specimen."""
    random = np.random.default_rng(seed)
    middles = random.uniform(-0.5, 0.5, (NUMBER, 3)) * (WIDTH, WIDTH, LENGTH)
    return middles, MEDIAN * np.exp(SCATTER * random.standard_normal(NUMBER))


if __name__ == "__main__":
    places, radii = pores(int(sys.argv[1]))
    np.savetxt(sys.argv[2], np.column_stack([places, radii]) * 1e-3, fmt="%.9e", header="x y z radius (m)")
