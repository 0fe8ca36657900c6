#!/usr/bin/python3
"""crevice.png, profile.png, history.png: the crevice against its two finite-volume models; plot.py [RESULTS]"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from crevice_run import CREVICE, DY, Run, saturated_from  # noqa: E402
from gap_averaged import HOUR, simulate  # noqa: E402
from pdplot_lib import figures  # noqa: E402
from trench import carve  # noqa: E402

FULL_CURRENT = CREVICE.currentPerSpeed * CREVICE.speed(CREVICE.saturation)[0]


def half_gap(x):
    return 0.5 * (CREVICE.mouthGap + (CREVICE.endGap - CREVICE.mouthGap) * x / CREVICE.length)


class Reference:
    """Of every whole hour: trench.py's two dimensions near the mouth from its start on, the rest gap-averaged."""

    def __init__(self):
        self.averaged, self.trench = simulate(CREVICE, cells=2032), carve(CREVICE)
        self.x = self.averaged.x
        self.depth = self.averaged.depth.copy()
        near = self.x < self.trench.x[-1]
        hours = np.rint(self.trench.times / HOUR).astype(int)
        for hour, depth in zip(hours, self.trench.depth):
            self.depth[hour, near] = np.interp(self.x[near], self.trench.x, depth)
        self.averagedSite = np.array([saturated_from(self.x, c) for c in self.averaged.concentration])
        self.site = self.averagedSite.copy()
        for hour, c in zip(hours[1:], self.trench.concentration[1:]):
            self.site[hour] = saturated_from(self.trench.x, np.mean(c[:, :-1], axis=1))


def save(figure, name):
    figure.savefig(folder / name, dpi=110)
    print(folder / name)


