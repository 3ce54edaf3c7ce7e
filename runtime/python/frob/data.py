"""Python representation of Frob's data types."""

from __future__ import annotations

import math
from typing import Any, Dict, Tuple

from .errors import InputError


class Data:
    """A value made by a constructor: `Data("At", 0.5)`, `Data("Pose", x=1.0, heading=0.0)`.

    You read a constructor's arguments by position, `value[0]`, or by field name, `value["heading"]`
    or `value.heading`. `str(value)` is the value in Frob's syntax.

    Booleans, numbers, tuples and arrays (lists) are Python's own types. `Nothing` and an event that
    does not occur are None; `Just x` and an occurrence of an event are x. If x itself is None or
    NaN, they are `Data("Just", x)` or `Data("Event", x)` instead.
    """

    __slots__ = ("constructor", "args", "fields")

    constructor: str
    args: Tuple[Any, ...]
    fields: Dict[str, Any]

    def __init__(self, constructor: str, /, *args: Any, **fields: Any) -> None:
        if args and fields:
            raise InputError(
                f"{constructor}: a constructor has positional arguments or fields, not both"
            )
        object.__setattr__(self, "constructor", constructor)
        object.__setattr__(self, "args", args or tuple(fields.values()))
        object.__setattr__(self, "fields", fields)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("a Frob value is immutable")

    def __getattr__(self, name: str) -> Any:
        try:
            return object.__getattribute__(self, "fields")[name]
        except KeyError:
            raise AttributeError(f"{self.constructor} has no field `{name}`") from None

    def __getitem__(self, key: "int | str") -> Any:
        return self.fields[key] if isinstance(key, str) else self.args[key]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Data):
            return NotImplemented
        mine = (self.constructor, self.args, list(self.fields))
        return mine == (other.constructor, other.args, list(other.fields))

    def __hash__(self) -> int:
        return hash((self.constructor, self.args))

    def __reduce__(self) -> "tuple[Any, ...]":
        return _rebuilt, (self.constructor, self.args, self.fields)

    def __repr__(self) -> str:
        named = [f"{name}={value!r}" for name, value in self.fields.items()]
        parts = named or [repr(value) for value in self.args]
        return f"Data({', '.join([repr(self.constructor), *parts])})"

    def __str__(self) -> str:
        return text(self)


def _rebuilt(constructor: str, args: "tuple[Any, ...]", fields: "dict[str, Any]") -> Data:
    return Data(constructor, **fields) if fields else Data(constructor, *args)


def is_missing(value: Any) -> bool:
    """Returns whether the value is None, NaN, or one of pandas' missing values."""
    if value is None or type(value).__name__ in ("NAType", "NaTType"):
        return True
    return isinstance(value, float) and math.isnan(value)


def text(value: Any) -> str:
    """Formats a value in Frob's syntax, as in recordings."""
    try:
        return _text(value)
    except RecursionError:
        raise InputError("a value that contains itself cannot be written as text") from None


def _text(value: Any, argument: bool = False) -> str:
    if value is None:
        return "Nothing"
    if isinstance(value, str):
        return value
    if type(value).__name__ in ("bool", "bool_"):
        return "true" if value else "false"
    if isinstance(value, Data):
        return _text_of_data(value, argument)
    if isinstance(value, tuple):
        return "(" + ", ".join(_text(part) for part in value) + ")"
    if isinstance(value, list):
        return "[" + ", ".join(_text(part) for part in value) + "]"
    number = _number(value)
    return f"({number})" if argument and number.startswith("-") else number


def _text_of_data(value: Data, argument: bool) -> str:
    if value.fields:
        parts = (f"{name} = {_text(part)}" for name, part in value.fields.items())
        whole = f"{value.constructor} {{{', '.join(parts)}}}"
    else:
        whole = " ".join([value.constructor, *(_text(part, True) for part in value.args)])
    return f"({whole})" if argument and value.args else whole


def _number(value: Any) -> str:
    if isinstance(value, float):
        return "nan" if math.isnan(value) else "%.17g" % value
    return str(value)
