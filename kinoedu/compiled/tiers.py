"""Functions that run interpreted or as machine code, and the decision between the two.

A call whose machine code is loaded runs it. A call whose machine code is on the disk loads it, once
this process has spent about as long interpreting as the import of numba takes; during that import
calls are interpreted. Every other call is interpreted at once, and its time is added up. After
BUDGET seconds it is compiled by another process. So the total time is never much more than that of
the better way: this is the ski-rental problem of online algorithms. An algorithm that is still
being interpreted when its machine code exists is restarted with its original arguments.

Functions called by an interpreted function are interpreted too, and their time is not counted
separately. A call with arguments that machine code cannot take (a recorder, a user's own problem)
is interpreted; for the functions it calls, the decision is made call by call.
"""

import functools
import importlib.util
import inspect
import logging
import os
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol, TypeVar, cast

import numpy as np

from ..support.threads import ThreadTime, spent_by
from . import modes, store
from .choices import CALLABLE, Function
from .kinds import Kind, kinds_of
from .saved_state import copy_state, restore_state

BUDGET = 2.0  # seconds of interpreting one kind of call before it is compiled
IMPORTING = 1.0  # seconds of interpreting before numba is imported, which takes about as long
LOOK_AGAIN = 0.5  # seconds between two looks for machine code on the disk
ASSUMED = 0.01  # seconds of interpreting before the kinds of arguments are looked at again

BEGUN, DONE = "compiling %s once", "compiled %s"  # log messages of a call that waits

log = logging.getLogger(__name__.partition(".")[0])

F = TypeVar("F", bound=Function)


class Compiled(Protocol):
    """A function with the Python function from which it was compiled."""

    py_func: Function

    def __call__(self, *args: Any) -> Any: ...


class ThreadState(threading.local):
    """What this thread is doing."""

    interpreting = False  # inside an interpreted call whose time is counted


thread_state = ThreadState()
TIERED: list["TieredFunction"] = []  # all of them
interpreted = ThreadTime()  # in all threads together


class TieredFunction:
    """A function that runs interpreted or as machine code."""

    def __init__(self, function: Function, *, is_algorithm: bool = False, **options: bool):
        functools.update_wrapper(self, function)
        self.__name__, self.__qualname__ = function.__name__, function.__qualname__
        self.py_func = function
        self.is_algorithm = is_algorithm
        self.options = options
        self.can_be_stored = store.is_digested(function)
        self.traces = 0  # blocks of in_python that have not ended
        # the dispatcher, once machine code is loaded
        self.machine: Function | None = None
        self.inner: Any = None  # numba's function for compiled callers, in a process that compiles
        self.specializations: dict[tuple[Kind, ...], Specialization] = {}
        self.assumed: dict[tuple[type, ...], Specialization] = {}  # by classes of arguments
        TIERED.append(self)

    def __call__(self, *args: Any) -> Any:
        if thread_state.interpreting or self.traces or modes.mode is modes.INTERPRETED:
            return self.py_func(*args)
        machine = self.machine
        return self.without_machine_code(*args) if machine is None else machine(*args)

    def without_machine_code(self, *args: Any) -> Any:
        """Run a call while no machine code is loaded.

        To find the kinds of arguments takes longer than most short calls. So they are assumed to be
        those of earlier arguments of the same classes, and are looked at again from time to time.
        """
        specialization = self.assumed.get(tuple(map(type, args)))
        if specialization is None or specialization.spent > specialization.assumed_until:
            return self.without_machine_code_for_kinds(*args)
        return specialization.run(args)

    def without_machine_code_for_kinds(self, *args: Any) -> Any:
        """Run a call for whose kinds no machine code is loaded."""
        kinds = kinds_of(args)
        if kinds is None:
            return self.py_func(*args)
        specialization = self.specializations.get(kinds)
        if specialization is None:
            specialization = self.specializations[kinds] = Specialization(self, kinds)
        if not self.is_algorithm:
            specialization.assumed_until = specialization.spent + ASSUMED
            self.assumed[tuple(map(type, args))] = specialization
        return specialization.run(args)

    def __reduce__(self) -> Any:
        return find_function, (self.__module__, self.__qualname__)

    def __repr__(self) -> str:
        return f"<compiled function {self.__module__}.{self.__qualname__}>"


