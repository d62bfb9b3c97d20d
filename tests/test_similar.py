"""Copies are found though names, comments and order were changed.

Code that all students were given is no sign of copying, and no score depends on the result.
"""

import csv
import io
import random
from pathlib import Path

import pytest
from submissions import notebook

from kinoedu.cli import main
from kinoedu.grading.collect.notebook import read_cells
from kinoedu.grading.collect.submissions import Submission
from kinoedu.grading.report.fingerprints import (
    RUN,
    WINDOW,
    hash_text,
    select_fingerprints,
    split_program,
)
from kinoedu.grading.report.similar import find_similar
from kinoedu.grading.report.similar_page import write_similar

HOUSE = Path(__file__).resolve().parent.parent
NAME = "01_geometry"

OWN_WAY = """
def point_segment_distance(q, p1, p2):
    # walk along the segment, ever finer
    low, high = 0.0, 1.0
    for step in range(60):
        third = (high - low) / 3
        left, right = low + third, high - third
        if np.linalg.norm(q - p1 - left * (p2 - p1)) < np.linalg.norm(q - p1 - right * (p2 - p1)):
            high = right
        else:
            low = left
    return np.linalg.norm(q - p1 - low * (p2 - p1))
"""
HELPER = """
def corners_turn(ring, way=1):
    total = 0
    for before, here, after in zip(ring[-1:] + ring[:-1], ring, ring[1:] + ring[:1]):
        total += way * (here[0] - before[0]) * (after[1] - here[1])
    return total if total > 0 else -total
"""
DISGUISED = '''
def turning(points: list, direction: int = 1) -> float:
    """All my own work."""
    s: float = 0
    for a, b, c in zip(
        points[-1:] + points[:-1],
        points,
        points[1:] + points[:1],
    ):
        s += direction * (b[0] - a[0]) * (c[1] - b[1])  # cross
    return s if s > 0 else -s

x = 1

def point_segment_distance(point, start, end):
    "Mine."
    a, b = 0.0, 1.0
    for _ in range(60):
        t = ((b - a) / 3)
        u, v = a + t, b - t
        if (np.linalg.norm(point - start - u * (end - start))
                < np.linalg.norm(point - start - v * (end - start))):
            b = v
        else:
            a = u
    return np.linalg.norm(point - start - a * (end - start))
'''
CLOSED_FORM = """
def point_segment_distance(q, p1, p2):
    way = p2 - p1
    square = way @ way
    share = min(1.0, max(0.0, (q - p1) @ way / square)) if square > 0 else 0.0
    nearest = p1 + share * way
    return float(np.sqrt(((q - nearest) ** 2).sum()))
"""


def handed_in(student: str, *sources: str) -> Submission:
    """A submission of lesson 1."""
    return Submission(student, NAME, f"{student}.ipynb", notebook(*sources))


def by_chance(rng: random.Random) -> str:
    """A random function that nobody else writes."""
    steps = [
        f"    s = s {rng.choice('+-*/')} a{rng.choice('+-*/')}{rng.randint(2, 10**6)}"
        for _ in range(25)
    ]
    return "\n".join(["def mine(a, s):", *steps, "    return s"])


def named(found) -> list[tuple[str, str]]:
    """The pairs of a list, by name."""
    return [(one.first.name, one.second.name) for one in found]


def test_a_copy_is_found_in_disguise():
    """Names, comments, annotations, layout and order differ, and the pair comes first.

    Students with other programs are in no pair with these two.
    """
    rng = random.Random(1)
    others = [handed_in(f"s{n}", by_chance(rng), CLOSED_FORM) for n in range(8)]
    found = find_similar(
        NAME, [handed_in("ann", OWN_WAY, HELPER), *others, handed_in("bob", DISGUISED)]
    )
    first = found.each_other[0]
    assert (first.first.name, first.second.name) == ("ann", "bob")
    assert first.of_first > 0.95 and first.of_second > 0.95
    assert not any("ann" in pair or "bob" in pair for pair in named(found.each_other[1:]))


