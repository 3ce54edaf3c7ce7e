"""The simulator in this process: the C interface of sim.h."""

from __future__ import annotations

import ctypes as c
import os
import threading
from typing import Any, NamedTuple, Optional

from . import tools
from .errors import Error

ROOM = 8192
"""Bytes for what is wrong with a world."""


class Settings(c.Structure):
    _fields_ = [
        ("robot", c.c_char_p),
        ("seed", c.c_uint64),
        ("wall_distance_m", c.c_double),
        ("picture", c.c_int),
        ("body", c.c_void_p),
    ]


class Place(c.Structure):
    _fields_ = [
        ("x_m", c.c_double),
        ("y_m", c.c_double),
        ("heading_rad", c.c_double),
        ("touches", c.c_int),
    ]


class Truth(NamedTuple):
    """Where the robot really is, in the world."""

    x: float
    y: float
    heading: float
    touches: bool
    clearance: float
    """From the robot's middle to the nearest wall, polygon or post, in metres."""


_loaded: Optional[c.CDLL] = None


def loaded() -> c.CDLL:
    """The shared object of the simulator, beside the hosts of frobc."""
    global _loaded
    if _loaded is None:
        path = os.path.join(tools.prefix(), "lib", "frobc", "libfrob-simulator.so")
        try:
            _loaded = _declared(c.CDLL(path))
        except OSError as error:
            raise Error(f"the simulator cannot be loaded: {error}; install frobc again") from None
    return _loaded


def _declared(lib: c.CDLL) -> c.CDLL:
    sim, memory, time = c.c_void_p, c.c_void_p, c.c_int64
    for name, result, arguments in [
        ("open", sim, [c.c_char_p, c.POINTER(Settings), c.c_char_p, c.c_size_t]),
        ("close", None, [sim]),
        ("input_size", c.c_size_t, [sim]),
        ("output_size", c.c_size_t, [sim]),
        ("world_robot", c.c_char_p, [c.c_char_p, c.c_char_p, c.c_size_t]),
        ("robots", c.c_size_t, [sim]),
        ("advance", None, [sim, time]),
        ("read", None, [sim, memory]),
        ("command", None, [sim, time, memory]),
        ("place_robot", Place, [sim, c.c_size_t]),
        ("clearance_robot", c.c_double, [sim, c.c_size_t]),
        ("picture", c.c_int, [sim, c.c_char_p, c.c_char_p, c.c_size_t]),
    ]:
        function: Any = getattr(lib, "frob_sim_" + name)
        function.restype = result
        function.argtypes = arguments
    return lib


def default_world(program: str) -> str:
    """As for `frobc run`: beside the program, or the room that comes with frobc."""
    beside = os.path.join(os.path.dirname(program), "world.toml")
    room = os.path.join(tools.prefix(), "share", "frobc", "worlds", "room.toml")
    return beside if os.path.isfile(beside) else room


def robot_of(world: str) -> str:
    """The robot that a world names; empty if it leaves it open."""
    message = c.create_string_buffer(ROOM)
    name = loaded().frob_sim_world_robot(os.fsencode(world), message, ROOM)
    if name is None:
        raise Error(message.value.decode("utf-8", "replace"))
    return str(name.decode())


class Simulator:
    """A world with a robot in it. Threads that use one take turns."""

    def __init__(self, world: str, robot: str, seed: int, body: Any, picture: bool) -> None:
        self._lock = threading.Lock()
        self._lib = loaded()
        message = c.create_string_buffer(ROOM)
        settings = Settings(robot.encode(), seed, 0.0, int(picture), body)
        self._sim = self._lib.frob_sim_open(os.fsencode(world), c.byref(settings), message, ROOM)
        if not self._sim:
            raise Error(message.value.decode("utf-8", "replace"))
        if self._lib.frob_sim_robots(self._sim) != 1:
            self.close()
            raise Error(f"{world} has several robots: an environment is for one")

    def _open(self) -> Any:
        if not self._sim:
            raise Error("the simulation is closed")
        return self._sim

    def sizes(self) -> "tuple[int, int]":
        """Of the robot's input and output structs."""
        with self._lock:
            sim = self._open()
            return self._lib.frob_sim_input_size(sim), self._lib.frob_sim_output_size(sim)

    def read(self, time_ns: int, memory: Any) -> None:
        """Runs the physics up to this time, which must not go back, and reads the sensors."""
        with self._lock:
            sim = self._open()
            self._lib.frob_sim_advance(sim, time_ns)
            self._lib.frob_sim_read(sim, memory)

    def command(self, time_ns: int, memory: Any) -> None:
        with self._lock:
            self._lib.frob_sim_command(self._open(), time_ns, memory)

    def truth(self) -> Truth:
        with self._lock:
            sim = self._open()
            p = self._lib.frob_sim_place_robot(sim, 0)
            clearance = self._lib.frob_sim_clearance_robot(sim, 0)
        return Truth(p.x_m, p.y_m, p.heading_rad, bool(p.touches), clearance)

    def draw(self, path: str) -> None:
        message = c.create_string_buffer(ROOM)
        with self._lock:
            done = self._lib.frob_sim_picture(self._open(), os.fsencode(path), message, ROOM)
        if not done:
            raise Error(message.value.decode("utf-8", "replace"))

    def close(self) -> None:
        with self._lock:
            sim, self._sim = self._sim, None
            if sim:
                self._lib.frob_sim_close(sim)

    def __del__(self) -> None:
        if getattr(self, "_sim", None):
            self.close()
