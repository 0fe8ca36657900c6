#!/usr/bin/python3
"""Pairs of cells for neighbours.yaml, and the exact share of a bond that a crack along their common edge leaves.
  neighbours.py mesh FILE       80 times two rows of four points 1 mm apart, 5 mm from pair to pair
  neighbours.py cracks [PARTS]  their cracks, along (k + 1/2)/80 of the edge of pair k, as an entry of a deck; in PARTS
                                straight parts each
"""
import itertools
import sys

import numpy as np

N, EDGE, DISTANCE = 80, 1.0e-3, 5.0e-3


def lengths():
    """Of the parts of the common edges that are cut, in edges."""
    return (np.arange(N) + 0.5) / N


def exact_share(a):
    """Where a connection crosses the edge at (1 - w) y_p + w y_q, y_p and y_q uniform in [0, 1], w = x_p/(x_p + x_q) has the
    density 1/(2 (1 - w)^2) below 1/2, and so mirrored above; a as of lengths()."""
    def square(x):
        return np.maximum(x, 0.0)**2
    w = 0.5 * (np.arange(20000) + 0.5) / 20000
    a = np.asarray(a)[:, None]
    below = (square(a) - square(a - w) - square(a - 1 + w) + square(a - 1)) / (2 * w * (1 - w))
    return 1.0 - np.mean(below / (1 - w)**2, axis=1) * 0.5


if __name__ == "__main__":
    if sys.argv[1] == "mesh":
        with open(sys.argv[2], "w") as file:
            for k in range(N):
                for row, x in itertools.product((-1, 0), (-1.5, -0.5, 0.5, 1.5)):
                    file.write(f"{x * EDGE:.17g} {k * DISTANCE + row * EDGE:.17g} 0.0 1 {EDGE**3:.17g}\n")
    else:
        entries = []
        for k, a in enumerate(lengths()):
            ends = np.concatenate([[-1.5], np.arange(1, int(sys.argv[2]) if len(sys.argv) > 2 else 1) * a / 2, [a]])
            points = ", ".join(f"0.0, {k * DISTANCE + (end - 0.5) * EDGE:.12g}" for end in ends)
            entries.append(f"Crack {k}: {{Type: Polyline, Points: [{points}]}}")
        print("{" + ", ".join(entries) + "}")
