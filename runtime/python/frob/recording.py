"""Reads recordings: CSV files with a header and one row for each instant."""

from __future__ import annotations

import csv
import gzip
import io
import os
import subprocess
import zlib
from contextlib import closing
from dataclasses import dataclass
from typing import (
    IO,
    TYPE_CHECKING,
    Any,
    Dict,
    Generator,
    Iterable,
    Iterator,
    List,
    Mapping,
    Optional,
    Sequence,
    Tuple,
    cast,
)

from . import cells, times
from .data import Data, is_missing
from .dialect import OURS, Dialect, to_front
from .errors import Error, InputError
from .tools import PathLike, path_text

if TYPE_CHECKING:
    import pandas as pd

    Table = pd.DataFrame


class Columns(Dict[str, Any]):
    """A table of columns by name, used if pandas is not installed. `attrs` has the same meaning as
    in a DataFrame."""

    def __init__(self, columns: Dict[str, Any]) -> None:
        super().__init__(columns)
        self.attrs: Dict[str, Any] = {}


@dataclass(frozen=True)
class Assertion:
    """The result of an assertion or assumption in a recording."""

    label: str
    verdict: str
    """`held`, `violated`, `undecided`, or `never checked`."""
    first: Optional[float]
    """The time of the first violation, in seconds."""
    count: int
    """The number of instants with a violation."""


def read(
    file: PathLike,
    *,
    separator: str = ",",
    decimal_comma: bool = False,
    time_column: Optional[str] = None,
    columns: Optional[Mapping[str, str]] = None,
) -> "Table":
    """Reads a recording, or any trace, as a DataFrame; without pandas, as `Columns`.

    Numbers and booleans are Python's own; `frob.Data` describes all other values. An event that
    does not occur is None. `attrs` contains `params` (the values that the program ran with),
    `units` (their units) and `assertions` (the result of each assertion). Files whose names end in
    .gz or .zst are decompressed; for .zst, this needs the program zstd.

    These options read recordings from other programs: `separator` is the separator between cells
    (`"tab"` or a character); `decimal_comma` is True if numbers have a decimal comma; `time_column`
    names the column with the times; and `columns` maps names of columns to those in the file, as in
    `{"in.speed": "wheel_speed"}`. Times that a float cannot represent to the nanosecond (beyond
    2^53 ns), such as times since 1970, are exact and relative to the first row;
    `attrs["origin_ns"]` is the time of the first row.
    """
    dialect = Dialect.checked(separator, decimal_comma, time_column, columns)
    path = path_text(file, "file")
    try:
        with open(path, "rb", buffering=0) as raw, closing(_unpacked(path, raw)) as pieces:
            text = b"".join(_with_short_lines(path, pieces)).decode("utf-8-sig")
    except OSError as error:
        raise Error(f"cannot read {path}: {error.strerror or error}") from None
    except UnicodeDecodeError:
        raise Error(f"{path} is not a recording: it is not text") from None
    table: "Table" = parsed(path, text, dialect)
    return table


_TOOLS = {".gz": ("gzip", b"\x1f\x8b"), ".zst": ("zstd", b"\x28\xb5\x2f\xfd")}


LONGEST = 16 << 20
"""Maximum length of a row in bytes; it bounds the memory use for any file."""


def _with_short_lines(path: str, pieces: Iterable[bytes]) -> Iterator[bytes]:
    length = 0
    for piece in pieces:
        first, last = piece.find(b"\n"), piece.rfind(b"\n")
        if length + (len(piece) if first < 0 else first) > LONGEST:
            raise Error(f"{path} is not a recording: it has a row of more than {LONGEST >> 20} MB")
        length = length + len(piece) if last < 0 else len(piece) - last - 1
        yield piece


def _pieces(stream: IO[bytes]) -> Iterator[bytes]:
    while piece := stream.read(1 << 16):
        yield piece


