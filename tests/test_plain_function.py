"""An exercise from a plain function: what is read, which mistakes are found, what is refused."""

import ast
import tomllib

import numpy as np
import pytest

from kinoedu.cli import main
from kinoedu.course.lessons.shared.drawn_inputs import INPUTS, KINDS, draw_cases
from kinoedu.course.new_exercise import add_cells, fill_template, plain_values
from kinoedu.course.plain_function import example_of, read_plain_function
from kinoedu.course.plain_slips import usual_slips
from kinoedu.course.release import HOUSE
from kinoedu.errors import InvalidParameter

NEAREST = '''
import numpy as np

def nearest(q: "point", polygon: "polygon") -> "number":
    """The distance from q to the nearest vertex.

    >>> nearest((0, 0), [(3, 4), (9, 4), (9, 9)])
    5
    """
    return np.linalg.norm(polygon - q, axis=1).min()
'''
SYMMETRIC = '''
def between(a: "number", b: "number") -> "number":
    """The mean of two numbers.

    >>> between(0, 4)
    2
    """
    return (a + b) / 2
'''
REFUSES = '''
import math

def turned(angle: "angle", times: "count", length: "length") -> "truth":
    """Whether a wheel points to the right.

    >>> turned(0, 1, 1)
    True
    """
    if times == 0:
        raise ValueError("no turn")
    return math.cos(angle * times) * length > 0
'''


def read(tmp_path, text):
    """The function of a file with a text."""
    file = tmp_path / "mine.py"
    file.write_text(text)
    return read_plain_function(file)


@pytest.mark.parametrize("kind", sorted(INPUTS))
def test_drawn_inputs_have_their_shape(kind):
    """Each kind of input has at least ten cases of each kind, and they are small first."""
    inputs = {"one": INPUTS[kind], "other": INPUTS["point"]}
    cases = list(draw_cases(inputs, np.random.default_rng(0)))
    assert all(sum(case.kind == one for case in cases) >= 10 for one in KINDS)
    for case in cases:
        assert np.isfinite(np.asarray(case.given["one"], float)).all()
        inputs["one"].shape.decode(inputs["one"].shape.encode(case.given["one"]))
    again = list(draw_cases(inputs, np.random.default_rng(0)))
    assert all(
        np.array_equal(a.given[name], b.given[name])
        for a, b in zip(cases, again)
        for name in inputs
    )


def test_the_usual_mistakes_are_found(tmp_path):
    """Those of the inputs and those of the answer."""
    keys = [slip.key for slip in usual_slips(read(tmp_path, NEAREST))]
    assert {"axes_of_q", "last_of_polygon", "first_of_polygon", "square", "half"} <= set(keys)


def test_what_is_no_mistake_here_is_left_out(tmp_path):
    """To exchange the arguments of a mean changes nothing; a distance is never negative."""
    assert "swapped_a_b" not in [slip.key for slip in usual_slips(read(tmp_path, SYMMETRIC))]
    other = SYMMETRIC.replace("(a + b) / 2", "a - b / 2").replace("    2\n", "    -2\n")
    assert "swapped_a_b" in [slip.key for slip in usual_slips(read(tmp_path, other))]


def test_a_function_may_refuse_inputs(tmp_path):
    """A ValueError is a right answer; angles in degrees and one turn more are mistakes."""
    plain = read(tmp_path, REFUSES)
    keys = [slip.key for slip in usual_slips(plain)]
    assert {"degrees_angle", "one_more_times", "opposite"} <= set(keys)
    values = plain_values(plain)
    assert values["standard_imports"] == "import math\n"
    assert "math" not in values["imports"]
    assert "import math" in values["solution"]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("def nearest", "def nearest(", "is not Python"),
        ('"point"', '"place"', "q needs an annotation, one of point"),
        (': "point"', "", "q needs an annotation"),
        (' -> "number"', "", "the answer needs an annotation"),
        (">>> ", "", "needs a docstring with its statement and one example"),
        ("    5\n", "    6\n", "says 6, but the function returns"),
        ("(0, 0)", "q", "plain values"),
        ("(0, 0), ", "", "has 1 arguments"),
        ("import numpy as np\n", "import numpy as np\nx = 1\n", "and nothing else"),
        ("import numpy as np\n", "", "name 'np' is not defined"),
        ("import numpy", "import numpie", "cannot be run: ModuleNotFoundError"),
        ("def nearest", "@np.vectorize\ndef nearest", "no decorator"),
        ("(q: ", "(*, q: ", "without *, /"),
        ('"polygon")', '"polygon" = 0)', "default values"),
        ("(q: ", "(right: ", "can be named right"),
        ("    return np.linalg.norm(polygon - q, axis=1).min()\n", "", "below its docstring"),
        (">>> nearest(", ">>> max(", "plain values"),
        ("min()", "min", "says 5, but the function returns"),
        ("return", "polygon -= q; return", "changes its argument polygon"),
    ],
)
def test_what_is_missing_is_named(tmp_path, old, new, words):
    """The error says what to write."""
    with pytest.raises(InvalidParameter) as error:
        plain_values(read(tmp_path, NEAREST.replace(old, new, 1)))
    assert words in str(error.value)


