"""Grade a whole class on all workers, and keep each result as soon as it is there.

The name of a result's file follows from the submission, the questions, the course's secret and
kinoedu's sources. So a run that was stopped, even killed, continues where it was, and nothing is
graded twice. A failure of the machine is tried again and then reported; it never gives a score.
"""

import atexit
import functools
import hashlib
import json
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from itertools import islice
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NamedTuple

from ...compiled.store import source_digest
from ...course.release import HOUSE, solution_path
from ...support.completed_futures import CompletedFutures, failure_of
from ...support.progress import Progress
from ...support.whole_files import written_whole
from ..assignments.questions import read_assignment
from ..collect.submissions import Submission
from ..sandbox.sandbox import NoSandbox, Sandbox
from .contracts import apply_contracts
from .submission import PYTHON, Grade, grade, is_cut_off, is_late

AHEAD = 256  # notebooks submitted at a time, since a cluster's scheduler holds them in memory
TRIES = 5
TRIES_BESIDE = 2  # of these while other jobs run
PATIENT = 3.0  # factor on time limits, for jobs that took too long beside others


class Job(NamedTuple):
    """One notebook to grade."""

    key: str
    assignment: str
    data: bytes
    secret: bytes
    patience: float = 1.0
    trusted: bool = False
    variants: tuple[tuple[str, str], ...] = ()


class Graded(NamedTuple):
    """A submission and its grade, or None and the reason."""

    submission: Submission
    grade: Grade | None
    trouble: str = ""


def grade_all(
    submissions: list[Submission],
    out: Path,
    secret: bytes,
    *,
    place: "Place | None" = None,
    progress: Progress | None = None,
    trusted: bool = False,
    patience: float = 1.0,
) -> list[Graded]:
    """Grade submissions; the grades do not depend on the workers.

    Parameters
    ----------
    out : the folder of the grades; results are kept in `out`/results.
    place : where to work, by default `use_local_workers()`.
    progress : called with the number of finished notebooks and of all.
    trusted : run the programs without a sandbox.
    patience : a factor on all time limits. It has no part in a result's name: most results do not
        depend on it. Only what took too long with less patience is graded again.

    Returns
    -------
    list of Graded
        In the order of the submissions.

    Raises
    ------
    OSError
        Where `out` cannot be written, or a cluster is lost (a ConnectionError).
    """
    results = out / "results"
    results.mkdir(parents=True, exist_ok=True)
    readable = [one for one in submissions if not one.trouble]
    keyed = ((compute_key(one, secret), one) for one in readable)
    jobs = {key: make_job(one, key, secret, trusted, patience) for key, one in keyed}
    records = {key: read_result(results / f"{key}.json") for key in jobs}
    grades = {
        key: record
        for key, record in records.items()
        if record is not None and is_settled(record, patience)
    }
    report_progress = progress or (lambda done, everything: None)
    report_progress(len(grades), len(jobs))
    troubles: dict[str, str] = {}
    missing = [job for key, job in jobs.items() if key not in grades]
    # what was late beside other jobs is graded again, alone and with more time
    for alone in (False, True):
        late = []
        for job, record, trouble in run_jobs(
            missing, place or use_local_workers(), 1 if alone else None
        ):
            if record is None:
                troubles[job.key] = trouble
            elif not alone and is_late(record):
                late.append(job._replace(patience=PATIENT * patience))
                continue
            else:
                if is_cut_off(record):
                    record = {**record, "patience": patience}
                write_result(results / f"{job.key}.json", record)
                grades[job.key] = record
            report_progress(len(grades) + len(troubles), len(jobs))
        missing = late
    return [attach_grade(one, grades, troubles, secret) for one in submissions]


def make_job(one: Submission, key: str, secret: bytes, trusted: bool, patience: float) -> Job:
    """The job that grades a submission."""
    return Job(key, one.assignment, one.data, secret, patience, trusted, one.variants)


def is_settled(record: Grade, patience: float) -> bool:
    """Whether more patience, or a newer Python, would not change a result."""
    if record.get("python", PYTHON) != PYTHON:
        return False
    return not is_cut_off(record) or patience <= record.get("patience", 1.0)


def attach_grade(
    one: Submission, grades: dict[str, Grade], troubles: dict[str, str], secret: bytes
) -> Graded:
    """A submission with its grade, or with the reason why there is none."""
    if one.trouble:
        return Graded(one, None, one.trouble)
    key = compute_key(one, secret)
    return Graded(one, grades.get(key), troubles.get(key, ""))


def compute_key(one: Submission | Job, secret: bytes) -> str:
    """The name of a result; equal for equal bytes, questions, contracts, secret and sources."""
    parts = [
        one.assignment.encode(),
        one.data,
        hashlib.sha256(secret).digest(),
        join_sources(one.assignment),
    ]
    parts += [repr(one.variants).encode()] if one.variants else []
    digests = b"".join(hashlib.sha256(part).digest() for part in parts)
    return hashlib.sha256(digests).hexdigest()[:40]


@functools.cache
def digest_library() -> str:
    """The digest of kinoedu's sources."""
    return source_digest(HOUSE / "kinoedu")


@functools.cache
def join_sources(name: str) -> bytes:
    """The digest of kinoedu's sources, and an assignment's solution: a grade depends on both."""
    return digest_library().encode() + solution_path(name).read_bytes()


