"""Every link of the course's pages leads somewhere, in the repository and in the kit for students.

What students are told to run is there for them. Links to other sites are not followed.
"""

import json
import re
import sys
from fnmatch import fnmatch
from pathlib import Path
from urllib.parse import urlsplit

import pytest

from kinoedu.cli import make_parser
from kinoedu.course.release import files_for_students, students_readme

HOUSE = Path(__file__).resolve().parent.parent
sys.path.append(str(HOUSE / "docs"))
from links import anchors, follow, read_page  # noqa: E402 (the page's own script)

COMMAND = re.compile(r"python start\.py\b([^`\n#]*)")
# files that own_code.md tells its reader to write
OWN = ("notebooks/pit.toml", "notebooks/pit.json", "notebooks/mine.py:potential")
FOR_TEACHERS = ("test", "site", "release", "grade", "regrade", "export", "similar", "bench")


@pytest.fixture(scope="module")
def kit(tmp_path_factory):
    """The files of the kit; the recorded results are no page."""
    folder = tmp_path_factory.mktemp("kit").resolve()
    for place, data in files_for_students().items():
        (folder / place).parent.mkdir(parents=True, exist_ok=True)
        (folder / place).write_bytes(data)
    return folder


@pytest.fixture(scope="module")
def links():
    """All links of the repository, each with whether it leads somewhere."""
    return list(follow(HOUSE))


def find_broken(house, links):
    """The files and targets of links that lead nowhere."""
    broken = [link for link, sound in links if sound is False]
    return [(link.file.relative_to(house).as_posix(), link.target) for link in broken]


def test_every_link_of_the_repository_leads_somewhere(links):
    """To a file in it, and a part that this file has."""
    assert find_broken(HOUSE, links) == []
    assert sum(sound is True for _, sound in links) > 300


def test_every_link_of_the_kit_leads_somewhere(kit):
    """In README, exercises, lessons and guides."""
    links = list(follow(kit))
    assert find_broken(kit, links) == []
    assert sum(sound is True for _, sound in links) > 200


def test_links_to_other_sites_are_whole_and_encrypted(links):
    """python docs/links.py lists them."""
    outside = {urlsplit(link.target) for link, sound in links if sound is None}
    assert len(outside) > 5
    assert all(there.scheme == "https" and "." in there.netloc for there in outside)


@pytest.mark.parametrize(
    ("text", "broken"),
    [
        ("[a](other.md) [b](other.md#a-part-of-it) [c](#here)\n\n# Here", []),
        ("[a](nowhere.md)", ["nowhere.md"]),
        ("[a](other.md#another)", ["other.md#another"]),
        (
            "![a](no.png) <img src='none.png'> [a][b]\n\n[b]: gone.md",
            ["no.png", "none.png", "gone.md"],
        ),
        ("[a](../outside.md)", ["../outside.md"]),
        ("`[a](code.md)` and\n\n    [b](more_code.md)", []),
        ("[a](https://example.org/nothing)", []),
    ],
)
def test_a_broken_link_is_found(tmp_path, text, broken):
    """Of a page, a picture, a part, and of HTML; code has no links."""
    (tmp_path / "outside.md").write_text("")
    house = tmp_path.resolve() / "house"
    house.mkdir()
    (house / "page.md").write_text(text, encoding="utf-8")
    (house / "other.md").write_text("# A part, of `it`!\n", encoding="utf-8")
    assert sorted(target for _, target in find_broken(house, follow(house))) == sorted(broken)


def test_anchors_are_those_of_github():
    """A link in a heading counts by its text, and punctuation does not."""
    assert "an-image" in anchors("An image")
    assert "whats-a-b-c" in anchors("What's a, [b](c.md) `c`?")


