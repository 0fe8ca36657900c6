"""Components of vectors and tensors, and what is derived of tensors."""
import numpy as np

from .results import PlotError

_VECTOR = {"x": 0, "y": 1, "z": 2}
# Row by row (9), or the upper half row by row (6), as VTK has them.
_TENSORS = {9: {a + b: 3 * i + j for i, a in enumerate("xyz") for j, b in enumerate("xyz")},
            6: {"xx": 0, "xy": 1, "xz": 2, "yx": 1, "yy": 3, "yz": 4, "zx": 2, "zy": 4, "zz": 5}}
_DERIVED = ("von-mises", "principal1", "principal2", "principal3")


def known_components(width):
    """Names of what can be shown of a field of `width` numbers a point."""
    if width in _TENSORS:
        return [*_TENSORS[width], *_DERIVED]
    return list(_VECTOR) if width == 3 else [str(i + 1) for i in range(width)] if width > 1 else []


def default_component(field, width):
    """What people look at: of a vector its magnitude; of a stress that of von Mises, of a strain the largest; else the
    first."""
    if width in (1, 3):
        return None
    if width in _TENSORS and "stress" in field.lower():
        return "von-mises"
    return "principal1" if width in _TENSORS and "strain" in field.lower() else known_components(width)[0]


def component_of(field, values, name):
    """[n] of values [n, width]; without a name the magnitude."""
    width = values.shape[1]
    if name is None:
        return np.linalg.norm(values, axis=1)
    if name not in known_components(width):
        raise PlotError(f"--component {name}: {field} has {width} numbers a point; choose among "
                        f"{', '.join(known_components(width))}")
    if name in _DERIVED:
        return _derived(field, _symmetric(values), name)
    return values[:, _TENSORS[width][name] if width in _TENSORS else _VECTOR[name] if width == 3 else int(name) - 1]


def _symmetric(values):
    """[n, 3, 3]: the symmetric part."""
    places = [_TENSORS[values.shape[1]][a + b] for a in "xyz" for b in "xyz"]
    tensors = values[:, places].reshape(-1, 3, 3)
    return (tensors + tensors.transpose(0, 2, 1)) / 2


def _derived(field, tensors, name):
    if name != "von-mises":
        return np.linalg.eigvalsh(tensors)[:, 3 - int(name[-1])]  # the first is the largest
    deviator = tensors - np.trace(tensors, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
    # 3/2 makes a uniaxial stress its own measure; 2/3 the strain of a material that keeps its volume.
    factor = 2 / 3 if "strain" in field.lower() else 3 / 2
    return np.sqrt(factor * np.einsum("nij,nij->n", deviator, deviator))


def title_of(field, width, name):
    if width == 1:
        return field
    titles = {None: "magnitude", "von-mises": "von Mises", "principal1": "largest principal value",
              "principal2": "middle principal value", "principal3": "smallest principal value"}
    return f"{field} {titles.get(name, name)}"
