"""The library as a student's program finds it in the sandbox.

Only the modules that a program uses are loaded, and the functions that it is to write are withheld.
Withholding prevents a program from calling the answer. It does not hide it: the library's source is
public, and people must judge what is copied.
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
    """A program called the function that it is to write."""


USUAL = (
    "numpy",
    # numpy would load these two at their first use, in every program anew
    "numpy.ma",
    "numpy.random",
    "kinoedu.geometry",
    "kinoedu.course.judging",
    "kinoedu.course.drawn",
    "kinoedu.course.whole_shapes",
)
JUDGES, LESSONS = "kinoedu.course.lessons", HERE / "course" / "lessons"
WITHHELD: set[tuple[str, ...]] = set()  # pairs of module and name


def open_library() -> None:
    """Make `import kinoedu` fast, and prepare to withhold functions.

    It changes how modules are imported, so call it only in a process of the sandbox.
    """
    register_package("kinoedu", HERE, {}, own=True)
    register_package(
        "kinoedu.course", HERE / "course", {"check": do_nothing, "show": do_nothing}, own=False
    )
    register_package(JUDGES, LESSONS, {}, own=False)
    for room in find_lesson_names():
        register_package(f"{JUDGES}.{room}", LESSONS / room, {}, own=False)
    sys.meta_path.insert(0, Withholding())


def find_lesson_names() -> list[str]:
    """The names of the packages of the lessons."""
    return [place.parent.name for place in LESSONS.glob("*/__init__.py")]


def withhold(names: Iterable[str]) -> None:
    """Withhold functions, named as "module:name", from programs that run from now on."""
    WITHHELD.update(tuple(name.split(":")) for name in names)
    for module in [
        module for name, module in sys.modules.items() if name.partition(".")[0] == "kinoedu"
    ]:
        guard_withheld(module)


def load_call(name: str) -> Callable[..., Any]:
    """The function that calls a student's function for an exercise.

    name : "" to pass the arguments as they are, else "module:Class.call". Only that function is
        loaded, with the names that its lines use, since the rest of its module knows the answers.
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


def remove_judges(lent: Iterable[str]) -> list[str]:
    """Forget every exercise's judge, and return the folders of the judges, to be hidden.

    Of the judges' modules only functions that an assignment lends are kept, named as "module:name",
    such as a wrong program that a student must expose.
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


def do_nothing(*_: Any, **__: Any) -> None:
    """A `check` that does nothing, as answers are judged outside the sandbox."""


class LazyPackage(ModuleType):
    """A package whose own file is run at the first use of its names.

    Its modules can be imported without it.
    """

    def __getattr__(self, name: str) -> Any:
        spec = self.__spec__
        if spec is None or spec.loader is None or name.startswith("__"):
            raise AttributeError(name)
        self.__class__ = ModuleType  # type: ignore[assignment]
        spec.loader.exec_module(self)
        return getattr(self, name)


def register_package(name: str, folder: Path, things: dict[str, Any], *, own: bool) -> None:
    """Register a package without running its file; the file is run later if `own`, else never."""
    spec = importlib.util.spec_from_file_location(
        name, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    assert spec is not None
    package = (LazyPackage if own else ModuleType)(name)
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
    """An import finder that finds modules as usual and replaces withheld functions in them."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        """The module's spec, with a loader that also replaces withheld functions."""
        if name.partition(".")[0] != "kinoedu":
            return None
        spec = importlib.machinery.PathFinder.find_spec(name, path, target)
        if spec is not None and spec.loader is not None:
            load = spec.loader.exec_module
            spec.loader.exec_module = lambda module: (load(module), guard_withheld(module))  # type: ignore
        return spec


def guard_withheld(module: ModuleType) -> None:
    """Replace withheld functions in a module by guards."""
    for name, thing in list(vars(module).items()):
        home = (getattr(thing, "__module__", None), getattr(thing, "__name__", None))
        if home in WITHHELD and not hasattr(thing, "withheld"):
            setattr(module, name, make_guard(thing))


def make_guard(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function, callable only from the library itself."""

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