def _unpacked(path: str, raw: IO[bytes]) -> Generator[bytes, None, None]:
    tool, magic = _TOOLS.get(os.path.splitext(path)[1], (None, b""))
    if tool is None:
        yield from _pieces(raw)
        return
    reason = "the archive is truncated or damaged (`frobc convert` recovers its complete rows)"
    try:
        if raw.seekable() and os.pread(raw.fileno(), len(magic), 0) != magic:
            reason = f"its name says that it is compressed by {tool}, but it is not"
        elif tool == "gzip":
            yield from _pieces(gzip.GzipFile(fileobj=raw))
            return
        else:
            with subprocess.Popen(
                [tool, "-dcq"], stdin=raw, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
            ) as unpacking:
                try:
                    yield from _pieces(cast(IO[bytes], unpacking.stdout))
                except GeneratorExit:
                    unpacking.kill()
                    raise
            if unpacking.returncode == 0:
                return
    except FileNotFoundError:
        reason = f"this needs the program {tool}, which is not installed (`apt install {tool}`)"
    except (EOFError, OSError, zlib.error):
        pass
    raise Error(f"cannot read {path}: {reason}")


def parsed(path: str, text: str, dialect: Dialect = OURS) -> Any:
    head, rest, lines = _head(text)
    try:
        rows = [row for row in _cells(rest, dialect) if row]
    except csv.Error as error:
        raise Error(f"{path} is not a recording: {error}") from None
    if not rows:
        raise Error(f"{path}:{lines + 1}: not a recording: the first column must be `time`")
    try:
        time, names = dialect.header(rows[0])
    except InputError as error:
        raise InputError(f"{path}:{lines + 1}: {error}") from None
    if names[0] != "time":
        raise Error(
            f"{path}:{lines + 1}: not a recording: the first column must be `time`, not "
            f"`{names[0]}`{dialect.time_hint(names)}"
        )
    body = rows[1:]
    for number, row in enumerate(body):
        if len(row) != len(names):
            raise Error(
                f"{path}:{lines + number + 2}: {len(names)} columns, but {len(row)} cells in this "
                f"row{dialect.width_hint(len(names), len(row))}"
            )
    by_column = zip(*body) if body else ((),) * len(names)
    given = to_front(time, list(by_column))
    columns = {n: _column(path, n, c, lines, dialect) for n, c in zip(names, given)}
    columns["time"], origin = _times(columns["time"], given[0], dialect)
    table = as_table({name: _array(column) for name, column in columns.items()})
    table.attrs["origin_ns"] = origin
    table.attrs["params"], table.attrs["units"] = _params(path, head)
    table.attrs["assertions"] = _assertions(columns)
    return table


def as_table(columns: Dict[str, Any]) -> Any:
    try:
        import pandas
    except ImportError:
        return Columns(columns)
    return pandas.DataFrame(columns)


def _head(text: str) -> Tuple[List[str], str, int]:
    """Splits a file into the comment lines before the header and the rest; also returns the number
    of comment lines.
    """
    head: List[str] = []
    at = 0
    while text.startswith("#", at):
        end = text.find("\n", at) + 1 or len(text)
        head.append(text[at:end].strip())
        at = end
    return head, text[at:], len(head)


def _params(path: str, head: Iterable[str]) -> Tuple[Dict[str, Any], Dict[str, str]]:
    params: Dict[str, Any] = {}
    units: Dict[str, str] = {}
    for place, line in enumerate(head):
        if line.startswith("# param ") and "=" in line:
            name, value = line[len("# param ") :].split("=", 1)
            number, _, unit = value.partition("[")
            try:
                params[name] = cells.value(number)
            except cells.CellError as error:
                raise Error(f"{path}:{place + 1}: parameter `{name}`: {error}") from None
            units[name] = unit.rstrip("]")
    return params, units


def _cells(text: str, dialect: Dialect) -> Iterable[List[str]]:
    return csv.reader(io.StringIO(text, newline=""), delimiter=dialect.separator, strict=True)