def read_result(file: Path) -> Grade | None:
    """The result in a file, or None where there is none or it is damaged."""
    try:
        record = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    is_whole = isinstance(record, dict) and {"status", "questions", "cells"} <= set(record)
    return record if is_whole else None


def write_result(file: Path, record: Grade) -> None:
    """Write a result, completely or not at all."""
    with written_whole(file) as part:
        part.write_text(json.dumps(record, indent=1, sort_keys=True) + "\n", encoding="utf-8")


Place = Callable[[int | None], Any]  # number of workers, None for all -> context of an Executor


def use_local_workers(workers: int | None = None) -> Place:
    """Processes of this computer, by default one for each processor.

    After Ctrl-C they end at once: what was submitted is not waited for.
    """

    @contextmanager
    def place(most: int | None) -> Iterator[Executor]:
        new = multiprocessing.get_context("spawn")
        alive, held = new.Pipe(duplex=False)
        pool = ProcessPoolExecutor(
            most or workers, mp_context=new, initializer=end_with_parent, initargs=(alive,)
        )
        with alive, held, pool:
            try:
                yield pool
            except BaseException:
                held.close()
                pool.shutdown(wait=False, cancel_futures=True)
                raise

    return place


def end_with_parent(alive: Connection) -> None:
    """Make this process end when its parent closes the other end of a pipe, or is killed.

    Ctrl-C is for the parent to handle. It is not ignored here, as students' programs, which are
    processes of this one, would inherit that.
    """

    def watch() -> None:
        with suppress(EOFError):
            alive.recv()
        os._exit(1)

    signal.signal(signal.SIGINT, lambda *_: None)
    threading.Thread(target=watch, daemon=True).start()


def use_dask_workers(address: str) -> Place:
    """The workers of a Dask cluster; each needs the same kinoedu and a sandbox."""

    @contextmanager
    def place(most: int | None) -> Iterator[Executor]:
        from dask.distributed import Client

        with Client(address, timeout=10, set_as_default=False) as client:
            workers = sorted(client.scheduler_info()["workers"])
            yield client.get_executor(
                pure=False, retries=TRIES, **({"workers": workers[:1]} if most == 1 else {})
            )

    return place


def run_jobs(
    jobs: Iterable[Job], place: Place, most: int | None
) -> Iterator[tuple[Job, Grade | None, str]]:
    """Yield each job with its record, or None and the reason, as jobs are completed.

    A job is tried again, up to TRIES times, if its worker is lost or its machine fails. After
    TRIES_BESIDE failures it runs alone, so that a job that ends workers takes no other job with it.
    Where a worker was lost, the jobs that were being run may be at fault, and any job if none was
    completed before.
    """
    left, tries = list(jobs), dict[str, int]()
    while left:
        calm = [job for job in left if tries.get(job.key, 0) < TRIES_BESIDE]
        now = calm or left[:1]
        left = [job for job in left if job not in calm] if calm else left[1:]
        with place(most if calm else 1) as executor:
            completed, begun = CompletedFutures[Job](), {job.key for job in now}
            following = iter(now)
            submit_jobs(islice(following, AHEAD), executor, completed)
            for job, future in completed:
                submit_jobs(islice(following, 1), executor, completed)
                trouble = failure_of(future)
                if trouble is None:
                    begun = {
                        other.key
                        for waiting, other in completed.waiting.items()
                        if waiting.running()
                    }
                    yield job, future.result(), ""
                    continue
                tries[job.key] = tries.get(job.key, 0) + (
                    job.key in begun or not isinstance(trouble, BrokenProcessPool)
                )
                if tries[job.key] < TRIES:
                    left.append(job)
                else:
                    yield job, None, f"{type(trouble).__name__}: {trouble}"


def submit_jobs(jobs: Iterable[Job], executor: Executor, completed: CompletedFutures[Job]) -> None:
    """Submit jobs. Those that broken workers do not take fail as those that they had taken."""
    for job in jobs:
        try:
            future = executor.submit(grade_job, job)
        except BrokenProcessPool as broken:
            future = Future()
            future.set_exception(broken)
        completed.add(future, job)


class ThreadSandboxes(threading.local):
    """The sandboxes of each grading thread, as a Dask worker may have several threads.

    One has walls, and one is for programs that are trusted.
    """

    def __init__(self) -> None:
        self.sandboxes = {trusted: Sandbox(trusted) for trusted in (False, True)}
        for sandbox in self.sandboxes.values():
            atexit.register(sandbox.close)


SANDBOXES = ThreadSandboxes()


def grade_job(job: Job) -> Grade:
    """Grade a notebook in this process and its sandbox.

    Raises
    ------
    NoSandbox
    RuntimeError
        Where this process would give the result another name: a worker of a cluster may be older
        than a judge that was repaired.
    """
    if compute_key(job, job.secret) != job.key:
        # of Python's own class, which every version can receive
        raise RuntimeError("a worker has another version of kinoedu or of the solution; restart it")
    sandbox = SANDBOXES.sandboxes[job.trusted]
    try:
        task = apply_contracts(read_assignment(job.assignment), job.variants)
        return grade(job.data, task, job.secret, sandbox, patience=job.patience)
    except NoSandbox:
        sandbox.close()
        raise
