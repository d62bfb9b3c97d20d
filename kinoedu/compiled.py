"""The one door to numba: the lines a student reads are the lines that run, at the speed of C.

`compiled` turns a function into machine code the first time it is called with a new kind of argument, and keeps that code on
disk for the next process; `body` does so for a whole algorithm. What was compiled stays reachable in Python as `.py_func`, and
gives the same numbers.

`generic` makes a question that each kind of record answers in its own way; `record` lets compiled code call a record's methods.
A *record* is a NamedTuple of arrays, numbers and records: the one kind of object that Python and compiled code share.

Without numba, or under NUMBA_DISABLE_JIT=1, everything still works and gives the same answers, slowly.

The cache. numba notices a change in a compiled function's own file only, never in what it calls. So code is kept in a folder named
by a digest of the sources that it may be made of (`cache.py`), for functions and records of this package only. Where no folder can
be written, code is compiled anew in each process.
"""

import functools
import inspect
import logging
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol, TypeVar, cast

from .cache import cache_folder, is_digested, is_ours
from .errors import DuplicateKind

try:
    import numba
    from numba.core import cgutils
    from numba.core.caching import FunctionCache
    from numba.extending import intrinsic, overload, overload_method, register_jitable
except ImportError:  # pragma: no cover - tried in a process of its own
    numba = None

JIT = numba is not None and not numba.config.DISABLE_JIT

log = logging.getLogger(__name__.partition(".")[0])

F = TypeVar("F", bound=Callable[..., Any])
C = TypeVar("C", bound=type)


class Compiled(Protocol):
    """A function with the Python body it was compiled from."""

    py_func: Callable[..., Any]

    def __call__(self, *args: Any) -> Any: ...


CACHE = cache_folder(Path(__file__).parent) if JIT else None


if JIT:

    class _PackageCache(FunctionCache):
        """Keeps code on disk only where the package's sources determine it: a record from elsewhere brings code from elsewhere.
        Opened when its function is first called: that looks at the disk, and a program calls few of all functions."""

        is_body = is_open = False

        def __init__(self, source: Callable[..., Any]) -> None:
            self._source, self._cache_path = source, str(CACHE)

        def open(self) -> None:
            previous, numba.config.CACHE_DIR = numba.config.CACHE_DIR, str(CACHE)
            try:
                super().__init__(self._source)
            except RuntimeError:  # the folder has gone: compiled anew in each process
                self._name, self._enabled = self._source.__qualname__, False
            finally:
                numba.config.CACHE_DIR = previous
            self.is_open = True

        def load_overload(self, sig: Any, target_context: Any) -> Any:
            if not self.is_open:
                self.open()
            found = super().load_overload(sig, target_context) if all(map(is_ours, sig)) else None
            if found is None and self.is_body:
                log.info("compiling %s once; the next run starts at once", self._name.rpartition(".")[2])
            return found

        def save_overload(self, sig: Any, data: Any) -> None:
            loadable = not isinstance(data.signature.return_type, numba.types.Generator)  # numba fails to call one from new code
            if loadable and all(map(is_ours, data.signature.args)):
                super().save_overload(sig, data)

    @intrinsic
    def borrowed(typing_context: Any, value: Any) -> Any:
        """The same record or tuple, its arrays without owners."""

        def disowned(context: Any, builder: Any, kind: Any, item: Any) -> Any:
            if isinstance(kind, numba.types.Array):
                array = cgutils.create_struct_proxy(kind)(context, builder, value=item)
                array.meminfo = cgutils.get_null_value(array.meminfo.type)
                array.parent = cgutils.get_null_value(array.parent.type)
                return array._getvalue()
            if isinstance(kind, numba.types.BaseTuple):
                items = zip(kind, cgutils.unpack_tuple(builder, item), strict=True)
                return context.make_tuple(builder, kind, [disowned(context, builder, k, i) for k, i in items])
            context.nrt.incref(builder, kind, item)
            return item

        def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            return disowned(context, builder, signature.args[0], args[0])

        return value(value), generate


INLINED = {"forceinline": True, "error_model": "numpy"}
OPTIONS = {"nogil": True, "error_model": "numpy"}  # numpy: a float divided by zero is inf, without a check at every division


def compiled(function: Callable[..., Any]) -> Compiled:
    """Compile `function` at its first call for each kind of arguments; `.py_func` is the Python it came from.

    >>> @compiled
    ... def twice(x):
    ...     return x + x
    >>> twice(2.0) == twice.py_func(2.0)
    True
    """
    return _dispatcher(function, function)