def test_a_file_that_is_no_text_is_refused(tmp_path):
    """As one that is not Python."""
    file = tmp_path / "mine.py"
    file.write_bytes(b"\xff\xfe")
    with pytest.raises(InvalidParameter, match="is not Python"):
        read_plain_function(file)


def test_an_input_that_fails_is_named(tmp_path):
    """A division by zero, for example, at one of the cases that are drawn."""
    text = SYMMETRIC.replace("(a + b) / 2", "b / a").replace("(0, 4)", "(2, 4)")
    with pytest.raises(InvalidParameter) as error:
        usual_slips(read(tmp_path, text))
    assert "between fails for {'a': 0" in str(error.value)
    assert "ZeroDivisionError" in str(error.value)


SPELT = {
    "two spaces": SYMMETRIC.replace("    return", "  return").replace('    """', '  """'),
    "tabs": SYMMETRIC.replace("    return", "\tif a:\n\t\ta = a\n\treturn").replace(
        '    """', '\t"""'
    ),
    "quotation": SYMMETRIC.replace('"""', "'''").replace("numbers.", 'numbers, or "mean"'),
    "formula": SYMMETRIC.replace('"""The mean', 'r"""The $\\frac{1}{2}$ mean', 1),
    "future": "from __future__ import annotations\n" + SYMMETRIC,
}


@pytest.mark.parametrize("text", SPELT.values(), ids=SPELT)
def test_however_it_is_spelt_the_exercise_is_python(tmp_path, text):
    """Cell, exercise and bank can be parsed, and the messages can be filled in."""
    plain = read(tmp_path, text)
    values = {"name": plain.name, "lesson": "77_means", "cls": "Between", "title": "Between"}
    values |= plain_values(plain)
    for template in ("answer.py", "exercise.py", "bank.py"):
        ast.parse(fill_template(HOUSE, f"plain_{template}", values))
    messages = tomllib.loads(fill_template(HOUSE, "plain_messages.toml", values))
    assert all(rule.format() for rule in messages[plain.name]["rules"].values())


def test_all_words_round_the_example_are_the_statement(tmp_path):
    """Also those below it."""
    plain = read(tmp_path, SYMMETRIC.replace("    2\n", "    2\n\n    Half-way between both.\n"))
    assert plain.statement == "The mean of two numbers.\n\nHalf-way between both."


def test_what_students_read_asks_no_teacher_to_edit(tmp_path):
    """The exercise can be released as it is written; only a comment is for the teacher."""
    values = plain_values(read(tmp_path, NEAREST)) | {"name": "nearest", "title": "Nearest"}
    words = [
        tomllib.loads(fill_template(HOUSE, "plain_messages.toml", values)),
        add_cells(tmp_path / "new.ipynb", "nearest", "77_corners", "Statement", "pass").cells,
    ]
    assert "you name here" not in repr(words) and "Edit" not in repr(words)


def test_the_example_is_tried(tmp_path):
    """Its arguments become arrays."""
    given = example_of(read(tmp_path, NEAREST))
    assert given["polygon"].shape == (3, 2)


def test_another_name_is_refused(tmp_path, capsys):
    """The exercise has the name of its function."""
    read(tmp_path, NEAREST)
    command = ["new-exercise", "farthest", "--lesson", "77_walls", "--from"]
    assert main([*command, str(tmp_path / "mine.py")]) == 2
    assert "defines nearest" in capsys.readouterr().err
