"""The library as a student's program finds it in the sandbox: only what it uses is loaded, and what it is to write is withheld.

Withholding stops a program from calling the answer. It does not hide it: the library is open, and copying is for people to judge.
"""

import functools
import importlib.machinery
import importlib.util
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from types import ModuleType
from typing import Any

HERE = Path(__file__).resolve().parent.parent


class Withheld(Exception):
    """A program called the very function that it is to write."""


USUAL = ("numpy", "kinoedu.geometry", "kinoedu.course.judging", "kinoedu.course.drawn", "kinoedu.course.whole_shapes")
WITHHELD: set[tuple[str, ...]] = set()  # modules and names


def open_library() -> None:
    """Make `import kinoedu` quick, and let functions be withheld. For a process that runs nothing else."""
    stand_for("kinoedu", HERE, {}, own=True)
    stand_for("kinoedu.course", HERE / "course", {"check": nothing, "show": nothing}, own=False)
    stand_for("kinoedu.course.exercises", HERE / "course" / "exercises", {}, own=False)
    sys.meta_path.insert(0, Withholding())


def withhold(names: Iterable[str]) -> None:
    """Withhold functions, named as "module:name", from programs that are run from now on."""
    WITHHELD.update(tuple(name.split(":")) for name in names)
    for module in [module for name, module in sys.modules.items() if name.partition(".")[0] == "kinoedu"]:
        take_out(module)


def nothing(*_: Any, **__: Any) -> None:
    """A check that says nothing: what is judged is judged elsewhere."""


class Later(ModuleType):
    """A package whose own file is run when something of it is asked for, so that its modules can be had without it."""

    def __getattr__(self, name: str) -> Any:
        spec = self.__spec__
        if spec is None or spec.loader is None or name.startswith("__"):
            raise AttributeError(name)
        self.__class__ = ModuleType  # type: ignore[assignment]
        spec.loader.exec_module(self)
        return getattr(self, name)


def stand_for(name: str, folder: Path, things: dict[str, Any], *, own: bool) -> None:
    """Put a package in its place whose own file is not run yet, or never where `own` is False."""
    spec = importlib.util.spec_from_file_location(name, folder / "__init__.py", submodule_search_locations=[str(folder)])
    assert spec is not None
    package = (Later if own else ModuleType)(name)
    package.__dict__.update(__spec__=spec, __path__=[str(folder)], __package__=name, __file__=str(folder / "__init__.py"), **things)
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
    """Put guards before what is withheld. Compiled functions are guarded at a package's door only: within it, other compiled code
    needs them as they are.
    """
    for name, thing in list(vars(module).items()):
        home = (getattr(thing, "__module__", None), getattr(thing, "__name__", None))
        if (
            home in WITHHELD
            and not hasattr(thing, "withheld")
            and (hasattr(module, "__path__") or not hasattr(thing, "inspect_types"))
        ):
            setattr(module, name, guarded(thing))


def guarded(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function that only the library itself may call."""

    @functools.wraps(function)
    def guard(*args: Any, **named: Any) -> Any:
        caller = sys._getframe(1).f_globals.get("__name__", "")
        if caller.partition(".")[0] == "kinoedu":
            return function(*args, **named)
        raise Withheld(f"{function.__name__} is what you are to write, so the library's own is withheld here")

    del guard.__wrapped__
    guard.withheld = True  # type: ignore[attr-defined]
    return guard
