"""A program that drives a robot in the simulator, instant by instant, and what is put in the
place of some of its inputs and outputs."""

from __future__ import annotations

import ctypes
import os
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from . import library, shapes, tools
from .errors import Error, InputError
from .simulator import Simulator, Truth, default_world, robot_of


def number_of(leaf: shapes.Leaf) -> Optional[shapes.Scalar]:
    """Of a column that is a number or a truth value, or an event of one."""
    if isinstance(leaf, shapes.Sum) and leaf.is_optional:
        (inner,) = leaf.constructors[1].parts
        return inner if isinstance(inner, shapes.Scalar) else None
    return leaf if isinstance(leaf, shapes.Scalar) else None


class Drive:
    """`start`, then `step` at each instant."""

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
    ) -> None:
        path = tools.existing(file, "program")
        self._world = default_world(path) if world is None else tools.existing(world, "world")
        if robot is None:
            robot = robot_of(self._world) or None
        self.code = library.build(path, entry, robot, sources)
        if not self.code.robot:
            raise Error(f"{self.code.name} is a program for no robot; `reactimateRobot` makes one")
        self._rate = rate
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
        """Of the columns of these names, each a number, a truth value, or an event of one."""
        for name in names:
            if name not in self._columns:
                known = ", ".join(self._columns)
                raise InputError(f"{self.code.name} has no number `{name}`; it has: {known}")
        found = [number_of(self._columns[name][0]) for name in names]
        return [leaf for leaf in found if leaf is not None]

    def start(self, seed: int, params: Mapping[str, Any]) -> None:
        """A world anew, and the program: the robot has read its sensors at time 0."""
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
        self._instant = 0
        self._running().read(0, self._input)

    def _running(self) -> Simulator:
        if self._sim is None:
            raise Error("the simulation has not been started, or is closed: reset it first")
        return self._sim

    def step(self, inputs: Mapping[str, Any], outputs: Mapping[str, Any]) -> None:
        """The program's instant, with these values in the place of its own; then the world goes
        on, and at the next instant the sensors are read."""
        sim = self._running()
        now, before = self._time_ns(self._instant), self._time_ns(self._instant - 1)
        self._put(inputs)
        dt = 0.0 if self._instant == 0 else (now - before) / 1e9
        self.code.table.step(self._state, self._params, dt, self._input, self._output)
        self._put(outputs)
        sim.command(now, self._output)
        self._instant += 1
        sim.read(self._time_ns(self._instant), self._input)

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
        """What they are now; of an event that does not occur None."""
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
