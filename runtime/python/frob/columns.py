"""Converts columns to and from arrays of a program's C structs, with numpy."""

from __future__ import annotations

import decimal
import math
import numbers as kinds
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Mapping, Sequence, Tuple

from . import shapes, times
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
            "columns and arrays need numpy, which is not installed: run `pip install numpy` or "
            "`apt install python3-numpy`, or pass a list of inputs"
        ) from None
    return numpy


def _seen(leaf: shapes.Scalar, memory: Any, count: int, size: int) -> "NDArray[Any]":
    """Returns a view of a column's values within the structs."""
    np = numpy()
    if count == 0:
        return np.empty(0, dtype=leaf.numpy_name)  # type: ignore[no-any-return]
    array: "NDArray[Any]" = np.ndarray(
        (count,), dtype=leaf.numpy_name, buffer=memory, offset=leaf.offset, strides=(size,)
    )
    return array


def _numbers(name: str, leaf: shapes.Scalar, given: "NDArray[Any]") -> "NDArray[Any]":
    """Checks and converts a column: all its values must fit the program's type."""
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
    # Converts value by value, so that an error names its row. This also accepts a column of Python
    # objects.
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
    """Converts an array, a Series, or a list with values of any type to a column."""
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
    """Returns the number of rows of a column."""
    try:
        if not isinstance(given, (str, bytes)):
            return len(given)
    except TypeError:
        pass
    raise InputError(f"{name}: expected a column, found {shapes.shown(given)}")


def listed(name: str, given: Any) -> List[Any]:
    """Converts a column to a list of its values."""
    length(name, given)
    try:
        return list(given)
    except TypeError:
        raise InputError(f"{name}: expected a column, found {shapes.shown(given)}") from None


def unmasked(name: str, given: Any) -> Any:
    if isinstance(given, numpy().ma.MaskedArray) and numpy().ma.is_masked(given):
        raise InputError(f"{name}: values are masked: fill them, or remove their rows")
    return given


def write(memory: Any, size: int, leaves: Leaves, given: Mapping[str, Any], count: int) -> None:
    """Fills `count` structs from the columns. A missing column gets its default value."""
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
    """Checks that no required column is missing."""
    names = set(given)
    missing = [name for name, leaf in leaves if name not in names and not leaf.may_be_left_out()]
    if missing:
        known = ", ".join(str(name) for name in given) or "none"
        raise InputError(
            f"the column `{missing[0]}` of {program} is missing; "
            f"the columns are {', '.join(name for name, _ in leaves)}, found {known}"
        )


def read(memory: Any, size: int, leaves: Leaves, count: int) -> "Dict[str, NDArray[Any]]":
    """Copies an output's columns from the structs."""
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


def dt_of_time(time: Any) -> "NDArray[np.int64]":
    """Converts times in seconds to time steps in nanoseconds; the first step is 0."""
    np = numpy()
    column = as_column("time", time)
    if column.dtype.kind in "Mm":
        ns = _of_dates(column)
    elif column.dtype.kind in "iuf" and column.dtype.itemsize <= 8:
        ns = _of_floats(column)
    else:
        values = [_time_ns(value, row) for row, value in enumerate(column.tolist())]
        ns = np.array(values, dtype=np.int64)
    dt = np.diff(ns, prepend=ns[:1])
    if bool(np.any(dt < 0)):
        row = int(np.argmax(dt < 0))
        raise InputError(
            f"time, row {row}: the time goes backwards: {column[row]} comes after a later time"
        )
    return dt  # type: ignore[no-any-return]


def _of_floats(column: "NDArray[Any]") -> "NDArray[Any]":
    np = numpy()
    near = np.abs(column.astype(np.float64)) <= times.MOST_NS / 1e9
    if not bool(np.all(near)):
        row = int(np.argmin(near))
        raise InputError(
            f"time, row {row}: {column[row]} is not a time in seconds{times.hint(column[row])}"
        )
    if column.dtype.kind in "iu":
        return column.astype(np.int64) * 10**9  # type: ignore[no-any-return]
    # Converts in two parts, because a float near 1.7e18 ns cannot represent single nanoseconds.
    whole = np.floor(column)
    parts = np.rint((column - whole).astype(np.float64) * 1e9)
    return whole.astype(np.int64) * 10**9 + parts.astype(np.int64)  # type: ignore[no-any-return]