def test_the_kits_readme_speaks_to_students(kit):
    """Of nothing that only instructors have; with all lessons."""
    text = (kit / "README.md").read_text(encoding="utf-8")
    assert text == students_readme()
    assert not re.search(r"(?i)instructor|solutions|contribut|benchmark|pytest", text)
    lessons = {file.name for file in (HOUSE / "notebooks").glob("*.ipynb")}
    assert lessons <= {Path(link).name for link in read_page(kit / "README.md").links}


def test_what_students_are_told_to_run_is_there_for_them(kit):
    """Commands of the kit's pages and of its notebooks, with files that it has."""
    pages = [*kit.rglob("*.md"), *kit.glob("*/*.ipynb")]
    told = [line for page in pages for line in COMMAND.findall(page.read_text(encoding="utf-8"))]
    assert len(told) > 6
    for line in map(str.split, told):
        assert not {*line[:1]} & {*FOR_TEACHERS}, line
        if line and "--help" not in line:
            make_parser().parse_args(line)
            given = [word for word in line if word.startswith(("notebooks/", "exercises/"))]
            assert all((kit / word).is_file() for word in given if word not in OWN), line


@pytest.mark.parametrize("page", ["contributing", "SUPPORT", "SECURITY", "CODE_OF_CONDUCT"])
def test_pages_for_a_community_are_where_platforms_look(page):
    """In docs, linked to each other and from README; they name no address that may not exist."""
    file = HOUSE / "docs" / f"{page}.md"
    text = file.read_text(encoding="utf-8")
    assert len(text) > 300 and "@" not in re.sub(r"`[^`]*`|```.*?```", "", text, flags=re.DOTALL)
    pages = [HOUSE / "README.md", *(HOUSE / "docs").glob("*.md")]
    leading = [
        one for one in pages if any(link.endswith(file.name) for link in read_page(one).links)
    ]
    assert set(leading) - {file}


def words_of(lesson):
    """The words that a lesson lists as its own."""
    cells = json.loads(lesson.read_text(encoding="utf-8"))["cells"]
    lines = [line for cell in cells for line in cell["source"] if line.startswith("**Words**")]
    return re.findall(r"\*([^*]+)\*", "".join(lines).removeprefix("**Words**"))


@pytest.mark.parametrize(
    "lesson", sorted((HOUSE / "notebooks").glob("*.ipynb")), ids=lambda p: p.stem
)
def test_the_glossary_explains_each_word_of_a_lesson(lesson):
    """Its rows name every word at the end of a lesson: the README promises all terms."""
    glossary = (HOUSE / "docs" / "glossary.md").read_text(encoding="utf-8").lower()
    words = [word.replace("$", "").lower() for word in words_of(lesson)]
    assert [word for word in words if word not in glossary] == []
    assert words or lesson.stem.startswith("00_")


def test_git_leaves_alone_what_the_pages_on_grading_have_teachers_make():
    """Names of students, grades and secrets; the pages name the places in their commands."""
    ignored = [line.strip("/") for line in (HOUSE / ".gitignore").read_text().splitlines()]
    pages = "".join(page.read_text(encoding="utf-8") for page in HOUSE.glob("docs/grading*.md"))
    made = set(re.findall(r"--(?:out|zip|secret) ([a-z]\w+(?:\.zip)?)", pages))
    made |= set(re.findall(r"(?:grade|--variants|--template) ([a-z]\w+(?:\.\w+)?) --", pages))
    assert {"grades", "handouts", "gradescope_secret", "course.zip", "students.txt"} <= made
    named = {name for name in made if not any(fnmatch(name, one) for one in ignored)}
    assert named == set()


def test_scripts_run_with_the_courses_python():
    """Another Python has no kinoedu, and stops with an error that does not say so."""
    pages = [HOUSE / "README.md", *HOUSE.glob("docs/*.md"), *HOUSE.glob("benchmarks/*.md")]
    for page in pages:
        text = page.read_text(encoding="utf-8")
        assert not re.search(r"(?<!bin/)python (docs|benchmarks|tests)/", text), page
