"""Columns of a program's input and output, in arrays of C's structs, by numpy."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Mapping, Sequence, Tuple

from . import shapes
from .errors import Error, InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Leaves = Sequence[Tuple[str, shapes.Leaf]]


def numpy() -> Any:
    try:
        import numpy
    except ImportError:
        raise Error(
            "columns and arrays need numpy, which is not installed: `apt install python3-numpy` "
            "or `pip install numpy`, or give a list of inputs"
        ) from None
    return numpy


def _seen(leaf: shapes.Scalar, memory: Any, count: int, size: int) -> "NDArray[Any]":
    """The numbers of a column where they lie in the structs."""
    np = numpy()
    if count == 0:
        return np.empty(0, dtype=leaf.numpy_name)  # type: ignore[no-any-return]
    array: "NDArray[Any]" = np.ndarray(
        (count,), dtype=leaf.numpy_name, buffer=memory, offset=leaf.offset, strides=(size,)
    )
    return array


def _numbers(name: str, leaf: shapes.Scalar, given: "NDArray[Any]") -> "NDArray[Any]":
    """The column, if all of it is what the program takes."""
    np = numpy()
    kind = given.dtype.kind
    if isinstance(leaf, shapes.Bool):
        good = kind == "b"
    elif isinstance(leaf, shapes.Int):
        good = kind in "iu" or (kind == "f" and bool(np.all(given == np.floor(given))))
        good = good and (len(given) == 0 or bool(given.min() >= -(2**31) and given.max() < 2**31))
    else:
        good = kind in "iuf"
    if good:
        return given
    # By single values, whose mistake has a row; a column of objects may be good.
    return np.array(  # type: ignore[no-any-return]
        [_one(leaf, value, f"{name}, row {row}") for row, value in enumerate(given.tolist())],
        dtype=leaf.numpy_name,
    )


def _one(leaf: shapes.Scalar, value: Any, place: str) -> Any:
    if isinstance(value, str):
        value = shapes.from_text(leaf, value, place)
    if isinstance(leaf, shapes.Int) and isinstance(value, float) and value.is_integer():
        value = int(value)
    return leaf.converted(value, place)


def as_column(name: str, given: Any) -> "NDArray[Any]":
    """Of an array, a Series, or a list, whose values may be of any kind."""
    np = numpy()
    if hasattr(given, "dtype"):
        array: "NDArray[Any]" = np.asarray(unmasked(name, given))
    elif isinstance(given, (list, tuple)):
        array = np.empty(len(given), dtype=object)
        for row, value in enumerate(given):
            array[row] = value
    else:
        array = np.asarray(given)
    if array.ndim != 1:
        raise InputError(f"{name}: expected a column, found {shapes.shown(given)}")
    return array


def length(name: str, given: Any) -> int:
    """How many rows a column has."""
    if isinstance(given, (str, bytes)) or not hasattr(given, "__len__"):
        raise InputError(f"{name}: expected a column, found {shapes.shown(given)}")
    return len(given)


def unmasked(name: str, given: Any) -> Any:
    if isinstance(given, numpy().ma.MaskedArray) and numpy().ma.is_masked(given):
        raise InputError(f"{name}: values are masked: fill them, or leave their rows out")
    return given


def write(memory: Any, size: int, leaves: Leaves, given: Mapping[str, Any], count: int) -> None:
    """Fills structs with columns, all of which are there with so many rows."""
    for name, leaf in leaves:
        if name not in given:
            _fill(memory, size, leaf, count)
            continue
        column = as_column(name, given[name])
        if isinstance(leaf, shapes.Scalar):
            _seen(leaf, memory, count, size)[:] = _numbers(name, leaf, column)
            continue
        for row, value in enumerate(column.tolist()):
            leaf.write(memory, row * size, value, f"{name}, row {row}")


def _fill(memory: Any, size: int, leaf: shapes.Leaf, count: int) -> None:
    if isinstance(leaf, shapes.Scalar):
        _seen(leaf, memory, count, size)[:] = leaf.default
    else:
        for row in range(count):
            leaf.write(memory, row * size, leaf.default, "")


def check(leaves: Leaves, given: Iterable[str], program: str) -> None:
    """Are the columns all that the program takes?"""
    names = set(given)
    missing = [name for name, leaf in leaves if name not in names and not leaf.may_be_left_out()]
    if missing:
        known = ", ".join(str(name) for name in given) or "none"
        raise InputError(
            f"the column `{missing[0]}` is missing, which {program} takes; "
            f"it takes {', '.join(name for name, _ in leaves)}, found {known}"
        )


def read(memory: Any, size: int, leaves: Leaves, count: int) -> "Dict[str, NDArray[Any]]":
    """The columns of an output, as arrays of their own."""
    np = numpy()
    result: "Dict[str, NDArray[Any]]" = {}
    for name, leaf in leaves:
        if isinstance(leaf, shapes.Scalar):
            result[name] = _seen(leaf, memory, count, size).copy()
        else:
            column = np.empty(count, dtype=object)
            for row in range(count):
                column[row] = leaf.read(memory, row * size)
            result[name] = column
    return result


def dt_of_time(time: Any) -> "NDArray[np.float64]":
    """The steps between times in seconds, each of whole nanoseconds; the first is 0."""
    np = numpy()
    column = as_column("time", time)
    if column.dtype.kind not in "iuf":
        column = np.array([_time(value, row) for row, value in enumerate(column.tolist())], float)
    if not bool(np.all(np.abs(column) < 1e9)):
        row = int(np.argmin(np.abs(column) < 1e9))
        raise InputError(f"time, row {row}: {column[row]} is not a time in seconds")
    ns = np.rint(column.astype(np.float64) * 1e9).astype(np.int64)
    dt = np.zeros(len(ns))
    dt[1:] = np.diff(ns) / 1e9
    if bool(np.any(dt < 0)):
        row = int(np.argmax(dt < 0))
        raise InputError(f"time, row {row}: time goes back: {column[row]} comes after a later time")
    return dt  # type: ignore[no-any-return]


def listed_dt_of_time(times: Sequence[Any]) -> List[float]:
    """Likewise, without numpy."""
    ns: List[int] = []
    for row, value in enumerate(times):
        seconds = _time(value, row)
        if not abs(seconds) < 1e9:
            raise InputError(f"time, row {row}: {seconds} is not a time in seconds")
        ns.append(round(seconds * 1e9))
        if row > 0 and ns[row] < ns[row - 1]:
            raise InputError(f"time, row {row}: time goes back: {seconds} comes after a later time")
    return [0.0, *((b - a) / 1e9 for a, b in zip(ns, ns[1:]))][: len(ns)]


def _time(value: Any, row: int) -> float:
    if hasattr(value, "__float__") and not shapes.is_truth(value):
        return float(value)
    raise InputError(f"time, row {row}: {shapes.shown(value)} is not a time in seconds")


SOME = 8192
"""Instants whose steps stay in the processor's cache."""


