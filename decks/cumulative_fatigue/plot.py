#!/usr/bin/python3
"""lives.png: lives of bars, and of bars whose constants scatter; growth.png: growth of a crack over the range of K, and over
that of the elements at its tip; plot.py [RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from relation import LIMITS, YOUNG, growth, life, lives_that_scatter  # noqa: E402

RUN_OUT, BONDS = 1e7, 59 + 58 + 57  # cycles; of the bar: 60 points, 3 spacings a horizon
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def rows_of(name):
    with open(folder / name) as file:
        return list(csv.DictReader(file))


def draw_lives(axis):
    worst = 0.0
    for (strength, limit), color in zip(LIMITS.items(), ("C0", "C1")):
        stress = np.linspace(limit * YOUNG * 1.00001, 600e6, 2000)
        axis.plot(life(2 * stress / YOUNG, limit), stress * 1e-6, color=color,
                  label=f"limit {limit:g}: {strength} MPa at 1e7 cycles")
        for file in sorted(folder.glob(f"bar_{strength}_*.csv")):
            last, amplitude = rows_of(file.name)[-1], float(file.stem.split("_")[2]) * 1e6
            cycles, exact = float(last["time"]), min(life(2 * amplitude / YOUNG, limit), RUN_OUT)
            worst = max(worst, abs(cycles / exact - 1))
            axis.plot(cycles, amplitude * 1e-6, ">" if cycles == RUN_OUT else "o", color=color, fillstyle="none")
            print(f"limit {limit:g}, {amplitude * 1e-6:g} MPa: {cycles:.6g} cycles")
    print(f"largest relative error of a life: {worst:.1e}")
    axis.legend()


def draw_scatter(axis, name, weakest_of):
    stresses = np.linspace(240e6, 600e6, 73)
    bands = []
    for stress in stresses:
        lives, shares = lives_that_scatter(2 * stress / YOUNG, 20000, weakest_of)
        bands.append([lives[min(np.searchsorted(shares, share), len(lives) - 1)] for share in (0.05, 0.5, 0.95)])
    low, middle, high = np.minimum(np.array(bands).T, 1e9)
    axis.fill_betweenx(stresses * 1e-6, low, high, color="C2", alpha=0.2, label="5 to 95 %, by statistics")
    axis.plot(middle, stresses * 1e-6, color="C2", label="median")
    gaps = []
    for series in dict.fromkeys(row["label"] for row in rows_of(f"{name}.study.csv")):
        stress = float(series.split()[0])
        runs = [row for row in rows_of(f"{name}.study.csv") if row["label"] == series]
        broke = [float(row["Maximum Largest_Damage"]) > 0 for row in runs]
        lives = np.where(broke, [float(row["Time Of Maximum Largest_Damage"]) for row in runs], RUN_OUT)
        axis.plot(lives, np.full(len(lives), stress), "|", color="k")
        exact, shares = lives_that_scatter(2e6 * stress / YOUNG, weakest_of=weakest_of)
        found = np.sort(np.interp(lives[broke], exact, shares))
        gaps.append(np.max(np.abs(found - (np.arange(len(found)) + 0.5) / len(lives)), initial=0.0))
    print(f"{name}: largest gap of the distributions (20 lives: 0.29 once in twenty times): "
          + ", ".join(f"{gap:.2f}" for gap in gaps))
    axis.legend()


def rate_of(name):
    rows = rows_of(name)
    a, n = (np.array([float(row[key]) for row in rows]) for key in ("Crack_Length", "time"))
    steady = a > 0.0135
    return np.polyfit(n[steady], a[steady], 1)[0]


def draw_growth(law, ratio):
    ranges = np.logspace(np.log10(1.4), np.log10(70), 300) * 1e6
    for measure, color in (("Amplitude", "C0"), ("Range", "C1")):
        label = {"Amplitude": "in amplitudes", "Range": "in ranges"}[measure] + " of strain"
        law.loglog(ranges * 1e-6, growth(ranges, measure), color=color, label=label)
        found = []
        for file in folder.glob(f"growth_{measure}_*.csv"):
            intensity = float(file.stem.split("_")[2])
            found.append((intensity, rate_of(file.name)))
        intensity, rate = np.array(sorted(found)).T
        exact = growth(intensity * 1e6, measure)
        law.loglog(intensity, rate, "o", color=color, fillstyle="none")
        ratio.semilogx(intensity, rate / exact, "o-", color=color)
        for row in zip(intensity, rate, exact, rate / exact):
            print(measure, "dK %g MPa m^0.5: %.3g, by the elements %.3g m/cycle, ratio %.3f" % row)
    for file in sorted(folder.glob("fine_Amplitude_*.csv")):
        intensity = float(file.stem.split("_")[2])
        found, exact = rate_of(file.name), growth(intensity * 1e6)
        print(f"half the horizon, dK {intensity:g} MPa m^0.5: {found:.3g} m/cycle, ratio {found / exact:.3f}")
    law.set_xlabel("range of K (MPa m$^{0.5}$)")
    law.set_ylabel("growth (m/cycle)")
    law.legend()
    ratio.axhspan(0.9, 1.1, color="0.9")
    ratio.axhline(1.0, color="0.6")
    ratio.set_ylim(0.8, 1.2)
    ratio.set_xlabel("range of K (MPa m$^{0.5}$)")
    ratio.set_ylabel("growth over r/N of the elements")


figure, axes = figures.plt.subplots(1, 3, figsize=(12, 4), constrained_layout=True, sharey=True)
draw_lives(axes[0])
draw_scatter(axes[1], "specimens", 1)
draw_scatter(axes[2], "bonds", BONDS)
for axis, title in zip(axes, ("one set of constants", "specimens that scatter", "bonds that scatter")):
    axis.set(xscale="log", xlim=(5e2, 2e7), ylim=(240, 600), xlabel="cycles to the first broken bond", title=title)
    axis.grid(alpha=0.3, which="both")
axes[0].set_ylabel("amplitude of stress (MPa), R = -1")
figure.savefig(folder / "lives.png", dpi=150)

figure, axes = figures.plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True)
draw_growth(*axes)
for axis in axes:
    axis.grid(alpha=0.3, which="both")
figure.savefig(folder / "growth.png", dpi=150)
print(folder / "lives.png", folder / "growth.png")
