"""The simulator as a Gymnasium environment. The agent acts either as a controller, which sets a
program's outputs, or as an operator, who sets inputs such as knobs."""

from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

from . import shapes, table, tools
from .drive import Drive, number_of
from .errors import Error, InputError
from .simulation import Picture
from .simulator import Truth

try:
    import gymnasium
    import numpy as np
    from numpy.typing import NDArray
except ImportError as error:
    raise Error(
        f"frob.gym needs gymnasium and numpy: {error}; run `pip install gymnasium`"
    ) from None

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Moment:
    """The instant after an action, as passed to `reward` and `done`."""

    time: float
    """Seconds since the start."""
    values: Dict[str, float]
    """The observed columns."""
    action: Dict[str, float]
    truth: Truth
    before: Truth
    """The true state at the previous instant."""


class RobotEnv(gymnasium.Env[Floats, Floats]):
    """A program in the simulator, with some of its columns controlled by an agent.

    `action` names the columns that the agent sets: outputs (`out.turn`) or inputs
    (`in.console.speed`); the default is all outputs. `observation` names the columns that it
    observes; the default is all numeric inputs. The observation of an event is the value of its
    last occurrence, or the upper limit before the first one. The program always runs, and
    determines every column that the agent does not set.

    `reward` takes a `Moment`. `done` takes a `Moment` and returns whether the episode has ended. By
    default, an episode ends at a collision. After `duration` seconds the episode is truncated.
    During an outage of the world (`[outage]`) the program has no instants, so a step can take as
    long as the outage. `limits` maps columns to their lowest and highest values."""

    metadata: Dict[str, Any] = {"render_modes": []}

    def __init__(
        self,
        file: tools.PathLike,
        *,
        reward: Callable[[Moment], float],
        action: Optional[Sequence[str]] = None,
        observation: Optional[Sequence[str]] = None,
        done: Optional[Callable[[Moment], bool]] = None,
        duration: float = 60.0,
        rate: float = 50.0,
        limits: Optional[Mapping[str, Tuple[float, float]]] = None,
        params: Optional[Mapping[str, Any]] = None,
        world: Optional[tools.PathLike] = None,
        robot: Optional[tools.PathLike] = None,
        entry: str = "main",
        sources: Sequence[tools.PathLike] = (),
        picture: bool = False,
    ) -> None:
        if not 0.1 <= rate <= 10000:
            raise InputError(f"rate: expected steps per second from 0.1 to 10000, found {rate}")
        if not duration > 0:
            raise InputError(f"duration: expected seconds, found {duration}")
        self._drive = Drive(
            file,
            world=world,
            robot=robot,
            entry=entry,
            sources=sources,
            rate=rate,
            picture=picture,
            lasts=duration,
        )
        self._reward, self._done, self._duration = reward, done, duration
        self._params = dict(params or {})
        code = self._drive.code
        code.params_with(self._params)
        self._action = list(_numbers(code.output_columns) if action is None else action)
        # Omits keys typed on the console: they are integers, but not sensor readings.
        inputs = (
            name
            for name, leaf in code.input_columns
            if name not in self._action and _is_sensed(leaf)
        )
        self._observation = list(inputs if observation is None else observation)
        for name in limits or {}:
            if name not in self._action + self._observation:
                raise InputError(f"limits: `{name}` is in neither `action` nor `observation`")
        self._picture = picture
        ranges = {**_ranges(code), **(limits or {})}
        self.action_space: Any = self._space(self._action, ranges)
        self.observation_space: Any = self._space(self._observation, limits or {})

    def _space(self, names: Sequence[str], ranges: Mapping[str, Tuple[float, float]]) -> Any:
        leaves = self._drive.numbers(names)
        if not names or len(set(names)) != len(names):
            raise InputError(
                "`action` and `observation` must each name at least one column, without duplicates"
            )
        bounds = [ranges.get(n, _natural(leaf)) for n, leaf in zip(names, leaves)]
        low, high = (np.array([b[k] for b in bounds], dtype=np.float64) for k in (0, 1))
        if not bool(np.all(low <= high)):
            raise InputError(f"limits: the minimum is greater than the maximum in {list(names)}")
        return gymnasium.spaces.Box(low, high, dtype=np.float64)

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> "tuple[Floats, dict[str, Any]]":
        """Starts a new episode. `seed` has the same meaning as in `frobc run`; without it, each
        episode gets a different seed. `options` may contain `params`, which apply from this episode
        on."""
        super().reset(seed=seed)
        self._params.update((options or {}).get("params", {}))
        number = int(self.np_random.integers(2**31)) if seed is None else seed
        self._drive.start(number, self._params)
        self._last: List[float] = self.observation_space.high.tolist()
        self._truth = self._drive.truth()
        return self._seen(), self._info()

    def step(self, action: Floats) -> "tuple[Floats, float, bool, bool, dict[str, Any]]":
        """Runs one instant. Values beyond the limits are clipped; NaN is an error."""
        chosen = self._chosen(action)
        of_input = {n: v for n, v in chosen.items() if n.startswith("in")}
        of_output = {n: v for n, v in chosen.items() if n.startswith("out")}
        self._drive.step(of_input, of_output)
        before, self._truth = self._truth, self._drive.truth()
        seen = self._seen()
        moment = Moment(
            self._drive.time,
            dict(zip(self._observation, seen.tolist())),
            {name: float(value) for name, value in chosen.items()},
            self._truth,
            before,
        )
        done = self._truth.touches if self._done is None else bool(self._done(moment))
        cut = self._drive.time >= self._duration
        return seen, float(self._reward(moment)), done, cut, self._info()

    def _chosen(self, action: Floats) -> Dict[str, Any]:
        given = np.asarray(action, dtype=np.float64)
        shape = self.action_space.shape
        if given.shape != shape or bool(np.any(np.isnan(given))):
            names = ", ".join(self._action)
            raise InputError(
                f"expected an action of shape {shape} ({names}) without NaN, found {action!r}"
            )
        space = self.action_space
        bounded = np.clip(given, space.low, space.high).tolist()
        leaves = self._drive.numbers(self._action)
        return {n: _as(leaf, x) for n, leaf, x in zip(self._action, leaves, bounded)}

    def _seen(self) -> Floats:
        seen = np.array(self._held(), dtype=np.float64)
        space = self.observation_space
        return np.clip(seen, space.low, space.high)

    def _held(self) -> List[float]:
        values = self._drive.values(self._observation)
        held = [old if new is None else new for old, new in zip(self._last, values)]
        self._last = held
        return held

    def _info(self) -> Dict[str, Any]:
        return {"time": self._drive.time, "truth": self._truth}

    def picture(self) -> Picture:
        """Draws the world and the path so far as an SVG; requires `picture=True`."""
        if not self._picture:
            raise Error("no path was recorded: create the environment with `picture=True`")
        with tempfile.TemporaryDirectory(prefix="frob-") as folder:
            path = os.path.join(folder, "run.svg")
            self._drive.draw(path)
            with open(path, encoding="utf-8") as file:
                return Picture(file.read())

    def close(self) -> None:
        self._drive.close()


