"""An Abaqus model from its parts: one mesh, with sets and surfaces of all bodies."""
import re

import numpy as np

from .abaqus_elements import SIDES
from .abaqus_parts import Body
from .elements import LINEAR
from .errors import MeshError
from .placement import moved
from .raw import RawGroup, RawMesh, known_part, middles_off

_SIDE_KINDS = {2: "line", 3: "triangle", 4: "quad"}


class Model:
    """Bodies in one model: numbers of nodes and elements are those of all of it. reader: what went through the file."""

    def __init__(self, file_name, reader):
        self.file_name, self.reader = file_name, reader
        self.nodes, self.parts, self.bodies = [], [], {}
        self._add("", reader.model, lambda x: x)
        for part, keyword in reader.instances:
            self._add(part.name.upper(), part, moved(keyword))
        if not reader.instances:
            for name, part in reader.parts.items():  # a part that is saved by itself
                self._add(name, part, lambda x: x)
        if not any(len(nodes) for nodes in self.nodes) or not self.parts:
            raise MeshError(f"{file_name}: no nodes and elements of an Abaqus mesh")

    def _add(self, key, part, move):
        first = sum(map(len, self.nodes))
        if key in self.bodies:
            raise MeshError(f"{self.file_name}: two instances are called {part.name}")
        body = Body(self.file_name, part, first, list(range(len(self.parts), len(self.parts) + len(part.blocks))))
        self.nodes += [move(x) for x in part.coordinates]
        for _, kind, connectivity in part.blocks:
            self.parts.append((kind, body.nodes(connectivity, "elements name")))
        self.bodies[key] = body

    def mesh(self):
        nodes = np.concatenate(self.nodes)
        names = self._names()
        groups, node_sets, sections = {}, {}, []
        for body in self.bodies.values():
            for key, (name, _) in body.part.element_sets.items():
                group = groups[body, key] = RawGroup(names(body, name))
                self._fill(group, body, name)
            for key, (name, _) in body.part.node_sets.items():
                if ("NSET", key) not in self.reader.hidden:
                    node_sets[names(body, name)] = self._set_nodes(body, name)
            sections += self._sections(body, groups)
        shown = [group for (_, key), group in groups.items() if ("ELSET", key) not in self.reader.hidden
                 or group in sections]
        for body in self.bodies.values():
            shown += [self._surface(body, name, names(body, name)) for name in body.part.surfaces]
        mesh = RawMesh(nodes, [self._known(kind, nodes, indices) for kind, indices in self.parts],
                       [group for group in shown if group.members], node_sets)
        mesh.sections = [group for group in sections if group.members]
        mesh.notes = self.reader.notes + (["blocks are the element sets of *SECTIONs"] if mesh.sections else [])
        return mesh

    def _known(self, kind, nodes, indices):
        if kind == "line3" and len(indices):  # the middle node is the second or the last
            indices = min(indices, indices[:, [0, 2, 1]], key=lambda tried: middles_off(kind, nodes, tried))
        return known_part(self.file_name, kind, indices)

    def _names(self):
        """How a set of a body is called: with the instance before it where several bodies have one of this name."""
        count = {}
        for body in self.bodies.values():
            part = body.part
            for name in {*part.element_sets, *part.node_sets, *(name.upper() for name in part.surfaces)}:
                count[name] = count.get(name, 0) + 1
        return lambda body, name: f"{body.part.name}.{name}" if count[name.upper()] > 1 and body.part.name else name

    def _sections(self, body, groups):
        """Groups that sections name; a set that nobody named is called as its material."""
        found = []
        for name, material, place in body.part.sections:
            group = groups.get((body, name.upper()))
            if group is None:
                raise MeshError(f"{place}: there is no element set {name}")
            if ("ELSET", name.upper()) in self.reader.hidden and material:
                group.name = material
            if group not in found:
                found.append(group)
        return found

    def _body(self, body, instance):
        if instance is None:
            return body
        if instance.upper() not in self.bodies:
            raise MeshError(f"{self.file_name}: there is no instance {instance}")
        return self.bodies[instance.upper()]

    def _meant(self, body, labels, has):
        """(body, its labels): what a set of the model itself does not find there is in the only instance."""
        if body.part is not self.reader.model or len(self.bodies) != 2:
            return [(body, labels)]
        there, (other,) = has(body)(labels), [one for one in self.bodies.values() if one is not body]
        return [(body, labels[there]), (other, labels[~there])]

    def _set_nodes(self, body, name, depth=0):
        members = self._members(body.part.node_sets, name, depth)
        found = []
        for instance, what in members:
            owner = self._body(body, instance)
            if isinstance(what, tuple):
                group = RawGroup("")
                self._fill(group, owner, what[1])
                found += [np.unique(self.parts[part][1][rows]) for part, rows in group.members.items()]
            elif isinstance(what, str):
                found.append(self._set_nodes(owner, what, depth + 1))
            else:
                found += [one.nodes(labels, f"node set {name} names")
                          for one, labels in self._meant(owner, what, lambda one: one.has_nodes)]
        return np.unique(np.concatenate(found)) if found else np.array([], np.int64)

    def _fill(self, group, body, name, depth=0):
        for instance, what in self._members(body.part.element_sets, name, depth):
            owner = self._body(body, instance)
            if isinstance(what, str):
                self._fill(group, owner, what, depth + 1)
                continue
            for one, labels in self._meant(owner, what, lambda one: one.has_elements):
                for part, rows in one.elements(labels, f"element set {name} names").items():
                    group.add(part, rows)

    def _members(self, sets, name, depth):
        if name.upper() not in sets or depth > 50:
            raise MeshError(f"{self.file_name}: there is no set {name}, or it holds itself")
        return sets[name.upper()][1]

    def _surface(self, body, name, shown_name):
        group, found = RawGroup(shown_name), {}
        for row, place in body.part.surfaces[name]:
            side = re.fullmatch(r"[SE](\d)", row[1].upper()) if len(row) > 1 else None
            if side is None or not row[0]:
                self.reader.notes.append(f"{place}: surface {name}: {', '.join(row)} is left out; faces S1, S2 ... are "
                                         "understood")
                continue
            before, dot, member = row[0].rpartition(".")
            elements = RawGroup("")
            owner = self._body(body, before if dot else None)
            if member.isdigit():
                for one, labels in self._meant(owner, np.array([int(member)]), lambda one: one.has_elements):
                    for part, rows in one.elements(labels, f"surface {name} names").items():
                        elements.add(part, rows)
            else:
                self._fill(elements, owner, member)
            for part, rows in elements.members.items():
                kind, connectivity = self.parts[part]
                sides, index = SIDES.get(LINEAR.get(kind, kind), []), int(side.group(1)) - 1
                if index >= len(sides):
                    raise MeshError(f"{place}: surface {name}: a {kind} has no side {side.group(0)}")
                found.setdefault(len(sides[index]), []).append(connectivity[rows][:, sides[index]])
        for n_corners, corners in found.items():
            corners = np.concatenate(corners)
            group.add(len(self.parts), np.arange(len(corners)))
            self.parts.append((_SIDE_KINDS[n_corners], corners))
        return group
