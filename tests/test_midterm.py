"""The midterm: variants differ, seeds repeat, and answers are right by other computations."""

import itertools
import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from kinoedu.cli import main
from kinoedu.course.midterm import make_papers, read_midterm, write_midterm
from kinoedu.course.release import FOLDERS_FOR_STUDENTS
from kinoedu.errors import InvalidParameter

QUESTIONS = read_midterm()
BY_NAME = {one.name: one for one in QUESTIONS}


def draw(name, seed):
    """A question with numbers, and the whole numbers of its answer."""
    asked = BY_NAME[name].draw(np.random.default_rng(seed))
    return asked, [int(n) for n in re.findall(r"-?\d+", asked.answer)]


def test_variants_differ_and_seeds_repeat():
    """Every question of four variants has its own answer; another variant changes no other."""
    for seed in range(3):
        papers = make_papers(QUESTIONS, seed, "ABCD")
        for place in range(len(QUESTIONS)):
            assert len({paper.questions[place][1].answer for paper in papers}) == 4
        assert make_papers(QUESTIONS, seed, "AB") == papers[:2]
    assert make_papers(QUESTIONS, 0, "A") != make_papers(QUESTIONS, 1, "A")
    assert [one.lesson[:2] for one in QUESTIONS] == [f"{n:02}" for n in range(1, 9)]


def test_too_many_variants_are_refused():
    """Also two of one name, a seed below zero, and names that are no file names."""
    few = [BY_NAME["count_the_cells"]]
    with pytest.raises(InvalidParameter, match="different answers"):
        make_papers(few, 0, "ABCDEFGHIJ")
    with pytest.raises(InvalidParameter, match="different names"):
        make_papers(few, 0, "AA")
    assert main(["midterm", "--seed", "-1", "--out", "nowhere"]) == 2
    assert main(["midterm", "--seed", "1", "--out", "nowhere", "--variants", "../A"]) == 2
    assert not Path("nowhere").exists()


def test_students_have_no_questions(tmp_path):
    """The kit has no folder of solutions; the command says so there."""
    assert "solutions" not in FOLDERS_FOR_STUDENTS
    with pytest.raises(InvalidParameter, match="students' copies"):
        write_midterm(tmp_path / "out", 0, house=tmp_path)


def test_papers_have_no_answers_and_solutions_have_all(tmp_path):
    """Markdown and HTML; nothing in the HTML is fetched."""
    assert main(["midterm", "--seed", "5", "--out", str(tmp_path / "exam")]) == 0
    paper, _ = make_papers(QUESTIONS, 5, "AB")
    for name, solved in (("midterm_A", False), ("solutions_A", True)):
        text = (tmp_path / "exam" / f"{name}.md").read_text(encoding="utf-8")
        page = (tmp_path / "exam" / f"{name}.html").read_text(encoding="utf-8")
        assert "http" not in page
        assert page.count("<section>") == len(QUESTIONS)
        for _, asked in paper.questions:
            assert asked.text in text
            assert (asked.answer in text) == solved
            assert (asked.solution in text) == solved


SEEDS = pytest.mark.parametrize("seed", range(12))


def points_in(text):
    """The points of a text."""
    return [tuple(map(int, pair)) for pair in re.findall(r"\((-?\d+), (-?\d+)\)", text)]


@SEEDS
def test_segment_and_line(seed):
    """The robot is beyond p2, by a triangle 3, 4, 5."""
    asked, answer = draw("segment_and_line", seed)
    (x1, y), (x2, _), (x, up) = points_in(asked.text)
    assert answer[:2] == [round(np.hypot(x - x2, up - y)), up - y]
    assert Fraction(*answer[2:]) == Fraction(x - x1, x2 - x1) > 1


@SEEDS
def test_round_a_box(seed):
    """The sides of the box, added up."""
    asked, answer = draw("round_a_box", seed)
    (a, low), _, (b, high), _, _, (goal, _) = points_in(asked.text)
    around = 2 * (b - a + high - low)
    assert answer[0] == goal + 2 * high
    assert answer[1] == goal - (b - a) + around + (b - a) + 2 * high
    assert abs(float(asked.answer.rpartition(" ")[2]) - (goal + 1.5 * around)) < 1e-9


