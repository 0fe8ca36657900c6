"""penny.png: openings of round cracks in space, and the stress intensity that they mean."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402
from penny import half_opening, intensity  # noqa: E402

SPACING = 1.0e-3  # of the deck


def opening(folder, name, height, tilt, spacing=SPACING):
    """Distances from the axis, m, and half the opening there: means over rings a spacing wide of the points within a
    spacing of the crack, above less below."""
    results = Results(folder / f"{name}.h5")
    normal = np.array([np.sin(tilt), 0.0, np.cos(tilt)])
    x = results.x - (0.0, 0.0, height)
    over = x @ normal
    rho = np.linalg.norm(x - over[:, None] * normal, axis=1)
    u = results.field("Displacement", results.steps[-1]) @ normal
    near = np.abs(over) < 1.001 * spacing
    ring = np.floor(rho / spacing).astype(int)
    rows = []
    for k in range(1, int(10e-3 / spacing)):
        # Points on the crack are above it, as for the run.
        above, below = (near & (ring == k) & part for part in (over > -1e-6 * spacing, over < -1e-6 * spacing))
        if above.any() and below.any():
            rows.append((0.5 * (rho[above].mean() + rho[below].mean()), 0.5 * (u[above].mean() - u[below].mean())))
    return np.array(rows).T


def ratios_of(folder, name, a, height=0.0, tilt=0.0, spacing=SPACING):
    """K over the exact one: what the opening is of the exact one, as linear in the distance from the rim, at the rim;
    and by the ellipse that the opening is nearest to, v^2 = c^2 (b^2 - rho^2), as c b^0.5."""
    rho, v = opening(folder, name, height, tilt, spacing)
    r = a - rho
    used = (r > 0.25 * a) & (r < 0.9 * a)
    at_rim = np.polyfit(r[used], v[used] / half_opening(a, rho[used]), 1)[1]
    slope, square = np.polyfit(rho[used]**2, v[used]**2, 1)
    exact = half_opening(a, 0.0) / a
    return at_rim, np.sqrt(-slope) * (-square / slope)**0.25 / (exact * np.sqrt(a))


def draw(folder):
    figure, (of_opening, of_radius) = figures.plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    radii = ("9.0", "9.25", "9.5", "9.75", "10.0")
    for rule, color, label in (("Adaptive", "tab:blue", "shares of bonds"),
                               ("Intersection", "tab:orange", "intersection")):
        straight = np.array([ratios_of(folder, f"penny_{a}_0_0_{rule}", 1e-3 * float(a)) for a in radii])
        tilted = np.array([ratios_of(folder, f"penny_10.0_0_{tilt}_{rule}", 10e-3, tilt=np.radians(tilt))
                           for tilt in ((20, 45) if rule == "Adaptive" else (20,))])
        k = straight * intensity(1e-3 * np.array([[float(a)] for a in radii]))
        grows = [("at each step" if np.all(np.diff(column) > 0) else "not at each step") for column in k.T]
        print(f"{rule}: error of K by extrapolation, %, radii {radii} mm:", np.round(100 * (straight[:, 0] - 1), 2),
              "grows", grows[0], "; tilted by 20 (45) degrees", np.round(100 * (tilted[:, 0] - 1), 2))
        print("  by the ellipse:", np.round(100 * (straight[:, 1] - 1), 2), "grows", grows[1], "; tilted",
              np.round(100 * (tilted[:, 1] - 1), 2))
        for column, style, how in ((0, "o-", "to the rim"), (1, "s--", "ellipse")):
            of_radius.plot([float(a) for a in radii], 100 * (straight[:, column] - 1), style, color=color,
                           fillstyle="none", label=f"{label}, {how}")
            of_radius.plot([10.05, 10.1][:len(tilted)], 100 * (tilted[:, column] - 1), style[0], color=color, markersize=4)
        rho, v = opening(folder, f"penny_10.0_0_0_{rule}", 0.0, 0.0)
        of_opening.plot(rho * 1e3, v * 1e6, "o", color=color, fillstyle="none" if rule == "Adaptive" else "full",
                        markersize=6 if rule == "Adaptive" else 3, label=label)
    for what, name, height, spacing in (("through points", "penny_10.0_0.5_0_Adaptive", 0.5e-3, SPACING),
                                        ("points 0.67 mm apart", "penny_0.667", 0.0, 2 / 3 * SPACING),
                                        ("points 0.5 mm apart", "penny_0.5", 0.0, 0.5 * SPACING)):
        ratios = np.array(ratios_of(folder, name, 10e-3, height, 0.0, spacing))
        print(f"crack {what}: error of K, %", np.round(100 * (ratios - 1), 2))
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
