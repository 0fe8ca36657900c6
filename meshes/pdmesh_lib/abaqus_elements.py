"""Element types of Abaqus, and the corners of their sides.

Node orders and faces: Abaqus Elements Guide, "Solid isoparametric quadrilaterals and hexahedra", "... triangles,
tetrahedra, and wedges".
"""
import re

from .elements import ELEMENTS
from .errors import MeshError

_FAMILIES = [(r"[DA]?C3D|SC", "solid"), (r"CPS|CPEG?|[DA]C2D|M3D|SFM3D|STRI|D?S(?=\d)|R3D", "plane"),
             (r"T[23]D|R2D|SPRINGA?", "line"), (r"B[23]", "beam"), (r"MASS|ROTARYI", "point")]
_KINDS = {"solid": {4: "tetra", 5: "pyramid", 6: "wedge", 8: "hexahedron", 10: "tetra10", 15: "wedge15",
                    20: "hexahedron20"},
          "plane": {3: "triangle", 4: "quad", 6: "triangle6", 65: "triangle6", 8: "quad8", 9: "quad9"},
          "line": {2: "line", 3: "line3"}, "beam": {1: "line", 2: "line3", 3: "line"}, "point": {1: "vertex"}}
N_NODES = {"pyramid": 5, **{name: len(element.nodes) for name, element in ELEMENTS.items()}}
# Corners of face S1, S2 ... of solids and edge S1, S2 ... of plane elements.
SIDES = {"triangle": [(0, 1), (1, 2), (2, 0)], "quad": [(0, 1), (1, 2), (2, 3), (3, 0)],
         "tetra": [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)],
         "wedge": [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)],
         "hexahedron": [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]}


def kind_of(name, place):
    """The element of ELEMENTS (or "pyramid") that a type such as C3D8R is."""
    if re.match(r"[DAS]?C?AX|[DA]CAX", name):
        raise MeshError(f"{place}: axisymmetric elements {name}: their volumes are not those of a plane; mesh "
                        "the solid")
    for pattern, family in _FAMILIES:
        found = re.match(rf"(?:{pattern})(\d*)", name)
        kind = _KINDS[family].get(int(found.group(1) or {"point": 1, "line": 2}.get(family, 0))) if found else None
        if kind:
            return kind
    raise MeshError(f"{place}: elements of type {name or '(none)'} are not supported; mesh with solid (C3D...) or "
                    "plane (CPS..., CPE...) elements of first or second order, or leave these out by --skip "
                    f"{name or 'TYPE'}")
