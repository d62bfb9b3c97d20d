"""Machine code in numba's format: reading it from the disk, and calling it.

In a user's process only one thread (numba_thread.py) works with numba, so that the interruption of
another thread never leaves numba's lock held.
"""

import hashlib
import pickle
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

from .choices import Function
from .kinds import NONE, RNG, Kind, is_tuple_kind

# error_model: a float divided by zero is inf, without a check at every division.
# forceinline: set for every function, or numba would pass it on from an inlined one to its callees.
OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "forceinline": False}
RNG_TYPE = numba.typeof(np.random.default_rng(0))


def new_dispatcher(function: Function, missed: Function) -> Any:
    """A dispatcher that calls machine code, or `missed` for other kinds; it never compiles."""
    dispatcher = numba.njit(**OPTIONS)(function)
    dispatcher._compile_for_args = lambda *args: missed
    return dispatcher


def numba_type(kind: Kind) -> Any:
    """numba's type for a kind.

    Examples
    --------
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
    return types.none if kind == NONE else from_dtype(np.dtype(kind))


def compatibility_key() -> tuple[Any, ...]:
    """The versions and the processor that machine code depends on."""
    features = llvmlite.binding.get_host_cpu_features().flatten()
    return numba.__version__, llvmlite.binding.get_host_cpu_name(), features


def to_bytes(result: CompileResult) -> bytes:
    """Machine code as bytes for a file, behind their digest: damaged code could end a process."""
    code = dumps(result._reduce())
    return pickle.dumps((compatibility_key(), hashlib.sha256(code).digest())) + code


def load(dispatcher: Any, file: Path) -> None:
    """Add the machine code in a file to a dispatcher; raises where it cannot be used."""
    with open(file, "rb") as stream:
        computer, digest = pickle.load(stream)
        code = stream.read()
    if computer != compatibility_key():
        raise ValueError(f"{file.name} is for another computer")
    if hashlib.sha256(code).digest() != digest:
        raise ValueError(f"{file.name} is damaged")
    add_machine_code(dispatcher, pickle.loads(code))


@global_compiler_lock
def add_machine_code(dispatcher: Any, parts: tuple[Any, ...]) -> None:
    """Add machine code to a dispatcher, in the parts in which it was stored."""
    dispatcher.targetctx.refresh()  # makes numba's own functions available to the machine code
    dispatcher.add_overload(CompileResult._rebuild(dispatcher.targetctx, *parts))
