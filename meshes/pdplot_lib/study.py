"""Pictures of the table of a study: error against work, and histories over time and against what was varied."""
import argparse
import csv
import itertools
import math
import sys
from pathlib import Path

import numpy as np

from .pictures import save
from .results import PlotError, history_units, read_history
from .units import time_unit, with_unit

_MARKERS = "os^vDP*X<>"
# What a column of the table may tell of a history, as in "Maximum Top_ReactionY".
_TIME = "Time Of Maximum"
_VALUES = ("Final", "Maximum", "Minimum", _TIME)
_OTHER_COLUMNS = ("label", "overrides", "results", "error", "seconds", "bond_updates")


class Table:
    """NAME.study.csv, which pdrun --study writes. rows: those of runs that did not fail."""

    def __init__(self, path):
        self.path = Path(path)
        try:
            with open(path, newline="", encoding="utf-8") as file:
                reader = csv.DictReader(file)
                self.columns = list(reader.fieldnames or [])
                rows = list(reader)
            self.rows = [row for row in rows if row["seconds"]]
        except (OSError, KeyError, ValueError, TypeError) as error:
            raise PlotError(f"{path}: cannot be read as the table of a study ({error})") from error
        if not self.rows:
            raise PlotError(f"{path}: no run has come to its end: nothing to draw")
        self.value_columns = [name for name in self.columns if _split(name)]
        self.swept = [name for name in self.columns if name not in _OTHER_COLUMNS and not _split(name)]

    def histories(self):
        """Columns of the runs' histories that the table has values of."""
        return list(dict.fromkeys(_split(name)[1] for name in self.value_columns))

    def series(self):
        """{label: its rows}"""
        return {label: [row for row in self.rows if row["label"] == label]
                for label in dict.fromkeys(row["label"] for row in self.rows)}

    def number(self, row, column):
        try:
            return float(row[column])
        except ValueError:
            return math.nan


def _split(column):
    """("Maximum", "Top_ReactionY") of "Maximum Top_ReactionY"; nothing of other columns."""
    for value in _VALUES:
        if column.startswith(value + " "):
            return value, column[len(value) + 1:]
    return None


def draw_errors(table, error, reference):
    from .figures import plt  # sets the style
    points = {label: [(table.number(row, "error"), float(row["seconds"]), float(row["bond_updates"])) for row in rows]
              for label, rows in table.series().items()}
    points = {label: [point for point in those if point[0] > 0.0] for label, those in points.items()}
    if not any(points.values()):
        raise PlotError(f"{table.path}: no run with an error above zero: nothing to draw on logarithmic axes")
    figure, panels = plt.subplots(1, 2, figsize=(10, 4.4), sharey=True, constrained_layout=True)
    for (label, those), marker in zip(points.items(), itertools.cycle(_MARKERS)):
        for panel, column in zip(panels, (1, 2)):
            if those:
                panel.loglog([point[column] for point in those], [point[0] for point in those], marker=marker,
                             markersize=5, linewidth=1.2, label=label)
    panels[0].set_xlabel("wall time (s)")
    panels[1].set_xlabel("directed bond-updates")
    panels[0].set_ylabel(f"error {error}".strip())
    for panel in panels:
        panel.grid(alpha=0.3, which="both")
    panels[1].legend(fontsize=8)
    if reference:
        figure.suptitle(f"reference: {reference}", fontsize=9)
    return figure


def draw_histories(table):
    """A row of panels a history: curves over time of all runs; its values against what was varied; the times of its
    maximum. A series has a line style and a marker, a run a colour."""
    from .figures import plt
    names = table.histories()
    path = _varied(table)
    kinds = [kind for kind in _VALUES if path and any(_split(column)[0] == kind for column in table.value_columns)]
    groups = [group for group in ([kind for kind in kinds if kind != _TIME], [kind for kind in kinds if kind == _TIME])
              if group]
    width = 1 + len(groups)
    figure, panels = plt.subplots(len(names), width, figsize=(4.8 * width, 3.2 * len(names)), squeeze=False,
                                  constrained_layout=True)
    runs = [(row, read_history(_history_of(table, row))) for row in table.rows]
    units = history_units(_history_of(table, table.rows[0]), names)
    for name, row in zip(names, panels):
        _draw_curves(row[0], table, runs, name, path, plt.get_cmap("viridis"))
        row[0].set_ylabel(with_unit(name, units[name]))
        for panel, group in zip(row[1:], groups):
            _draw_values(panel, table, name, path, group)
            what = ", ".join(kind.lower() for kind in group)
            panel.set_ylabel(with_unit(f"{what} {name}", "s" if group == [_TIME] else units[name]))
    _legends(figure, panels)
    return figure


