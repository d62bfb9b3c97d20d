"""Public names that check their arguments and make a record."""

from typing import Any


class Constructor(type):
    """The type of names such as `Problem` and `PolygonWorld`.

    A record is a NamedTuple, and compiled code returns it as it is, so its own `__new__` cannot
    check anything. A class of this type derives from the record, checks in its `__new__`, and
    returns the record itself. It serves as an annotation, and `isinstance` holds for every record
    that it makes.
    """

    def __instancecheck__(cls, thing: Any) -> bool:
        return any(isinstance(thing, base) for base in cls.__bases__) and cls._makes(thing)

    def _makes(cls, thing: Any) -> bool:
        """Whether a record could come from this class and not from another with the same record."""
        return True