@contextmanager
def in_python(*functions: Any) -> Iterator[None]:
    """Run these functions interpreted, so that their lines can be traced.

    The functions that they call run as always. It holds in all threads.

    Examples
    --------
    >>> from kinoedu.graphs.paths import extract_path
    >>> with in_python(extract_path):
    ...     extract_path([-1, 0, 1], 2)
    array([0, 1, 2])
    """
    tiered = [function for function in functions if isinstance(function, TieredFunction)]
    for function in tiered:
        function.traces += 1
    try:
        yield
    finally:
        for function in tiered:
            function.traces -= 1


def find_function(module: str, name: str) -> Any:
    """A function of a module, by name."""
    return getattr(importlib.import_module(module), name)


class Specialization:
    """A function for given kinds of arguments: the time spent interpreting it, its machine code."""

    def __init__(self, function: TieredFunction, kinds: tuple[Kind, ...]) -> None:
        self.function = function
        self.kinds = kinds
        self.spent = self.requested_after = 0.0  # seconds of interpreting
        self.assumed_until = 0.0  # by `spent`
        self.is_loaded = self.is_tried = False
        self.is_generator = inspect.isgeneratorfunction(function.py_func)
        self.is_never_stored = (
            self.is_generator or not function.can_be_stored or not store.are_digested(kinds)
        )
        self.looked = -np.inf

    def run(self, args: tuple[Any, ...]) -> Any:
        """Run a call in the better way."""
        if modes.mode is modes.COMPILED_FIRST and not self.is_tried:
            self.compile_now()
        elif interpreted.seconds > IMPORTING and self.is_on_disk():
            self.load_or_import()
        if self.is_loaded and self.function.machine is not None:
            return self.function.machine(*args)
        if self.function.is_algorithm and not self.is_never_stored:
            return self.interpret_or_restart(args)
        return self.interpret(args)

    @property
    def to_compile(self) -> store.Request:
        """The request for its machine code."""
        return store.Request(self.function.__module__, self.function.__name__, self.kinds)

    @functools.cached_property
    def file(self) -> Path | None:
        """The file of its machine code, which may not exist yet."""
        place = None if self.is_never_stored else store.folder()
        return None if place is None else place / f"{self.to_compile.name}.code"

    def is_on_disk(self) -> bool:
        """Whether machine code is on the disk; looks only every LOOK_AGAIN seconds."""
        now = time.monotonic()
        if self.is_never_stored or now < self.looked + LOOK_AGAIN:
            return False
        self.looked = now
        return self.file is not None and self.file.exists()

    def load_or_import(self) -> None:
        """`load` if numba is imported; if not, import it and load while calls are interpreted."""
        from .numba_thread import NUMBA_THREAD

        if NUMBA_THREAD.has_numba:
            self.load()
        else:
            NUMBA_THREAD.submit(self.load_here)

    def load(self) -> None:
        """Load the machine code from the disk; if that fails, the call stays interpreted."""
        from .numba_thread import NUMBA_THREAD

        NUMBA_THREAD.run_and_wait(self.load_here)

    def load_here(self) -> None:
        """`load` in this thread."""
        from . import compiler  # noqa: F401  # teaches numba its types before any call
        from .machine import load
        from .numba_thread import NUMBA_THREAD

        NUMBA_THREAD.has_numba = True
        if self.is_loaded or self.file is None:
            return
        try:
            machine = self.dispatcher()
            load(machine, self.file)
            self.begin_to_use(machine)
        except Exception:  # damaged, or for another computer: made again when it pays
            self.is_never_stored = self.requested_after > 0.0
            self.file.unlink(missing_ok=True)

    def dispatcher(self) -> Any:
        """numba's dispatcher, to which machine code is added as it is loaded."""
        from .machine import new_dispatcher

        return self.function.machine or new_dispatcher(
            self.function.py_func, self.function.without_machine_code_for_kinds
        )

    def begin_to_use(self, machine: Any) -> None:
        """Call the dispatcher from now on; another thread's call while numba loads would fail."""
        self.function.machine = machine
        self.is_loaded = True

    def request_after(self, seconds: float, queue: str = store.WANTED) -> None:
        """Request its compilation by another process if interpreting has taken long.

        Request it again if the time has doubled: the worker may have ended without a look at it.
        `queue` is AWAITED where a call waits for it; other requests give way.
        """
        if seconds > max(BUDGET, 2.0 * self.requested_after) and not self.is_never_stored:
            from .numba_thread import NUMBA_THREAD

            self.requested_after = seconds
            NUMBA_THREAD.submit(lambda: self.request_here(queue))

    def request_here(self, queue: str) -> None:
        """Request its compilation, in this thread."""
        from .requests import request_compilation

        place = store.folder()
        is_expected = place is not None and request_compilation(place, queue, self.to_compile)
        self.is_never_stored = not is_expected

    def compile_now(self) -> None:
        """Compile it and wait, at most once; what numba cannot compile stays interpreted.

        Another process compiles it, or this one if it cannot be stored on the disk.
        """
        from .numba_thread import NUMBA_THREAD
        from .requests import compile_and_wait

        self.is_tried = True
        if self.is_generator or self.is_loaded:
            return
        if self.file is not None and self.file.exists():
            self.load()
            return
        log.info(BEGUN, self.function.__name__)
        place = store.folder()
        if self.is_never_stored or place is None:
            NUMBA_THREAD.run_and_wait(self.compile_here)
        elif compile_and_wait(place, self.to_compile):
            self.load()
        log.info(DONE, self.function.__name__)

    def compile_here(self) -> None:
        """Compile it in this process."""
        from .compiler import compile_entry

        try:
            machine = self.dispatcher()
            machine.add_overload(compile_entry(self.function, self.kinds))
            self.begin_to_use(machine)
        except Exception as error:
            log.warning("%s stays interpreted: %s", self.function.__name__, error)

    # ---- interpreted ---------------------------------------------------------------------------

    def interpret(self, args: tuple[Any, ...]) -> Any:
        """Interpret a call and count its time; functions called in it are interpreted."""
        thread = threading.get_ident()
        spent = spent_by.get(thread) or spent_by.setdefault(thread, ThreadTime())
        began = time.perf_counter()
        thread_state.interpreting, spent.began = True, began
        try:
            with np.errstate(all="ignore"):  # as machine code, which does not warn
                return self.function.py_func(*args)
        finally:
            thread_state.interpreting, spent.began = False, None
            seconds = time.perf_counter() - began
            spent.seconds += seconds
            interpreted.seconds += seconds
            self.spent += seconds
            self.request_after(self.spent)

    def interpret_or_restart(self, args: tuple[Any, ...]) -> Any:
        """Interpret an algorithm; if its machine code is loaded meanwhile, restart with that."""
        from .numba_thread import MachineCodeLoaded, WatchedCall

        saved, handled = copy_state(args), sys.exc_info()[1]  # what the caller handles already
        watch = WatchedCall(self)
        try:
            try:
                return self.interpret(args)
            finally:
                watch.close()
        except MachineCodeLoaded as change:
            failing = change.__context__
            if failing is not None and failing is not handled:  # raised while the call was failing
                raise failing from None
        restore_state(args, saved)
        return self.function.machine(*args)  # type: ignore[misc]  # it was loaded just now


