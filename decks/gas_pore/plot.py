#!/usr/bin/python3
"""map.png: lives and strengths over the depth of a pore; spacing.png: what the distance between points makes of them,
and pores that points resolve; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path[:0] = [str(Path(__file__).resolve().parents[2] / "meshes"), str(Path(__file__).resolve().parents[1] / "cumulative_fatigue")]

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from relation import LIMITS, YOUNG, amplitude  # noqa: E402
from relation import life as life_of_range  # noqa: E402

LIMIT, STRESS, RUN_OUT = LIMITS["254"], 400.0, 1e7  # MPa, cycles
SPACING, HORIZON = 0.64, 1.92  # mm, of the map
RADII = (20, 50, 100)  # um
DEPTHS = ("0.26", "0.90", "1.54", "2.18", "2.82", "3.46", "4.10", "4.74", "5.38", "6.02", "6.66")  # mm
HEIGHTS, SPACINGS = ("0.0", "0.31"), (0.21, 0.32, 0.42, 0.64, 0.84, 1.12)  # mm
# Strength at 0.26 and 6.66 mm over that without a pore.
PUBLISHED = {20: (0.933, 0.994), 50: (0.813, 0.965), 100: (0.679, 0.917)}
COLORS = dict(zip(RADII, ("tab:blue", "tab:orange", "tab:red")))
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def life(name):
    return read_history(folder / name)["time"][-1]


def strength(name):
    """Amplitude of stress, MPa, for 1e7 cycles: strains are in proportion to it."""
    return STRESS * amplitude(RUN_OUT) / amplitude(life(name))


def starts_at_pore(name, depth):
    """Whether all bonds that break first end beside the pore."""
    results = Results(folder / f"{name}.h5")
    broken = results.field("Cycles_To_First_Break", results.steps[-1]).ravel() > 0
    return np.all(np.abs(results.x[broken, :2] * 1e3 - (float(depth), 0.0)) < 1.5 * SPACING)


def far_strain(spacing):
    """Strain along the load in the middle of the specimen without a pore."""
    results = Results(folder / f"free_{spacing}.h5")
    x, y = (results.x[:, :2] * 1e3).T
    near = np.hypot(x - 6.72, y) < 2.0 * spacing
    return np.polyfit(y[near] * 1e-3, results.field("Displacement", results.steps[-1])[near, 1], 1)[0]


def means_of_cells(name):
    """[columns, rows, 2] mean displacement of the material in square cells of the map's spacing, m."""
    results = Results(folder / f"{name}.h5")
    inside = np.max(np.abs(results.x[:, :2]), axis=1) < HORIZON * 1e-3
    cell = np.floor(results.x[inside, :2] / (SPACING * 1e-3) + 1e-6).astype(int)
    cell -= cell.min(axis=0)
    shape = cell.max(axis=0) + 1
    index, weight = cell[:, 0] * shape[1] + cell[:, 1], results.volume[inside]
    u = results.field("Displacement", results.steps[-1])[inside, :2]
    sums = np.stack([np.bincount(index, weight * u[:, d]) for d in (0, 1)], 1)
    return (sums / np.bincount(index, weight)[:, None]).reshape(*shape, 2)


def strain_of_cells(name):
    """Largest strain of bonds, up to a horizon long, between cells."""
    mean = means_of_cells(name)
    shape = mean.shape
    largest = 0.0
    for i in range(-3, 4):
        for j in range(4):
            bond = np.array([i, j]) * SPACING * 1e-3
            if 0 < i * i + j * j <= 9:
                first = mean[max(-i, 0):shape[0] - max(i, 0), :shape[1] - j]
                second = mean[max(i, 0):shape[0] - max(-i, 0), j:]
                largest = max(largest, np.max((second - first) @ bond) / (bond @ bond))
    return largest


def opening_of_pore(name, far):
    """What the two columns beside the pore stretch by, more than far away, across the rows that it lies between: in
    parts of the far strain over a spacing."""
    y = means_of_cells(name)[..., 1]
    column, row = y.shape[0] // 2, y.shape[1] // 2
    return np.sum(y[column - 1:column + 1, row] - y[column - 1:column + 1, row - 1]) / (far * SPACING * 1e-3) - 2.0


def draw_lives(axis, radius, names, size):
    """Draws and returns depths, lives, and whether the first bond breaks at the pore."""
    depths = np.array([float(name.split("_")[2]) for name in names])
    lives = np.array([life(name) for name in names])
    at_pore = np.array([starts_at_pore(name, depth) for name, depth in zip(names, depths)])
    for where, style in ((at_pore, "full"), (~at_pore, "none")):
        axis.plot(depths[where], lives[where], "o", color=COLORS[radius], fillstyle=style, markersize=size,
                  markeredgewidth=0.7)
    return depths, lives, at_pore


def draw_places(of_life, of_strength, radius, whole):
    """Pores all over the cells, and what strengths come to at each depth."""
    ratios, starts = [], []
    for height in HEIGHTS:
        names = sorted(file.stem for file in folder.glob(f"place_{radius}_*_{height}.csv"))
        depths, _, at_pore = draw_lives(of_life, radius, names, 3)
        ratios.append([strength(name) / whole for name in names])
        starts.append(at_pore)
    least, largest = np.min(ratios, axis=0), np.max(ratios, axis=0)
    of_strength.fill_between(depths, least, largest, color=COLORS[radius], alpha=0.2)
    at_surface, deep = ~np.array(starts), depths > 2.0
    print(f"  all places: strength over that without a pore {least[0]:.3f} to {largest[0]:.3f} at 0.26 mm, "
          f"{least[deep].min():.3f} to {largest[deep].max():.3f} deeper than 2 mm, least {least.min():.3f}")
    print(f"  surface first: {np.mean(at_surface[:, deep]):.0%} of the places deeper than 2 mm; from a depth of",
          depths[np.any(at_surface, axis=0)][:1], "mm on")


