"""What a search varies, and the searches.

A point of the search has a number from 0 to 1 for each parameter, and for each input as many as it
has control points.
"""

from __future__ import annotations

import heapq
import itertools
import random
import warnings
from bisect import bisect_right
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Sequence, Tuple

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

    def sketch(self, most: int, drawn: random.Random, is_restless: bool) -> "Sketch":
        """Parameters anywhere, and inputs that are constant but for a few changes: at most so
        many parts each, or if they are restless as many as there are control points. Half of the changes are early, as those have the rest of the run to act
        in; many values are at an end, and most last ones, where things come to rest."""

        def value(at_end: float) -> float:
            return float(drawn.getrandbits(1)) if drawn.random() < at_end else drawn.random()

        def change() -> float:
            share = drawn.random()
            return share if drawn.getrandbits(1) else self.points**-share

        most = min(most, self.points)
        parts = [self.points if is_restless else drawn.randint(1, most) for _ in self.inputs]
        numbers = [value(OFTEN) for _ in self.params]
        for count in parts:
            numbers += sorted(change() for _ in range(count - 1))
            numbers += [value(OFTEN) for _ in range(count - 1)] + [value(MOSTLY)]
        return Sketch(self, parts, numbers)

    def _steady(self, shares: List[float]) -> List[float]:
        own, others = shares[: len(self.params)], shares[len(self.params) :]
        return own + [share for share in others for _ in range(self.points)]


@dataclass(frozen=True)
class Sketch:
    """A point of a space by fewer numbers, each from 0 to 1."""

    space: Space
    parts: List[int]
    """Of each input."""
    numbers: List[float]
    """A number for each parameter; then of each input the times at which it changes, and its
    values between them."""

    def at(self, numbers: Sequence[float]) -> List[float]:
        """The point for other numbers. What is beyond an end is at the end."""
        within = [min(max(number, 0.0), 1.0) for number in numbers]
        first = len(self.space.params)
        point = within[:first]
        points = self.space.points
        for count in self.parts:
            changes = sorted(within[first : first + count - 1])
            values = within[first + count - 1 : first + 2 * count - 1]
            first += 2 * count - 1
            places = ((k + 0.5) / points for k in range(points))
            point += [values[bisect_right(changes, place)] for place in places]
        return point


def _values(range_: Range, shares: "NDArray[Any]") -> "NDArray[Any]":
    np = columns.numpy()
    if range_.kind == "float":
        values = range_.low + shares * (range_.high - range_.low)
        return np.clip(values, range_.low, range_.high)  # type: ignore[no-any-return]
    kind = bool if range_.kind == "bool" else np.int32
    return np.array([range_.at(share) for share in shares], dtype=kind)  # type: ignore[no-any-return]


Objective = Callable[[Sequence[float]], float]
"""Less is better, and below 0 is what is looked for."""

CORNERS = 8
"""At most so many of a search's runs are spent on them."""

OFTEN, MOSTLY = 0.4, 0.8
"""How likely a value is at an end."""

FEW = 3
"""So many parts an input has at most in the first sketches."""

RESTLESS = 10
"""One sketch of so many has as many parts as inputs have control points."""

SKETCHES = 30
"""So many are tried before the best of them is bettered."""

WIDTH = 0.1
"""How far CMA-ES goes at first from the sketch that it betters."""

PATIENCE = 3
"""CMA-ES ends when so many generations have come no nearer."""


class Over(Exception):
    """It is found, or there are no runs left."""


class Search:
    """Looks for a point whose value is below 0, in so many runs at most.

    First the corners. Then sketches: inputs that change a few times, and are often at an end, as
    what has modes is broken by such runs rather than by restless ones, of which there are some
    too. Whenever some have been tried, CMA-ES (Hansen) betters the best that has not been yet:
    the times of its changes, its values and the parameters. Sketches may have more parts from
    round to round, in the end as many as inputs have control points.
    """

    def __init__(self, space: Space, objective: Objective, runs: int, seed: int) -> None:
        self.space = space
        self.objective = objective
        self.runs = runs
        self.used = 0
        self.drawn = random.Random(seed)

    def run(self, method: str) -> None:
        try:
            for corner in self.space.corners(CORNERS, self.drawn):
                self.value(corner)
            tried: List[Tuple[float, int, Sketch]] = []
            for most in itertools.count(FEW):
                for number in range(SKETCHES):
                    is_restless = number % RESTLESS == 0
                    sketch = self.space.sketch(most, self.drawn, is_restless)
                    value = self.value(sketch.at(sketch.numbers))
                    heapq.heappush(tried, (value, self.used, sketch))
                if method == "cma":
                    nearest, _, sketch = heapq.heappop(tried)
                    self.better(nearest, sketch)
        except Over:
            pass

    def value(self, point: List[float]) -> float:
        value = self.objective(point)
        self.used += 1
        if value < 0 or self.used >= self.runs:
            raise Over
        return value

    def better(self, value: float, sketch: Sketch) -> None:
        # It adapts a covariance, which one number has none of: the second makes no difference.
        count = len(sketch.numbers)
        beginning = sketch.numbers if count > 1 else sketch.numbers * 2
        options = {"seed": self.drawn.randrange(1, 2**31), "verbose": -9}
        strategy = cma().CMAEvolutionStrategy(beginning, WIDTH, options)
        nearest, ago = value, 0
        while ago < PATIENCE and not strategy.stop():
            asked = strategy.ask()
            values = [self.value(sketch.at(some[:count])) for some in asked]
            strategy.tell(asked, values)
            ago = 0 if min(values) < nearest else ago + 1
            nearest = min(nearest, *values)


def need_numpy() -> None:
    try:
        import numpy  # noqa: F401
    except ImportError:
        raise Error(
            "falsify needs numpy, which is not installed: `apt install python3-numpy` or "
            "`pip install numpy`"
        ) from None


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
