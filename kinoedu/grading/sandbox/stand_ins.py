"""What a notebook has and the process of a student's program has not.

There are no pictures, no widgets, no machine code, no shell and no threads. Programs that use them
are not wrong, so each has a stand-in: pictures and commands do nothing, numba leaves functions as
they are, and what a thread should do is done at once. This module needs only Python's standard
library and numpy.
"""

import concurrent.futures.thread
import importlib.machinery
import multiprocessing.pool
import re
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np

PICTURES = ("matplotlib", "mpl_toolkits", "pylab")
NEVER_THERE = (
    *("IPython", "ipywidgets", "anywidget", "ipympl", "matplotlib_inline"),
    *("plotly", "seaborn", "bokeh", "altair", "pyvista", "tqdm"),
)
# magics that run their line or the rest of their cell, and options before such a line
RUNS_LINE, RUNS_CELL = ("time", "prun"), ("time", "timeit", "prun", "capture")
PRUN_OPTIONS = re.compile(r"^(-[qr] +|-[lsTD] *\S+ +)*")
# how many things a call of a picture's method returns, where programs unpack them
RETURNED = {
    name: count
    for count, names in (
        (1, "plot plot3D semilogx semilogy loglog step fill"),
        (2, "get_xlim get_ylim xlim ylim xticks yticks get_size_inches get_legend_handles_labels"),
        (2, "pie"),
        (3, "hist errorbar"),
        (4, "hist2d axis acorr xcorr"),
    )
    for name in names.split()
}


class Silent:
    """A thing that does nothing, whatever a program does with it.

    Every attribute, item and result is again such a thing. As a number it is 0, and it holds
    nothing, or as many things as its method is known to return. Functions are returned as they
    are, so that it decorates too.

    >>> figure = Silent()
    >>> left, right = figure.subplots(1, 2)
    >>> (line,) = left.plot([0, 1], "r")
    >>> float(line), list(left.patches)
    (0.0, [])
    """

    _name: str = ""
    _items: Any = ()

    def __init__(self, *_: Any, **__: Any) -> None:
        pass

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return make_silent(name)

    def __call__(self, *args: Any, **named: Any) -> Any:
        if len(args) == 1 and not named and isinstance(args[0], FunctionType | type):
            return args[0]
        return make_silent("", tuple(Silent() for _ in range(RETURNED.get(self._name, 0))))

    def subplots(self, nrows: int = 1, ncols: int = 1, *, squeeze: bool = True, **_: Any) -> Any:
        """The axes of a figure: one, or an array of them with the shape that it would have."""
        axes = np.empty((nrows, ncols), object)
        for at in np.ndindex(nrows, ncols):
            axes[at] = Silent()
        return axes if not squeeze else axes[0, 0] if axes.size == 1 else np.squeeze(axes)

    def __iter__(self) -> Iterator[Any]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def __getitem__(self, at: Any) -> Any:
        return Silent()

    def do_nothing(self, *_: Any) -> None:
        """Do nothing."""

    __setitem__ = __delitem__ = __exit__ = do_nothing

    def return_silent(self, *_: Any) -> Any:
        """Return another silent thing, as the result of any operator."""
        return Silent()

    __add__ = __sub__ = __mul__ = __truediv__ = __floordiv__ = __mod__ = __pow__ = return_silent
    __radd__ = __rsub__ = __rmul__ = __rtruediv__ = __rpow__ = __or__ = __ror__ = return_silent
    __neg__ = __abs__ = __round__ = __and__ = __matmul__ = return_silent

    def return_false(self, *_: Any) -> bool:
        """Return False, as the result of any comparison."""
        return False

    __lt__ = __le__ = __gt__ = __ge__ = __bool__ = __contains__ = __instancecheck__ = return_false

    def return_zero(self) -> int:
        """Return 0, the number that it is."""
        return 0

    __int__ = __index__ = return_zero

    def __float__(self) -> float:
        return 0.0

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.zeros((), dtype)

    def __enter__(self) -> Any:
        return self

    def __mro_entries__(self, bases: Any) -> tuple[type, ...]:
        return (Silent,)  # so a class may be derived from it

    def __repr__(self) -> str:
        return "<picture>"

    def __format__(self, how: str) -> str:
        return "0"


