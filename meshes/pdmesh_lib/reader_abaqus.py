"""Reads Abaqus input files: nodes, elements, node and element sets, surfaces.

meshio's reader gives elements to the wrong sets where *ELEMENT blocks share an ELSET or have none, knows few types, and
lays the nodes of several parts over each other. Keywords: Abaqus Keywords Reference Guide; node orders and faces:
Abaqus Elements Guide, "Solid isoparametric quadrilaterals and hexahedra", "... triangles, tetrahedra, and wedges".
"""
import re
import warnings
from pathlib import Path

import numpy as np

from .elements import ELEMENTS, LINEAR
from .errors import MeshError
from .raw import RawGroup, RawMesh, known_part, middles_off

_FAMILIES = [(r"[DA]?C3D|SC", "solid"), (r"CPS|CPEG?|[DA]C2D|M3D|SFM3D|STRI|S(?=\d)|R3D", "plane"),
             (r"T[23]D|R2D|SPRINGA?", "line"), (r"B[23]", "beam"), (r"MASS|ROTARYI", "point")]
_KINDS = {"solid": {4: "tetra", 5: "pyramid", 6: "wedge", 8: "hexahedron", 10: "tetra10", 15: "wedge15",
                    20: "hexahedron20"},
          "plane": {3: "triangle", 4: "quad", 6: "triangle6", 65: "triangle6", 8: "quad8", 9: "quad9"},
          "line": {2: "line", 3: "line3"}, "beam": {1: "line", 2: "line3", 3: "line"}, "point": {1: "vertex"}}
_NODES = {"pyramid": 5, **{name: len(element.nodes) for name, element in ELEMENTS.items()}}
# Corners of face S1, S2 ... of solids and edge S1, S2 ... of plane elements.
_SIDES = {"triangle": [(0, 1), (1, 2), (2, 0)], "quad": [(0, 1), (1, 2), (2, 3), (3, 0)],
          "tetra": [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)],
          "wedge": [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)],
          "hexahedron": [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]}
_SIDE_KINDS = {2: "line", 3: "triangle", 4: "quad"}
_GENERATORS = ("NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM")


def read_abaqus(file_name):
    reader = _Reader(file_name)
    for keyword, options, lines, place in _sections(file_name):
        reader.take(keyword, options, lines, place)
    return reader.mesh()


def _sections(file_name, depth=0):
    """(keyword, options, data lines, file:line) in turn; files that are included stand in for their line."""
    try:
        text = Path(file_name).read_text(encoding="latin-1")
    except OSError as error:
        raise MeshError(f"{file_name}: cannot be read: {error.strerror}") from None
    pieces = re.split(r"^[ \t]*\*(?!\*)", re.sub(r"^[ \t]*\*\*.*$", "", text, flags=re.M), flags=re.M)
    line = 1 + pieces[0].count("\n")
    for piece in pieces[1:]:
        head, _, body = piece.partition("\n")
        at = line
        line += piece.count("\n")
        while head.rstrip().endswith(","):  # a keyword goes on after a comma
            more, _, body = body.partition("\n")
            head = head.rstrip() + more
        words = [word.strip() for word in head.split(",")]
        options = {}
        for word in words[1:]:
            name, _, value = word.partition("=")
            options[name.strip().upper()] = value.strip().strip('"')
        keyword = words[0].upper()
        if keyword == "INCLUDE":
            if depth > 8:
                raise MeshError(f"{file_name}:{at}: files include each other without end")
            yield from _sections(Path(file_name).parent / options.get("INPUT", ""), depth + 1)
        else:
            yield keyword, options, [row for row in body.splitlines() if row.strip()], f"{file_name}:{at}"


