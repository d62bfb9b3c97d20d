"""The process that compiles: python -m kinoedu.compiled.worker FOLDER SLOT [gives-way].

It takes the oldest request, compiles it, and leaves the machine code in the folder. It ends when no
requests are left, or after its current request if its parent process has ended. Each slot has one
worker at a time. A request during which a worker was killed is tried again by the next worker, up
to ATTEMPTS times.
"""

import contextlib
import importlib
import os
import pickle
import signal
import sys
import time
from pathlib import Path

from ..support.whole_files import written_whole
from . import store
from .store import (
    PACKAGE,
    UPPER_ROOMS,
    Request,
    pending_requests,
    sources,
    try_lock,
    write_request,
)

ATTEMPTS = 3
LINGER = 5.0  # seconds without requests before it ends
POLL_INTERVAL = 0.1  # seconds between two looks for requests
NICE = 10  # the priority of a worker that gives way, by which it still comes to an end
AUTOGROUP = Path("/proc/self/autogroup")  # the priority of this session, see man 7 sched


def main(arguments: list[str]) -> int:
    """Compile the requests in a folder; returns the exit code."""
    place, slot = Path(arguments[0]), arguments[1]
    if "gives-way" in arguments:
        lower_priority()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    if store.folder() != place:  # the sources have changed since the request
        return 1
    with contextlib.suppress(FileNotFoundError), open(place / f"slot-{slot}", "wb") as lock:
        if not try_lock(lock):
            return 0
        retry_unfinished(place, place / f"taken-{slot}")
        import_compiled_modules()
        compile_requests(place, place / f"taken-{slot}")
    return 0


def lower_priority() -> None:
    """Lower the priority of this process: about a tenth of a processor that others want too.

    Linux may share its processors between sessions first, and then `nice` counts only among the
    processes of one session. This process has a session of its own, whose priority it lowers too.
    """
    if hasattr(os, "nice"):
        os.nice(NICE)
        with contextlib.suppress(OSError):
            if AUTOGROUP.exists():
                AUTOGROUP.write_text(str(NICE), encoding="ascii")
    else:
        import ctypes

        idle = 0x40
        kernel = ctypes.windll.kernel32  # type: ignore[attr-defined]
        kernel.SetPriorityClass(kernel.GetCurrentProcess(), idle)


def retry_unfinished(place: Path, taken: Path) -> None:
    """Repeat the requests that the last worker did not finish, up to ATTEMPTS times."""
    taken.mkdir(exist_ok=True)
    for file in taken.iterdir():
        with contextlib.suppress(Exception):
            unfinished: Request = pickle.loads(file.read_bytes())
            again = unfinished._replace(attempts=unfinished.attempts + 1)
            if again.attempts < ATTEMPTS:
                write_request(place, again)
            else:
                write_refusal(place, again, f"compiling it ended {ATTEMPTS} processes")
        file.unlink(missing_ok=True)


def import_compiled_modules() -> None:
    """Import every module with compiled functions, so that all implementations are registered."""
    without = (*UPPER_ROOMS, "compiled", "__init__.py", "__main__.py", "lab.py", "warm.py")
    for source in sources(PACKAGE, without):
        parts = source.relative_to(PACKAGE.parent).with_suffix("").parts
        importlib.import_module(".".join(parts).removesuffix(".__init__"))


def compile_requests(place: Path, taken: Path) -> None:
    """Compile until there are no requests for LINGER seconds, or the parent process has ended."""
    parent, last = os.getppid(), time.monotonic()
    while os.getppid() == parent and time.monotonic() < last + LINGER:
        file = take_request(place, taken)
        if file is None:
            time.sleep(POLL_INTERVAL)
        else:
            compile_request(place, file)
            last = time.monotonic()


def take_request(place: Path, taken: Path) -> Path | None:
    """Take the oldest request; None if there is none."""
    for file in pending_requests(place):
        mine = taken / file.name
        try:
            file.rename(mine)
        except OSError:  # another worker took it
            continue
        if not (place / f"{file.name}.code").exists():
            return mine
        mine.unlink()
    return None


def compile_request(place: Path, file: Path) -> None:
    """Compile a request and write its machine code, or the reason why there is none."""
    from .compiler import compile_entry
    from .machine import to_bytes
    from .tiers import find_function

    request: Request = pickle.loads(file.read_bytes())
    try:
        result = compile_entry(find_function(request.module, request.function), request.kinds)
        with written_whole(place / f"{request.name}.code") as part:
            part.write_bytes(to_bytes(result))
    except (OSError, SystemExit):
        write_request(place, request)
        raise
    except Exception as error:
        write_refusal(place, request, f"{type(error).__name__}: {error}")
    file.unlink()


def write_refusal(place: Path, request: Request, why: str) -> None:
    """Write the reason why a request cannot be compiled."""
    with written_whole(place / f"{request.name}.refused") as part:
        part.write_text(why, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
