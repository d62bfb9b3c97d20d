"""The numbers of the accessibility statement are those of the palette; its claims have tests."""

import re
from pathlib import Path

from matplotlib.colors import to_rgb

from kinoedu.course import EXERCISES
from kinoedu.figures import palette

HOUSE = Path(__file__).resolve().parent.parent
STATEMENT = (HOUSE / "docs" / "accessibility.md").read_text(encoding="utf-8")
# on white; what is free is white itself
PALE = {"path", "right", "outside", "hit_2_area", "cell", "free_area", "frontier", "free"}
PALE |= {"shape", "grown", "route", "lit"}
TEXT = {"ink", "hit", "true", "yours", "start", "goal", "tree", "left"}


def contrast_to_white(colour):
    """The contrast ratio of WCAG 2."""
    linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in to_rgb(colour)]
    return 1.05 / (sum(w * v for w, v in zip((0.2126, 0.7152, 0.0722), linear)) + 0.05)


def test_the_pale_colours_are_those_that_the_statement_names():
    """No other is below 3 to 1, and the numbers are right; colours of text have at least 4.5."""
    contrast = {name: contrast_to_white(colour) for name, colour in palette.NAMED.items()}
    assert {name for name, ratio in contrast.items() if ratio < 3.0} == PALE
    assert all(contrast[name] >= 4.5 for name in TEXT)
    said = {"path": "2.3", "right": "2.3", "outside": "2.5", "hit_2_area": "2.6"}
    for name, number in said.items():
        assert number in STATEMENT
        assert abs(contrast[name] - float(number)) <= 0.051
    assert all(contrast[name] < 1.4 for name in ("cell", "free_area", "frontier", "lit"))
    assert all(1.4 <= contrast[name] < 1.65 for name in ("shape", "grown", "route"))
    assert all(3.0 <= contrast[name] < 3.15 for name in ("roadmap", "robot"))


def test_what_the_statement_says_of_the_boards_is_tested():
    """Keyboard and reduced motion are driven in a browser; recorded boards say what they are."""
    tests = (HOUSE / "tests" / "in_lab" / "test_board.py").read_text(encoding="utf-8")
    assert "def test_everything_is_reached_by_keyboard" in tests
    assert "def test_reduced_motion_steps_and_does_not_play" in tests
    board = (HOUSE / "kinoedu" / "boards" / "core" / "board.js").read_text(encoding="utf-8")
    assert 'role: "status"' in board
    styles = [*(HOUSE / "kinoedu").rglob("*.css"), *(HOUSE / "docs" / "static").glob("*.css")]
    sheets = "".join(file.read_text(encoding="utf-8") for file in styles)
    assert "forced-colors" not in sheets  # when this changes, the statement may too
    deck = (HOUSE / "kinoedu" / "slides" / "deck.css").read_text(encoding="utf-8")
    assert not re.search(r"transition|animation", deck)


def test_the_exercises_that_need_a_drawing_are_those_named():
    """No other exercise judges what was drawn."""
    drawn = {name for name in EXERCISES if name.startswith(("plot_", "draw_"))}
    assert drawn == {"plot_environment", "plot_configuration_space"}
    assert all(f"`{name}`" in STATEMENT for name in drawn)


def test_the_rubric_has_the_points_of_the_notebooks():
    """The sum of each project, as the rubric says."""
    from kinoedu.grading.assignments.questions import read_assignment

    rubric = (HOUSE / "docs" / "rubrics.md").read_text(encoding="utf-8")
    projects = {1: "03_decomposition", 2: "09_trees", 3: "13_kinodynamic_planning"}
    for number, name in projects.items():
        questions = read_assignment(name).questions
        (row,) = re.findall(rf"(?m)^\| {number}, [^|]*\| (\d+) \| (.*) \|$", rubric)
        assert int(row[0]) == sum(one.points for one in questions)
        each = [int(points) for points in re.findall(r" (\d+)(?:,|$)", row[1])]
        assert each == [one.points for one in questions]
