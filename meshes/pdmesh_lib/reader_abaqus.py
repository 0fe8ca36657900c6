"""Reads Abaqus input files: nodes, elements, node and element sets, surfaces, sections, parts and their instances.

meshio's reader gives elements to the wrong sets where *ELEMENT blocks share an ELSET or have none, knows few types, and
lays the nodes of several parts over each other. Keywords: Abaqus Keywords Reference Guide.
"""
import re

import numpy as np

from .abaqus_elements import N_NODES, kind_of
from .abaqus_keywords import keywords
from .abaqus_model import Model
from .abaqus_parts import Part
from .errors import MeshError
from .placement import axes_of, cylindrical

_MOST_GENERATED = 10**8  # labels of a set; more are a slip, and fill the memory
_GENERATORS = ("NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SUBSTRUCTURE", "SYMMETRICMODELGENERATION")


def read_abaqus(file_name, skip):
    reader = _Reader(file_name, skip)
    for keyword in keywords(file_name):
        reader.take(keyword)
    return Model(file_name, reader).mesh()


class _Reader:
    """Goes through the keywords once. instances: [(part, data of its placement)]."""

    def __init__(self, file_name, skip):
        self.file_name, self.skip = file_name, skip
        self.model = self.current = Part()
        self.axes = None  # of *SYSTEM
        self.parts, self.instances, self.hidden, self.notes = {}, [], set(), []

    def take(self, keyword):
        name = keyword.name
        if name == "NODE":
            self._nodes(keyword)
        elif name == "ELEMENT":
            self._elements(keyword)
        elif name in ("NSET", "ELSET"):
            self._set(keyword)
        elif name == "SURFACE":
            self._surface(keyword)
        elif name == "SYSTEM":
            self.axes = axes_of(keyword)
        elif name in ("PART", "INSTANCE"):
            self._begin(keyword)
        elif name in ("ENDPART", "ENDINSTANCE"):
            self.current, self.axes = self.model, None
        elif name.endswith("SECTION") and "ELSET" in keyword.options:
            self.current.sections.append((keyword.options["ELSET"], keyword.options.get("MATERIAL"), keyword.place))
        elif name in _GENERATORS:
            raise MeshError(f"{keyword.place}: *{name} is not understood; let Abaqus/CAE write all nodes and elements")

    def _begin(self, keyword):
        name = keyword.options.get("NAME", "")
        if not name:
            raise MeshError(f"{keyword.place}: *{keyword.name} needs NAME=")
        self.axes = None
        if keyword.name == "PART":
            self.current = self.parts[name.upper()] = Part(name)
            return
        part = keyword.options.get("PART", "")
        if part.upper() not in self.parts:
            raise MeshError(f"{keyword.place}: there is no *PART, NAME={part} before this instance of it")
        self.current = Part(name, self.parts[part.upper()])
        self.instances.append((self.current, keyword))

    def _nodes(self, keyword):
        keyword.allow("NSET", "SYSTEM", "INPUT")
        numbers, counts = keyword.table(float)
        if not len(counts):
            return
        if counts.max() > 7 or counts.min() < 2:
            row = int(np.flatnonzero((counts > 7) | (counts < 2))[0])
            raise MeshError(f"{keyword.place_of(row)}: a line of *NODE is `label, x, y, z`, with decimal points; this "
                            f"one has {counts[row]} numbers")
        if counts.max() > 4 and not any("." in row for row in keyword.rows):
            raise MeshError(f"{keyword.place_of(0)}: a line of *NODE is `label, x, y, z`; these have {counts[0]} whole "
                            "numbers: decimal commas? Write decimal points")
        table = np.zeros((len(counts), max(int(counts.max()), 4)))  # coordinates that are left out are 0
        table[np.arange(table.shape[1]) < counts[:, None]] = numbers
        labels = table[:, 0].astype(np.int64)
        bad = np.flatnonzero((labels != table[:, 0]) | (labels < 1))
        if len(bad):
            raise MeshError(f"{keyword.place_of(int(bad[0]))}: the label of a node is a whole number of 1 or more, not "
                            f"{table[bad[0], 0]:g}")
        self.current.labels.append(labels)
        self.current.coordinates.append(self._global(table[:, 1:4], keyword))
        if "NSET" in keyword.options:
            self._extend(self.current.node_sets, keyword.options["NSET"], [(None, labels)])

    def _global(self, x, keyword):
        system = keyword.options.get("SYSTEM", "R").upper()
        if system == "S":
            raise MeshError(f"{keyword.place}: nodes in spherical coordinates (SYSTEM=S) are not understood; let "
                            "Abaqus/CAE write them in Cartesian ones")
        if system not in ("R", "C"):
            raise MeshError(f"{keyword.place}: SYSTEM={system}; known are R (Cartesian) and C (cylindrical)")
        x = cylindrical(x) if system == "C" else x
        return x if self.axes is None else self.axes[0] + x @ self.axes[1]

    def _elements(self, keyword):
        keyword.allow("TYPE", "ELSET", "INPUT", "SOLID ELEMENT NUMBERING")
        name = keyword.options.get("TYPE", "").upper()
        if self.skip.wants(name):
            goes_on = [row.rstrip().endswith(",") for row in keyword.rows]
            first = [row for row, after in enumerate([False] + goes_on[:-1]) if not after] if goes_on else []
            labels = np.array([keyword.number(row, keyword.rows[row].split(",")[0], int) for row in first],
                              dtype=np.int64)
            self.skip.count(name, len(labels))
            self.current.skipped.append(labels)
        else:
            kind = kind_of(name, keyword.place)
            labels, connectivity = self._connectivity(keyword, name, N_NODES[kind])
            self.current.blocks.append((labels, kind, connectivity))
        if "ELSET" in keyword.options:
            self._extend(self.current.element_sets, keyword.options["ELSET"], [(None, labels)])

    @staticmethod
    def _connectivity(keyword, name, n_nodes):
        if any(re.search(r"[A-Za-z_]", row) for row in keyword.rows[:1]):
            raise MeshError(f"{keyword.place}: elements {name} name nodes of instances; they join parts, and are no "
                            f"part of a mesh: leave them out by --skip {name}")
        numbers, counts = keyword.table(np.int64)
        # A line that ends in a comma goes on in the next.
        goes_on = np.array([row.rstrip().endswith(",") for row in keyword.rows], dtype=bool)
        starts = np.flatnonzero(np.concatenate([[True], ~goes_on[:-1]])) if len(counts) else np.array([], int)
        sizes = np.add.reduceat(counts, starts) if len(starts) else counts
        wrong = np.flatnonzero(sizes != 1 + n_nodes)
        if len(wrong):
            raise MeshError(f"{keyword.place_of(int(starts[wrong[0]]))}: {name} has {n_nodes} nodes, and this element "
                            f"{sizes[wrong[0]] - 1}; a line goes on in the next where it ends in a comma")
        table = numbers.reshape(-1, 1 + n_nodes)
        return table[:, 0], table[:, 1:]

    def _set(self, keyword):
        keyword.allow(keyword.name, "ELSET", "GENERATE", "INSTANCE", "INTERNAL", "UNSORTED", "INPUT")
        name = keyword.options.get(keyword.name)
        if not name:
            raise MeshError(f"{keyword.place}: *{keyword.name} needs {keyword.name}=NAME")
        is_nodes = keyword.name == "NSET"
        if "INTERNAL" in keyword.options:
            self.hidden.add((keyword.name, name.upper()))
        instance = keyword.options.get("INSTANCE")
        if is_nodes and "ELSET" in keyword.options:
            members = [(instance, ("ELSET", keyword.options["ELSET"]))]
        else:
            members = _members(keyword, instance)
        self._extend(self.current.node_sets if is_nodes else self.current.element_sets, name, members)

    @staticmethod
    def _extend(sets, name, members):
        sets.setdefault(name.upper(), (name, []))[1].extend(members)

    def _surface(self, keyword):
        name = keyword.options.get("NAME")
        kind = keyword.options.get("TYPE", "ELEMENT").upper()
        if not name or kind not in ("ELEMENT", "NODE") or {"COMBINE", "CROP"} & set(keyword.options):
            self.notes.append(f"{keyword.place}: surface {name} is left out: it is not made of elements or nodes")
        elif kind == "NODE":
            members = [_member(keyword.fields(row)[0], None, keyword, row) for row in range(len(keyword.rows))]
            self._extend(self.current.node_sets, name, members)
        else:
            self.current.surfaces.setdefault(name, []).extend(
                (keyword.fields(row), keyword.place_of(row)) for row in range(len(keyword.rows)))


