"""The space of parameters and inputs that a search varies, and the search algorithms.

A point of the space has one number from 0 to 1 for each parameter, and one for each control point
of each input.
"""

from __future__ import annotations

import heapq
import importlib.util
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
    """The range of a parameter or an input, in the unit that the program uses."""

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
    """The search space: the parameters, then the control points of the inputs."""

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
        """The inputs' values at these times: constant from each control point to the next, or
        linear between control points that are spread evenly from the first instant to the last."""
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
                # Adds half a nanosecond, so that an instant on a boundary reliably belongs to the
                # next value.
                index = ((time + 5e-10) * (self.points / duration)).astype(int)
                values = _values(input_, shares)
                found[input_.name] = values[np.minimum(index, self.points - 1)]
        return found

    def corners(self, most: int, drawn: random.Random) -> Iterator[List[float]]:
        """Yields points in which every parameter and every input is at one end of its range; an
        input stays there for the whole run. If there are more than `most` such points, yields a
        random selection."""
        count = len(self.params) + len(self.inputs)
        if 2**count <= most:
            numbers: Sequence[int] = range(2**count)
        else:
            numbers = [drawn.getrandbits(count) for _ in range(most)]
        for number in numbers:
            yield self._steady([float(number >> k & 1) for k in range(count)])

    def sketch(self, most: int, drawn: random.Random, is_restless: bool) -> "Sketch":
        """Draws a random point: parameters anywhere in their ranges, and inputs that change a few
        times. An input has at most `most` constant parts, or, if `is_restless` is true, as many
        parts as there are control points. Half of the changes are early, so that they can take
        effect during the rest of the run. Many values are at an end of their range, especially the
        last value of each input, which stays in effect until the end of the run."""

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
    """A point, described by when and how its inputs change instead of by their control points. All
    numbers are from 0 to 1."""

    space: Space
    parts: List[int]
    """Number of constant parts of each input."""
    numbers: List[float]
    """One number for each parameter; then, for each input, the times at which it changes, and its
    values between them."""

    def at(self, numbers: Sequence[float]) -> List[float]:
        """Returns the point that these numbers describe. Clips each number to the range 0 to 1."""
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
"""The function to minimize. A negative value ends the search."""

CORNERS = 8
"""Maximum number of corners that a search tries."""

OFTEN, MOSTLY = 0.4, 0.8
"""Probabilities that a value is at an end of its range: for most values, and for the last value of
each input."""

FEW = 3
"""Maximum number of parts of an input in the first round of sketches."""

RESTLESS = 10
"""Every RESTLESS-th sketch has as many parts as there are control points."""

SKETCHES = 30
"""Number of sketches in a round, after which the best one is improved."""

WIDTH = 0.1
"""Initial step size of CMA-ES."""

PATIENCE = 3
"""Number of generations without progress after which CMA-ES stops."""


class Over(Exception):
    """Raised when a point has been found, or when no runs are left."""


class Search:
    """Searches for a point with a negative value, in a limited number of runs.

    The search first tries the corners. Then it tries random sketches, in which most inputs change
    only a few times and are often at an end of their range. Such runs are more likely to reveal
    faults in programs with modes than restless runs are, but the search also tries a few restless
    ones. After each round of sketches, CMA-ES (Hansen) improves the best sketch that it has not
    worked on yet: its parameters, and the times and values of its inputs. In each round, sketches
    may have more parts than in the previous one, up to the number of control points.
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
        # CMA-ES adapts a covariance matrix, so it needs at least two numbers. If there is only one,
        # this adds a second one, which has no effect.
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


def need_packages(method: str) -> None:
    """Checks, before anything is compiled, that the packages for this search method are installed.
    Otherwise, raises an error that says how to install the missing ones.
    """
    needed = ["numpy", "cma"] if method == "cma" else ["numpy"]
    missing = [name for name in needed if importlib.util.find_spec(name) is None]
    if not missing:
        return
    which = " and ".join(missing) + (", which is" if len(missing) == 1 else ", which are")
    blind = (
        "; or search at random (`--method random`), which takes more runs"
        + ("" if missing == ["cma"] else " and needs only numpy")
        if "cma" in missing
        else ""
    )
    raise Error(f"falsify needs {which} not installed: run `frobc extras install search`{blind}")


def cma() -> Any:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # cma warns that it cannot plot without matplotlib
            import cma
    except ImportError:
        raise Error(
            "the search by CMA-ES needs the package cma, which is not installed: "
            "run `frobc extras install search`, or use the random method, which takes more runs"
        ) from None
    return cma
