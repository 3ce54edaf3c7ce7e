"""The types of a program's values: their layout in C structs, and their form in Python."""

from __future__ import annotations

import ctypes
import operator
import struct
from typing import Any, Iterator, List, Mapping, Sequence, Tuple, Union

from . import cells, table
from .data import Data, is_missing
from .errors import Error, InputError

Buffer = Any  # writable memory: a ctypes array, a memoryview


def shown(value: Any) -> str:
    """Formats a value for a message, shortened to 60 characters."""
    whole = repr(value)
    return whole if len(whole) <= 60 else whole[:57] + "..."


def wrong(place: str, expected: str, value: Any) -> InputError:
    return InputError(f"{place}: expected {expected}, found {shown(value)}")


def is_truth(value: Any) -> bool:
    return isinstance(value, bool) or type(value).__name__ in ("bool_", "bool")


REQUIRED = object()
TAG = struct.Struct("=B")


class Shape:
    """A type. `read` reads a value from a struct, and `write` writes one to a struct."""

    meaning: str
    """Description for messages, such as `a number`."""

    default: Any = REQUIRED
    """The default of an input that may be omitted, such as the initial value of a control on the
    operator's console.
    """

    def may_be_left_out(self) -> bool:
        return self.default is not REQUIRED

    def read(self, memory: Buffer, base: int) -> Any:
        raise NotImplementedError

    def write(self, memory: Buffer, base: int, value: Any, place: str) -> None:
        raise NotImplementedError


class Scalar(Shape):
    """A number or a boolean."""

    def __init__(self, meaning: str, code: str, numpy_name: str, offset: int) -> None:
        self.meaning = meaning
        self.packed = struct.Struct("=" + code)
        self.numpy_name = numpy_name
        self.offset = offset

    def read(self, memory: Buffer, base: int) -> Any:
        return self.packed.unpack_from(memory, base + self.offset)[0]

    def write(self, memory: Buffer, base: int, value: Any, place: str) -> None:
        if isinstance(value, str):
            value = from_text(self, value, place)
        self.packed.pack_into(memory, base + self.offset, self.converted(value, place))

    def converted(self, value: Any, place: str) -> Any:
        raise NotImplementedError


class Bool(Scalar):
    def __init__(self, offset: int) -> None:
        super().__init__("True or False", "?", "bool", offset)

    def converted(self, value: Any, place: str) -> bool:
        if not is_truth(value):
            raise wrong(place, self.meaning, value)
        return bool(value)


class Int(Scalar):
    def __init__(self, offset: int) -> None:
        super().__init__("a whole number from -2147483648 to 2147483647", "i", "int32", offset)

    def converted(self, value: Any, place: str) -> int:
        if is_truth(value):
            raise wrong(place, self.meaning, value)
        try:
            whole = operator.index(value)
        except (TypeError, ValueError, ArithmeticError):
            raise wrong(place, self.meaning, value) from None
        if not -(2**31) <= whole < 2**31:
            raise wrong(place, self.meaning, value)
        return whole


class Float(Scalar):
    def __init__(self, code: str, numpy_name: str, offset: int) -> None:
        super().__init__("a number", code, numpy_name, offset)

    def converted(self, value: Any, place: str) -> float:
        try:
            return number(value)
        except (TypeError, ValueError, ArithmeticError):
            raise wrong(place, self.meaning, value) from None


def number(value: Any) -> float:
    """Converts a number to a float. Raises TypeError, ValueError or ArithmeticError for anything
    else: booleans, strings, arrays, and integers beyond the largest float."""
    is_other = isinstance(value, (str, bytes, complex)) or getattr(value, "ndim", 0) != 0
    is_other = is_other or type(value).__name__ in ("complex64", "MaskedConstant")
    if is_other or is_truth(value) or not hasattr(value, "__float__"):
        raise TypeError
    return float(operator.index(value)) if isinstance(value, int) else float(value)


