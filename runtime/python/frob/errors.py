"""The exceptions of this package. Each message says where the problem is, what caused it, and what
to do."""

from __future__ import annotations

import re

_CONTROLS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")


def printable(text: str) -> str:
    """Escapes control characters, so that the text can be printed on a terminal: ESC becomes
    \\027."""
    return _CONTROLS.sub(lambda found: f"\\{ord(found.group()):03d}", text)


class Error(Exception):
    """Base class of this package's errors. For compiler errors, the text is the compiler's own."""

    def __str__(self) -> str:
        return printable(super().__str__())


class CompileError(Error):
    """Raised when the compiler rejects the program. The text contains all messages of `frobc`."""


class InputError(Error, ValueError):
    """Raised when an argument or an input of a program is invalid."""


class FrobWarning(UserWarning):
    """A warning from `frobc`."""
