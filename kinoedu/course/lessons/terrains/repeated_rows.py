"""The exercise on repeated numbers in a table of measurements, which chance rarely makes."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ...exercise import Axes, Case, Restated, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ...whole_shapes import Integers
from ...withheld import withheld

# path length and seconds of RRT on six terrains, then of PRM on the same terrains: P. A. Maniar,
# "AI path prediction and planning for autonomous vehicles", section 6
PUBLISHED = (
    (810.1928, 11.88077),
    (1295.298, 36.51574),
    (925.14, 23.3382),
    (1400.944, 36.13657),
    (1388.704, 36.13657),
    (1718.973, 25.15795),
    (685.8932, 7.299953),
    (1076.54, 6.519054),
    (925.14, 23.3382),
    (1311.246, 9.929559),
    (1228.797, 5.207032),
    (1433.969, 9.230730),
)


class RepeatedRows(ValueExercise):
    """Find pairs of rows that have the same number in the same column."""

    name = "repeated_rows"
    lesson = "10_terrains"
    kinds = ("none", "one_column", "whole_rows", "far_apart", "three_alike", "missing")
    given = Record(table=Numbers(("n", "m")))
    answer = Integers(("k", 3))
    slips = (
        Slip("neighbours", lambda table: [r for r in find_repeats(table) if r[1] == r[0] + 1]),
        Slip(
            "whole",
            lambda table: [r for r in find_repeats(table) if (table[r[0]] == table[r[1]]).all()],
        ),
        Slip("one_each", lambda table: keep_one_each(find_repeats(table))),
        Slip("first_column", lambda table: [r for r in find_repeats(table) if r[2] == 0]),
        Slip("from_one", lambda table: [(i + 1, j + 1, c + 1) for i, j, c in find_repeats(table)]),
        Slip(
            "both_ways",
            lambda table: [r for i, j, c in find_repeats(table) for r in ((i, j, c), (j, i, c))],
        ),
        Slip(
            "itself",
            lambda table: sorted(
                find_repeats(table) + [(i, i, c) for i, c in np.argwhere(table == table).tolist()]
            ),
        ),
        Slip("missing", lambda table: find_repeats(np.where(np.isnan(table), -1.0, table))),
        Slip("close", lambda table: find_repeats(table, 0.5)),
        Slip("close", lambda table: find_repeats(table, 0.01)),
    )

    changes = (
        Restated("later_first", answer=lambda triples, *given: [(j, i, c) for i, j, c in triples]),
        Restated(
            "column_first",
            answer=lambda triples, *given: [(c, i, j) for i, j, c in triples],
            usual_answer=lambda triples, *given: [(i, j, c) for c, i, j in triples],
        ),
    )

    @staticmethod
    @withheld
    def reference(table: Array) -> list[tuple[int, int, int]]:
        """Return every pair, column by column."""
        return find_repeats(table)

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield two rows, the published table, then random tables with copied numbers."""
        nan = float("nan")
        for kind, rows in (
            ("none", [[1, 2], [2, 1]]),
            ("one_column", [[1, 2], [3, 2]]),
            ("whole_rows", [[1, 2], [1, 2]]),
            ("far_apart", [[5, 2], [3, 4], [5, 6]]),
            ("three_alike", [[7.0], [7.0], [7.0]]),
            ("three_alike", [[7.0], [7.0], [7.0], [7.0]]),
            ("one_column", [[0.0, 1.0], [0.0, 2.0]]),
            ("one_column", [[1, 2, 3, 4, 5], [6, 7, 8, 9, 5]]),
            ("missing", [[nan, 1], [nan, 2]]),
            ("none", [[812.1, 11.9], [812.4, 12.1]]),
            ("none", [[812.1001, 11.9], [812.1002, 12.1]]),
            ("none", [[0.1 + 0.2, 11.9], [0.3, 12.1]]),
            ("far_apart", PUBLISHED),
        ):
            yield Case(kind, {"table": np.array(rows, float)})
        for number in range(10):
            for kind in self.kinds:
                yield Case(kind, {"table": draw_table_at_random(kind, 4 + number, rng)})

    def same(self, value: Value, truth: Value) -> bool:
        """Whether both hold the same triples, each once, in any order."""
        return sorted(map(tuple, np.reshape(value, (-1, 3)).tolist())) == sorted(
            map(tuple, np.reshape(truth, (-1, 3)).tolist())
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the table, the repeats in green and the student's wrong entries in brown."""
        from .pictures import draw_table

        value = np.asarray(outcome.value) if isinstance(outcome, Answer) else None
        draw_table(self, case, value, self.truth(case), ax)


def find_repeats(table: Array, near: float = 0.0) -> list[tuple[int, int, int]]:
    """Return all (i, j, column), i < j, whose numbers differ by at most `near`.

    A missing number, nan, is equal to nothing.
    """
    n, m = table.shape
    return [
        (i, j, c)
        for i in range(n)
        for j in range(i + 1, n)
        for c in range(m)
        if abs(table[i, c] - table[j, c]) <= near
    ]


def keep_one_each(found: list[tuple[int, int, int]]) -> list[tuple[int, int, int]]:
    """Return the first triple of each pair of rows."""
    return [t for k, t in enumerate(found) if t[:2] not in {other[:2] for other in found[:k]}]


def draw_table_at_random(kind: str, n: int, rng: np.random.Generator) -> Array:
    """Draw lengths, seconds and counts of n runs, all different except for copies.

    In tables without copies, two numbers are close to each other.
    """
    table = np.column_stack(
        [700.0 + rng.permutation(10 * n)[:n] * 7.31, 5.0 + rng.permutation(9 * n)[:n] * 0.37]
    )
    table = np.column_stack([table, 20.0 + rng.permutation(5 * n)[:n]])
    i = int(rng.integers(0, n - 3))
    c = int(rng.integers(3))
    if kind == "none":
        table[i + 1, 0] = table[i, 0] * (1.0 + 1e-6)
    elif kind == "one_column":
        table[i + 1, c] = table[i, c]
    elif kind == "whole_rows":
        table[i + 1] = table[i]
    elif kind == "far_apart":
        table[n - 1, c] = table[i, c]
    elif kind == "three_alike":
        table[[i + 1, i + 2], c] = table[i, c]
    elif kind == "missing":
        table[[i, i + 2], c] = np.nan
    return table
