"""Computes the margins of assertions from the compiler's formulas and the columns of a run.

A margin is a number at each instant, positive if the condition is true and negative if it is false:
the robustness of signal temporal logic (Donzé and Maler 2010) over the instants of a run, for the
past-time operators of the module Past. A condition that does not compare numbers has an infinite
margin, and so does an operand that does not affect the result.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional

from . import columns

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Series = NDArray[np.float64]
    Times = NDArray[np.int64]


class Margin:
    """The margin of one assertion, given by the formula that the compiler put into the program."""

    def __init__(self, text: str) -> None:
        self._formula: Any = json.loads(text)
        self.columns: List[str] = sorted(_columns(self._formula))

    def over(self, nanoseconds: "Times", values: "Mapping[str, NDArray[Any]]") -> "Series":
        """Computes the margin at each instant. `values` contains the columns over a stretch without
        gaps, because an assertion has no margin while its signal function does not run."""
        return _over(self._formula, nanoseconds, values)


def _columns(formula: Any) -> "set[str]":
    if isinstance(formula, str):
        return {formula}
    if isinstance(formula, list):
        return set().union(*(_columns(part) for part in formula[1:]))
    return set()


def _over(f: Any, ns: "Times", values: "Mapping[str, NDArray[Any]]") -> "Series":
    np = columns.numpy()
    if isinstance(f, bool):
        return np.full(len(ns), np.inf if f else -np.inf)  # type: ignore[no-any-return]
    if isinstance(f, str):
        return _column(values[f])
    word, parts = f[0], f[1:]
    if word in _TIMED:
        time = values[parts[0]]
        q = _nanoseconds(float(time[0])) if len(time) else 0
        return _TIMED[word](ns, q, *(_over(part, ns, values) for part in parts[1:]))
    given = [_over(part, ns, values) for part in parts]
    if word == "not":
        return -given[0]
    if word == "and":
        return np.minimum(*given)  # type: ignore[no-any-return]
    if word == "or":
        return np.maximum(*given)  # type: ignore[no-any-return]
    if word == "if":
        c, a, b = given
        return np.maximum(np.minimum(c, a), np.minimum(-c, b))  # type: ignore[no-any-return]
    if word == "ever":
        return np.maximum.accumulate(given[0])  # type: ignore[no-any-return]
    if word == "always":
        return np.minimum.accumulate(given[0])  # type: ignore[no-any-return]
    if word == "since":
        return _since(*given)
    raise ValueError(
        f"the program contains a condition `{word}`, which this package does not support"
    )


def _column(values: "NDArray[Any]") -> "Series":
    """Booleans have infinite margins; NaN counts as false."""
    np = columns.numpy()
    if values.dtype == bool:
        return np.where(values, np.inf, -np.inf)  # type: ignore[no-any-return]
    numbers = values.astype(np.float64)
    return np.where(np.isnan(numbers), -np.inf, numbers)  # type: ignore[no-any-return]


def _nanoseconds(seconds: float) -> Optional[int]:
    """Rounds a time to nanoseconds, as programs do. Returns None for a time that is NaN or so large
    that it never passes."""
    if seconds != seconds or seconds * 1e9 >= 2**63:
        return None
    return max(0, round(seconds * 1e9))


def _since(p: "Series", q: "Series") -> "Series":
    np = columns.numpy()
    said = -np.inf
    series = []
    for a, b in zip(p.tolist(), q.tolist()):
        said = max(b, min(a, said))
        series.append(said)
    return np.array(series)  # type: ignore[no-any-return]


def _within(ns: "Times", q: Optional[int], p: "Series") -> "Series":
    """The maximum over the last q nanoseconds."""
    np = columns.numpy()
    first = np.zeros(len(ns), int) if q is None else np.searchsorted(ns, ns - q, side="left")
    return _largest(p, first, np.arange(len(ns)))


def _held_for(ns: "Times", q: Optional[int], p: "Series") -> "Series":
    """The minimum since the latest instant that is at least q nanoseconds in the past; minus
    infinity if there is no such instant."""
    np = columns.numpy()
    if q is None:
        return np.full(len(ns), -np.inf)  # type: ignore[no-any-return]
    first = np.searchsorted(ns, ns - q, side="right") - 1
    least = -_largest(-p, np.maximum(first, 0), np.arange(len(ns)))
    return np.where(first < 0, -np.inf, least)  # type: ignore[no-any-return]


def _by(ns: "Times", q: Optional[int], p: "Series") -> "Series":
    """The maximum up to time q; infinity until then, because the result is still open."""
    np = columns.numpy()
    is_late = np.zeros(len(ns), bool) if q is None else ns - ns[:1] > q
    largest = np.max(p[~is_late], initial=-np.inf)
    return np.where(is_late, largest, np.inf)  # type: ignore[no-any-return]


def _responds(ns: "Times", q: Optional[int], p: "Series", answer: "Series") -> "Series":
    """The minimum over all instants more than q nanoseconds ago: at each of them, p must have been
    false, or the answer must have come since."""
    np = columns.numpy()
    count = len(ns)
    if q is None:
        return np.full(count, np.inf)  # type: ignore[no-any-return]
    # Judges each instant at the first instant after its deadline.
    asked, when = np.arange(count), np.searchsorted(ns, ns + q, side="right")
    asked, when = asked[when < count], when[when < count]
    first = np.full(count, np.inf)
    np.minimum.at(first, when, np.maximum(-p[asked], _largest(answer, asked, when)))
    said = np.inf
    series = []
    for new, a in zip(first.tolist(), answer.tolist()):
        said = min(max(said, a), new)
        series.append(said)
    return np.array(series)  # type: ignore[no-any-return]


def _largest(x: "Series", first: "NDArray[Any]", last: "NDArray[Any]") -> "Series":
    """The maximum of each range, both ends included. Uses a sparse table, with the maxima of 1, 2,
    4, … values that start at each index.
    """
    np = columns.numpy()
    if len(x) == 0 or len(first) == 0:
        return np.empty(len(first))  # type: ignore[no-any-return]
    table = [x]
    while 2 ** len(table) <= len(x):
        half = 2 ** (len(table) - 1)
        table.append(np.maximum(table[-1][:-half], table[-1][half:]))
    level = np.frexp(last - first + 1)[1] - 1
    found = np.empty(len(first))
    for k in np.unique(level):
        here = level == k
        ends = last[here] - 2**k + 1
        found[here] = np.maximum(table[k][first[here]], table[k][ends])
    return found  # type: ignore[no-any-return]


_TIMED: "Dict[str, Callable[..., Series]]" = {
    "within": _within,
    "heldFor": _held_for,
    "by": _by,
    "respondsWithin": _responds,
}