def make_silent(name: str, items: tuple[Any, ...] = ()) -> Silent:
    """A silent thing with a name, which may decide what it returns, or with items."""
    thing = Silent()
    thing.__dict__.update(_name=name, _items=items)
    return thing


def draw_subplots(*args: Any, **named: Any) -> tuple[Silent, Any]:
    """pyplot's `subplots`: a figure and its axes."""
    return Silent(), Silent().subplots(*args, **named)


def draw_mosaic(*_: Any, **__: Any) -> tuple[Silent, Silent]:
    """pyplot's `subplot_mosaic`: a figure and its axes by name."""
    return Silent(), Silent()


class SilentModule(ModuleType):
    """A module whose every name is a silent thing, but for those that it was given."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return make_silent(name)


class StandInFinder:
    """An import finder for the packages that have stand-ins, and all their modules."""

    def __init__(self, packages: Iterable[str], things: dict[str, dict[str, Any]]) -> None:
        self.packages, self.things = set(packages), things

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        """The spec of a stand-in, or None where the module is another one."""
        if name.partition(".")[0] not in self.packages:
            return None
        return importlib.machinery.ModuleSpec(name, self, is_package=True)  # type: ignore[arg-type]

    def create_module(self, spec: Any) -> ModuleType:
        """A module of silent things, with the names that its package's stand-in has."""
        module = SilentModule(spec.name)
        vars(module).update(self.things.get(spec.name.partition(".")[0], {}))
        return module

    def exec_module(self, module: ModuleType) -> None:
        """Do nothing, as the module is complete."""


def decorate_or_return(*args: Any, **_: Any) -> Any:
    """A decorator that leaves functions as they are, used as `@njit` and as `@njit(cache=True)`."""
    is_decorated = len(args) == 1 and isinstance(args[0], FunctionType | type)
    return args[0] if is_decorated else lambda function: function


def vectorize(*args: Any, **_: Any) -> Any:
    """numba's `vectorize`, with and without arguments: the function of each element."""
    return np.vectorize(args[0]) if args and isinstance(args[0], FunctionType) else np.vectorize


class TypedList(list[Any]):
    """numba.typed.List, as a list."""

    empty_list = classmethod(lambda cls, *_: cls())


class TypedDict(dict[Any, Any]):
    """numba.typed.Dict, as a dict."""

    empty = classmethod(lambda cls, *_, **__: cls())


class Progress(Silent):
    """tqdm's progress bar: what it counts, without the bar."""

    def __init__(self, iterable: Iterable[Any] = (), *_: Any, **__: Any) -> None:
        self.__dict__["_items"] = iterable


PICTURE_THINGS = {"subplots": draw_subplots, "subplot_mosaic": draw_mosaic}
THINGS: dict[str, dict[str, Any]] = {
    "matplotlib": PICTURE_THINGS,
    "pylab": PICTURE_THINGS,
    "tqdm": {"tqdm": Progress, "trange": lambda *ends, **_: Progress(range(*ends))},
    "numba": {
        **dict.fromkeys(("njit", "jit", "jitclass", "stencil"), decorate_or_return),
        "vectorize": vectorize,
        "prange": range,
        "List": TypedList,
        "Dict": TypedDict,
        "typed": SimpleNamespace(List=TypedList, Dict=TypedDict),
    },
}


class NotebookShell(Silent):
    """What `get_ipython()` returns; it runs the code of magics such as `%time` and nothing else.

    `collect/left_out.py` lists the other commands, for people to read.
    """

    def __init__(self, space: dict[str, Any]) -> None:
        self.user_ns = space

    def run_line_magic(self, name: str, line: str = "", *_: Any, **__: Any) -> Any:
        """Run the line of `%time` and the like, and return its value if it is an expression."""
        if name in RUNS_LINE:
            with suppress(SyntaxError):
                return self.run_code(PRUN_OPTIONS.sub("", line) if name == "prun" else line)
        return Silent()

    def run_cell_magic(self, name: str, line: str = "", cell: str = "", *_: Any, **__: Any) -> None:
        """Run the cell of `%%time` and the like."""
        if name in RUNS_CELL:
            with suppress(SyntaxError):
                self.run_code(cell)

    def run_code(self, code: str) -> Any:
        """Run code in the notebook's namespace, and return its value if it is an expression."""
        try:
            value = compile(code.strip(), "<magic>", "eval")
        except SyntaxError:
            exec(compile(code, "<magic>", "exec"), self.user_ns)
            return None
        return eval(value, self.user_ns)

    def magic(self, line: str = "") -> Any:
        """Run a magic that is written in one text."""
        name, _, rest = line.lstrip("%").partition(" ")
        return self.run_line_magic(name, rest)

    def system(self, command: str = "", *_: Any, **__: Any) -> None:
        """Leave out a command of the shell."""

    def getoutput(self, command: str = "", *_: Any, **__: Any) -> list[str]:
        """Leave out a command of the shell, which has no output."""
        return []


