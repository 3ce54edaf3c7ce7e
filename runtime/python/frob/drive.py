"""Runs a robot program in the simulator, one instant at a time. The caller can override some of the
program's inputs and outputs."""

from __future__ import annotations

import ctypes
import math
import os
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from . import library, shapes, tools
from .errors import Error, InputError
from .simulator import Simulator, Truth, robot_of, world_path


def number_of(leaf: shapes.Leaf) -> Optional[shapes.Scalar]:
    """Returns the scalar type of a column that is a number, a boolean, or an event that carries
    one; None for other columns."""
    if isinstance(leaf, shapes.Sum) and leaf.is_optional:
        (inner,) = leaf.constructors[1].parts
        return inner if isinstance(inner, shapes.Scalar) else None
    return leaf if isinstance(leaf, shapes.Scalar) else None


class Drive:
    """A program in the simulator. Call `start`, then `step` for each instant."""

    def __init__(
        self,
        file: tools.PathLike,
        *,
        world: Optional[tools.PathLike],
        robot: Optional[tools.PathLike],
        entry: str,
        sources: Sequence[tools.PathLike],
        rate: float,
        picture: bool,
        lasts: float = math.inf,
    ) -> None:
        path = tools.existing(file, "program")
        self._world = world_path(path, world)
        if robot is None:
            robot = robot_of(self._world) or None
        self.code = library.build(path, entry, robot, sources)
        if not self.code.robot:
            raise Error(
                f"{self.code.name} is not a robot program; use `reactimateRobot` to make one"
            )
        self._rate = rate
        self._lasts = lasts
        self._picture = picture
        self._sim: Optional[Simulator] = None
        self._input = ctypes.create_string_buffer(self.code.table.input_size + 1)
        self._output = ctypes.create_string_buffer(self.code.table.output_size + 1)
        self._columns: Dict[str, Tuple[shapes.Leaf, Any]] = {}
        for leaves, memory in (
            (self.code.input_columns, self._input),
            (self.code.output_columns, self._output),
        ):
            for name, leaf in leaves:
                if number_of(leaf) is not None:
                    self._columns[name] = leaf, memory

    def numbers(self, names: Sequence[str]) -> List[shapes.Scalar]:
        """Returns the scalar types of the named columns. Each column must be a number, a boolean,
        or an event that carries one."""
        for name in names:
            if name not in self._columns:
                known = ", ".join(self._columns)
                raise InputError(
                    f"{self.code.name} has no numeric column `{name}`; it has: {known}"
                )
        found = [number_of(self._columns[name][0]) for name in names]
        return [leaf for leaf in found if leaf is not None]

    def start(self, seed: int, params: Mapping[str, Any]) -> None:
        """Starts a new simulation, resets the program, and reads the sensors at time 0."""
        self.close()
        self._params = self.code.params_with(params)
        self._state = self.code.new_state()
        self.code.table.reset(self._state, self._params)
        body = self.code.part(f"frob_{self.code.robot}_body")
        self._sim = Simulator(self._world, self.code.robot, seed, body, self._picture)
        table = self.code.table
        taken, given = self._sim.sizes()
        if table.input_size < taken or table.output_size < given:
            raise Error(f"{self.code.name} was compiled by another version of frobc")
        ctypes.memset(self._input, 0, table.input_size)
        ctypes.memset(self._output, 0, table.output_size)
        for name, leaf in self.code.input_columns:
            if leaf.may_be_left_out():
                leaf.write(self._input, 0, leaf.default, name)
        self._instant, self._stepped_ns = 0, None
        self._arrive()

    def _running(self) -> Simulator:
        if self._sim is None:
            raise Error("the simulation has not been started, or is closed: reset it first")
        return self._sim

    def step(self, inputs: Mapping[str, Any], outputs: Mapping[str, Any]) -> None:
        """Runs one instant of the program; `inputs` and `outputs` override the program's own
        values. Then advances the world to the program's next instant and reads the sensors. The
        program has no instants during an outage of the world, so its next instant is after the
        outage."""
        sim = self._running()
        now = self._time_ns(self._instant)
        self._put(inputs)
        dt_ns = 0 if self._stepped_ns is None else now - self._stepped_ns
        self._stepped_ns = now
        step = self.code.table.step
        step(self._state, self._params, dt_ns, dt_ns / 1e9, self._input, self._output)
        self._put(outputs)
        sim.command(now, self._output)
        self._instant += 1
        self._arrive()

    def _arrive(self) -> None:
        """Advances the world to the program's next instant, or to the end of the run."""
        sim = self._running()
        while not sim.read(self._time_ns(self._instant), self._input) and self.time < self._lasts:
            self._instant += 1

    def _put(self, values: Mapping[str, Any]) -> None:
        for name, value in values.items():
            leaf, memory = self._columns[name]
            leaf.write(memory, 0, value, name)

    def _time_ns(self, instant: int) -> int:
        return round(instant * 1e9 / self._rate)

    @property
    def time(self) -> float:
        return self._time_ns(self._instant) / 1e9

    def values(self, names: Sequence[str]) -> List[Any]:
        """Returns the current values of the columns; None for an event that does not occur."""
        pairs = (self._columns[name] for name in names)
        return [leaf.read(memory, 0) for leaf, memory in pairs]

    def truth(self) -> Truth:
        return self._running().truth()

    def draw(self, path: str) -> None:
        self._running().draw(path)

    def close(self) -> None:
        if self._sim is not None:
            self._sim.close()
            self._sim = None