def inlined(function: Callable[..., Any]) -> Compiled:
    """The same for a short kernel that is handed records: its compiled callers take its code in, so that no record is passed on.

    Not for kernels of numbers alone: the compiler knows better which of those to take in.
    """
    return _dispatcher(function, function, forceinline=True)


def body(function: Callable[..., Any]) -> Compiled:
    """Compile the whole body of an algorithm, which Python starts on a problem.

    A body only borrows the arrays it is given: nothing counts references to them while it runs, which makes planners two and a half
    times faster. It may write into them, but must return only numbers and arrays of its own.
    """
    if not JIT:
        return compiled(function)
    whole = numba.njit(forceinline=True, **OPTIONS)(function)

    # written out with a name for each argument: numba takes 0.2 ms to look at an *args tuple that holds a Generator
    names = ", ".join(inspect.signature(function).parameters)
    scope: dict[str, Any] = {"whole": whole, "borrowed": borrowed, "__name__": function.__module__}
    exec(f"def start({names}): return whole(*borrowed(({names},)))", scope)
    dispatcher = _dispatcher(scope["start"], function)
    dispatcher.py_func = function
    dispatcher._cache.is_body = True  # type: ignore[attr-defined]
    return dispatcher


def _dispatcher(function: Callable[..., Any], source: Callable[..., Any], **options: bool) -> Compiled:
    """numba's dispatcher for `function`, whose code on disk goes by the name of `source`."""
    if not JIT:
        function.py_func = function  # type: ignore[attr-defined]
        return cast(Compiled, function)
    dispatcher = numba.njit(**OPTIONS, **options)(function)
    if CACHE is not None and is_digested(source):
        dispatcher._cache = _PackageCache(source)
    return cast(Compiled, dispatcher)


def callable_from_compiled(function: F) -> F:
    """Leave `function` as it is in Python, and let compiled code call it too.

    For the steps of an algorithm that are handed a problem: interpreted, they may be handed a recorder or a reader's own object.
    """
    return cast(F, register_jitable(function)) if JIT else function


def generic(records: int) -> Callable[[Callable[..., Any]], Any]:
    """Make a question whose answer depends on the kinds of its first `records` arguments.

    The decorated function answers for kinds that have registered no answer of their own. Answers are plain functions: compiled
    code takes them in, the interpreter runs them.

    >>> @generic(1)
    ... def legs(animal):
    ...     return 0
    >>> @legs.register(int)
    ... def legs_of_a_number(animal):
    ...     return animal
    >>> legs(4), legs("snake")
    (4, 0)
    """

    def make(default: Callable[..., Any]) -> Any:
        answers: dict[tuple[type, ...], Callable[..., Any]] = {}

        @functools.wraps(default)
        def ask(*args: Any) -> Any:
            return answers.get(tuple(map(type, args[:records])), default)(*args)

        def register(*kinds: type) -> Callable[[F], F]:
            def keep(answer: F) -> F:
                if kinds in answers:
                    names = ", ".join(kind.__name__ for kind in kinds)
                    raise DuplicateKind(f"{default.__name__} already has an answer for ({names}); register a kind of your own")
                answers[kinds] = answer
                return answer

            return keep

        def choose(*args: Any) -> Callable[..., Any]:
            return answers.get(tuple(getattr(arg, "instance_class", arg) for arg in args[:records]), default)

        if JIT:
            overload(ask, strict=False, jit_options=INLINED)(choose)
        ask.register = register  # type: ignore[attr-defined]
        return ask

    return make


_methods: dict[str, dict[type, Callable[..., Any]]] = {}


def record(record_class: C) -> C:
    """Let compiled code call the methods of a NamedTuple class, as Python can.

    >>> from typing import NamedTuple
    >>> @record
    ... class Circle(NamedTuple):
    ...     radius: float
    ...     def area(self):
    ...         return 3.0 * self.radius * self.radius
    >>> @compiled
    ... def area_of(circle):
    ...     return circle.area()
    >>> area_of(Circle(2.0))
    12.0
    """
    for name, method in vars(record_class).items():
        if callable(method) and not name.startswith("_"):
            if name not in _methods:
                _methods[name] = {}
                if JIT:
                    overload_method(numba.types.BaseNamedTuple, name, strict=False, jit_options=INLINED)(_chooser(name, method))
            _methods[name][record_class] = method
    return record_class


def _chooser(name: str, method: Callable[..., Any]) -> Callable[..., Any]:
    def choose(self: Any, *args: Any) -> Callable[..., Any] | None:
        return _methods[name].get(getattr(self, "instance_class", type(None)))

    choose.__signature__ = inspect.signature(method)  # type: ignore[attr-defined]  # numba folds arguments by it
    return choose
