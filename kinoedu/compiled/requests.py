"""Asking for machine code: writing down what is wanted, and starting who compiles it."""

import os
import subprocess
import sys
import time
from collections.abc import Callable, Collection
from pathlib import Path

from ..support.threads import WAITING_FILES
from .store import PACKAGE, Wanted, lock_taken, want

BACKGROUND = 0  # the slot of the one worker that gives way to everything else
AGAIN = 0.05  # seconds between two looks for what is waited for
FAILURES = 3  # workers that may fail while something is waited for

WAITING_FILES.add(__file__)
started: dict[int, "subprocess.Popen[bytes]"] = {}  # by slot


def is_refused(place: Path, wanted: Wanted) -> bool:
    """Whether numba could not compile it."""
    return (place / f"{wanted.name}.refused").exists()


def is_there(place: Path, wanted: Wanted) -> bool:
    """Whether its machine code has come."""
    return (place / f"{wanted.name}.code").exists()


def have_compiled(place: Path, wanted: Wanted) -> bool:
    """Have something compiled behind whatever else is running; whether there is hope of it."""
    if is_refused(place, wanted) or is_there(place, wanted):
        return is_there(place, wanted)
    try:
        want(place, wanted)
        start_worker(place, BACKGROUND)
    except OSError:  # no processes here, or no room on the disk
        return False
    return True


def wait_for(place: Path, wanted: Wanted) -> bool:
    """Have something compiled and wait for it; whether it was."""
    return not compile_all(place, [wanted], workers=1)


def compile_all(
    place: Path,
    wanted: Collection[Wanted],
    *,
    workers: int,
    gives_way: bool = False,
    tell: Callable[[int, int], None] = lambda done, of: None,
) -> list[Wanted]:
    """Have all compiled by some processes, and wait; those that could not be compiled.

    tell : is told how many are done, and of how many.
    """
    missing = [one for one in wanted if not is_there(place, one) and not is_refused(place, one)]
    for one in missing:
        want(place, one)
    everything, slots = len(missing), range(1, 1 + min(workers, len(missing)))
    failures = 0
    try:
        while missing and failures < FAILURES:
            tell(everything - len(missing), everything)
            for slot in slots:
                failures += has_failed(slot)
                start_worker(place, slot, gives_way=gives_way)
            time.sleep(AGAIN)
            missing = [
                one for one in missing if not is_there(place, one) and not is_refused(place, one)
            ]
    except BaseException:
        for slot in slots:
            stop_worker(slot)
        raise
    return [one for one in wanted if not is_there(place, one)]


def start_worker(place: Path, slot: int, *, gives_way: bool = True) -> None:
    """Start the worker of a slot, unless there is one."""
    worker = started.get(slot)
    if (worker is not None and worker.poll() is None) or has_worker(place, slot):
        return
    path = os.pathsep.join(filter(None, [str(PACKAGE.parent), os.environ.get("PYTHONPATH")]))
    kept = {name: value for name, value in os.environ.items() if name != "KINOEDU_MACHINE_CODE"}
    command = [sys.executable, "-P", "-m", "kinoedu.compiled.worker", str(place), str(slot)]
    with open(place / "log", "ab") as log:
        started[slot] = subprocess.Popen(
            command + ["gives-way"] * gives_way,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=log,
            env={**kept, "PYTHONPATH": path, "KINOEDU_CACHE": str(place.parent)},
            start_new_session=True,  # Ctrl-C is the reader's
        )


def has_failed(slot: int) -> bool:
    """Whether the worker of a slot ended for another reason than that it had nothing to do."""
    worker = started.get(slot)
    if worker is None or worker.poll() is None:
        return False
    del started[slot]
    return worker.returncode != 0


def has_worker(place: Path, slot: int) -> bool:
    """Whether some process is the worker of a slot."""
    with open(place / f"slot-{slot}", "wb") as lock:
        return not lock_taken(lock)  # and freed again here


def stop_worker(slot: int) -> None:
    """End the worker of a slot."""
    worker = started.pop(slot, None)
    if worker is not None:
        worker.terminate()
        worker.wait()