@SEEDS
def test_cheapest_path(seed):
    """All simple paths, tried one by one; the cheapest is the only one."""
    asked, _ = draw("cheapest_path", seed)
    found = re.findall(r"(\d)-(\d): (\d)", asked.text)
    weight = {(int(a), int(b)): int(w) for a, b, w in found}
    weight |= {(b, a): w for (a, b), w in weight.items()}
    costs = {}
    for n in range(5):
        for between in itertools.permutations(range(1, 5), n):
            path = (0, *between, 5)
            if all(pair in weight for pair in itertools.pairwise(path)):
                costs[path] = sum(weight[pair] for pair in itertools.pairwise(path))
    best = min(costs, key=costs.get)
    assert list(costs.values()).count(costs[best]) == 1
    assert f"(b) {', '.join(map(str, best))}, cost {costs[best]};" in asked.answer
    assert asked.answer.endswith(f"(c) {min(map(len, costs)) - 1}")


@SEEDS
def test_arm_and_headings(seed):
    """Complex numbers for the arm; the shorter of two arcs."""
    asked, _ = draw("arm_and_headings", seed)
    l1, l2 = map(int, re.search(r"links (\d) and (\d)", asked.text).groups())
    one, two, a, b = map(int, re.findall(r"(-?\d+)°", asked.text))
    elbow = l1 * 1j ** (one // 90)
    tip = elbow + l2 * 1j ** ((one + two) // 90)
    assert points_in(asked.answer) == [(p.real, p.imag) for p in (elbow, tip)]
    assert f"from {l1 - l2} to {l1 + l2}; (c) {min(a - b, 360 - (a - b))}°" in asked.answer


@SEEDS
def test_grid_and_halton(seed):
    """The digits, mirrored in fractions."""
    asked, answer = draw("grid_and_halton", seed)
    n, k, i = (
        int(re.search(p, asked.text)[1]) for p in (r"of (\d+) p", r"1/(\d+)", r"number (\d+)")
    )
    assert n == k * k
    assert answer[:3] == [1, 2 * k, k]
    for base, mirrored in ((2, Fraction(*answer[3:5])), (3, Fraction(*answer[5:7]))):
        digits = np.base_repr(i, base)[::-1]
        assert mirrored == sum(Fraction(int(d), base ** (e + 1)) for e, d in enumerate(digits))


@SEEDS
def test_box_and_triangle(seed):
    """The convex hull of all differences, by another library."""
    import shapely

    asked, _ = draw("box_and_triangle", seed)
    (_, (a, _), (_, b), *rest), corners = points_in(asked.text), points_in(asked.answer)
    box = rest[-4:]
    robot = [(0, 0), (a, 0), (0, b)]
    hull = shapely.MultiPoint([(x - u, y - v) for x, y in box for u, v in robot]).convex_hull
    assert shapely.Polygon(corners).equals(hull)
    assert len(corners) == 5


@SEEDS
def test_closest_on_a_line(seed):
    """Each node sorts the others by distance; a tie goes to the lower number."""
    asked, _ = draw("closest_on_a_line", seed)
    xs = [int(n) for n in re.search(r"x-axis at ([\d, ]+)\.", asked.text)[1].split(", ")]
    k = int(re.search(r"K = (\d)", asked.text)[1])
    pairs = set()
    for i, x in enumerate(xs):
        others = sorted((abs(x - y), j) for j, y in enumerate(xs) if j != i)[:k]
        pairs |= {(min(i, j), max(i, j)) for _, j in others}
    most = max(sum(i in pair for pair in pairs) for i in range(len(xs)))
    edges = ", ".join(f"{a}-{b}" for a, b in sorted(pairs))
    assert asked.answer == f"(a) {edges}; (b) {most}"


@SEEDS
def test_count_the_cells(seed):
    """Three cells, and four more for each triangle."""
    asked, answer = draw("count_the_cells", seed)
    n = int(re.search(r"(\d) triangles", asked.text)[1])
    assert answer == [3, 3 + 4 * n]


def test_no_paper_overwrites_another():
    """Disks of Windows and macOS have one file for both names."""
    with pytest.raises(InvalidParameter, match="different names"):
        make_papers([], 0, ["A", "a"])
