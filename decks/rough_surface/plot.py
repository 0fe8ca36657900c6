#!/usr/bin/python3
"""strain.png: largest strains of bonds beside waves and random surfaces against theory; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
here = Path(__file__).resolve()
sys.path.insert(0, str(here.parent))
sys.path[:0] = [str(here.parents[2] / "meshes"), str(here.parents[1] / "cumulative_fatigue")]

import numpy as np  # noqa: E402
from image import heights, waves  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from relation import YOUNG, amplitude  # noqa: E402
from relation import life as life_of_range  # noqa: E402
from theory import concentration  # noqa: E402

STRAIN, RUN_OUT, SPACING = 300e6 / YOUNG, 1e7, 20.0  # cycles, um
LENGTH, AMPLITUDES, SEEDS = 400.0, (2, 4, 6, 8, 10), range(1, 11)  # um
PLACES = ((0, 0), (10, 0), (0, 10), (5, 5))  # of waves along and across the lattice, um
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def life(name):
    return read_history(folder / name)["time"][-1]


def first_break(name):
    """The point below the mean height that has lost the largest part of its bonds, um."""
    results = Results(folder / f"{name}.h5")
    damage = np.where(results.x[:, 1] < -5e-6, results.field("Damage", results.steps[-1]).ravel(), 0.0)
    return 1e6 * results.x[damage.argmax(), :2]


figure, (of_waves, of_profile, of_lives) = figures.plt.subplots(1, 3, figsize=(14, 4.2), constrained_layout=True)
for place, style in zip(PLACES, "osv^"):
    start, height = place
    found = np.array([amplitude(life(f"sine_{a}_{start}_{height}")) / STRAIN for a in AMPLITUDES])
    theory = 1 + 4 * np.pi * np.array(AMPLITUDES) / LENGTH
    print(f"waves moved by {place} um: largest strain over the far one", np.round(found, 4), "theory",
          np.round(theory, 4),
          "lives over theory's", np.round(life_of_range(2 * found * STRAIN) / life_of_range(2 * theory * STRAIN), 3))
    of_waves.plot(AMPLITUDES, found, style, color="tab:blue", fillstyle="none", label=f"moved by {start}, {height} µm")
a = np.array([0.0, 10.5])
of_waves.plot(a, 1 + 4 * np.pi * a / LENGTH, color="k", linewidth=0.8, label="theory: 1 + 2 a k")
of_waves.set_xlabel("amplitude of waves 400 µm long (µm)")
of_waves.set_ylabel("largest strain over that far away")

lives, expected, places = [], [], []
x = np.linspace(-1800, 1800, 20001)
for seed in SEEDS:
    strain = concentration(waves(["random", str(seed)]), x)
    lives.append(life(f"random_{seed}"))
    expected.append(life_of_range(2 * strain.max() * STRAIN))
    places.append((first_break(f"random_{seed}")[0], x[strain.argmax()]))
    there = strain[np.abs(x - places[-1][0]) < 40].max()
    print(f"surface {seed}: life {lives[-1]:.0f}, theory {expected[-1]:.0f} (strain {strain.max():.3f}); breaks at x = "
          f"{places[-1][0]:.0f} um, theory {places[-1][1]:.0f}; theory's strain there {there:.3f}")
print("lives over theory's", np.round(np.array(lives) / expected, 2), "in the same trough",
      np.sum(np.abs(np.diff(places, axis=1)) < 80), "correlation of ranks",
      np.round(np.corrcoef(*[np.argsort(np.argsort(part)) for part in (lives, expected)])[0, 1], 2))
of_lives.plot(expected, lives, "o", color="tab:blue", fillstyle="none")
ends = np.array([min(expected) * 0.8, max(expected) * 1.25])
of_lives.plot(ends, ends, color="0.5", label="equal")
of_lives.fill_between(ends, ends / 1.2, ends * 1.2, color="0.5", alpha=0.15, label="20 %")
of_lives.set_xlabel("life by theory (cycles)")
of_lives.set_ylabel("life (cycles)")

x = np.linspace(-700, 300, 2000)
of_profile.fill_between(x, -60, heights(["random", "1"], x), color="0.85")
outline = np.loadtxt(here.parent / "random_1.txt") if (here.parent / "random_1.txt").exists() else None
if outline is not None:
    of_profile.plot(1e6 * outline[:, 1], 1e6 * outline[:, 2], ".-", color="tab:red", markersize=3, linewidth=0.6,
                    label="outline of the image")
lattice = np.meshgrid(np.arange(-690, 301, SPACING), np.arange(-50, 40, SPACING))
of_profile.plot(*(part.ravel() for part in lattice), ".", color="tab:blue", markersize=2, label="points")
of_profile.plot(*first_break("random_1"), "*", color="k", markersize=10, label="breaks here first")
of_profile.set_xlim(-700, 300)
of_profile.set_ylim(-60, 45)
of_profile.set_xlabel("x (µm)")
of_profile.set_ylabel("y (µm), nine times as large as x")
for axis in (of_waves, of_profile, of_lives):
    axis.grid(alpha=0.3, which="both")
    axis.legend(fontsize=7)
figure.savefig(folder / "strain.png", dpi=150)
print(folder / "strain.png")
