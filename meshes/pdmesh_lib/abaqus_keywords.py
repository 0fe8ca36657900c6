"""The keyword blocks of an Abaqus input file, those of the files that it includes among them.

Rules of input: Abaqus Analysis User's Guide, "Input syntax rules".
"""
import re
from pathlib import Path

import numpy as np

from .errors import MeshError
from .text import number_of, numbers_of, read_text

_WORDS = re.compile(r'(?:[^,"]|"[^"]*")+')


class Keyword:
    """name: in upper case, without blanks; options: NAME -> value; place: "file:line"; rows: its data lines."""

    def __init__(self, head, place):
        words = [word.strip() for word in _WORDS.findall(head)]
        self.place, self.pieces = place, []  # (file, number of the first line, text)
        self.name = re.sub(r"\s", "", words[0]).upper() if words else ""
        self.options = {}
        for word in words[1:]:
            name, _, value = word.partition("=")
            self.options[" ".join(name.split()).upper()] = value.strip().strip('"')
        self._rows = None

    @property
    def rows(self):
        if self._rows is None:
            self._rows = [row for _, _, text in self.pieces for row in text.split("\n") if row and not row.isspace()]
        return self._rows

    def place_of(self, row):
        """file:line of a data line."""
        for file, first, text in self.pieces:
            for number, line in enumerate(text.split("\n"), first):
                if line and not line.isspace():
                    if row == 0:
                        return f"{file}:{number}"
                    row -= 1
        return self.place

    def allow(self, *names):
        """Refuses options that are not among `names`: what they change would be missing without a word."""
        for name in self.options:
            if name not in names:
                raise MeshError(f"{self.place}: *{self.name}: the option {name} is not understood (understood are "
                                f"{', '.join(names)}); let Abaqus/CAE write the mesh without it")

    def fields(self, row):
        """The fields of a data line; the last is not empty."""
        found = [word.strip().strip('"') for word in self.rows[row].split(",")]
        while found and not found[-1]:
            found.pop()
        return found

    def table(self, kind):
        """All numbers, [n], and how many each line has, [rows]; a comma at the end of a line adds none. A field that is
        left blank is 0 where `kind` is float."""
        rows = [row.rstrip().rstrip(",") for row in self.rows]
        counts = np.array([row.count(",") + 1 for row in rows], dtype=np.int64)
        text = ",".join(rows)
        if ",," not in "," + text.replace(" ", "").replace("\t", ""):
            numbers = numbers_of(text, kind, ",")
            if numbers is not None and len(numbers) == counts.sum():
                return numbers, counts
        return np.array([self.number(i, word, kind) for i, row in enumerate(rows) for word in row.split(",")],
                        dtype=kind), counts

    def number(self, row, word, kind):
        if not word.strip():
            if kind is float:
                return 0.0
            raise MeshError(f"{self.place_of(row)}: *{self.name}: a field is left blank")
        try:
            return number_of(word, kind)
        except ValueError as error:
            raise MeshError(f"{self.place_of(row)}: *{self.name}: {error}") from None


def keywords(file_name):
    """The keyword blocks in turn. Data lines at the head of an included file belong to the keyword before it."""
    current = None
    for head, file, line, text in _events(file_name, Path(file_name).parent):
        if head is not None:
            if current is not None:
                yield current
            current = Keyword(head, f"{file}:{line}")
        elif text and not text.isspace():
            if current is None:
                raise MeshError(f"{file}:{line}: numbers before the first *KEYWORD; is it an Abaqus input file?")
            current.pieces.append((file, line, text))
    if current is not None:
        yield current


def _events(file_name, folder, depth=0):
    """(head of a keyword or None, file, line, data lines) in turn."""
    if depth > 8:
        raise MeshError(f"{file_name}: files include each other without end")
    pieces = _pieces(file_name)
    yield None, file_name, 1, pieces[0]
    line = 1 + pieces[0].count("\n")
    for piece in pieces[1:]:
        head, _, body = piece.partition("\n")
        at, after = line, line + 1
        line += piece.count("\n")
        while head.rstrip().endswith(",") and body:  # a keyword goes on after a comma
            more, _, body = body.partition("\n")
            head, after = head.rstrip() + more if more.strip() else head, after + 1
        keyword = Keyword(head, f"{file_name}:{at}")
        wanted = keyword.options.get("INPUT")
        if keyword.name == "INCLUDE":
            yield from _events(_found(wanted, folder, file_name, keyword.place), folder, depth + 1)
        else:
            yield head, file_name, at, ""
            if wanted is not None and keyword.name in ("NODE", "ELEMENT", "NSET", "ELSET"):
                other = _found(wanted, folder, file_name, keyword.place)
                data, *more = _pieces(other)
                if more:
                    raise MeshError(f"{other}: *{keyword.name}, INPUT= reads lines of data, and there are keywords; "
                                    "*INCLUDE reads both")
                yield None, other, 1, data
        yield None, file_name, after, body


def _pieces(file_name):
    """What stands before the first keyword, and after the star of each; comments are blank lines."""
    text = re.sub(r"^[ \t]*\*\*.*$", "", read_text(file_name), flags=re.M)
    return re.split(r"^[ \t]*\*", text, flags=re.M)


def _found(name, folder, file_name, place):
    """Names are relative to the main input file; some programs write them relative to the file that has them."""
    if not name:
        raise MeshError(f"{place}: INPUT=FILE is missing")
    for candidate in (folder / name, Path(file_name).parent / name):
        if candidate.is_file():
            return str(candidate)
    raise MeshError(f"{place}: INPUT={name}: no such file beside the mesh")
