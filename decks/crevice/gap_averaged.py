#!/usr/bin/python3
"""Crevice corrosion averaged over the gap, by finite volumes; shares nothing with the library.

The gap is hundreds of times shorter than the crevice, so the concentration C hardly varies across it. Along x, from
the mouth (x = 0, C = 0) to the closed end (x = L), with the half gap h(x, t) = h0(x) + s(x, t), where s is the depth
eaten of one wall,

    d(h C)/dt = d/dx(h D dC/dx) + C_solid ds/dt,    C <= C_sat,    0 <= ds/dt <= v(C) = i(C)/(z F C_solid),

and at each x either C = C_sat or ds/dt = v(C). It leaves out what a deep trench changes: differences of C across it,
and the slope of its walls; trench.py has both.

Sample runs:
  gap_averaged.py                              the alloy 625 crevice, rate factor 15
  gap_averaged.py --factor 1                   with the rates as printed the attack dies out
  gap_averaged.py --gap 50 10 --csv a.csv      the gap at mouth and end, um; depth and C of every hour into a.csv
  gap_averaged.py --ignition 400 500 600 --find-factor    the rate factors above which these widths, um, ignite
"""
import argparse
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.linalg import solve_banded

FARADAY = 96485.33212  # C/mol
HOUR = 3600.0


def alloy_625(factor):
    """i(C) of alloy 625, A/m2, and its slope; C in mol/m3. These are i(pH) and pH(C) of Jafarzadeh, Zhao, Shakouri and
    Bobaru, Electrochim. Acta 401 (2022) 139512, eq. 23-25, times a factor, with exp(-0.723 pH) and C
    in mol/L: with exp(-723 pH), as printed, i overflows where pH < 0."""

    def current(c):
        decay = 7.405 * np.exp(-0.08036e-3 * c)
        power = 1.151 * np.exp(-0.723 * (decay - 6.498))
        i = factor * 1e4 * 10.0 ** (power - 7.647)  # 1e4: A/cm2 to A/m2
        return i, i * np.log(10.0) * power * 0.723 * 0.08036e-3 * decay

    return current


@dataclass(frozen=True)
class Crevice:
    """The problem; lengths in m, concentrations in mol/m3."""

    length: float = 12.7e-3
    mouthGap: float = 50e-6  # of the whole gap, as endGap
    endGap: float = 10e-6
    diffusivity: float = 720e-12  # m2/s
    saturation: float = 5600.0
    solid: float = 140000.0
    charge: float = 2.37
    factor: float = 15.0  # on the printed rates
    ignition: float = 500e-6  # width at the closed end where C starts high
    ignitionShare: float = 0.99  # of saturation
    current: object = None  # C -> i (A/m2), di/dC; by default that of alloy 625 times the factor

    @property
    def currentPerSpeed(self):
        """A/m2 per m/s: by Faraday's law."""
        return self.charge * FARADAY * self.solid

    def speed(self, c):
        """v(C) of bare metal, m/s, and its slope."""
        current = self.current or alloy_625(self.factor)
        return tuple(value / self.currentPerSpeed for value in current(c))


def slow_from(times, sites, limit, per=10 * HOUR, window=2 * HOUR):
    """Time and place from which on the active site drifts, in every later `window`, by less than `limit` (m) in `per`;
    NaN where it never comes to that."""
    t = np.arange(times[0], times[-1] - window + 1.0, 60.0)
    speed = np.abs(np.interp(t + window, times, sites) - np.interp(t, times, sites)) / window
    moving = np.flatnonzero(speed >= limit / per)
    first = moving[-1] + 1 if len(moving) else 0
    return (t[first], float(np.interp(t[first], times, sites))) if first < len(t) else (np.nan, np.nan)


@dataclass
class Result:
    """Times in s; rows of `depth` and `concentration` are snapshots at `times`, columns cells with centres `x`."""

    crevice: Crevice
    x: np.ndarray
    times: np.ndarray
    depth: np.ndarray
    concentration: np.ndarray
    rejected: int = 0  # steps
    iterations: int = 0  # of Newton's method
    massError: float = 0.0  # largest, of all that was dissolved or there at the start
    # One entry a step, and one at the start:
    time: list = field(default_factory=list)
    site: list = field(default_factory=list)  # where the current density is highest
    peak: list = field(default_factory=list)  # that current density, A/m2
    total: list = field(default_factory=list)  # current of one wall per width, A/m
    outflow: list = field(default_factory=list)  # through half of the mouth so far, per width, mol/m

    @property
    def steps(self):
        return len(self.time) - 1

    @property
    def trench(self):
        """Largest depth at the end, and its place."""
        k = int(np.argmax(self.depth[-1]))
        return self.depth[-1, k], self.x[k]

    def site_at(self, t):
        return np.interp(t, self.time, self.site)

    def stop(self, drift=0.01):
        return slow_from(self.time, self.site, drift * self.crevice.length)

    def is_alive(self):
        """Whether at the end the peak current is at least half of that of a saturated electrolyte."""
        return self.peak[-1] > 0.5 * self.crevice.currentPerSpeed * self.crevice.speed(self.crevice.saturation)[0]


