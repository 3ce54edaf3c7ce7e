"""`python3 -m frob.falsify_command`: what `frobc falsify` runs."""

from __future__ import annotations

import argparse
import os
import re
import sys
import warnings
from typing import Dict, List, Optional, Sequence

from .errors import Error
from .falsification import Search, falsify
from .judging import FAR

VIOLATED, WRONG_USE = 1, 2
"""Exit statuses, as those of frobc."""


def main(arguments: Optional[Sequence[str]] = None) -> int:
    options = _options().parse_args(arguments)
    # What frobc warns of, as it does.
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
        )
        for search in searches:
            _tell(search, options)
    except Error as error:
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
        nearest = f"; the nearest margin is {search.nearest:.6g}" if search.nearest < FAR else ""
        blind = "" if search.has_margin else "; it compares nothing, so the search was blind"
        print(f"held      {label}: not violated in {runs}{nearest}{blind}")
        return
    margin = f", margin {found.margin:.6g}" if found.margin < 0 else ""
    print(f"violated  {label}: at {found.time:g} s, found in {runs}{margin}")
    settings = "".join(f" --param {name}={value}" for name, value in found.settings.items())
    stem = os.path.join(options.keep, re.sub(r"[^A-Za-z0-9_.-]+", "-", label))
    if found.drive is None:
        os.makedirs(options.keep, exist_ok=True)
        found.write(stem + ".csv")
        print(f"          frobc trace {options.file} --input {stem}.csv{settings}")
        return
    drive = found.drive
    world = drive.world
    if drive.disturbances:
        os.makedirs(options.keep, exist_ok=True)
        world = stem + ".toml"
        with open(world, "w", encoding="utf-8") as file:
            file.write(drive.text)
    given = [f"--world {world}", f"--seed {drive.seed}", f"--for {options.duration:g}s"]
    given += [f"--rate {options.rate:g}"] if options.rate != 50 else []
    given += [f"--robot {options.robot}"] if options.robot is not None else []
    given += [f"--entry {options.entry}"] if options.entry != "main" else []
    print(f"          frobc run {options.file} {' '.join(given)}{settings}")
    if drive.disturbances:
        told = ", ".join(f"{name} = {value:.6g}" for name, value in drive.disturbances.items())
        print(f"          with {told}")


if __name__ == "__main__":
    sys.exit(main())
