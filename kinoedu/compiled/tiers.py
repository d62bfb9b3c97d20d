"""Two ways to run a function, and which of them is taken.

A call whose machine code is loaded runs it. A call whose code lies on the disk loads it, once this
process has interpreted long enough to pay for importing numba. Every other call is interpreted, at
once, and its time added up: what has cost BUDGET seconds is compiled by another process. So the
total is never much worse than the better of the two, as with skis that one rents until they could
have been bought. An algorithm that is interpreted for longer is begun again, from the arguments as
they were, when its machine code has come.

What an interpreted function calls is interpreted too, and not counted by itself. What no machine
code can be made for (a recorder, a reader's own problem) is interpreted; what that calls is chosen
call by call.
"""

import functools
import importlib.util
import inspect
import logging
import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol, TypeVar, cast

import numpy as np

from ..support.threads import Spent, spent_by
from . import modes, store
from .choices import CALLABLE
from .kinds import Kind, kinds_of

BUDGET = 2.0  # seconds that interpreting one kind of call may cost before it is compiled
IMPORTING = 1.0  # seconds of interpreting, in all, before numba is imported: about what that takes
LOOK_AGAIN = 0.5  # seconds after which it is looked again whether machine code has come

BEGUN, DONE = "compiling %s once", "compiled %s"  # what is logged when a call waits for it

log = logging.getLogger(__name__.partition(".")[0])

F = TypeVar("F", bound=Callable[..., Any])


class Compiled(Protocol):
    """A function with the Python function it was compiled from."""

    py_func: Callable[..., Any]

    def __call__(self, *args: Any) -> Any: ...


class Here(threading.local):
    """What this thread is doing."""

    interpreting = False  # inside an interpreted call whose time is counted


here = Here()
TIERED: list["Tiered"] = []  # all there are
interpreted = Spent()  # by all threads together


class Tiered:
    """A function that runs in the one way or the other."""

    def __init__(
        self, function: Callable[..., Any], *, is_algorithm: bool = False, **options: bool
    ):
        functools.update_wrapper(self, function)
        self.__name__, self.__qualname__ = function.__name__, function.__qualname__
        self.py_func = function
        self.is_algorithm = is_algorithm
        self.options = options
        self.can_be_stored = store.is_digested(function)
        self.machine: Callable[..., Any] | None = None  # runs machine code, once some is loaded
        self.inner: Any = None  # what compiled code calls, in a process that compiles
        self.specializations: dict[tuple[Kind, ...], Specialization] = {}
        TIERED.append(self)

    def __call__(self, *args: Any) -> Any:
        machine = self.machine
        if machine is None or here.interpreting or modes.mode is modes.INTERPRETED:
            return self.without_machine_code(*args)
        return machine(*args)

    def without_machine_code(self, *args: Any) -> Any:
        """Run a call for whose kinds no machine code is loaded."""
        if here.interpreting or modes.mode is modes.INTERPRETED:
            return self.py_func(*args)
        kinds = kinds_of(args)
        if kinds is None:
            return self.py_func(*args)
        specialization = self.specializations.get(kinds)
        if specialization is None:
            specialization = self.specializations[kinds] = Specialization(self, kinds)
        return specialization.run(args)

    def __reduce__(self) -> Any:
        return find, (self.__module__, self.__qualname__)

    def __repr__(self) -> str:
        return f"<compiled function {self.__module__}.{self.__qualname__}>"


def find(module: str, name: str) -> Any:
    """A function of a module."""
    return getattr(importlib.import_module(module), name)