def draw_crevice(run, reference):
    """Along the crevice and, enlarged, the trench: damage of the metal, concentration of the electrolyte, and the walls
    of the models."""
    hours = (2, 5, 10, 20, 30, 50, 72)
    highest = (half_gap(0.0) + 1.05 * reference.averaged.depth.max()) * 1e6
    greys = figures.plt.cm.Greys(np.linspace(0.2, 1.0, 256))  # without white, which is where there is nothing
    greys = type(figures.plt.cm.viridis)(greys)
    figure, axes = figures.plt.subplots(len(hours), 2, figsize=(12, 1.75 * len(hours)), constrained_layout=True,
                                        sharex="col")
    edges = [np.append(at - 0.5 * step, at[-1] + 0.5 * step) * unit for at, step, unit in ((run.x, run.dx, 1e3),
                                                                                           (run.y, DY, 1e6))]
    for hour, row in zip(hours, axes):
        k = run.at(hour)
        damage, concentration = run.field("Damage", k), run.field("Concentration", k)
        isLiquid = damage >= 1.0
        isLiquid[~run.isMetal] = True
        walls = [half_gap(reference.x) + depth[hour] for depth in (reference.depth, reference.averaged.depth)]
        for axis, right in zip(row, (CREVICE.length, 3e-3)):
            metal = axis.pcolormesh(*edges, np.where(isLiquid, np.nan, damage).T, cmap=greys, vmin=0.0, vmax=1.0)
            liquid = axis.pcolormesh(*edges, np.where(isLiquid, concentration, np.nan).T / 1e3, cmap="viridis",
                                     vmin=0.0, vmax=CREVICE.saturation / 1e3)
            for wall, line in zip(walls, ("r-", "r:")):
                axis.plot(reference.x * 1e3, wall * 1e6, line, linewidth=0.8)
            axis.set_xlim(edges[0][0], right * 1e3)
            axis.set_ylim(0, highest)
        row[0].set_ylabel(f"{hour} h\ny (µm)")
    for axis in axes[-1]:
        axis.set_xlabel("x from the mouth (mm)")
    figure.colorbar(metal, ax=axes[: len(hours) // 2], label="damage of the metal", pad=0.01)
    figure.colorbar(liquid, ax=axes[len(hours) // 2:], label="C of the electrolyte (mol/L)", pad=0.01)
    figure.suptitle("scales of x and y differ; right: the trench; red: wall by finite volumes, dotted: averaged over "
                    "the gap", fontsize=10)
    save(figure, "crevice.png")


def draw_profile(run, reference):
    figure, (whole, trench) = figures.plt.subplots(1, 2, figsize=(11, 4), constrained_layout=True)
    hours = (2, 5, 10, 20, 30, 50, 72)
    for k, hour in enumerate(hours):
        colour, depth = figures.plt.cm.viridis(k / len(hours)), run.depth(run.at(hour))
        for axis in (whole, trench):
            axis.plot(run.x[run.isCrevice] * 1e3, depth * 1e6, ".", color=colour, markersize=3, label=f"{hour} h")
            axis.plot(reference.x * 1e3, reference.depth[hour] * 1e6, "-", color=colour, linewidth=0.9)
            axis.plot(reference.x * 1e3, reference.averaged.depth[hour] * 1e6, ":", color=colour, linewidth=0.9)
    whole.set_yscale("log")
    whole.set_ylim(1e-2, 1e3)
    trench.set_xlim(0, 3)
    for axis in (whole, trench):
        axis.set_xlabel("x from the mouth (mm)")
        axis.set_ylabel("depth (µm)")
        axis.grid(alpha=0.3)
    whole.set_title("points: peridynamics; lines: finite volumes, dotted: averaged over the gap", fontsize=9)
    trench.legend(fontsize=8)
    save(figure, "profile.png")


def draw_history(run, printed, reference):
    times = run.times[1:]
    site = np.array([run.active_site(k) for k in range(1, len(run.times))])
    deepest = np.array([run.depth(k).max() for k in range(1, len(run.times))])
    hours = reference.averaged.times
    exactSite = np.interp(times, hours, reference.site)
    exactDeepest = np.interp(times, hours, reference.depth.max(axis=1))
    figure, (left, middle, right) = figures.plt.subplots(1, 3, figsize=(14, 4), constrained_layout=True)
    left.plot(times / HOUR, site * 1e3, ".", label="peridynamics")
    left.plot(times / HOUR, exactSite * 1e3, "-", linewidth=0.9, label="finite volumes")
    left.plot(hours / HOUR, reference.averagedSite * 1e3, ":", linewidth=0.9, label="averaged over the gap")
    middle.plot(times / HOUR, deepest * 1e6, ".", label="peridynamics")
    middle.plot(times / HOUR, exactDeepest * 1e6, "-", linewidth=0.9, label="finite volumes")
    middle.plot(hours / HOUR, reference.averaged.depth.max(axis=1) * 1e6, ":", linewidth=0.9,
                label="averaged over the gap")
    middle.plot(times / HOUR, FULL_CURRENT / CREVICE.currentPerSpeed * times * 1e6, "--", linewidth=0.8,
                label="saturated electrolyte all the time")
    for shown, title, line in ((run, f"factor {CREVICE.factor:g}", "."), (printed, "rates as printed", "x")):
        peak = [np.nanmax(shown.field("Current_Density", k)) for k in range(1, len(shown.times))]
        right.semilogy(shown.times[1:] / HOUR, peak, line, markersize=4, label=title)
    averaged = reference.averaged
    right.semilogy(np.array(averaged.time) / HOUR, averaged.peak, "-", linewidth=0.9,
                   label=f"averaged over the gap, factor {CREVICE.factor:g}")
    for axis, title in ((left, "99.5 % saturated from (mm from the mouth)"), (middle, "largest depth (µm)"),
                        (right, "highest current density (A/m²)")):
        axis.set_xlabel("t (h)")
        axis.set_ylabel(title)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    save(figure, "history.png")
    for hour in (2, 5, 10, 20, 30, 50, 72):
        k = int(np.argmin(np.abs(times - hour * HOUR)))
        off, deeper = site[k] - exactSite[k], deepest[k] / exactDeepest[k] - 1
        print(f"{times[k] / HOUR:g} h: 99.5 % saturated from {site[k] * 1e3:.3f} mm, {100 * off / exactSite[k]:+.2f} % "
              f"({100 * off / CREVICE.length:+.2f} % of L); largest depth {deepest[k] * 1e6:.2f} um, "
              f"{100 * deeper:+.2f} %")


def half_widths(x, depth):
    """How far from the deepest place, to mouth and closed end, it is half as deep."""
    top = int(np.argmax(depth))
    return (x[top] - np.interp(0.5 * depth[top], depth[: top + 1], x[: top + 1]),
            np.interp(-0.5 * depth[top], -depth[top:], x[top:]) - x[top])


def print_trench(run, printed, reference):
    for name, x, depth in (("peridynamics", run.x[run.isCrevice], run.depth(-1)),
                           ("finite volumes", reference.x, reference.depth[-1]),
                           ("averaged over the gap", reference.x, reference.averaged.depth[-1])):
        mouthSide, endSide = half_widths(x, depth)
        print(f"{name}: {depth.max() * 1e6:.1f} um deep at {x[np.argmax(depth)] * 1e3:.3f} mm; half as deep "
              f"{mouthSide * 1e6:.0f} um nearer to the mouth and {endSide * 1e6:.0f} um nearer to the closed end; "
              f"lost {np.mean(depth) * CREVICE.length:.4g} m2")
    print(f"with the printed rates: deepest {printed.depth(-1).max() * 1e6:.3g} um")


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
model = Reference()
factorFifteen, printedRates = Run(folder / "crevice"), Run(folder / "printed")
draw_crevice(factorFifteen, model)
draw_profile(factorFifteen, model)
draw_history(factorFifteen, printedRates, model)
print_trench(factorFifteen, printedRates, model)
