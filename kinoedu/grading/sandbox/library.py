"""The library as a student's program finds it in the sandbox: only what it uses is loaded, and what
it is to write is withheld.

Withholding stops a program from calling the answer. It does not hide it: the library is open, and
copying is for people to judge.
"""

import functools
import gc
import importlib
import importlib.machinery
import importlib.util
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

HERE = Path(__file__).resolve().parent.parent.parent


class Withheld(Exception):
    """A program called the very function that it is to write."""


USUAL = (
    *(
        "numpy",
        "numpy.ma",
        "numpy.random",
    ),  # the last two numpy would load at their first use, in each program again
    *(
        "kinoedu.geometry",
        "kinoedu.course.judging",
        "kinoedu.course.drawn",
        "kinoedu.course.whole_shapes",
    ),
)
JUDGES, LESSONS = "kinoedu.course.lessons", HERE / "course" / "lessons"
WITHHELD: set[tuple[str, ...]] = set()  # modules and names


def open_library() -> None:
    """Make `import kinoedu` quick, and let functions be withheld. For a process that runs nothing
    else.
    """
    stand_for("kinoedu", HERE, {}, own=True)
    stand_for("kinoedu.course", HERE / "course", {"check": nothing, "show": nothing}, own=False)
    stand_for(JUDGES, LESSONS, {}, own=False)
    for room in rooms():
        stand_for(f"{JUDGES}.{room}", LESSONS / room, {}, own=False)
    sys.meta_path.insert(0, Withholding())


def rooms() -> list[str]:
    """The names of the rooms of the lessons."""
    return [place.parent.name for place in LESSONS.glob("*/__init__.py")]


def withhold(names: Iterable[str]) -> None:
    """Withhold functions, named as "module:name", from programs that are run from now on."""
    WITHHELD.update(tuple(name.split(":")) for name in names)
    for module in [
        module for name, module in sys.modules.items() if name.partition(".")[0] == "kinoedu"
    ]:
        take_out(module)


def own_call(name: str) -> Callable[..., Any]:
    """How an exercise calls a function, "" for with its arguments, else "module:Class.call": that
    alone, and of its module no more than its lines name, since what else stands there knows the
    answers.
    """
    if not name:
        return lambda function, arguments: function(*arguments.values())
    home, _, place = name.partition(":")
    module = importlib.import_module(home)
    call = functools.reduce(getattr, place.split("."), module)
    things = {"__name__": home, "__package__": module.__package__}
    things |= {
        thing: vars(module)[thing] for thing in call.__code__.co_names if thing in vars(module)
    }
    return functools.partial(FunctionType(call.__code__, things), None)


def without_judges(lent: Iterable[str]) -> list[str]:
    """Forget every exercise's judge, and keep of their modules only functions that an assignment
    lends, named as "module:name", such as a wrong program that is to be exposed. Returns the
    folders of the judges, to be hidden.
    """
    things = [
        (home, name, getattr(importlib.import_module(home), name))
        for home, name in (place.split(":") for place in lent)
    ]
    judges = [
        module
        for module in sys.modules
        if module.startswith(JUDGES + ".") and module.count(".") > JUDGES.count(".") + 1
    ]
    for name in judges:
        module, (room, _, last) = sys.modules.pop(name), name.rpartition(".")
        vars(sys.modules[room]).pop(last, None)
        for thing in [
            thing for thing, value in vars(module).items() if hasattr(value, "value_verdict")
        ]:
            delattr(module, thing)
    for home, name, thing in things:
        setattr(sys.modules.setdefault(home, ModuleType(home)), name, thing)
    if judges:
        gc.collect()
    return [str(LESSONS)]


def nothing(*_: Any, **__: Any) -> None:
    """A check that says nothing: what is judged is judged elsewhere."""


class Later(ModuleType):
    """A package whose own file is run when something of it is asked for, so that its modules can be
    had without it.
    """

    def __getattr__(self, name: str) -> Any:
        spec = self.__spec__
        if spec is None or spec.loader is None or name.startswith("__"):
            raise AttributeError(name)
        self.__class__ = ModuleType  # type: ignore[assignment]
        spec.loader.exec_module(self)
        return getattr(self, name)


def stand_for(name: str, folder: Path, things: dict[str, Any], *, own: bool) -> None:
    """Put a package in its place whose own file is not run yet, or never where `own` is False."""
    spec = importlib.util.spec_from_file_location(
        name, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    assert spec is not None
    package = (Later if own else ModuleType)(name)
    package.__dict__.update(
        __spec__=spec,
        __path__=[str(folder)],
        __package__=name,
        __file__=str(folder / "__init__.py"),
        **things,
    )
    sys.modules[name] = package
    above, _, last = name.rpartition(".")
    if above:
        setattr(sys.modules[above], last, package)


class Withholding:
    """Finds modules as ever, and takes out of each what is withheld."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        """The module's own spec, with a loader that looks through what it has loaded."""
        if name.partition(".")[0] != "kinoedu":
            return None
        spec = importlib.machinery.PathFinder.find_spec(name, path, target)
        if spec is not None and spec.loader is not None:
            load = spec.loader.exec_module
            spec.loader.exec_module = lambda module: (load(module), take_out(module))  # type: ignore
        return spec


def take_out(module: ModuleType) -> None:
    """Put guards before what is withheld."""
    for name, thing in list(vars(module).items()):
        home = (getattr(thing, "__module__", None), getattr(thing, "__name__", None))
        if home in WITHHELD and not hasattr(thing, "withheld"):
            setattr(module, name, guarded(thing))


def guarded(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function that only the library itself may call."""

    @functools.wraps(function)
    def guard(*args: Any, **named: Any) -> Any:
        caller = sys._getframe(1).f_globals
        home = str(caller.get("__name__"))
        if (
            home.startswith("kinoedu.")
            and not home.startswith("kinoedu.course.")
            and caller is vars(sys.modules.get(home, sys))
        ):
            return function(*args, **named)
        raise Withheld(
            f"{function.__name__} is what you are to write, so the library's own is withheld here"
        )

    del guard.__wrapped__
    guard.withheld = True  # type: ignore[attr-defined]
    return guard
