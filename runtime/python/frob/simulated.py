"""Runs a program in the simulator, where it drives a robot, and computes its assertions'
margins.
"""

from __future__ import annotations

import ctypes
import os
import re
import tempfile
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple

from . import columns, library, search, shapes, tools
from .errors import Error, InputError
from .judging import Claim, Subject
from .ranges import between, ends
from .simulator import Simulator, robot_of, world_path

if TYPE_CHECKING:
    from numpy.typing import NDArray

SEED = "--seed"
"""The name of the noise seed among the parameters and disturbances that a search varies."""

TOUCHES = Claim("touches nothing", False, shapes.Bool(0), None, "")
"""The additional assertion for simulated runs. The simulator, not the program, evaluates it."""


class World:
    """A world file in which a search varies some numbers."""

    def __init__(self, path: str, varied: Sequence[str]) -> None:
        self.path = path
        with open(path, encoding="utf-8") as file:
            self._text = file.read()
        self.varied = list(varied)
        if varied and re.search(r"^\s*picture\s*=", self._text, re.MULTILINE):
            raise InputError(
                f"{path} refers to pictures, which cannot be found from a modified copy of "
                "the file: remove the disturbances"
            )

    def text(self, values: Mapping[str, float]) -> str:
        """Returns the file with these values in place of the varied numbers, which are named
        `table.key`.
        """
        text = self._text
        for name in self.varied:
            table, key = name.split(".")
            text = _set(text, table, key, repr(float(values[name])))
        return text


def _set(text: str, table: str, key: str, value: str) -> str:
    lines = text.split("\n")
    heads = [k for k, line in enumerate(lines) if re.match(rf"\s*\[\s*{table}\s*\]", line)]
    if not heads:
        return text.rstrip("\n") + f"\n\n[{table}]\n{key} = {value}\n"
    for k in range(heads[0] + 1, len(lines)):
        if re.match(r"\s*\[", lines[k]):
            break
        if re.match(rf"\s*{key}\s*=", lines[k]):
            lines[k] = f"{key} = {value}"
            return "\n".join(lines)
    lines.insert(heads[0] + 1, f"{key} = {value}")
    return "\n".join(lines)


def disturbances(given: Mapping[str, Any]) -> List[search.Range]:
    """Checks disturbances and converts them to ranges."""
    found = []
    for name, value in given.items():
        place = f"disturbance {name}"
        if not isinstance(name, str) or not re.fullmatch(r"[a-z_]+\.[a-z_]+", name):
            raise InputError(
                f"{place}: expected a table and a key of the world file, such as sonar.noise"
            )
        numbers = [_number(place, end) for end in ends(place, value)]
        if len(numbers) != 2:
            raise InputError(f'{place}: expected a range, such as "0 to 0.1", found {value!r}')
        found.append(between(place, name, "float", *numbers))
    return found


def seeds(given: Any) -> List[search.Range]:
    if given is None:
        return []
    numbers = [_number("seeds", end) for end in ends("seeds", given)]
    if len(numbers) != 2 or not all(x == int(x) and 0 <= x < 2**31 for x in numbers):
        raise InputError(f'seeds: expected whole numbers, such as "1 to 100", found {given!r}')
    return [between("seeds", SEED, "int", int(numbers[0]), int(numbers[1]))]


def _number(place: str, given: Any) -> float:
    try:
        return float(given)
    except (TypeError, ValueError, ArithmeticError):
        raise InputError(f"{place}: expected a number, found {shapes.shown(given)}") from None


