"""The benchmarks' own functions that call kinoedu's, as machine code."""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

from kinoedu.compiled.compiler import register_choices

F = TypeVar("F", bound=Callable[..., Any])


def njit(function: F) -> F:
    """Let numba compile a function at its first call.

    numba must know before which implementation of a generic function, such as is_free, is for which
    records. kinoedu tells it so only when it compiles something itself.
    """
    register_choices()
    return numba.njit(function)  # type: ignore[no-any-return]  # numba has no types
