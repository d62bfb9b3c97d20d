"""The state of an algorithm's arguments, saved so that the algorithm can be begun again."""

from typing import Any

import numpy as np


def copy_state(value: object) -> Any:
    """Copy what an algorithm may change in a value: arrays and a generator's state."""
    if isinstance(value, np.ndarray):
        return value.copy() if value.flags.writeable else None
    if isinstance(value, np.random.Generator):
        return value.bit_generator.state
    return [copy_state(field) for field in value] if isinstance(value, tuple) else None


def restore_state(value: Any, saved: Any) -> None:
    """Restore the copied state of a value."""
    if saved is None:
        return
    if isinstance(value, np.ndarray):
        value[...] = saved
    elif isinstance(value, np.random.Generator):
        value.bit_generator.state = saved
    else:
        for field, before in zip(value, saved, strict=True):
            restore_state(field, before)
