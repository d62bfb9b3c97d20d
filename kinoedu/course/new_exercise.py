"""A new exercise, whole from its first minute: a tiny one, the middle of two points, under a name
and in a lesson of one's own.

It comes with all that an exercise has: its cell in the solution notebook, its file of cases,
reference and picture, its words, its bank of wrong answers and its test. All of it passes the tests
of the house; what to edit is marked by the word Edit.
"""

import ast
import keyword
import re
import shutil
from pathlib import Path
from string import Template
from typing import Any

from ..errors import InvalidParameter
from ..support.whole_files import written_whole
from ..words import catalogue
from .lessons import EXERCISES
from .release import HOUSE, run

TEMPLATES = (
    "solutions/new_exercise"  # students do not get them: they hold an answer, and wrong ones
)
PLACES = {  # where each template's file goes
    "exercise.py": "kinoedu/course/lessons/{room}/{name}.py",
    "messages.toml": "kinoedu/course/lessons/{room}/{name}.toml",
    "bank.py": "solutions/bank/{name}.py",
    "its_test.py": "tests/lessons/test_{name}.py",
}
LIST = "kinoedu/course/lessons/{room}/__init__.py"
POINTS = 3  # one for each kind of input


def new_exercise(name: str, lesson: str, house: Path = HOUSE) -> list[str]:
    """Write a new exercise into a house, and run the solution notebook with it. Returns the files
    that were made or changed, in the order in which to edit them. Raises InvalidParameter, and then
    has written nothing.
    """
    refuse(name, lesson, house)
    room = room_of(lesson)
    made = {
        place.format(name=name, room=room): filled(house, template, name, lesson)
        for template, place in PLACES.items()
    }
    book, list_of_room = f"solutions/{lesson}.ipynb", LIST.format(room=room)
    before = (
        (house / list_of_room).read_text(encoding="utf-8")
        if (house / list_of_room).exists()
        else None
    )
    try:
        (house / list_of_room).parent.mkdir(exist_ok=True)
        write(house, made | {list_of_room: listed(before or empty_list(lesson), name)})
        write_notebook(with_cells(house, book, name, lesson), house / book)
    except BaseException:
        for place in made:
            (house / place).unlink(missing_ok=True)
        if before is None:
            shutil.rmtree((house / list_of_room).parent)
        else:
            write(house, {list_of_room: before})
        raise
    return [book, *made, list_of_room]


def room_of(lesson: str) -> str:
    """The room of a lesson: where its exercises are, else one that is named like it.

    >>> room_of("09_trees"), room_of("77_midpoints")
    ('trees', 'midpoints')
    """
    rooms = {
        exercise.lesson: type(exercise).__module__.split(".")[-2] for exercise in EXERCISES.values()
    }
    return rooms.get(lesson, lesson.partition("_")[2])


def empty_list(lesson: str) -> str:
    """The list of a new room."""
    number, _, title = lesson.partition("_")
    name = title.replace("_", " ").capitalize()
    return f'"""Lesson {int(number)}: {name}. Its exercises, as the notebook asks for them."""\n\nEXERCISES = [\n]\n'


def write(house: Path, files: dict[str, str]) -> None:
    """Write texts by their places, each whole."""
    for place, text in files.items():
        with written_whole(house / place) as part:
            part.write_text(text, encoding="utf-8")


def refuse(name: str, lesson: str, house: Path) -> None:
    """Raise InvalidParameter where there can be no such exercise."""
    if not re.fullmatch(r"[a-z][a-z0-9_]{2,50}", name) or keyword.iskeyword(name):
        wanted = "3 to 51 small letters, digits and _, such as closest_wall"
        raise InvalidParameter(
            f"an exercise is named like the function it asks for, by {wanted}; got {name!r}"
        )
    if not re.fullmatch(r"\d\d_[a-z0-9_]+", lesson):
        raise InvalidParameter(
            f"a lesson is named like 14_walls: two digits and a word or more; got {lesson!r}"
        )
    if not (house / TEMPLATES).is_dir():
        raise InvalidParameter(
            "this copy of the course is for students: it has no solutions, to which an exercise "
            "could be added"
        )
    places = [place.format(name=name, room=room_of(lesson)) for place in PLACES.values()]
    taken = [place for place in places if (house / place).exists()]
    if name in EXERCISES or name in catalogue("en") or taken:
        raise InvalidParameter(
            f"there is a {name} already ({taken[0] if taken else 'an exercise, or words'}); "
            "choose another name"
        )


def filled(house: Path, template: str, name: str, lesson: str) -> str:
    """A template with its names filled in."""
    text = (house / TEMPLATES / f"{template}.txt").read_text(encoding="utf-8")
    return Template(text).substitute(
        name=name, lesson=lesson, cls=class_name(name), title=name.replace("_", " ").capitalize()
    )


def class_name(name: str) -> str:
    """The name of an exercise's class.

    >>> class_name("closest_wall")
    'ClosestWall'
    """
    return "".join(word.capitalize() for word in name.split("_"))


def listed(text: str, name: str) -> str:
    """The list of a room with one more exercise: its import in the order of the alphabet, its class
    at the end. Raises InvalidParameter where the list has another form.

    >>> text = "from .a import A\\nfrom .c import C\\n\\nEXERCISES = [\\n    C,\\n    A,\\n]\\n"
    >>> print(listed(text, "b"))
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
            f"the list could not take {cls}: is it listed already, or was the file changed in its "
            f"form?\n{text}"
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


def with_cells(house: Path, place: str, name: str, lesson: str) -> Any:
    """The solution notebook, new where there is none, with the exercise at its end."""
    import nbformat
    from nbformat import v4

    file = house / place
    statement, answer = (
        filled(house, template, name, lesson).rstrip() for template in ("statement.md", "answer.py")
    )
    if file.exists():
        book = nbformat.read(file, as_version=4)
    else:
        first = (
            f"# {lesson.replace('_', ' ').capitalize()}\n\nEdit: what holds for all exercises of "
            "this lesson."
        )
        imports = "import numpy as np\nfrom kinoedu.course import check, show"
        book = v4.new_notebook(
            cells=[v4.new_markdown_cell(first, id="title"), v4.new_code_cell(imports, id="imports")]
        )
        book.metadata = {
            "kernelspec": {
                "display_name": "Python 3 (ipykernel)",
                "language": "python",
                "name": "python3",
            }
        }
    mark = {"cell_type": "code", "schema_version": 3, "task": False}
    written = {**mark, "grade": False, "grade_id": name, "locked": False, "solution": True}
    checked = {
        **mark,
        "grade": True,
        "grade_id": f"check_{name}",
        "locked": True,
        "points": POINTS,
        "solution": False,
    }
    book.cells += [
        v4.new_markdown_cell(statement, id=f"statement_{name}"),
        v4.new_code_cell(answer, id=name, metadata={"nbgrader": written}),
        v4.new_code_cell(f"check({name})", id=f"check_{name}", metadata={"nbgrader": checked}),
    ]
    return book


def write_notebook(book: Any, file: Path) -> None:
    """Run a notebook, and keep it with its outputs."""
    import nbformat

    with written_whole(file) as part:
        part.write_text(nbformat.writes(run(book, file.parent)) + "\n", encoding="utf-8")
