"""From the groups of elements of a file to blocks and node sets."""
import numpy as np

from .elements import ELEMENTS
from .errors import MeshError


class Group:
    """Elements that become a node set: list of (element type, connectivity), or single mesh nodes. is_solid: they are
    elements of the mesh itself, not sides of them."""

    def __init__(self, name, parts=(), nodes=None, is_solid=False):
        self.name, self.parts, self.nodes, self.is_solid = name, list(parts), nodes, is_solid

    def corner_nodes(self):
        parts = [connectivity[:, :ELEMENTS[kind].corners].ravel() for kind, connectivity in self.parts]
        if self.nodes is not None:
            parts.append(self.nodes)
        return np.unique(np.concatenate(parts)) if parts else np.array([], int)


def blocks_and_groups(file_name, raw, dimension, chosen=None):
    """(block number of each element of each part, {number: name}, groups that become node sets, notes).

    Groups of elements of the mesh's dimension make blocks: those named by `chosen`, or all that do not overlap. A group
    that others fill completely (ALL, or a second name) becomes a node set; one that they fill partly needs `chosen`.
    """
    dimensions = [ELEMENTS[kind].dimension for kind, _ in raw.parts]
    solid, groups = [], []
    for group in raw.groups:
        (solid if any(dimensions[part] == dimension for part in group.members) else groups).append(group)
    if chosen is not None:
        unknown = [name for name in chosen if name not in [group.name for group in solid]]
        if unknown:
            raise MeshError(f"{file_name}: --blocks: no group {', '.join(unknown)} of {dimension}D elements (there "
                            f"are: {', '.join(group.name for group in solid) or 'none'})")
        rest = [group for group in solid if group.name not in chosen]
        blocks = [group for group in solid if group.name in chosen]
    else:
        blocks, rest = solid, []
    numbers, blocks, filled = _assign(file_name, raw, dimensions, dimension, blocks)
    notes = [f"group {group.name} is a node set: other groups have all its elements" for group in filled]
    result = [Group(group.name, _parts(raw, group)) for group in groups]
    result += [Group(group.name, _parts(raw, group), is_solid=True) for group in rest + filled]
    result += [Group(name, nodes=nodes) for name, nodes in raw.node_sets.items()]
    return numbers, {number: group.name for number, group in blocks.items()}, result, notes


def _parts(raw, group):
    return [(raw.parts[part][0], raw.parts[part][1][indices]) for part, indices in group.members.items()]


def _assign(file_name, raw, dimensions, dimension, candidates):
    """Smallest groups first, so that one that holds others comes after them; of equal ones the later first: the sets
    that a user of Abaqus has named stand after those of *ELEMENT."""
    owner = [np.full(len(connectivity), -1) for _, connectivity in raw.parts]
    blocks, filled = [], []
    by_size = sorted(range(len(candidates)), key=lambda i: (sum(map(len, candidates[i].members.values())), -i))
    for index in by_size:
        members = {part: m for part, m in candidates[index].members.items() if dimensions[part] == dimension}
        taken = np.concatenate([owner[part][m] for part, m in members.items()])
        if (taken >= 0).all():
            filled.append(index)
            continue
        if (taken >= 0).any():
            other = candidates[int(taken.max())].name
            raise MeshError(f"{file_name}: {np.count_nonzero(taken >= 0)} elements belong to the groups {other} and "
                            f"{candidates[index].name} at once, and a point has one block; name the groups that are "
                            "blocks, as --blocks A,B: the others become node sets")
        for part, m in members.items():
            owner[part][m] = index
        blocks.append(index)
    blocks.sort()
    number_of = _numbers([candidates[index].number for index in blocks])
    lookup = np.array([0] * len(candidates) + [max(number_of, default=0) + 1])  # the last: elements in no group
    lookup[blocks] = number_of
    return ([lookup[values] for values in owner], {n: candidates[i] for n, i in zip(number_of, blocks)},
            [candidates[index] for index in sorted(filled)])


def _numbers(wished):
    """The numbers that a file gives, where it gives all and they differ; else 1, 2 ..."""
    is_usable = all(number is not None and number > 0 for number in wished) and len(set(wished)) == len(wished)
    return list(wished) if is_usable else list(range(1, len(wished) + 1))
