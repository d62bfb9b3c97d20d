"""Concept questions: every file is complete, and Canvas and Moodle can read what is exported."""

import json
import zipfile
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import pytest

import kinoedu as ke
from kinoedu.cli import main
from kinoedu.cli.questions import PLATFORMS
from kinoedu.course import EXERCISES
from kinoedu.course.questions import Questions, hold_back, lessons_with_questions, read_questions
from kinoedu.course.questions.canvas import QTI
from kinoedu.course.questions.question import HERE, parse_questions
from kinoedu.course.release import QUESTIONS, hold_questions_back
from kinoedu.errors import InvalidParameter

HOUSE = Path(__file__).resolve().parent.parent
LESSONS = [f"{file.stem}" for file in sorted((HOUSE / "notebooks").glob("[01][0-9]_*.ipynb"))]
LESSONS = [lesson for lesson in LESSONS if not lesson.startswith("00")]
ALL = [(lesson, one) for lesson in lessons_with_questions() for one in read_questions(lesson)]
PREFIX = {"": QTI}
ONE = '[q]\nquestion = "?"\nright = "a"\nchoices.a = "1"\nwhy.a = "So."\nchoices.b = "2"\n'


def test_every_lesson_asks_five_questions():
    """All names are different, and every question has four choices in the order of letters."""
    assert lessons_with_questions() == LESSONS
    assert all(len(read_questions(lesson)) == 5 for lesson in LESSONS)
    assert len({one.name for _, one in ALL}) == 70
    assert all("".join(c.letter for c in one.choices) == "abcd" for _, one in ALL)


@pytest.mark.parametrize(("lesson", "question"), ALL, ids=[one.name for _, one in ALL])
def test_every_choice_has_a_reason_of_its_own(lesson, question):
    """No two choices or reasons are equal; a misconception is one that an exercise knows."""
    for texts in ([c.text for c in question.choices], [c.why for c in question.choices]):
        assert len(set(texts)) == 4
        assert all(text.strip() == text and text for text in texts)
    for choice in question.choices:
        if choice.slip:
            name, _, key = choice.slip.partition(".")
            assert choice.letter != question.right
            assert key in {slip.key for slip in EXERCISES[name].slips}


def test_the_right_choice_cannot_be_guessed():
    """Neither by its letter, nor because it is the longest or the shortest."""
    letters = Counter(one.right for _, one in ALL)
    assert all(12 <= letters[letter] <= 24 for letter in "abcd")
    lengths = [[len(c.text) for c in one.choices] for _, one in ALL]
    right = [len(one.right_choice.text) for _, one in ALL]
    for extreme in (max, min):
        assert sum(r == extreme(row) for r, row in zip(right, lengths)) < 35


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[q", "is not TOML"),
        (ONE, "one reason for each choice; see b"),
        (ONE.replace('right = "a"', 'right = "c"'), "right is 'c'"),
        (ONE.replace('right = "a"\n', ""), "right is ''"),
        ('[q]\nquestion = "?"\nchoices.a = "1"\n', "at least two choices"),
        ('q = "?"', "needs a question"),
    ],
)
def test_a_mistake_in_a_file_is_named(text, words):
    """The error names the file and the question."""
    with pytest.raises(InvalidParameter, match=r"mine\.toml") as error:
        parse_questions(text, "mine.toml")
    assert words in str(error.value)


def test_a_translation_is_asked_where_it_is_there(monkeypatch, tmp_path):
    """Other lessons are asked in English."""
    (tmp_path / "xx").mkdir()
    (tmp_path / "en").symlink_to(HERE / "en")
    (tmp_path / "xx" / "01_geometry.toml").write_text(ONE + 'why.b = "Not."\n')
    monkeypatch.setattr("kinoedu.course.questions.question.HERE", tmp_path)
    monkeypatch.setenv("KINOEDU_LANGUAGE", "xx")
    assert read_questions("01_geometry")[0].name == "q"
    assert len(read_questions("06_sampling")) == 5


def test_a_choice_opens_and_says_why():
    """Each choice is a button of the page itself; exactly one of them is right."""
    asked = ke.ask("01_geometry")
    page = ElementTree.fromstring(asked._repr_html_())
    questions = page.findall("ol/li")
    assert len(questions) == 5
    for question in questions:
        said = [choice.find("p").text for choice in question.findall("details")]
        assert Counter(text.partition(".")[0] for text in said) == {"Right": 1, "No": 3}
        assert len({choice.get("name") for choice in question.findall("details")}) == 1
    assert "Right" not in repr(asked)
    with pytest.raises(InvalidParameter, match="14_moving_and_uncertain"):
        ke.ask("15_flying")


