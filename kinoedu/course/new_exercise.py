"""Create a new exercise that is complete from the start.

The new exercise is a tiny one, the midpoint of two points, under a name and in a lesson of your
choice; or it is made from a plain function of yours (`plain_function.py`). It has everything that
an exercise needs: cells in the solution notebook, a file with cases, reference and picture,
messages, a bank of wrong answers and a test. It passes the project's tests. The word Edit marks the
parts to edit.
"""

import ast
import keyword
import re
import shutil
import sys
from pathlib import Path
from string import Template
from textwrap import indent
from typing import Any

from ..errors import InvalidParameter
from ..messages import catalogue
from ..support.whole_files import written_whole
from .lessons import EXERCISES
from .plain_function import ANSWERS, PlainFunction, example_of
from .plain_slips import PlainSlip, usual_slips
from .release import HOUSE, read_notebook_node, run_notebook

TEMPLATES = "solutions/new_exercise"  # not for students: they contain right and wrong answers
PLACES = {  # the file that each template becomes
    "exercise.py": "kinoedu/course/lessons/{room}/{name}.py",
    "messages.toml": "kinoedu/course/lessons/{room}/{name}.toml",
    "bank.py": "solutions/bank/{name}.py",
    "its_test.py": "tests/lessons/test_{name}.py",
}
CELLS = ("statement.md", "answer.py")  # of the notebook
NUMPY = "import numpy as np"
DESCRIBED = {  # kinds of input and answer, in words
    "point": "a point, an array of shape `(2,)`",
    "points": "points, an array of shape `(n, 2)`",
    "polygon": "the vertices of a simple polygon, counter-clockwise, an array of shape `(n, 2)`",
    "number": "a number",
    "length": "a positive number",
    "angle": "an angle in radians",
    "count": "a whole number",
    "truth": "`True` or `False`",
}
MARK = "wrong"  # of a program in a bank, course/bank.py
LIST = "kinoedu/course/lessons/{room}/__init__.py"
POINTS = 3  # one point for each kind of input


def new_exercise(
    name: str, lesson: str, house: Path = HOUSE, plain: PlainFunction | None = None
) -> list[str]:
    """Write a new exercise into a copy of the project, and run its solution notebook.

    Parameters
    ----------
    plain : the function from which the exercise is made; by default that of the example.

    Returns
    -------
    list of str
        The files that were made or changed, in the order in which to edit them.

    Raises
    ------
    InvalidParameter
        Where the name or the lesson cannot be used; nothing is written then.
    """
    check_names(name, lesson, house)
    room = room_of(lesson)
    kind, values = "", {"name": name, "lesson": lesson, "cls": class_name(name)}
    values["title"] = name.replace("_", " ").capitalize()
    if plain is not None:
        kind, values = "plain_", values | plain_values(plain)
    made = {
        place.format(name=name, room=room): fill_template(house, kind + template, values)
        for template, place in PLACES.items()
    }
    refuse_taken_class(name, made[PLACES["exercise.py"].format(name=name, room=room)])
    cells = [fill_template(house, kind + template, values).rstrip() for template in CELLS]
    book, list_of_room = f"solutions/{lesson}.ipynb", LIST.format(room=room)
    list_file = house / list_of_room
    before = list_file.read_text(encoding="utf-8") if list_file.exists() else None
    try:
        list_file.parent.mkdir(exist_ok=True)
        write_files(house, made | {list_of_room: add_to_list(before or new_list(lesson), name)})
        write_notebook(add_cells(house / book, name, lesson, *cells), house / book)
    except BaseException:
        for place in made:
            (house / place).unlink(missing_ok=True)
        if before is None:
            shutil.rmtree(list_file.parent)
        else:
            write_files(house, {list_of_room: before})
        raise
    return [book, *made, list_of_room]


def room_of(lesson: str) -> str:
    """Folder of a lesson's exercises; for a new lesson, its name without the number.

    >>> room_of("09_trees"), room_of("77_midpoints")
    ('trees', 'midpoints')
    """
    rooms = {
        exercise.lesson: type(exercise).__module__.split(".")[-2] for exercise in EXERCISES.values()
    }
    return rooms.get(lesson, lesson.partition("_")[2])


def new_list(lesson: str) -> str:
    """Source of the list of exercises for a new lesson."""
    number, _, title = lesson.partition("_")
    name = title.replace("_", " ").capitalize()
    docstring = f'"""Lesson {int(number)}: {name}. Its exercises, in the order of the notebook."""'
    return f"{docstring}\n\nEXERCISES = [\n]\n"


def write_files(house: Path, files: dict[str, str]) -> None:
    """Write texts to files, each atomically."""
    for place, text in files.items():
        with written_whole(house / place) as part:
            part.write_text(text, encoding="utf-8")


