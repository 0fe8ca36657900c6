"""Runs of the crevice: what is read from their results."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "meshes"))

import numpy as np  # noqa: E402
from gap_averaged import HOUR, Crevice  # noqa: E402
from pdplot_lib.results import Results  # noqa: E402

DY = 1e-6
CREVICE = Crevice()


def saturated_from(x, c):
    """Where, coming from the mouth, C averaged over the height reaches 99.5 % of saturation: next to the active site,
    and to be had from all models alike; NaN where it does not."""
    level = 0.995 * CREVICE.saturation
    full = np.flatnonzero(c >= level)
    if len(full) == 0:
        return np.nan
    k = full[0]
    return x[k] - (x[k] - x[k - 1]) * (c[k] - level) / (c[k] - c[k - 1])


class Run:
    """Fields of a run of pdrun on its lattice, [columns along x, rows along y], NaN where there are no points."""

    def __init__(self, name):
        self.results = Results(name)
        corner = self.results.x.min(axis=0)
        self.dx = np.min(np.diff(np.unique(np.rint(self.results.x[:, 0] * 1e9)))) * 1e-9
        self.column = np.rint((self.results.x[:, 0] - corner[0]) / self.dx).astype(int)
        self.row = np.rint((self.results.x[:, 1] - corner[1]) / DY).astype(int)
        self.shape = self.column.max() + 1, self.row.max() + 1
        self.x = corner[0] + self.dx * np.arange(self.shape[0])
        self.y = corner[1] + DY * np.arange(self.shape[1])
        self.isCrevice = self.x > 0.0
        self.isMetal = self.field("Damage", 0) < 1.0
        self.times = np.array([self.results.time(step) for step in self.results.steps])

    def field(self, name, k):
        values = np.full(self.shape, np.nan)
        values[self.column, self.row] = self.results.field(name, self.results.steps[k])
        return values

    def depth(self, k):
        """Of the columns of the crevice: what is gone of their metal."""
        return np.sum(np.where(self.isMetal, self.field("Damage", k), 0.0), axis=1)[self.isCrevice] * DY

    def active_site(self, k):
        isLiquid = (self.field("Damage", k) >= 1.0) | ~self.isMetal
        mean = np.nanmean(np.where(isLiquid, self.field("Concentration", k), np.nan), axis=1)
        return saturated_from(self.x[self.isCrevice], mean[self.isCrevice])

    def at(self, hour):
        return int(np.argmin(np.abs(self.times - hour * HOUR)))
