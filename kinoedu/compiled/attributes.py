"""Methods and properties of records in compiled code.

Those that numba's `overload_method` and `overload_attribute` add to all named tuples hide fields of
the same name in other records. These do not.
"""

from typing import Any

from numba import types
from numba.core.imputils import impl_ret_borrowed
from numba.core.typing.templates import (
    _OverloadAttributeTemplate,
    _OverloadMethodTemplate,
    infer_getattr,
    make_overload_attribute_template,
)
from numba.extending import overload

from .choices import Function


class RecordMethod(_OverloadMethodTemplate):
    """A method of the records without a field of its name."""

    def _resolve(self, kind: Any, name: str) -> Any:
        return None if name in kind.fields else super()._resolve(kind, name)


class RecordProperty(_OverloadAttributeTemplate):
    """A property of the records without a field of its name."""

    def _init_once(self) -> None:
        chosen = type(self)

        @self._get_target_registry("attribute").lower_getattr(chosen.key, chosen._attr)
        def read(context: Any, builder: Any, kind: Any, value: Any) -> Any:
            if chosen._attr in kind.fields:
                index = kind.fields.index(chosen._attr)
                item = builder.extract_value(value, index)
                return impl_ret_borrowed(context, builder, kind[index], item)
            function = chosen._get_function_type(context.typing_context, kind)
            signature = chosen._get_signature(context.typing_context, function, (kind,), {})
            call = context.get_function(function, signature)
            context.add_linking_libs(getattr(call, "libs", ()))
            return call(builder, (value,))

    def _resolve(self, kind: Any, name: str) -> Any:
        return None if name in kind.fields else super()._resolve(kind, name)


def add_method(name: str, choose: Function, options: dict[str, Any]) -> None:
    """Let compiled code call the method of a record that a function selects."""
    add_attribute(RecordMethod, name, choose, options)


def add_property(name: str, choose: Function, options: dict[str, Any]) -> None:
    """Let compiled code read the property of a record that a function selects."""
    add_attribute(RecordProperty, name, choose, options)


def add_attribute(base: Any, name: str, choose: Function, options: dict[str, Any]) -> None:
    """Tell numba of an attribute of records."""
    template = make_overload_attribute_template(
        types.BaseNamedTuple, name, choose, base=base, strict=False, jit_options=options
    )
    infer_getattr(template)
    overload(choose, strict=False, jit_options=options)(choose)
