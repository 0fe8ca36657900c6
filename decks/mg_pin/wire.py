"""The wire of this scene and its scans, which several pictures show."""
from pathlib import Path

import numpy as np

RADIUS, SPEED, FILM = 40.0, 1.494, 4340 / 3600  # um, um/h = i/(zF C_solid) of 5.73 A/m2, h
FIRST_SCAN = 0.687  # h
hours, measured, deviation = np.loadtxt(Path(__file__).parent / "measured.csv", delimiter=",", skiprows=3).T


def exact_radius(t, speed=SPEED, film=FILM):
    """Of a round wire, um."""
    return RADIUS - speed * (t - film * (1 - np.exp(-t / film)) if film > 0 else t)


def draw_scans(axis, **style):
    style = {"markersize": 4, "label": "measured, with 1 sd", **style}
    axis.errorbar(hours, measured, yerr=deviation, fmt="ko", capsize=2, **style)


def off_scans(t, loss):
    """Of losses (% of the first scan) at the times t (h), at the scans after the first that they reach: standard
    deviations from the measured ones."""
    reached = (hours <= t[-1]) & (hours > hours[0])
    return (np.interp(hours[reached], t, loss) - measured[reached]) / deviation[reached]