def _times(seconds: List[Any], texts: Sequence[str], dialect: Dialect) -> Tuple[List[Any], int]:
    """Makes the times relative to the first row if floats cannot represent them to the nanosecond.
    Also returns the origin in ns."""
    if not any(isinstance(one, float) and abs(one) * 1e9 > times.IN_A_FLOAT for one in seconds):
        return seconds, 0
    exact = [times.of_text(dialect.cell(text)) for text in texts]
    if exact[0] is None:
        return seconds, 0
    rest = zip(exact, seconds)
    return [(ns - exact[0]) / 1e9 if ns is not None else one for ns, one in rest], exact[0]


def _column(path: str, name: str, texts: Iterable[str], lines: int, dialect: Dialect) -> List[Any]:
    texts = [dialect.cell(text) for text in texts]
    try:
        return [_float(text) for text in texts]
    except ValueError:
        pass  # also catches CellError, which is reported with its row below
    if set(texts) <= {"true", "false"}:
        return [text == "true" for text in texts]
    values: List[Any] = []
    for number, text in enumerate(texts):
        try:
            values.append(_cell(text))
        except cells.CellError as error:
            if dialect.names and name not in dialect.columns and name != "time":
                return texts
            hint = dialect.number_hint(text)
            raise Error(f"{path}:{lines + number + 2}: column `{name}`: {error}{hint}") from None
    if all(value is None or isinstance(value, Data) and not value.args for value in values):
        return [value and value.constructor for value in values]
    return values


def _float(text: str) -> float:
    if "_" in text:
        raise ValueError
    return cells.finite(text)


def _cell(text: str) -> Any:
    """Parses a cell. An empty cell is an event that does not occur. An event that carries NaN keeps
    its constructor, because NaN alone would mean a missing value.
    """
    if text.strip() == "":
        return None
    value = cells.value(text)
    return Data("Event", value) if is_missing(value) and value is not None else value


def _array(column: List[Any]) -> Any:
    try:
        import numpy as np
    except ImportError:
        return column
    kinds = {type(value) for value in column}
    if kinds <= {float} or kinds == {bool}:
        return np.array(column, dtype=float if kinds <= {float} else bool)
    array = np.empty(len(column), dtype=object)
    for row, value in enumerate(column):
        array[row] = value
    return array


VERDICTS = {"NotAsked", "Holds", "Open", "Fails", None}


def _assertions(columns: Dict[str, List[Any]]) -> Dict[str, Assertion]:
    """Computes the results of the assertions as a host prints them. The first instant at which an
    assumption fails, and all later instants, do not count.
    """
    told = {
        name: column
        for name, column in columns.items()
        if _label(name) and all(_is_verdict(value) for value in column)
    }
    labels = [_label(name) for name in told]
    assumed = {name: column for name, column in told.items() if ".assume " in name}
    failures = (column.index("Fails") for column in assumed.values() if "Fails" in column)
    void = min(failures, default=None)
    found: Dict[str, Assertion] = {}
    for name, column in told.items():
        label = _label(name) if labels.count(_label(name)) == 1 else name[len("probe.") :]
        judged = column if name in assumed else column[:void]
        found[label] = _fate(label, judged, columns["time"])
    return found


def _fate(label: str, column: List[Any], time: List[float]) -> Assertion:
    failed = [t for t, verdict in zip(time, column) if verdict == "Fails"]
    seen = [verdict for verdict in column if verdict is not None]
    if failed:
        verdict = "violated"
    elif seen and seen[-1] == "Open":
        verdict = "undecided"
    else:
        verdict = "held" if set(seen) - {"NotAsked"} else "never checked"
    return Assertion(label, verdict, failed[0] if failed else None, len(failed))


def _label(column: str) -> str:
    for word in (".assert ", ".assume "):
        if column.startswith("probe.") and word in column:
            return column.split(word, 1)[1]
    return ""


def _is_verdict(value: Any) -> bool:
    return value is None or isinstance(value, str) and value in VERDICTS
