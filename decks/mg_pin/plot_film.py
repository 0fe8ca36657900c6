#!/usr/bin/python3
"""pin.mp4: the wire dissolves; speed with streamlines, dissolved magnesium; plot_film.py [RESULTS] [NAME]; needs ffmpeg"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from matplotlib.animation import FFMpegWriter  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
name = sys.argv[2] if len(sys.argv) > 2 else "mg_pin"
results, history = Results(str(folder / name)), read_history(folder / f"{name}.csv")
near = (np.abs(results.x[:, 1]) < 200e-6) & (results.x[:, 0] > -150e-6) & (results.x[:, 0] < 350e-6)
columns, rows = (np.unique(np.round(results.x[near, axis] * 1e6, 3)) for axis in (0, 1))
order = np.flatnonzero(near)[np.lexsort((results.x[near, 0], results.x[near, 1]))]


def whole(label, step, component=None, sign=1.0):
    """The lattice of both halves [rows, columns]; `sign` of the mirror image."""
    values = results.field(label, step)
    half = (values if component is None else values[:, component])[order].reshape(len(rows), len(columns))
    return np.vstack([sign * half[::-1], half])


columns, y = np.linspace(columns[0], columns[-1], len(columns)), np.linspace(-rows[-1], rows[-1], 2 * len(rows))
most = [np.percentile(results.field("Velocity", results.steps[1])[order, 0], 99.5),
        np.percentile(whole("Concentration", results.steps[1])[whole("Fluid", results.steps[1]) == 1], 99.5)]
figure, axes = figures.plt.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
scales = [figures.plt.cm.ScalarMappable(cmap=colours) for colours in ("viridis", "magma")]
for axis, scale, top, label in zip(axes, scales, most, ("speed (m/s)", "Mg²⁺ (mol/m³)")):
    scale.set_clim(0, top)
    figure.colorbar(scale, ax=axis, label=label, shrink=0.8)
writer = FFMpegWriter(fps=6, bitrate=400, extra_args=["-pix_fmt", "yuv420p"])
# All frames of one size: nothing is cut to what is in it.
with figures.plt.rc_context({"savefig.bbox": None}), writer.saving(figure, str(folder / "pin.mp4"), 100):
    for step in results.steps[1:]:
        is_dry = whole("Fluid", step) != 1
        u, v = whole("Velocity", step, 0), whole("Velocity", step, 1, -1.0)
        metal = np.ma.masked_equal(1 - whole("Damage", step), 0.0)
        for axis, scale, field in zip(axes, scales, (np.hypot(u, v), whole("Concentration", step))):
            axis.clear()
            axis.pcolormesh(columns, y, np.ma.array(field, mask=is_dry), cmap=scale.cmap, norm=scale.norm)
            axis.pcolormesh(columns, y, metal, cmap="Greys", vmin=-0.5, vmax=1.5)
            axis.set_aspect("equal")
            axis.set(xlim=(-150, 350), ylim=(-200, 200), xlabel="x (µm)")
        axes[0].streamplot(columns, y, np.where(is_dry, 0, u), np.where(is_dry, 0, v), color="w", linewidth=0.5,
                           density=1.1, arrowsize=0.6)
        axes[0].set(xlim=(-150, 350), ylim=(-200, 200))
        time = results.time(step)
        lost = np.interp(time, history["time"], history["Relative_Volume_Loss"])
        axes[1].set_title(f"{time / 3600:.2f} h, {lost:.0f} % dissolved", fontsize=9)
        writer.grab_frame()
print(folder / "pin.mp4")
