"""What a body is to a page: its settings, what it says, and how its layers look.

A body returns a NamedTuple of arrays of float64. Its first field, `facts`, is a row of numbers: the
status, then those that `Body.facts` names. The status is the number of what is said, or a fault of
the scene, `scenes.py`. Every other field has rows: the numbers of a layer of a drawing.
"""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple, get_type_hints

import numpy as np

from ..compiled import Compiled
from ..messages import get_template
from ..support.json_fields import JsonObject

LINE, DOT = "line", "dot"  # a width that falls with the number of steps; a size with that of dots
TOTAL = "total"  # the fact with this name is the number of steps
HANDLES = "handles"  # the kind of rows number, x, y: handles that are moved there
TEXTS = "texts"  # the kind of rows that fill the text at each step before the last
IMAGE = "image"  # the kind of rows that are the numbers of the bitmap's colours
LIST = "list"  # the kind of rows that are listed in the text, in the blank with the field's name


class Say(NamedTuple):
    """A message: its key, and what fills some of its blanks: other messages, or plain text.

    Facts fill the other blanks.
    """

    key: str
    values: Mapping[str, Any] = MappingProxyType({})


class Look(NamedTuple):
    """The look of a field as a layer of a drawing, `kinoedu.boards.core.drawing`.

    A row has its coordinates, the number of a label or the numbers of a note, and its steps.

    width : a number, LINE, DOT, or the name of a fact.
    grows, ends : whether a row has the step at which it appears, and that at which it disappears.
    form : how the number of a label is written, as in `Body.facts`.
    says, names : the messages of a row, and the names of its numbers; `which` is that of the
        message, where there are several. Those of a label are its text.
    hatched : whether bodies have stripes.
    """

    field: str
    kind: str
    colour: str = "ink"
    width: float | str = 1.0
    grows: bool = False
    ends: bool = False
    dash: tuple[float, ...] = ()
    form: str = ""
    says: tuple[Say, ...] = ()
    names: tuple[str, ...] = ()
    hatched: bool = False


class Picture(NamedTuple):
    """A second picture beside that of a body.

    says : what it says, chosen by the fact `chosen`, or by the status.
    """

    says: tuple[Say, ...]
    layers: tuple[Look, ...]
    chosen: str = ""


class Body(NamedTuple):
    """A function from a scene, settings and a generator to what is shown.

    settings, shows : the NamedTuples that it takes and returns.
    facts : the names of the facts after the status, each with the form in which it is written, such
        as "length:.4g". The form of a word is its alphabet: each digit d of the number stands for
        letter d, and 0 for "-". In the form "H|L" the number 3 is written H3, and -3 is L3.
    says : what is said at each status.
    warns : what is said where nothing can be shown, at the statuses REFUSED, REFUSED - 1, ... The
        facts after the status are a point, for the blank {q}.
    beside : a second picture, with handles of its own. The scene has each of them twice, after
        those of the first picture: where it is, and where it was at the last answer.
    title : its name in a menu; menu : the key of the menu's name.
    unit : the key of the message that names a step.
    is_random : whether it draws random numbers, so that another seed gives another answer.
    """

    function: Compiled
    settings: Any
    shows: Any
    facts: tuple[str, ...]
    says: tuple[Say, ...]
    layers: tuple[Look, ...]
    warns: tuple[Say, ...] = ()
    beside: Picture | None = None
    title: Say | str = ""
    menu: str = ""
    unit: str = ""
    is_random: bool = False

    @property
    def kinds(self) -> tuple[Any, ...]:
        """Settings like those that it takes, for a compiler: numbers, and rows of numbers."""
        kinds = get_type_hints(self.settings).values()
        return self.settings(*(0.0 if kind is float else np.empty((0, 0)) for kind in kinds))


def split_form(fact: str) -> tuple[str, str]:
    """The name and the form of a fact.

    >>> split_form("length:.4g")
    ('length', '.4g')
    """
    name, _, form = fact.partition(":")
    return name, form


def in_form(value: float, form: str) -> str:
    """A number as it is written: see `Body.facts`.

    >>> in_form(2.0 / 3.0, ".4g"), in_form(1762.0, ","), in_form(323.0, "RSL"), in_form(0, "RSL")
    ('0.6667', '1,762', 'LSL', '-')
    >>> in_form(3.0, "H|L"), in_form(-3.0, "H|L")
    ('H3', 'L3')
    """
    if "|" in form:
        return f"{form[0] if value > 0.0 else form[2]}{abs(int(value))}"
    if form.isalpha() and form.isupper():
        return "".join(form[int(digit) - 1] for digit in str(int(value)) if digit != "0") or "-"
    return format(int(value) if form in (",", "d") else float(value), form)


def template_of(say: Say, language: str) -> str:
    """A message whose other blanks are still to be filled."""
    text = get_template(say.key, language)
    for name, value in say.values.items():
        filled = template_of(value, language) if isinstance(value, Say) else str(value)
        text = text.replace(f"{{{name}}}", filled)
    return text


def describe_body(body: Body, language: str) -> JsonObject:
    """A body as plain data."""
    return {
        "fields": list(body.shows._fields),
        "settings": list(body.settings._fields),
        "facts": [split_form(fact) for fact in body.facts],
        "says": [template_of(say, language) for say in body.says],
        "warns": [template_of(say, language) for say in body.warns],
        "layers": [describe_look(look, language) for look in body.layers],
        "beside": None if body.beside is None else describe_picture(body.beside, language),
        "title": template_of(body.title, language) if isinstance(body.title, Say) else body.title,
        "menu": get_template(body.menu, language) if body.menu else "",
        "unit": get_template(body.unit, language) if body.unit else "",
        "random": body.is_random,
    }


def describe_look(look: Look, language: str) -> JsonObject:
    """A look as plain data, with what its rows say."""
    return {**look._asdict(), "says": [template_of(say, language) for say in look.says]}


def describe_picture(picture: Picture, language: str) -> JsonObject:
    """A second picture as plain data."""
    return {
        "says": [template_of(say, language) for say in picture.says],
        "layers": [describe_look(look, language) for look in picture.layers],
        "chosen": picture.chosen,
    }
