"""A compiled program. You can run it step by step, or for many instants at once."""

from __future__ import annotations

import ctypes
import threading
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, overload

from . import columns, library, shapes, times, tools
from .errors import InputError

if TYPE_CHECKING:
    import pandas as pd
    from numpy.typing import NDArray

CHUNK = 1 << 24
"""Maximum number of instants per call to C, because the C function counts in 32 bits and cannot be
interrupted.
"""


class Program:
    """A program and its state; `frob.compile` returns one."""

    def __init__(self, code: library.Library, params: Mapping[str, Any]) -> None:
        self._code = code
        self._lock = threading.RLock()
        self._state = code.new_state()
        self._input = ctypes.create_string_buffer(code.table.input_size + 1)
        self._output = ctypes.create_string_buffer(code.table.output_size + 1)
        self._params = code.params_with(params)
        self._values = {name: p.default for name, p in code.params.items()}
        self._note(params)
        code.table.reset(self._state, self._params)
        self._has_stepped = False

    def _note(self, params: Mapping[str, Any]) -> None:
        self._values.update(
            {name: self._code.params[name].value(value) for name, value in params.items()}
        )

    def __repr__(self) -> str:
        return f"<frob program {self.name}>"

    def __reduce__(self) -> Any:
        raise TypeError("a compiled program cannot be sent to another process: compile it there")

    @property
    def name(self) -> str:
        return self._code.name

    @property
    def robot(self) -> str:
        """The robot that the program drives; empty for a plain signal function."""
        return self._code.robot

    @property
    def params(self) -> "Dict[str, library.Number]":
        """The values of the parameters, in their units."""
        return dict(self._values)

    @property
    def units(self) -> Dict[str, str]:
        """The units of the parameters."""
        return {name: p.unit for name, p in self._code.params.items()}

    @property
    def inputs(self) -> List[str]:
        """The names of the input columns, as in a trace."""
        return [name for name, _ in self._code.input_columns]

    @property
    def outputs(self) -> List[str]:
        """The names of the output columns."""
        return [name for name, _ in self._code.output_columns]

    def reset(self, params: Optional[Mapping[str, Any]] = None) -> None:
        """Resets the state. Parameters that are not given keep their values."""
        with self._lock:
            changed = library.settings(params, "params")
            values: Dict[str, Any] = dict(self._values)
            values.update(changed)
            self._params = self._code.params_with(values)
            self._note(changed)
            self._code.table.reset(self._state, self._params)
            self._has_stepped = False

    def copy(self) -> "Program":
        """Returns an independent copy in the same state."""
        with self._lock:
            other = Program(self._code, self._values)
            ctypes.memmove(other._state, self._state, self._code.table.state_size)
            other._has_stepped = self._has_stepped
            return other

    def __copy__(self) -> "Program":
        return self.copy()

    def __deepcopy__(self, memo: Any) -> "Program":
        return self.copy()

    def step(self, dt: float, inputs: Any) -> Any:
        """Runs one instant, `dt` seconds after the previous one. `dt` is ignored in the first
        instant.
        """
        seconds = columns.step(dt, "dt")
        code = self._code
        with self._lock:
            code.input.write(self._input, 0, inputs, "in")
            dt_ns = times.of_dt(seconds) if self._has_stepped else 0
            self._has_stepped = True
            step = code.table.step
            step(self._state, self._params, dt_ns, dt_ns / 1e9, self._input, self._output)
            return code.output.read(self._output, 0)

    @overload
    def run(
        self,
        inputs: "NDArray[Any]",
        *,
        dt: Any = None,
        time: Any = None,
        out: "Optional[NDArray[Any]]" = None,
    ) -> "NDArray[Any]": ...

    @overload
    def run(self, inputs: List[Any], *, dt: Any = None, time: Any = None) -> List[Any]: ...

    @overload
    def run(
        self, inputs: "Mapping[str, Any]", *, dt: Any = None, time: Any = None
    ) -> "Dict[str, NDArray[Any]]": ...

    @overload
    def run(
        self, inputs: "pd.DataFrame", *, dt: Any = None, time: Any = None
    ) -> "pd.DataFrame": ...

    def run(self, inputs: Any, *, dt: Any = None, time: Any = None, out: Any = None) -> Any:
        """Runs many instants from the initial state, without changing the state that `step` uses.

        The type of `inputs` determines the type of the result:

        - an array with one column for each input: an array
        - a mapping of columns, named as in a trace: a dict of arrays
        - a DataFrame: a DataFrame
        - a list of values, each as for `step`: a list

        `dt` is the duration of a step in seconds: a single number for all steps, or one for each
        step. Alternatively, `time` contains the time of each instant in seconds; the default is the
        inputs' column `time`, if there is one. If `inputs` is an array, `out` may be an array that
        receives the outputs."""
        if out is not None and (isinstance(inputs, list) or not hasattr(inputs, "dtype")):
            raise InputError("out: this is only supported if the inputs are an array")
        if isinstance(inputs, list):
            return self._run_list(inputs, dt, time)
        np = columns.numpy()
        if isinstance(inputs, np.ndarray):
            return self._run_array(inputs, dt, time, out)
        return self._run_columns(inputs, dt, time)

    def _run_list(self, inputs: List[Any], dt: Any, time: Any) -> List[Any]:
        fresh = Program(self._code, self._values)
        seconds = _listed_steps(len(inputs), dt, time)
        return [fresh.step(one, value) for one, value in zip(seconds, inputs)]

    def _run_array(
        self, inputs: "NDArray[Any]", dt: Any, time: Any, out: "Optional[NDArray[Any]]"
    ) -> "NDArray[Any]":
        np = columns.numpy()
        code = self._code
        leaves = columns.numbers(code.input_columns, self.name)
        outs = columns.numbers(code.output_columns, self.name)
        wanted = f"expected an array of {len(leaves)} columns ({', '.join(self.inputs)})"
        columns.unmasked("the array", inputs)
        table = inputs.reshape(-1, 1) if inputs.ndim == 1 else inputs
        if table.ndim != 2 or table.shape[1] != len(leaves):
            raise InputError(f"{wanted}, found the shape {inputs.shape}")
        count = len(table)
        dt_ns = _array_steps(count, dt, time)
        size = code.table.input_size
        if shapes.only_floats(code.input_columns, size) and table.dtype.kind in "iuf":
            memory = np.require(table, np.float64, ["C", "A"])
        else:
            memory = np.zeros(count * size, dtype=np.uint8)
            given = {name: _truths(leaf, table[:, k]) for k, (name, leaf) in enumerate(leaves)}
            columns.write(memory, size, leaves, given, count)
        are_floats = shapes.only_floats(code.output_columns, code.table.output_size)
        if out is not None:
            shape = (count,) if len(outs) == 1 else (count, len(outs))
            if not (are_floats and _takes(out, shape, apart_from=(memory,))):
                raise InputError(
                    f"out: expected a writable float64 array of shape {shape} in row-major order "
                    "that shares no memory with the inputs; all outputs of the program must be "
                    "Float"
                )
            self._steps(count, dt_ns, memory, out)
            return out
        output = self._steps(count, dt_ns, memory)
        if are_floats:
            result = output.view(np.float64)
            return result if len(outs) == 1 else result.reshape(count, len(outs))  # type: ignore
        parts = columns.read(output, code.table.output_size, outs, count)
        stacked = [parts[name].astype(np.float64) for name, _ in outs]
        return stacked[0] if len(outs) == 1 else np.column_stack(stacked)

    def _run_columns(self, inputs: Any, dt: Any, time: Any) -> Any:
        np = columns.numpy()
        code = self._code
        if not isinstance(inputs, Mapping) and not hasattr(inputs, "columns"):
            raise InputError(
                f"expected an array, a mapping of columns, a DataFrame or a list, found "
                f"{shapes.shown(inputs)}"
            )
        names = list(inputs.keys())
        columns.check(code.input_columns, names, self.name)
        if time is None and dt is None and "time" in names:
            time = inputs["time"]
        lengths = {n: columns.length(n, inputs[n]) for n, _ in code.input_columns if n in names}
        of_time = 0 if time is None else columns.length("time", time)
        some = next(iter(lengths.items()), ("time", of_time))
        for name, length in lengths.items():
            if length != some[1]:
                raise InputError(f"`{name}` has {length} rows, but `{some[0]}` has {some[1]}")
        count = some[1]
        dt_ns = _array_steps(count, dt, time)
        size = code.table.input_size
        memory = np.zeros(count * size, dtype=np.uint8)
        columns.write(memory, size, code.input_columns, inputs, count)
        output = self._steps(count, dt_ns, memory)
        parts = columns.read(output, code.table.output_size, code.output_columns, count)
        if isinstance(inputs, Mapping):
            return parts
        framed = {"time": inputs["time"]} if "time" in names else {}
        return type(inputs)({**framed, **parts}, index=inputs.index)

    def _steps(self, count: int, dt_ns: Any, memory: Any, output: Any = None) -> Any:
        """Runs the program and returns the outputs as bytes. All arrays must be contiguous and have
        `count` elements. Exception: `dt_ns` may be shorter if all its elements except the first are
        equal; those elements are then reused."""
        np = columns.numpy()
        code = self._code
        steps, has_params = code.steps()
        state = code.new_state()
        with self._lock:
            params = self._params
        if output is None:
            output = np.empty(count * code.table.output_size, dtype=np.uint8)
        code.table.reset(state, params)
        seconds = dt_ns / 1e9
        arrays = (dt_ns, seconds, memory, output)
        places = [array.ctypes.data for array in arrays]
        sizes = [8, seconds.itemsize, code.table.input_size, code.table.output_size]
        is_shared = len(dt_ns) < count
        chunk = len(dt_ns) - 1 if is_shared else CHUNK
        for first in range(0, count, chunk):
            row = [min(first, 1) if is_shared else first] * 2 + [first] * 2
            at = [place + k * size for place, k, size in zip(places, row, sizes)]
            some = min(chunk, count - first)
            steps(state, *([params] if has_params else []), some, *at)
        return output


