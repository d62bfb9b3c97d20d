"""The exercise on planning in time: earliest arrival by safe intervals.

M. Phillips, M. Likhachev, "SIPP: Safe interval path planning for dynamic environments" (2011).
"""

import math
from collections.abc import Iterator
from heapq import heappop, heappush

import numpy as np

from ....planners.moving.safe_intervals import search_intervals
from ...exercise import RIGHT, Axes, Case, Exercise, Restated, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Numbers, Record, Value
from ...whole_shapes import Integer
from ...withheld import withheld
from .pictures import draw_schedule

LATE = 1e-6  # tolerance of times
END = 30.0

Safe = list[list[tuple[float, float]]]
Rows = list[tuple[float, float]]


@withheld
def find_schedule(safe: Value, moves: Value, start: int, goal: int) -> Rows:
    """Find a path in time with the earliest arrival at the goal.

    Returns
    -------
    Rows (place, time of arrival); empty where there is no path.
    """
    intervals = [[(float(b), float(e)) for b, e in own] for own in safe]
    ways = find_adjacent_places(moves)
    first = next((k for k, (b, e) in enumerate(intervals[start]) if b <= 0.0 <= e), None)
    waiting: list[tuple[float, int, int, Rows]] = (
        [] if first is None else [(0.0, start, first, [(start, 0.0)])]
    )
    done: set[tuple[int, int]] = set()
    while waiting:
        arrived, u, k, rows = heappop(waiting)
        if u == goal:
            return rows
        if (u, k) in done:
            continue
        done.add((u, k))
        for v, duration in ways.get(u, []):
            for j, (begin, end) in enumerate(intervals[v]):
                there = max(arrived + duration, begin)
                if there <= end and there - duration <= intervals[u][k][1] and (v, j) not in done:
                    heappush(waiting, (there, v, j, [*rows, (v, there)]))
    return []


def find_adjacent_places(moves: Value) -> dict[int, list[tuple[int, float]]]:
    """Return for each place its adjacent places, each with the duration of the move."""
    ways: dict[int, list[tuple[int, float]]] = {}
    for u, v, duration in moves:
        ways.setdefault(int(u), []).append((int(v), float(duration)))
        ways.setdefault(int(v), []).append((int(u), float(duration)))
    return ways


def find_schedule_fault(safe: Value, moves: Value, start: int, goal: int, rows: Value) -> str:
    """Return the first rule that a schedule breaks, or "".

    Whether the arrival is the earliest is not checked.
    """
    if not any(b <= 0.0 <= e for b, e in safe[start]):
        return "begin"
    if not np.isfinite(rows).all() or rows[0][0] != start or abs(rows[0][1]) > LATE:
        return "start"
    ways = find_adjacent_places(moves)
    for (u, arrived), (v, there) in zip(rows, rows[1:]):
        if u == v:
            return "own_row"
        durations = [duration for w, duration in ways.get(u, []) if w == v]
        if not durations:
            return "move"
        left = there - min(durations)
        if left < arrived - LATE:
            return "too_fast"
        if not any(
            b - LATE <= arrived and left <= e + LATE for b, e in safe[int(u)] if arrived <= e + LATE
        ):
            return "wait"
        if not any(b - LATE <= there <= e + LATE for b, e in safe[int(v)]):
            return "unsafe"
    return "" if rows[-1][0] == goal else "goal"


