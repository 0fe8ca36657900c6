"""Numbers in text files, as people and programs write them."""
import re
import warnings

import numpy as np

from .errors import MeshError


def read_text(file_name):
    """The whole file, line ends as \\n, without a byte order mark. Bytes that are no UTF-8 are Latin letters."""
    try:
        with open(file_name, "rb") as file:
            data = file.read()
    except OSError as error:
        raise MeshError(f"{file_name}: cannot be read: {error.strerror}") from None
    if data[:2] in (b"\xff\xfe", b"\xfe\xff") or b"\0" in data[:200]:
        raise MeshError(f"{file_name}: no plain text (UTF-16, or binary); save it as text in UTF-8")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def numbers_of(text, kind, separator):
    """All numbers of a text in bulk; None where there is anything else."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)  # how numpy tells of text that is no number
        try:
            return np.fromstring(text, dtype=kind, sep=separator)
        except (DeprecationWarning, ValueError):
            return None


def number_of(word, kind):
    """One number: exponents of Fortran (1.5D-3) too, and whole numbers with a decimal point (12.0, 1.2e1). Throws
    ValueError, which says what is wrong."""
    plain = re.sub(r"(?<=[\d.])[dD](?=[-+]?\d)", "e", word.strip())
    try:
        value = float(plain)
    except ValueError:
        hint = f"; write {plain.replace(',', '.')}" if re.fullmatch(r"[-+]?\d+,\d+([eE][-+]?\d+)?", plain) else ""
        raise ValueError(f"`{word.strip()}` is not a number{hint}") from None
    if not np.isfinite(value) or "_" in plain:
        raise ValueError(f"`{word.strip()}` is not a finite number")
    if kind is float:
        return value
    if value != np.floor(value):
        raise ValueError(f"`{word.strip()}` is not a whole number")
    if abs(value) >= 2**63:
        raise ValueError(f"`{word.strip()}` is too large")
    return int(plain) if re.fullmatch(r"[-+]?\d+", plain) else int(value)
