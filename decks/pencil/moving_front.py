"""Pencil electrode by finite volumes on a grid that stretches with the front; shares nothing with the library.

C = 0 at the mouth x = 0, front at x = s(t); metal: D C_x = s' (C_solid - C) at the front, where either s' = v, the speed of the
bare metal, or C = C_sat, whichever is slower. With r = x/s the volumes s dr hold s C dr and lose D C_r/s + r s' C.
"""
import numpy as np


def solve_tridiagonal(lower, diagonal, upper, right):
    """Thomas algorithm; lower[0] and upper[-1] are not used."""
    n = len(right)
    above, value = np.zeros(n), np.zeros(n)
    pivot = diagonal[0]
    value[0] = right[0] / pivot
    for k in range(1, n):
        above[k - 1] = upper[k - 1] / pivot
        pivot = diagonal[k] - lower[k] * above[k - 1]
        value[k] = (right[k] - lower[k] * value[k - 1]) / pivot
    for k in range(n - 2, -1, -1):
        value[k] -= above[k] * value[k + 1]
    return value


def depths(times, diffusivity, solid, saturation, speed, cells=40, growth=0.004, start=1e-7):
    """Depth s at `times` (rising, s), m; `speed` of the bare metal, m/s. Backward Euler, steps of `growth` t."""
    width = 1.0 / cells
    faces = width * np.arange(cells + 1)
    # Quasi-steady start, so small that it is soon forgotten.
    front = min(saturation, speed * start * solid / diffusivity)
    s, now = start, start / speed + 0.5 * start**2 * (solid - saturation) / (diffusivity * saturation)
    c = front * (faces[1:] - 0.5 * width)
    found = []
    for end in times:
        while now < end * (1.0 - 1e-12):
            h = min(growth * now, end - now)
            rate, isBare = speed, True
            for _ in range(40):
                after = s + h * rate
                d, wind = diffusivity / (after * width), rate * faces
                diagonal = np.full(cells, after * width / h + 2.0 * d)
                lower, upper = np.full(cells, -d), np.full(cells, -d)
                right = s * width / h * c
                # Faces that move with the grid take in what is there: central differences.
                diagonal[:-1] -= 0.5 * wind[1:-1]
                diagonal[1:] += 0.5 * wind[1:-1]
                upper[:-1] -= 0.5 * wind[1:-1]
                lower[1:] += 0.5 * wind[1:-1]
                diagonal[0] += d  # C = 0 half a cell away
                diagonal[-1] += d
                if isBare:  # 2 d (C_f - C) = rate (C_solid - C_f); C_f is taken over by the moving front: rate C_solid in all
                    share = 2.0 * d / (2.0 * d + rate)
                    diagonal[-1] -= 2.0 * d * share + rate * share
                    right[-1] += (2.0 * d + rate) * (1.0 - share) * solid
                else:
                    right[-1] += (2.0 * d + rate) * saturation
                guess = solve_tridiagonal(lower, diagonal, upper, right)
                if isBare:
                    if (2.0 * d * guess[-1] + rate * solid) / (2.0 * d + rate) <= saturation:
                        break
                    isBare = False
                    continue
                better = min(speed, 2.0 * d * (saturation - guess[-1]) / (solid - saturation))
                if abs(better - rate) < 1e-12 * speed:
                    break
                rate = better
            c, s, now = guess, after, now + h
        found.append(s)
    return np.array(found)
