#!/usr/bin/python3
"""Interface kernels side by side: fronts that are plane, slant or are round, with and without random bonds; kernels.png
and its tables; the default on long cells; kernels.py PDRUN DECK [RESULTS]"""
import os
import subprocess
import sys
from math import cos, pi, radians, sin
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

SPEED = 5.1e3 / (2.19 * 96485.33212 * 142900)
SOLID, SATURATION, SPACING = 142900.0, 4600.0, 1e-6
KERNELS, RULES = ("Flux Exact", "Trial Calibration"), ("Deterministic", "Stochastic")
ANGLES, STEPS = (0.0, 15.0, 26.565, 36.87, 45.0), 16
RISES = (0.0, 0.1, 0.2, 0.5, 1.0)


def run(kernel, rule, horizon, metal, mouth, time, mesh="plate", **more):
    """Times, points and, by time, the share of each point's metal that has gone."""
    settings = {"Discretization/Input Mesh File": f"{mesh}.txt", "Materials/Metal/Interface Kernel": kernel,
                "Damage Models/Phases/Rule": rule, "Blocks/Body/Horizon": horizon * SPACING,
                "Boundary Conditions/Metal Node Set/Expression": metal,
                "Boundary Conditions/Mouth Node Set/Expression": mouth, "Solver/Final Time": time,
                "Solver/Corrosion/Load Steps": STEPS, "Output/Output Filename": "kernels", "Output/Output Frequency": 1,
                **more}
    command = [pdrun, deck] + [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    results = Results(folder / "kernels")
    gone = [np.where(results.field("Damage", step) >= 1, 1.0,
                     (SOLID - results.field("Concentration", step)) / (SOLID - SATURATION)) for step in results.steps]
    return np.array([results.time(step) for step in results.steps]), results.x, np.array(gone)


def slope(times, depths):
    """Error of a speed, in per cent, once the front has left where it started."""
    first = STEPS // 3
    return 100 * (np.polyfit(times[first:], depths[first:], 1)[0] / SPEED - 1)


def plane(kernel, rule, horizon, degrees):
    """Of a front whose normal is at this angle to the grid, in a band with soft sides through the middle of the plate."""
    c, s, start, width = cos(radians(degrees)), sin(radians(degrees)), -20e-6, 16e-6
    depth = f"{c!r}*x + {s!r}*y"
    times, x, gone = run(kernel, rule, horizon, f"{depth} > {start}", f"{depth} < {start - 2e-6}", 160.0)
    across, depth = c * x[:, 1] - s * x[:, 0], c * x[:, 0] + s * x[:, 1] - start
    band = np.where((np.abs(across) < width) & (depth > 0), 0.5 + 0.5 * np.cos(pi * across / width), 0.0)
    return slope(times, gone @ band * SPACING**2 / width)


def round_front(kernel, rule, radius, grows):
    """Of the mean radius of a hole that grows, or of an island that shrinks, over 13 um."""
    inner, outer = "x*x + y*y < ", "x*x + y*y > "
    metal, mouth = (outer, inner) if grows else (inner, outer)
    held = radius + (-2e-6 if grows else 2e-6)
    times, x, gone = run(kernel, rule, 4, f"{metal}{radius**2!r}", f"{mouth}{held**2!r}", 80.0)
    distance = np.hypot(x[:, 0], x[:, 1])
    was_metal = distance > radius if grows else distance < radius
    area = gone @ was_metal.astype(float) * SPACING**2
    whole = np.sum(distance < radius) * SPACING**2
    return slope(times, np.abs(np.sqrt((whole + (area if grows else -area)) / pi) - radius))


def on_long_cells(ratio, rise):
    """Of a front that climbs `rise` m each m along cells `ratio` times as long as high; in the middle of its length."""
    columns, above, edge = 48, 10e-6, ratio * SPACING
    length, slant = columns * edge, np.hypot(1.0, rise)
    wall = f"{above!r} + {rise!r}*({length!r} - x)"
    time = max(8 * rise * edge, 12e-6) / slant / SPEED
    times, x, gone = run("Flux Exact", "Deterministic", 4 * ratio, f"y > {wall}",
                         f"y < {wall} - {3 * max(rise * edge, SPACING)!r}", time, f"long{ratio}",
                         **{"Materials/Metal/Horizon Axes": f"[{4 * edge!r}, {4 * SPACING!r}]",
                            "Materials/Metal/Diffusivity": 1e-7})
    middle = (np.abs(x[:, 0] / length - 0.5) < 0.2) & (x[:, 1] > above + rise * (length - x[:, 0]))
    width = len(np.unique(np.rint(x[middle, 0] / edge - 0.5)))  # columns
    return slope(times, gone @ middle.astype(float) * SPACING / width / slant)


def main():
    figure, axes = figures.plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True, sharey=True)
    for axis, rule in zip(axes, RULES):
        for kernel, line in zip(KERNELS, ("--", "-")):
            for horizon, marker in ((3, "o"), (4, "s"), (5, "^")):
                errors = [plane(kernel, rule, horizon, angle) for angle in ANGLES]
                cells = " | ".join(f"{error:+.2f} %" for error in errors)
                print(f"| {kernel}, {rule} | {horizon} | {cells} |", flush=True)
                axis.plot(ANGLES, errors, line, marker=marker, markersize=4, color=f"C{KERNELS.index(kernel)}",
                          label=f"{kernel}, horizon {horizon} spacings")
            print(f"| {kernel}, {rule} | hole {round_front(kernel, rule, 16e-6, True):+.1f} % | island "
                  f"{round_front(kernel, rule, 30e-6, False):+.1f} % |", flush=True)
        axis.set_title(f"Rule: {rule}", fontsize=10)
        axis.set_xlabel("angle between normal of the front and grid (degrees)")
        axis.grid(alpha=0.3)
    for ratio in (5, 25):
        cells = " | ".join(f"{on_long_cells(ratio, rise):+.1f} %" for rise in RISES)
        print(f"| {ratio}:1 | {cells} |", flush=True)
    axes[0].set_ylabel("error of the speed (%)")
    axes[1].legend(fontsize=7)
    figure.savefig(folder / "kernels.png", dpi=110)
    print(folder / "kernels.png")


pdrun, deck = (os.path.abspath(path) for path in sys.argv[1:3])
folder = Path(sys.argv[3] if len(sys.argv) > 3 else ".").resolve()
if __name__ == "__main__":
    main()
