"""What a search varies, and the searches.

A point of the search has a number from 0 to 1 for each parameter, and for each input as many as it
has control points.
"""

from __future__ import annotations

import random
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Sequence

from . import columns
from .errors import Error, InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

SHAPES = ("constant", "linear")
METHODS = ("cma", "random")


@dataclass(frozen=True)
class Range:
    """What a parameter or an input may be, in the unit that the program has it in."""

    name: str
    low: float
    high: float
    kind: str
    """`float`, `int` or `bool`."""

    def at(self, share: float) -> Any:
        if self.kind == "bool":
            return share >= 0.5
        if self.kind == "int":
            whole = int(self.low + share * (self.high - self.low + 1))
            return min(whole, int(self.high))
        return min(max(self.low + share * (self.high - self.low), self.low), self.high)


class Space:
    """All that is varied: parameters, then inputs by their control points."""

    def __init__(
        self, params: Sequence[Range], inputs: Sequence[Range], points: int, shape: str
    ) -> None:
        self.params = params
        self.inputs = inputs
        self.points = points
        self.shape = shape
        self.size = len(params) + points * len(inputs)

    def params_at(self, point: Sequence[float]) -> Dict[str, Any]:
        return {param.name: param.at(share) for param, share in zip(self.params, point)}

    def inputs_at(
        self, point: Sequence[float], time: "NDArray[Any]", duration: float
    ) -> "Dict[str, NDArray[Any]]":
        """The inputs at these times: constant from each control point to the next, or linear
        between the first instant and the last."""
        np = columns.numpy()
        found = {}
        at = len(self.params)
        for input_ in self.inputs:
            shares = np.asarray(point[at : at + self.points], float)
            at += self.points
            if self.shape == "linear" and self.points > 1:
                places = np.linspace(0.0, duration, self.points)
                found[input_.name] = _values(input_, np.interp(time, places, shares))
            else:
                # Half a nanosecond, that an instant on the border is on this side of it.
                index = ((time + 5e-10) * (self.points / duration)).astype(int)
                values = _values(input_, shares)
                found[input_.name] = values[np.minimum(index, self.points - 1)]
        return found

    def refined(self, point: Sequence[float], points: int) -> List[float]:
        """A point of a space whose inputs have so many control points, no more than here, as one
        of this space. A part that is constant there is one here."""
        fine = list(point[: len(self.params)])
        for first in range(len(self.params), len(point), points):
            coarse = list(point[first : first + points])
            if self.shape == "linear" and points > 1:
                places = [k * (points - 1) / (self.points - 1) for k in range(self.points)]
                fine += [_between(coarse, place) for place in places]
            else:
                fine += [coarse[k * points // self.points] for k in range(self.points)]
        return fine

    def corners(self, most: int, drawn: random.Random) -> Iterator[List[float]]:
        """Everything at one of its ends, inputs all the time; some of them where these are
        more than `most`."""
        count = len(self.params) + len(self.inputs)
        if 2**count <= most:
            numbers: Sequence[int] = range(2**count)
        else:
            numbers = [drawn.getrandbits(count) for _ in range(most)]
        for number in numbers:
            yield self._steady([float(number >> k & 1) for k in range(count)])

    def pulse(self, drawn: random.Random) -> Callable[[Sequence[float]], List[float]]:
        """Any corner, parameters anywhere, and one input that leaves its end for a while: for the
        numbers from 0 to 1 that say when, how long (rather a short time than a long one) and for
        what."""
        params = [drawn.random() for _ in self.params]
        steady = self._steady(params + [float(drawn.getrandbits(1)) for _ in self.inputs])
        offset = len(self.params) + drawn.randrange(len(self.inputs)) * self.points

        def point(numbers: Sequence[float]) -> List[float]:
            when, length, value = numbers
            first = min(int(max(when, 0.0) * self.points), self.points - 1)
            last = first + int(self.points ** min(max(length, 0.0), 1.0))
            changed = list(steady)
            for k in range(first, min(last, self.points)):
                changed[offset + k] = _within(value)
            return changed

        return point

    def _steady(self, shares: List[float]) -> List[float]:
        own, others = shares[: len(self.params)], shares[len(self.params) :]
        return own + [share for share in others for _ in range(self.points)]


def _between(values: Sequence[float], place: float) -> float:
    first = min(int(place), len(values) - 2)
    return values[first] + (place - first) * (values[first + 1] - values[first])


def _values(range_: Range, shares: "NDArray[Any]") -> "NDArray[Any]":
    np = columns.numpy()
    if range_.kind == "float":
        values = range_.low + shares * (range_.high - range_.low)
        return np.clip(values, range_.low, range_.high)  # type: ignore[no-any-return]
    kind = bool if range_.kind == "bool" else np.int32
    return np.array([range_.at(share) for share in shares], dtype=kind)  # type: ignore[no-any-return]


PULSE_NUMBERS = 3
"""Of a pulse: when, how long, for what (`Space.pulse`)."""

Objective = Callable[[Sequence[float]], float]
"""Less is better, and below 0 is what is looked for."""

CORNERS = 8
"""At most so many of a search's runs are spent on them."""

BEYOND = 0.25
"""A search goes so far beyond each end, which is the end itself: there is where things break."""

PULSES = 300
"""So many of them are tried before CMA-ES begins at another place."""

PATIENCE = 12
"""CMA-ES ends after so many runs for each number that it looks for."""


class Over(Exception):
    """It is found, or there are no runs left."""


class Search:
    """Looks for a point whose value is below 0, in so many runs at most.

    First the corners. Then pulses: everything stays at an end, but for one input in some part of
    the time; from each that comes nearer than all before, CMA-ES (Hansen) changes that part. And,
    in turn with them, CMA-ES over everything, from another place each time. There inputs begin
    with few control points, and come to all of them by and by: what can be found with few is
    found sooner.
    """

    def __init__(self, space: Space, objective: Objective, runs: int, seed: int) -> None:
        self.space = space
        self.objective = objective
        self.runs = runs
        self.used = 0
        self.nearest = float("inf")
        self.drawn = random.Random(seed)

    def run(self, method: str) -> None:
        try:
            for corner in self.space.corners(CORNERS, self.drawn):
                self.value(corner)
            while method == "random":
                self.value([_within(self.drawn.random()) for _ in range(self.space.size)])
            for points in _levels(self.space):
                for _ in range(PULSES if self.space.inputs else 0):
                    self.pulse()
                self.everything(points)
        except Over:
            pass

    def value(self, point: List[float]) -> float:
        value = self.objective(point)
        self.used += 1
        if value < 0 or self.used >= self.runs:
            raise Over
        self.nearest = min(self.nearest, value)
        return value

    def pulse(self) -> None:
        before = self.nearest
        pulse = self.space.pulse(self.drawn)
        numbers = [self.drawn.random() for _ in range(PULSE_NUMBERS)]
        if self.value(pulse(numbers)) < before:
            self.evolution(numbers, 0.1, pulse)

    def everything(self, points: int) -> None:
        space = self.space
        size = len(space.params) + points * len(space.inputs)
        # It adapts a covariance, which one number has none of.
        beginning = [self.drawn.random() for _ in range(max(size, 2))]

        def refined(shares: Sequence[float]) -> List[float]:
            return space.refined([_within(share) for share in shares[:size]], points)

        self.evolution(beginning, 0.4, refined)

    def evolution(
        self,
        beginning: List[float],
        width: float,
        point: Callable[[Sequence[float]], List[float]],
    ) -> None:
        options = {"seed": self.drawn.randrange(1, 2**31), "verbose": -9}
        strategy = cma().CMAEvolutionStrategy(beginning, width, options)
        left = PATIENCE * len(beginning)
        while left > 0 and not strategy.stop():
            asked = strategy.ask()
            strategy.tell(asked, [self.value(point(shares)) for shares in asked])
            left -= len(asked)


def _levels(space: Space) -> Iterator[int]:
    """How many control points, one search after the other, without end: 2; 2, 3; 2, 3, 5; …"""
    all_ = [space.points]
    while all_[0] > 2:
        all_.insert(0, (all_[0] + 1) // 2)
    round_ = 1
    while True:
        yield from all_[:round_]
        round_ = min(round_ + 1, len(all_))


def _within(share: float) -> float:
    return min(max((1 + 2 * BEYOND) * share - BEYOND, 0.0), 1.0)


def cma() -> Any:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that it cannot draw, without matplotlib
            import cma
    except ImportError:
        raise Error(
            "the search by CMA-ES needs the package cma, which is not installed: "
            "`pip install cma`, or search at random, which takes more runs (method random)"
        ) from None
    return cma
