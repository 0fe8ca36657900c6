"""Expressions in x, y, z over all points at once: `y > 0.099 and x < 0.05`."""
import ast

import numpy as np

from .errors import MeshError

_FUNCTIONS = {name: getattr(np, name) for name in ("sqrt", "abs", "sin", "cos", "tan", "exp", "log", "hypot", "floor")}
_FUNCTIONS.update(atan2=np.arctan2, min=np.minimum, max=np.maximum)
_BINARY = {ast.Add: np.add, ast.Sub: np.subtract, ast.Mult: np.multiply, ast.Div: np.divide, ast.Pow: np.power,
           ast.Mod: np.mod, ast.BitAnd: np.logical_and, ast.BitOr: np.logical_or}
_COMPARE = {ast.Lt: np.less, ast.LtE: np.less_equal, ast.Gt: np.greater, ast.GtE: np.greater_equal,
            ast.Eq: np.equal, ast.NotEq: np.not_equal}


def evaluate(text, variables):
    """Value of `text`; `variables` maps names to arrays or numbers. Throws MeshError on anything else."""
    try:
        # Python's own ^ binds less than + does.
        words = text.replace("&&", " and ").replace("||", " or ").replace("^", "**")
        tree = ast.parse(words.strip(), mode="eval")
    except SyntaxError as error:
        raise MeshError(f"expression `{text}`: {error.msg} at column {error.offset}") from None
    return _value(tree.body, variables, text)


def select(text, variables):
    """Indices of the points where `text` holds."""
    value = np.asarray(evaluate(text, variables))
    if value.dtype != bool:
        raise MeshError(f"expression `{text}` is a number, not a condition; write for example `y > 0.099`")
    n_points = len(variables["x"])
    return np.flatnonzero(np.broadcast_to(value, (n_points,)))


def variables_of(points):
    return {"x": points.x[:, 0], "y": points.x[:, 1], "z": points.x[:, 2], "r": np.hypot(*points.x[:, :2].T),
            "block": points.block, "volume": points.volume, "pi": np.pi}


def named(text):
    """`top: y > 0.1` as (name, expression)."""
    name, colon, expression = text.partition(":")
    if not colon or not name.strip() or not expression.strip():
        raise MeshError(f"`{text}`: expected `name: expression`, for example `top: y > 0.099`")
    return name.strip(), expression.strip()


def _value(node, variables, text):
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        return node.value
    if isinstance(node, ast.Name):
        if node.id in variables:
            return variables[node.id]
        raise MeshError(f"expression `{text}`: unknown name `{node.id}` (known: {', '.join(variables)})")
    if isinstance(node, ast.BinOp) and type(node.op) in _BINARY:
        return _BINARY[type(node.op)](_value(node.left, variables, text), _value(node.right, variables, text))
    if isinstance(node, ast.UnaryOp):
        value = _value(node.operand, variables, text)
        return np.logical_not(value) if isinstance(node.op, ast.Not) else (
            -value if isinstance(node.op, ast.USub) else value)
    if isinstance(node, ast.BoolOp):
        values = [_value(part, variables, text) for part in node.values]
        combine = np.logical_and if isinstance(node.op, ast.And) else np.logical_or
        result = values[0]
        for value in values[1:]:
            result = combine(result, value)
        return result
    if isinstance(node, ast.Compare) and all(type(operator) in _COMPARE for operator in node.ops):
        parts = [_value(part, variables, text) for part in [node.left] + node.comparators]
        result = True
        for operator, left, right in zip(node.ops, parts, parts[1:]):
            result = np.logical_and(result, _COMPARE[type(operator)](left, right))
        return result
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        if node.func.id not in _FUNCTIONS:
            raise MeshError(f"expression `{text}`: unknown function `{node.func.id}` "
                            f"(known: {', '.join(sorted(_FUNCTIONS))})")
        try:
            return _FUNCTIONS[node.func.id](*[_value(argument, variables, text) for argument in node.args])
        except (TypeError, ValueError):
            raise MeshError(f"expression `{text}`: wrong number of arguments for `{node.func.id}`") from None
    raise MeshError(f"expression `{text}`: `{ast.unparse(node)}` is not understood here")
