"""What the library lends to a student's program, as the program finds it.

A function, a problem or a record of the library is a number here, and asks the runner. Modules of
kinoedu hold what the assignment lends; every other name of theirs can be imported, and says at its
use that it is not lent.
"""

import importlib
import importlib.machinery
import sys
from collections.abc import Callable
from functools import cache
from types import ModuleType
from typing import Any, ClassVar

import numpy as np

from . import wire
from .stand_ins import Silent

Ask = Callable[..., Any]
# what shows or checks something in a notebook is left out without a word
SILENT_MODULES = ("kinoedu.figures", "kinoedu.boards")
SILENT = ("board", "check", "display", "figure", "play", "show")


class Lent:
    """Something of the library, which answers to its number."""

    def __init__(self, number: int, ask: Ask) -> None:
        self._number, self._ask = number, ask


class LentFunction(Lent):
    """A function of the library, with its name if it has one."""

    def __init__(self, number: int, ask: Ask, name: str) -> None:
        super().__init__(number, ask)
        if name:
            self.__name__ = self.__qualname__ = name

    def __call__(self, *given: Any, **named: Any) -> Any:
        return self._ask(self._number, "", given, named)


class LentThing:
    """A thing made by a class that is lent: its methods, which `make_class` adds, and its data.

    A class derived from it makes such a thing as well, and calls its methods by `super()`.
    """

    _ask: ClassVar[Ask]
    _number: int  # of the class; each thing has its own
    _is_made = False

    def __init__(self, *given: Any, **named: Any) -> None:
        made = self._ask(type(self)._number, "", given, named)
        self._number, self._is_made = made._number, True

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or not self._is_made:
            raise AttributeError(name)
        return self._ask(self._number, name, ())


class LentCollection(LentThing):
    """A thing with a length, such as a graph with its nodes."""

    def __len__(self) -> int:
        return self._ask(self._number, "__len__", ())

    def __iter__(self) -> Any:
        return iter(self._ask(self._number, "__iter__", ()))

    def __contains__(self, item: object) -> bool:
        return self._ask(self._number, "__contains__", (item,))


def make_class(number: int, ask: Ask, name: str, methods: list[str]) -> type[LentThing]:
    """A class that is lent, as a class: for `isinstance`, annotations, and classes derived."""

    def make_method(question: str) -> Callable[..., Any]:
        return lambda self, *given, **named: ask(self._number, question, given, named)

    kind = LentCollection if "__len__" in methods else LentThing
    parts = {one: make_method(one) for one in methods if not one.startswith("_")}
    return type(name, (kind,), {**parts, "_ask": staticmethod(ask), "_number": number})


class LentRecord(Lent):
    """A record of the library: its fields, by name and in order."""

    def __init__(self, number: int, ask: Ask, fields: dict[str, Any]) -> None:
        super().__init__(number, ask)
        self.__dict__.update(fields)
        self._fields = tuple(fields)

    def __iter__(self) -> Any:
        return iter([getattr(self, name) for name in self._fields])

    def __len__(self) -> int:
        return len(self._fields)

    def __getitem__(self, place: Any) -> Any:
        return list(self)[place]


class LentValues:
    """The values on both sides of the line: encoded for the runner, and decoded from it."""

    def __init__(self, ask: Ask) -> None:
        self.ask = ask
        self.generators: dict[int, Any] = {}  # of numpy, of today's or of the older kind
        self.numbers: dict[int, int] = {}  # of generators, by their identity
        self.classes: dict[int, type[LentThing]] = {}

    def encode(self, value: Any) -> Any:
        """A value as JSON data."""
        return wire.encode(value, self.lend)

    def decode(self, data: Any) -> Any:
        """The value of JSON data."""
        return wire.decode(data, self.find)

    def lend(self, value: Any) -> dict[str, Any] | None:
        """The mark of what the library lent, or of a generator."""
        number = getattr(value, "_number", None)
        if type(number) is int:
            return {wire.LENT: number}
        if isinstance(value, np.random.Generator | np.random.RandomState):
            number = self.numbers.setdefault(id(value), len(self.numbers))
            self.generators[number] = value
            return {wire.GENERATOR: [number, wire.read_state(value)]}
        return None

    def find(self, mark: str, content: Any) -> Any:
        """What a mark stands for."""
        if content["is"] == "axes":
            from matplotlib.backends.backend_agg import FigureCanvasAgg
            from matplotlib.figure import Figure

            figure = Figure()
            FigureCanvasAgg(figure)
            return figure.add_subplot()
        number = content["number"]
        if content["is"] == "function":
            return LentFunction(number, self.ask, content["name"])
        if content["is"] == "class":
            made = make_class(number, self.ask, content["name"], content["methods"])
            return self.classes.setdefault(number, made)
        if content["is"] == "thing":
            kind = self.classes[content["of"]]
            thing = kind.__new__(kind)
            thing._number, thing._is_made = number, True
            return thing
        parts = {name: self.decode(part) for name, part in content["parts"].items()}
        if content["is"] == "record":
            return LentRecord(number, self.ask, parts)
        return self.make_problem(number, parts)

    def make_problem(self, number: int, parts: dict[str, Any]) -> Any:
        """A problem that asks the runner."""
        problem = Loaded.problem(
            lambda question, *given: self.ask(number, question, given),
            parts["questions"],
            parts["numbers"],
            parts["ends"],
            Loaded.metrics[parts["metric"][0]](*parts["metric"][1:]),
        )
        problem._number = number
        return problem

    def take(self, reply: Any) -> Any:
        """Take over how an answer left the generators, and return or raise the answer."""
        for number, state in reply["states"]:
            wire.set_state(self.generators[number], state)
        if "raised" in reply:
            kinds, message = reply["raised"]
            raise find_exception(kinds)(message)
        return self.decode(reply["value"])

    def is_axes(self, value: Any) -> bool:
        """Whether a value is matplotlib's axes."""
        return hasattr(value, "get_xlabel")

    def read(self, value: Any) -> Any:
        """What axes hold; every other value as it is."""
        return Loaded.read_axes(value) if self.is_axes(value) else value


