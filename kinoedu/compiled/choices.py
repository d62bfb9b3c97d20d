"""Questions that each kind of record answers in its own way, and methods of records.

In Python both are ordinary calls. What compiled code needs to know of them is listed here, and read
by compiler.py before it compiles.
"""

import functools
import inspect
from collections.abc import Callable
from typing import Any, TypeVar

from ..errors import DuplicateKind

F = TypeVar("F", bound=Callable[..., Any])
C = TypeVar("C", bound=type)

GENERICS: list[tuple[Callable[..., Any], Callable[..., Any]]] = []  # a question; what chooses
METHODS: dict[str, dict[type, Callable[..., Any]]] = {}  # by name, then by class
CALLABLE: list[Callable[..., Any]] = []  # plain functions that compiled code may call


def generic(records: int) -> Callable[[Callable[..., Any]], Any]:
    """Make a question whose answer depends on the kinds of its first `records` arguments.

    The decorated function answers for kinds that have registered no answer of their own. Answers
    are plain functions: compiled code takes them in, the interpreter runs them.

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
                    raise DuplicateKind(
                        f"{default.__name__} already has an answer for ({names}); register a kind "
                        "of your own"
                    )
                answers[kinds] = answer
                return answer

            return keep

        def choose(*args: Any) -> Callable[..., Any]:
            kinds = (getattr(arg, "instance_class", arg) for arg in args[:records])
            return answers.get(tuple(kinds), default)

        ask.register = register  # type: ignore[attr-defined]
        GENERICS.append((ask, choose))
        return ask

    return make


def record(record_class: C) -> C:
    """Let compiled code call the methods of a NamedTuple class, as Python can.

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
    return record_class


def method_chooser(name: str) -> Callable[..., Any]:
    """What chooses, for the class of its first argument, the method of a name; or None."""
    methods = METHODS[name]

    def choose(self: Any, *args: Any) -> Callable[..., Any] | None:
        return methods.get(getattr(self, "instance_class", type(None)))

    signature = inspect.signature(next(iter(methods.values())))
    choose.__signature__ = signature  # type: ignore[attr-defined]  # numba folds arguments by it
    return choose
