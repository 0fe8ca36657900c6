#!/usr/bin/python3
"""Pores of specimens, drawn at random: pores.py FIRST LAST FOLDER writes pores_SEED.txt for these seeds, a line
`x y z radius` each pore.

The number of pores is fixed; middles are even over the volume, so that some are cut by a side, as of a specimen that
was machined; radii are lognormal.
"""
import sys
from pathlib import Path

import numpy as np

WIDTH, LENGTH = 2.0, 3.6  # mm, of the part with pores
NUMBER, MEDIAN, SCATTER = 100, 0.030, 0.45  # pores; mm; deviation of the logarithm of the radius


def pores(seed):
    """[n, 3] middles and [n] radii, mm; x = y = z = 0 is the middle of the specimen."""
    random = np.random.default_rng(seed)
    middles = random.uniform(-0.5, 0.5, (NUMBER, 3)) * (WIDTH, WIDTH, LENGTH)
    return middles, MEDIAN * np.exp(SCATTER * random.standard_normal(NUMBER))


if __name__ == "__main__":
    for seed in range(int(sys.argv[1]), int(sys.argv[2]) + 1):
        places, radii = pores(seed)
        np.savetxt(Path(sys.argv[3]) / f"pores_{seed}.txt", np.column_stack([places, radii]) * 1e-3, fmt="%.9e",
                   header="x y z radius (m)")