def _numbers(leaves: Sequence[Tuple[str, shapes.Leaf]]) -> List[str]:
    return [name for name, leaf in leaves if isinstance(leaf, shapes.Scalar)]


def _is_sensed(leaf: shapes.Leaf) -> bool:
    return isinstance(leaf, shapes.Scalar) or isinstance(number_of(leaf), shapes.Float)


def _natural(leaf: shapes.Scalar) -> Tuple[float, float]:
    if isinstance(leaf, shapes.Bool):
        return 0.0, 1.0
    if isinstance(leaf, shapes.Int):
        return float(-(2**31)), float(2**31 - 1)
    return -np.inf, np.inf


def _as(leaf: shapes.Scalar, value: float) -> Any:
    """Converts a float to the column's type: for an Int, the nearest integer; for a Bool, whether
    it is at least 0.5.
    """
    if isinstance(leaf, shapes.Bool):
        return value >= 0.5
    return round(value) if isinstance(leaf, shapes.Int) else value


def _ranges(code: Any) -> Dict[str, Tuple[float, float]]:
    """Returns the limits that the program declares for the knobs of its console."""
    found: Dict[str, Tuple[float, float]] = {}
    places = {leaf.offset: name for name, leaf in code.input_columns if hasattr(leaf, "offset")}
    for control in (code.table.console[i] for i in range(code.table.control_count)):
        if control.kind == table.KNOB:
            found[places[control.value[0].offset]] = control.least, control.most
    return found
