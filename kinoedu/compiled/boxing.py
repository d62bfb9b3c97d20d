"""Arguments and results of machine code, passed without a call of a Python function.

A thread may be stopped by an exception that another thread raises in it, or by Ctrl-C. It arrives
where a Python function begins. numba calls Python functions when it makes the arrays and named
tuples of a result, and when it takes a random generator, and does not look whether they failed. So
a thread stopped there ended the whole process. The functions here use Python's and numpy's C
functions alone, and are faster.
"""

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.boxing import box_tuple
from numba.core.pythonapi import NativeValue, _boxers, _unboxers
from numba.np.numpy_support import as_dtype

# numpy's struct bitgen_t: the state, and the functions that draw from it
BIT_GENERATOR_FIELDS = ("state", "fnptr_next_uint64", "fnptr_next_uint32", "fnptr_next_double")


def use_c_functions_alone() -> None:
    """Replace numba's ways in and out for the values that algorithms here take and return."""
    _boxers.functions[types.Array] = box_array
    _boxers.functions[types.NamedTuple] = _boxers.functions[types.NamedUniTuple] = box_named_tuple
    _unboxers.functions[types.NumPyRandomBitGeneratorType] = unbox_bit_generator


def box_array(typ: Any, value: Any, c: Any) -> Any:
    """A numpy array from an array of machine code."""
    constant = as_constant(c)
    array = cgutils.alloca_once_value(c.builder, value)
    signature = ir.FunctionType(
        c.pyapi.pyobj,
        [c.pyapi.voidptr, c.pyapi.pyobj, ir.IntType(32), ir.IntType(32), c.pyapi.pyobj],
    )
    made = c.builder.call(
        c.pyapi._get_function(signature, name="NRT_adapt_ndarray_to_python_acqref"),
        [
            c.builder.bitcast(array, c.pyapi.voidptr),
            constant(np.ndarray),
            c.context.get_constant(types.int32, typ.ndim),
            c.context.get_constant(types.int32, int(typ.mutable)),
            constant(as_dtype(typ.dtype)),
        ],
    )
    c.context.nrt.decref(c.builder, typ, value)
    return made


def box_named_tuple(typ: Any, value: Any, c: Any) -> Any:
    """A named tuple from a tuple of machine code, made as by `tuple.__new__`."""
    fields = box_tuple(typ, value, c)
    constant = as_constant(c)
    made = c.pyapi.call_function_objargs(
        constant(tuple.__new__), (constant(typ.instance_class), fields)
    )
    c.pyapi.decref(fields)
    return made


def unbox_bit_generator(typ: Any, generator: Any, c: Any) -> Any:
    """The state and the functions of numpy's random numbers, from the generator's capsule."""
    fields = cgutils.create_struct_proxy(typ)(c.context, c.builder)
    fields.parent = generator
    capsule = c.pyapi.object_getattr_string(generator, "capsule")
    pointer = ir.FunctionType(c.pyapi.voidptr, [c.pyapi.pyobj, c.pyapi.voidptr])
    name = c.context.insert_const_string(c.builder.module, "BitGenerator")
    struct = c.builder.call(
        c.pyapi._get_function(pointer, name="PyCapsule_GetPointer"), [capsule, name]
    )
    with c.builder.if_then(cgutils.is_not_null(c.builder, struct), likely=True):
        address = c.context.get_value_type(types.uintp)
        words = c.builder.bitcast(struct, address.as_pointer())
        for i, field in enumerate(BIT_GENERATOR_FIELDS):
            word = c.builder.load(cgutils.gep(c.builder, words, i))
            setattr(fields, field, word)
        fields.state_address = fields.state
        c.pyapi.decref(capsule)
    return NativeValue(fields._getvalue(), is_error=cgutils.is_null(c.builder, struct))


def as_constant(c: Any) -> Any:
    """A function that keeps a Python object with the machine code, and reads it there."""
    return lambda thing: c.env_manager.read_const(c.env_manager.add_const(thing))
