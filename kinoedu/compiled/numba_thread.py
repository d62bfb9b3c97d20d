"""The one thread that works with numba, and that watches interpreted algorithms.

It loads machine code for other threads, which wait for it. It requests the compilation of an
algorithm that exceeds its budget. When the machine code exists, it interrupts the interpreted call,
which is restarted.
"""

import logging
import os
import queue
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..support.threads import WAITING_FILES, raise_in, short_turns, withdraw_exception

if TYPE_CHECKING:
    from .tiers import Specialization

log = logging.getLogger(__name__)

WAITING_FILES.add(__file__)
POLL_INTERVAL = 0.1  # seconds between two checks of the watched calls
IDLE_INTERVAL = 5.0  # seconds between two checks after as many seconds without work
LONGEST_WAIT = 60.0  # seconds for which a fork waits until this thread is between two jobs


class MachineCodeLoaded(BaseException):
    """Raised in an interpreted algorithm when its machine code has been loaded."""


class WatchedCall:
    """An algorithm that a thread is interpreting."""

    def __init__(self, specialization: "Specialization") -> None:
        self.specialization = specialization
        self.thread = threading.get_ident()
        self.began = time.perf_counter()
        self.lock = threading.Lock()
        self.is_closed = self.is_interrupted = False
        NUMBA_THREAD.watch(self)

    def check(self) -> None:
        """Load, interrupt or request compilation, depending on the time that the call has taken."""
        from .store import AWAITED
        from .tiers import IMPORTING

        call, seconds = self.specialization, time.perf_counter() - self.began
        if seconds > IMPORTING and not call.is_loaded and call.is_on_disk():
            call.load_here()
        if call.is_loaded:
            self.interrupt()
        else:
            call.request_after(call.spent + seconds, AWAITED)

    def interrupt(self) -> None:
        """Interrupt the interpreted call, unless it has ended."""
        with self.lock:
            if not self.is_closed and not self.is_interrupted:
                self.is_interrupted = True
                raise_in(self.thread, MachineCodeLoaded)

    def close(self) -> None:
        """End the watch after the call, and withdraw an interruption that is still to come."""
        NUMBA_THREAD.unwatch(self)
        with self.lock:
            self.is_closed = True
        if self.is_interrupted:
            withdraw_exception()


class NumbaThread:
    """The thread, started when there is work."""

    has_numba = False  # in this process, wholly imported

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Reset to the state without a thread, as after a fork."""
        self.jobs: queue.SimpleQueue[Callable[[], None] | None] = queue.SimpleQueue()
        self.watches: set[WatchedCall] = set()
        self.thread: threading.Thread | None = None
        self.is_idle = True
        self.starting = threading.Lock()
        self.working = threading.Lock()  # held during each job, and during a fork
        self.is_paused = False

    def pause(self) -> None:
        """Wait before a fork until no job is done: the child would get a half-imported numba."""
        if threading.current_thread() is not self.thread and self.working.acquire(
            timeout=LONGEST_WAIT
        ):
            self.is_paused = True

    def resume(self) -> None:
        """Go on in the parent after a fork."""
        if self.is_paused:
            self.is_paused = False
            self.working.release()

    def ensure_running(self) -> None:
        """Start the thread unless it runs, and end its idle state."""
        if self.thread is None:
            with self.starting:
                if self.thread is None:
                    thread = threading.Thread(target=self.run, name="kinoedu", daemon=True)
                    thread.start()
                    self.thread = thread
        if self.is_idle:
            self.jobs.put(None)

    def watch(self, watch: WatchedCall) -> None:
        """Check a watch periodically from now on."""
        self.watches.add(watch)
        self.ensure_running()

    def unwatch(self, watch: WatchedCall) -> None:
        """Stop checking a watch."""
        self.watches.discard(watch)

    def submit(self, work: Callable[[], None]) -> None:
        """Run some work in this thread soon."""
        self.ensure_running()
        self.jobs.put(work)

    def run_and_wait(self, work: Callable[[], None]) -> None:
        """Run some work in this thread and wait for it; raises what the work raises.

        An interruption of the calling thread does not interrupt the work.
        """
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

        self.ensure_running()
        self.jobs.put(job)
        while "done" not in done:
            time.sleep(0.001)
        if "error" in done:
            raise done["error"]

    def run(self) -> None:
        """The loop of the thread."""
        last = time.monotonic()
        while True:
            self.is_idle = not self.watches and time.monotonic() - last > IDLE_INTERVAL
            try:
                job = self.jobs.get(timeout=IDLE_INTERVAL if self.is_idle else POLL_INTERVAL)
            except queue.Empty:
                job = None
            self.is_idle = False
            if job is not None or self.watches:
                last = time.monotonic()
                with self.working, short_turns():
                    self.work(job)

    def work(self, job: Callable[[], None] | None) -> None:
        """Do a job, and check the watched calls."""
        try:
            if job is not None:
                job()
        except Exception:  # such as a full disk; the thread must go on
            log.exception("machine code could not be requested")
        for watch in tuple(self.watches):
            try:
                watch.check()
            except Exception:
                log.exception("an interpreted call could not be watched")
                self.watches.discard(watch)


NUMBA_THREAD = NumbaThread()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        before=NUMBA_THREAD.pause,
        after_in_parent=NUMBA_THREAD.resume,
        after_in_child=NUMBA_THREAD.reset,
    )
