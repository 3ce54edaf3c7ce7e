"""Looks for a run in which an assertion of a program does not hold."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence

from . import columns, library, ranges, search, simulated, tools
from .errors import InputError
from .judging import FAR, Claim, Subject

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Drive:
    """What makes a run in the simulator, beside the parameters."""

    world: str
    """The path of the world file."""
    seed: int
    disturbances: Dict[str, float]
    text: str
    """The world file with them."""


@dataclass(frozen=True)
class Counterexample:
    """A run in which an assertion was violated."""

    label: str
    time: float
    """When it was violated first, in seconds."""
    margin: float
    """How far it was from holding; 0 where nothing can be said."""
    runs: int
    """How many runs it took to find it."""
    params: Dict[str, Any]
    settings: Dict[str, str]
    """The parameters as texts with their units, for `--param`."""
    inputs: "Dict[str, NDArray[Any]]"
    """The columns of the run, `time` first, as `Program.run` takes them. Of a run in the
    simulator there is nothing but `time`."""
    drive: Optional[Drive] = None
    """Of a run in the simulator."""

    def write(self, file: tools.PathLike) -> None:
        """As a trace that `frobc trace --input` takes."""
        with open(file, "w", newline="") as out:
            writer = csv.writer(out, lineterminator="\n")
            writer.writerow(self.inputs)
            for row in zip(*(column.tolist() for column in self.inputs.values())):
                writer.writerow([f"{row[0]:.9f}", *(_cell(value) for value in row[1:])])


def _cell(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else repr(value)


@dataclass(frozen=True)
class Search:
    """What became of the search for one assertion."""

    label: str
    found: Optional[Counterexample]
    runs: int
    nearest: float
    """The least margin of all runs: how nearly it was violated."""
    has_margin: bool
    """If not, nothing was compared, and the search was blind."""


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
) -> List[Search]:
    """Looks for runs in which the program's assertions do not hold, one assertion after the other.

    `params` and `inputs` are ranges by name, as `(low, high)` or as a text `"2[1/m] to 8[1/m]"`;
    of an input, which is a column as in a trace, also one value. An input has `points` values in
    the run, each kept to the next (`shape` is `"constant"`) or with straight lines between them
    (`"linear"`). The search is guided by how nearly the assertion held; `only` names some of
    them, `runs` is the most for each. What is found is found again with the same `seed`.
    With `check_rate` only what is violated with so many instants a second too has been found.

    A program that drives a robot does so in the simulator: in `world`, or the one that
    `frobc run` takes. Varied are parameters, `seeds` of the noise (`"1 to 100"`) and
    `disturbances`, numbers of the world file, as `{"sonar.noise": (0, 0.05)}`. There it is an
    assertion too that the robot touches nothing.
    """
    _check("duration", duration, 1e-3, 1e6)
    _check("rate", rate, 0.1, 1e6)
    if check_rate is not None:
        _check("check_rate", check_rate, 0.1, 1e6)
    _check("points", points, 1, 10000)
    _check("runs", runs, 1, 10**9)
    if shape not in search.SHAPES:
        raise InputError(f'shape: expected "constant" or "linear", found {shape!r}')
    if method not in search.METHODS:
        raise InputError(f'method: expected "cma" or "random", found {method!r}')
    search.need_numpy()
    if method == "cma":
        search.cma()
    path = tools.existing(file, "program")
    robot = simulated.robot_for(path, world) if robot is None else robot
    code = library.build(path, entry, robot, sources, asserts="margin")
    if code.robot:
        if inputs or check_rate is not None:
            raise InputError(
                f"{code.name} drives a robot, so its inputs come from the simulator: vary "
                "parameters, disturbances and seeds instead of inputs; and check_rate is for others"
            )
        beside = simulated.disturbances(disturbances or {})
        place = simulated.world_of(path, world, [one.name for one in beside])
        subject: Subject = simulated.Simulated(code, place, duration, rate)
        beside += simulated.seeds(seeds)
        varied, signals = ranges.of_params(code, params or {}), ranges.Inputs([], {})
    else:
        if world is not None or disturbances or seeds is not None:
            raise InputError(
                f"{code.name} is a program for no robot, so it has no world: vary parameters and "
                "inputs (`reactimateRobot` makes a program for a robot)"
            )
        subject, beside = Subject(code, duration, rate), []
        varied, signals = ranges.of_program(code, params or {}, inputs or {})
    chosen = subject.chosen(only)
    space = search.Space([*varied, *beside], signals.varied, int(points), shape)
    if space.size == 0:
        raise InputError(
            "nothing is varied: give a range to a parameter, a disturbance or the seeds"
            if code.robot
            else "nothing is varied: give a range to a parameter or to an input"
        )
    finer = None if check_rate is None else Subject(code, duration, check_rate)
    looking = Looking(subject, finer, space, signals.fixed)
    return [looking.searched(claim, int(runs), seed, method) for claim in chosen]


def _check(name: str, value: Any, least: float, most: float) -> None:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise InputError(f"{name}: expected a number, found {value!r}")
    if not least <= value <= most:
        raise InputError(f"{name}: expected a number from {least:g} to {most:g}, found {value:g}")


def _setting(value: Any) -> str:
    return repr(value)


@dataclass(frozen=True)
class Looking:
    """What is looked at: the program, once more with a finer step, and what is varied."""

    subject: Subject
    finer: Optional[Subject]
    space: search.Space
    fixed: Dict[str, Any]

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

    def _drive(self, values: Dict[str, Any]) -> Optional[Drive]:
        if not isinstance(self.subject, simulated.Simulated):
            return None
        world = self.subject.world
        disturbances = {name: float(values[name]) for name in world.varied}
        seed = self.subject.seed_of(values)
        return Drive(world.path, seed, disturbances, world.text(disturbances))
