#!/usr/bin/python3
"""concentration.png: the field at the end, and its profile along y = 0 against the exact one; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

SATURATION, DIFFUSIVITY, LENGTH = 2.65e-5, 0.84e-9, 0.2


def fick(x, t):
    """Slab with C = C_sv at x = 0 and no flux at x = LENGTH, from C = 0 (Fourier series)."""
    odd = np.arange(1, 400, 2)[:, None] * np.pi / (2 * LENGTH)
    return 1 - np.sum(2 / (odd * LENGTH) * np.sin(odd * x) * np.exp(-odd ** 2 * DIFFUSIVITY * t), axis=0)


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
results = Results(folder / "hydrogen_only")
view = figures.View("Concentration", factor=1 / SATURATION, unit="C / C_sv")
last = results.steps[-1]
figure, (left, right) = figures.plt.subplots(1, 2, figsize=(11, 3.6), constrained_layout=True)
image = figures.draw_map(left, results, last, view, (0.0, 1.0), 1.0)
left.set_title(figures.step_title(results, last))
figure.colorbar(image, ax=left, shrink=0.8).set_label("C / C_sv")
row = np.abs(results.x[:, 1] - results.x[np.argmin(np.abs(results.x[:, 1])), 1]) < 1e-6
order = np.argsort(results.x[row, 0])
x = results.x[row, 0][order]
for step in [step for step in results.steps if step > 0]:
    values = results.field("Concentration", step)[row][order] / SATURATION
    line, = right.plot(x * 1e3, values, ".", markersize=3, label=figures.time_text(results.time(step)))
    right.plot(x * 1e3, fick(x, results.time(step)), "-", linewidth=0.9, color=line.get_color())
right.set_xlabel("x (mm)")
right.set_ylabel("C / C_sv on y = 0")
right.set_title("points: peridynamics; lines: Fick's law")
right.grid(alpha=0.3)
right.legend(fontsize=7)
figure.savefig(folder / "concentration.png", dpi=110)
print(folder / "concentration.png")
