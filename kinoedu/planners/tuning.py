"""Checks of tuning parameters: each becomes a plain number, or an InvalidParameter is raised."""

from ..errors import InvalidParameter
from ..geometry.checks import integer, is_real, nonnegative, positive
from ..support.text import shortened

__all__ = ["fraction", "integer", "iteration_limit", "nonnegative", "one_of", "positive"]


def one_of(value: object, name: str, choices: tuple[str, ...]) -> str:
    """One of a few strings.

    Raises
    ------
    InvalidParameter
        Where the value is not one of `choices`.

    Examples
    --------
    >>> one_of("left", "turn", ("left", "right"))
    'left'
    """
    if not isinstance(value, str) or value not in choices:
        raise InvalidParameter(
            f"{name} must be {' or '.join(map(repr, choices))}, got {shortened(value)}"
        )
    return value


def iteration_limit(max_iterations: object, max_nodes: int) -> int:
    """The largest number of iterations; by default ten for each node.

    Raises
    ------
    InvalidParameter
        Where it is neither None nor an integer of zero or more.
    """
    if max_iterations is None:
        return 10 * max_nodes
    return integer(max_iterations, "max_iterations", least=0)


def fraction(value: object, name: str) -> float:
    """A number from 0 to 1 as a float.

    Raises
    ------
    InvalidParameter
        Where the value is not such a number.
    """
    if not is_real(value) or not 0.0 <= value <= 1.0:
        raise InvalidParameter(f"{name} must be a number from 0 to 1, got {shortened(value)}")
    return float(value)
