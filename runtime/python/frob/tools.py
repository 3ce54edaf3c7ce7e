"""Finds and runs `frobc`."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import warnings
from pathlib import Path
from typing import List, Sequence, Union

from .errors import CompileError, Error, FrobWarning, InputError

PathLike = Union[str, "os.PathLike[str]"]

REJECTED = 1
"""The exit status of frobc for an invalid program."""

INSTALLED = Path(__file__).parent / "tools"
"""In a wheel, the folder of frobc and its hosts; it has the layout of `make install`."""


BESIDE = Path(__file__).resolve().parents[4]
"""The folder of the installation if this file is in its share/frobc/python/frob."""


def frobc() -> str:
    """Finds frobc: the path in FROBC if it is set, otherwise the one in the wheel or the
    installation that contains this package, otherwise the one on PATH.
    """
    named = os.environ.get("FROBC")
    found = named or str(INSTALLED / "bin" / "frobc")
    if not named and not os.access(found, os.X_OK):
        found = str(BESIDE / "bin" / "frobc")
    if not named and not os.access(found, os.X_OK):
        found = shutil.which("frobc") or ""
    if not found or not os.access(found, os.X_OK):
        place = f"FROBC names {named}, which cannot be run" if named else "frobc is not on PATH"
        raise Error(f"{place}: install frobc, or set FROBC to its path")
    return os.path.abspath(found)


def prefix() -> str:
    """Finds the folder with lib/frobc and share/frobc: FROB_HOME, or the folder where frobc is
    installed.
    """
    named = os.environ.get("FROB_HOME")
    found = frobc()
    folders = [os.path.dirname(os.path.dirname(path)) for path in (found, os.path.realpath(found))]
    for folder in ([named] if named else []) + folders:
        if os.path.isdir(os.path.join(folder, "lib", "frobc")):
            return folder
    raise Error(f"lib/frobc is not next to {found}: install frobc, or set FROB_HOME to its folder")


def run(arguments: Sequence[str]) -> str:
    """Runs frobc and returns its standard output. If frobc fails, raises its messages as an
    exception; otherwise, issues them as a warning.

    frobc and its child processes end when this process ends, for whatever reason."""
    command = [frobc(), *arguments]
    try:
        done = subprocess.run(
            command,
            capture_output=True,
            stdin=subprocess.DEVNULL,
            env={**os.environ, "FROBC_PARENT": str(os.getpid())},
        )
    except OSError as error:
        raise Error(f"{command[0]} cannot be run: {error.strerror}") from None
    told = done.stderr.decode("utf-8", "replace").rstrip("\n")
    if done.returncode == REJECTED:
        raise CompileError(told)
    if done.returncode != 0:
        raise Error(told or f"frobc exited with status {done.returncode}")
    if told:
        warnings.warn(told, FrobWarning, stacklevel=4)
    return done.stdout.decode("utf-8", "replace")


def path_text(path: PathLike, what: str) -> str:
    """Converts a path to a string that system calls accept."""
    try:
        text = os.fsdecode(path)
        os.fsencode(text)
    except (TypeError, UnicodeError):
        raise InputError(f"{what}: expected a path, found {path!r:.60}") from None
    if "\0" in text:
        raise InputError(f"{what}: a path must not contain a zero byte, found {path!r:.60}")
    return text


def paths(given: Sequence[PathLike], what: str) -> List[PathLike]:
    """Checks a list of paths; rejects a single path."""
    if isinstance(given, (str, bytes, os.PathLike)):
        raise InputError(f"{what}: expected a list, found {given!r:.60}")
    try:
        return list(given)
    except TypeError:
        raise InputError(f"{what}: expected a list, found {given!r:.60}") from None


def word(value: str, what: str) -> str:
    """Checks a string that will be passed as a command-line argument."""
    if not isinstance(value, str):
        raise InputError(f"{what}: expected a string, found {value!r:.60}")
    return path_text(value, what)


def words(given: Sequence[str], what: str) -> List[str]:
    """Checks a list of strings. A single string counts as a list that contains only this string."""
    return [word(one, what) for one in ([given] if isinstance(given, str) else paths(given, what))]


def command(*arguments: str) -> str:
    """Formats a command that users can copy into a shell, with arguments quoted where necessary."""
    return " ".join(map(shlex.quote, arguments))


def existing(path: PathLike, what: str) -> str:
    """Converts a path to a string and checks that the file exists."""
    text = path_text(path, what)
    if not os.path.isfile(text):
        raise Error(f"there is no {what} {text}")
    if text.startswith("-"):
        text = os.path.join(".", text)
    return text
