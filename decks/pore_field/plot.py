#!/usr/bin/python3
"""lives.png: lives of the specimens of the study and what breaks them; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
here = Path(__file__).resolve()
sys.path.insert(0, str(here.parent))
sys.path[:0] = [str(here.parents[2] / "meshes"), str(here.parents[1] / "cumulative_fatigue")]

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from pores import NUMBER, WIDTH, pores  # noqa: E402
from relation import YOUNG, amplitude  # noqa: E402
from relation import life as life_of_range  # noqa: E402

STRESS, RUN_OUT, SEEDS = 300.0, 1e7, range(1, 51)  # MPa, cycles
HARDNESS = 350  # Vickers, of Ti-6Al-4V; assumed
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def life(name):
    """Cycles to the first bond; infinite where there is none."""
    history = read_history(folder / name)
    return history["time"][-1] if history["Largest_Damage"][-1] > 0 else np.inf


def strength_of(cycles):
    """Amplitude of stress, MPa, for 1e7 cycles: strains are in proportion to it."""
    return STRESS * amplitude(RUN_OUT) / amplitude(cycles)


def root_areas(middles, radii):
    """Square roots of the areas of pores across the load, of cut ones what is inside; um."""
    angle = (np.arange(2000) + 0.5) * np.pi * (3 - np.sqrt(5))
    disc = np.sqrt((np.arange(2000) + 0.5) / 2000)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    inside = [np.all(np.abs(m[:2] + r * disc) < 0.5 * WIDTH, axis=1).mean() for m, r in zip(middles, radii)]
    return 1e3 * np.sqrt(np.pi * radii**2 * inside)


def murakami(middles, radii):
    """Fatigue limits of each pore by itself, MPa (Murakami's root-area model, R = -1), and whether it is at a side: cut
    by it, or with less than a quarter of its radius of material before it, where he takes it to the side."""
    depth = 0.5 * WIDTH - np.max(np.abs(middles[:, :2]), axis=1)
    is_cut, is_near = depth < radii, depth < 1.25 * radii
    factor = np.where(is_cut, 1.43, np.where(is_near, 1.41, 1.56))
    return factor * (HARDNESS + 120) / root_areas(middles, radii)**(1 / 6), is_near


def killer(name, middles, radii):
    """The pore that is nearest to the bonds that broke, and how far they pass from its surface (mm)."""
    results = Results(folder / f"{name}.h5")
    damage = results.field("Damage", results.steps[-1]).ravel()
    ends = 1e3 * results.x[damage > 0.3 * damage.max()]
    best = (np.inf, -1)
    reach = 2.1 * WIDTH / len(np.unique(np.round(results.x[:, 0], 9)))  # a horizon
    for i in range(len(ends)):
        for j in range(i):
            bond = ends[j] - ends[i]
            if np.linalg.norm(bond) > reach:
                continue
            s = np.clip((middles - ends[i]) @ bond / (bond @ bond), 0, 1)
            gap = np.linalg.norm(ends[i] + s[:, None] * bond - middles, axis=1) - radii
            best = min(best, (gap.min(), int(gap.argmin())))
    return best[1], best[0]


class Series:
    """Specimens of one series of the study."""

    def __init__(self, number):
        rows = []
        for seed in SEEDS:
            if not (folder / f"study.study/{number}_{seed}.report.json").exists():
                continue
            middles, radii = pores(seed)
            limits, is_near = murakami(middles, radii)
            name = f"study.study/{number}_{seed}"
            pore, gap = killer(name, middles, radii)
            areas = root_areas(middles, radii)
            rows.append((life(name), pore, gap, areas[pore], areas.max(), is_near[pore], limits[pore], limits.min(),
                         1 + np.sum(areas > areas[pore]), 1 + np.sum(limits < limits[pore]), np.sum(is_near)))
        (self.lives, self.pores, self.gaps, self.areas, self.largest, self.near, self.limits, self.lowest, self.rank,
         self.rank_by_limit, self.n_near) = np.array(rows).T

    def tell(self, label):
        n = len(self.lives)
        strengths = np.sort(strength_of(self.lives))[[0, n // 2, -1]]
        lowest = np.sort(self.lowest)[[0, n // 2, -1]]
        print(f"{label}, {n} specimens: lives {self.lives.min():.0f} to {self.lives.max():.0f}, median "
              f"{np.median(self.lives):.0f}; strengths (lowest, middle, highest) {np.round(strengths, 1)} MPa; "
              f"lowest limits of their pores by Murakami over 1.6 HV {np.round(lowest / (1.6 * HARDNESS), 3)}")
        print("  gap between killing bond and its pore, spacings of 0.1 mm: largest", np.round(10 * self.gaps.max(), 2))
        print(f"  killer is the largest: {np.mean(self.rank == 1):.0%}, of the three largest "
              f"{np.mean(self.rank <= 3):.0%}, ten {np.mean(self.rank <= 10):.0%}; worst by Murakami "
              f"{np.mean(self.rank_by_limit == 1):.0%}, of the three {np.mean(self.rank_by_limit <= 3):.0%}; at a side "
              f"{np.mean(self.near):.0%} of the killers, {self.n_near.sum() / (n * NUMBER):.1%} of all pores")
        m, scale = weibull(self.lives)
        print(f"  Weibull: modulus of lives {m:.2f}, scale {scale:.0f}; of strengths "
              f"{weibull(strength_of(self.lives))[0]:.1f}; rank correlation of life with root area of the killer "
              f"{correlation(self.lives, self.areas):.2f}, of the largest {correlation(self.lives, self.largest):.2f}; "
              f"with Murakami's limit of the killer {correlation(self.lives, self.limits):.2f}, of the lowest "
              f"{correlation(self.lives, self.lowest):.2f}")


def correlation(a, b):
    """Spearman's."""
    ranks = [np.argsort(np.argsort(x)) for x in (a, b)]
    return np.corrcoef(*ranks)[0, 1]


def shares(values):
    """Sorted, and the shares of the distribution that they stand for (Bernard's medians)."""
    n = len(values)
    return np.sort(values), (np.arange(1, n + 1) - 0.3) / (n + 0.4)


def weibull(values):
    """Modulus and scale by a straight line through ln(-ln(1 - F)) over ln(value)."""
    value, share = shares(values)
    slope, offset = np.polyfit(np.log(value), np.log(-np.log(1 - share)), 1)
    return slope, np.exp(-offset / slope)


def main():
    base, other = Series(1), Series(2)
    free = life("free")
    print(f"no pores: {free:.0f} cycles ({300e6 / YOUNG:.6f} of strain lives "
          f"{life_of_range(2 * 300e6 / YOUNG):.0f}), strength {strength_of(free):.1f} MPa")
    base.tell("20 points across")
    other.tell("21 points across")
    n = len(other.lives)
    ratio = other.lives / base.lives[:n]
    print(f"21 over 20 points: lives {ratio.min():.2f} to {ratio.max():.2f}, mean {ratio.mean():.3f}, deviation "
          f"{np.std(np.log(ratio)):.2f}; same killer {np.mean(base.pores[:n] == other.pores):.0%}; "
          f"correlation of ranks {correlation(base.lives[:n], other.lives):.2f}")
    draw(base, other, free)


def draw(base, other, free):
    figure, (of_lives, of_areas, of_limits) = figures.plt.subplots(1, 3, figsize=(14, 4.2), constrained_layout=True)
    for series, color, label in ((base, "tab:blue", "20 points across"), (other, "tab:orange", "21 points across")):
        value, share = shares(series.lives)
        of_lives.plot(value, np.log(-np.log(1 - share)), "o", color=color, fillstyle="none", markersize=4, label=label)
        modulus, scale = weibull(series.lives)
        line = np.array([value[0], value[-1]])
        of_lives.plot(line, modulus * np.log(line / scale), color=color, linewidth=0.8, label=f"modulus {modulus:.1f}")
    of_lives.axvline(free, color="0.5", linestyle="--", label="no pores")
    of_lives.set_xscale("log")
    ticks = np.array([0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98])
    of_lives.set_yticks(np.log(-np.log(1 - ticks)), [f"{100 * tick:.0f} %" for tick in ticks])
    of_lives.set_xlabel("life at 300 MPa (cycles)")
    of_lives.set_ylabel("specimens that are broken")
    for is_near, style, label in ((True, "full", "killer at a side"), (False, "none", "killer inside")):
        for series, color in ((base, "tab:blue"), (other, "tab:orange")):
            those = series.near.astype(bool) == is_near
            of_areas.plot(series.areas[those], series.lives[those], "o", color=color, fillstyle=style, markersize=5,
                          label=label if series is base else None)
            of_limits.plot(series.lowest[those], strength_of(series.lives[those]), "o", color=color, fillstyle=style,
                           markersize=5, label=label if series is base else None)
    of_areas.axhline(free, color="0.5", linestyle="--")
    of_areas.set_yscale("log")
    of_areas.set_xlabel("√area of the pore that breaks the specimen (µm)")
    of_areas.set_ylabel("life at 300 MPa (cycles)")
    of_limits.axhline(strength_of(free), color="0.5", linestyle="--")
    of_limits.set_xlabel("lowest limit of its pores by Murakami (MPa)")
    of_limits.set_ylabel("strength at 1e7 cycles (MPa)")
    for axis in (of_lives, of_areas, of_limits):
        axis.grid(alpha=0.3, which="both")
        axis.legend(fontsize=7)
    figure.savefig(folder / "lives.png", dpi=150)
    print(folder / "lives.png")


if __name__ == "__main__":
    main()
