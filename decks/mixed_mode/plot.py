#!/usr/bin/python3
"""cracks.png: the cracks when their branches have grown to the length at which the kink is measured, and the kink angles
as a table; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

HALF_LENGTH, HORIZON = 0.01, 0.002
# The kink is the direction from the old tip to what has broken between half a horizon and two horizons from it: nearer
# lies the tip's own zone of damage, farther the crack has already turned across the load. It is measured when both
# branches have passed that ring, 4 horizons from the old tip.
INNER, OUTER, PASSED = 0.5 * HORIZON, 2 * HORIZON, 4 * HORIZON
THRESHOLD = 0.3


def maximum_tangential_stress(angle):
    """Kink (degrees) of a crack at `angle` with the load: K_I sin(k) + K_II (3 cos(k) - 1) = 0, K_I = sin^2, K_II =
    sin cos (Erdogan & Sih, J. Basic Eng. 85 (1963) 519)."""
    one, two = np.sin(np.radians(angle)) ** 2, np.sin(np.radians(angle)) * np.cos(np.radians(angle))
    return 0.0 if abs(two) < 1e-12 else -2 * np.degrees(
        np.arctan((np.sqrt(one ** 2 + 8 * two ** 2) - one) / (4 * two)))


def branches(results, step, direction):
    """For both tips: (kink in degrees, length) of what broke ahead of them, or None."""
    grown = results.field("Damage", step) - results.field("Damage", 0)
    found = []
    for sign in (1.0, -1.0):
        ahead = sign * np.array(direction)
        offset = results.x[:, :2] - HALF_LENGTH * ahead
        distance = np.linalg.norm(offset, axis=1)
        along = offset @ ahead
        across = offset @ np.array([-ahead[1], ahead[0]])
        chosen = (grown > THRESHOLD) & (distance < 1.5 * PASSED) & (along > -distance * 0.7)
        ring = chosen & (distance > INNER) & (distance < OUTER)
        if not ring.any():
            found.append(None)
            continue
        angle = np.degrees(np.arctan2(np.sum(across[ring] * grown[ring]), np.sum(along[ring] * grown[ring])))
        found.append((angle, distance[chosen].max()))
    return found


def measure(results, direction):
    """First step at which both branches are long enough: (step, kinks)."""
    for step in results.steps:
        found = branches(results, step, direction)
        if all(branch is not None and branch[1] > PASSED for branch in found):
            return step, [branch[0] for branch in found]
    return None, None


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
cases = [(f"{deck}_{angle}", f"{name}, crack at {angle}°", angle, maximum_tangential_stress(angle))
         for deck, name in (("dry", "dry"), ("hydrogen", "hydrogen")) for angle in (90, 75, 60, 45, 30)]
cases.append(("shear", "pure mode II", 90, -70.53))
panels = []
for name, label, angle, expected in cases:
    if not (folder / f"{name}.h5").exists():
        continue
    results = Results(folder / name)
    direction = (1.0, 0.0) if name == "shear" else (np.sin(np.radians(angle)), np.cos(np.radians(angle)))
    step, kinks = measure(results, direction)
    if step is None:
        print(f"{label}: the crack has not grown by {PASSED * 1e3:g} mm")
        continue
    print(f"{label}: kink {kinks[0]:+.1f} and {kinks[1]:+.1f} degrees, maximum tangential stress {expected:+.1f} or "
          f"{-expected:+.1f}, step {step}")
    panels.append((results, step, f"{label}: kink {np.mean(np.abs(kinks)):.0f}° (theory {abs(expected):.0f}°)"))
if panels:
    figure = figures.map_panels(panels, figures.View("Damage", limits=(0.0, 0.6)), columns=4)
    figure.savefig(folder / "cracks.png", dpi=110)
    print(folder / "cracks.png")
