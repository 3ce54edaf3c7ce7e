"""Runs the simulator in this process, through the C interface in sim.h."""

from __future__ import annotations

import ctypes as c
import os
import threading
from typing import Any, NamedTuple, Optional

from . import tools
from .errors import Error

ROOM = 8192
"""Size of the buffer for messages about a world."""


class Settings(c.Structure):
    _fields_ = [
        ("robot", c.c_char_p),
        ("seed", c.c_uint64),
        ("wall_distance_m", c.c_double),
        ("picture", c.c_int),
        ("body", c.c_void_p),
        ("served", c.c_int),
    ]


class Place(c.Structure):
    _fields_ = [
        ("x_m", c.c_double),
        ("y_m", c.c_double),
        ("heading_rad", c.c_double),
        ("touches", c.c_int),
    ]


class Collision(c.Structure):
    _fields_ = [
        ("time_s", c.c_double),
        ("x_m", c.c_double),
        ("y_m", c.c_double),
        ("clearance_m", c.c_double),
        ("with_", c.c_char_p),
    ]


class Truth(NamedTuple):
    """The robot's true state in the world."""

    x: float
    y: float
    heading: float
    touches: bool
    clearance: float
    """Distance from the robot's centre to the nearest wall, polygon, post or cone, in metres."""


_loaded: Optional[c.CDLL] = None


def loaded() -> c.CDLL:
    """Loads the simulator's shared object, which is installed with the hosts of frobc."""
    global _loaded
    if _loaded is None:
        path = os.path.join(tools.prefix(), "lib", "frobc", "libfrob-simulator.so")
        try:
            _loaded = _declared(c.CDLL(path))
        except OSError as error:
            raise Error(f"the simulator cannot be loaded: {error}; reinstall frobc") from None
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
        ("is_away", c.c_int, [sim, time]),
        ("place_robot", Place, [sim, c.c_size_t]),
        ("clearance_robot", c.c_double, [sim, c.c_size_t]),
        ("collision_robot", c.c_int, [sim, c.c_size_t, c.c_size_t, c.POINTER(Collision)]),
        ("describe_collision", None, [c.POINTER(Collision), c.c_char_p, c.c_size_t]),
        ("picture", c.c_int, [sim, c.c_char_p, c.c_char_p, c.c_size_t]),
    ]:
        function: Any = getattr(lib, "frob_sim_" + name)
        function.restype = result
        function.argtypes = arguments
    return lib


def world_path(program: str, world: Optional[tools.PathLike]) -> str:
    """Finds the world in the same way as `frobc run`. If a world is given, searches for it in the
    current folder, in the program's folder, and among those installed with frobc. Otherwise uses
    `world.toml` in the program's folder or, if there is none, the default room."""
    folder = os.path.dirname(program)
    own = os.path.join(tools.prefix(), "share", "frobc", "worlds")
    beside = os.path.join(folder, "world.toml")
    if world is None:
        return beside if os.path.isfile(beside) else os.path.join(own, "room.toml")
    name = tools.path_text(world, "world")
    for path in (name, os.path.join(folder, name), os.path.join(own, name)):
        if os.path.exists(path):
            try:
                with open(path, "rb"):
                    return tools.existing(path, "world")
            except OSError as error:
                raise Error(f"cannot read the world {path}: {error.strerror}") from None
    raise Error(
        f"there is no world {name} here or next to {program} or among the worlds that come "
        f"with frobc: {', '.join(sorted(os.listdir(own)))}"
    )


def robot_of(world: str) -> str:
    """Returns the robot that a world names; empty if it names none."""
    message = c.create_string_buffer(ROOM)
    name = loaded().frob_sim_world_robot(os.fsencode(world), message, ROOM)
    if name is None:
        raise Error(message.value.decode("utf-8", "replace"))
    return str(name.decode())


class Simulator:
    """A world with a robot in it. Threads that share a world take turns."""

    def __init__(self, world: str, robot: str, seed: int, body: Any, picture: bool) -> None:
        self._lock = threading.Lock()
        self._lib = loaded()
        message = c.create_string_buffer(ROOM)
        settings = Settings(robot.encode(), seed, 0.0, int(picture), body, 0)
        self._sim = self._lib.frob_sim_open(os.fsencode(world), c.byref(settings), message, ROOM)
        if not self._sim:
            raise Error(message.value.decode("utf-8", "replace"))
        if self._lib.frob_sim_robots(self._sim) != 1:
            self.close()
            raise Error(f"{world} has several robots, but an environment supports only one")
        self._rest = c.create_string_buffer(self._lib.frob_sim_output_size(self._sim) + 1)
        self._rests = False

    def _open(self) -> Any:
        if not self._sim:
            raise Error("the simulation is closed")
        return self._sim

    def sizes(self) -> "tuple[int, int]":
        """Returns the sizes of the robot's input and output structs."""
        with self._lock:
            sim = self._open()
            return self._lib.frob_sim_input_size(sim), self._lib.frob_sim_output_size(sim)

    def read(self, time_ns: int, memory: Any) -> bool:
        """Runs the physics up to this time, which must not decrease between calls, and reads the
        sensors.

        During an outage of the world, commands a stop instead and returns False, because the
        program has no instants then."""
        with self._lock:
            sim = self._open()
            self._lib.frob_sim_advance(sim, time_ns)
            if self._lib.frob_sim_is_away(sim, time_ns):
                self._rests = True
                self._lib.frob_sim_command(sim, time_ns, self._rest)
                return False
            self._lib.frob_sim_read(sim, memory)
            return True

    def command(self, time_ns: int, memory: Any) -> None:
        """Commands the robot. The first command after an outage is replaced by a stop."""
        with self._lock:
            given = self._rest if self._rests else memory
            self._lib.frob_sim_command(self._open(), time_ns, given)
            self._rests = False

    def first_collision(self) -> str:
        """Describes the first collision in one line: object, time, place and clearance. Empty if
        there was none."""
        collision = Collision()
        text = c.create_string_buffer(ROOM)
        with self._lock:
            sim = self._open()
            if not self._lib.frob_sim_collision_robot(sim, 0, 0, c.byref(collision)):
                return ""
            self._lib.frob_sim_describe_collision(c.byref(collision), text, ROOM)
        return text.value.decode("utf-8", "replace")

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
