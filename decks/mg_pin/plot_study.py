#!/usr/bin/python3
"""transport.png, coupling.png, narrow.png: what run.sh --study runs; plot_study.py [RESULTS]"""
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from pdplot_lib.results import Results, read_history  # noqa: E402
from scipy.interpolate import griddata  # noqa: E402

CRITERIA = {"volume": "5 % of the wire", "each": "each load step", "drag_0.1": "10 % of the drag",
            "drag_0.02": "2 % of the drag", "drag_0.005": "0.5 % of the drag"}
folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")


def save(figure, name):
    figure.savefig(folder / name, dpi=110)
    print(folder / name)


def flows(name):
    """How many a run has found."""
    lines = json.loads((folder / f"{name}.report.json").read_text())["solver"]
    return int(next(line for line in lines if "Steady Flow: " in line and "load steps," in line).split("Steady Flow: ")[-1]
               .split()[0])


RADIUS, DIFFUSIVITY, SPEED, VISCOSITY = 40e-6, 1e-9, 0.047, 1e-6  # m, m2/s, m/s, m2/s


def correlation(radius):
    """The Sherwood number of a wire in cross flow (Churchill & Bernstein 1977)."""
    reynolds, schmidt = SPEED * 2 * radius / VISCOSITY, VISCOSITY / DIFFUSIVITY
    return 0.3 + 0.62 * reynolds**0.5 * schmidt**(1 / 3) / (1 + (0.4 / schmidt)**(2 / 3))**0.25 * (
        1 + (reynolds / 282000)**0.625)**0.8


def layer(name):
    """The Sherwood number of layer.yaml."""
    return -read_history(folder / f"{name}.csv")["Lost"][-1] / (np.pi * RADIUS) * 2 * RADIUS / DIFFUSIVITY


def of_layers():
    """The Sherwood number over the radius, by those of the whole wire and of half of its diameter."""
    whole, half = layer("layer"), layer("layer_thin")
    return lambda radius: whole * (radius / RADIUS)**np.log2(whole / half)


def round_wire(t, sherwood):
    """Loss, in %, of a wire in cross flow whose Sherwood number is that of its radius at all times."""
    ratio = 14302 / (71508 - 14302)
    radius = [RADIUS]
    for dt in np.diff(t):
        r = max(radius[-1], 1e-9)
        radius.append(max(r - dt * ratio * sherwood(r) * DIFFUSIVITY / (2 * r), 0.0))
    return 100 * (1 - (np.array(radius) / RADIUS)**2)


def draw_transport():
    figure, axis = figures.plt.subplots(figsize=(6.4, 4.4), constrained_layout=True)
    for spacing, style in (("10.6", "C0--"), ("7.1", "C0-")):
        history = read_history(folder / f"transport_{spacing}.csv")
        axis.plot(history["time"], history["Relative_Volume_Loss"], style, label=f"points {spacing} µm apart")
        print(f"transport, {spacing} um: " + ", ".join(
            f"{np.interp(t, history['time'], history['Relative_Volume_Loss']):.1f} % at {t} s" for t in (0.02, 0.04, 0.06, 0.08)))
    print("Sherwood numbers: " + ", ".join(f"{name} {layer(name):.2f}" for name in ("layer", "layer_thin", "layer_upwind"))
          + f"; of the correlation {correlation(RADIUS):.2f}, {correlation(RADIUS / 2):.2f}")
    t = np.linspace(0, 0.8, 8001)
    for label, sherwood, style in (("layer resolved (layer.yaml), round wire", of_layers(), "C3-"),
                                   ("Churchill & Bernstein, round wire", correlation, "k--")):
        loss = round_wire(t, sherwood)
        print(f"{label}: " + ", ".join(f"{np.interp(at, t, loss):.1f} % at {at} s" for at in (0.04, 0.1, 0.2))
              + f", all of it in {t[np.argmax(loss >= 100)]:.2f} s")
        axis.plot(t, loss, style, linewidth=0.9, label=label)
    axis.set(xlabel="time (s)", ylabel="volume loss (%)", title="surface always saturated")
    axis.legend(fontsize=8)
    save(figure, "transport.png")


def draw_coupling():
    figure, axes = figures.plt.subplots(2, 2, figsize=(10, 6), constrained_layout=True)
    for row, prefix, unit in ((axes[0], "", 3600.0), (axes[1], "transport_", 1.0)):
        for name, label in CRITERIA.items():
            file = "transport_10.6" if prefix and name == "volume" else prefix + name
            history = read_history(folder / f"{file}.csv")
            t, loss = history["time"] / unit, history["Relative_Volume_Loss"]
            row[0].plot(t, loss, "-", linewidth=1, label=f"{label}: {flows(file)} flows")
            row[1].step(t, 2e6 * history["DragX"], where="pre", linewidth=1)
            print(f"{file}: {flows(file)} flows; loss " + ", ".join(
                f"{np.interp(part * t[-1], t, loss):.4f}" for part in (0.125, 0.25, 0.5, 1.0)) + " %")
        row[0].set(xlabel="time (h)" if unit > 1 else "time (s)", ylabel="volume loss (%)")
        row[1].set(xlabel="time (h)" if unit > 1 else "time (s)", ylabel="drag of the last flow (µN/m)")
        row[0].legend(fontsize=7)
    save(figure, "coupling.png")


def draw_narrow():
    results = Results(str(folder / "narrow"))
    figure, axis = figures.plt.subplots(figsize=(8, 4.4), constrained_layout=True)
    step = results.steps[1]
    x = results.x[:, :2] * 1e6
    fluid, velocity = results.field("Fluid", step) == 1, results.field("Velocity", step)
    grid = np.meshgrid(np.linspace(-240, 440, 341), np.linspace(0, 150, 76))
    u, w = (griddata(x[fluid], velocity[fluid, a], tuple(grid), "linear") for a in (0, 1))
    solid = np.hypot(*grid) < 40
    u[solid] = w[solid] = np.nan
    shown = axis.pcolormesh(*grid, np.hypot(u, w), cmap="viridis")
    figure.colorbar(shown, ax=axis, label="speed (m/s)", orientation="horizontal", shrink=0.6, aspect=40)
    axis.streamplot(grid[0], grid[1], u, w, color="w", linewidth=0.5, density=1.2, arrowsize=0.6)
    axis.set(xlabel="x (µm)", ylabel="y (µm)", aspect="equal", title=f"tube of 150 µm, {results.time(step) / 3600:.2f} h")
    for name in ("narrow", "mg_pin"):
        history = read_history(folder / f"{name}.csv")
        print(f"{name}: {history['Relative_Volume_Loss'][-1]:.3f} % after 9 h; drag at first "
              f"{2e6 * history['DragX'][1]:.4g}, at the end {2e6 * history['DragX'][-1]:.4g} uN/m; {flows(name)} flows")
    save(figure, "narrow.png")


draw_transport()
draw_coupling()
draw_narrow()
