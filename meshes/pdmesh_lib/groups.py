"""From the groups of elements of a file to blocks and node sets."""
import numpy as np

from .elements import ELEMENTS
from .errors import MeshError


class Group:
    """What becomes a node set: elements, a list of (element type, connectivity), mesh nodes, or both: elements where
    points are elements, nodes where points are nodes. is_solid: elements of the mesh itself, not sides of them;
    is_face: such elements beside a face, whose nodes the nodes are."""

    def __init__(self, name, parts=(), nodes=None, is_solid=False, is_face=False):
        self.name, self.parts, self.nodes, self.is_solid, self.is_face = name, list(parts), nodes, is_solid, is_face

    def corner_nodes(self):
        """The nodes that it names itself; else those of its elements."""
        if self.nodes is not None:
            return np.unique(self.nodes)
        found = [_corners(*part).ravel() for part in self.parts]
        return np.unique(np.concatenate(found)) if found else np.array([], int)


def _corners(kind, connectivity):
    return connectivity[:, :ELEMENTS[kind].corners]


def blocks_and_groups(file_name, raw, dimension, chosen=None):
    """(block number of each element of each part, {number: name}, groups that become node sets, notes).

    Groups of elements of the mesh's dimension make blocks: those named by `chosen`; those that the file itself says are
    blocks; or all that do not overlap. A group that others fill completely (ALL, or a second name) becomes a node set,
    and so do elements beside a face, of which the file also names the nodes; one that others fill partly needs
    `chosen`.
    """
    dimensions = [ELEMENTS[kind].dimension for kind, _ in raw.parts]
    node_sets = _paired(raw, dimensions, dimension)
    solid, sides = [], []
    for group in raw.groups:
        (solid if any(dimensions[part] == dimension for part in group.members) else sides).append(group)
    candidates = _candidates(file_name, raw, dimension, solid, chosen)
    rest = [group for group in solid if group not in candidates]
    numbers, blocks, filled, loose = _assign(file_name, raw, dimensions, dimension, candidates)
    notes = [f"group {group.name} is a node set: other groups have all its elements" for group in filled]
    if any(group.number not in (None, number) for number, group in blocks.items()):
        notes.append("blocks are numbered 1, 2 ...: the file's own numbers are not all different and above 0")
    if loose and blocks:
        notes.append(f"{loose} elements are in none of the groups that are blocks: block_{max(blocks) + 1}")
    result = [Group(group.name, _parts(raw, group), group.nodes) for group in sides]
    result += [Group(group.name, _parts(raw, group), group.nodes, not _is_face(raw, group), _is_face(raw, group))
               for group in rest + filled + [group for group in blocks.values() if group.nodes is not None]]
    result += [Group(name, nodes=nodes) for name, nodes in node_sets.items()]
    notes += _told_apart(result)
    return numbers, {number: group.name for number, group in blocks.items()}, result, notes


def _paired(raw, dimensions, dimension):
    """Node sets that stand alone. One that is called like a group of elements and holds nodes of those alone, as
    programs write both of one region, goes to the group: all nodes of its sides, or some of solid elements."""
    alone = {}
    for name, nodes in raw.node_sets.items():
        for group in raw.groups:
            if group.name.upper() != name.upper() or group.nodes is not None or not group.members:
                continue
            own = np.zeros(len(raw.nodes), bool)
            for _, connectivity in _parts(raw, group):
                own[connectivity] = True
            may_be_some = group not in raw.sections and any(dimensions[part] == dimension for part in group.members)
            if len(nodes) and own[nodes].all() and (may_be_some or _has_all_corners(raw, group, nodes)):
                group.nodes = nodes
                break
        else:
            alone[name] = nodes
    return alone


def _is_face(raw, group):
    """Whether the file names but some of the nodes of the group's elements: those of a face of them."""
    return group.nodes is not None and not _has_all_corners(raw, group, group.nodes)


def _has_all_corners(raw, group, nodes):
    named = np.zeros(len(raw.nodes), bool)
    named[nodes] = True
    return all(named[_corners(*part)].all() for part in _parts(raw, group))


def _candidates(file_name, raw, dimension, solid, chosen):
    """Groups that may be blocks."""
    if chosen is not None:
        unknown = [name for name in chosen if name not in [group.name for group in solid]]
        if unknown:
            raise MeshError(f"{file_name}: --blocks: no group {', '.join(unknown)} of {dimension}D elements (there "
                            f"are: {', '.join(group.name for group in solid) or 'none'})")
        return [group for group in solid if group.name in chosen]
    sections = [group for group in solid if group in raw.sections]
    if sections:
        return sections
    return [group for group in solid if not _is_face(raw, group)]


def _told_apart(groups):
    """Gives groups of one name different ones; returns notes."""
    taken, notes = {group.name for group in groups}, []
    seen = set()
    for group in groups:
        if group.name in seen:
            dimension = max((ELEMENTS[kind].dimension for kind, _ in group.parts), default=None)
            name = group.name + ("_nodes" if dimension is None else f"_{dimension}d")
            while name in taken:
                name += "_"
            notes.append(f"two groups are called {group.name}: the node set of the second, of "
                         f"{'nodes' if dimension is None else f'{dimension}D elements'}, is {name}")
            group.name = name
            taken.add(name)
        seen.add(group.name)
    return notes


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
                            "blocks, as --blocks A,B: the others become node sets; or all do: --one-block")
        for part, m in members.items():
            owner[part][m] = index
        blocks.append(index)
    blocks.sort()
    number_of = _numbers([candidates[index].number for index in blocks])
    lookup = np.array([0] * len(candidates) + [max(number_of, default=0) + 1])  # the last: elements in no group
    lookup[blocks] = number_of
    loose = sum(np.count_nonzero(values < 0) for values, d in zip(owner, dimensions) if d == dimension)
    return ([lookup[values] for values in owner], {n: candidates[i] for n, i in zip(number_of, blocks)},
            [candidates[index] for index in sorted(filled)], loose)


def _numbers(wished):
    """The numbers that a file gives, where it gives all and they differ; else 1, 2 ..."""
    is_usable = all(number is not None and number > 0 for number in wished) and len(set(wished)) == len(wished)
    return list(wished) if is_usable else list(range(1, len(wished) + 1))