@dataclass
class State:
    u: np.ndarray  # places on the graph of rate against C, see Stepper
    content: np.ndarray  # h C, mol/m2
    depth: np.ndarray
    rate: np.ndarray  # ds/dt
    outflow: float = 0.0


class Stepper:
    """Steps of Alexander's SDIRK method of second order (L-stable; SIAM J. Numer. Anal. 14 (1977) 1006).

    A cell's unknown is u, a place on the kinked graph of dissolution rate against C: for u <= 0 C = C_sat + u and the
    rate is v(C), for u > 0 C = C_sat and the rate v(C_sat) (1 - u/C_sat). So Newton's method on u is the active-set
    method for the condition that either C = C_sat or the metal is bare. (Where a cell fills up within a step, the second
    stage may take back with a negative rate what the first had too much; over the step nothing is plated.)"""

    gamma = 1.0 - 0.5 * np.sqrt(2.0)
    maximumIterations = 25
    tolerance = 1e-11  # of Newton's last change, of saturation

    def __init__(self, crevice, cells):
        self.crevice, self.cells, self.dx = crevice, cells, crevice.length / cells
        self.x = (np.arange(cells) + 0.5) * self.dx
        self.halfGap = 0.5 * (crevice.mouthGap + (crevice.endGap - crevice.mouthGap) * self.x / crevice.length)
        self.fullSpeed = crevice.speed(crevice.saturation)[0]
        self.iterations = 0

    def start(self):
        p = self.crevice
        # A cell that the edge of the region cuts keeps its part of the mass.
        share = np.clip((self.x - p.length + p.ignition) / self.dx + 0.5, 0.0, 1.0)
        c = p.ignitionShare * p.saturation * share
        return State(c - p.saturation, self.halfGap * c, np.zeros(self.cells), p.speed(c)[0])

    def on_graph(self, u):
        """C, ds/dt, and their derivatives by u."""
        saturation, isBare = self.crevice.saturation, u <= 0.0
        c = saturation + np.minimum(u, 0.0)
        speed, slope = self.crevice.speed(c)
        rate = np.where(isBare, speed, self.fullSpeed * (1.0 - u / saturation))
        return c, rate, isBare * 1.0, np.where(isBare, slope, -self.fullSpeed / saturation)

    def half_gap_at_mouth(self, h):
        return h[0] - self.halfGap[0] + 0.5 * self.crevice.mouthGap

    def fluxes(self, c, h):
        """h D dC/dx of all faces, from the mouth to the closed end."""
        flux = np.zeros(self.cells + 1)
        flux[1:-1] = 0.5 * (h[1:] + h[:-1]) * self.crevice.diffusivity * np.diff(c) / self.dx
        flux[0] = self.half_gap_at_mouth(h) * self.crevice.diffusivity * c[0] / (0.5 * self.dx)
        return flux

    def gain(self, flux, rate):
        return np.diff(flux) / self.dx + self.crevice.solid * rate

    def jacobian(self, c, cByU, h, hByU, rateByU, tau):
        """Of the residual of `solve`, in the bands of solve_banded."""
        perLength, share = self.crevice.diffusivity / self.dx, tau / self.dx
        mean = 0.5 * (h[1:] + h[:-1]) * perLength
        byH = 0.5 * perLength * np.diff(c)
        byLeft, byRight = byH * hByU[:-1] - mean * cByU[:-1], byH * hByU[1:] + mean * cByU[1:]  # of fluxes, inner faces
        bands = np.zeros((3, self.cells))
        bands[0, 1:], bands[2, :-1] = -share * byRight, share * byLeft
        bands[1] = hByU * c + h * cByU - tau * self.crevice.solid * rateByU
        bands[1, :-1] -= share * byLeft
        bands[1, 1:] += share * byRight
        bands[1, 0] += share * 2.0 * perLength * (self.half_gap_at_mouth(h) * cByU[0] + c[0] * hByU[0])
        return bands

    def solve(self, u, content, depth, tau):
        """The u of content and depth that have moved on by tau of their rates, those rates, and the flux through the
        mouth; None where Newton's method fails, as it may in a step that is too long."""
        saturation = self.crevice.saturation
        for _ in range(self.maximumIterations):
            self.iterations += 1
            c, rate, cByU, rateByU = self.on_graph(u)
            h = self.halfGap + depth + tau * rate
            residual = h * c - content - tau * self.gain(self.fluxes(c, h), rate)
            try:
                change = solve_banded((1, 1), self.jacobian(c, cByU, h, tau * rateByU, rateByU, tau), -residual)
            except (np.linalg.LinAlgError, ValueError):
                return None
            wanted = np.maximum(u + change, -saturation)
            # What crosses the kink stops beyond it, to be judged by the slope that holds there.
            crosses = (u > 0.0) != (wanted > 0.0)
            wanted[crosses] = np.where(u[crosses] > 0.0, -1e-14, 1e-14) * saturation
            isDone = np.max(np.abs(wanted - u)) < self.tolerance * saturation and not np.any(crosses)
            u = wanted
            if isDone:
                c, rate, _, _ = self.on_graph(u)
                flux = self.fluxes(c, self.halfGap + depth + tau * rate)
                return u, self.gain(flux, rate), rate, flux[0]
        return None

    def step(self, old, length):
        """The state after a step, and how far it is from the first-order method's (of saturation, or of the gap); None
        where there is no solution."""
        tau, ahead = self.gamma * length, (1.0 - self.gamma) * length
        first = self.solve(old.u, old.content, old.depth, tau)
        if first is None:
            return None
        u, gain, rate, mouth = first
        second = self.solve(u, old.content + ahead * gain, old.depth + ahead * rate, tau)
        if second is None:
            return None
        newU, newGain, newRate, newMouth = second
        # Content from the rates rather than from u: mass is kept to rounding, whatever Newton's tolerance.
        new = State(newU, old.content + ahead * gain + tau * newGain, old.depth + ahead * rate + tau * newRate, newRate,
                    old.outflow + ahead * mouth + tau * newMouth)
        h = self.halfGap + new.depth
        offDepth, offContent = tau * (newRate - rate), tau * (newGain - gain)
        offC = (offContent - self.on_graph(newU)[0] * offDepth) / h
        return new, max(np.max(np.abs(offC)) / self.crevice.saturation, np.max(np.abs(offDepth) / h))

    def active_site(self, state):
        """Place of the highest rate."""
        k, rate, isFull = int(np.argmax(state.rate)), state.rate, state.u > 0.0
        edge = k if isFull[k] else k + 1
        if 0 < edge < self.cells and isFull[edge] and not isFull[edge - 1]:
            # Saturation begins in this cell, which is bare over the part that its rate tells.
            return self.x[edge] + self.dx * (np.clip(rate[edge] / self.fullSpeed, 0.0, 1.0) - 0.5)
        if 0 < k < self.cells - 1 and rate[k - 1] + rate[k + 1] < 2.0 * rate[k]:
            bend = rate[k - 1] - 2.0 * rate[k] + rate[k + 1]
            return self.x[k] + self.dx * np.clip(0.5 * (rate[k - 1] - rate[k + 1]) / bend, -0.5, 0.5)
        return self.x[k]


