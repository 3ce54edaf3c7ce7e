"""Runs a program and computes the margins of its assertions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple

from . import columns, library, margins, shapes
from .errors import InputError
from .program import Program

if TYPE_CHECKING:
    from numpy.typing import NDArray

FAILS = 3
"""The tag of the constructor `Fails` of a verdict."""

FAR = 1e9
"""The margin of a result that is certain: larger than any difference that a search needs to
consider."""


@dataclass(frozen=True)
class Claim:
    """An assertion or an assumption, and where to read its verdict. In an array of instances, each
    instance has its own claim."""

    label: str
    is_assumption: bool
    verdict: shapes.Leaf
    margin: Optional[margins.Margin]
    suffix: str


class Subject:
    """The program under test, with its assertions."""

    def __init__(self, code: library.Library, duration: float, rate: float) -> None:
        np = columns.numpy()
        self.code = code
        self.duration = duration
        count = int(duration * rate + 0.5) + 1
        self.time = np.arange(count) / rate
        self.nanoseconds = np.rint(self.time * 1e9).astype(np.int64)
        self.dt = columns.dt_of_time(self.time)
        self.claims = list(_claims(code))
        probes = code.table.probes
        shown = shapes.columns(shapes.of_value(probes[0], {}), "probe") if probes else ()
        self.leaves = dict(shown)

    # The assertions and parameters of a search.

    def assertions(self) -> List[Claim]:
        return [claim for claim in self.claims if not claim.is_assumption]

    def chosen(self, only: Sequence[str]) -> List[Claim]:
        assertions = self.assertions()
        if not assertions:
            raise InputError(
                f"{self.code.name} has no assertion that could be violated: "
                'write `assert "label" (condition)` among the equations of a proc'
            )
        known = [claim.label for claim in assertions]
        for label in only:
            if label not in known:
                raise InputError(
                    f"there is no assertion `{label}`; the assertions are: "
                    + ", ".join(f"`{one}`" for one in dict.fromkeys(known))
                )
        return [claim for claim in assertions if not only or claim.label in only]

    def params_of(self, values: Mapping[str, Any]) -> Dict[str, Any]:
        """Selects the program's own parameters from all values that a search varies."""
        return dict(values)

    # Running the program

    def judged(
        self, claim: Claim, params: Mapping[str, Any], inputs: "Mapping[str, NDArray[Any]]"
    ) -> Tuple[float, Optional[int]]:
        """Runs the program. Returns the margin of the claim, and the first instant at which the
        claim is violated. Instants after a failed assumption do not count."""
        memory = self._output(params, inputs)
        void = self.void(memory)
        failed = self._first_failure(claim, memory)
        value = self._margin(claim, memory, void)
        if failed < void:
            return min(value, 0.0), failed
        return value + self.voided(void), None

    def void(self, memory: "NDArray[Any]") -> int:
        """Returns the first instant at which an assumption fails, or the number of instants if none
        fails. That instant and all later ones do not count.
        """
        assumed = [one for one in self.claims if one.is_assumption]
        return min((self._first_failure(one, memory) for one in assumed), default=len(self.time))

    def voided(self, void: int) -> float:
        """A penalty for a failed assumption. The earlier the assumption fails, the larger it is."""
        return FAR * (1.0 - void / len(self.time)) if void < len(self.time) else 0.0

    def _first_failure(self, claim: Claim, memory: "NDArray[Any]") -> int:
        """Returns the first instant at which the claim fails, or the number of instants if it never
        does.
        """
        np = columns.numpy()
        runs, tags = _seen(claim.verdict, memory, len(self.time), self.code.table.output_size)
        failed = tags == FAILS if runs is None else (tags == FAILS) & runs
        return int(np.argmax(failed)) if bool(failed.any()) else len(self.time)

    def _output(
        self, params: Mapping[str, Any], inputs: "Mapping[str, NDArray[Any]]"
    ) -> "NDArray[Any]":
        np = columns.numpy()
        size = self.code.table.input_size
        memory = np.zeros(len(self.time) * size, dtype=np.uint8)
        columns.write(memory, size, self.code.input_columns, inputs, len(self.time))
        program = Program(self.code, params)
        output: "NDArray[Any]" = program._steps(len(self.time), self.dt, memory)
        return output

    def _margin(self, claim: Claim, memory: "NDArray[Any]", void: int) -> float:
        """Returns the smallest margin at an instant before `void`."""
        np = columns.numpy()
        if claim.margin is None:
            return FAR
        count, size = len(self.time), self.code.table.output_size
        running: Any = None
        values = {}
        for name in claim.margin.columns:
            leaf = self.leaves.get(f"probe.{name}{claim.suffix}")
            if leaf is None:
                return FAR
            running, values[name] = _seen(leaf, memory, count, size)
        least = FAR
        for first, last in _stretches(running, count):
            last = min(last, void)
            if first < last:
                part = {name: column[first:last] for name, column in values.items()}
                series = claim.margin.over(self.nanoseconds[first:last], part)
                least = min(least, float(np.min(series)))
        return max(least, -FAR)


def _claims(code: library.Library) -> Iterator[Claim]:
    count = code.table.claim_count
    texts = code.margins(count)
    for row, text in zip((code.table.claims[k] for k in range(count)), texts):
        margin = None if text is None else margins.Margin(text)
        for name, leaf in shapes.columns(shapes.of_value(row.value[0], {}), ""):
            yield Claim(row.label.decode(), bool(row.is_assumption), leaf, margin, name)


def _seen(
    leaf: shapes.Leaf, memory: "NDArray[Any]", count: int, size: int
) -> "Tuple[Optional[NDArray[Any]], NDArray[Any]]":
    """Reads a column. Returns a mask of the instants at which its signal function runs (None if it
    always runs), and the values; for a sum type, these are the constructors' tags."""
    np = columns.numpy()

    def view(kind: str, offset: int) -> "NDArray[Any]":
        return np.ndarray(  # type: ignore[no-any-return]
            (count,), dtype=kind, buffer=memory, offset=offset, strides=(size,)
        )

    if isinstance(leaf, shapes.Scalar):
        return None, view(leaf.numpy_name, leaf.offset)
    assert isinstance(leaf, shapes.Sum)
    if leaf.is_event:
        inner = leaf.constructors[1].parts[0]
        assert isinstance(inner, (shapes.Scalar, shapes.Sum))
        return view("uint8", leaf.offset) == 1, _seen(inner, memory, count, size)[1]
    return None, view("uint8", leaf.offset)


def _stretches(running: Any, count: int) -> Iterator[Tuple[int, int]]:
    """Yields the uninterrupted stretches in which a signal function runs: for each, the first
    instant, and the instant after the last one."""
    np = columns.numpy()
    if running is None:
        yield 0, count
        return
    edges = np.flatnonzero(np.diff(np.concatenate(([0], running.astype(np.int8), [0]))))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist())
