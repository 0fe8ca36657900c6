#!/usr/bin/python3
"""growth.png: lengths over cycles in the middle of slabs, at their faces and in the plane body, and the fronts; and what the
README states of them; plot.py [RESULTS]"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

FIRST, LAST = 13.5, 19.0  # mm: growth from half a horizon on, to beside the end
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def history(name):
    with open(folder / f"{name}.csv") as file:
        rows = list(csv.DictReader(file))
    return {key: np.array([float(row[key]) for row in rows]) for key in rows[0]}


def cycles_between(run, column):
    lengths, first = np.unique(run[column] * 1e3, return_index=True)
    return np.diff(np.interp([FIRST, LAST], lengths, run["time"][first]))[0]


def front(name):
    """(z, length of the crack) in mm at the end: where damage falls through the threshold of the deck, layer by layer."""
    run = Results(folder / name)
    x, damage = run.x * 1e3, run.field("Damage", run.steps[-1])
    for z in np.unique(x[:, 2].round(6)):
        row = (np.abs(x[:, 2] - z) < 1e-3) & (np.abs(x[:, 1] - 0.5) < 1e-3)
        order = np.argsort(x[row, 0])
        along, d = x[row, 0][order], damage[row][order]
        last = np.flatnonzero(d >= 0.2)[-1]
        yield z, along[last] + (d[last] - 0.2) / (d[last] - d[last + 1]) * (along[last + 1] - along[last])


figure, axes = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
plane = history("plane")
of_plane = cycles_between(plane, "Length_In_The_Middle")
axes[0].plot(plane["time"] * 1e-3, plane["Length_In_The_Middle"] * 1e3, "k", label="plane strain")
for number, name in enumerate(("slab_6", "slab_9")):
    run, label = history(name), f"slab of {name[-1]} mm"
    for column, style in (("Length_In_The_Middle", "-"), ("Length_At_A_Face", ":")):
        axes[0].plot(run["time"] * 1e-3, run[column] * 1e3, style, color=f"C{number}",
                     label=f"{label}, {'middle' if style == '-' else 'face'}")
    places = np.array(list(front(name)))
    axes[1].plot(*places.T, "o-", color=f"C{number}", label=label)
    print(f"{label}: cycles from {FIRST} to {LAST} mm over those of the plane body {cycles_between(run, 'Length_In_The_Middle') / of_plane:.3f}"
          f" in the middle, {cycles_between(run, 'Length_At_A_Face') / of_plane:.3f} at a face; front {places[:, 1].round(2)}")
axes[0].set_xlabel("cycles (10³)")
axes[0].set_ylabel("crack length (mm)")
axes[1].set_xlabel("z (mm)")
axes[1].set_ylabel("front at the end (mm)")
axes[1].set_ylim(17, 21)
for axis in axes:
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)
figure.savefig(folder / "growth.png", dpi=130)
print(folder / "growth.png")
