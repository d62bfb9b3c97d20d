"""Public classes that check their arguments and make a record, and the help of records."""

from __future__ import annotations

from typing import ForwardRef, TypeVar

C = TypeVar("C", bound=type)


class Constructor(type):
    """The metaclass of public classes such as `Problem` and `PolygonWorld`.

    A record is a NamedTuple that compiled code also creates, so its own `__new__` cannot check
    arguments. A class with this metaclass derives from the record; its `__new__` checks the
    arguments and returns the plain record. The class can be used as an annotation, and `isinstance`
    is true for every record that the class makes.
    """

    def __instancecheck__(cls, thing: object) -> bool:
        return any(isinstance(thing, base) for base in cls.__bases__) and cls._makes(thing)

    def _makes(cls, thing: object) -> bool:
        """Whether this class can make the record, and not only another class of the same record."""
        return True


def with_type_names(record_class: C) -> C:
    """Let `help` print the types of a NamedTuple's fields as the source names them.

    Under `from __future__ import annotations`, NamedTuple stores `Array` as `ForwardRef('Array')`.
    """
    types = record_class.__annotations__  # the same dictionary as that of its `__new__`
    for field, kind in types.items():
        types[field] = kind.__forward_arg__ if isinstance(kind, ForwardRef) else kind
    return record_class