class EarliestArrival(Exercise):
    """Find the path in time that reaches the goal first, waiting where something passes."""

    name = "earliest_arrival"
    lesson = "14_moving_and_uncertain"
    kinds = ("go", "wait", "aside", "again", "none")
    given = Record(
        safe=Listed(Numbers(("k", 2))), moves=Numbers(("m", 3)), start=Integer(), goal=Integer()
    )
    answer = Numbers(("n", 2))
    source = staticmethod(find_schedule)
    shown = staticmethod(search_intervals)

    changes = (
        Restated("from_goal", answer=lambda rows, *given: np.reshape(rows, (-1, 2))[::-1]),
        Restated("time_first", answer=lambda rows, *given: np.reshape(rows, (-1, 2))[:, ::-1]),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield cases with two places, then with three, then random ones."""
        always = [(0, END)]
        yield make_case("go", [always, always], [(0, 1, 4)], 0, 1)
        yield make_case("go", [always, always], [(1, 0, 3)], 0, 1)
        yield make_case("go", [always, [(0, 3), (6, END)]], [(0, 1, 2)], 0, 1)
        yield make_case("go", [always, always, always], [(0, 1, 2), (1, 2, 3), (0, 2, 7)], 0, 2)
        yield make_case(
            "go", [[(0, 4), (7, END)], always, [(0, 1), (10, END)]], [(0, 1, 2), (0, 2, 1)], 0, 2
        )
        shortcut = [(0, 1, 9), (0, 2, 1), (1, 2, 1), (1, 3, 1)]
        yield make_case("go", [always, always, always, always], shortcut, 0, 3)
        yield make_case("go", [always], np.empty((0, 3)), 0, 0)
        yield make_case("go", [[(-5, -1), (-0.5, 4)], always], [(0, 1, 2)], 0, 1)
        yield make_case("go", [[(-3, 0)], always], [(0, 1, 2)], 0, 1)
        yield make_case("go", [[(-3, 0)]], np.empty((0, 3)), 0, 0)
        yield make_case("go", [always, [(1 / 3, 2 / 3)]], [(0, 1, 0.4)], 0, 1)
        yield make_case("wait", [always, [(0, 3), (6, END)]], [(0, 1, 4)], 0, 1)
        yield make_case(
            "wait", [always, [(0, 2), (5, 9), (11, END)], always], [(0, 1, 3), (1, 2, 1)], 0, 2
        )
        yield make_case("wait", [[(0, 5000)], [(1, 3), (4000, 4010)]], [(0, 1, 4)], 0, 1)
        yield make_case("wait", [always, [(0, 1), (8, 8)]], [(0, 1, 2)], 0, 1)
        yield make_case(
            "aside", [[(0, 4), (7, END)], always, [(10, END)]], [(0, 1, 2), (0, 2, 1)], 0, 2
        )
        yield make_case(
            "again", [always, [(0, 3), (6, END)], [(0, 1), (7, END)]], [(0, 1, 2), (1, 2, 2)], 0, 2
        )
        # the start is visited three times
        thrice = [[(0, 2), (4, 6), (8, 10)], [(1, 4.5), (6.5, 9)], [(10.5, END)]]
        yield make_case("again", thrice, [(0, 1, 1), (0, 2, 1)], 0, 2)
        yield make_case("none", [[(0, 5)], [(8, END)]], [(0, 1, 2)], 0, 1)
        yield make_case("none", [always, always, always], [(0, 1, 2)], 0, 2)
        yield make_case("none", [[(2, END)], always], [(0, 1, 2)], 0, 1)
        yield make_case("none", [[(2, END)]], np.empty((0, 3)), 0, 0)
        yield make_case("none", [[], always], [(0, 1, 2)], 0, 1)
        wanted = dict.fromkeys(self.kinds, 8)
        for _ in range(4000):
            if not any(wanted.values()):
                return
            safe, moves, start, goal = draw_roadmap(rng)
            kind = classify(safe, moves, start, goal)
            if kind and wanted[kind]:
                wanted[kind] -= 1
                yield make_case(kind, safe, moves, start, goal)

    def value_verdict(self, case: Case, value: object) -> Verdict:
        """Judge that the schedule keeps every rule and arrives as early as possible."""
        safe, moves, start, goal = case.given.values()
        best, rows = find_schedule(safe, moves, start, goal), np.asarray(value).tolist()
        rule = find_schedule_fault(safe, moves, start, goal, rows) if rows else ""
        if best and not rows:
            rule = "already" if start == goal else "found"
        elif best and not rule and rows[-1][1] > best[-1][1] + LATE:
            rule = "later"
        if rule in ("later", "found"):
            rule = find_misread_rule(safe, moves, start, goal, rows) or rule
        if rule == "found" and not is_first_from_zero(safe[start]):
            rule = "contains"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe one right answer."""
        best = find_schedule(*case.given.values())
        if not best:
            return self.message("no_way")
        rows = format_value([tuple(row) for row in self.as_asked(best, case)])
        return self.message("wanted", time=format_value(best[-1][1]), rows=rows)

    def ask_for_answers(self, case: Case) -> None:
        """Ask for the right schedule, and for the arrivals if a rule is misread."""
        super().ask_for_answers(case)
        find_misread_arrivals(*case.given.values())

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the safe intervals of each place, a right path and the student's."""
        value = outcome.value if isinstance(outcome, Answer) else None
        draw_schedule(self, case, find_schedule(*case.given.values()), value, ax)


def find_misread_rule(safe: Value, moves: Value, start: int, goal: int, rows: Rows) -> str:
    """Return the rule that the student probably misread, or "".

    It is the rule without which these rows would have the earliest arrival.
    """
    theirs = find_arrival(rows)
    for rule, ours in find_misread_arrivals(safe, moves, start, goal):
        if ours == theirs or abs(ours - theirs) < 2.0 * LATE:
            return rule
    return ""


@withheld
def find_misread_arrivals(
    safe: Value, moves: Value, start: int, goal: int
) -> list[tuple[str, float]]:
    """Return rules that can be misread, each with the earliest arrival without it."""
    open_ends = [[(b, e - LATE) for b, e in own] for own in safe]
    last_only = [own[-1:] if place == goal else own for place, own in enumerate(safe)]
    return [
        (rule, find_arrival(find_schedule(other, moves, start, goal)))
        for rule, other in (("closed", open_ends), ("forever", last_only))
    ]


def is_first_from_zero(own: Value) -> bool:
    """Whether the first interval of a place begins at 0, and ends later."""
    return bool(own[0][0] == 0.0 < own[0][1])


def find_arrival(rows: Rows) -> float:
    """Return when a schedule ends; infinity where it has no rows."""
    return rows[-1][1] if rows else math.inf


@withheld
def classify(safe: Safe, moves: Value, start: int, goal: int) -> str:
    """Return the kind of a case by what a right path does; "" where the case is dull."""
    best = find_schedule(safe, moves, start, goal)
    if not best:
        return "none"
    places = [place for place, _ in best]
    if len(set(places)) < len(places):
        return "aside"
    once = search_one_arrival_each(safe, moves, start, goal)
    if once > best[-1][1] + LATE:
        return "again"
    durations = {(u, v): d for u, own in find_adjacent_places(moves).items() for v, d in own}
    waits = sum(b - a - durations[int(u), int(v)] > LATE for (u, a), (v, b) in zip(best, best[1:]))
    return "wait" if waits else "go" if len(best) > 2 else ""


def search_one_arrival_each(safe: Safe, moves: Value, start: int, goal: int) -> float:
    """Return the arrival of a search that keeps one arrival for each place."""
    ways, done, waiting = find_adjacent_places(moves), set[int](), [(0.0, start)]
    while waiting:
        arrived, u = heappop(waiting)
        if u == goal:
            return arrived
        if u in done:
            continue
        done.add(u)
        last = max((e for b, e in safe[u] if b <= arrived <= e), default=-1.0)
        for v, duration in ways.get(u, []):
            times = [
                max(arrived + duration, b)
                for b, e in safe[v]
                if max(arrived + duration, b) <= min(e, last + duration)
            ]
            if times:
                heappush(waiting, (min(times), v))
    return math.inf


def draw_roadmap(rng: np.random.Generator) -> tuple[Safe, Value, int, int]:
    """Draw places in a row or a ring with random safe intervals.

    Times are multiples of 4, 1/2, 1/16 or 1/128, so that a program with a fixed time step misses
    them.
    """
    n, parts = int(rng.integers(3, 8)), float(rng.choice((0.25, 2, 16, 128)))
    safe: Safe = []
    for _ in range(n):
        safe.append(draw_intervals(parts, rng))
        if rng.random() < 0.1:
            safe[-1] = safe[-1][1:]
    pairs = [(k, k + 1) for k in range(n - 1)]
    pairs += [
        (int(u), int(v))
        for u, v in rng.integers(0, n, (int(rng.integers(0, 3)), 2))
        if abs(u - v) > 1
    ]
    moves = [
        (u, v, float(rng.integers(1, round(max(4.0 * parts, 4.0)) + 1)) / parts)
        for u, v in dict.fromkeys(tuple(sorted(pair)) for pair in pairs)
    ]
    return safe, moves, 0, n - 1


def draw_intervals(parts: float, rng: np.random.Generator) -> list[tuple[float, float]]:
    """Draw the safe intervals of a place, as multiples of 1 / parts.

    Some begin before 0, and some last only for a moment.
    """
    end = END * max(1.0, 2.0 / parts)
    ends = np.unique(rng.integers(1, round(parts * (end - end / 3)), 2 * int(rng.integers(0, 4))))
    marks = [0.0, *(ends[: len(ends) // 2 * 2] / parts).tolist(), end]
    own = [(a, a if a > 0.0 and rng.random() < 0.1 else b) for a, b in zip(marks[::2], marks[1::2])]
    before = float(rng.integers(1, 9)) / parts
    if rng.random() < 0.3:
        own[0] = (-before, own[0][1])
    if rng.random() < 0.2:
        own.insert(0, (-before - 3.0, -before - float(rng.integers(1, 3))))
    return own


def make_case(kind: str, safe: Value, moves: Value, start: int, goal: int) -> Case:
    """Return a case of a roadmap."""
    rows = [np.reshape(np.array(own, float), (-1, 2)) for own in safe]
    rows_of_moves = np.reshape(np.array(moves, float), (-1, 3))
    return Case(kind, {"safe": rows, "moves": rows_of_moves, "start": start, "goal": goal})
