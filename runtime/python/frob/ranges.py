"""The ranges of the parameters and inputs that a search varies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Tuple

from . import columns, library, search, shapes
from .errors import InputError


@dataclass(frozen=True)
class Inputs:
    varied: List[search.Range]
    fixed: Dict[str, Any]
    """Inputs that have one value for the whole run."""


def of_program(
    code: library.Library, params: Mapping[str, Any], inputs: Mapping[str, Any]
) -> Tuple[List[search.Range], Inputs]:
    return of_params(code, params), _inputs(code, inputs)


def of_params(code: library.Library, params: Mapping[str, Any]) -> List[search.Range]:
    found = []
    for name, given in params.items():
        param = code.params.get(name)
        if param is None:
            known = ", ".join(code.params) or "none"
            raise InputError(f"{code.name} has no parameter `{name}`; it has: {known}")
        given_ends = ends(f"param {name}", given)
        if len(given_ends) == 1:
            unit = f"[{param.unit}]" if param.unit not in ("", "1") else ""
            raise InputError(
                f'param {name}: expected a range, such as "{_text(param.default)}{unit} to …", '
                f"found {shapes.shown(given)}"
            )
        low, high = (param.value(end) for end in given_ends)
        found.append(_range(f"param {name}", name, param.shape, low, high))
    return found


def _inputs(code: library.Library, inputs: Mapping[str, Any]) -> Inputs:
    leaves = dict(code.input_columns)
    found = Inputs([], {})
    for name, given in inputs.items():
        leaf = leaves.get(name)
        if leaf is None:
            known = ", ".join(leaves) or "none"
            raise InputError(f"{code.name} has no input `{name}`; it has: {known}")
        if not isinstance(leaf, shapes.Scalar):
            raise InputError(
                f"{name}: it is not a number ({leaf.meaning}), so it cannot have a range"
            )
        values = [_value(leaf, end, name) for end in ends(name, given)]
        if len(values) == 1:
            found.fixed[name] = values[0]
        else:
            found.varied.append(_range(name, name, leaf, *values))
    columns.check(code.input_columns, inputs, code.name)
    return found


def ends(place: str, given: Any) -> List[Any]:
    """Splits a range into its two ends; for a single value, returns a list of just that value."""
    if isinstance(given, str):
        return [part.strip() for part in given.split(" to ")] if " to " in given else [given]
    if isinstance(given, (tuple, list)):
        if len(given) != 2:
            raise InputError(f"{place}: expected (low, high), found {shapes.shown(given)}")
        return list(given)
    return [given]


def _value(leaf: shapes.Scalar, given: Any, place: str) -> Any:
    if isinstance(given, str):
        given = shapes.from_text(leaf, given, place)
    return leaf.converted(given, place)


def _range(place: str, name: str, shape: shapes.Scalar, low: Any, high: Any) -> search.Range:
    kind = {shapes.Bool: "bool", shapes.Int: "int"}.get(type(shape), "float")
    return between(place, name, kind, low, high)


def between(place: str, name: str, kind: str, low: Any, high: Any) -> search.Range:
    if not (abs(low) < float("inf") and abs(high) < float("inf")):
        raise InputError(f"{place}: expected two finite ends, found {_text(low)} to {_text(high)}")
    if not low < high:
        raise InputError(
            f"{place}: the range ends at {_text(high)}, which is not more than {_text(low)}"
        )
    return search.Range(name, low, high, kind)


def _text(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)