def test_what_many_write_weighs_less_than_what_two_share():
    """Two students share a short function beside the code of all eight; their pair weighs most."""
    all_of_them = [
        handed_in(f"s{n}", OWN_WAY, HELPER, *([CLOSED_FORM] if n in (3, 6) else []))
        for n in range(8)
    ]
    found = find_similar(NAME, all_of_them)
    assert named(found.each_other)[0] == ("s3", "s6")
    assert found.each_other[0].weight > 3 * found.each_other[1].weight


@pytest.mark.parametrize(
    "given", ["exercises/09_trees", "exercises/02_bug_algorithms", "notebooks/01_geometry"]
)
def test_what_all_were_given_is_taken_out(given):
    """An exercise as handed out, or a lesson, has nothing in common with itself."""
    data = (HOUSE / f"{given}.ipynb").read_bytes()
    assert split_program([cell.source for cell in read_cells(data)])
    found = find_similar(
        NAME, [Submission(student, NAME, "x.ipynb", data) for student in ("ann", "bob")]
    )
    assert found.each_other == [] and found.course == []
    assert len(found.programs) == 2


def test_the_courses_own_programs_are_recognised():
    """A solution, and a function of the library under other names, are found in their files."""
    solved = Submission(
        "ann", NAME, "x.ipynb", (HOUSE / "solutions" / f"{NAME}.ipynb").read_bytes()
    )
    text = (HOUSE / "kinoedu" / "geometry" / "segments.py").read_text(encoding="utf-8")
    found = find_similar(
        NAME, [solved, handed_in("bob", text.replace("p1", "start").replace("p2", "end"))]
    )
    best: dict[str, str] = {}
    for first, second in named(found.course):
        best.setdefault(first, second)
    assert best == {"ann": f"solutions/{NAME}.ipynb", "bob": "kinoedu/geometry/segments.py"}


NONSENSE = [
    "def f(:\n  the quick brown fox jumps\n  over the lazy dog = 7",
    "\x00",
    "(" * 5000,
    "1" + "+1" * 50_000,
    "x = 1" + "0" * 9000,
    "",
]


@pytest.mark.parametrize("bad", NONSENSE, ids=range(len(NONSENSE)))
def test_what_python_cannot_read_counts_by_its_lines(bad):
    """The other cells are compared too, and two students with the same lines are found."""
    found = find_similar(
        NAME,
        [
            handed_in("ann", bad, OWN_WAY),
            handed_in("bob", DISGUISED, bad),
            handed_in("cy", CLOSED_FORM),
        ],
    )
    assert named(found.each_other)[0] == ("ann", "bob")
    lines = find_similar(
        NAME,
        [
            handed_in("ann", NONSENSE[0]),
            handed_in("bob", NONSENSE[0] + " # mine"),
            handed_in("cy", CLOSED_FORM),
        ],
    )
    assert named(lines.each_other) == [("ann", "bob")]


def test_whatever_two_share_that_is_long_enough_is_seen():
    """The law of winnowing on random words.

    A common stretch of RUN + WINDOW - 1 words has a common fingerprint.
    """
    rng = random.Random(3)
    for _ in range(200):
        common = [rng.randint(0, 9) for _ in range(RUN + WINDOW - 1)]
        one, other = (
            [rng.randint(0, 9) for _ in range(rng.randint(0, 40))]
            + common
            + [rng.randint(0, 9) for _ in range(rng.randint(0, 40))]
            for _ in range(2)
        )
        first, second = (
            select_fingerprints(
                [(hash_text(str(word)), at) for at, word in enumerate(words)], WINDOW
            )
            for words in (one, other)
        )
        assert first.keys() & second.keys()


