"""Parts of an Abaqus model and their instances: nodes, elements and sets by their labels."""
import numpy as np

from .errors import MeshError


class Part:
    """What *PART, *INSTANCE or, outside of them, the model itself holds. Members of sets: (name of the instance or
    None, labels or the name of another set)."""

    def __init__(self, name="", other=None):
        self.name = name
        self.labels, self.coordinates = list(other.labels) if other else [], list(other.coordinates) if other else []
        self.blocks = list(other.blocks) if other else []  # (labels, element type, connectivity in labels)
        self.skipped = list(other.skipped) if other else []  # labels of elements that are left out
        self.node_sets = _copied(other.node_sets) if other else {}  # NAME -> (name as written, members)
        self.element_sets = _copied(other.element_sets) if other else {}
        self.surfaces = dict(other.surfaces) if other else {}  # name -> rows of an element-based surface
        self.sections = list(other.sections) if other else []  # (element set, material, place)


def _copied(sets):
    return {key: (name, list(members)) for key, (name, members) in sets.items()}


class Body:
    """A part where it stands in the model: labels to numbers of nodes and elements. first_node: of the model's nodes;
    parts: numbers of its blocks among those of the model."""

    def __init__(self, file_name, part, first_node, parts):
        self.file_name, self.part, self.parts = file_name, part, parts
        self.of = f" of {part.name}" if part.name else ""
        labels = np.concatenate(part.labels) if part.labels else np.array([], np.int64)
        self._nodes, self._node_labels = self._sorted(labels, "node")
        self._nodes = self._nodes + first_node
        labels = [labels for labels, _, _ in part.blocks]
        owners = [np.full(len(found), number) for found, number in zip(labels, parts)]
        indices = [np.arange(len(found)) for found in labels]
        labels += part.skipped
        owners += [np.full(len(found), -1) for found in part.skipped]
        indices += [np.zeros(len(found), np.int64) for found in part.skipped]
        order, self._element_labels = self._sorted(np.concatenate(labels) if labels else np.array([], np.int64),
                                                   "element")
        self._owners = np.concatenate(owners)[order] if labels else order
        self._indices = np.concatenate(indices)[order] if labels else order

    def _sorted(self, labels, what):
        order = np.argsort(labels, kind="stable")
        ordered = labels[order]
        twice = np.flatnonzero(np.diff(ordered) == 0)
        if len(twice):
            raise MeshError(f"{self.file_name}: {what} {ordered[twice[0]]}{self.of} is defined twice; are there "
                            "several meshes in one file? Number them apart, or give each a *PART")
        return order, ordered

    def has_nodes(self, labels):
        return _found(self._node_labels, labels)[1]

    def has_elements(self, labels):
        return _found(self._element_labels, labels)[1]

    def nodes(self, labels, what):
        """Numbers of the nodes with these labels."""
        places, there = _found(self._node_labels, labels)
        self._demand(labels, there, what, "nodes")
        return self._nodes[places]

    def elements(self, labels, what):
        """{part: numbers of elements in it}; those left out are passed over."""
        places, there = _found(self._element_labels, labels)
        self._demand(labels, there, what, "elements")
        owners, indices = self._owners[places], self._indices[places]
        return {int(part): indices[owners == part] for part in np.unique(owners) if part >= 0}

    def _demand(self, labels, there, what, kind):
        if not there.all():
            raise MeshError(f"{self.file_name}: {what} {kind}{self.of} that are not there, as {labels[~there][0]}")


def _found(ordered, labels):
    places = np.searchsorted(ordered, labels)
    places[places == len(ordered)] = 0
    return places, ordered[places] == labels if len(ordered) else np.zeros(np.shape(labels), bool)
