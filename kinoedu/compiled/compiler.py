"""Machine code made by numba: a function and all that it calls become one piece.

Only that piece is called from Python. What it calls is neither given an entry from Python nor
turned into machine code of its own, which saves most of the time that numba would take.
"""

import inspect
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numba
from numba import _dynfunc, types
from numba.core import cgutils, cpu
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, CompileResult, DefaultPassBuilder
from numba.extending import (
    intrinsic,
    overload,
    overload_method,
    register_jitable,
    typeof_impl,
)

from . import choices
from .kinds import Kind
from .machine import OPTIONS, numba_type
from .tiers import Tiered

WITHOUT_ENTRY = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
INLINED = {"forceinline": True, "error_model": "numpy"}
registered = {"generics": 0, "callable": 0}
methods_known: set[str] = set()


def compile_entry(function: Tiered, kinds: tuple[Kind, ...]) -> CompileResult:
    """Compile a function for some kinds of arguments, to be called from Python.

    Raises numba's error where it cannot be compiled.
    """
    register_choices()
    entry = borrowing(function.py_func) if function.is_algorithm else function.py_func
    dispatcher = numba.njit(**OPTIONS, no_cfunc_wrapper=True, pipeline_class=EntryCompiler)(entry)
    signature = tuple(map(numba_type, kinds))
    with lean_libraries():
        dispatcher.compile(signature)
    result = dispatcher.overloads[signature]
    for environment in result._find_referenced_environments():
        result.library.codegen.set_env(environment.env_name, environment)
    return result


def register_choices() -> None:
    """Tell numba of the questions, methods and functions that were defined since the last time."""
    for ask, choose in choices.GENERICS[registered["generics"] :]:
        overload(ask, strict=False, jit_options=INLINED)(choose)
    registered["generics"] = len(choices.GENERICS)
    for function in choices.CALLABLE[registered["callable"] :]:
        register_jitable(function)
    registered["callable"] = len(choices.CALLABLE)
    for name in set(choices.METHODS) - methods_known:
        choose = choices.method_chooser(name)
        overload_method(types.BaseNamedTuple, name, strict=False, jit_options=INLINED)(choose)
        methods_known.add(name)


@typeof_impl.register(Tiered)
def type_of_tiered(function: Tiered, context: Any) -> Any:
    """A function of ours that compiled code calls."""
    if function.inner is None:
        options = {**OPTIONS, **WITHOUT_ENTRY, **function.options}
        function.inner = numba.njit(**options)(function.py_func)
    return types.Dispatcher(function.inner)


# ---- what is only called from compiled code -----------------------------------------------------


class LeanLibrary(JITCodeLibrary):
    """A compiled function. Unless Python enters it, it stays in LLVM's language: it becomes machine
    code as a part of those that call it."""

    is_entry = False

    def _optimize_final_module(self) -> None:
        if self.is_entry:
            super()._optimize_final_module()
            return
        passes, builder = self._codegen._module_pass_manager()  # numba runs a cheaper one before
        passes.run(self._final_module, builder)

    def _finalize_final_module(self) -> None:
        if self.is_entry:
            super()._finalize_final_module()
            return
        self._finalize_dynamic_globals()
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:
        return int(super().get_pointer_to_function(name)) if self.is_entry else 0


def executable(self: Any, library: Any, description: Any, environment: Any) -> Any:
    """numba's get_executable; what Python does not enter gets an entry that leads nowhere."""
    if not isinstance(library, LeanLibrary) or library.is_entry:
        return executable_of_numba(self, library, description, environment)
    name = description.qualname.rpartition(".")[2]
    return _dynfunc.make_function(description.lookup_module(), name, name, 0, environment, (library,))


executable_of_numba = cpu.CPUContext.get_executable


@contextmanager
def lean_libraries() -> Iterator[None]:
    """While the block runs, new libraries are lean."""
    codegen = numba.core.registry.cpu_target.target_context.codegen()
    usual = codegen._library_class
    codegen._library_class = LeanLibrary
    cpu.CPUContext.get_executable = executable
    try:
        yield
    finally:
        codegen._library_class = usual
        cpu.CPUContext.get_executable = executable_of_numba


# ---- what Python enters -------------------------------------------------------------------------


class EntryCompiler(CompilerBase):
    """numba's usual passes, for a function that Python enters."""

    def define_pipelines(self) -> list[Any]:
        name = self.state.func_id.func_qualname
        library = self.state.library = self.state.targetctx.codegen().create_library(name)
        library.enable_object_caching()
        library.is_entry = True
        return [DefaultPassBuilder.define_nopython_pipeline(self.state)]


def borrowing(function: Callable[..., Any]) -> Callable[..., Any]:
    """The same algorithm, which only borrows the arrays that it is given.

    Nothing counts references to them while it runs, which makes planners two and a half times as
    fast. It may write into them, but must return only numbers and arrays of its own.
    """
    whole = numba.njit(**{**OPTIONS, **WITHOUT_ENTRY, "forceinline": True})(function)
    # written out with a name for each argument: numba takes 0.2 ms to look at an *args tuple that
    # holds a Generator
    names = ", ".join(inspect.signature(function).parameters)
    scope = {"whole": whole, "borrowed": borrowed, "__name__": function.__module__}
    exec(f"def {function.__name__}({names}): return whole(*borrowed(({names},)))", scope)
    return scope[function.__name__]


@intrinsic
def borrowed(typing_context: Any, value: Any) -> Any:
    """The same value; the arrays in it without owners."""

    def disowned(context: Any, builder: Any, kind: Any, item: Any) -> Any:
        if isinstance(kind, types.Array):
            array = cgutils.create_struct_proxy(kind)(context, builder, value=item)
            array.meminfo = cgutils.get_null_value(array.meminfo.type)
            array.parent = cgutils.get_null_value(array.parent.type)
            return array._getvalue()
        if isinstance(kind, types.BaseTuple):
            items = zip(kind, cgutils.unpack_tuple(builder, item), strict=True)
            return context.make_tuple(builder, kind, [disowned(context, builder, k, i) for k, i in items])
        context.nrt.incref(builder, kind, item)
        return item

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return disowned(context, builder, signature.args[0], args[0])

    return value(value), generate
