"""Create a new exercise that is complete from the start.

The new exercise is a tiny one, the midpoint of two points, under a name and in a lesson of your
choice. It has everything that an exercise needs: cells in the solution notebook, a file with cases,
reference and picture, messages, a bank of wrong answers and a test. It passes the project's tests.
The word Edit marks the parts to edit.
"""

import ast
import keyword
import re
import shutil
from pathlib import Path
from string import Template
from typing import Any

from ..errors import InvalidParameter
from ..messages import catalogue
from ..support.whole_files import written_whole
from .lessons import EXERCISES
from .release import HOUSE, run_notebook

TEMPLATES = "solutions/new_exercise"  # not for students: they contain right and wrong answers
PLACES = {  # the file that each template becomes
    "exercise.py": "kinoedu/course/lessons/{room}/{name}.py",
    "messages.toml": "kinoedu/course/lessons/{room}/{name}.toml",
    "bank.py": "solutions/bank/{name}.py",
    "its_test.py": "tests/lessons/test_{name}.py",
}
LIST = "kinoedu/course/lessons/{room}/__init__.py"
POINTS = 3  # one point for each kind of input


def new_exercise(name: str, lesson: str, house: Path = HOUSE) -> list[str]:
    """Write a new exercise into a copy of the project, and run its solution notebook.

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
    made = {
        place.format(name=name, room=room): fill_template(house, template, name, lesson)
        for template, place in PLACES.items()
    }
    book, list_of_room = f"solutions/{lesson}.ipynb", LIST.format(room=room)
    list_file = house / list_of_room
    before = list_file.read_text(encoding="utf-8") if list_file.exists() else None
    try:
        list_file.parent.mkdir(exist_ok=True)
        write_files(house, made | {list_of_room: add_to_list(before or new_list(lesson), name)})
        write_notebook(add_cells(house, book, name, lesson), house / book)
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
    if not re.fullmatch(r"\d\d_[a-z0-9_]+", lesson):
        raise InvalidParameter(
            "the name of a lesson is two digits and one or more words, such as 14_walls; "
            f"got {lesson!r}"
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


def fill_template(house: Path, template: str, name: str, lesson: str) -> str:
    """Fill in the names in a template."""
    text = (house / TEMPLATES / f"{template}.txt").read_text(encoding="utf-8")
    return Template(text).substitute(
        name=name, lesson=lesson, cls=class_name(name), title=name.replace("_", " ").capitalize()
    )


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


def add_cells(house: Path, place: str, name: str, lesson: str) -> Any:
    """Solution notebook with the exercise added at its end; a new notebook where there is none."""
    import nbformat
    from nbformat import v4

    file = house / place
    statement, answer = (
        fill_template(house, template, name, lesson).rstrip()
        for template in ("statement.md", "answer.py")
    )
    if file.exists():
        book = nbformat.read(file, as_version=4)
    else:
        title = lesson.replace("_", " ").capitalize()
        first = f"# {title}\n\nEdit: what holds for all exercises of this lesson."
        imports = "import numpy as np\nfrom kinoedu.course import check, show"
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