class _Reader:
    def __init__(self, file_name):
        self.file_name = file_name
        self.labels, self.coordinates = [], []
        self.blocks = []  # (element labels, element type, connectivity in labels)
        self.node_sets, self.element_sets = {}, {}  # NAME -> (name as written, list of labels or of other names)
        self.surfaces, self.hidden, self.notes, self.n_instances = {}, set(), [], 0

    def take(self, keyword, options, lines, place):
        if keyword == "NODE":
            self._nodes(options, lines, place)
        elif keyword == "ELEMENT":
            self._elements(options, lines, place)
        elif keyword in ("NSET", "ELSET"):
            sets = self.node_sets if keyword == "NSET" else self.element_sets
            if keyword == "NSET" and "ELSET" in options:
                self.notes.append(f"{place}: node set {options.get('NSET')} of an element set is left out")
                return
            name = options.get(keyword)
            if not name:
                raise MeshError(f"{place}: *{keyword} needs {keyword}=NAME")
            if "INTERNAL" in options:
                self.hidden.add(name.upper())
            self._extend(sets, name, _members(lines, "GENERATE" in options, place))
        elif keyword == "SURFACE" and options.get("TYPE", "ELEMENT").upper() == "ELEMENT" and "NAME" in options:
            self.surfaces[options["NAME"]] = [[word.strip() for word in row.split(",")] for row in lines]
        elif keyword == "INSTANCE":
            self.n_instances += 1
            if self.n_instances > 1 or lines:
                raise MeshError(f"{place}: an assembly of several or moved instances; write the input without parts "
                                "and assemblies (Abaqus/CAE: Model > Edit Attributes > Do not use parts and "
                                "assemblies)")
        elif keyword in _GENERATORS:
            raise MeshError(f"{place}: *{keyword} is not understood; let Abaqus/CAE write all nodes and elements")

    @staticmethod
    def _extend(sets, name, members):
        sets.setdefault(name.upper(), (name, []))[1].extend(members)

    def _nodes(self, options, lines, place):
        count = 1 + max((row.count(",") for row in lines[:1]), default=3)
        try:
            table = _numbers(lines, float).reshape(len(lines), -1)
            if table.shape[1] != count or not 2 <= count <= 4:
                raise ValueError(f"{table.size} numbers on {len(lines)} lines")
        except ValueError:
            table = self._uneven_nodes(lines, place)
        table = np.column_stack([table, np.zeros((len(table), 4 - table.shape[1]))])
        self.labels.append(table[:, 0].astype(np.int64))
        self.coordinates.append(table[:, 1:])
        if "NSET" in options:
            self._extend(self.node_sets, options["NSET"], self.labels[-1].tolist())

    @staticmethod
    def _uneven_nodes(lines, place):
        """Lines that leave out coordinates, which are then 0."""
        rows = [row.rstrip(", \t").split(",") for row in lines]
        try:
            return np.array([(row + ["0"] * 4)[:4] for row in rows], dtype=float).reshape(-1, 4)
        except ValueError as error:
            raise MeshError(f"{place}: a line of *NODE is not `label, x, y, z`: {error}") from None

    def _elements(self, options, lines, place):
        kind = self._kind(options.get("TYPE", "").upper(), place)
        try:
            numbers = _numbers(lines, np.int64)
        except ValueError as error:
            raise MeshError(f"{place}: a line of *ELEMENT is not of whole numbers: {error}") from None
        width = 1 + _NODES[kind]
        if len(numbers) % width:
            raise MeshError(f"{place}: {options['TYPE']} has {width - 1} nodes, but the lines do not hold whole "
                            "elements")
        table = numbers.reshape(-1, width)
        self.blocks.append((table[:, 0], kind, table[:, 1:]))
        if "ELSET" in options:
            self._extend(self.element_sets, options["ELSET"], table[:, 0].tolist())

    @staticmethod
    def _kind(name, place):
        if re.match(r"[DAS]?C?AX|[DA]CAX", name):
            raise MeshError(f"{place}: axisymmetric elements {name}: their volumes are not those of a plane; mesh the "
                            "solid")
        for pattern, family in _FAMILIES:
            found = re.match(rf"(?:{pattern})(\d*)", name)
            kind = _KINDS[family].get(int(found.group(1) or {"point": 1, "line": 2}.get(family, 0))) if found else None
            if kind:
                return kind
        raise MeshError(f"{place}: elements of type {name or '(none)'} are not supported; mesh with solid (C3D...) or "
                        "plane (CPS..., CPE...) elements of first or second order")

    def mesh(self):
        if not self.labels or not self.blocks:
            raise MeshError(f"{self.file_name}: no nodes and elements of an Abaqus mesh")
        place = self._place(np.concatenate(self.labels))
        nodes = np.concatenate(self.coordinates)
        parts = []
        for labels, kind, connectivity in self.blocks:
            indices = place(connectivity, "elements name nodes")
            if kind == "line3":  # the middle node is the second or the last
                indices = min(indices, indices[:, [0, 2, 1]], key=lambda tried: middles_off(kind, nodes, tried))
            parts.append(known_part(self.file_name, kind, indices))
        groups = [self._group(name, self._resolve(self.element_sets, name))
                  for name in self.element_sets if name not in self.hidden]
        node_sets = {self.node_sets[name][0]: place(self._resolve(self.node_sets, name), f"node set {name} names nodes")
                     for name in self.node_sets if name not in self.hidden}
        for name, rows in self.surfaces.items():
            groups.append(self._surface(name, rows, parts))
        mesh = RawMesh(nodes, parts, [group for group in groups if group.members], node_sets)
        mesh.notes = self.notes
        return mesh

    def _place(self, labels):
        order = np.argsort(labels, kind="stable")
        ordered = labels[order]
        if (np.diff(ordered) == 0).any():
            raise MeshError(f"{self.file_name}: node {ordered[:-1][np.diff(ordered) == 0][0]} is defined twice; are "
                            "there several parts? Write the input without parts and assemblies")

        def place(wanted, what):
            found = np.minimum(np.searchsorted(ordered, wanted), len(ordered) - 1)
            if (ordered[found] != wanted).any():
                missing = wanted[ordered[found] != wanted][0]
                raise MeshError(f"{self.file_name}: {what} that are not there, as {missing}")
            return order[found]
        return place

    def _resolve(self, sets, name, depth=0):
        """Labels of a set, those of the sets in it included."""
        if name.upper() not in sets or depth > 50:
            raise MeshError(f"{self.file_name}: there is no set {name}, or it holds itself")
        labels = []
        for member in sets[name.upper()][1]:
            labels.extend([member] if isinstance(member, int) else self._resolve(sets, member, depth + 1).tolist())
        return np.array(labels, dtype=np.int64)

    def _group(self, name, labels):
        group = RawGroup(self.element_sets[name][0])
        for part, (mine, _, _) in enumerate(self.blocks):
            group.add(part, np.flatnonzero(np.isin(mine, labels)))
        return group

    def _surface(self, name, rows, parts):
        group, found = RawGroup(name), {}
        for row in rows:
            side = re.fullmatch(r"[SE](\d)", row[1].upper()) if len(row) > 1 else None
            if side is None:
                self.notes.append(f"surface {name}: {', '.join(row)} is left out; faces S1, S2 ... are understood")
                continue
            member = _label(row[0])
            labels = np.array([member]) if isinstance(member, int) else self._resolve(self.element_sets, member)
            for mine, kind, connectivity in self.blocks:
                sides, index = _SIDES.get(LINEAR.get(kind, kind), []), int(side.group(1)) - 1
                if index < len(sides):
                    corners = connectivity[np.isin(mine, labels)][:, sides[index]]
                    found.setdefault(len(sides[index]), []).append(corners)
        place = self._place(np.concatenate(self.labels))
        for n_corners, corners in found.items():
            corners = np.concatenate(corners)
            if len(corners):
                group.add(len(parts), np.arange(len(corners)))
                parts.append((_SIDE_KINDS[n_corners], place(corners, "surfaces name nodes")))
        return group


def _numbers(lines, kind):
    """All numbers of the lines in turn. Throws ValueError where there is anything else."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)  # how numpy tells of text that is no number
        try:
            return np.fromstring(",".join(row.rstrip().rstrip(",") for row in lines), dtype=kind, sep=",")
        except DeprecationWarning as warning:
            raise ValueError(str(warning)) from None


def _members(lines, is_generated, place):
    """Labels, or names of other sets, of *NSET and *ELSET."""
    rows = [[_label(word) for word in row.split(",") if word.strip()] for row in lines]
    if not is_generated:
        return [member for row in rows for member in row]
    try:
        return [label for row in rows for label in range(row[0], row[1] + 1, row[2] if len(row) > 2 else 1)]
    except (TypeError, IndexError, ValueError):
        raise MeshError(f"{place}: GENERATE needs lines of `first, last, step`") from None


def _label(word):
    """A whole number, with or without the name of the one instance before it, or a name."""
    word = word.strip().strip('"')
    number = word.rpartition(".")[2]
    return int(number) if number.isdigit() else number