def _history_of(table, row):
    return table.path.parent / (row["results"] + ".csv")


def _several(table):
    """Swept paths that have more than one value."""
    return [path for path in table.swept if len({row[path] for row in table.rows if row[path]}) > 1]


def _varied(table):
    """The swept path that the values are shown over: the first of numbers, or the first there is; None without."""
    several = _several(table)
    numeric = [path for path in several
               if all(math.isfinite(table.number(row, path)) for row in table.rows if row[path])]
    return (numeric or several or [None])[0]


def _short(path):
    """What names a deck path well enough: its last two parts."""
    return "/".join(path.split("/")[-2:])


def _draw_curves(panel, table, runs, name, path, colours):
    longest = max(np.max(history["time"]) for _, history in runs)
    seconds, unit = time_unit(longest)
    values = list(dict.fromkeys(row[path] for row, _ in runs if row[path])) if path else []
    many = len(table.series()) > 1
    styles = dict(zip(table.series(), itertools.cycle(("-", "--", ":", "-."))))
    for number, (row, history) in enumerate(runs):
        shade = values.index(row[path]) / max(1, len(values) - 1) if path and row[path] else None
        colour = colours(0.85 * shade) if shade is not None else f"C{number % 10}"
        value = ", ".join(f"{_short(other)} {row[other]}" for other in _several(table) if row[other])
        label = ", ".join(part for part in (row["label"] if many or not value else "", value) if part)
        panel.plot(history["time"] / seconds, history[name], color=colour, linestyle=styles[row["label"]],
                   linewidth=1.2, label=label)
    panel.set_xlabel(with_unit("time", unit))
    panel.grid(alpha=0.3)


def _draw_values(panel, table, name, path, kinds):
    several = len(table.series()) > 1
    for kind in kinds:
        column = f"{kind} {name}"
        for (label, rows), marker in zip(table.series().items(), itertools.cycle(_MARKERS)):
            rows = [row for row in rows if row[path] and math.isfinite(table.number(row, column))]
            if not rows:  # what it varies is something else
                continue
            numbers = [table.number(row, path) for row in rows]
            is_numeric = all(math.isfinite(number) for number in numbers)
            words = [label] * several + [kind.lower()] * (len(kinds) > 1)
            panel.plot(numbers if is_numeric else [row[path] for row in rows],
                       [table.number(row, column) for row in rows], marker=marker, markersize=5, linewidth=1.2,
                       label=", ".join(words))
            if is_numeric and numbers and min(numbers) > 0.0 and max(numbers) / min(numbers) >= 30.0:
                panel.set_xscale("log")
    panel.set_xlabel(_short(path))
    panel.grid(alpha=0.3, which="both")


def _legends(figure, panels):
    """Curves have one legend below all, which many runs need; values one in the panel where it says something."""
    for row in panels:
        for panel in row[1:]:
            if len([text for text in panel.get_legend_handles_labels()[1] if text]) > 1:
                panel.legend(fontsize=8)
    handles, labels = panels[0][0].get_legend_handles_labels()
    if len(labels) > 1:
        columns = max(1, min(len(labels), 70 * panels.shape[1] // (8 + max(map(len, labels)))))
        figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=columns, fontsize=8)


def _draw(options):
    table = Table(options.table)
    stem = str(table.path.with_suffix(""))
    stem = stem[:-len(".study")] if stem.endswith(".study") else stem
    has_errors, has_histories = "error" in table.columns, bool(table.value_columns)
    if options.output and has_errors and has_histories:
        raise PlotError(f"-o {options.output}: {table.path} has errors and histories, two pictures; leave -o out")
    if has_errors:
        save(draw_errors(table, options.error, options.reference), options.output or stem + ".study.png", "pdstudy",
             is_named=bool(options.output))
    if has_histories:
        save(draw_histories(table), options.output or stem + ".histories.png", "pdstudy",
             is_named=bool(options.output))


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="pdstudy", description="Pictures of the table of a study.",
                                     epilog="sample run: pdstudy hydrogen_diffusion.study.csv -o study.png")
    parser.add_argument("table", help="NAME.study.csv, which pdrun --study writes")
    parser.add_argument("--reference", default="", help="what the errors are taken against, for the title")
    parser.add_argument("--error", default="", help="name of the error norm, for the axis")
    parser.add_argument("-o", "--output", help="picture to write (.png, .pdf, .svg); default: NAME.study.png for "
                                               "errors, NAME.histories.png for histories")
    try:
        _draw(parser.parse_args(arguments))
    except PlotError as error:
        print(f"pdstudy: {error}", file=sys.stderr)
        return 2
    return 0
