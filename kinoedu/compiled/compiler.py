"""Compilation with numba of a function and all functions it calls, as one piece of machine code.

Python calls only that piece. The functions inside it have no entry from Python and no machine code
of their own, which saves most of numba's compilation time.
"""

import gc
import inspect
import itertools
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numba
from numba import _dynfunc, types
from numba.core import cgutils, cpu
from numba.core.bytecode import FunctionIdentity
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, CompilerBase, CompileResult, DefaultPassBuilder
from numba.core.lowering import Lower
from numba.extending import (
    intrinsic,
    overload,
    register_jitable,
    typeof_impl,
)

from . import attributes, boxing, choices
from .choices import Function
from .kinds import Kind
from .machine import OPTIONS, numba_type
from .savings import replace_slow_parts
from .tiers import TieredFunction

INLINED = {"forceinline": True, "error_model": "numpy"}
NEW_OBJECTS = 100_000  # between two searches for unused cycles; Python's own number is 700 to 2,000
# numba counts functions from 1, and the count is a part of their symbols. Code from two processes
# that is loaded into a third must not have equal symbols: LLVM would take one function's constants
# for the other's.
FunctionIdentity._unique_ids = itertools.count(secrets.randbits(48))
registered = {"generics": 0, "callable": 0}
methods_known: set[str] = set()
properties_known: set[str] = set()


def compile_entry(function: TieredFunction, kinds: tuple[Kind, ...]) -> CompileResult:
    """Compile a function that Python calls, for given kinds of arguments.

    Raises numba's error where it cannot be compiled.
    """
    result = compile_as(LeanLibrary, function, kinds, EntryCompiler)
    for environment in result._find_referenced_environments():
        result.library.codegen.set_env(environment.env_name, environment)
    return result


def compile_as(
    library: type[JITCodeLibrary],
    function: TieredFunction,
    kinds: tuple[Kind, ...],
    pipeline: type[CompilerBase] = Compiler,
) -> CompileResult:
    """Compile a function and those that it calls, by numba's passes, into libraries of a kind."""
    register_choices()
    replace_slow_parts()
    boxing.use_c_functions_alone()
    entry = borrowing(function.py_func) if function.is_algorithm else function.py_func
    dispatcher = numba.njit(**OPTIONS, pipeline_class=pipeline)(entry)
    signature = tuple(map(numba_type, kinds))
    with lean_libraries(library), few_searches_for_cycles():
        dispatcher.compile(signature)
    return dispatcher.overloads[signature]


@contextmanager
def few_searches_for_cycles() -> Iterator[None]:
    """Have Python search for unused cycles less often while the block runs.

    The searches took a seventh of a compilation. Without any, memory would be three times as much.
    """
    before = gc.get_threshold()
    gc.set_threshold(NEW_OBJECTS, *before[1:])
    try:
        yield
    finally:
        gc.set_threshold(*before)


def register_choices() -> None:
    """Register with numba the functions, methods and properties defined since the last call."""
    for generic, choose, records in choices.GENERICS[registered["generics"] :]:
        early = {"pipeline_class": EarlyCompiler} if records > 1 else {}
        overload(generic, strict=False, jit_options={**INLINED, **early})(choose)
    registered["generics"] = len(choices.GENERICS)
    for function in choices.CALLABLE[registered["callable"] :]:
        register_jitable(function)
    registered["callable"] = len(choices.CALLABLE)
    for name in set(choices.METHODS) - methods_known:
        attributes.add_method(name, choices.method_chooser(name), INLINED)
        methods_known.add(name)
    for name in set(choices.PROPERTIES) - properties_known:
        attributes.add_property(name, choices.property_chooser(name), INLINED)
        properties_known.add(name)


@typeof_impl.register(TieredFunction)
def type_of_tiered(function: TieredFunction, context: Any) -> Any:
    """The numba type of a function of this package that compiled code calls."""
    if function.inner is None:
        early = {"pipeline_class": EarlyCompiler} if function.options.get("forceinline") else {}
        function.inner = numba.njit(**OPTIONS | function.options | early)(function.py_func)
    return types.Dispatcher(function.inner)


# ---- functions that only compiled code calls ----------------------------------------------------