def record(result, stepper, state, now):
    p = result.crevice
    result.time.append(now)
    result.site.append(stepper.active_site(state))
    result.peak.append(p.currentPerSpeed * np.max(state.rate))
    result.total.append(p.currentPerSpeed * np.sum(state.rate) * stepper.dx)
    result.outflow.append(state.outflow)


def simulate(crevice, finalTime=72 * HOUR, cells=1016, tolerance=1e-3, snapshots=72, fixedStep=None):
    """Integrates to finalTime (s) in steps that differ by `tolerance` at most from the first-order method, or of
    `fixedStep`. `snapshots`: how many, evenly spaced, beside the start. RuntimeError where steps get too small."""
    stepper = Stepper(crevice, cells)
    times = finalTime * np.arange(snapshots + 1) / snapshots
    result = Result(crevice, stepper.x, times, np.zeros((snapshots + 1, cells)), np.zeros((snapshots + 1, cells)))
    state, now, proposed = stepper.start(), 0.0, fixedStep or 1e-3
    initialMass = np.sum(state.content) * stepper.dx
    record(result, stepper, state, now)
    for k, end in enumerate(times):
        while now < end * (1.0 - 1e-12):
            left = end - now
            # The last two steps to a snapshot are of a length.
            length = left if proposed >= left * (1.0 - 1e-9) else min(proposed, left if fixedStep else 0.5 * left)
            new, error = stepper.step(state, length) or (None, np.inf)
            if new is None or (not fixedStep and error > tolerance):
                result.rejected += 1
                proposed = length * max(0.2, 0.8 * np.sqrt(tolerance / error))
                if fixedStep or proposed < 1e-12 * finalTime:
                    raise RuntimeError(f"no solution of a step of {length:g} s at {now:g} s")
                continue
            state, now = new, now + length
            record(result, stepper, state, now)
            known = initialMass + crevice.solid * np.sum(state.depth) * stepper.dx
            there = np.sum(state.content) * stepper.dx + state.outflow
            result.massError = max(result.massError, abs(there - known) / known)
            if not fixedStep:
                better = length * min(2.0, 0.8 * np.sqrt(tolerance / max(error, 1e-12)))
                proposed = max(better, proposed) if length < proposed else better
        result.depth[k], result.concentration[k] = state.depth, state.content / (stepper.halfGap + state.depth)
    result.iterations = stepper.iterations
    return result