def test_canvas_can_read_the_questions(tmp_path):
    """The manifest lists a quiz for each lesson, each item scores one of its own choices.

    Every choice shows feedback that exists; identifiers are unique, and the same each time.
    """
    files = [tmp_path / "one.zip", tmp_path / "two.zip"]
    for file in files:
        assert main(["questions", "--to", "canvas", "--out", str(file)]) == 0
    assert files[0].read_bytes() == files[1].read_bytes()
    with zipfile.ZipFile(files[0]) as archive:
        manifest = ElementTree.fromstring(archive.read("imsmanifest.xml"))
        resources = [one for one in manifest.iter() if one.tag.endswith("}resource")]
        assert {one.get("type") for one in resources} == {"imsqti_xmlv1p2"}
        places = [one[0].get("href") for one in resources]
        assert set(archive.namelist()) == {"imsmanifest.xml", *places}
        quizzes = [ElementTree.fromstring(archive.read(place)) for place in places]
    items = [item for quiz in quizzes for item in quiz.iterfind("assessment/section/item", PREFIX)]
    assert len(quizzes) == 14
    assert len({item.get("ident") for item in items}) == len(items) == 70
    for (_, question), item in zip(ALL, items):
        labels = item.findall("presentation/response_lid/render_choice/response_label", PREFIX)
        idents = [label.get("ident") for label in labels]
        fields = dict(
            zip(
                [one.text for one in item.iter(f"{{{QTI}}}fieldlabel")],
                [one.text for one in item.iter(f"{{{QTI}}}fieldentry")],
            )
        )
        assert fields["question_type"] == "multiple_choice_question"
        assert fields["original_answer_ids"].split(",") == idents
        conditions = item.findall("resprocessing/respcondition", PREFIX)
        scoring = [one for one in conditions if one.find("setvar", PREFIX) is not None]
        assert [one.find("setvar", PREFIX).text for one in scoring] == ["100"]
        chosen = scoring[0].find("conditionvar/varequal", PREFIX)
        assert chosen.get("respident") == "response1"
        assert idents.index(chosen.text) == "abcd".index(question.right)
        shown = {one.get("linkrefid") for one in item.iter(f"{{{QTI}}}displayfeedback")}
        given = item.findall("itemfeedback", PREFIX)
        assert shown == {one.get("ident") for one in given} == {f"{one}_fb" for one in idents}
        texts = [one.text for one in item.iter(f"{{{QTI}}}mattext")]
        for text in texts:  # each is itself well-formed HTML
            ElementTree.fromstring(text)


def test_moodle_can_read_the_questions(tmp_path):
    """Each lesson begins with its category; one choice has all points, and the others none."""
    file = tmp_path / "questions.xml"
    assert (
        main(["questions", "01_geometry", "12_the_car", "--to", "moodle", "--out", str(file)]) == 0
    )
    root = ElementTree.parse(file).getroot()
    assert root.tag == "quiz"
    kinds = [one.get("type") for one in root]
    assert kinds == ["category", *["multichoice"] * 5] * 2
    assert root[6].find("category/text").text == "$course$/top/kinoedu/Lesson 12: The car"
    numbers = [
        one.find("idnumber").text
        for one in root.iter("question")
        if one.find("idnumber") is not None
    ]
    assert len(set(numbers)) == 10
    for one in root.findall("question[@type='multichoice']"):
        assert one.find("single").text == "true"
        assert one.find("questiontext").get("format") == "html"
        assert sorted(a.get("fraction") for a in one.findall("answer")) == ["0", "0", "0", "100"]
        assert all(a.find("feedback/text").text.startswith("<p>") for a in one.findall("answer"))
        for text in one.iter("text"):
            if text.text.startswith("<"):
                ElementTree.fromstring(text.text)


def test_a_file_for_the_other_platform_is_not_written(tmp_path, capsys):
    """Canvas would not import an .xml; the error says which ending it reads."""
    file = tmp_path / "questions.xml"
    assert main(["questions", "--to", "canvas", "--out", str(file)]) == 2
    assert f"--out {file}: a file of questions for canvas ends in .zip" in capsys.readouterr().err
    assert not file.exists()


