"""The exercise `order_of_error`. LaValle, section 14.3.2."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ...exercise import Axes, Case, Change, Restated, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ...withheld import withheld
from ..shared.car_pictures import draw_orders


@withheld
def orders(h: Array, errors: Array) -> Array:
    """Order of the error between neighbouring steps, shape (n - 1,).

    It is log(e_i / e_i+1) / log(h_i / h_i+1).
    """
    h, errors = np.asarray(h, float), np.asarray(errors, float)
    return np.log(errors[:-1] / errors[1:]) / np.log(h[:-1] / h[1:])


class OrderOfError(ValueExercise):
    """The order of a method, from measured errors and their steps."""

    name = "order_of_error"
    lesson = "12_the_car"
    kinds = ("halves", "steps", "rising", "floor")
    given = Record(h=Numbers(("n",)), errors=Numbers(("n",)))
    answer = Numbers(("k",))
    source = staticmethod(orders)
    slips = (
        Slip("halves", lambda h, e: np.log2(e[:-1] / e[1:])),
        Slip("ratio", lambda h, e: e[:-1] / e[1:]),
        Slip("ratios", lambda h, e: (e[:-1] / e[1:]) / (h[:-1] / h[1:])),
        Slip("upside_down", lambda h, e: 1.0 / orders(h, e)),
        Slip("sign", lambda h, e: -orders(h, e)),
        Slip("one_point", lambda h, e: (np.log(e) / np.log(h))[1:]),
        Slip("one_point", lambda h, e: (np.log(e) / np.log(h))[:-1]),
        Slip("from_first", lambda h, e: np.log(e[0] / e[1:]) / np.log(h[0] / h[1:])),
        Slip("no_log", lambda h, e: np.diff(e) / np.diff(h)),
        Slip("never_negative", lambda h, e: np.maximum(orders(h, e), 0.0)),
        Slip("one_slope", lambda h, e: np.full(len(h) - 1, np.polyfit(np.log(h), np.log(e), 1)[0])),
        Slip("rounded", lambda h, e: np.round(orders(h, e))),
    )
    reference = staticmethod(orders)

    changes = (
        Change(
            "from_first",
            lambda orders, h, e: np.array(
                [orders(h[[0, i]], e[[0, i]])[0] for i in range(1, len(h))]
            ),
        ),
        Restated(
            "factor",
            answer=lambda p, *given: np.power(2.0, p),
            usual_answer=lambda factor, *given: np.log2(factor),
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Powers of two first, then errors with noise."""
        yield order_case("halves", (0.8, 0.4), (0.06, 0.03))
        yield order_case("halves", (0.8, 0.4, 0.2), (0.32, 0.02, 0.00125))
        yield order_case("steps", (0.9, 0.3), (0.9, 0.1))
        yield order_case("rising", (0.1, 0.2, 0.4), (0.01, 0.02, 0.04))
        yield order_case("floor", (0.2, 0.1, 0.05), (0.000001, 0.000001, 0.000004))
        yield order_case("floor", (0.1, 0.05), (4e-15, 2e-16))
        for _ in range(12):
            n, p, c = int(rng.integers(2, 6)), int(rng.integers(1, 5)), rng.uniform(0.1, 20)
            halves = rng.choice([0.2, 0.4, 0.8, 1.6]) / 2.0 ** np.arange(n)
            uneven = np.round(rng.uniform(0.5, 0.9) * np.cumprod(rng.uniform(0.2, 0.8, n)), 4)
            noise = rng.uniform(0.9, 1.1, n)
            yield order_case("halves", halves, c * halves**p * noise)
            yield order_case("steps", uneven, c * uneven**p * noise)
            yield order_case("rising", uneven[::-1], c * uneven[::-1] ** p * noise)
            yield order_case("floor", halves, 1e-12 * rng.uniform(1.1, 2.0, n) ** np.arange(n))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the errors against the step, both on logarithmic scales."""
        draw_orders(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def order_case(kind: str, h: Value, errors: Value) -> Case:
    """Case of steps and their errors."""
    return Case(
        kind, {"h": np.array(h, float), "errors": np.array([float(f"{e:.4g}") for e in errors])}
    )
