"""Machine code with numba: read from the disk, and called.

Only the keeper's thread works with numba in a reader's process, so that stopping any other thread
never leaves numba's lock held.
"""

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import llvmlite.binding
import numba
import numpy as np
from numba import types
from numba.core.compiler import CompileResult
from numba.core.compiler_lock import global_compiler_lock
from numba.core.serialize import dumps
from numba.np.numpy_support import from_dtype

from .kinds import NOTHING, RNG, Kind, is_tuple_kind

# error_model: a float divided by zero is inf, without a check at every division. forceinline: said
# of every function, or numba would pass it on from a function that is taken in to all that it
# calls.
OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "forceinline": False}
RNG_TYPE = numba.typeof(np.random.default_rng(0))


def new_dispatcher(function: Callable[..., Any], missed: Callable[..., Any]) -> Any:
    """What calls a function's machine code; for kinds that have none, `missed`. Never compiles."""
    dispatcher = numba.njit(**OPTIONS)(function)
    dispatcher._compile_for_args = lambda *args: missed
    return dispatcher


def numba_type(kind: Kind) -> Any:
    """numba's type for a kind.

    >>> from .kinds import kind_of
    >>> numba_type(kind_of(np.zeros((2, 3))))
    Array(float64, 2, 'C', False, aligned=True)
    """
    if is_tuple_kind(kind):
        fields = [numba_type(field) for field in kind[1]]
        return types.BaseTuple.from_types(fields, None if kind[0] is tuple else kind[0])
    if isinstance(kind, tuple):
        dtype, dimensions, layout, writable = kind
        return types.Array(from_dtype(np.dtype(dtype)), dimensions, layout, readonly=not writable)
    if kind == RNG:
        return RNG_TYPE
    return types.none if kind == NOTHING else from_dtype(np.dtype(kind))


def magic() -> tuple[Any, ...]:
    """What machine code fits: numba, and the processor as LLVM knows it."""
    features = llvmlite.binding.get_host_cpu_features().flatten()
    return numba.__version__, llvmlite.binding.get_host_cpu_name(), features


def packed(result: CompileResult) -> bytes:
    """Machine code as it is kept on the disk."""
    return pickle.dumps(magic()) + dumps(result._reduce())


def load(dispatcher: Any, file: Path) -> None:
    """Give a dispatcher the machine code in a file. Raises where the file does not hold such code
    for this computer."""
    with open(file, "rb") as stream:
        if pickle.load(stream) != magic():
            raise ValueError(f"{file.name} is for another computer")
        parts = pickle.load(stream)
    add(dispatcher, parts)


@global_compiler_lock
def add(dispatcher: Any, parts: tuple[Any, ...]) -> None:
    """Give a dispatcher machine code, in the parts that it was packed in."""
    dispatcher.targetctx.refresh()  # what machine code calls of numba's is there from now on
    dispatcher.add_overload(CompileResult._rebuild(dispatcher.targetctx, *parts))
