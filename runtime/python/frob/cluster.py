"""Performs the runs of a sweep on the workers of a `dask.distributed` cluster.

Each task is a shard of the runs (`frobc sweep --shard`). Workers that can see the client's folder
for rows write to that folder, each into its own file. Other workers return their rows as the task's
result, and the client writes them. If a worker is killed, the scheduler gives its task to another
worker, which performs the missing runs. Therefore the rows are the same on any combination of
machines."""

from __future__ import annotations

import glob
import os
import socket
import tempfile
import uuid
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Sequence, Set, Tuple

from . import tools
from .errors import Error, InputError

if TYPE_CHECKING:
    from distributed import Client

LEAST_RUNS = 50
"""Minimum number of runs per task. Each task costs the scheduler some milliseconds and makes
`frobc sweep` read the plan again.
"""

MOST_RUNS = 500
"""Approximate maximum number of runs per task. If a worker that cannot see the client's files is
killed, the runs of its task have to be repeated.
"""

TASKS_A_THREAD = 4
"""Minimum number of tasks per thread, so that the last workers finish at about the same time."""


@dataclass(frozen=True)
class Work:
    """The data that all tasks of a sweep share."""

    plan: str
    options: Tuple[str, ...]
    digest: str
    folder: str
    mark: str
    """A file that the client has created in the folder. A worker that sees the file sees the same
    folder.
    """


@dataclass(frozen=True)
class Answer:
    """A worker's answer before the first run."""

    lack: str
    """The reason why the worker cannot perform the runs; empty if it can."""
    shares: bool
    """Whether the worker sees the client's folder."""


@dataclass(frozen=True)
class Made:
    """The result of a task. Rows are kept even if some runs failed."""

    rows: bytes
    """Empty if the rows are already in the client's folder."""
    fault: str


def make(client: "Client", plan: str, options: Sequence[str], folder: str) -> None:
    """Performs the runs of the plan that have no row in the folder yet."""
    if client.asynchronous:
        raise InputError("client: expected a synchronous client, found an asynchronous one")
    told = look(plan, options, folder)
    left = int(told["runs"]) - int(told["done"])
    if left == 0:
        return
    mark = os.path.join(folder, f"sweep-{uuid.uuid4().hex}")
    try:
        os.makedirs(folder, exist_ok=True)
        open(mark, "xb").close()
    except OSError as error:
        raise Error(f"cannot write to {folder}: {error.strerror}") from None
    try:
        work = Work(plan, tuple(options), told["digest"], folder, mark)
        fault = _make(client, work, left)
    finally:
        os.remove(mark)
    if fault:
        told = look(plan, options, folder)
        raise Error(
            f"{fault}\n{told['done']} of {told['runs']} runs are done; repeat the call to continue"
        )


def look(plan: str, options: Sequence[str], rows: str) -> Dict[str, str]:
    """Returns the output of `frobc sweep --dry-run`: `runs`, `done` and `digest`."""
    told = tools.run(["sweep", "--dry-run", *options, "--rows", rows, plan])
    return dict(line.split(": ", 1) for line in told.splitlines())


# Functions that run on the client.


def _ask_all(client: "Client", work: Work) -> bool:
    """Asks all workers whether they see the folder; returns whether they all do. Raises an
    error, before any run starts, if one of them cannot perform the runs.
    """
    answers = client.run(ask, work, on_error="return")
    for address, answer in answers.items():
        if isinstance(answer, Exception):
            raise Error(f"the worker {address} cannot perform runs: {_text(answer)}")
        if answer.lack:
            raise Error(f"the worker {address} cannot perform these runs: {answer.lack}")
    return all(answer.shares for answer in answers.values())


def _text(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}"


def _make(client: "Client", work: Work, left: int) -> str:
    """Performs the missing runs. Returns the first failure, or an empty string."""
    from distributed import as_completed

    all_see = _ask_all(client, work)
    known = b"" if all_see else _rows_of(work.folder)
    threads = max(1, sum(client.nthreads().values()))
    count = max(1, min(left // LEAST_RUNS, max(TASKS_A_THREAD * threads, left // MOST_RUNS)))
    sent = client.submit(bytes, known, pure=False)
    parts = range(1, count + 1)
    futures = [client.submit(shard, work, part, count, sent, pure=False) for part in parts]
    fault = ""
    try:
        for future in as_completed(futures):
            made = _result(future)
            _keep(work, made.rows)
            fault = fault or made.fault
            future.release()
    finally:
        client.cancel([sent, *futures])
    return fault


def _keep(work: Work, rows: bytes) -> None:
    path = work.mark + ".rows"
    if rows:
        try:
            with open(path, "ab") as file:
                file.write(rows)
        except OSError as error:
            raise Error(f"cannot write rows to {path}: {error.strerror}") from None


def _result(future: Any) -> Made:
    try:
        made: Made = future.result()
    except Exception as error:  # a cluster can fail in many ways
        return Made(b"", f"a worker could not perform its runs: {_text(error)}")
    return made


# Functions that run on a worker.

_fit_for: Set[Work] = set()
"""Sweeps for which this process has checked that it can perform the runs."""


def ask(work: Work) -> Answer:
    """Checks whether this worker can perform the runs, and whether the rows would be the same."""
    return Answer(_lack(work), _shares(work))


def _lack(work: Work) -> str:
    if work in _fit_for:
        return ""
    with tempfile.TemporaryDirectory(prefix="frob-") as no_rows:
        try:
            told = look(work.plan, work.options, no_rows)
        except Error as error:
            reason = _without("error: ", str(error))
            return f"{reason}\n(the worker needs the same plan, program and worlds as the client)"
    if told["digest"] != work.digest:
        return "its plan, program, worlds or frobc differ from those of the client"
    _fit_for.add(work)
    return ""


def _shares(work: Work) -> bool:
    return os.path.exists(work.mark)


def _without(start: str, text: str) -> str:
    return text[len(start) :] if text.startswith(start) else text


def shard(work: Work, number: int, count: int, known: bytes) -> Made:
    """Performs one of `count` parts of the runs, skipping runs whose rows are known."""
    lack = _lack(work)
    if lack:
        return _fault(lack)
    with tempfile.TemporaryDirectory(prefix="frob-") as scratch:
        rows = work.folder if _shares(work) else os.path.join(scratch, "rows")
        table = os.path.join(scratch, "runs.csv")
        part = ["--shard", f"{number}/{count}", "--jobs", "1", "--rows", rows, "--table", table]
        if rows == work.folder:
            return Made(b"", _run([*part, *work.options, work.plan]))
        os.mkdir(rows)
        first = os.path.join(rows, "known.rows")
        with open(first, "wb") as file:
            file.write(known)
        fault = _run([*part, *work.options, work.plan])
        os.remove(first)
        return Made(_rows_of(rows), fault)


def _run(arguments: Sequence[str]) -> str:
    try:
        tools.run(["sweep", *arguments])
    except Error as error:
        return _fault(_without("error: ", str(error))).fault
    return ""


def _fault(text: str) -> Made:
    return Made(b"", f"a worker on {socket.gethostname()} could not perform its runs: {text}")


def _rows_of(folder: str) -> bytes:
    """Concatenates all files of rows. A truncated last line stays a separate, invalid line."""
    texts = []
    for path in sorted(glob.glob(os.path.join(glob.escape(folder), "*.rows"))):
        with open(path, "rb") as file:
            text = file.read()
        texts.append(text if text.endswith(b"\n") or not text else text + b"\n")
    return b"".join(texts)