def draw_map():
    figure, (of_life, of_strength) = figures.plt.subplots(1, 2, figsize=(12, 4.4), constrained_layout=True)
    whole = strength(f"free_{SPACING}")
    print(f"without a pore: {life(f'free_{SPACING}'):.0f} cycles, {whole:.1f} MPa")
    of_life.axhline(life(f"free_{SPACING}"), color="0.5", linestyle="--", label="no pore")
    for radius in RADII:
        color = COLORS[radius]
        names = [f"map_{radius}_{depth}" for depth in DEPTHS]
        depths, lives, at_pore = draw_lives(of_life, radius, names, 6)
        of_life.plot(depths, lives, color=color, linewidth=0.8)
        of_life.plot([], [], "o-", color=color, label=f"r = {radius} µm")
        strengths = np.array([strength(name) for name in names]) / whole
        of_strength.plot(depths, strengths, "o", color=color, markersize=5, label=f"r = {radius} µm")
        for depth, value in zip((0.26, 6.66), PUBLISHED[radius]):
            of_strength.plot(depth, value, "x", color=color, markersize=9, markeredgewidth=2)
        print(f"r = {radius} um: lives", " ".join(f"{n:.0f}{'p' if p else 's'}" for n, p in zip(lives, at_pore)))
        print("  strengths over that without a pore:", np.round(strengths, 3), "published", PUBLISHED[radius],
              f"semicircle at the surface {strength(f'semicircle_{radius}') / whole:.3f}")
        draw_places(of_life, of_strength, radius, whole)
    of_strength.plot([], [], "x", color="0.3", label="published")
    of_life.plot([], [], "o", color="0.3", fillstyle="none", label="surface first")
    of_life.set_yscale("log")
    of_life.set_ylim(400, 2600)
    of_life.set_ylabel("life at 400 MPa (cycles)")
    of_strength.set_ylim(0.5, 1.02)
    of_strength.set_ylabel("strength at 1e7 cycles over that without a pore")
    for axis in (of_life, of_strength):
        axis.set_xlabel("depth of the pore (mm)")
        axis.grid(alpha=0.3, which="both")
        axis.legend(fontsize=8, loc="lower right", ncols=2)
    figure.savefig(folder / "map.png", dpi=150)


def draw_spacing():
    figure, (of_strength, of_strain) = figures.plt.subplots(1, 2, figsize=(12, 4.4), constrained_layout=True)
    for radius in RADII:
        color = COLORS[radius]
        for depth, style, published in zip((0.26, 6.66), ("o-", "s--"), PUBLISHED[radius]):
            ratios = [strength(f"spacing_{spacing}_{radius}_{depth}") / strength(f"free_{spacing}")
                      for spacing in SPACINGS]
            of_strength.plot(SPACINGS, ratios, style, color=color, fillstyle="full" if depth < 1 else "none",
                             label=f"r = {radius} µm, depth {depth} mm")
            of_strength.plot(1.18, published, "x", color=color, markersize=9, markeredgewidth=2)
            print(f"r = {radius} um, depth {depth} mm, spacings {SPACINGS} mm:", np.round(ratios, 3))
        strains = [amplitude(life(f"spacing_{spacing}_{radius}_6.66")) / far_strain(spacing) for spacing in SPACINGS]
        of_strain.plot(np.array(SPACINGS) / radius * 1e3, strains, "s", color=color, fillstyle="none",
                       label=f"shares, r = {radius} µm")
        print("  largest strain of a bond over the far one, 6.66 mm deep:", np.round(strains, 3))
    resolved = {spacing: amplitude(life(f"local_{spacing}")) / (STRESS * 1e6 / YOUNG)
                for spacing in (0.05, 0.025, 0.0125)}
    of_strain.plot(np.array(list(resolved)) / 0.1, list(resolved.values()), "k^",
                   label="resolved by points, r = 100 µm")
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
    far = STRESS * 1e6 / YOUNG
    for place in ("0.26_0.0", "0.02_0.0", "0.26_0.31"):
        for per_cell in (1, 2, 4, 6, 8) if place == "0.02_0.0" else (1, 2, 4, 6):
            strain = strain_of_cells(f"whole_{place}_{per_cell}")
            print(f"horizon {HORIZON} mm, pore at {place}, {per_cell} points an edge: strain between cells "
                  f"{strain / far:.4f} of the far one, life {life_of_range(2 * strain):.0f}; the pore opens by "
                  f"{opening_of_pore(f'whole_{place}_{per_cell}', far):.3f}")
        for per_cell in (1, 6, 8) if place == "0.26_0.0" else (1, 6):
            print(f"  {per_cell} points an edge: first bond of all {life(f'same_{place}_{per_cell}'):.1f}")
    known = strength("map_100_0.26")
    for stress in (150, 155, 160, 200, 300):
        strain = amplitude(life("map_100_0.26")) * stress / STRESS
        print(f"{stress} MPa, r = 100 um, 0.26 mm deep: {life(f'stress_{stress}'):.6g} cycles; by the life at 400 MPa "
              f"{life_of_range(2 * strain) if strain > LIMIT else RUN_OUT:.6g} (strength {known:.2f})")
    for radius in RADII:
        root_area = np.sqrt(np.pi) * radius
        print(f"Murakami, HV 350, r = {radius} um: " + ", ".join(
            f"{place} {factor * (350 + 120) / root_area**(1 / 6) / (1.6 * 350):.3f}"
            for place, factor in (("touching", 1.41), ("inside", 1.56))))


draw_map()
draw_spacing()
print_controls()
