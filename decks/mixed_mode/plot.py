#!/usr/bin/python3
"""kinks.png: angle of the branch against that of the load, with the theory's; branches.png: the branches on one mesh; and
the angles as a table; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from cases import CASES, kink  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.raster import Raster  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

HORIZON = 0.001  # m
# The kink is the slope of a straight line through what has broken between one and three horizons from the old tip, each
# point weighed by its damage: nearer lies the tip's own zone of damage. A slope does not ask where the line starts: the
# crack may leave the old one beside its tip.
INNER, OUTER = HORIZON, 3 * HORIZON
CRACKED = 0.3  # damage of a point beside a branch
FRINGE = 0.1  # damage below which a point is not of the branch
MESHES, SHOWN = (1, 2, 3), 2


def measure(results):
    """At the first step at which the branch has passed OUTER: (step, kink in degrees), or None."""
    x = results.x[:, :2]
    distance = np.hypot(x[:, 0], x[:, 1])
    for step in results.steps:
        grown = results.field("Damage", step) - results.field("Damage", 0)
        grown[x[:, 0] < -0.7 * distance] = 0.0  # the pre-crack's faces
        if not (grown[distance > OUTER] > CRACKED).any():
            continue
        ring = (distance > INNER) & (distance < OUTER)
        points, weights = x[ring], grown[ring]
        weights[weights < FRINGE] = 0.0
        mean = np.arctan2(*(weights @ points)[::-1])
        along = points @ [np.cos(mean), np.sin(mean)]
        across = points @ [-np.sin(mean), np.cos(mean)]
        slope = np.polyfit(along, across, 1, w=np.sqrt(weights))[0]  # polyfit squares its weights
        return step, np.degrees(mean + np.arctan(slope))
    return None


def draw(axis, results, step, case, title):
    """The surroundings of the tip, turned so that the load is vertical; dashed: the theory's kink."""
    turn = 0.0 if case == "shear" else np.pi / 2 - np.radians(float(case))
    rotation = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    x = results.x[:, :2] @ rotation
    size = 5 * HORIZON
    raster = Raster(x, results.spacing(), pixels=260, window=(np.full(2, -size), np.full(2, size)))
    image = axis.imshow(raster.image(results.field("Damage", step)), origin="lower", cmap="inferno", vmin=0, vmax=0.6,
                        extent=[value * 1e3 for value in raster.extent])
    angle = turn + np.radians(kink(case))
    ends = np.array([0.0, 4.5]) * HORIZON * 1e3
    axis.plot(ends * np.cos(angle), ends * np.sin(angle), "--", color="white", linewidth=0.8)
    axis.set_title(title, fontsize=8)
    axis.set_xticks([])
    axis.set_yticks([])
    return image


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
pictures, maps = figures.plt.subplots(2, len(CASES), figsize=(11, 4.2), constrained_layout=True)
figure, axis = figures.plt.subplots(figsize=(5.2, 3.8), constrained_layout=True)
axis.plot([0, 75], [0, 75], color="black", linewidth=0.8, label="maximum tangential stress")
for row, (deck, color, shift) in enumerate((("dry", "C0", -0.6), ("hydrogen", "C3", 0.6))):
    for case, panel in zip(CASES, maps[row]):
        found = {mesh: measure(Results(folder / f"{deck}_{case}_{mesh}")) for mesh in MESHES}
        # Towards the theory's side counts as positive; a crack straight ahead has no side.
        angles = np.array([-result[1] for result in found.values() if result])
        axis.plot(np.full(len(angles), abs(kink(case)) + shift), angles, ".", color=color, markersize=4)
        axis.plot([abs(kink(case)) + shift], [angles.mean()], "o", color=color, markerfacecolor="none",
                  label=deck if case == CASES[0] else None)
        print(f"{deck:9} {case:>5}: kink {angles.mean():5.1f}, standard deviation {angles.std(ddof=1):4.1f} degrees, "
              f"theory {abs(kink(case)):4.1f}; meshes {np.round(angles, 1)}")
        if found[SHOWN]:
            results = Results(folder / f"{deck}_{case}_{SHOWN}")
            name = "mode II" if case == "shear" else f"{case}°"
            image = draw(panel, results, found[SHOWN][0], case, f"{deck}, {name}: {-found[SHOWN][1]:.0f}° "
                                                                f"({abs(kink(case)):.0f}°)")
axis.set_xlabel("kink, theory (degrees)")
axis.set_ylabel("kink, measured (degrees)")
axis.grid(alpha=0.3)
axis.legend()
pictures.colorbar(image, ax=maps, shrink=0.8).set_label("Damage")
figure.savefig(folder / "kinks.png", dpi=110)
pictures.savefig(folder / "branches.png", dpi=110)
print(folder / "kinks.png", folder / "branches.png")
