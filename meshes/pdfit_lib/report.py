"""What a fit leaves: table of iterations, residuals, results and a picture."""
import csv
import json
import os
from pathlib import Path

import numpy as np

from pdplot_lib.pictures import save
from pdplot_lib.units import time_unit, with_unit


def write(path, text):
    """Whole or not at all."""
    unfinished = Path(f"{path}.unfinished")
    unfinished.write_text(text, encoding="utf-8")
    os.replace(unfinished, path)


class Iterations:
    """The table, on the terminal and as <base>.fit.csv, rewritten after each row."""

    def __init__(self, problem, runs):
        self.problem, self.runs, self.rows = problem, runs, []
        names = [value.name + (f" ({value.unit})" if value.unit else "") for value in problem.values]
        self.widths = [max(12, len(name)) for name in names]
        what = "chi^2" if problem.has_deviations else "squares"
        self.header = ["iteration", "runs", what, *names]
        problem.print(f"{'iteration':>9}  {'runs':>5}  {what:>12}  " +
                      "  ".join(f"{name:>{width}}" for name, width in zip(names, self.widths)))

    def add(self, values, squares):
        self.rows.append([len(self.rows), self.runs.n_known, f"{squares:.9g}", *(f"{value:.9g}" for value in values)])
        self.problem.print(f"{len(self.rows) - 1:>9}  {self.runs.n_known:>5}  {squares:>12.5g}  " +
                           "  ".join(f"{value:>{width}.6g}" for value, width in zip(values, self.widths)))
        write(self.problem.base + ".fit.csv", _csv([self.header, *self.rows]))


def _csv(rows):
    class Lines(list):
        write = list.append
    lines = Lines()
    csv.writer(lines, lineterminator="\n").writerows(rows)
    return "".join(lines)


def write_residuals(problem, models):
    rows = [["series", "place", "time", "measured", "deviation", "model", "residual", "fitted"]]
    for series, model in zip(problem.series, models):
        for k, residual in enumerate(series.residuals(model)):
            rows.append([series.label, series.places[k], f"{series.time[k]:.9g}" if series.is_over_time else "",
                         f"{series.measured[k]:.9g}", f"{series.deviation[k]:.9g}" if series.deviation[k] > 0 else "",
                         _number(model[k]), _number(residual), str(bool(series.is_fitted[k])).lower()])
    write(problem.base + ".fit.residuals.csv", _csv(rows))


def _number(value):
    return f"{value:.9g}" if np.isfinite(value) else ""


def summary_of(series, model):
    """(root mean square of the residuals, largest) of fitted points and of the others; None where there are none."""
    residuals = series.residuals(model)
    result = []
    for those in (residuals[series.is_fitted], residuals[~series.is_fitted]):
        those = those[np.isfinite(those)]
        result.append((float(np.sqrt(np.mean(those**2))), float(np.max(np.abs(those)))) if len(those) else None)
    return result


def coarse_history(series, histories):
    """A warning where rows of the history are too far apart for points between them; empty where not."""
    if not series.is_over_time:
        return ""
    error = series.interpolation_error(histories)
    measured = series.measured[series.is_fitted]
    enough = 0.01 * np.max(np.abs(measured))
    if series.has_deviations and not series.is_logarithmic:
        enough = 0.2 * series.deviation[series.is_fitted].min()
    if error <= enough:
        return ""
    how = f"may be off by {error:.2g} {series.unit}".rstrip() if np.isfinite(error) else "cannot be judged"
    return (f"{series.label}: the history has so few rows that its values between them, linear in time, {how}: ask for "
            "more Load Steps, or a smaller History Frequency")