def _takes(out: Any, shape: Any, apart_from: Sequence[Any]) -> bool:
    """Returns whether C can write outputs of this shape to `out` while it reads the arrays in
    `apart_from`."""
    np = columns.numpy()
    is_such = isinstance(out, np.ndarray) and out.dtype == np.float64 and out.shape == shape
    if not is_such or any(np.may_share_memory(out, array) for array in apart_from):
        return False
    return bool(out.flags.c_contiguous and out.flags.aligned and out.flags.writeable)


def _truths(leaf: shapes.Scalar, column: "NDArray[Any]") -> "NDArray[Any]":
    """Converts 0 and 1 in an array of numbers to booleans."""
    if not isinstance(leaf, shapes.Bool) or column.dtype.kind not in "iuf":
        return column
    if not bool(((column == 0) | (column == 1)).all()):
        row = int((~((column == 0) | (column == 1))).argmax())
        raise InputError(f"row {row}: expected 0 or 1 for a truth value, found {column[row]}")
    return column != 0  # type: ignore[no-any-return]


def _array_steps(count: int, dt: Any, time: Any) -> "NDArray[Any]":
    _one_of(dt, time)
    if time is None:
        return columns.steps(dt, count)
    dt_ns = columns.dt_of_time(time)
    if len(dt_ns) != count:
        raise InputError(f"time has {len(dt_ns)} rows, but the input has {count}")
    return dt_ns


def _listed_steps(count: int, dt: Any, time: Any) -> Sequence[float]:
    _one_of(dt, time)
    if time is None and isinstance(dt, (int, float)):
        return [columns.step(dt, "dt")] * count
    what = "dt" if time is None else "time"
    given = columns.listed(what, dt if time is None else time)
    if len(given) != count:
        raise InputError(f"{what} has {len(given)} rows, but the input has {count}")
    if time is None:
        return given
    return columns.listed_dt_of_time(given)


def _one_of(dt: Any, time: Any) -> None:
    if (dt is None) == (time is None):
        raise InputError(
            "give the time between instants, `dt`, in seconds, or the `time` of each instant"
            + ("" if dt is None else ", not both")
        )


def compile(
    file: tools.PathLike,
    *,
    entry: str = "main",
    robot: Optional[tools.PathLike] = None,
    params: Optional[Mapping[str, Any]] = None,
    sources: Sequence[tools.PathLike] = (),
) -> Program:
    """Compiles a program. `params` are the values of its parameters, in their units; `sources` are
    C files whose functions it calls; `robot` selects the robot if the program does not."""
    return Program(library.build(file, entry, robot, sources), library.settings(params, "params"))
