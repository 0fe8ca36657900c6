#!/usr/bin/python3
"""Mesh of film.yaml and its node sets: metal, a film that random pits pierce, electrolyte; pits.py [THICKNESS] [FOLDER]"""
import sys
from pathlib import Path

import numpy as np

SPACING, SHAPE, SEA_LAYERS = 1e-6, (128, 128, 64), 4


def pits(count=20, margin=12e-6, seed=1):
    """Centres [count, 2] and radii (m); pits may overlap."""
    rng = np.random.default_rng(seed)
    return rng.uniform(margin, SHAPE[0] * SPACING - margin, (count, 2)), rng.uniform(2e-6, 4e-6, count)


def in_a_pit(x, y):
    centres, radii = pits()
    inside = np.zeros(np.shape(x), bool)
    for (cx, cy), radius in zip(centres, radii):
        inside |= (x - cx)**2 + (y - cy)**2 < radius**2
    return inside


def write_mesh(thickness, folder):
    layers = round(thickness / SPACING)
    z, y, x = ((np.arange(n) + 0.5) * SPACING for n in reversed(SHAPE))
    z -= (SHAPE[2] - layers - SEA_LAYERS) * SPACING
    z, y, x = (a.ravel() for a in np.meshgrid(z, y, x, indexing="ij"))
    isFilm = (z > 0) & (z < layers * SPACING) & ~in_a_pit(x, y)
    table = np.column_stack([x, y, z, np.where(isFilm, 2, 1), np.full(x.size, SPACING**3)])
    np.savetxt(folder / "film.txt", table, fmt=["%.7g"] * 3 + ["%d", "%.6g"])
    for name, chosen in (("film_nodes", isFilm), ("sea_nodes", z > layers * SPACING)):
        np.savetxt(folder / f"{name}.txt", np.flatnonzero(chosen) + 1, fmt="%d")


if __name__ == "__main__":
    write_mesh(float(sys.argv[1]) if len(sys.argv) > 1 else 1e-6, Path(sys.argv[2] if len(sys.argv) > 2 else "."))