class Parts(Shape):
    """A product type: a tuple, a record, or an array."""

    def __init__(self, name: str, is_array: bool, labels: Sequence[str], parts: Sequence[Shape]):
        self.name = name
        self.is_array = is_array
        self.labels = labels  # field names of a record; empty for other types
        self.parts = parts
        kind = f"a list of {len(parts)}" if is_array else f"a tuple of {len(parts)}"
        fields = ", ".join(labels)
        self.meaning = f"`{name}`, or a mapping with {fields}" if labels else name or kind

    def may_be_left_out(self) -> bool:
        return bool(self.labels) and all(part.may_be_left_out() for part in self.parts)

    def read(self, memory: Buffer, base: int) -> Any:
        values = [part.read(memory, base) for part in self.parts]
        if self.is_array:
            return values
        if self.labels:
            return Data(self.name, **dict(zip(self.labels, values)))
        return Data(self.name, *values) if self.name else tuple(values)

    def write(self, memory: Buffer, base: int, value: Any, place: str) -> None:
        if isinstance(value, str):
            value = from_text(self, value, place)
        if self.labels:
            self._write_fields(memory, base, value, place)
            return
        if isinstance(value, Data) and value.constructor == self.name:
            value = value.args
        elif self.name and len(self.parts) == 1:
            value = (value,)
        values = self._listed(value, place)
        for number, (part, one) in enumerate(zip(self.parts, values)):
            inner = f"{place}[{number}]" if self.is_array else f"{place}.{number + 1}"
            part.write(memory, base, one, inner)

    def _listed(self, value: Any, place: str) -> Sequence[Any]:
        if isinstance(value, (str, bytes, Mapping)) or not hasattr(value, "__len__"):
            raise wrong(place, self.meaning, value)
        try:
            values = list(value)
        except TypeError:
            raise wrong(place, self.meaning, value) from None
        if len(values) != len(self.parts):
            found = f"{len(values)}: {shown(value)}"
            raise InputError(f"{place}: expected {self.meaning}, found {found}")
        return values

    def _write_fields(self, memory: Buffer, base: int, value: Any, place: str) -> None:
        fields = value.fields if isinstance(value, Data) else value
        if not isinstance(fields, Mapping) or (
            isinstance(value, Data) and value.constructor != self.name
        ):
            raise wrong(place, self.meaning, value)
        for label, part in zip(self.labels, self.parts):
            if label in fields:
                part.write(memory, base, fields[label], f"{place}.{label}")
            elif part.may_be_left_out():
                left_out = {} if isinstance(part, Parts) else part.default
                part.write(memory, base, left_out, f"{place}.{label}")
            else:
                raise InputError(f"{place}: the field `{label}` is missing")
        for label in fields:
            if label not in self.labels:
                raise InputError(
                    f"{place}: there is no field `{label}`; the fields are {', '.join(self.labels)}"
                )


class Sum(Shape):
    """A sum type: a tag, and slots for the arguments of its constructors."""

    def __init__(self, offset: int, is_event: bool, constructors: Sequence[Parts]) -> None:
        self.offset = offset
        self.is_event = is_event
        self.constructors = constructors
        self.numbers = {c.name: number for number, c in enumerate(constructors)}
        names = [c.name for c in constructors]
        self.is_optional = is_event or names == ["Nothing", "Just"]
        self.is_enumeration = all(not c.parts for c in constructors)
        if self.is_optional:
            inner = constructors[1].parts[0]
            self.meaning = f"{inner.meaning}, or None"
            self.wraps = isinstance(inner, Sum) and inner.is_optional
        else:
            self.meaning = " or ".join(f"`{name}`" for name in names)

    def read(self, memory: Buffer, base: int) -> Any:
        (tag,) = TAG.unpack_from(memory, base + self.offset)
        constructor = self.constructors[min(tag, len(self.constructors) - 1)]
        if self.is_enumeration:
            return constructor.name
        if self.is_optional and tag == 0:
            return None
        values = [part.read(memory, base) for part in constructor.parts]
        if self.is_optional and not self.wraps and not is_missing(values[0]):
            return values[0]
        return (
            Data(constructor.name, **dict(zip(constructor.labels, values)))
            if (constructor.labels)
            else Data(constructor.name, *values)
        )

    def write(self, memory: Buffer, base: int, value: Any, place: str) -> None:
        if isinstance(value, str) and (self.is_event or value not in self.numbers):
            value = from_text(self, value, place)
        if isinstance(value, str):
            value = Data(value)
        if self.is_optional:
            value = self._told(value)
        if not isinstance(value, Data) or value.constructor not in self.numbers:
            raise wrong(place, self.meaning, value)
        number = self.numbers[value.constructor]
        constructor = self.constructors[number]
        clear(self, memory, base)
        TAG.pack_into(memory, base + self.offset, number)
        if constructor.labels:
            constructor.write(memory, base, value, place)
        elif len(value.args) != len(constructor.parts):
            count = len(constructor.parts)
            raise InputError(
                f"{place}: expected `{constructor.name}` with {count} "
                f"argument{'' if count == 1 else 's'}, found {shown(value)}"
            )
        for part, one in zip(constructor.parts, () if constructor.labels else value.args):
            part.write(memory, base, one, place)

    def _told(self, value: Any) -> Any:
        """Wraps an optional value in its constructor."""
        empty, full = self.constructors[0].name, self.constructors[1].name
        if isinstance(value, Data) and value.constructor in (empty, full):
            return value
        return Data(empty) if is_missing(value) else Data(full, value)


