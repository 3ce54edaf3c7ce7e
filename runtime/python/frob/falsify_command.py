"""`python3 -m frob.falsify_command`: the implementation of `frobc falsify`."""

from __future__ import annotations

import argparse
import os
import re
import signal
import sys
import time
import warnings
from typing import Dict, List, Optional, Sequence

from . import tools
from .errors import Error
from .falsification import Search, falsify
from .judging import FAR

VIOLATED, WRONG_USE, BUG = 1, 2, 3
"""Exit statuses, the same as those of frobc."""


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command. Reports an interrupt in one line, and other exceptions as internal
    errors."""
    looked = _Looked()
    try:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        return _run(_options().parse_args(arguments), looked)
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        looked.clear()
        print(f"interrupted: {looked.interrupted()}", file=sys.stderr)
    except BrokenPipeError:
        # The reader has closed the pipe, so this discards the remaining output.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return WRONG_USE
    except Exception as error:
        looked.clear()
        print(
            f"internal error in falsify: {type(error).__name__}: {error}\n"
            "This is a bug in frobc, not in your program.",
            file=sys.stderr,
        )
        return BUG
    sys.stdout.flush()
    sys.stderr.flush()
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    os.kill(os.getpid(), signal.SIGINT)
    return 128 + signal.SIGINT


class _Looked:
    """Tracks the progress of the searches: updates a line on the terminal and, after an interrupt,
    reports the results so far.
    """

    def __init__(self) -> None:
        self._label, self._runs, self._most, self._ended = "", 0, 0, 0
        self._shown = 0.0

    def see(self, label: str, runs: int, most: int) -> None:
        self._label, self._runs, self._most = label, runs, most
        now = time.monotonic()
        if not sys.stderr.isatty() or now - self._shown < 0.1:
            return
        self._shown = now
        try:
            room = os.get_terminal_size(sys.stderr.fileno()).columns or 80
        except OSError:
            room = 80
        tail = f": {runs} of at most {most} runs"
        left = max(0, room - 1 - len(tail))
        head = label if len(label) <= left else label[: max(0, left - 1)] + "…"
        print(f"\r\033[K{(head + tail)[: room - 1]}", end="", file=sys.stderr, flush=True)

    def clear(self) -> None:
        if self._shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
        self._shown = 0.0

    def end(self) -> None:
        self._ended += 1
        self._label = ""
        self.clear()

    def interrupted(self) -> str:
        kept = "no search has finished, so no results were saved"
        if self._ended > 0:
            kept = (
                f"the results of {self._ended} search{'' if self._ended == 1 else 'es'} are above"
            )
        if not self._label:
            return f"{kept}; to start over, run the same command again"
        return (
            f"{kept}; `{tools.command('--only', self._label)}` restarts the search that "
            f"had performed {self._runs} of at most {self._most} runs"
        )


def _run(options: argparse.Namespace, looked: _Looked) -> int:
    def ended(search: Search) -> None:
        looked.end()
        _tell(search, options)
        sys.stdout.flush()

    # Prints warnings in the same way as frobc.
    warnings.showwarning = lambda message, *_: print(message, file=sys.stderr)
    try:
        searches = falsify(
            options.file,
            params=_ranges("--param", options.param),
            inputs=_ranges("--input", options.input),
            disturbances=_ranges("--disturbance", options.disturbance),
            seeds=options.seeds,
            world=options.world,
            duration=options.duration,
            rate=options.rate,
            points=options.points,
            shape="linear" if options.linear else "constant",
            only=options.only,
            runs=options.runs,
            seed=options.seed,
            method=options.method,
            check_rate=options.check_rate,
            entry=options.entry,
            robot=options.robot,
            sources=options.sources,
            progress=looked.see,
            ended=ended,
        )
    except Error as error:
        looked.clear()
        told = str(error)
        print(told if told.startswith(("error", "internal")) else f"error: {told}", file=sys.stderr)
        return WRONG_USE
    except OSError as error:
        print(f"error: cannot write {error.filename}: {error.strerror}", file=sys.stderr)
        return WRONG_USE
    return VIOLATED if any(search.found for search in searches) else 0


def _options() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="frobc falsify", add_help=False, allow_abbrev=False)
    parser.add_argument("file")
    parser.add_argument("--param", action="append", default=[])
    parser.add_argument("--input", action="append", default=[])
    parser.add_argument("--disturbance", action="append", default=[])
    parser.add_argument("--seeds", default=None)
    parser.add_argument("--world", default=None)
    parser.add_argument("--for", dest="duration", type=float, default=60.0)
    parser.add_argument("--rate", type=float, default=50.0)
    parser.add_argument("--check-rate", type=float, default=None)
    parser.add_argument("--points", type=int, default=10)
    parser.add_argument("--linear", action="store_true")
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--method", default="cma")
    parser.add_argument("--keep", default="falsified")
    parser.add_argument("--entry", default="main")
    parser.add_argument("--robot", default=None)
    parser.add_argument("--with", dest="sources", action="append", default=[])
    return parser


def _ranges(option: str, settings: List[str]) -> Dict[str, str]:
    found: Dict[str, str] = {}
    for setting in settings:
        name, equals, given = setting.partition("=")
        if not equals or not name.strip():
            raise Error(f'{option} takes NAME="LOW to HIGH", found `{setting}`')
        if name.strip() in found:
            raise Error(f"{option}: `{name.strip()}` is given twice")
        found[name.strip()] = given.strip()
    return found


def _tell(search: Search, options: argparse.Namespace) -> None:
    label, found = search.label, search.found
    runs = f"{search.runs} run" + ("" if search.runs == 1 else "s")
    if found is None:
        nearest = f"; the smallest margin is {search.nearest:.6g}" if search.nearest < FAR else ""
        blind = (
            ""
            if search.has_margin
            else "; the assertion compares no numbers, so the search was not guided"
        )
        print(f"held      {label}: not violated in {runs}{nearest}{blind}")
        return
    margin = f", margin {found.margin:.6g}" if found.margin < 0 else ""
    print(f"violated  {label}: at {found.time:g} s, found in {runs}{margin}")
    if found.collision:
        print(f"          {found.collision}")
    program = [options.file]
    for source in options.sources:
        program += ["--with", source]
    settings = ["--entry", options.entry] if options.entry != "main" else []
    settings += ["--robot", options.robot] if options.robot is not None else []
    for name, value in found.settings.items():
        settings += ["--param", f"{name}={value}"]
    stem = os.path.join(options.keep, re.sub(r"[^A-Za-z0-9_.-]+", "-", label))
    if found.drive is None:
        os.makedirs(options.keep, exist_ok=True)
        found.write(stem + ".csv")
        told = tools.command("frobc", "trace", *program, "--input", stem + ".csv", *settings)
        print(f"          {told}")
        return
    drive = found.drive
    world = drive.world
    if drive.disturbances:
        os.makedirs(options.keep, exist_ok=True)
        world = stem + ".toml"
        with open(world, "w", encoding="utf-8") as file:
            file.write(drive.text)
    given = ["--world", world, "--seed", str(drive.seed), "--for", f"{options.duration:g}s"]
    given += ["--rate", f"{options.rate:g}"] if options.rate != 50 else []
    print(f"          {tools.command('frobc', 'run', *program, *given, *settings)}")
    if drive.disturbances:
        told = ", ".join(f"{name} = {value:.6g}" for name, value in drive.disturbances.items())
        print(f"          with {told}")


if __name__ == "__main__":
    sys.exit(main())
