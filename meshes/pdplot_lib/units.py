"""Units of fields, and the prefix that makes numbers readable."""
import numpy as np

_UNITS = {
    "Displacement": "m", "Coordinates": "m", "Model_Coordinates": "m", "Velocity": "m/s", "Force_Density": "N/m³",
    "External_Force_Density": "N/m³", "Temperature": "K", "Bond_Stress": "Pa", "Volume": "m³", "Horizon": "m",
    "Stored_Elastic_Energy_Density": "J/m³", "Stored_Elastic_Energy": "J", "Kinetic_Energy": "J",
}
_PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")]


def unit_of(field):
    """Empty for pure numbers and for what only the deck knows."""
    return _UNITS.get(field, "")


def scaled(limit, unit):
    """(factor, unit with prefix) so that `limit` times the factor is between 1 and 1000."""
    if unit not in ("m", "Pa", "J", "N", "m/s") or not np.isfinite(limit) or limit == 0:
        return 1.0, unit
    for value, prefix in _PREFIXES:
        if limit >= 0.9999 * value:
            return 1 / value, prefix + unit
    return 1.0, unit


def time_text(seconds):
    """A time in the unit that people use for its size."""
    for value, name in ((86400 * 2, "d"), (3600 * 2, "h")):
        if seconds >= value:
            return f"{seconds / (86400 if name == 'd' else 3600):.4g} {name}"
    if seconds == 0 or seconds >= 1:
        return f"{seconds:.4g} s"
    for value, name in ((1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")):
        if seconds >= value:
            return f"{seconds / value:.4g} {name}"
    return f"{seconds:.3g} s"


def with_unit(name, unit):
    return f"{name.replace('_', ' ')} ({unit})" if unit else name.replace("_", " ")