def write_results(problem, runs, fitted, judgement, models):
    values = [{"name": judged.value.name, "unit": judged.value.unit, "value": judged.number,
               "interval": judged.interval, "note": judged.note} for judged in judgement.values]
    series = []
    for one, model in zip(problem.series, models):
        those, others = summary_of(one, model)
        series.append({"label": one.label, "fitted": those and {"rms": those[0], "largest": those[1]},
                       "others": others and {"rms": others[0], "largest": others[1]}})
    result = {"writer": "pdfit", "converged": bool(fitted.is_converged), "message": fitted.message,
              "sum_of_squares": judgement.sum_of_squares, "degrees_of_freedom": judgement.degrees,
              "runs": runs.count, "runs_reused": runs.reused, "values": values,
              "correlation": [[_finite(c) for c in row] for row in judgement.correlation], "series": series}
    write(problem.base + ".fit.json", json.dumps(result, indent=2) + "\n")


def _finite(number):
    return float(number) if np.isfinite(number) else None


def draw(problem, judgement, models, histories):
    """A row a series: measured points with what the fitted values give, and residuals."""
    from pdplot_lib.figures import plt
    figure, axes = plt.subplots(len(problem.series), 2, figsize=(10, 3.4 * len(problem.series)), squeeze=False,
                                constrained_layout=True)
    for series, model, (left, right) in zip(problem.series, models, axes):
        unit = series.unit
        if series.is_over_time:
            _draw_over_time(left, right, series, model, histories)
        else:
            _draw_over_runs(left, right, series, model)
        left.set_ylabel(with_unit(series.column if series.is_over_time else "model", unit))
        left.set_title(series.label)
        what = "ln(model) - ln(measured)" if series.is_logarithmic else "model - measured"
        right.set_ylabel(with_unit(what, "standard deviations" if series.has_deviations else
                                   "" if series.is_logarithmic else unit))
        right.axhline(0.0, color="0.5", linewidth=0.8)
        if series.has_deviations:
            right.axhspan(-1.0, 1.0, color="0.92", zorder=0)
        for panel in (left, right):
            panel.grid(alpha=0.3)
        left.legend(fontsize=8)
    figure.suptitle("\n".join(judged.text() for judged in judgement.values), fontsize=9)
    save(figure, problem.base + ".fit.png", "pdfit", is_named=False)


def _marks(series):
    """(which points, filled or not, label)"""
    return [(those, {"mfc": color}, label) for those, color, label in
            ((series.is_fitted, "k", "measured"), (~series.is_fitted, "w", "measured, not fitted")) if those.any()]


def _draw_over_time(left, right, series, model, histories):
    history = histories[series.runs[0]]
    if series.time_unit:
        length, name = series.time_factor, series.time_unit
    else:
        length, name = time_unit(float(np.max(history["time"])))
    left.plot(history["time"] / length, history[series.column] * series.factor, "C0-", linewidth=1.2, label="fitted")
    residuals = series.residuals(model)
    for those, style, label in _marks(series):
        errors = np.where(series.deviation > 0, series.deviation, 0.0)[those]
        measured = series.measured[those]
        if series.is_logarithmic:
            errors = [measured * (1 - np.exp(-errors)), measured * (np.exp(errors) - 1)]
        left.errorbar(series.time[those] / length, measured, yerr=errors, fmt="ko", markersize=4, capsize=2,
                      label=label, **style)
        right.plot(series.time[those] / length, residuals[those], "ko", markersize=4, **style)
    if series.is_logarithmic:
        left.set_yscale("log")
    for panel in (left, right):
        panel.set_xlabel(f"time ({name})")


def _draw_over_runs(left, right, series, model):
    residuals = series.residuals(model)
    ends = [min(np.nanmin(model), series.measured.min()), max(np.nanmax(model), series.measured.max())]
    left.plot(ends, ends, "C0-", linewidth=1.2, label="model = measured")
    left.plot(series.measured, model, "ko", markersize=4, label="runs")
    if series.is_logarithmic:
        left.set(xscale="log", yscale="log")
        right.set_xscale("log")
    right.plot(series.measured, residuals, "ko", markersize=4)
    for panel in (left, right):
        panel.set_xlabel(with_unit("measured", series.unit))