class Executor(concurrent.futures.Executor):
    """An executor that makes each call at once, in place of those with threads or processes."""

    def __init__(self, *_: Any, **__: Any) -> None:
        pass

    def submit(self, function: Callable[..., Any], /, *args: Any, **named: Any) -> Any:
        """Call the function, and return a future that is done."""
        future = concurrent.futures.Future[Any]()
        try:
            future.set_result(function(*args, **named))
        except Exception as error:
            future.set_exception(error)
        return future


class Result:
    """What a call of a pool returned, or the exception that it raised."""

    def __init__(self, future: Any) -> None:
        self.get = future.result

    def wait(self, *_: Any) -> None:
        """Return, as the call is over."""


class Pool:
    """A pool of `multiprocessing` that makes each call at once."""

    def __init__(self, *_: Any, **__: Any) -> None:
        pass

    def apply_async(
        self, function: Any, args: Any = (), kwds: dict[str, Any] | None = None, *_: Any
    ) -> Result:
        """Call the function, and return its result as one that was waited for."""
        return Result(Executor().submit(function, *args, **(kwds or {})))

    def apply(self, function: Any, args: Any = (), kwds: dict[str, Any] | None = None) -> Any:
        """Call the function."""
        return function(*args, **(kwds or {}))

    def map(self, function: Any, values: Any, *_: Any, **__: Any) -> list[Any]:
        """Call the function for each value."""
        return [function(value) for value in values]

    def starmap(self, function: Any, values: Any, *_: Any, **__: Any) -> list[Any]:
        """Call the function for each tuple of arguments."""
        return [function(*value) for value in values]

    def imap(self, function: Any, values: Any, *_: Any, **__: Any) -> Iterator[Any]:
        """Call the function for each value, one after another."""
        return map(function, values)

    imap_unordered = imap

    def map_async(self, function: Any, values: Any, *_: Any, **__: Any) -> Result:
        """Call the function for each value, and return the results as one."""
        return self.apply_async(self.map, (function, values))

    def close(self) -> None:
        """Do nothing, as no process was started."""

    join = terminate = close

    def __enter__(self) -> "Pool":
        return self

    def __exit__(self, *_: Any) -> None:
        pass


class Thread(threading.Thread):
    """A thread that does its work when it is started, before `start` returns."""

    def start(self) -> None:
        """Run; an exception ends the thread and not the program, as usual."""
        with suppress(Exception):
            self.run()

    def join(self, timeout: float | None = None) -> None:
        """Return, as the thread is over."""

    def is_alive(self) -> bool:
        """Whether it runs: never, as it is over or not started yet."""
        return False


def install(space: dict[str, Any], *, has_pictures: bool = False) -> None:
    """Put the stand-ins in place.

    Call it only in the process of a student's program, since it changes Python's own modules.

    Parameters
    ----------
    space : the namespace of the notebook, which gets `get_ipython` and `display`.
    has_pictures : whether matplotlib itself is there, and is to be used.
    """
    shell = NotebookShell(space)
    space.update(get_ipython=lambda: shell, display=Silent().do_nothing)
    things = {"IPython": {"get_ipython": space["get_ipython"]}, **THINGS}
    packages = {*NEVER_THERE, "numba", *(() if has_pictures else PICTURES)}
    for name in [name for name in sys.modules if name.partition(".")[0] in packages]:
        del sys.modules[name]
    sys.meta_path.insert(0, StandInFinder(packages, things))
    for home in (concurrent.futures, concurrent.futures.thread):
        vars(home).update(ThreadPoolExecutor=Executor, ProcessPoolExecutor=Executor)
    for home in (multiprocessing, multiprocessing.pool):
        vars(home).update(Pool=Pool, ThreadPool=Pool)
    threading.Thread = Thread  # type: ignore[misc]
