"""Requests for machine code, and the processes that compile it."""

import os
import subprocess
import sys
import time
from collections.abc import Callable, Collection
from pathlib import Path

from ..support.threads import WAITING_FILES
from .store import AWAITED, PACKAGE, Request, slot_file, try_lock, write_request

POLL_INTERVAL = 0.05  # seconds between two looks for machine code
MAX_FAILURES = 3  # workers that may fail during one wait

WAITING_FILES.add(__file__)
started: dict[tuple[str, int], "subprocess.Popen[bytes]"] = {}  # workers by queue and slot


def is_refused(place: Path, request: Request) -> bool:
    """Whether numba could not compile it."""
    return (place / f"{request.name}.refused").exists()


def is_there(place: Path, request: Request) -> bool:
    """Whether its machine code exists."""
    return (place / f"{request.name}.code").exists()


def is_pending(place: Path, request: Request) -> bool:
    """Whether it is neither compiled nor refused."""
    return not is_there(place, request) and not is_refused(place, request)


def request_compilation(place: Path, queue: str, request: Request) -> bool:
    """Request machine code; returns whether it exists or can be expected."""
    if is_refused(place, request) or is_there(place, request):
        return is_there(place, request)
    try:
        write_request(place / queue, request)
        start_worker(place, queue, 0)
    except OSError:  # processes are not possible, or the disk is full
        return False
    return True


def compile_and_wait(place: Path, request: Request) -> bool:
    """Request machine code and wait; returns whether it was compiled."""
    try:
        return not compile_all(place, AWAITED, [request], workers=1)
    except OSError:  # processes are not possible, or the disk is full
        return False


def compile_all(
    place: Path,
    queue: str,
    requests: Collection[Request],
    *,
    workers: int,
    report_progress: Callable[[int, int], None] = lambda done, of: None,
) -> list[Request]:
    """Compile all requests in several processes, and wait.

    Parameters
    ----------
    place : the folder of machine code.
    queue : AWAITED or WANTED.
    requests : what to compile.
    workers : how many processes compile. One that runs already for single requests is among them.
    report_progress : is called with the number of requests that are done, and the number of all.

    Returns
    -------
    list
        The requests that could not be compiled.
    """
    missing = [request for request in requests if is_pending(place, request)]
    for request in missing:
        write_request(place / queue, request)
    total, slots = len(missing), range(min(workers, len(missing)))
    failures = 0
    try:
        while missing and failures < MAX_FAILURES:
            report_progress(total - len(missing), total)
            for slot in slots:
                failures += has_failed(queue, slot)
                start_worker(place, queue, slot)
            time.sleep(POLL_INTERVAL)
            missing = [request for request in missing if is_pending(place, request)]
    except BaseException:
        for slot in slots:
            stop_worker(queue, slot)
        raise
    return [request for request in requests if not is_there(place, request)]


def start_worker(place: Path, queue: str, slot: int) -> None:
    """Start the worker of a queue's slot, unless it runs."""
    worker = started.get((queue, slot))
    if (worker is not None and worker.poll() is None) or has_worker(place, queue, slot):
        return
    path = os.pathsep.join(filter(None, [str(PACKAGE.parent), os.environ.get("PYTHONPATH")]))
    env = {name: value for name, value in os.environ.items() if name != "KINOEDU_MACHINE_CODE"}
    worker_of = [str(place), queue, str(slot)]
    with open(place / "log", "ab") as log:
        started[queue, slot] = subprocess.Popen(
            [sys.executable, "-P", "-m", "kinoedu.compiled.worker", *worker_of],
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=log,
            env={**env, "PYTHONPATH": path, "KINOEDU_CACHE": str(place.parent)},
            start_new_session=True,  # Ctrl-C does not reach the worker
        )


def has_failed(queue: str, slot: int) -> bool:
    """Whether the worker of a queue's slot has ended with an error."""
    worker = started.get((queue, slot))
    if worker is None or worker.poll() is None:
        return False
    del started[queue, slot]
    return worker.returncode != 0


def has_worker(place: Path, queue: str, slot: int) -> bool:
    """Whether any process is the worker of a queue's slot."""
    with open(slot_file(place, queue, slot), "wb") as lock:
        return not try_lock(lock)  # closing the file unlocks it


def stop_worker(queue: str, slot: int) -> None:
    """Terminate the worker of a queue's slot."""
    worker = started.pop((queue, slot), None)
    if worker is not None:
        worker.terminate()
        worker.wait()