# ---- the decorators -----------------------------------------------------------------------------


def can_import(name: str) -> bool:
    """Whether a package can be imported; does not import it."""
    try:
        return importlib.util.find_spec(name) is not None
    except (ImportError, ValueError):
        return False


HAS_COMPILER = os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0") and can_import("numba")


def compiled(function: Function) -> Compiled:
    """Let a function run as machine code where that exists; `.py_func` is the Python function.

    Examples
    --------
    >>> @compiled
    ... def twice(x):
    ...     return x + x
    >>> twice(2.0) == twice.py_func(2.0)
    True
    """
    return make_tiered(function)


def inlined(function: Function) -> Compiled:
    """`compiled` for a short kernel that takes records: its compiled callers inline its code.

    So no record is passed on. Which kernels that take numbers only are inlined, the compiler mostly
    decides better. Dubins' curves are an exception; benchmarks/curves.py measures what they gain.
    """
    return make_tiered(function, forceinline=True)


def algorithm(function: Function) -> Compiled:
    """`compiled` for a whole algorithm, which Python starts on a problem.

    It borrows the arrays of its arguments: it may write into them, but must return only numbers and
    its own arrays. A long interpreted run is restarted as machine code.
    """
    return make_tiered(function, is_algorithm=True)


def make_tiered(function: Function, **how: bool) -> Compiled:
    """Make a function that runs in two ways, or the function itself if numba is not available.

    A generator is always interpreted, because numba cannot load machine code of generators.
    """
    if HAS_COMPILER:
        return cast(Compiled, TieredFunction(function, **how))
    function.py_func = function  # type: ignore[attr-defined]
    return cast(Compiled, function)


def callable_from_compiled(function: F) -> F:
    """Leave a function unchanged in Python, and let compiled code call it too.

    It is for steps of an algorithm that take a problem: interpreted, they accept a recorder or a
    user's own object.
    """
    CALLABLE.append(function)
    return function
