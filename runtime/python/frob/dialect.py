"""Recordings from other programs, with a different separator, a decimal comma, or other column
names.

`frobc trace` reads them with the same options (compiler/interp/trace/dialect.mli).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any, List, Mapping, Optional, Sequence, Tuple

from .errors import InputError

SEPARATORS = ",;|: ^~#&/\t"
_DECIMAL_COMMA = re.compile(r"([-+]?[0-9]*),([0-9]+([eE][-+]?[0-9]+)?)")
_LIKE_TIME = re.compile(r".*(time|stamp).*|t|secs?|seconds", re.IGNORECASE)


@dataclass(frozen=True)
class Dialect:
    separator: str = ","
    decimal_comma: bool = False
    time_column: Optional[str] = None
    columns: Mapping[str, str] = field(default_factory=dict)
    """Maps the program's column names to those of the recording."""

    @staticmethod
    def checked(separator: Any, decimal_comma: Any, time_column: Any, columns: Any) -> "Dialect":
        separator = "\t" if separator == "tab" else separator
        if not (isinstance(separator, str) and len(separator) == 1 and separator in SEPARATORS):
            text = f'separator: expected "tab", or a character such as ";", found {separator!r:.60}'
            raise InputError(text)
        if not isinstance(decimal_comma, bool):
            text = f"decimal_comma: expected True or False, found {decimal_comma!r:.60}"
            raise InputError(text)
        if not (time_column is None or isinstance(time_column, str)):
            raise InputError(f"time_column: expected a name, found {time_column!r:.60}")
        columns = {} if columns is None else columns
        are_names = isinstance(columns, Mapping) and all(
            isinstance(one, str) for pair in columns.items() for one in pair
        )
        if not are_names:
            raise InputError(f"columns: expected a mapping of names, found {columns!r:.60}")
        return Dialect(separator, decimal_comma, time_column, columns)

    @property
    def names(self) -> bool:
        """Returns whether the dialect names columns. If so, other columns may contain any text."""
        return self.time_column is not None or bool(self.columns)

    def header(self, names: Sequence[str]) -> Tuple[int, List[str]]:
        """Returns the index of the time column, and the names of the columns, with `time` first."""
        ours: List[str] = list(names)
        left: List[Optional[str]] = list(names)

        def find(option: str, column: str) -> int:
            if column not in left:
                known = ", ".join(f"`{name}`" for name in ours)
                text = f"there is no column `{column}` for `{option}`; the columns are {known}"
                raise InputError(text + self.separator_hint(ours))
            return left.index(column)

        time = 0 if self.time_column is None else find("time_column", self.time_column)
        for name, column in self.columns.items():
            place = find("columns", column)
            ours[place], left[place] = name, None
        if self.time_column is not None:
            ours[time] = "time"
        return time, to_front(time, ours)

    def cell(self, text: str) -> str:
        """Replaces the decimal comma of a number with a decimal point."""
        found = _DECIMAL_COMMA.fullmatch(text) if self.decimal_comma else None
        return f"{found[1]}.{found[2]}" if found else text

    def separator_hint(self, names: Sequence[str]) -> str:
        first = names[0]
        for mark, many, argument in (
            (";", "semicolons", '";"'),
            ("\t", "tabs", '"tab"'),
            (",", "commas", '","'),
        ):
            if mark in first and mark != self.separator:
                return f"; its columns are separated by {many}: pass `separator={argument}`"
        return ""

    def time_hint(self, names: Sequence[str]) -> str:
        if hint := self.separator_hint(names):
            return hint
        exact = [name for name in names if name.lower() == "time"]
        like = exact + [name for name in names if _LIKE_TIME.fullmatch(name)]
        column = f'"{like[0]}"' if like else "NAME"
        return f"; to choose the column with the times, pass `time_column={column}`"

    def width_hint(self, width: int, count: int) -> str:
        """Returns a hint for a row with `count` cells where the header has `width` columns."""
        if count > width and self.decimal_comma and self.separator == ",":
            return (
                "; if numbers have a decimal comma, put them in double quotes, or separate the cells "
                'by `;` and pass `separator=";"`'
            )
        return "; the recording may be truncated"

    def number_hint(self, text: str) -> str:
        is_one = not self.decimal_comma and _DECIMAL_COMMA.fullmatch(text)
        return "; for numbers with a decimal comma, pass `decimal_comma=True`" if is_one else ""


OURS = Dialect()


def to_front(place: int, items: Sequence[Any]) -> List[Any]:
    return (
        [items[place], *items[:place], *items[place + 1 :]] if place < len(items) else list(items)
    )