def test_shared_lines_are_where_they_are_said_to_be():
    """The lines of a fingerprint are in its piece, and together they cover its statements."""
    (piece,) = split_program([OWN_WAY])
    assert piece.lines[0].startswith("def point_segment_distance")
    covered = {line for first, last in piece.prints.values() for line in range(first, last + 1)}
    assert covered <= set(range(len(piece.lines)))
    assert {3, 4, 5, 6, 7, 8} <= covered


def test_pages_are_the_same_for_the_same_class_and_safe(tmp_path):
    """Each pair has a page, names and programs are escaped, and old pages are removed."""
    evil = OWN_WAY.replace("# walk", "'</pre><script>alert(1)</script>' # walk")
    submissions = [
        handed_in("=ann<b>", evil),
        handed_in("bob", DISGUISED),
        handed_in("cy", CLOSED_FORM),
    ]
    for student, sources in (("dan", OWN_WAY), ("eve", CLOSED_FORM)):
        submissions.append(handed_in(student, sources))
    write_similar([find_similar(NAME, submissions)], tmp_path)
    (tmp_path / "pairs" / "old.html").write_text("old")
    before = {
        file: file.read_bytes()
        for file in tmp_path.rglob("*")
        if file.is_file() and file.name != "old.html"
    }
    write_similar([find_similar(NAME, submissions[::-1])], tmp_path)
    assert {file: file.read_bytes() for file in tmp_path.rglob("*") if file.is_file()} == before
    pages = "".join(data.decode() for file, data in before.items() if file.suffix == ".html")
    assert "&lt;script&gt;alert" in pages
    assert "<script>" not in pages and "ann<b>" not in pages
    rows = list(csv.DictReader(io.StringIO((tmp_path / "similar.csv").read_text(encoding="utf-8"))))
    assert rows[0].keys() >= {"first", "second", "share_of_first", "share_of_second", "page"}
    assert any(row["first"] == "'=ann<b>" for row in rows)
    assert all((tmp_path / row["page"]).exists() for row in rows)
    assert not any("score" in column for column in rows[0])
    page = (tmp_path / rows[0]["page"]).read_text(encoding="utf-8")
    assert page.count("<mark>") >= 10
    pieces_shown = [line for line in page.splitlines() if line.startswith("<pre")]
    assert set(pieces_shown) - {"<pre></pre>"}
    # narrow pages show the title, which names the author, above each piece
    assert all(line.startswith(('<pre title="', "<pre></pre>")) for line in pieces_shown)


def test_the_command_says_where_to_look(tmp_path, capsys):
    """One file cannot be read; an empty folder is refused."""
    for student, data in (("ann", notebook(OWN_WAY)), ("bob", notebook(DISGUISED)), ("cy", b"{")):
        (tmp_path / "in" / student).mkdir(parents=True)
        (tmp_path / "in" / student / f"{NAME}.ipynb").write_bytes(data)
    assert main(["similar", str(tmp_path / "in"), "--out", str(tmp_path / "out")]) == 0
    output = capsys.readouterr().out
    assert "similar.html" in output and "1 submissions could not be read" in output
    (tmp_path / "empty").mkdir()
    assert main(["similar", str(tmp_path / "empty"), "--out", str(tmp_path / "x")]) == 2
    assert not (tmp_path / "x").exists()
    within = tmp_path / "in" / "similar"  # grading would list it as a student without a notebook
    assert main(["similar", str(tmp_path / "in"), "--out", str(within)]) == 2
    assert "name a folder outside" in capsys.readouterr().err
    assert not within.exists()


def test_a_function_is_shown_whole_whatever_characters_stand_above_it():
    """Page breaks and Unicode's separators end no line of Python."""
    function = "def f(x):\n" + "".join(f"    a{i} = x * {i} + x\n" for i in range(12))
    for above in ("", "# \x0c\x1c\u2028\n"):
        (piece,) = split_program([f"{above}{function}"])
        assert piece.lines == function.splitlines()
