"""States of numpy's random generators as plain data."""

from typing import Any

import numpy as np


def plain_state(state: Any) -> Any:
    """A state that can be compared and written as JSON: its arrays are lists."""
    if isinstance(state, dict):
        return {name: plain_state(part) for name, part in state.items()}
    return state.tolist() if isinstance(state, np.ndarray | np.generic) else state
