"""A fit as pdrun hands it over: values, runs, and series of measurements."""
import json
from pathlib import Path

import numpy as np


class FitError(Exception):
    """Why a fit cannot go on: names the run or the value, and the remedy."""


class Value:
    """A value that is adjusted. The optimiser sees `scaled` ones: shares of the start, or logarithms."""

    def __init__(self, data):
        self.name, self.unit, self.factor = data["name"], data["unit"], data["factor"]
        self.start, self.scale, self.is_logarithmic = data["start"], data["scale"], data["logarithmic"]
        self.bounds = [self.scaled(bound) if bound is not None else limit
                       for bound, limit in ((data["lowest"], -np.inf), (data["highest"], np.inf))]

    def scaled(self, value):
        return float(np.log(value)) if self.is_logarithmic else value / self.scale

    def unscaled(self, scaled):
        return float(np.exp(scaled) if self.is_logarithmic else scaled * self.scale)

    def step(self, share):
        """Of differences, scaled."""
        return float(np.log1p(share)) if self.is_logarithmic else share

    def text(self, value, digits=6):
        return f"{value:.{digits}g}" + (f" {self.unit}" if self.unit else "")


class Series:
    """Measured points, and how they are compared with histories. Times in s, all else in the unit of the data."""

    def __init__(self, data):
        self.label, self.column, self.value_kind = data["label"], data["column"], data["value"]
        self.factor, self.unit = data["factor"], data["unit"]
        self.time_unit, self.time_factor = data["time unit"], data["time factor"]
        self.is_logarithmic = data["logarithmic"]
        points = data["points"]
        self.runs = np.array([point["run"] for point in points])
        self.time, self.measured, self.deviation = (np.array([float(point[key]) for point in points])
                                                    for key in ("time", "measured", "deviation"))
        self.is_fitted = np.array([point["fitted"] for point in points])
        self.places = [point["place"] for point in points]

    @property
    def is_over_time(self):
        return not self.value_kind

    @property
    def has_deviations(self):
        return bool(np.all(self.deviation[self.is_fitted] > 0))

    def model(self, histories):
        """What the histories of all runs {number: {column: rows}} give in place of the measured values; not a number
        where a run has none."""
        if self.is_over_time:
            time, column = finite_rows(histories[self.runs[0]], self.column)
            # Times of decimal numbers are met to rounding.
            slack = 1e-9 * np.abs(time).max(initial=0.0)
            at = np.where(np.abs(self.time - time[-1:]) <= slack, time[-1:], self.time) if len(time) else self.time
            values = np.interp(at, time, column, left=np.nan, right=np.nan) if len(time) else np.full(len(at), np.nan)
        else:
            values = np.array([value_of(*finite_rows(histories[run], self.column), self.value_kind)
                               for run in self.runs])
        return values * self.factor

    def interpolation_error(self, histories):
        """What linear interpolation between the rows of the history is off by at the fitted points, in the unit of the
        data, as its second differences say; not a number where there are too few rows for these."""
        time, column = finite_rows(histories[self.runs[0]], self.column)
        time, first = np.unique(time, return_index=True)
        column, at = column[first], self.time[self.is_fitted]
        if len(time) < 4:
            return np.nan
        slope = np.diff(column) / np.diff(time)
        curvature = np.abs(2 * np.diff(slope) / (time[2:] - time[:-2]))
        curvature = np.concatenate([curvature[:1], curvature, curvature[-1:]])
        row = np.clip(np.searchsorted(time, at) - 1, 0, len(time) - 2)
        here = np.maximum(curvature[row], curvature[row + 1])
        return float(np.max(np.abs((at - time[row]) * (time[row + 1] - at)) * here / 2)) * abs(self.factor)

    def residuals(self, model):
        """In standard deviations where there are any; of Logarithmic series those of logarithms."""
        with np.errstate(invalid="ignore", divide="ignore"):
            difference = np.log(model) - np.log(self.measured) if self.is_logarithmic else model - self.measured
            return difference / np.where(self.deviation > 0, self.deviation, 1.0 if not self.has_deviations else np.nan)

    def obstacle(self, model):
        """(row, why and what to do) of the first fitted point that cannot be compared; nothing where all can."""
        rows = np.flatnonzero(self.is_fitted & ~np.isfinite(self.residuals(model)))
        if not len(rows):
            return None
        value, why = model[rows[0]], f'"{self.column}" has no value there'
        if np.isfinite(value):
            why = f'"{self.column}" is {value:g}, which has no logarithm'
        elif self.value_kind == "Time Of Maximum":
            why = f'the maximum of "{self.column}" is reached at the start: nothing happened'
        return rows[0], why + "; set a later Final Time or leave the row out"


def finite_rows(history, column):
    if column not in history:
        raise FitError(f"no run writes the column \"{column}\"; there are: {', '.join(history)}")
    good = np.isfinite(history[column])
    return history["time"][good], history[column][good]


def value_of(time, column, kind):
    """Not a number where there is none: a maximum at the start is the time of nothing."""
    if not len(column) or (kind == "Time Of Maximum" and np.argmax(column) == 0):
        return np.nan
    return {"Final": lambda: column[-1], "Maximum": column.max, "Minimum": column.min,
            "Time Of Maximum": lambda: time[np.argmax(column)]}[kind]()


class Problem:
    def __init__(self, path):
        data = json.loads(Path(path).read_text(encoding="utf-8"))
        self.name, self.base, self.folder, self.program = (data[key] for key in ("name", "base", "folder", "program"))
        self.is_quiet, self.is_central = data["quiet"], data["central"]
        self.tolerance, self.difference_step = data["tolerance"], data["difference step"]
        self.max_iterations, self.processes = data["iterations"], data["processes"]
        self.values = [Value(value) for value in data["values"]]
        self.series = [Series(series) for series in data["series"]]
        self.runs = data["runs"]

    @property
    def has_deviations(self):
        return all(series.has_deviations for series in self.series)

    def unscaled(self, scaled):
        return [value.unscaled(u) for value, u in zip(self.values, scaled)]

    def text(self, values):
        return ", ".join(f"{value.name} {value.text(number)}" for value, number in zip(self.values, values))

    def overrides(self, run, values):
        """Texts path=value of a run with these values."""
        return [item["path"] + "=" + "".join(self._piece(piece, values) for piece in item["pieces"])
                for item in self.runs[run]["overrides"]]

    def _piece(self, piece, values):
        if isinstance(piece, str):
            return piece
        value, number = self.values[piece["value"]], float(values[piece["value"]])
        if piece["whole"]:
            return f"{number!r} {value.unit}".rstrip()
        number *= value.factor
        return f"({number!r})" if number < 0 else repr(number)

    def print(self, text):
        if not self.is_quiet:
            print(text, flush=True)
