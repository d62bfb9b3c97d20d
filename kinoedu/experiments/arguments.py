"""Arguments of functions, from the tables of an experiment's file."""

import inspect
from collections.abc import Callable, Set
from dataclasses import is_dataclass
from typing import Any, get_args

from ..support.json_fields import Field

PLAIN = (bool, int, float, str)  # types of values in a file
TYPE_NAMES = {bool: "true or false", int: "a whole number", float: "a number", str: "a string"}


def arguments_from(
    field: Field,
    function: Callable[..., object],
    already_read: tuple[str, ...],
    renamed: dict[str, str],
    hidden: Set[str] = frozenset({"rng"}),
) -> dict[str, Any]:
    """Arguments of a function from a table, checked against its signature.

    `already_read` names the keys that do not count; `renamed` maps keys to other parameters;
    `hidden` are the parameters that a file cannot give.
    """
    accepted = {
        name: annotation
        for name, annotation in annotations_of(function).items()
        if name not in hidden and (record_in(annotation) or kinds_of(annotation))
    }
    fields = field.members((*already_read, *renamed), tuple(accepted))
    return {
        renamed.get(name, name): argument_from(argument, accepted.get(name, int))
        for name, argument in fields.items()
        if name not in already_read
    }


def annotations_of(function: Callable[..., object]) -> dict[str, Any]:
    """The types of a function's parameters.

    A parameter without an annotation has the type of its default, or any plain type.
    """
    try:
        parameters = inspect.signature(function, eval_str=True).parameters
    except Exception:  # a reader's own annotations may be any text
        parameters = inspect.signature(function).parameters
    return {name: annotation_of(parameter) for name, parameter in parameters.items()}


def annotation_of(parameter: inspect.Parameter) -> Any:
    """The type of one parameter."""
    if parameter.annotation is not inspect.Parameter.empty:
        return parameter.annotation
    kind = type(parameter.default)
    if kind in PLAIN:
        return kind if kind is not int else float | int
    return bool | int | float | str


def argument_from(field: Field, annotation: Any) -> Any:
    """A value of the type that a parameter has: a plain value, or a record from a table."""
    record = record_in(annotation)
    if record is not None:
        return record(**arguments_from(field, record, (), {}))
    kinds, given = kinds_of(annotation), type(field.value)
    if given not in kinds and not (given is int and float in kinds):
        raise field.wrong(" or ".join(TYPE_NAMES[kind] for kind in kinds))
    return field.value


def record_in(annotation: Any) -> type | None:
    """The record that an argument is, also where it may be None."""
    kinds = (annotation, *get_args(annotation))
    return next((kind for kind in kinds if is_dataclass(kind) and isinstance(kind, type)), None)


def kinds_of(annotation: object) -> list[type]:
    """Plain types that an argument may have."""
    return [kind for kind in PLAIN if kind in (get_args(annotation) or (annotation,))]
