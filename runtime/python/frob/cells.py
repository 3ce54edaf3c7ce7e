"""Parses the cells of recordings: `At 0.5`, `Pose {x = 1, heading = -2}`, `(1, true)`."""

from __future__ import annotations

import math
import re
from typing import Any, Dict, List

from .data import Data, is_missing

NUMBER = re.compile(
    r"[-+]?(?:(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|nan|inf(?:inity)?)(?![\w'.])", re.IGNORECASE
)
WORD = re.compile(r"[A-Za-z_][\w'.]*")
HEX = re.compile(r"0x[0-9a-fA-F]+")
MARKS = "()[]{},="


DEEPEST = 200
"""Maximum nesting of parentheses, brackets and braces: more than any type needs."""


class CellError(ValueError):
    """Raised if a string is not a valid value."""


def words(cell: str) -> List[str]:
    """Splits a cell into words. A quoted label is one word and keeps its quotes."""
    found: List[str] = []
    at = 0
    while at < len(cell):
        if cell[at] in " \t":
            at += 1
            continue
        if cell[at] == '"':
            end = cell.find('"', at + 1) + 1
            if end == 0:
                raise CellError("a quote is not closed")
        elif cell[at] in MARKS:
            end = at + 1
        else:
            match = HEX.match(cell, at) or NUMBER.match(cell, at) or WORD.match(cell, at)
            if match is None:
                raise CellError(f"`{cell[at : at + 40]}` is neither a number nor a word")
            end = match.end()
        found.append(cell[at:end])
        at = end
    return found


def value(cell: str) -> Any:
    """Parses the text of a cell without knowing the type of its value."""
    rest = words(cell)
    depth = 0
    for word in rest:
        depth += (word in "([{") - (word in ")]}")
        if depth > DEEPEST:
            raise CellError(f"brackets are nested more than {DEEPEST} levels deep")
    rest.reverse()
    result = _value(rest)
    if rest:
        raise CellError(f"unexpected `{rest[-1]}` after the value")
    return result


def _take(rest: List[str]) -> str:
    if not rest:
        raise CellError("the value ends too early")
    return rest.pop()


def _expect(rest: List[str], mark: str) -> None:
    word = _take(rest)
    if word != mark:
        raise CellError(f"expected `{mark}`, found `{word}`")


def _value(rest: List[str]) -> Any:
    """Parses a constructor application or a single value."""
    word = rest[-1] if rest else ""
    is_name = word[:1].isalpha() and word[:1].isupper() and not NUMBER.fullmatch(word)
    if is_name and rest[-2:-1] != ["{"]:
        rest.pop()
        args: List[Any] = []
        while rest and rest[-1] not in (")", "]", "}", ",", "="):
            args.append(_alone(rest))
        return _plain(word, args)
    return _alone(rest)


def _alone(rest: List[str]) -> Any:
    word = _take(rest)
    if word == "(":
        parts = _list(rest, ")")
        return parts[0] if len(parts) == 1 else tuple(parts)
    if word == "[":
        return _list(rest, "]")
    if word in ("true", "false"):
        return word == "true"
    if word.startswith('"'):
        return word[1:-1]
    if word[0] in "0123456789+-." or word.lower() in ("nan", "inf", "infinity"):
        return _number(word)
    if word[:1].isalpha() and word[:1].isupper():
        return Data(word, **_fields(rest)) if rest[-1:] == ["{"] else _plain(word, [])
    raise CellError(f"`{word}` is not a value")


def _plain(word: str, args: List[Any]) -> Any:
    """Builds a value in the form that `Data` describes: omits the constructors `Just` and `Event`
    if the value is unambiguous without them."""
    if word in ("True", "False") and not args:
        return word == "True"
    if word in ("Nothing", "NoEvent") and not args:
        return None
    if word in ("Just", "Event") and len(args) == 1 and not is_missing(args[0]):
        return args[0]
    return Data(word, *args)


def finite(word: str) -> float:
    """Converts a word to a number. Accepts `inf`, but rejects digits that overflow to infinity."""
    number = float(word)
    if math.isinf(number) and any(c.isdigit() for c in word):
        raise CellError(f"expected a number up to 1.79e308, or `inf`, found `{word}`")
    return number


def _number(word: str) -> Any:
    if word.startswith("0x"):
        return int(word, 16)
    number = finite(word)
    try:
        whole = int(word)
    except ValueError:
        return number
    return -0.0 if whole == 0 and word.startswith("-") else whole


def _list(rest: List[str], end: str) -> List[Any]:
    parts: List[Any] = []
    if rest and rest[-1] == end:
        rest.pop()
        return parts
    while True:
        parts.append(_value(rest))
        word = _take(rest)
        if word == end:
            return parts
        if word != ",":
            raise CellError(f"expected `,` or `{end}`, found `{word}`")


def _fields(rest: List[str]) -> Dict[str, Any]:
    _expect(rest, "{")
    fields: Dict[str, Any] = {}
    while True:
        name = _take(rest)
        if name == "}" and not fields:
            return fields
        _expect(rest, "=")
        fields[name] = _value(rest)
        word = _take(rest)
        if word == "}":
            return fields
        if word != ",":
            raise CellError(f"expected `,` or `}}`, found `{word}`")
