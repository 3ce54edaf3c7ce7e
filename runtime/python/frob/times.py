"""Exact times in whole nanoseconds. A float has too few digits for nanoseconds since 1970."""

from __future__ import annotations

import decimal
import math
import numbers
import re
from typing import Any, Optional

MOST_NS = 4 * 10**18
"""Maximum time. Times since 1970 will reach it in the year 2096."""

IN_A_FLOAT = 2**53
"""Maximum time that a float in seconds can represent to the nanosecond."""

_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", re.ASCII)
_EXACT = decimal.Context(prec=60, rounding=decimal.ROUND_HALF_UP)


def of_text(text: str) -> Optional[int]:
    """Parses seconds as in a trace; rounds halves away from zero. None if the text is invalid."""
    if not _NUMBER.fullmatch(text):
        return None
    try:
        return _of_decimal(decimal.Decimal(text))
    except ArithmeticError:
        return None


def of_value(value: Any) -> Optional[int]:
    """Converts a time in seconds (a number or a string) to nanoseconds. None if it is invalid or
    too large."""
    if isinstance(value, str):
        return of_text(value.strip())
    if isinstance(value, decimal.Decimal):
        return _of_decimal(value) if value.is_finite() else None
    if isinstance(value, numbers.Integral):
        value = int(value)  # numpy's integers overflow
    if isinstance(value, numbers.Rational):
        ns = round(value * 10**9)
        return ns if abs(ns) <= MOST_NS else None
    seconds = float(value)
    if not abs(seconds) <= MOST_NS / 1e9:
        return None
    whole = math.floor(seconds)
    return whole * 10**9 + round((seconds - whole) * 1e9)


MOST_DT = 1e9
"""Maximum dt in seconds. Longer steps are clamped to this, as in generated C."""


def of_dt(seconds: float) -> int:
    """Rounds a dt, which must not be negative, to nanoseconds. Rounds halves to even, as generated
    C does."""
    return round(min(seconds, MOST_DT) * 1e9)


def hint(seconds: Any) -> str:
    """Returns a hint, in the words of `frobc`, if a time that is too large looks like a time since
    1970 in a smaller unit; otherwise, returns an empty string.
    """
    try:
        size = abs(float(seconds))
    except (TypeError, ValueError, ArithmeticError):
        return ""
    for unit, least, most, factor in (
        ("milliseconds", 1e11, 1e14, "1e3"),
        ("microseconds", 1e14, 1e17, "1e6"),
        ("nanoseconds", 1e17, 1e20, "1e9"),
    ):
        if least <= size < most:
            return f": this looks like {unit}, so divide the times by {factor}"
    return ""


def _of_decimal(seconds: decimal.Decimal) -> Optional[int]:
    if seconds.adjusted() > 10:
        return None
    ns = int(_EXACT.quantize(_EXACT.scaleb(_EXACT.create_decimal(seconds), 9), decimal.Decimal(1)))
    return ns if abs(ns) <= MOST_NS else None
