"""The rules of the house: style, types, imports, notebooks, what may print."""

import ast
import importlib
import json
import pydoc
import subprocess
import sys
from pathlib import Path

import pytest

HOUSE = Path(__file__).resolve().parent.parent
SOURCES = sorted((HOUSE / "kinoedu").rglob("*.py"))
PAGES = sorted(
    p
    for room in ("kinoedu", "docs")
    for kind in ("js", "css")
    for p in (HOUSE / room).rglob(f"*.{kind}")
)
ROOMS = {
    *("start.py", "kinoedu", "tests", "benchmarks", "docs", "jupyterlite"),
    *("notebooks", "exercises", "solutions"),
}
NOTEBOOKS = sorted(
    p for room in ("notebooks", "exercises", "solutions") for p in (HOUSE / room).glob("*.ipynb")
)


@pytest.mark.parametrize(
    "tool",
    [
        ["ruff", "check", *sorted(ROOMS)],
        ["ruff", "format", "--check", "kinoedu", "tests", "benchmarks"],
        ["mypy"],
        ["importlinter.cli", "lint"],
    ],
    ids=lambda tool: " ".join(tool[:2]),
)
def test_tool_finds_nothing(tool):
    """ruff, mypy and the import contracts pass."""
    command = [sys.executable, "-m", *tool]
    if tool[0].startswith("importlinter"):
        command = [
            sys.executable,
            "-c",
            "from importlinter.cli import lint_imports; raise SystemExit(lint_imports())",
        ]
    run = subprocess.run(
        command, cwd=HOUSE, capture_output=True, text=True, encoding="utf-8", errors="replace"
    )
    assert run.returncode == 0, run.stdout + run.stderr


def test_ruff_reads_what_the_project_has():
    """And nothing else: teachers keep submissions, grades and drafts in the same folder."""
    listed = subprocess.run(
        ["git", "ls-files", "*.py", "*.ipynb"], cwd=HOUSE, capture_output=True, text=True
    )
    if listed.returncode != 0:
        pytest.skip("this copy of the project is no repository")
    assert {name.split("/")[0] for name in listed.stdout.splitlines()} == ROOMS


def test_no_circle_of_imports():
    """Of files, also by imports within functions and for types alone. But for those of compiled/,
    where numba is imported only when machine code is loaded or made."""
    import networkx as nx

    sys.path.append(str(HOUSE / "docs"))
    from house_picture import imports

    circles = [
        circle
        for circle in nx.strongly_connected_components(nx.DiGraph(imports()))
        if len(circle) > 1
    ]
    tiers = {f"kinoedu.compiled.{name}" for name in ("compiler", "numba_thread", "tiers")}
    assert circles == [tiers]


def test_the_picture_of_the_house_shows_its_rooms_and_imports():
    """As they are: docs/house_picture.py draws it anew."""
    sys.path.append(str(HOUSE / "docs"))
    from house_picture import PICTURE, drawn

    assert PICTURE.read_text(encoding="utf-8") == drawn()


@pytest.fixture(scope="module")
def trees():
    """The syntax tree of every source, by its path within the project."""
    return {
        source.relative_to(HOUSE): ast.parse(source.read_text(encoding="utf-8"))
        for source in SOURCES
    }


def test_every_file_and_public_function_says_what_it_is(trees):
    """Modules, public classes and public functions have docstrings."""
    assert [str(path) for path, tree in trees.items() if not ast.get_docstring(tree)] == []
    assert [
        f"{path}: {node.name}"
        for path, tree in trees.items()
        for node in tree.body
        if isinstance(node, ast.FunctionDef | ast.ClassDef)
        and not (node.name.startswith("_") or ast.get_docstring(node))
    ] == []


def test_rooms_are_small(trees):
    """A file has one purpose: at most 400 lines, and no function over 60 below its docstring."""
    assert [
        str(source)
        for source in SOURCES
        if len(source.read_text(encoding="utf-8").splitlines()) > 400
    ] == []
    assert [
        f"{path}: {node.name}"
        for path, tree in trees.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef) and node.end_lineno - first_line_of_code(node) >= 60
    ] == []


def first_line_of_code(function):
    """Where a function's own lines begin, below its docstring."""
    has_docstring = ast.get_docstring(function) is not None and len(function.body) > 1
    return function.body[1 if has_docstring else 0].lineno


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.relative_to(HOUSE).as_posix())
def test_scripts_and_styles_of_pages_have_at_most_100_columns(page):
    """As Python files, where ruff counts them."""
    lines = enumerate(page.read_text(encoding="utf-8").splitlines(), 1)
    assert [number for number, line in lines if len(line) > 100] == []


