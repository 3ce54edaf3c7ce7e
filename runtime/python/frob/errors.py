"""What can go wrong, as exceptions: each says where, why, and what to do."""

from __future__ import annotations


class Error(Exception):
    """Any error of this package; the text is the compiler's own where it comes from there."""


class CompileError(Error):
    """The program was rejected: the text is what `frobc` writes, message by message."""


class InputError(Error, ValueError):
    """What a program was given is not what it takes."""


class FrobWarning(UserWarning):
    """What `frobc` warns of."""