def steps(dt: Any, count: int) -> "NDArray[np.float64]":
    """One dt for each instant; or, of one for all, as many as there are at once."""
    np = numpy()
    if getattr(dt, "ndim", None) == 0 or isinstance(dt, (int, float)):
        return np.full(min(count, SOME), step(dt, "dt"))  # type: ignore[no-any-return]
    column = as_column("dt", dt)
    if column.dtype.kind not in "iuf" or not bool(np.all(column >= 0)):
        for row, value in enumerate(column.tolist()):
            step(value, f"dt, row {row}")
    if len(column) != count:
        raise InputError(f"dt has {len(column)} rows, and the input {count}")
    return np.ascontiguousarray(column, dtype=np.float64)  # type: ignore[no-any-return]


def step(dt: Any, place: str) -> float:
    """The seconds of a step."""
    if isinstance(dt, bool) or not hasattr(dt, "__float__"):
        raise InputError(f"{place}: expected seconds, found {shapes.shown(dt)}")
    seconds = float(dt)
    if math.isnan(seconds) or seconds < 0:
        raise InputError(f"{place}: {seconds} is no time that passes; it is seconds from 0 on")
    return seconds


def numbers(leaves: Leaves, program: str) -> List[Tuple[str, shapes.Scalar]]:
    """The columns, if each is a number or a truth value, as an array can have them."""
    found: List[Tuple[str, shapes.Scalar]] = []
    for name, leaf in leaves:
        if not isinstance(leaf, shapes.Scalar):
            raise InputError(
                f"`{name}` of {program} is no number ({leaf.meaning}), and an array has numbers "
                "only: give a mapping of columns, or a DataFrame"
            )
        found.append((name, leaf))
    return found
