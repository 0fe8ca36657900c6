"""Calibration: values of decks that are adjusted to measured series."""
