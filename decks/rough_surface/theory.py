"""A half-plane whose surface is y = A(x) = sum of a cos(k x + phase), strained along x by e: to first order in the slopes a k.

Tractions vanish on y = A(x) where the even stress E e and the stress of the shear E e A'(x) on y = 0 add up (Gao, Int. J.
Solids Struct. 28 (1991) 703): with Airy's function -E e a y exp(k y) cos(k x + phase)

    s_xx = E e [1 - a k (2 + k y) exp(k y) cos(k x + phase)],   largest in the troughs: 1 + 2 a k.
"""
import numpy as np

POISSON = 1.0 / 3.0  # of the deck; plane stress


def displacement(strain, waves, x, y):
    """u and v, of the shapes of x and y; lengths in one unit."""
    u, v = x.copy(), -POISSON * y
    for a, k, phase in zip(*waves):
        decay = a * np.exp(k * y)
        u -= decay * (2 + (1 + POISSON) * k * y) * np.sin(k * x + phase)
        v += decay * ((1 + POISSON) * (k * y - 1) + 2 * POISSON) * np.cos(k * x + phase)
    return strain * u, strain * v


def concentration(waves, x):
    """Strain along the surface over the far one."""
    return 1 + 2 * sum(-a * k * np.cos(k * x + phase) for a, k, phase in zip(*waves))


def bond_strains(strain, waves, spacing, columns, rows, reach, parts=12):
    """Largest strain of bonds, up to `reach` spacings long, between the mean displacements of the material in square cells,
    and where its middle is. columns, rows: edges of the cells; only those between the first and the last column."""
    fine = (np.arange(parts) + 0.5) / parts * spacing
    x = (columns[:-1, None] + fine).ravel()[:, None]
    y = (rows[:-1, None] + fine).ravel()[None, :]
    x, y = np.broadcast_arrays(x, y)
    surface = sum(a * np.cos(k * x + phase) for a, k, phase in zip(*waves))
    is_solid = y < surface
    shape = (len(columns) - 1, parts, len(rows) - 1, parts)
    share = is_solid.reshape(shape).mean(axis=(1, 3))
    u = np.stack([np.where(is_solid, part, 0.0).reshape(shape).mean(axis=(1, 3))
                  for part in displacement(strain, waves, x, y)], axis=-1)
    mean = u / np.where(share > 0, share, np.nan)[..., None]
    mean[share < 0.05] = np.nan  # cells that runs leave out
    largest, where = 0.0, None
    for i in range(-reach, reach + 1):
        for j in range(reach + 1):
            if not 0 < i * i + j * j <= reach * reach or (j == 0 and i < 0):
                continue
            bond = np.array([i, j]) * spacing
            first = mean[max(-i, 0):shape[0] - max(i, 0), :shape[2] - j]
            second = mean[max(i, 0):shape[0] - max(-i, 0), j:]
            strains = ((second - first) @ bond) / (bond @ bond)
            if np.nanmax(strains) > largest:
                largest = np.nanmax(strains)
                at = np.unravel_index(np.nanargmax(strains), strains.shape)
                where = columns[at[0] + max(-i, 0)] + 0.5 * spacing + 0.5 * bond[0], rows[at[1]] + 0.5 * spacing + 0.5 * bond[1]
    return largest, where