def least_factor(crevice, low=0.5, high=200.0, precision=1e-3, **options):
    """The rate factor above which the attack lives on, by bisection; NaN where there is none up to `high`. What lives
    after 6 h stays alive: a region that dies takes an hour or two."""

    def lives(factor):
        return simulate(replace(crevice, factor=factor), finalTime=6 * HOUR, snapshots=1, **options).is_alive()

    if not lives(high):
        return np.nan
    while high > low * (1.0 + precision):
        middle = np.sqrt(low * high)
        low, high = (low, middle) if lives(middle) else (middle, high)
    return high


def write_csv(result, name):
    rows = [(t, x, s, c) for t, depth, concentration in zip(result.times, result.depth, result.concentration)
            for x, s, c in zip(result.x, depth, concentration)]
    np.savetxt(name, rows, delimiter=",", header="t (s),x (m),depth (m),C (mol/m3)", comments="", fmt="%.8g")


def print_summary(result):
    depth, place = result.trench
    limit = result.crevice.speed(result.crevice.saturation)[0] * result.times[-1]
    print(f"{'alive' if result.is_alive() else 'died out'} at {result.times[-1] / HOUR:g} h; depth {depth * 1e6:.4g} um "
          f"at x = {place * 1e3:.4g} mm (with saturated electrolyte all the time: {limit * 1e6:.4g} um)")
    if result.is_alive():
        for drift in (0.01, 0.005, 0.0025):
            t, x = result.stop(drift)
            print(f"active site drifts less than {100 * drift:g} % of L in 10 h from {t / HOUR:.3g} h on, "
                  f"then at {x * 1e3:.4g} mm")
    print(f"highest current density {max(result.peak):.4g} A/m2, at the end {result.peak[-1]:.4g}; "
          f"{result.steps} steps, {result.rejected} rejected, {result.iterations} Newton iterations; "
          f"mass kept to {result.massError:.1e}")


def main():
    base = Crevice()
    parser = argparse.ArgumentParser(description="Gap-averaged crevice corrosion of alloy 625.")
    parser.add_argument("--gap", type=float, nargs=2, default=[50.0, 10.0], metavar="UM", help="at mouth and end")
    parser.add_argument("--diffusivity", type=float, default=base.diffusivity, help="m2/s")
    parser.add_argument("--saturation", type=float, default=base.saturation, help="mol/m3")
    parser.add_argument("--factor", type=float, default=base.factor, help="on the printed rates")
    parser.add_argument("--ignition", type=float, nargs="+", default=[500.0], metavar="UM",
                        help="width of the region that starts the attack")
    parser.add_argument("--find-factor", action="store_true", help="that each of these widths needs")
    parser.add_argument("--hours", type=float, default=72.0)
    parser.add_argument("--cells", type=int, default=1016)
    parser.add_argument("--tolerance", type=float, default=1e-3, help="of a step, of saturation")
    parser.add_argument("--csv", help="depth and concentration at 72 times")
    given = parser.parse_args()
    numbers = {"cells": given.cells, "tolerance": given.tolerance}
    for width in given.ignition:
        crevice = Crevice(mouthGap=given.gap[0] * 1e-6, endGap=given.gap[1] * 1e-6, diffusivity=given.diffusivity,
                          saturation=given.saturation, factor=given.factor, ignition=width * 1e-6)
        if given.find_factor:
            print(f"{width:g} um: lives on from a rate factor of {least_factor(crevice, **numbers):.4g} on")
            continue
        result = simulate(crevice, given.hours * HOUR, **numbers)
        print_summary(result)
        if given.csv:
            write_csv(result, given.csv)


if __name__ == "__main__":
    main()