def _members(keyword, instance):
    """Members of *NSET and *ELSET, as Part has them."""
    if not any(re.search(r'[A-Za-z"_]', row) for row in keyword.rows):
        numbers, counts = keyword.table(np.int64)
        if "GENERATE" in keyword.options:
            return [(instance, _generated(keyword, numbers, counts))]
        return [(instance, numbers)] if len(numbers) else []
    if "GENERATE" in keyword.options:
        raise MeshError(f"{keyword.place}: GENERATE needs lines of `first, last, step`")
    return [_member(word, instance, keyword, row) for row in range(len(keyword.rows)) for word in keyword.fields(row)
            if word]


def _generated(keyword, numbers, counts):
    found, at = [], 0
    for row, count in enumerate(counts):
        first, last, step = [*numbers[at:at + count], 1][:3] if count in (2, 3) else (0, 0, 0)
        if step < 1 or last < first or (last - first) // step > _MOST_GENERATED:
            raise MeshError(f"{keyword.place_of(row)}: GENERATE needs lines of `first, last, step`")
        found.append(np.arange(first, last + 1, step))
        at += count
    return np.concatenate(found) if found else numbers


def _member(word, instance, keyword, row):
    """A label, or the name of a set, either with the name of an instance before it."""
    if re.fullmatch(r"\d+(\.0*)?", word):
        return instance, np.array([int(float(word))])
    before, dot, name = word.rpartition(".")
    name = name.strip('"')
    if not name:
        raise MeshError(f"{keyword.place_of(row)}: `{word}` is neither a label nor the name of a set")
    return (before.strip('"') if dot else instance), (np.array([int(name)]) if name.isdigit() else name)
