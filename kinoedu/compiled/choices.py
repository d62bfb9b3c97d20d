"""Generic functions with implementations for kinds of records, and methods of records.

In Python both are ordinary calls. This module lists what compiled code must know of them;
compiler.py reads the lists before it compiles.
"""

import functools
import inspect
from collections.abc import Callable
from typing import Any, TypeVar

from ..errors import DuplicateKind

Function = Callable[..., Any]
F = TypeVar("F", bound=Function)
C = TypeVar("C", bound=type)

# generic functions, each with what selects its implementation, by how many records
GENERICS: list[tuple[Any, Function, int]] = []
METHODS: dict[str, dict[type, Function]] = {}  # methods by name, then by class
PROPERTIES: dict[str, dict[type, Function]] = {}  # the same of properties
CALLABLE: list[Function] = []  # plain functions that compiled code may call


def generic(records: int) -> Callable[[Function], Any]:
    """Make a generic function, which selects its implementation by its first `records` arguments.

    The decorated function is the default for kinds without an implementation. Implementations are
    plain functions: compiled code inlines them, and Python interprets them. Register one with
    `@function.register(kind, ...)`; `function.is_known(kind, ...)` says whether there is one.

    Raises
    ------
    DuplicateKind
        By `register`, where the kinds have an implementation already.

    Examples
    --------
    >>> @generic(1)
    ... def legs(animal):
    ...     return 0
    >>> @legs.register(int)
    ... def legs_of_a_number(animal):
    ...     return animal
    >>> legs(4), legs("snake"), legs.is_known(int)
    (4, 0, True)
    """

    def make(default: Function) -> Any:
        implementations: dict[tuple[type, ...], Function] = {}

        @functools.wraps(default)
        def dispatch(*args: Any) -> Any:
            if records == 1 and args:  # the usual case, in a quarter of `map`'s time
                return implementations.get((type(args[0]),), default)(*args)
            return implementations.get(tuple(map(type, args[:records])), default)(*args)

        def register(*kinds: type) -> Callable[[F], F]:
            def add(implementation: F) -> F:
                if kinds in implementations:
                    names = ", ".join(kind.__name__ for kind in kinds)
                    raise DuplicateKind(
                        f"{default.__name__} already has an implementation for ({names}); register "
                        "a kind of your own"
                    )
                implementations[kinds] = implementation
                return implementation

            return add

        def choose(*args: Any) -> Function:
            kinds = (getattr(arg, "instance_class", arg) for arg in args[:records])
            return implementations.get(tuple(kinds), default)

        dispatch.register = register  # type: ignore[attr-defined]
        dispatch.implementations = implementations  # type: ignore[attr-defined]
        dispatch.is_known = lambda *kinds: kinds in implementations  # type: ignore[attr-defined]
        GENERICS.append((dispatch, choose, records))
        return dispatch

    return make


def record(record_class: C) -> C:
    """Let compiled code use the methods and properties of a NamedTuple class, as Python can.

    Examples
    --------
    >>> from typing import NamedTuple
    >>> @record
    ... class Circle(NamedTuple):
    ...     radius: float
    ...     def area(self):
    ...         return 3.0 * self.radius * self.radius
    >>> Circle(2.0).area()
    12.0
    """
    for name, method in vars(record_class).items():
        if callable(method) and not name.startswith("_"):
            METHODS.setdefault(name, {})[record_class] = method
        if isinstance(method, property) and method.fget is not None:
            PROPERTIES.setdefault(name, {})[record_class] = method.fget
    return record_class


def method_chooser(name: str) -> Function:
    """A function that selects the method of a name for the class of its first argument, or None."""
    methods = METHODS[name]

    def choose(self: Any, *args: Any) -> Function | None:
        return methods.get(getattr(self, "instance_class", type(None)))

    signature = inspect.signature(next(iter(methods.values())))
    choose.__signature__ = signature  # type: ignore[attr-defined]  # numba binds arguments by it
    return choose


def property_chooser(name: str) -> Function:
    """The same for the property of a name."""
    properties = PROPERTIES[name]

    def choose(self: Any) -> Function | None:
        return properties.get(getattr(self, "instance_class", type(None)))

    return choose