class LeanLibrary(JITCodeLibrary):
    """A compiled function that stays in LLVM's intermediate language, unless Python calls it.

    It is optimized, and becomes machine code, as a part of its callers. Functions by EarlyCompiler
    are optimized by themselves as well.
    """

    is_entry = False
    is_early = False

    def finalize(self) -> None:
        if self.is_entry or self.is_early:
            self._linking_libraries = self.find_parts()
            super().finalize()
        self._finalized = True

    def find_parts(self) -> list[Any]:
        """The libraries of all functions that it calls, callers first: LLVM drops what nobody calls
        when it is linked. A function by EarlyCompiler has those that it calls within.
        """
        found = dict[Any, None]()

        def visit(library: Any) -> None:
            for part in library._linking_libraries:
                if part not in found:
                    if isinstance(part, LeanLibrary) and not part.is_early:
                        visit(part)
                    found[part] = None

        visit(self)
        return list(found)[::-1]

    def _optimize_final_module(self) -> None:
        if self.is_entry:
            super()._optimize_final_module()
        else:
            passes, builder = self._codegen._module_pass_manager()
            passes.run(self._final_module, builder)

    def _verify_declare_only_symbols(self) -> None:
        """Refuse code that calls a function that was not linked: it would crash a user's process.

        Numba's own looks for functions of numba alone.
        """
        for function in self._final_module.functions:
            if function.is_declaration and function.name.startswith("_ZN"):
                raise TypeError(f"{function.name} is called, and was not linked")

    def _finalize_final_module(self) -> None:
        if self.is_entry:
            super()._finalize_final_module()

    def get_pointer_to_function(self, name: str) -> int:
        return int(super().get_pointer_to_function(name)) if self.is_entry else 0


def executable(self: Any, library: Any, description: Any, environment: Any) -> Any:
    """numba's get_executable, but with a dummy entry for functions that Python does not call."""
    if not isinstance(library, LeanLibrary) or library.is_entry:
        return executable_of_numba(self, library, description, environment)
    name = description.qualname.rpartition(".")[2]
    return _dynfunc.make_function(
        description.lookup_module(), name, name, 0, environment, (library,)
    )


def entry_from_python(self: Any, release_gil: bool) -> None:
    """numba's create_cpython_wrapper, only for functions that Python calls."""
    if not isinstance(self.library, LeanLibrary) or self.library.is_entry:
        entry_from_python_of_numba(self, release_gil)


def entry_from_c(self: Any) -> None:
    """Replaces numba's create_cfunc_wrapper: C calls none of the functions."""


executable_of_numba = cpu.CPUContext.get_executable
entry_from_python_of_numba = Lower.create_cpython_wrapper


@contextmanager
def lean_libraries(kind: type[JITCodeLibrary]) -> Iterator[None]:
    """Make new libraries of a lean kind while the block runs."""
    codegen = numba.core.registry.cpu_target.target_context.codegen()
    with (
        replaced(codegen, "_library_class", kind),
        replaced(cpu.CPUContext, "get_executable", executable),
        replaced(Lower, "create_cpython_wrapper", entry_from_python),
        replaced(Lower, "create_cfunc_wrapper", entry_from_c),
    ):
        yield


@contextmanager
def replaced(owner: Any, name: str, value: Any) -> Iterator[None]:
    """Give an attribute another value while the block runs."""
    usual = getattr(owner, name)
    setattr(owner, name, value)
    try:
        yield
    finally:
        setattr(owner, name, usual)


# ---- functions that Python calls ----------------------------------------------------------------


class EntryCompiler(CompilerBase):
    """numba's usual passes, for a function that Python calls."""

    mark = "is_entry"

    def define_pipelines(self) -> list[Any]:
        name = self.state.func_id.func_qualname
        library = self.state.library = self.state.targetctx.codegen().create_library(name)
        library.enable_object_caching()
        setattr(library, self.mark, True)
        return [DefaultPassBuilder.define_nopython_pipeline(self.state)]


class EarlyCompiler(EntryCompiler):
    """The same passes, for a function that is optimized before its callers, and again with them.

    So are generic functions of several records, which are the questions about collision, and
    `inlined` kernels: batches of points and motions take a fifth less time. If all functions were,
    a car's tree would take a fifth more time, and the compiler a quarter more.
    """

    mark = "is_early"


def borrowing(function: Function) -> Function:
    """Wrap an algorithm so that it borrows the arrays of its arguments.

    No references to them are counted while it runs, which makes planners two and a half times as
    fast. It may write into the arrays, but must return only numbers and its own arrays.
    """
    inner = numba.njit(**{**OPTIONS, "forceinline": True})(function)
    # Every argument has a name, because numba takes 0.2 ms for an *args tuple with a Generator.
    names = ", ".join(inspect.signature(function).parameters)
    scope = {"inner": inner, "borrowed": borrowed, "__name__": function.__module__}
    exec(f"def {function.__name__}({names}): return inner(*borrowed(({names},)))", scope)
    return scope[function.__name__]


@intrinsic
def borrowed(typing_context: Any, value: Any) -> Any:
    """The same value, with arrays that have no owners."""

    def disowned(context: Any, builder: Any, kind: Any, item: Any) -> Any:
        if isinstance(kind, types.Array):
            array = cgutils.create_struct_proxy(kind)(context, builder, value=item)
            array.meminfo = cgutils.get_null_value(array.meminfo.type)
            array.parent = cgutils.get_null_value(array.parent.type)
            return array._getvalue()
        if isinstance(kind, types.BaseTuple):
            items = zip(kind, cgutils.unpack_tuple(builder, item), strict=True)
            return context.make_tuple(
                builder, kind, [disowned(context, builder, k, i) for k, i in items]
            )
        context.nrt.incref(builder, kind, item)
        return item

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return disowned(context, builder, signature.args[0], args[0])

    return value(value), generate