def find_exception(kinds: list[str]) -> type[Exception]:
    """The first of Python's own exceptions among some names, under the first name.

    An error of the library is the class that the program imports.
    """
    if "KinoeduError" in kinds:
        return error_of_library(kinds[0])
    known = vars(sys.modules["builtins"])
    base = next(
        (
            known[kind]
            for kind in kinds
            if isinstance(known.get(kind), type) and issubclass(known[kind], Exception)
        ),
        RuntimeError,
    )
    return base if base.__name__ == kinds[0] else type(kinds[0], (base,), {})


@cache
def error_of_library(name: str) -> type[Exception]:
    """The class of the library's errors of this name: the same one raised, imported and caught."""
    base = ValueError if name == "KinoeduError" else error_of_library("KinoeduError")
    return type(name, (base,), {})


class NotLent:
    """A name of the library that this assignment does not lend; it may stand in annotations."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __or__(self, other: object) -> "NotLent":
        return self

    __ror__ = __or__

    def __call__(self, *given: Any, **named: Any) -> Any:
        raise NotLentError(
            f"{self._name} is not lent to this assignment; write it, or use what its first cells "
            "import"
        )

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return NotLent(f"{self._name}.{name}")


class NotLentError(Exception):
    """A program called what is not lent."""


class LentModule(ModuleType):
    """A module of kinoedu, as far as it is lent."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if name in SILENT or self.__name__.startswith(SILENT_MODULES):
            return Silent()
        full_name = f"{self.__name__}.{name}"
        if self.__name__ == "kinoedu.errors":
            return error_of_library(name)
        finder = self.__loader__
        assert isinstance(finder, LentModules)
        return (
            importlib.import_module(full_name)
            if finder.has_module(full_name)
            else NotLent(full_name)
        )


class LentModules(importlib.machinery.PathFinder):
    """Finds every module of kinoedu, and fills it with what is lent."""

    def __init__(self, modules: dict[str, dict[str, Any]]) -> None:
        self.modules = modules

    def has_module(self, name: str) -> bool:
        """Whether something of a module, or of one within it, is lent."""
        return any(module == name or module.startswith(name + ".") for module in self.modules)

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:  # type: ignore[override]
        """The spec of a module of kinoedu."""
        if name.partition(".")[0] != "kinoedu":
            return None
        return importlib.machinery.ModuleSpec(name, self, is_package=True)  # type: ignore[arg-type]

    def create_module(self, spec: importlib.machinery.ModuleSpec) -> LentModule:
        """An empty module."""
        return LentModule(spec.name)

    def exec_module(self, module: ModuleType) -> None:
        """Fill the module."""
        vars(module).update(self.modules.get(module.__name__, {}))


class Loaded:
    """What problems and axes need of the library, where an assignment has them."""

    problem: Any = None
    metrics: ClassVar[dict[str, Callable[..., Any]]] = {}
    read_axes: Any = None


def take_from_library() -> None:
    """Keep what problems and axes need, before the library is forgotten."""
    problems = sys.modules.get("kinoedu.course.lent_problem")
    if problems is not None:
        Loaded.problem = problems.LentProblem
        spaces = (problems.RealSpace, problems.WrappingSpace)
        Loaded.metrics = {space.__name__: space for space in spaces} | {"float": float}
    axes = sys.modules.get("kinoedu.course.axes_contents")
    if axes is not None:
        Loaded.read_axes = axes.read_axes
