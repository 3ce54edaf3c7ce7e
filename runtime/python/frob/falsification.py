"""Searches for runs that violate an assertion of a program."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional, Sequence

from . import columns, library, ranges, search, shapes, simulated, tools
from .errors import InputError
from .judging import FAR, Claim, Subject

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Drive:
    """The settings of a run in the simulator, apart from the parameters."""

    world: str
    """The path of the world file."""
    seed: int
    disturbances: Dict[str, float]
    text: str
    """The content of the world file, with these disturbances applied."""


@dataclass(frozen=True)
class Counterexample:
    """A run that violates an assertion."""

    label: str
    time: float
    """The time of the first violation, in seconds."""
    margin: float
    """The margin of the violation; 0 if unknown."""
    runs: int
    """The number of runs that it took to find this violation."""
    params: Dict[str, Any]
    settings: Dict[str, str]
    """The parameters as strings with units, for `--param`."""
    inputs: "Dict[str, NDArray[Any]]"
    """The columns of the run, `time` first, in the form that `Program.run` accepts. A run in the
    simulator has only the column `time`."""
    drive: Optional[Drive] = None
    """The settings of the run if it was in the simulator; otherwise None."""
    collision: str = ""
    """If the violation is a collision: its object, time, place and clearance, as `frobc run` prints
    them. Otherwise empty."""

    def write(self, file: tools.PathLike) -> None:
        """Writes the inputs as a trace for `frobc trace --input`."""
        with open(file, "w", newline="") as out:
            writer = csv.writer(out, lineterminator="\n")
            writer.writerow(self.inputs)
            for row in zip(*(column.tolist() for column in self.inputs.values())):
                writer.writerow([f"{row[0]:.9f}", *(_cell(value) for value in row[1:])])


def _cell(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else repr(value)


@dataclass(frozen=True)
class Search:
    """The result of the search for one assertion."""

    label: str
    found: Optional[Counterexample]
    runs: int
    nearest: float
    """The smallest margin of all runs: how close the search came to a violation."""
    has_margin: bool
    """If False, the assertion has no margin, so nothing guided the search."""


def falsify(
    file: tools.PathLike,
    *,
    params: Optional[Mapping[str, Any]] = None,
    inputs: Optional[Mapping[str, Any]] = None,
    disturbances: Optional[Mapping[str, Any]] = None,
    seeds: Any = None,
    world: Optional[tools.PathLike] = None,
    duration: float = 60.0,
    rate: float = 50.0,
    points: int = 10,
    shape: str = "constant",
    only: Sequence[str] = (),
    runs: int = 1000,
    seed: int = 1,
    method: str = "cma",
    check_rate: Optional[float] = None,
    entry: str = "main",
    robot: Optional[tools.PathLike] = None,
    sources: Sequence[tools.PathLike] = (),
    progress: Optional[Callable[[str, int, int], None]] = None,
    ended: Optional[Callable[[Search], None]] = None,
) -> List[Search]:
    """Searches for runs that violate the program's assertions, one assertion after another.

    `params` and `inputs` map names to ranges, either `(low, high)` or a string such as `"2[1/m] to
    8[1/m]"`. Inputs have the same names as in a trace, and may also have a fixed value. Each
    input has `points` values during the run; it keeps each value until the next
    (`shape="constant"`) or changes linearly between them (`shape="linear"`). The margin of the
    assertion guides the search. `only` selects assertions by label, and `runs` is the maximum
    number of runs for each. Searches with the same `seed` are identical. If `check_rate` is given,
    a violation counts only if it also occurs when the program runs at that rate, in instants per
    second.

    A program that drives a robot runs in the simulator, in `world` or, by default, in the world
    that `frobc run` uses. The search varies parameters, `seeds` of the noise (`"1 to 100"`), and
    `disturbances`, which are numbers of the world file, such as `{"sonar.noise": (0, 0.05)}`. There
    is one additional assertion: the robot touches nothing.

    After each run, `progress` is called with the assertion's label, the number of its runs so far,
    and the maximum number of runs. `ended` is called with the result of each search as soon as the
    search is complete.
    """
    _check("duration", duration, 1e-3, 1e6)
    _check("rate", rate, 0.1, 1e6)
    if check_rate is not None:
        _check("check_rate", check_rate, 0.1, 1e6)
    _check("points", points, 1, 10000)
    _check("runs", runs, 1, 10**9)
    params, inputs = library.settings(params, "params"), library.settings(inputs, "inputs")
    beside = library.settings(disturbances, "disturbances")
    only = tools.words(only, "only")
    if isinstance(seed, bool) or not isinstance(seed, int):
        raise InputError(f"seed: expected a whole number, found {shapes.shown(seed)}")
    if not isinstance(shape, str) or shape not in search.SHAPES:
        raise InputError(f'shape: expected "constant" or "linear", found {shape!r}')
    if not isinstance(method, str) or method not in search.METHODS:
        raise InputError(f'method: expected "cma" or "random", found {method!r}')
    search.need_packages(method)
    path = tools.existing(file, "program")
    robot = simulated.robot_for(path, world) if robot is None else robot
    code = library.build(path, entry, robot, sources, asserts="margin")
    if code.robot:
        if inputs or check_rate is not None:
            raise InputError(
                f"{code.name} drives a robot, so its inputs come from the simulator: vary "
                "parameters, disturbances or seeds instead of inputs, and remove check_rate"
            )
        shaken = simulated.disturbances(beside)
        place = simulated.world_of(path, world, [one.name for one in shaken])
        subject: Subject = simulated.Simulated(code, place, duration, rate)
        shaken += simulated.seeds(seeds)
        varied, signals = ranges.of_params(code, params), ranges.Inputs([], {})
    else:
        if world is not None or beside or seeds is not None:
            raise InputError(
                f"{code.name} is not a robot program, so it has no world: vary only parameters and "
                "inputs, or use `reactimateRobot` to make a robot program"
            )
        subject, shaken = Subject(code, duration, rate), []
        varied, signals = ranges.of_program(code, params, inputs)
    chosen = subject.chosen(only)
    space = search.Space([*varied, *shaken], signals.varied, int(points), shape)
    if space.size == 0:
        raise InputError(
            "nothing is varied: give a range to a parameter, a disturbance or the seeds"
            if code.robot
            else "nothing is varied: give a range to a parameter or to an input"
        )
    finer = None if check_rate is None else Subject(code, duration, check_rate)
    looking = Looking(subject, finer, space, signals.fixed, progress)
    searches = []
    for claim in chosen:
        searches.append(looking.searched(claim, int(runs), seed, method))
        if ended is not None:
            ended(searches[-1])
    return searches


def _check(name: str, value: Any, least: float, most: float) -> None:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise InputError(f"{name}: expected a number, found {shapes.shown(value)}")
    if not least <= value <= most:
        found = f"{value:g}" if isinstance(value, float) else shapes.shown(value)
        raise InputError(f"{name}: expected a number from {least:g} to {most:g}, found {found}")


def _setting(value: Any) -> str:
    return repr(value)


@dataclass(frozen=True)
class Looking:
    """The program under test, a copy of it that runs at the check rate, and the values to vary."""

    subject: Subject
    finer: Optional[Subject]
    space: search.Space
    fixed: Dict[str, Any]
    progress: Optional[Callable[[str, int, int], None]]

    def searched(self, claim: Claim, runs: int, seed: int, method: str) -> Search:
        found: List[Counterexample] = []
        nearest: List[float] = []

        def objective(point: Sequence[float]) -> float:
            params = self.space.params_at(point)
            inputs = self._inputs(self.subject, point)
            value, failed = self.subject.judged(claim, params, inputs)
            if failed is not None and self.finer is not None:
                again, finer = self.finer.judged(claim, params, self._inputs(self.finer, point))
                if finer is None:
                    value, failed = again, None
            nearest.append(value)
            if self.progress is not None:
                self.progress(claim.label, len(nearest), runs)
            if failed is None:
                return max(value, 0.0)
            found.append(
                Counterexample(
                    label=claim.label,
                    time=float(self.subject.time[failed]),
                    margin=value if abs(value) < FAR else 0.0,
                    runs=len(nearest),
                    params=self.subject.params_of(params),
                    settings=self._settings(params),
                    inputs={"time": self.subject.time, **inputs},
                    drive=self._drive(params),
                    collision=self._collision(claim),
                )
            )
            return -1.0

        search.Search(self.space, objective, runs, seed).run(method)
        has_margin = claim.margin is not None or claim is simulated.TOUCHES
        return Search(
            claim.label, found[0] if found else None, len(nearest), min(nearest), has_margin
        )

    def _inputs(self, subject: Subject, point: Sequence[float]) -> "Dict[str, NDArray[Any]]":
        np = columns.numpy()
        fixed = {name: np.full(len(subject.time), value) for name, value in self.fixed.items()}
        return {**fixed, **self.space.inputs_at(point, subject.time, subject.duration)}

    def _settings(self, params: Dict[str, Any]) -> Dict[str, str]:
        units = {name: param.unit for name, param in self.subject.code.params.items()}
        return {
            name: _setting(value) + (f"[{units[name]}]" if units[name] not in ("", "1") else "")
            for name, value in self.subject.params_of(params).items()
        }

    def _collision(self, claim: Claim) -> str:
        if not isinstance(self.subject, simulated.Simulated) or claim is not simulated.TOUCHES:
            return ""
        return self.subject.collision

    def _drive(self, values: Dict[str, Any]) -> Optional[Drive]:
        if not isinstance(self.subject, simulated.Simulated):
            return None
        world = self.subject.world
        disturbances = {name: float(values[name]) for name in world.varied}
        seed = self.subject.seed_of(values)
        return Drive(world.path, seed, disturbances, world.text(disturbances))