def test_an_unknown_lesson_writes_no_file(tmp_path, capsys):
    """The error lists the lessons."""
    for platform, (ending, _) in PLATFORMS.items():
        file = tmp_path / f"questions{ending}"
        assert main(["questions", "geometry", "--to", platform, "--out", str(file)]) == 2
        assert "01_geometry" in capsys.readouterr().err
        assert not file.exists()


def test_a_kit_may_hold_answers_back():
    """Neither the file nor the notebook that students get has an answer; other files stay."""
    lesson = "01_geometry"
    asked = Questions(lesson, read_questions(lesson))
    output = {"data": {"text/html": [asked._repr_html_()], "text/plain": [repr(asked)]}}
    book = {"cells": [{"outputs": [output]}, {"source": "a = 1"}]}
    place = f"{QUESTIONS}en/{lesson}.toml"
    files = {
        place: (HERE / "en" / f"{lesson}.toml").read_bytes(),
        f"notebooks/{lesson}.ipynb": json.dumps(book).encode(),
        f"{QUESTIONS}en/06_sampling.toml": b"",
    }
    held = hold_questions_back(lesson, files)
    assert set(held) == {place, f"notebooks/{lesson}.ipynb"}
    everything = json.loads(json.dumps([text.decode() for text in held.values()]))
    for question in asked.questions:
        assert all(question.text in text for text in everything)
        for choice in question.choices:
            assert all(choice.text in text for text in everything)
            assert not any(choice.why in text for text in everything)
    for question in parse_questions(held[place].decode(), place):
        assert (question.right, question.choices[0].why) == ("", "")
        with pytest.raises(InvalidParameter, match="your teacher"):
            _ = question.right_choice
    del files[f"notebooks/{lesson}.ipynb"]  # a teacher asks the questions without the lesson
    assert set(hold_questions_back(lesson, files)) == {place}
    with pytest.raises(InvalidParameter, match="15_flying"):
        hold_questions_back("15_flying", files)


@pytest.mark.parametrize("platform", PLATFORMS)
def test_held_back_questions_are_not_written_for_a_platform(
    platform, tmp_path, capsys, monkeypatch
):
    """The command says in one line that this copy has no answers, and leaves no file."""
    lesson = "01_geometry"
    (tmp_path / "en").mkdir()
    asked = (HERE / "en" / f"{lesson}.toml").read_text(encoding="utf-8")
    (tmp_path / "en" / f"{lesson}.toml").write_text(hold_back(asked), encoding="utf-8")
    monkeypatch.setattr("kinoedu.course.questions.question.HERE", tmp_path)
    file = tmp_path / f"questions{PLATFORMS[platform][0]}"
    assert main(["questions", lesson, "--to", platform, "--out", str(file)]) == 2
    assert "not in this copy of the course" in capsys.readouterr().err
    assert not file.exists()


def test_every_answer_stands_on_a_line_of_its_own():
    """What is held back is all that says which choice is right."""
    for lesson in LESSONS:
        text = (HERE / "en" / f"{lesson}.toml").read_text(encoding="utf-8")
        held = parse_questions(hold_back(text), lesson)
        assert all(not one.right and not any(c.why + c.slip for c in one.choices) for one in held)


@pytest.mark.parametrize("lesson", LESSONS)
def test_every_notebook_asks_its_questions(lesson):
    """The stored output is that of the present questions; the kit's has no answers."""
    place = f"notebooks/{lesson}.ipynb"
    asked = Questions(lesson, read_questions(lesson))
    data = (HOUSE / place).read_bytes()
    (cell,) = (
        c for c in json.loads(data)["cells"] if f'ke.ask("{lesson}")' in "".join(c["source"])
    )
    (output,) = cell["outputs"]
    assert "".join(output["data"]["text/html"]) == asked._repr_html_()
    assert "".join(output["data"]["text/plain"]) == repr(asked)
    files = {place: data}
    for file in (HERE / "en").glob("*.toml"):
        files[f"{QUESTIONS}en/{file.name}"] = file.read_bytes()
    held = hold_questions_back(lesson, files)[place].decode()
    assert json.dumps(asked.questions[2].text, ensure_ascii=False)[1:-1] in held
    assert not any(
        json.dumps(choice.why, ensure_ascii=False)[1:-1] in held
        for question in asked.questions
        for choice in question.choices
    )
