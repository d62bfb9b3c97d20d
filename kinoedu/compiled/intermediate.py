"""Functions in LLVM's intermediate language, for a compiler of another processor's code.

Nothing is optimized or linked on the way, so functions that several entries call are compiled once.
A process that does this compiles nothing for its own processor: functions know one kind of library.
"""

from typing import Any

from .compiler import LeanLibrary, compile_as
from .kinds import kinds_of
from .tiers import Compiled, TieredFunction


class LooseLibrary(LeanLibrary):
    """A compiled function as it was written down, apart from those that it calls."""

    def _optimize_functions(self, ll_module: Any) -> None:
        """Numba would do this with each function that is added."""

    def finalize(self) -> None:
        """Numba would link and optimize here."""
        self._finalized = True


def compile_parts(function: Compiled, arguments: tuple[Any, ...]) -> tuple[str, dict[Any, Any]]:
    """The name of a function in compiled code, and the libraries and LLVM modules of its parts.

    Raises
    ------
    TypeError
        Where numba cannot compile it for these arguments.
    """
    kinds = kinds_of(arguments)
    if kinds is None or not isinstance(function, TieredFunction):
        raise TypeError("numba cannot compile this function for these arguments")
    result = compile_as(LooseLibrary, function, kinds)
    found, waiting = dict[Any, Any](), [result.library]
    while waiting:
        library = waiting.pop()
        if library not in found:
            found[library] = library._final_module
            waiting += library._linking_libraries
    return result.fndesc.llvm_func_name, found
