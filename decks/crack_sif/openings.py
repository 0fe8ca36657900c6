"""Openings of the crack in results of this scene, and the stress intensity that they mean."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

YOUNG, STRESS, HALF_WIDTH = 100.0e9, 100.0e6, 25.0e-3  # of the deck


def exact(a):
    """K of a centre crack of the half length a, Pa m^0.5: the secant of eq. 20 of the source, and Tada's form (0.1 %)."""
    x = np.asarray(a) / HALF_WIDTH
    secant = np.sqrt(1.0 / np.cos(0.5 * np.pi * x))
    tada = (1.0 - 0.025 * x**2 + 0.06 * x**4) * secant
    return secant * STRESS * np.sqrt(np.pi * a), tada * STRESS * np.sqrt(np.pi * a)


def opening(name):
    """Places x along the crack, m, and half the opening between the rows of points above and below it, m."""
    results = Results(name)
    x, u = results.x, results.field("Displacement", results.steps[-1])
    row = np.min(np.abs(x[:, 1]))
    upper, lower = (np.flatnonzero(np.abs(x[:, 1] - side * row) < 0.1 * row) for side in (1.0, -1.0))
    upper, lower = (ids[np.argsort(x[ids, 0])] for ids in (upper, lower))
    return x[upper, 0], 0.5 * (u[upper, 1] - u[lower, 1])


def intensity(x, v, a, nearest=3.0e-3, farthest=9.0e-3):
    """K by extrapolation to the right tip: v = 4 K/E sqrt(r/2 pi) sqrt(1 - r/2a), r from the tip, the latter factor that
    of the whole ellipse; what is left is taken as linear in r."""
    r = a - x
    near = (r > nearest) & (r < farthest)
    r, v = r[near], v[near]
    k = 0.25 * YOUNG * v * np.sqrt(2.0 * np.pi / r) / np.sqrt(1.0 - 0.5 * r / a)
    return np.polyfit(r, k, 1)[1]
