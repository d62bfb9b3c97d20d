"""The process that compiles: python -m kinoedu.compiled.worker FOLDER SLOT [gives-way].

It takes what is wanted, the oldest first, compiles it, and leaves the machine code in the folder.
It ends when nothing is wanted any more, or when who started it has ended and the one at hand is
done. Each slot has one worker at a time; what a worker was killed over is tried again by the next
one, ATTEMPTS times.
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
    Wanted,
    all_wanted,
    lock_taken,
    sources,
    want,
)

ATTEMPTS = 3
LINGER = 5.0  # seconds in which something else may be wanted
AGAIN = 0.1


def main(arguments: list[str]) -> int:
    """Compile what is wanted in a folder."""
    place, slot = Path(arguments[0]), arguments[1]
    if "gives-way" in arguments:
        give_way()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    if store.folder() != place:  # the sources have changed: others than those that are wanted
        return 1
    with contextlib.suppress(FileNotFoundError), open(place / f"slot-{slot}", "wb") as lock:
        if not lock_taken(lock):
            return 0
        recover(place, place / f"taken-{slot}")
        import_all()
        serve(place, place / f"taken-{slot}")
    return 0


def give_way() -> None:
    """Compile only while nothing else runs."""
    if hasattr(os, "nice"):
        os.nice(19)
    else:
        import ctypes

        idle = 0x40
        kernel = ctypes.windll.kernel32  # type: ignore[attr-defined]
        kernel.SetPriorityClass(kernel.GetCurrentProcess(), idle)


def recover(place: Path, taken: Path) -> None:
    """What the last worker of this slot did not finish is wanted again, unless that was too
    often.
    """
    taken.mkdir(exist_ok=True)
    for file in taken.iterdir():
        with contextlib.suppress(Exception):
            unfinished: Wanted = pickle.loads(file.read_bytes())
            again = unfinished._replace(attempts=unfinished.attempts + 1)
            if again.attempts < ATTEMPTS:
                want(place, again)
            else:
                refuse(place, again, f"compiling it ended {ATTEMPTS} processes")
        file.unlink(missing_ok=True)


def import_all() -> None:
    """Import all that may be compiled, so that every kind of record has its answers."""
    without = (*UPPER_ROOMS, "compiled", "__init__.py", "__main__.py", "lab.py", "warm.py")
    for source in sources(PACKAGE, without):
        parts = source.relative_to(PACKAGE.parent).with_suffix("").parts
        importlib.import_module(".".join(parts).removesuffix(".__init__"))


def serve(place: Path, taken: Path) -> None:
    """Compile until nothing is wanted for a while, or who started this has ended."""
    parent, last = os.getppid(), time.monotonic()
    while os.getppid() == parent and time.monotonic() < last + LINGER:
        file = next_wanted(place, taken)
        if file is None:
            time.sleep(AGAIN)
        else:
            compile_wanted(place, file)
            last = time.monotonic()


def next_wanted(place: Path, taken: Path) -> Path | None:
    """Take what was wanted first; None where nothing is."""
    for file in all_wanted(place):
        mine = taken / file.name
        try:
            file.rename(mine)
        except OSError:  # another worker took it
            continue
        if not (place / f"{file.name}.code").exists():
            return mine
        mine.unlink()
    return None


def compile_wanted(place: Path, file: Path) -> None:
    """Compile one, and write its code; or why there is none."""
    from .compiler import compile_entry
    from .machine import packed
    from .tiers import find

    wanted: Wanted = pickle.loads(file.read_bytes())
    try:
        result = compile_entry(find(wanted.module, wanted.function), wanted.kinds)
        with written_whole(place / f"{wanted.name}.code") as part:
            part.write_bytes(packed(result))
    except (OSError, SystemExit):
        want(place, wanted)
        raise
    except Exception as error:
        refuse(place, wanted, f"{type(error).__name__}: {error}")
    file.unlink()


def refuse(place: Path, wanted: Wanted, why: str) -> None:
    """Write down that something is not to be compiled."""
    with written_whole(place / f"{wanted.name}.refused") as part:
        part.write_text(why, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