def _of_dates(column: "NDArray[Any]") -> "NDArray[Any]":
    """Converts a column of dates or durations to nanoseconds."""
    np = numpy()
    missing = np.isnat(column)
    if bool(missing.any()):
        row = int(np.argmax(missing))
        raise InputError(f"time, row {row}: {column[row]} is not a time in seconds")
    exact = column.astype(f"{column.dtype.kind}8[ns]")
    if not bool(np.all(exact.astype(column.dtype) == column)):
        raise InputError("time: dates must be between 1678 and 2262, in whole nanoseconds")
    return exact.astype(np.int64)  # type: ignore[no-any-return]


def listed_dt_of_time(given: Sequence[Any]) -> List[float]:
    """Does the same as dt_of_time without numpy, and returns seconds."""
    ns: List[int] = []
    for row, value in enumerate(given):
        ns.append(_time_ns(value, row))
        if row > 0 and ns[row] < ns[row - 1]:
            raise InputError(
                f"time, row {row}: the time goes backwards: {value} comes after a later time"
            )
    return [0.0, *((b - a) / 1e9 for a, b in zip(ns, ns[1:]))][: len(ns)]


def _time_ns(value: Any, row: int) -> int:
    seconds = ns = None
    try:
        seconds = value if isinstance(value, (str, decimal.Decimal, kinds.Rational)) else None
        if shapes.is_truth(value):
            seconds = None
        if seconds is None:
            seconds = shapes.number(value)
        ns = times.of_value(seconds)
    except (TypeError, ValueError, ArithmeticError):
        pass
    if ns is None:
        raise InputError(
            f"time, row {row}: {shapes.shown(value)} is not a time in seconds{times.hint(seconds)}"
        )
    return ns


SOME = 8192
"""Number of instants whose steps fit into the processor's cache."""


def steps(dt: Any, count: int) -> "NDArray[np.int64]":
    """Returns the dt of each instant in nanoseconds; the first is 0. If all instants have the same
    dt, returns at most SOME + 1 of them; the caller reuses all but the first."""
    np = numpy()
    if getattr(dt, "ndim", None) == 0 or isinstance(dt, (int, float)):
        same = np.full(min(count, SOME + 1), times.of_dt(step(dt, "dt")))
        same[:1] = 0
        return same  # type: ignore[no-any-return]
    column = as_column("dt", dt)
    if column.dtype.kind not in "iuf" or not bool(np.all(column >= 0)):
        for row, value in enumerate(column.tolist()):
            step(value, f"dt, row {row}")
    if len(column) != count:
        raise InputError(f"dt has {len(column)} rows, but the input has {count}")
    seconds = column.astype(np.float64)
    ns = np.rint(np.minimum(seconds, times.MOST_DT) * 1e9).astype(np.int64)
    ns[:1] = 0
    return ns  # type: ignore[no-any-return]


def step(dt: Any, place: str) -> float:
    """Checks a step and converts it to seconds."""
    try:
        seconds = shapes.number(dt)
    except (TypeError, ValueError, ArithmeticError):
        raise InputError(f"{place}: expected seconds, found {shapes.shown(dt)}") from None
    if math.isnan(seconds) or seconds < 0:
        raise InputError(
            f"{place}: {seconds} is not a duration: give a non-negative number of seconds"
        )
    return seconds


def numbers(leaves: Leaves, program: str) -> List[Tuple[str, shapes.Scalar]]:
    """Checks that each column contains numbers or booleans, so that an array can hold them all."""
    found: List[Tuple[str, shapes.Scalar]] = []
    for name, leaf in leaves:
        if not isinstance(leaf, shapes.Scalar):
            raise InputError(
                f"`{name}` of {program} is not a number ({leaf.meaning}), but an array can only "
                "contain numbers: give a mapping of columns, or a DataFrame"
            )
        found.append((name, leaf))
    return found