class Simulated(Subject):
    """A program under test in the simulator. Each run starts a new world."""

    def __init__(self, code: library.Library, world: World, duration: float, rate: float) -> None:
        super().__init__(code, duration, rate)
        # `time` and `nanoseconds` contain only the instants of the last run, without those during
        # an outage.
        self._all = self.time, self.nanoseconds
        self.world = world
        self._input = ctypes.create_string_buffer(code.table.input_size + 1)

    def assertions(self) -> List[Claim]:
        return [*super().assertions(), TOUCHES]

    def seed_of(self, values: Mapping[str, Any]) -> int:
        return int(values.get(SEED, 1))

    def params_of(self, values: Mapping[str, Any]) -> Dict[str, Any]:
        beside = {SEED, *self.world.varied}
        return {name: value for name, value in values.items() if name not in beside}

    def judged(
        self, claim: Claim, params: Mapping[str, Any], inputs: "Mapping[str, NDArray[Any]]"
    ) -> Tuple[float, Optional[int]]:
        if claim is not TOUCHES:
            return super().judged(claim, params, inputs)
        self._output(params, inputs)
        failed = next((k for k, touches in enumerate(self._touches) if touches), None)
        void = self.void(self._memory)
        value = min(self._clearance[: max(void, 1)])
        if failed is not None and failed < void:
            return 0.0, failed
        return value + self.voided(void), None

    def _output(
        self, params: Mapping[str, Any], inputs: "Mapping[str, NDArray[Any]]"
    ) -> "NDArray[Any]":
        np = columns.numpy()
        table = self.code.table
        time, nanoseconds = self._all
        memory = np.zeros(len(time) * table.output_size, dtype=np.uint8)
        set_params = self.code.params_with(self.params_of(params))
        state = self.code.new_state()
        table.reset(state, set_params)
        self._touches: List[bool] = []
        self._clearance: List[float] = []
        self.collision = ""
        ran: List[int] = []
        stepped = 0
        sim = self._simulator(params)
        try:
            self._blank(sim)
            place, input_ = memory.ctypes.data, self._input
            for k, now in enumerate(nanoseconds.tolist()):
                if not sim.read(now, input_):
                    continue
                truth = sim.truth()
                self._touches.append(truth.touches)
                self._clearance.append(truth.clearance)
                output = place + len(ran) * table.output_size
                dt_ns = now - stepped if ran else 0
                table.step(state, set_params, dt_ns, dt_ns / 1e9, input_, output)
                sim.command(now, output)
                stepped = now
                ran.append(k)
            self.collision = sim.first_collision()
        finally:
            sim.close()
        if not ran:
            raise Error(
                f"the program never runs, because the outage in {self.world.path} covers the "
                "whole run"
            )
        self.time, self.nanoseconds = time[ran], nanoseconds[ran]
        self._memory = memory[: len(ran) * table.output_size]
        return self._memory  # type: ignore[no-any-return]

    def _simulator(self, values: Mapping[str, Any]) -> Simulator:
        world = self.world
        if not world.varied:
            return self._opened(world.path, values)
        with tempfile.TemporaryDirectory(prefix="frob-") as folder:
            path = os.path.join(folder, os.path.basename(world.path))
            with open(path, "w", encoding="utf-8") as file:
                file.write(world.text(values))
            try:
                return self._opened(path, values)
            except Error as error:
                settings = ", ".join(f"{name} = {values[name]:g}" for name in world.varied)
                told = str(error).replace(path, world.path)
                raise Error(f"{told}\n(with {settings})") from None

    def _opened(self, path: str, values: Mapping[str, Any]) -> Simulator:
        body = self.code.part(f"frob_{self.code.robot}_body")
        return Simulator(path, self.code.robot, self.seed_of(values), body, False)

    def _blank(self, sim: Simulator) -> None:
        table = self.code.table
        taken, given = sim.sizes()
        if table.input_size < taken or table.output_size < given:
            raise Error(f"{self.code.name} was compiled by another version of frobc")
        ctypes.memset(self._input, 0, table.input_size)
        for name, leaf in self.code.input_columns:
            if leaf.may_be_left_out():
                leaf.write(self._input, 0, leaf.default, name)


def world_of(program: str, world: Optional[tools.PathLike], varied: Sequence[str]) -> World:
    path = world_path(program, world)
    return World(path, varied)


def robot_for(program: str, world: Optional[tools.PathLike]) -> Optional[str]:
    """Returns the robot that the program's world names, or None."""
    path = world_path(program, world)
    return robot_of(path) or None