def check_names(name: str, lesson: str, house: Path) -> None:
    """Raise InvalidParameter where the exercise cannot be created."""
    if not re.fullmatch(r"[a-z][a-z0-9_]{2,50}", name) or keyword.iskeyword(name):
        raise InvalidParameter(
            "the name of an exercise is the name of its function: 3 to 51 lower-case letters, "
            f"digits and _, such as closest_wall; got {name!r}"
        )
    topic = lesson[3:]  # the name of a package
    is_taken = keyword.iskeyword(topic) or topic == "shared"
    if not re.fullmatch(r"\d\d_[a-z][a-z0-9_]*", lesson) or is_taken:
        raise InvalidParameter(
            "the name of a lesson is two digits and one or more words, such as 15_walls, and not "
            f"a single word that Python reserves, nor shared; got {lesson!r}"
        )
    if not (house / TEMPLATES).is_dir():
        raise InvalidParameter(
            "this copy of the course is for students; it has no solutions to which an exercise "
            "could be added"
        )
    places = [place.format(name=name, room=room_of(lesson)) for place in PLACES.values()]
    taken = [place for place in places if (house / place).exists()]
    if name in EXERCISES or name in catalogue("en") or taken:
        raise InvalidParameter(
            f"{name} exists already ({taken[0] if taken else 'an exercise or its messages'}); "
            "choose another name"
        )


def refuse_taken_class(name: str, source: str) -> None:
    """Raise InvalidParameter where an exercise's file imports something of its class's name."""
    imports = [node for node in ast.parse(source).body if isinstance(node, ast.ImportFrom)]
    if class_name(name) in {one.name for node in imports for one in node.names}:
        raise InvalidParameter(
            f"the class of {name} would be {class_name(name)}, which is something else in its "
            f"file; choose another name, such as {name}_of_points"
        )


def fill_template(house: Path, template: str, values: dict[str, str]) -> str:
    """Fill in the values in a template."""
    text = (house / TEMPLATES / f"{template}.txt").read_text(encoding="utf-8")
    return Template(text).substitute(values)


def plain_values(plain: PlainFunction) -> dict[str, str]:
    """What the templates of an exercise need to know of a plain function.

    Raises
    ------
    InvalidParameter
        Where its example is wrong.
    """
    given = example_of(plain)
    slips = usual_slips(plain)
    first_line = " ".join(plain.statement.split("\n\n")[0].split())
    shapes = [ANSWERS[plain.answer], *(repr_shape(kind) for kind in plain.inputs.values())]
    used = sorted({shape.partition("(")[0] for shape in shapes} - {"Integer"} | {"Record", "Value"})
    body = indent(plain.body, "    ")
    own_imports = [line for line in plain.imports.splitlines() if line != NUMPY]
    return {
        "signature": f"{plain.name}({', '.join(plain.inputs)})",
        "typed": ", ".join(f"{one}: Value" for one in plain.inputs),
        "docstring": as_docstring(first_line),
        "statement": plain.statement,
        "rule": as_message(first_line),
        "described": ", ".join(f"`{one}`, {DESCRIBED[k]}" for one, k in plain.inputs.items()),
        "answer_described": DESCRIBED[plain.answer],
        "call": plain.call,
        "result": plain.result,
        "standard_imports": "".join(f"{line}\n" for line in own_imports if is_standard(line)),
        "imports": "\n".join([NUMPY, *(one for one in own_imports if not is_standard(one))]),
        "solution": "\n".join([*(f"    {line}" for line in own_imports), body]),
        "body": body,
        "shapes": ", ".join(used),
        "whole_shapes": "from ...whole_shapes import Integer\n" if "Integer()" in shapes else "",
        "answer_shape": ANSWERS[plain.answer],
        "inputs": "\n".join(
            f'        "{one}": INPUTS["{kind}"],' for one, kind in plain.inputs.items()
        ),
        "given": ", ".join(f"{one}={repr_shape(k)}" for one, k in plain.inputs.items()),
        "example": "\n".join(
            f'            "{one}": {as_source(value)},' for one, value in given.items()
        ),
        "slips": "\n".join(f'        Slip("{one.key}", {one.program}),' for one in slips),
        "slip_messages": "\n".join(f'{one.key} = "{one.text}"' for one in slips),
        "wrong": "\n\n\n".join(wrong_programs(plain, slips)),
    }


def as_docstring(line: str) -> str:
    """A line as a docstring, whatever quotation marks and backslashes it has."""
    mark = "r" if "\\" in line else ""
    return mark + '"""' + line.replace('"', "'").rstrip("\\") + '"""'


def as_message(line: str) -> str:
    r"""A line as it stands in quotation marks in a file of messages, where {x} is a blank to fill.

    >>> print(as_message('The "sum" of \\{a}'))
    The 'sum' of \\{{a}}
    """
    quoted = line.replace("\\", "\\\\").replace('"', "'")
    return quoted.replace("{", "{{").replace("}", "}}")


def is_standard(line: str) -> bool:
    """Whether a line imports a module of Python itself.

    >>> is_standard("import math"), is_standard("from scipy.spatial import KDTree")
    (True, False)
    """
    return line.split()[1].partition(".")[0] in sys.stdlib_module_names


