"""Units of fields, and the prefix that makes numbers readable."""
import re

import numpy as np

# Of results that do not say what they are measured in: those written before fields had the attribute "units".
_UNITS = {
    "Displacement": "m", "Coordinates": "m", "Model_Coordinates": "m", "Velocity": "m/s", "Force_Density": "N/m³",
    "External_Force_Density": "N/m³", "Temperature": "K", "Bond_Stress": "Pa", "Volume": "m³", "Horizon": "m",
    "Stored_Elastic_Energy_Density": "J/m³", "Stored_Elastic_Energy": "J", "Kinetic_Energy": "J",
    "Corrosion_Depth": "m", "Current_Density": "A/m²", "Interface_Area_Density": "1/m", "Solid_Concentration": "mol/m³",
    "Saturation_Concentration": "mol/m³", "Dissolution_Rate": "mol/(m³ s)",
}
_HISTORY_UNITS = [("reaction", "N"), ("crack_length", "m"), ("crack_tip", "m"), ("crack_area", "m²"), ("energy", "J"),
                  ("work", "J"), ("j_integral", "J/m²"), ("mass_loss", "kg"), ("volume_loss", "m³"),
                  ("dissolved_amount", "mol"), ("depth", "m"), ("deepest_place", "m"), ("pit_width", "m"),
                  ("front_speed", "m/s"), ("current_density", "A/m²"), ("current_place", "m"),
                  ("total_current", "A")]
_POWERS = dict(zip("23456789", "²³⁴⁵⁶⁷⁸⁹"))
OF_THE_DECK = "in the deck's unit"
_PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")]


def unit_of(field):
    """Of a field of old results. Empty for pure numbers and for what only the deck knows, as the names of computes."""
    return _UNITS.get(field, "Pa" if "stress" in field.lower() else "")


def printed(unit):
    """A unit as results have it ("J/m3", "1") as it is read: "J/m³", ""."""
    return "" if unit == "1" else re.sub("(?<=[A-Za-z])[2-9]", lambda power: _POWERS[power.group()], unit)


def scaled(limit, unit):
    """(factor, unit with prefix) so that `limit` times the factor is between 1 and 1000."""
    if unit not in ("m", "Pa", "J", "N", "m/s") or not np.isfinite(limit) or limit == 0:
        return 1.0, unit
    for value, prefix in _PREFIXES:
        if limit >= 0.9999 * value:
            return 1 / value, prefix + unit
    return 1.0, unit


def plain(number):
    """Three digits, without an exponent where people would not write one."""
    text = f"{number:.3g}"
    return f"{float(text):.0f}" if "e" in text and 1 <= abs(number) < 1e7 else text


def time_text(seconds, longest=None):
    """A time in the unit that people use for its size, or for that of `longest`, so that all of a run have one."""
    length, name = time_unit(seconds if longest is None else longest)
    return f"{seconds / length:.4g} {name}"


def time_unit(longest):
    """(seconds in it, name) of the unit that people use for a time of this size."""
    for value, length, name in ((2 * 86400, 86400, "d"), (2 * 3600, 3600, "h"), (1, 1, "s"), (1e-3, 1e-3, "ms"),
                                (1e-6, 1e-6, "µs"), (1e-9, 1e-9, "ns")):
        if longest >= value:
            return length, name
    return 1.0, "s"


def history_unit(column):
    """Of a column of an old history, whose name the deck chooses: known where it says what it is."""
    for part, unit in _HISTORY_UNITS:
        if part in column.lower():
            return unit
    return ""


def with_unit(name, unit):
    return f"{name.replace('_', ' ')} ({unit})" if unit else name.replace("_", " ")