def clear(shape: Shape, memory: Buffer, base: int) -> None:
    """Sets every slot to zero, so that no old values remain in slots that the new constructor does
    not use.
    """
    if isinstance(shape, Scalar):
        shape.packed.pack_into(memory, base + shape.offset, 0)
    elif isinstance(shape, Sum):
        TAG.pack_into(memory, base + shape.offset, 0)
        for constructor in shape.constructors:
            for part in constructor.parts:
                clear(part, memory, base)
    elif isinstance(shape, Parts):
        for part in shape.parts:
            clear(part, memory, base)


def from_text(shape: Shape, text: str, place: str) -> Any:
    """Parses a value. The text of an event omits the constructor `Event`."""
    if text.strip() == "" and isinstance(shape, Sum) and shape.is_event:
        return None
    if isinstance(shape, Sum) and text.strip() in shape.numbers and not shape.is_event:
        return Data(text.strip())
    try:
        value = cells.value(text)
    except cells.CellError as error:
        text = text if len(text) <= 60 else text[:57] + "..."
        raise InputError(f"{place}: expected {shape.meaning}, found `{text}`: {error}") from None
    if isinstance(shape, Sum) and shape.is_event:
        return Data(shape.constructors[1].name, value)
    return value


Defaults = Mapping[int, Any]
"""For each value that may be omitted, maps the address of its `table.Value` to its default."""


def of_value(value: table.Value, defaults: Defaults) -> Shape:
    """The shape that a table describes."""
    shape = _of_kind(value, defaults)
    shape.default = defaults.get(ctypes.addressof(value), REQUIRED)
    return shape


def _of_kind(value: table.Value, defaults: Defaults) -> Shape:
    kind, offset = value.kind, value.offset
    if kind == table.BOOL:
        return Bool(offset)
    if kind == table.INT:
        return Int(offset)
    if kind in (table.FLOAT, table.ROUNDED):
        return Float("d", "float64", offset)
    if kind == table.SINGLE:
        return Float("f", "float32", offset)
    if kind == table.IMAGE:
        raise Error("the program uses camera images: run it with `frobc trace` or `frob.simulate`")
    constructors = [_parts(value.constructors[i], kind, defaults) for i in range(value.count)]
    if kind == table.SUM:
        return Sum(offset, bool(value.is_event), constructors)
    return constructors[0]


def _parts(constructor: table.Constructor, kind: int, defaults: Defaults) -> Parts:
    name = constructor.name.decode() if constructor.name else ""
    fields = [constructor.fields[i] for i in range(constructor.count)]
    labels = [f.name.decode() for f in fields] if constructor.is_record else []
    parts = [of_value(f.value[0], defaults) for f in fields]
    return Parts(name, kind == table.ARRAY, labels, parts)


Leaf = Union[Scalar, Sum, Parts]


def columns(shape: Shape, root: str) -> Iterator[Tuple[str, Leaf]]:
    """Yields the columns of a trace for a value of this shape, with their names (frob/trace.h)."""
    assert isinstance(shape, (Scalar, Sum, Parts))
    if not isinstance(shape, Parts) or not (shape.is_array or not shape.name or shape.labels):
        yield root, shape
        return
    for number, part in enumerate(shape.parts):
        if shape.is_array:
            name = f"{root}[{number}]"
        elif shape.labels:
            name = f"{root}.{shape.labels[number]}"
        else:
            name = f"{root}.{number + 1}"
        yield from columns(part, name)


def only_floats(leaves: List[Tuple[str, Leaf]], size: int) -> bool:
    """Returns whether the struct is an array of doubles, one for each column."""
    return size == 8 * len(leaves) and all(
        isinstance(leaf, Float) and leaf.numpy_name == "float64" and leaf.offset == 8 * number
        for number, (_, leaf) in enumerate(leaves)
    )