def repr_shape(kind: str) -> str:
    """The shape of a kind of input, as Python."""
    return {"polygon": ANSWERS["points"]}.get(kind) or ANSWERS[kind]


def as_source(value: Any) -> str:
    """An argument as Python."""
    return f"np.array({value.tolist()})" if hasattr(value, "tolist") else repr(value)


def wrong_programs(plain: PlainFunction, slips: list[PlainSlip]) -> list[str]:
    """The bank: each usual mistake, and mistakes that every function has."""
    names = ", ".join(plain.inputs)
    programs = [
        f'@{MARK}("{plain.name}", slip="{one.key}")\ndef {one.key}({names}):\n'
        f'    """{one.text.partition(".")[0]}."""\n'
        f"    return {one.program.partition(': ')[2]}"
        for one in slips
    ]
    others = {
        "prints": ("Prints the answer, and returns nothing.", f"print(right({names}))"),
        "function_itself": ("Returns a function, not its value.", "return right"),
        "always_an_error": ("Refuses every input.", 'raise ValueError("bad input")'),
        "as_text": ("Returns a text.", f"return str(right({names}))"),
        "twice": ("Returns the answer twice.", f"return [right({names})] * 2"),
        "nan": (
            "Returns something that is no number.",
            f"return np.asarray(right({names})) * np.nan",
        ),
    }
    return programs + [
        f'@{MARK}("{plain.name}")\ndef {key}({names}):\n    """{text}"""\n    {line}'
        for key, (text, line) in others.items()
    ]


def class_name(name: str) -> str:
    """Name of an exercise's class.

    >>> class_name("closest_wall")
    'ClosestWall'
    """
    return "".join(word.capitalize() for word in name.split("_"))


def add_to_list(text: str, name: str) -> str:
    """Add an exercise to the source of a lesson's list.

    The import is inserted in alphabetical order, the class at the end. Raises InvalidParameter
    where the list has another form.

    >>> text = "from .a import A\\nfrom .c import C\\n\\nEXERCISES = [\\n    C,\\n    A,\\n]\\n"
    >>> print(add_to_list(text, "b"))
    from .a import A
    from .b import B
    from .c import C
    <BLANKLINE>
    EXERCISES = [
        C,
        A,
        B,
    ]
    <BLANKLINE>
    """
    lines, cls = text.splitlines(keepends=True), class_name(name)
    begins = [at for at, line in enumerate(lines) if line == "EXERCISES = [\n"]
    ends = [at for at, line in enumerate(lines) if line == "]\n"]
    if len(begins) != 1 or not ends or ends[-1] < begins[0] or re.search(rf"\b{cls}\b", text):
        raise InvalidParameter(
            f"{cls} cannot be added to this list: either it is in the list already, or the file "
            f"has an unexpected form\n{text}"
        )
    lines.insert(ends[-1], f"    {cls},\n")
    imports = [at for at, line in enumerate(lines) if re.match(r"from \.\w+ import ", line)]
    after = next(
        (at for at in imports if lines[at].split()[1] > f".{name}"),
        imports[-1] + 1 if imports else begins[0],
    )
    lines.insert(after, f"from .{name} import {cls}\n" + ("" if imports else "\n"))
    ast.parse("".join(lines))
    return "".join(lines)


def add_cells(file: Path, name: str, lesson: str, statement: str, answer: str) -> Any:
    """Solution notebook with the exercise added at its end; a new notebook where there is none."""
    from nbformat import v4

    if file.exists():
        book = read_notebook_node(file)
    else:
        title = lesson.replace("_", " ").capitalize()
        how = "Write each function in its cell, run that cell, then the one with `check()`."
        first = f"# {title}\n\n{how}"
        imports = "import numpy as np\nfrom kinoedu.course import check"
        book = v4.new_notebook(
            cells=[v4.new_markdown_cell(first, id="title"), v4.new_code_cell(imports, id="imports")]
        )
        kernel = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
        book.metadata = {"kernelspec": kernel}
    mark = {"cell_type": "code", "schema_version": 3, "task": False}
    written = {**mark, "grade": False, "grade_id": name, "locked": False, "solution": True}
    checked = {**mark, "grade": True, "grade_id": f"check_{name}", "locked": True}
    checked |= {"points": POINTS, "solution": False}
    book.cells += [
        v4.new_markdown_cell(statement, id=f"statement_{name}"),
        v4.new_code_cell(answer, id=name, metadata={"nbgrader": written}),
        v4.new_code_cell(f"check({name})", id=f"check_{name}", metadata={"nbgrader": checked}),
    ]
    return book


def write_notebook(book: Any, file: Path) -> None:
    """Run a notebook and store it with its outputs."""
    import nbformat

    with written_whole(file) as part:
        part.write_text(nbformat.writes(run_notebook(book, file.parent)) + "\n", encoding="utf-8")