def test_only_the_command_line_prints(trees):
    """print stands in cli, lab.py and progress.py alone."""
    assert [
        str(path)
        for path, tree in trees.items()
        if path.parent.name != "cli" and path.name not in ("lab.py", "progress.py")
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id == "print"
    ] == []


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda p: p.relative_to(HOUSE).as_posix())
def test_notebook_is_stored_clean(notebook):
    """Run from top to bottom without errors, no widget state, no timestamps, small enough to send
    to a class, short cells.
    """
    text = notebook.read_text(encoding="utf-8")
    book = json.loads(text)
    code = [cell for cell in book["cells"] if cell["cell_type"] == "code"]
    assert [cell["execution_count"] for cell in code] == list(range(1, len(code) + 1))
    assert not any(output["output_type"] == "error" for cell in code for output in cell["outputs"])
    assert set(book["metadata"]) <= {"kernelspec", "language_info"}
    assert not any("execution" in cell["metadata"] for cell in code)
    longest = (
        10 if notebook.parent.name == "notebooks" else 25
    )  # an exercise is 5 to 25 lines to write
    assert max(len("".join(cell["source"]).splitlines()) for cell in code) <= longest
    assert len(text) < 1_000_000  # small enough to send to a class


ROOMS_WITH_HELP = (
    "boards c_space collision curves decomposition figures files geometry graphs planners problems "
    "robots sampling spaces worlds"
)


@pytest.mark.parametrize("room", ROOMS_WITH_HELP.split())
def test_help_begins_with_a_signature_that_fits_a_screen(room):
    """The types of its arguments have the names of the source: ArrayLike, and not all that numpy
    accepts for it. `from __future__ import annotations` keeps them.
    """
    module = importlib.import_module(f"kinoedu.{room}")
    lines = {name: signature_in_help(getattr(module, name)) for name in module.__all__}
    assert sum(line.startswith(name) for name, line in lines.items()) >= len(lines) / 2
    for name, line in lines.items():
        assert len(line) <= 500, name
        assert not any(long in line for long in ("Union[", "_SupportsArray", "numpy.")), name
        assert "ForwardRef" not in pydoc.render_doc(getattr(module, name)), name


def signature_in_help(thing):
    """The line of `help` with the signature of a function, or of what a class needs; or nothing."""
    lines = pydoc.plain(pydoc.render_doc(thing)).splitlines()
    beginnings = (f"{thing.__name__}(", f" |  {thing.__name__}(") if callable(thing) else ()
    return next((line.lstrip(" |") for line in lines if line.startswith(beginnings)), "")


def test_readme_names_files_that_exist():
    """Every link of the README and the docs leads to a file."""
    import re

    for page in (HOUSE / "README.md", *(HOUSE / "docs").glob("*.md")):
        for target in re.findall(r"\]\(([^)#]+)\)", page.read_text(encoding="utf-8")):
            assert target.startswith("http") or (page.parent / target).exists(), (
                f"{page.name}: {target}"
            )


def test_lines_beside_the_book_are_those_of_the_files():
    """docs/contributing.md quotes our lines without their comments, in order, and counts them."""
    import re

    def code(text):
        return [line.split("  #")[0].rstrip() for line in text.splitlines() if line.strip()]

    page = (HOUSE / "docs" / "contributing.md").read_text(encoding="utf-8")
    part = page.partition("## Beside the book")[2].partition("\n## ")[0]
    for section in part.split("\n### ")[1:]:
        steps, lines = map(int, re.findall(r"\d+(?= steps| lines)", section.splitlines()[0]))
        file = re.findall(r"`\w+`[^`]* in\s+\[[^]]*\]\(([^)]+)\)", section)[0]
        source = "\n".join(code((HOUSE / "docs" / file).read_text(encoding="utf-8")))
        quoted = [code(block) for block in re.findall(r"```python\n(.*?)```", section, re.DOTALL)]
        assert all("\n".join(block) in source for block in quoted), file
        assert sum(map(len, quoted)) == lines
        assert len(re.findall(r"^\d  ", section, re.MULTILINE)) == steps


def test_index_of_algorithms_names_every_planner():
    """And nothing that is not there."""
    import operator
    import re

    import kinoedu

    named = re.findall(
        r"`ke\.([\w.]+)", (HOUSE / "docs" / "algorithms.md").read_text(encoding="utf-8")
    )
    assert all(operator.attrgetter(name)(kinoedu) for name in named)
    assert {name for name in kinoedu.planners.__all__ if name.islower()} <= {
        name.rpartition(".")[2] for name in named
    }


def test_shipped_maps_are_the_tested_ones():
    """The maps beside the notebooks equal those whose every query is tested."""
    shipped = [
        file
        for file in (HOUSE / "notebooks" / "maps").iterdir()
        if file.suffix in (".map", ".scen")
    ]
    assert len(shipped) == 4
    for file in shipped:
        assert file.read_bytes() == (HOUSE / "tests" / "data" / "grid" / file.name).read_bytes()
