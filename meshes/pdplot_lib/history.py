"""Curves of what a run has recorded over time."""
import numpy as np

from .figures import plt
from .results import PlotError
from .units import time_unit, with_unit


def history_panels(runs, columns=None, against=None, units=None):
    """Histories of several runs: a panel for each column. runs: [(label, {column: values})]; units: {column: unit}."""
    first, units = runs[0][1], units or {}
    against = found_columns(first, against)[0] if against else ("time" if "time" in first else "step")
    if columns:
        columns = [name for wanted in columns for name in found_columns(first, wanted)]
    else:
        columns = [name for name in first if name not in ("step", "time", against)]
        # What is the same all along, as a reaction across the plane, says nothing.
        columns = [name for name in columns if any(np.ptp(run.get(name, 0.0)) > 0 for _, run in runs)] or columns
    if not columns:
        raise PlotError("the history has no columns; name computes for the whole body under Output Variables")
    across = 1 if len(columns) == 1 else 2
    rows = -(-len(columns) // across)
    figure, axes = plt.subplots(rows, across, figsize=(5.4 * across, 3.2 * rows), squeeze=False,
                                constrained_layout=True)
    for axis in axes.ravel()[len(columns):]:
        axis.axis("off")
    length, across_label = _axis(runs, against, units)
    for axis, column in zip(axes.ravel(), columns):
        for label, history in runs:
            if column in history and against in history:
                axis.plot(history[against] / length, history[column], label=label, linewidth=1.2)
        axis.set_xlabel(across_label)
        axis.set_ylabel(with_unit(column, units.get(column, "")))
        axis.grid(alpha=0.3)
        if len(runs) > 1:
            axis.legend()
    return figure


def _axis(runs, against, units):
    """(what the column is divided by, label): times in the unit that people use, or counted as the run counts them."""
    unit = units.get(against, "")
    if against != "time":
        return 1.0, with_unit(against, unit)
    if unit not in ("", "s"):
        return 1.0, unit
    seconds, unit = time_unit(max(np.max(run["time"]) for _, run in runs if "time" in run))
    return seconds, with_unit(against, unit)


def found_columns(history, wanted):
    """Columns that `wanted` means: itself, in any case of letters, or the components of a vector."""
    if wanted in history:
        return [wanted]
    lower = wanted.lower()
    alike = [name for name in history if name.lower() == lower]
    parts = [name for name in history if name[:-1].lower() == lower and name[-1] in "XYZ"]
    found = alike or [name for name in parts if np.any(history[name])] or parts
    if not found:
        raise PlotError(f"no column {wanted} in the history (there are: {', '.join(history)}); "
                        "name it under Output Variables")
    return found