class Specialization:
    """A function for one kind of arguments: what interpreting it has cost, where its code is."""

    def __init__(self, function: Tiered, kinds: tuple[Kind, ...]) -> None:
        self.function = function
        self.kinds = kinds
        self.spent = 0.0
        self.is_loaded = self.is_requested = self.is_tried = False
        self.is_generator = inspect.isgeneratorfunction(function.py_func)
        self.is_never_stored = (
            self.is_generator or not function.can_be_stored or not store.are_digested(kinds)
        )
        self.looked = -np.inf

    def run(self, args: tuple[Any, ...]) -> Any:
        """Run a call, machine code or not."""
        if modes.mode is modes.COMPILED_FIRST and not self.is_tried:
            self.compile_now()
        elif interpreted.seconds > IMPORTING and self.has_come():
            self.load()
        if self.is_loaded and self.function.machine is not None:
            return self.function.machine(*args)
        if self.function.is_algorithm and not self.is_never_stored:
            return self.interpret_until_code_comes(args)
        with self.counted():
            return self.function.py_func(*args)

    @property
    def wanted(self) -> store.Wanted:
        """Its name on the disk."""
        return store.Wanted(self.function.__module__, self.function.__name__, self.kinds)

    @functools.cached_property
    def file(self) -> Path | None:
        """Where its machine code is, or would be."""
        place = None if self.is_never_stored else store.folder()
        return None if place is None else place / f"{self.wanted.name}.code"

    def has_come(self) -> bool:
        """Whether machine code lies on the disk. Looks there now and then only."""
        now = time.monotonic()
        if self.is_never_stored or now < self.looked + LOOK_AGAIN:
            return False
        self.looked = now
        return self.file is not None and self.file.exists()

    def load(self) -> None:
        """Load the machine code from the disk; where it cannot be, the call stays interpreted."""
        from .keeper import KEEPER

        KEEPER.do(self.load_here)

    def load_here(self) -> None:
        """The same in this thread."""
        from .machine import load

        if self.is_loaded or self.file is None:
            return
        try:
            load(self.dispatcher(), self.file)
            self.is_loaded = True
        except Exception:  # damaged, or for another computer: made anew when it pays
            self.is_never_stored = self.is_requested
            self.file.unlink(missing_ok=True)

    def dispatcher(self) -> Any:
        """numba's dispatcher, which is given machine code as it comes."""
        from .machine import new_dispatcher

        if self.function.machine is None:
            self.function.machine = new_dispatcher(
                self.function.py_func, self.function.without_machine_code
            )
        return self.function.machine

    def request(self) -> None:
        """Have it compiled by another process."""
        from .keeper import KEEPER

        if not self.is_requested and not self.is_never_stored:
            self.is_requested = True
            KEEPER.later(self.request_here)

    def request_here(self) -> None:
        """The same in this thread."""
        from .requests import have_compiled

        place = store.folder()
        self.is_never_stored = place is None or not have_compiled(place, self.wanted)

    def compile_now(self) -> None:
        """Compile it and wait: in another process, or here what cannot be kept on the disk. Once:
        what numba cannot compile stays interpreted."""
        from .keeper import KEEPER
        from .requests import wait_for

        self.is_tried = True
        if self.is_generator or self.is_loaded:
            return
        if self.file is not None and self.file.exists():
            self.load()
            return
        log.info(BEGUN, self.function.__name__)
        place = store.folder()
        if self.is_never_stored or place is None:
            KEEPER.do(self.compile_here)
        elif wait_for(place, self.wanted):
            self.load()
        log.info(DONE, self.function.__name__)

    def compile_here(self) -> None:
        """Compile it in this process."""
        from .compiler import compile_entry

        try:
            self.dispatcher().add_overload(compile_entry(self.function, self.kinds))
            self.is_loaded = True
        except Exception as error:
            log.warning("%s stays interpreted: %s", self.function.__name__, error)

    # ---- interpreted ---------------------------------------------------------------------------

    @contextmanager
    def counted(self) -> Iterator[None]:
        """Count the time of the block; what it calls is interpreted."""
        began = time.perf_counter()
        spent = spent_by.setdefault(threading.get_ident(), Spent())
        try:
            here.interpreting, spent.began = True, began
            with np.errstate(all="ignore"):  # machine code does not warn either
                yield
        finally:
            here.interpreting, spent.began = False, None
            seconds = time.perf_counter() - began
            spent.seconds += seconds
            interpreted.seconds += seconds
            self.spent += seconds
            if self.spent > BUDGET:
                self.request()

    def interpret_until_code_comes(self, args: tuple[Any, ...]) -> Any:
        """Interpret an algorithm; where machine code comes first, begin again with that."""
        from .keeper import ChangeOver, Watch

        saved = copied(args)
        watch = Watch(self)
        try:
            try:
                with self.counted():
                    return self.function.py_func(*args)
            finally:
                watch.close()
        except ChangeOver as change:
            if change.__context__ is not None:  # it came while the call was failing already
                raise change.__context__ from None
        restore(args, saved)
        return self.function.machine(*args)  # type: ignore[misc]  # it has just been loaded


def copied(value: Any) -> Any:
    """What an algorithm may change in a value: the content of arrays, a generator's state."""
    if isinstance(value, np.ndarray):
        return value.copy() if value.flags.writeable else None
    if isinstance(value, np.random.Generator):
        return value.bit_generator.state
    return [copied(field) for field in value] if isinstance(value, tuple) else None


def restore(value: Any, saved: Any) -> None:
    """Give a value back what was copied."""
    if saved is None:
        return
    if isinstance(value, np.ndarray):
        value[...] = saved
    elif isinstance(value, np.random.Generator):
        value.bit_generator.state = saved
    else:
        for field, before in zip(value, saved, strict=True):
            restore(field, before)


def called() -> list[store.Wanted]:
    """The algorithms that this process has called from Python and that can be compiled."""
    kinds_of_calls = [s for f in TIERED if f.is_algorithm for s in f.specializations.values()]
    return [s.wanted for s in kinds_of_calls if not s.is_never_stored]


# ---- the decorators -----------------------------------------------------------------------------


def is_there(name: str) -> bool:
    """Whether a package could be imported; it is not."""
    try:
        return importlib.util.find_spec(name) is not None
    except (ImportError, ValueError):
        return False


HAS_COMPILER = os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0") and is_there("numba")


def compiled(function: Callable[..., Any]) -> Compiled:
    """Let a function run as machine code where that is there; `.py_func` is the function itself.

    >>> @compiled
    ... def twice(x):
    ...     return x + x
    >>> twice(2.0) == twice.py_func(2.0)
    True
    """
    return tiered(function)


def inlined(function: Callable[..., Any]) -> Compiled:
    """The same for a short kernel that is handed records: its compiled callers take its code in, so
    that no record is passed on.

    Not for kernels of numbers alone: the compiler knows better which of those to take in.
    """
    return tiered(function, forceinline=True)


def algorithm(function: Callable[..., Any]) -> Compiled:
    """The same for a whole algorithm, which Python starts on a problem.

    It only borrows the arrays it is given: it may write into them, but must return only numbers and
    arrays of its own. A long interpreted run of it is begun again as machine code.
    """
    return tiered(function, is_algorithm=True)


def tiered(function: Callable[..., Any], **how: bool) -> Compiled:
    """A function in two ways; in one where there is no numba. A generator is stepped by Python:
    numba cannot load machine code of generators."""
    if HAS_COMPILER:
        return cast(Compiled, Tiered(function, **how))
    function.py_func = function  # type: ignore[attr-defined]
    return cast(Compiled, function)


def callable_from_compiled(function: F) -> F:
    """Leave `function` as it is in Python, and let compiled code call it too.

    For the steps of an algorithm that are handed a problem: interpreted, they may be handed a
    recorder or a reader's own object.
    """
    CALLABLE.append(function)
    return function
