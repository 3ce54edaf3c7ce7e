"""Finds `frobc`, and runs it."""

from __future__ import annotations

import os
import shutil
import subprocess
import warnings
from pathlib import Path
from typing import Sequence, Union

from .errors import CompileError, Error, FrobWarning

PathLike = Union[str, "os.PathLike[str]"]

REJECTED = 1
"""The exit status of frobc for a program that is wrong."""

INSTALLED = Path(__file__).parent / "tools"
"""Where a wheel carries frobc and its hosts, laid out as `make install` does."""


def frobc() -> str:
    """Its path: that of FROBC if it is set, else the wheel's own, else that on PATH."""
    named = os.environ.get("FROBC")
    found = named or str(INSTALLED / "bin" / "frobc")
    if not named and not os.access(found, os.X_OK):
        found = shutil.which("frobc") or ""
    if not found or not os.access(found, os.X_OK):
        place = f"FROBC names {named}, which cannot be run" if named else "frobc is not on PATH"
        raise Error(f"{place}: install frobc, or set FROBC to where it is")
    return os.path.abspath(found)


def prefix() -> str:
    """The folder with lib/frobc and share/frobc: FROB_HOME, or that of frobc."""
    named = os.environ.get("FROB_HOME")
    found = frobc()
    folders = [os.path.dirname(os.path.dirname(path)) for path in (found, os.path.realpath(found))]
    for folder in ([named] if named else []) + folders:
        if os.path.isdir(os.path.join(folder, "lib", "frobc")):
            return folder
    raise Error(f"lib/frobc is not beside {found}: install frobc, or set FROB_HOME to where it is")


def run(arguments: Sequence[str]) -> str:
    """What frobc writes to standard output; its messages are an exception, or a warning."""
    command = [frobc(), *arguments]
    try:
        done = subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL)
    except OSError as error:
        raise Error(f"{command[0]} cannot be run: {error.strerror}") from None
    told = done.stderr.decode("utf-8", "replace").rstrip("\n")
    if done.returncode == REJECTED:
        raise CompileError(told)
    if done.returncode != 0:
        raise Error(told or f"frobc ended with status {done.returncode}")
    if told:
        warnings.warn(told, FrobWarning, stacklevel=4)
    return done.stdout.decode("utf-8", "replace")


def existing(path: PathLike, what: str) -> str:
    """The path as text, of a file that is there."""
    text = os.fspath(path)
    if not os.path.isfile(text):
        raise Error(f"there is no {what} {text}")
    if text.startswith("-"):
        text = os.path.join(".", text)
    return text
