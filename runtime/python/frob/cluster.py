"""The runs of a sweep by the workers of a `dask.distributed` cluster.

A task is a shard of the runs (`frobc sweep --shard`). Workers that see the client's folder for
rows write there, each into a file of its own; of others the rows come back as a task's result, and
the client writes them. A task whose worker is killed is given to another, which makes what is
missing. So any mixture of machines comes to the same rows."""

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
"""Of a task: the scheduler takes milliseconds for each, and `frobc sweep` reads the plan first."""

MOST_RUNS = 500
"""Of a task, about. What a worker has done when it is killed is made again, if its machine does
not see the client's files."""

TASKS_A_THREAD = 4
"""At least so many, so that the last workers end together."""


@dataclass(frozen=True)
class Work:
    """What is the same for all tasks of a sweep."""

    plan: str
    options: Tuple[str, ...]
    digest: str
    folder: str
    mark: str
    """A file that the client has put into the folder: who sees it sees the folder itself."""


@dataclass(frozen=True)
class Answer:
    """Of a worker, before the first run."""

    lack: str
    """What it cannot make the runs for; empty if it can."""
    shares: bool
    """It sees the client's folder."""


@dataclass(frozen=True)
class Made:
    """What a task has come to. Rows are kept though some could not be made."""

    rows: bytes
    """None if they are in the client's folder already."""
    fault: str


def make(client: "Client", plan: str, options: Sequence[str], folder: str) -> None:
    """Makes the runs of the plan that there is no row of in the folder."""
    if client.asynchronous:
        raise InputError("client: expected one that waits for results, found an asynchronous one")
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
            f"{fault}\n{told['done']} of {told['runs']} runs are done; the same call goes on where "
            "this one ended"
        )


def look(plan: str, options: Sequence[str], rows: str) -> Dict[str, str]:
    """What `frobc sweep --dry-run` tells: `runs`, `done` and `digest`."""
    told = tools.run(["sweep", "--dry-run", *options, "--rows", rows, plan])
    return dict(line.split(": ", 1) for line in told.splitlines())


# Here.


def _ask_all(client: "Client", work: Work) -> bool:
    """Whether all see the folder. No run is made if a worker could not make them."""
    answers = client.run(ask, work, on_error="return")
    for address, answer in answers.items():
        if isinstance(answer, Exception):
            raise Error(f"the worker {address} cannot make runs: {_text(answer)}")
        if answer.lack:
            raise Error(f"the worker {address} cannot make these runs: {answer.lack}")
    return all(answer.shares for answer in answers.values())


def _text(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}"


def _make(client: "Client", work: Work, left: int) -> str:
    """What went wrong first; empty if nothing did."""
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
    except Exception as error:  # whatever becomes of a cluster
        return Made(b"", f"a worker could not make its runs: {_text(error)}")
    return made


# On a worker.

_fit_for: Set[Work] = set()
"""Sweeps that this process can make the runs of, and has been asked."""


def ask(work: Work) -> Answer:
    """Whether this worker can make the runs, and make them to the same rows."""
    return Answer(_lack(work), _shares(work))


def _lack(work: Work) -> str:
    if work in _fit_for:
        return ""
    with tempfile.TemporaryDirectory(prefix="frob-") as no_rows:
        try:
            told = look(work.plan, work.options, no_rows)
        except Error as error:
            reason = _without("error: ", str(error))
            return f"{reason}\n(plan, program and worlds have to be there as they are here)"
    if told["digest"] != work.digest:
        return "its plan, program, worlds or frobc are others than here"
    _fit_for.add(work)
    return ""


def _shares(work: Work) -> bool:
    return os.path.exists(work.mark)


def _without(start: str, text: str) -> str:
    return text[len(start) :] if text.startswith(start) else text


def shard(work: Work, number: int, count: int, known: bytes) -> Made:
    """Makes one of so many parts of the runs, but for those whose rows are known."""
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
    return Made(b"", f"a worker on {socket.gethostname()} could not make its runs: {text}")


def _rows_of(folder: str) -> bytes:
    """All files of rows as one. A line that was cut stays one that is not whole."""
    texts = []
    for path in sorted(glob.glob(os.path.join(glob.escape(folder), "*.rows"))):
        with open(path, "rb") as file:
            text = file.read()
        texts.append(text if text.endswith(b"\n") or not text else text + b"\n")
    return b"".join(texts)
