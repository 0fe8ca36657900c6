#!/usr/bin/python3
"""map.png: lives and strengths over the depth of a pore; spacing.png: what the distance between points makes of them, and
pores that points resolve; plot.py [RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

YOUNG, LIMIT, DUCTILITY, EXPONENT = 110e9, 0.00231, 1.94, -0.865  # of the decks
STRESS, RUN_OUT = 400.0, 1e7  # MPa, cycles
SPACING, HORIZON = 0.6, 1.8  # mm, of the map
RADII, DEPTHS = (20, 50, 100), (0.26, 0.86, 1.46, 2.06, 2.66, 3.26, 3.86, 4.46, 5.06, 5.66, 6.26, 6.66)
HEIGHTS, SPACINGS = ("0.0", "0.14", "0.29"), (0.2, 0.3, 0.4, 0.6, 0.88, 1.2)
PUBLISHED = {20: (0.933, 0.994), 50: (0.813, 0.965), 100: (0.679, 0.917)}  # strength at 0.26 and 6.66 mm over that without a pore
COLORS = dict(zip(RADII, ("tab:blue", "tab:orange", "tab:red")))
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def life(name):
    with open(folder / f"{name}.csv") as file:
        return float(list(csv.DictReader(file))[-1]["time"])


def strain_of(cycles):
    """Amplitude of the strain of a bond that lives so many cycles."""
    return LIMIT + DUCTILITY * (2 * cycles)**EXPONENT


def life_of(strain):
    return 0.5 * ((strain - LIMIT) / DUCTILITY)**(1 / EXPONENT)


def strength(name):
    """Amplitude of stress, MPa, for 1e7 cycles: strains are in proportion to it."""
    return STRESS * strain_of(RUN_OUT) / strain_of(life(name))


def starts_at_pore(name, depth):
    """Whether all bonds that break first end beside the pore."""
    results = Results(folder / f"{name}.h5")
    broken = results.field("Cycles_To_First_Break", results.steps[-1]).ravel() > 0
    return np.all(np.abs(results.x[broken, :2] * 1e3 - (depth, 0.0)) < 1.5 * SPACING)


def far_strain(spacing):
    """Strain along the load in the middle of the specimen without a pore."""
    results = Results(folder / f"free_{spacing}.h5")
    x, y = (results.x[:, :2] * 1e3).T
    near = np.hypot(x - 6.6, y) < 2.0 * spacing
    return np.polyfit(y[near] * 1e-3, results.field("Displacement", results.steps[-1])[near, 1], 1)[0]


def strain_of_cells(name, spacing=SPACING):
    """Largest strain of bonds, up to a horizon long, between the mean displacements of the material in square cells."""
    results = Results(folder / f"{name}.h5")
    inside = np.max(np.abs(results.x[:, :2]), axis=1) < HORIZON * 1e-3
    cell = np.floor(results.x[inside, :2] / (spacing * 1e-3) + 1e-6).astype(int)
    cell -= cell.min(axis=0)
    shape = cell.max(axis=0) + 1
    index, weight = cell[:, 0] * shape[1] + cell[:, 1], results.volume[inside]
    u = results.field("Displacement", results.steps[-1])[inside, :2]
    mean = np.stack([np.bincount(index, weight * u[:, d]) / np.bincount(index, weight) for d in (0, 1)], 1).reshape(*shape, 2)
    largest = 0.0
    for i in range(-3, 4):
        for j in range(4):
            bond = np.array([i, j]) * spacing * 1e-3
            if 0 < i * i + j * j <= 9:
                first = mean[max(-i, 0):shape[0] - max(i, 0), :shape[1] - j]
                second = mean[max(i, 0):shape[0] - max(-i, 0), j:]
                largest = max(largest, np.max((second - first) @ bond) / (bond @ bond))
    return largest


def draw_map():
    figure, (of_life, of_strength) = figures.plt.subplots(1, 2, figsize=(12, 4.4), constrained_layout=True)
    whole = strength(f"free_{SPACING}")
    print(f"without a pore: {life(f'free_{SPACING}'):.0f} cycles, {whole:.1f} MPa")
    of_life.axhline(life(f"free_{SPACING}"), color="0.5", linestyle="--", label="no pore")
    for radius in RADII:
        color = COLORS[radius]
        lives = np.array([life(f"map_{radius}_{depth}") for depth in DEPTHS])
        at_pore = np.array([starts_at_pore(f"map_{radius}_{depth}", depth) for depth in DEPTHS])
        of_life.plot(DEPTHS, lives, color=color, linewidth=0.8)
        for where, style in ((at_pore, "full"), (~at_pore, "none")):
            of_life.plot(np.array(DEPTHS)[where], lives[where], "o", color=color, fillstyle=style)
        of_life.plot([], [], "o-", color=color, label=f"r = {radius} µm")
        strengths = np.array([strength(f"map_{radius}_{depth}") for depth in DEPTHS]) / whole
        of_strength.plot(DEPTHS, strengths, "o", color=color, markersize=5, label=f"r = {radius} µm")
        places = {}
        for height in HEIGHTS:
            files = folder.glob(f"place_{radius}_*_{height}.csv")
            for depth, name in sorted((float(file.stem.split("_")[2]), file.stem) for file in files):
                places.setdefault(depth, []).append(strength(name) / whole)
        depths, ratios = np.array(list(places)), np.array(list(places.values()))
        of_strength.fill_between(depths, ratios.min(axis=1), ratios.max(axis=1), color=color, alpha=0.2)
        for depth, value in zip((0.26, 6.66), PUBLISHED[radius]):
            of_strength.plot(depth, value, "x", color=color, markersize=9, markeredgewidth=2)
        print(f"r = {radius} um: lives", " ".join(f"{n:.0f}{'p' if p else 's'}" for n, p in zip(lives, at_pore)))
        print("  strengths over that without a pore:", np.round(strengths, 3), "published", PUBLISHED[radius])
        deep = depths > 2.0
        print(f"  over all places: 0.26 mm {ratios[0].min():.3f} to {ratios[0].max():.3f}, deeper than 2 mm {ratios[deep].min():.3f} to "
              f"{ratios[deep].max():.3f}; semicircle at the surface {strength(f'semicircle_{radius}') / whole:.3f}")
    of_strength.plot([], [], "x", color="0.3", label="published")
    of_life.plot([], [], "o", color="0.3", fillstyle="none", label="first bond at the surface")
    of_life.set_yscale("log")
    of_life.set_ylabel("life at 400 MPa (cycles)")
    of_strength.set_ylabel("strength at 1e7 cycles over that without a pore")
    for axis in (of_life, of_strength):
        axis.set_xlabel("depth of the pore (mm)")
        axis.grid(alpha=0.3, which="both")
        axis.legend(fontsize=8)
    figure.savefig(folder / "map.png", dpi=150)


def draw_spacing():
    figure, (of_strength, of_strain) = figures.plt.subplots(1, 2, figsize=(12, 4.4), constrained_layout=True)
    for radius in RADII:
        color = COLORS[radius]
        for depth, style, published in zip((0.26, 6.66), ("o-", "s--"), PUBLISHED[radius]):
            ratios = [strength(f"spacing_{spacing}_{radius}_{depth}") / strength(f"free_{spacing}") for spacing in SPACINGS]
            of_strength.plot(SPACINGS, ratios, style, color=color, fillstyle="full" if depth < 1 else "none",
                             label=f"r = {radius} µm, depth {depth} mm")
            of_strength.plot(1.27, published, "x", color=color, markersize=9, markeredgewidth=2)
            print(f"r = {radius} um, depth {depth} mm, spacings {SPACINGS} mm:", np.round(ratios, 3))
        strains = [strain_of(life(f"spacing_{spacing}_{radius}_6.66")) / far_strain(spacing) for spacing in SPACINGS]
        of_strain.plot(np.array(SPACINGS) / radius * 1e3, strains, "s", color=color, fillstyle="none", label=f"shares, r = {radius} µm")
        print("  largest strain of a bond over the far one, 6.66 mm deep:", np.round(strains, 3))
    resolved = {spacing: strain_of(life(f"local_{spacing}")) / (STRESS * 1e6 / YOUNG) for spacing in (0.05, 0.025, 0.0125)}
    of_strain.plot(np.array(list(resolved)) * 10, list(resolved.values()), "k^", label="resolved by points, r = 100 µm")
    print("resolved, three spacings a horizon:", {key: round(value, 3) for key, value in resolved.items()},
          {key: round(life(f"local_{key}"), 1) for key in resolved})
    of_strain.axhline(3.0, color="0.4", label="Kirsch")
    of_strain.set_xscale("log")
    of_strength.plot([], [], "x", color="0.3", label="published")
    of_strength.set_xlabel("distance between points (mm)")
    of_strength.set_ylabel("strength at 1e7 cycles over that without a pore")
    of_strain.set_xlabel("distance between points over the radius of the pore")
    of_strain.set_ylabel("largest strain of a bond over that far away")
    for axis in (of_strength, of_strain):
        axis.grid(alpha=0.3, which="both")
        axis.legend(fontsize=7)
    figure.savefig(folder / "spacing.png", dpi=150)


def print_controls():
    for name in ("Adaptive_0.6", "Intersection_0.6", "Intersection_0.1", "Intersection_0.075"):
        strain = strain_of_cells(f"whole_{name}")
        print(f"horizon {HORIZON} mm, {name}: strain between cells of {SPACING} mm {strain / (STRESS * 1e6 / YOUNG):.4f} of the far one, "
              f"life {life_of(strain):.0f}; first bond of all {life(f'same_{name}'):.1f}")
    known = strength("map_100_0.26")
    for stress in (155, 160, 170, 200, 250, 300):
        strain = strain_of(life("map_100_0.26")) * stress / STRESS
        print(f"{stress} MPa, r = 100 um, 0.26 mm deep: {life(f'stress_{stress}'):.6g} cycles; by the life at 400 MPa "
              f"{life_of(strain) if strain > LIMIT else RUN_OUT:.6g} (strength {known:.2f})")
    for radius in RADII:
        root_area = np.sqrt(np.pi) * radius
        print(f"Murakami, HV 350, r = {radius} um: " + ", ".join(
            f"{place} {factor * (350 + 120) / root_area**(1 / 6) / (1.6 * 350):.3f}"
            for place, factor in (("touching", 1.41), ("inside", 1.56))))


draw_map()
draw_spacing()
print_controls()
