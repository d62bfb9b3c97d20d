"""Public classes that check their arguments and make a record."""


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
