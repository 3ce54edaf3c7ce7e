"""Reads recordings: CSV with a row for each instant, and what stands at their head."""

from __future__ import annotations

import csv
import gzip
import io
import os
import subprocess
import zlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Optional, Tuple

from . import cells
from .data import Data, is_missing
from .errors import Error
from .tools import PathLike

if TYPE_CHECKING:
    import pandas as pd

    Table = pd.DataFrame


class Columns(Dict[str, Any]):
    """Columns by name, where pandas is not installed; `attrs` is as a DataFrame's."""

    def __init__(self, columns: Dict[str, Any]) -> None:
        super().__init__(columns)
        self.attrs: Dict[str, Any] = {}


@dataclass(frozen=True)
class Assertion:
    """What became of an assertion, or of an assumption, in a recording."""

    label: str
    verdict: str
    """`held`, `violated`, `undecided`, or `never asked`."""
    first: Optional[float]
    """The time at which it was violated first, in seconds."""
    count: int
    """At how many instants it was violated."""


def read(file: PathLike) -> "Table":
    """The rows of a recording, or of any trace, as a DataFrame; as `Columns` without pandas.

    Numbers are numbers, truth values are bool; what a program's data is in Python, `frob.Data`
    tells. Where an event does not occur there is None. `attrs` has `params`, the values that
    the program ran with, `units`, theirs, and `assertions`, what became of each. Names that
    end in .gz and .zst are decompressed, the latter by the program zstd.
    """
    path = os.fspath(file)
    try:
        with open(path, "rb") as raw:
            data = raw.read()
        text = _unpacked(path, data).decode("utf-8-sig")
    except OSError as error:
        raise Error(f"cannot read {path}: {error.strerror or error}") from None
    except UnicodeDecodeError:
        raise Error(f"{path} is not a recording: it is not text") from None
    table: "Table" = parsed(path, text)
    return table


_TOOLS = {".gz": ("gzip", b"\x1f\x8b"), ".zst": ("zstd", b"\x28\xb5\x2f\xfd")}


def _unpacked(path: str, data: bytes) -> bytes:
    tool, magic = _TOOLS.get(os.path.splitext(path)[1], (None, b""))
    if tool is None:
        return data
    reason = "the archive is cut off or damaged (`frobc convert` keeps its whole rows)"
    try:
        if not data.startswith(magic):
            reason = f"it is not compressed by {tool}, as its name says"
        elif tool == "gzip":
            return gzip.decompress(data)
        else:
            done = subprocess.run([tool, "-dcq"], input=data, capture_output=True)
            if done.returncode == 0:
                return done.stdout
    except FileNotFoundError:
        reason = f"the program {tool}, by which it goes, is not installed (`apt install {tool}`)"
    except (EOFError, OSError, zlib.error):
        pass
    raise Error(f"cannot read {path}: {reason}")


def parsed(path: str, text: str) -> Any:
    head, rest, lines = _head(text)
    try:
        rows = [row for row in csv.reader(io.StringIO(rest, newline=""), strict=True) if row]
    except csv.Error as error:
        raise Error(f"{path} is not a recording: {error}") from None
    if not rows or rows[0][0] != "time":
        found = f", found `{rows[0][0]}`" if rows else ""
        raise Error(f"{path}:{lines + 1}: not a recording: its first column is `time`{found}")
    names, body = rows[0], rows[1:]
    for number, row in enumerate(body):
        if len(row) != len(names):
            raise Error(
                f"{path}:{lines + number + 2}: {len(names)} columns, but {len(row)} cells in this "
                "row; the recording may have been cut"
            )
    by_column = zip(*body) if body else ((),) * len(names)
    columns = {n: _column(path, n, c, lines) for n, c in zip(names, by_column)}
    table = as_table({name: _array(column) for name, column in columns.items()})
    table.attrs["params"], table.attrs["units"] = _params(head)
    table.attrs["assertions"] = _assertions(columns)
    return table


def as_table(columns: Dict[str, Any]) -> Any:
    try:
        import pandas
    except ImportError:
        return Columns(columns)
    return pandas.DataFrame(columns)


def _head(text: str) -> Tuple[List[str], str, int]:
    """The comment lines before the names of columns, what comes after, and how many they are."""
    head: List[str] = []
    at = 0
    while text.startswith("#", at):
        end = text.find("\n", at) + 1 or len(text)
        head.append(text[at:end].strip())
        at = end
    return head, text[at:], len(head)


def _params(head: Iterable[str]) -> Tuple[Dict[str, Any], Dict[str, str]]:
    params: Dict[str, Any] = {}
    units: Dict[str, str] = {}
    for line in head:
        if line.startswith("# param ") and "=" in line:
            name, value = line[len("# param ") :].split("=", 1)
            number, _, unit = value.partition("[")
            params[name] = cells.value(number)
            units[name] = unit.rstrip("]")
    return params, units


def _column(path: str, name: str, texts: Iterable[str], lines: int) -> List[Any]:
    texts = list(texts)
    try:
        return [float(text) for text in texts]
    except ValueError:
        pass
    if set(texts) <= {"true", "false"}:
        return [text == "true" for text in texts]
    values: List[Any] = []
    for number, text in enumerate(texts):
        try:
            values.append(_cell(text))
        except cells.CellError as error:
            raise Error(f"{path}:{lines + number + 2}: column `{name}`: {error}") from None
    if all(value is None or isinstance(value, Data) and not value.args for value in values):
        return [value and value.constructor for value in values]
    return values


def _cell(text: str) -> Any:
    """An empty cell is an event that does not occur; one that occurs with NaN needs a name."""
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
    """As a host tells it at the end: an assumption that fails voids what comes after."""
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
        verdict = "held" if set(seen) - {"NotAsked"} else "never asked"
    return Assertion(label, verdict, failed[0] if failed else None, len(failed))


def _label(column: str) -> str:
    for word in (".assert ", ".assume "):
        if column.startswith("probe.") and word in column:
            return column.split(word, 1)[1]
    return ""


def _is_verdict(value: Any) -> bool:
    return value is None or isinstance(value, str) and value in VERDICTS
