#!/usr/bin/python3
"""depth.png: depth of the front against Faraday's law, and the difference; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import read_history  # noqa: E402

FARADAY = 96485.33212
SPEEDS = {"": 5.1e3 / (2.19 * FARADAY * 142900), "_copper": 1450 / (2 * FARADAY * 141000)}
AREAS = {"bar": 1.0, "strip": 20e-6, "block": 100e-12}

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
figure, (left, right) = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
for metal, title in (("", "SS304"), ("_copper", "Cu")):
    times = np.linspace(0, 300, 2)
    left.plot(times, SPEEDS[metal] * times * 1e6, "-", color="0.4", linewidth=0.9)
    for body, marker in (("bar", "o"), ("strip", "s"), ("block", "^")):
        history = read_history(folder / f"{body}{metal}.csv")
        t, depth = history["time"], history["Dissolved"] / AREAS[body]
        left.plot(t, depth * 1e6, marker, markersize=3, label=f"{title}, {body}")
        error = depth[1:] / (SPEEDS[metal] * t[1:]) - 1
        right.plot(t[1:], 100 * error, marker + "-", markersize=3, linewidth=0.7, label=f"{title}, {body}")
        print(f"{title}, {body}: {1e6 * depth[-1]:.4f} um, exact {1e6 * SPEEDS[metal] * t[-1]:.4f} um; error "
              f"{100 * error[-1]:+.3g} % at the end, at most {100 * np.max(np.abs(error)):.3g} %")
for axis, label in ((left, "depth (µm); lines: i t / (z F C_solid)"), (right, "error of the depth (%)")):
    axis.set_xlabel("t (s)")
    axis.set_ylabel(label)
    axis.grid(alpha=0.3)
left.legend(fontsize=7)
figure.savefig(folder / "depth.png", dpi=110)
print(folder / "depth.png")
