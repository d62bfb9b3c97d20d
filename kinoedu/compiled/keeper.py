"""The keeper: one thread that works with numba, and watches algorithms that are interpreted.

It loads machine code for whoever waits for it. An algorithm that outlasts its budget it has
compiled; when the machine code has come it ends the interpreted call, which is begun again.
"""

import logging
import os
import queue
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..support.threads import WAITING_FILES, raise_in

if TYPE_CHECKING:
    from .tiers import Specialization

log = logging.getLogger(__name__)

WAITING_FILES.add(__file__)
LOOK = 0.1  # seconds between two looks at what is watched
IDLE = 5.0  # seconds without work after which the keeper looks more rarely


class ChangeOver(BaseException):
    """Raised in an interpreted algorithm: its machine code has come."""


class Watch:
    """An algorithm that a thread is interpreting."""

    def __init__(self, specialization: "Specialization") -> None:
        self.specialization = specialization
        self.thread = threading.get_ident()
        self.began = time.perf_counter()
        self.lock = threading.Lock()
        self.is_closed = self.is_interrupted = False
        KEEPER.watch(self)

    def look(self) -> None:
        """Do what its time calls for."""
        from .tiers import BUDGET, IMPORTING

        it, seconds = self.specialization, time.perf_counter() - self.began
        if seconds > IMPORTING and not it.is_loaded and it.has_come():
            it.load_here()
        if it.is_loaded:
            self.interrupt()
        elif it.spent + seconds > BUDGET:
            it.request()

    def interrupt(self) -> None:
        """End the interpreted call, unless it has ended."""
        with self.lock:
            if not self.is_closed and not self.is_interrupted:
                self.is_interrupted = True
                raise_in(self.thread, ChangeOver)

    def close(self) -> None:
        """The call has ended: it is not to be interrupted any more, and perhaps was just now."""
        KEEPER.forget(self)
        with self.lock:
            self.is_closed = True
        if self.is_interrupted:
            raise_in(self.thread, None)


class Keeper:
    """The thread, started when there is something to do."""

    def __init__(self) -> None:
        self.renew()

    def renew(self) -> None:
        """Begin without a thread, as after a fork."""
        self.jobs: queue.SimpleQueue[Callable[[], None] | None] = queue.SimpleQueue()
        self.watches: set[Watch] = set()
        self.thread: threading.Thread | None = None
        self.is_idle = True
        self.starting = threading.Lock()

    def wake(self) -> None:
        """See to it that the thread runs."""
        if self.thread is None:
            with self.starting:
                if self.thread is None:
                    thread = threading.Thread(target=self.run, name="kinoedu", daemon=True)
                    thread.start()
                    self.thread = thread
        if self.is_idle:
            self.jobs.put(None)

    def watch(self, watch: Watch) -> None:
        """Look at a watch now and then."""
        self.watches.add(watch)
        self.wake()

    def forget(self, watch: Watch) -> None:
        """Do so no more."""
        self.watches.discard(watch)

    def later(self, work: Callable[[], None]) -> None:
        """Do some work in the keeper's thread, soon."""
        self.wake()
        self.jobs.put(work)

    def do(self, work: Callable[[], None]) -> None:
        """Do some work in the keeper's thread, and wait for it: what stops the caller's thread does
        not stop the work. Raises what the work raises."""
        if threading.current_thread() is self.thread:
            work()
            return
        done: dict[str, Any] = {}

        def job() -> None:
            try:
                work()
            except BaseException as error:
                done["error"] = error
            done["done"] = True

        self.wake()
        self.jobs.put(job)
        while "done" not in done:
            time.sleep(0.001)
        if "error" in done:
            raise done["error"]

    def run(self) -> None:
        """Work, for ever."""
        last = time.monotonic()
        while True:
            self.is_idle = not self.watches and time.monotonic() - last > IDLE
            try:
                job = self.jobs.get(timeout=IDLE if self.is_idle else LOOK)
            except queue.Empty:
                job = None
            self.is_idle = False
            if job is not None:
                last = time.monotonic()
                job()
            for watch in tuple(self.watches):
                last = time.monotonic()
                try:
                    watch.look()
                except Exception:
                    log.exception("an interpreted call could not be watched")
                    self.watches.discard(watch)


KEEPER = Keeper()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=KEEPER.renew)
