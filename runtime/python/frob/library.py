"""Loads a compiled program and reads its description."""

from __future__ import annotations

import ctypes
import os
import tempfile
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import shapes, table, tools
from .errors import Error, InputError

Number = Union[bool, int, float]


@dataclass(frozen=True)
class Param:
    """A parameter of a program."""

    name: str
    unit: str
    """The unit without brackets, such as `1/m`."""
    default: Number
    shape: shapes.Scalar

    def value(self, given: Any) -> Any:
        """Converts a number in the parameter's unit, or a string with a unit such as `4[1/m]`."""
        place = f"param {self.name}"
        if isinstance(given, str) and given.endswith("]") and "[" in given:
            text, unit = given[:-1].split("[", 1)
            if unit != self.unit:
                raise InputError(f"{place}: its unit is [{self.unit}], not [{unit}]")
            given = text.strip()
        if isinstance(given, str):
            given = shapes.from_text(self.shape, given, place)
        return self.shape.converted(given, place)


class Library:
    """The code of a program, which stays loaded until the process ends."""

    def __init__(self, path: str) -> None:
        try:
            self._object = ctypes.CDLL(path)
            found = table.Program.in_dll(self._object, table.SYMBOL)
        except (OSError, ValueError) as error:
            raise Error(f"{path} is not a compiled program: {error}") from None
        if found.abi != table.ABI:
            raise Error(
                f"{path} was compiled by another version of frobc: update frobc or the package frob"
            )
        if found.arithmetic() != 0:
            raise Error(
                f"{path} cannot be run: a library in this process has changed how the processor "
                "rounds numbers or flushes them to zero: use a process without that library"
            )
        self.table = found
        self.name: str = found.name.decode()
        self.robot: str = found.robot.decode()
        defaults = _console(found)
        self.input = shapes.of_value(found.input[0], defaults)
        self.output = shapes.of_value(found.output[0], {})
        self.input_columns = list(shapes.columns(self.input, "in"))
        self.output_columns = list(shapes.columns(self.output, "out"))
        self.params = _params(found)

    def part(self, name: str) -> Optional[int]:
        """Returns the address of a user-defined symbol in the object, or None if there is no such
        symbol.
        """
        try:
            return ctypes.addressof(ctypes.c_char.in_dll(self._object, name))
        except ValueError:
            return None

    def margins(self, count: int) -> List[Optional[str]]:
        """Returns the margin formula of each of the first `count` assertions; None for an assertion
        that has no formula.
        """
        try:
            texts = (ctypes.c_char_p * count).in_dll(self._object, "frob_margins")
        except ValueError:
            return [None] * count
        return [text.decode() if text is not None else None for text in texts]

    def steps(self) -> Tuple[Any, bool]:
        """Returns the C function that runs many steps, and whether it takes parameters."""
        name = self.name + "_steps"
        try:
            function = getattr(self._object, name)
        except AttributeError:
            text = f"{self.name} already defines `{name}`: rename that definition"
            raise Error(text) from None
        has_params = bool(self.table.default_params)
        params = [ctypes.c_void_p] if has_params else []
        memory = ctypes.c_void_p
        function.argtypes = [memory, *params, ctypes.c_int32, *[memory] * 4]
        function.restype = None
        return function, has_params

    def params_with(self, given: Mapping[str, Any]) -> Any:
        """Creates the parameter struct with the given values."""
        size = self.table.params_size
        memory = ctypes.create_string_buffer(max(size, 1))
        if size > 0:
            ctypes.memmove(memory, self.table.default_params, size)
        for name, value in settings(given, "params").items():
            param = self.params.get(name)
            if param is None:
                known = ", ".join(self.params) or "none"
                raise InputError(f"{self.name} has no parameter `{name}`; it has: {known}")
            number = param.value(value)
            param.shape.packed.pack_into(memory, param.shape.offset, number)
        return memory

    def new_state(self) -> Any:
        # Adds a byte, because the state may be empty.
        return ctypes.create_string_buffer(self.table.state_size + 1)


def settings(given: Optional[Mapping[str, Any]], what: str) -> Mapping[str, Any]:
    """Checks that an argument is a mapping from names to values. None counts as an empty
    mapping."""
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise InputError(f"{what}: expected a mapping of names, found {shapes.shown(given)}")
    return given


def _console(found: table.Program) -> Dict[int, Any]:
    """Returns the initial values of the operator's console."""
    untouched: Dict[int, Any] = {}
    for control in (found.console[i] for i in range(found.control_count)):
        address = ctypes.addressof(control.value[0])
        if control.kind == table.KNOB:
            untouched[address] = control.first
        elif control.kind in (table.TOGGLE, table.HOLD):
            untouched[address] = control.first > 0.0 and control.kind == table.TOGGLE
        else:
            untouched[address] = None
    return untouched


def _params(found: table.Program) -> Dict[str, Param]:
    params: Dict[str, Param] = {}
    for row in (found.params[i] for i in range(found.param_count)):
        shape = shapes.of_value(row.value[0], {})
        assert isinstance(shape, shapes.Scalar)
        memory = ctypes.string_at(found.default_params, found.params_size)
        name = row.name.decode()
        params[name] = Param(name, row.unit.decode(), shape.read(memory, 0), shape)
    return params


def build(
    file: tools.PathLike,
    entry: str,
    robot: Optional[tools.PathLike],
    sources: Sequence[tools.PathLike],
    asserts: str = "off",
) -> Library:
    """Compiles the program with frobc and loads it."""
    path = tools.existing(file, "program")
    options: List[str] = ["--entry", tools.word(entry, "entry"), "--asserts", asserts]
    if robot is not None:
        options += ["--robot", tools.path_text(robot, "robot")]
    for source in tools.paths(sources, "sources"):
        options += ["--with", tools.existing(source, "C file")]
    # Uses a new file name, because the code of a loaded file must not change.
    with tempfile.TemporaryDirectory(prefix="frob-") as folder:
        made = os.path.join(folder, "program.so")
        tools.run(["build", "--shared", *options, "-o", made, path])
        return Library(made)
