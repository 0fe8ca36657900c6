#!/usr/bin/python3
"""Pictures of run_methods.sh; plot_methods.py [RESULTS]
  neighbours.png   shares of a bond that a crack along the common edge of two cells leaves, by n of uniform partitions
  methods.png      errors of K by distance of points, time and n
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import numpy as np  # noqa: E402
from neighbours import N, exact_share, lengths  # noqa: E402
from openings import exact, intensity, opening  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

RULES = {"Adaptive": ("tab:blue", "shares"), "Intersection": ("tab:orange", "intersection"), "Both": ("tab:green", "both"),
         "Either": ("tab:red", "either")}
SPACINGS, PARTS = ("0.5", "0.333333333", "0.25"), (1, 2, 5, 10, 20, 40)
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
times = {name: float(seconds) for name, seconds in (line.split() for line in (folder / "times.txt").read_text().splitlines())}


def shares(name):
    """[lengths] from the damage of the second point of each upper row, a third of what the crack takes."""
    results = Results(folder / f"pairs_{name}.h5")
    x, y = results.x[:, 0], results.x[:, 1]
    second = (np.abs(x + 0.5e-3) < 1e-6) & (np.abs(y / 5e-3 - np.round(y / 5e-3)) < 1e-3)
    damage = results.field("Damage", results.steps[-1])[second][np.argsort(y[second])]
    return 1.0 - 3.0 * damage


def lines_of_a_bond():
    found = {}
    for line in (folder / "pairs.log").read_text().splitlines():
        name, text = line.split(": ", 1)
        found[name] = int(re.search(r"by (\d+) lines", text).group(1)) / N
    return found


figure, (of_share, of_error, of_work) = figures.plt.subplots(1, 3, figsize=(14, 4), constrained_layout=True)
a, wanted, work = lengths(), exact_share(lengths()), lines_of_a_bond()
of_share.plot(a, wanted, color="0.4", label="exact")
for n, color in zip(PARTS[1:], ("tab:red", "tab:orange", "tab:green", "tab:blue", "tab:purple")):
    share = shares(f"Uniform_{n}")
    if n < 20:
        of_share.plot(a, share, color=color, linewidth=0.9, label=f"n = {n}")
    else:
        of_error.plot(a, 100 * (share - wanted), color=color, label=f"n = {n}")
    of_work.loglog(work[f"Uniform_{n}"], 100 * np.max(np.abs(share - wanted)), "o", color=color, label=f"uniform, n = {n}")
    print(f"n = {n}: largest error {100 * np.max(np.abs(share - wanted)):.3f} % of a bond, {work[f'Uniform_{n}']:.0f} lines")
for tolerance, marker in (("1.0e-2", "^"), ("1.0e-3", "s"), ("1.0e-4", "D")):
    error, in_two = (shares(f"Adaptive_{tolerance}_{parts}") - wanted for parts in (1, 2))
    lines, lines_in_two = (work[f"Adaptive_{tolerance}_{parts}"] for parts in (1, 2))
    label = f"adaptive, tolerance {float(tolerance):g}"
    if tolerance == "1.0e-3":
        of_error.plot(a, 100 * error, "k--", label=label)
    of_work.loglog(lines, 100 * np.max(np.abs(error)), marker, color="k", fillstyle="none", label=label)
    print(f"{label}: largest error {100 * np.max(np.abs(error)):.3f} % of a bond, {lines:.0f} lines; with the crack in two parts "
          f"{100 * np.max(np.abs(in_two)):.3f} %, {lines_in_two:.0f} lines")
of_share.set_xlabel("length of the crack over that of the edge")
of_share.set_ylabel("share of the bond that is left")
of_error.set_xlabel("length of the crack over that of the edge")
of_error.set_ylabel("error (% of a bond)")
of_work.set_xlabel("lines looked at for a bond, in the mean; n$^3$")
of_work.set_ylabel("largest error (% of a bond)")
figures.save_curves(figure, folder / "neighbours.png", (of_share, of_error, of_work))


def errors(name, spacing):
    """Of K, %, for the five places of the tip."""
    lengths_of_crack = 1e-3 * (10.0 + 0.24 * float(spacing) * (np.arange(5) - 2))
    return np.array([100 * (intensity(*opening(folder / f"{name}_{k}.h5"), length) / exact(length)[1] - 1)
                     for k, length in enumerate(lengths_of_crack)])


def seconds(name):
    return np.median([times[f"{name}_{k}"] for k in range(5)])


figure, (of_spacing, of_time, of_parts) = figures.plt.subplots(1, 3, figsize=(14, 4), constrained_layout=True)
for rule, (color, label) in RULES.items():
    found = [errors(f"spaced_{rule}_{spacing}", spacing) for spacing in SPACINGS]
    worst = [np.max(np.abs(error)) for error in found]
    took = [seconds(f"spaced_{rule}_{spacing}") for spacing in SPACINGS]
    of_spacing.loglog([float(spacing) for spacing in SPACINGS], worst, "o-", color=color, label=label)
    of_time.loglog(took, worst, "o-", color=color, label=label)
    print(f"{rule}, {SPACINGS} mm: K off by up to", np.round(worst, 2), "%, range", np.round([np.ptp(error) for error in found], 2),
          "%; s of the processor", np.round(took, 2))
found = [errors(f"parts_{n}", SPACINGS[1]) for n in PARTS]
took = [seconds(f"parts_{n}") for n in PARTS]
of_parts.semilogx(PARTS, [np.max(np.abs(error)) for error in found], "o-", label="largest error")
of_parts.semilogx(PARTS, [np.ptp(error) for error in found], "s--", fillstyle="none", label="range over five places of the tip")
print("n =", PARTS, ": K off by up to", np.round([np.max(np.abs(error)) for error in found], 2), "%, range",
      np.round([np.ptp(error) for error in found], 2), "%; s of the processor", np.round(took, 2))
of_spacing.set_xlabel("distance of points (mm)")
of_time.set_xlabel("processor time of a run (s)")
of_parts.set_xlabel("n of uniform partitions, points 0.33 mm apart")
of_spacing.set_xticks([float(spacing) for spacing in SPACINGS], ("0.5", "0.33", "0.25"))
of_time.set_xticks((0.4, 0.8, 1.6), ("0.4", "0.8", "1.6"))
of_parts.set_xticks(PARTS, [str(n) for n in PARTS])
for axis in (of_spacing, of_time):
    axis.set_yticks((1, 2, 5, 10), ("1", "2", "5", "10"))
for axis in (of_spacing, of_time, of_parts):
    axis.minorticks_off()
    axis.set_ylabel("error of K (%)")
figures.save_curves(figure, folder / "methods.png", (of_spacing, of_time, of_parts))
