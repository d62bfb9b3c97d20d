"""Parts of numba that took much of a compilation's time, replaced by quicker ones.

They are replaced only in a process that compiles. The machine code does the same.
"""

import functools
from collections.abc import Callable
from typing import Any

import llvmlite.binding
import numba
from numba import types
from numba.core.datamodel import default_manager
from numba.core.runtime.context import NRTContext
from numba.core.targetconfig import TargetConfig
from numba.np.arrayobj import raise_with_shape_context

compare_all_options = TargetConfig.__eq__


@functools.cache
def replace_slow_parts() -> None:
    """Replace them, once in a process."""
    shorten_message_about_shapes()
    NRTContext.get_meminfos = find_owners
    TargetConfig.__eq__, TargetConfig.__hash__ = have_equal_options, hash_of_options
    # numba would report each call of LLVM to a timer of each function that is being compiled
    llvmlite.binding.ffi.lib._lock._cblist.clear()


# ---- the message about shapes -------------------------------------------------------------------


def shorten_message_about_shapes() -> None:
    """Shorten numba's error message for an assignment to a row of another length.

    The full message contains both shapes. Formatting it took a third of the compilation time and of
    the code of every function that assigns a row.
    """
    numba.core.registry.cpu_target.typing_context.refresh()
    kind = numba.core.registry.cpu_target.typing_context.resolve_value_type(
        raise_with_shape_context
    )
    for template in kind.templates:
        template._overload_func = staticmethod(fail_by_shape)


def fail_by_shape(source: Any, rows: Any) -> Callable[..., None]:
    """The compiled code for an array that does not fit."""

    def fail(source: Any, rows: Any) -> None:
        raise ValueError("an array of another shape cannot be assigned")

    return fail


# ---- counting references ------------------------------------------------------------------------


def find_owners(self: NRTContext, builder: Any, kind: types.Type, value: Any) -> list[Any]:
    """numba's get_meminfos: the owners of the memory of all arrays in a value, with their types.

    numba's own takes the value apart down to every number, and LLVM removes these instructions.
    """
    model = default_manager[kind]
    found = [(kind, model.get_nrt_meminfo(builder, value))] if model.has_nrt_meminfo() else []
    for part, take_part in model.traverse(builder):
        if has_owner(part):
            found += find_owners(self, builder, part, take_part(value))
    return found


@functools.cache
def has_owner(kind: types.Type) -> bool:
    """Whether values of a type have memory whose references are counted."""
    return bool(default_manager[kind].contains_nrt_meminfo())


# ---- options, by which numba finds what it has compiled ------------------------------------------


def have_equal_options(one: TargetConfig, other: object) -> Any:
    """Whether options are equal; numba's own reads all, though most that are compared are equal."""
    if isinstance(other, TargetConfig) and one._values == other._values:
        return True
    return compare_all_options(one, other)


def hash_of_options(one: TargetConfig) -> int:
    """The same for all options of a class, as numba's own, which sorts their names each time."""
    return hash(type(one))
