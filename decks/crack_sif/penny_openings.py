"""penny.png: openings of round cracks in space, and the stress intensity that they mean."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402
from penny import half_opening, intensity  # noqa: E402

SPACING = 1.0e-3  # of the deck


def opening(folder, name, height, tilt):
    """Distances from the axis, m, and half the opening there: means over rings a spacing wide of the points within a
    spacing of the crack, above less below; and the exact one in the middle of each ring."""
    results = Results(folder / f"{name}.h5")
    normal = np.array([np.sin(tilt), 0.0, np.cos(tilt)])
    x = results.x - (0.0, 0.0, height)
    over = x @ normal
    rho = np.linalg.norm(x - over[:, None] * normal, axis=1)
    u = results.field("Displacement", results.steps[-1]) @ normal
    near = np.abs(over) < SPACING * 0.999
    ring = np.floor(rho / SPACING).astype(int)
    rows = []
    for k in range(1, 10):
        above, below = (near & (ring == k) & (sign * over >= 0) for sign in (1, -1))
        below &= over < 0
        if above.any() and below.any():
            rows.append((0.5 * (rho[above].mean() + rho[below].mean()), 0.5 * (u[above].mean() - u[below].mean())))
    return np.array(rows).T


def ratio_of(folder, name, a, height, tilt):
    """K over the exact one: what the opening is of the exact one, as linear in the distance from the rim, at the rim."""
    rho, v = opening(folder, name, height, tilt)
    r = a - rho
    used = (r > 0.25 * a) & (r < 0.9 * a)
    return np.polyfit(r[used], v[used] / half_opening(a, rho[used]), 1)[1]


def draw(folder):
    figure, (of_opening, of_radius) = figures.plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    radii = ("9.0", "9.25", "9.5", "9.75", "10.0")
    for rule, color, label in (("Adaptive", "tab:blue", "shares of bonds"), ("Intersection", "tab:orange", "intersection")):
        errors = [100 * (ratio_of(folder, f"penny_{a}_0_0_{rule}", 1e-3 * float(a), 0.0, 0.0) - 1) for a in radii]
        k = [(1 + error / 100) * intensity(1e-3 * float(a)) for error, a in zip(errors, radii)]
        print(f"{rule}: error of K, %, radii {radii} mm:", np.round(errors, 2), "monotone" if np.all(np.diff(k) > 0) else "not monotone")
        of_radius.plot([float(a) for a in radii], errors, "o-", color=color, fillstyle="none", label=label)
        tilts = [100 * (ratio_of(folder, f"penny_10.0_0_{tilt}_{rule}", 10e-3, 0.0, np.radians(tilt)) - 1) for tilt in (0, 20, 45)]
        print("  tilted by 0, 20, 45 degrees:", np.round(tilts, 2))
        of_radius.plot([10.03, 10.06], tilts[1:], "s", color=color, markersize=4,
                       label=f"{label}, tilted by 20 and 45 degrees")
        rho, v = opening(folder, f"penny_10.0_0_0_{rule}", 0.0, 0.0)
        of_opening.plot(rho * 1e3, v * 1e6, "o", color=color, fillstyle="none" if rule == "Adaptive" else "full",
                        markersize=6 if rule == "Adaptive" else 3, label=label)
    for height in ("0.5",):
        print(f"crack {height} spacings above the edge of cells: error of K, %",
              np.round(100 * (ratio_of(folder, f"penny_10.0_{height}_0_Adaptive", 10e-3, 1e-3 * float(height), 0.0) - 1), 2))
    rho = np.linspace(0, 10e-3, 400)
    of_opening.plot(rho * 1e3, half_opening(10e-3, rho) * 1e6, color="0.4", label="exact, a = 10 mm")
    of_opening.set_xlabel("distance from the axis (mm)")
    of_opening.set_ylabel("half the opening (µm)")
    of_radius.set_xlabel("radius of the crack (mm)")
    of_radius.set_ylabel("error of K (%)")
    for axis in (of_opening, of_radius):
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    figure.savefig(folder / "penny.png", dpi=150)
    print(folder / "penny.png")
