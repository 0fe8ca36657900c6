"""How far cracks grow in a cycle over the range of K: the diagram in which Paris' law is a straight line."""
import numpy as np

from .figures import plt
from .history import found_columns
from .results import PlotError
from .units import with_unit

PIECES = 12  # of the growth of a run: a crack goes row by row of points, and rates are means over several


def growth_rates(cycles, lengths, ranges, pieces=PIECES):
    """(mean range, growth in a cycle) over equal pieces of the growth. Arrays of one number a step; the range of a step
    holds until the next."""
    loaded = np.argmax(ranges > 0.0)  # a history begins before any equilibrium
    cycles, lengths, ranges = cycles[loaded:], lengths[loaded:], ranges[loaded:]
    grown, first = np.unique(np.maximum.accumulate(lengths), return_index=True)
    if len(grown) < 3:
        raise PlotError("the crack has not grown: there is no rate to draw")
    ends = np.linspace(grown[0], grown[-1], min(pieces, len(grown) - 1) + 1)
    at = np.interp(ends, grown, cycles[first])
    total = np.concatenate([[0.0], np.cumsum(ranges[:-1] * np.diff(cycles))])
    steps = np.diff(at)
    passed = steps > 0.0  # what breaks at once takes no cycles
    means = np.diff(np.interp(at, cycles, total))[passed] / steps[passed]
    return means, np.diff(ends)[passed] / steps[passed]


def exponent_of(ranges, rates):
    """Of the power law through them; None where the range stays as it is."""
    usable = ranges > 0.0
    if np.ptp(np.log(ranges[usable])) < 0.1:
        return None
    return np.polyfit(np.log(ranges[usable]), np.log(rates[usable]), 1)[0]


def growth_panel(runs, length, against, units):
    """Rates of several runs on axes of logarithms. runs: [(label, {column: values})]; units: {column: unit}."""
    figure, axis = plt.subplots(figsize=(5.4, 4.0), constrained_layout=True)
    for label, history in runs:
        length_column, range_column = found_columns(history, length)[0], found_columns(history, against)[0]
        ranges, rates = growth_rates(history["time"], history[length_column], history[range_column])
        unit = units.get(range_column, "")
        factor, unit = (1e-6, "MPa m^0.5") if unit == "Pa m^0.5" else (1.0, unit)
        exponent = exponent_of(ranges, rates)
        axis.loglog(ranges * factor, rates, "o", fillstyle="none",
                    label=label if exponent is None else f"{label}: exponent {exponent:.2f}")
        axis.set_xlabel(with_unit(range_column, unit))
        unit = units.get(length_column, "")
        axis.set_ylabel(f"{with_unit(length_column, '')} a cycle" + (f" ({unit})" if unit else ""))
    axis.grid(which="both", alpha=0.3)
    axis.legend()
    return figure
