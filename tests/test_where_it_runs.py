"""Where the course runs: what it stands on may be used; without network; in an image; in a
browser.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest
from jupyter_server.serverapp import ServerApp
from jupyter_server.services.kernels.kernelmanager import MappingKernelManager
from PIL import Image
from test_start import Course
from traitlets.config import Config

from kinoedu.cli import make_parser
from kinoedu.compiled.store import user_cache

HOUSE = Path(__file__).resolve().parent.parent
DOCS = HOUSE / "docs"


@pytest.fixture
def course(tmp_path):
    return Course(tmp_path)


# --- licences


def load(path: Path):
    """A script as a module."""
    spec = spec_from_file_location(path.stem, path)
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_pinned_package_has_a_licence():
    """A new dependency without a line fails here: python docs/licences.py writes it."""
    script, page = load(DOCS / "licences.py"), (DOCS / "licences.md").read_text(encoding="utf-8")
    assert HOUSE / "environment.txt" in script.environments() and len(script.environments()) >= 3
    for file in script.environments():
        table = page.partition(f"### `{file.relative_to(HOUSE).as_posix()}`")[2].partition("###")[0]
        result = {
            row[1]: row[0].split(" | ")[1].strip()
            for row in script.ROW.finditer(table)
            if row[1] != "package"
        }
        assert script.pinned(file) == sorted(result), "run python docs/licences.py"
        assert all(re.search("[A-Z]", licence) for licence in result.values()), result


def test_every_folder_of_data_has_a_licence():
    """And every licence that lies beside data is linked."""
    page = (DOCS / "licences.md").read_text(encoding="utf-8").partition("## Packages")[0]
    rooms = [HOUSE / "notebooks", HOUSE / "tests" / "data"]
    folders = [
        folder
        for room in rooms
        for folder in sorted(room.iterdir())
        if folder.is_dir() and folder.name[0] not in "._"
    ]
    assert len(folders) >= 12
    for folder in folders:
        assert re.search(rf"^\| \[?{folder.relative_to(HOUSE).as_posix()}\b", page, re.MULTILINE), (
            folder
        )
        for licence in folder.glob("LICENSE*"):
            assert f"../{licence.relative_to(HOUSE).as_posix()})" in page, licence


# --- without network


def test_a_wheelhouse_is_gathered_and_set_up_from(course, tmp_path, monkeypatch):
    """What pip and uv get: to download all that was set up; to install from nothing but the
    folder.
    """
    start = load(course.home / "start.py")
    commands = []
    monkeypatch.setattr(start, "finish", lambda line, *_: commands.append(line) or True)
    monkeypatch.setenv("PATH", f"{course.bin}{os.pathsep}{os.defpath}")
    wheels = tmp_path / "whéels 1"
    assert start.main(["wheelhouse", str(wheels)]) == 0
    install, *_, download = (" ".join(line) for line in commands)
    assert "--no-index" not in install and "--no-index" not in download
    assert f"pip download --dest {wheels} " in download and download.endswith(
        "--no-deps --only-binary :all: -r environment.txt"
    )

    wheels.mkdir()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("KINOEDU_WHEELS", wheels.name)  # relative: the installers run elsewhere
    for tool in (start.with_uv, start.with_pip):
        assert tool("environment.txt", None, None)
        assert f"--no-index --find-links {wheels} --no-deps" in " ".join(commands[-1])


def test_a_folder_of_wheels_is_named_and_is_there(course, tmp_path):
    """One line says which folder is missing; --wheels takes nothing from the command that follows
    it.
    """
    (tmp_path / "wheels").mkdir()
    ended = course.run("--wheels", "wheels", "exit", "7", cwd=tmp_path)
    assert ended.status == 7 and ended.seen[0]["arguments"] == ["exit", "7"]
    (course.home / "environment.txt").write_text("# changed\n")
    for arguments in (["--wheels", "nowhere", "plan"], ["--wheels"], ["wheelhouse"]):
        ended = course.run(*arguments, cwd=tmp_path)
        last = ended.complaints.splitlines()[-1]
        assert ended.status == 2 and "folder" in last and "Traceback" not in ended.complaints
        assert "nowhere" in last or arguments[0] in last


@pytest.fixture
def wheels(tmp_path):
    """A folder with one package, which no index has."""
    import zipfile

    (tmp_path / "wheels").mkdir()
    with zipfile.ZipFile(tmp_path / "wheels" / "only_here-1.0-py3-none-any.whl", "w") as wheel:
        wheel.writestr("only_here.py", "result = 42\n")
        wheel.writestr(
            "only_here-1.0.dist-info/METADATA",
            "Metadata-Version: 2.1\nName: only-here\nVersion: 1.0\n",
        )
        wheel.writestr(
            "only_here-1.0.dist-info/WHEEL",
            "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        )
        wheel.writestr("only_here-1.0.dist-info/RECORD", "")
    return tmp_path / "wheels"


def test_wheels_in_a_folder_are_enough(course, tmp_path, wheels):
    """A package that no index has is installed, by pip, from the folder."""
    (course.home / "environment.txt").write_text("only-here==1.0\n")
    ended = course.run("--wheels", "wheels", "plan", cwd=tmp_path, uv="refuse")
    assert ended.status == 0, ended.complaints
    assert [path.read_text() for path in course.venv.glob("[Ll]ib/**/only_here.py")] == [
        "result = 42\n"
    ]


def test_pip_makes_a_half_written_package_whole(course, wheels):
    """Whichever of its files is not there."""
    (course.home / "environment.txt").write_text("only-here==1.0\n")
    how = {"uv": "refuse", "KINOEDU_WHEELS": str(wheels)}
    course.run("plan", **how)
    for lost in ("METADATA", "RECORD", None):
        (package,) = course.venv.glob("[Ll]ib/**/only_here.py")
        package.write_text("to")
        if lost:
            (package.parent / "only_here-1.0.dist-info" / lost).unlink()
        (course.venv / "installed.json").unlink()
        ended = course.run("plan", **how)
        assert ended.status == 0, (lost, ended.complaints)
        assert package.read_text() == "result = 42\n", lost


# --- a course that nobody writes to


def test_where_only_the_home_can_be_written_the_course_plans(tmp_path):
    """All else of the disk is read-only: kinoedu plans, draws, and keeps compiled code at home,
    begun with what all users share.
    """
    shut_in = [
        "bwrap",
        "--ro-bind",
        "/",
        "/",
        "--dev",
        "/dev",
        "--proc",
        "/proc",
        "--bind",
        str(tmp_path),
        str(tmp_path),
    ]
    if (
        shutil.which("bwrap") is None
        or subprocess.run([*shut_in, "true"], capture_output=True).returncode
    ):
        pytest.skip("bubblewrap cannot be used here")
    kept = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("XDG_", "KINOEDU_", "MPL"))
    }
    home = {
        "HOME": str(tmp_path),
        "TMPDIR": str(tmp_path),
        "KINOEDU_WARMED": str(user_cache()),
        "KINOEDU_MACHINE_CODE": "first",
    }
    town = [
        "notebooks/maps/Paris_1_256.map",
        "--query",
        "324",
        "--planner",
        "rrt",
        "--out",
        str(tmp_path / "plan.png"),
    ]
    command = [*shut_in, sys.executable, "-m", "kinoedu", "plan", *town]
    run = subprocess.run(
        command, cwd=HOUSE, env=kept | home, capture_output=True, text=True, timeout=300
    )
    assert run.returncode == 0 and run.stdout.startswith("found"), run.stdout + run.stderr
    assert (tmp_path / "plan.png").is_file() and list(tmp_path.glob(".cache/kinoedu/*/*"))


# --- an image


def instructions() -> list[tuple[str, str]]:
    """The lines of the Containerfile, continued ones joined, as (word, rest)."""
    text = re.sub(r"\\\n\s*", "", (HOUSE / "Containerfile").read_text(encoding="utf-8"))
    return [tuple(line.split(maxsplit=1)) for line in text.splitlines() if line and line[0] != "#"]


def test_the_image_copies_what_is_there_and_sent():
    """Every source of a COPY exists, and .containerignore lets it and nothing else through."""
    copied = {
        source for word, rest in instructions() if word == "COPY" for source in rest.split()[:-1]
    }
    assert copied >= {"start.py", "environment.txt", "kinoedu", "notebooks"}
    assert all((HOUSE / source).exists() for source in copied)
    ignored = (HOUSE / ".containerignore").read_text(encoding="utf-8").splitlines()
    assert "*" in ignored and {line[1:] for line in ignored if line.startswith("!")} == copied


def test_the_image_installs_what_start_installs_and_nothing_else():
    """start.py does it, from environment.txt; pip brings JupyterHub alone, and only where a version
    is asked for.
    """
    runs = [rest for word, rest in instructions() if word == "RUN"]
    start = load(HOUSE / "start.py")
    assert start.COURSE == "environment.txt" and "release" in start.TEACHING_COMMANDS
    assert [
        re.findall(r"start\.py ([^&]+?) *(?:&|$)", run) for run in runs if "start.py" in run
    ] == [
        ["warm --all"],
        ["release --help"],
    ]
    (pip,) = [run for run in runs if "pip" in run]
    assert pip.startswith('if [ -n "$JUPYTERHUB" ]') and "--constraint environment.txt" in pip


def test_students_and_the_grader_are_not_root_and_the_solutions_stay_with_the_grader():
    """What is built if nothing else is asked for is the last stage."""
    stages: list[list[tuple[str, str]]] = []
    for word, rest in instructions():
        stages += [[]] if word == "FROM" else []
        stages[-1].append((word, rest))
    base, grader, course = stages
    assert [stage[0][1].rpartition(" AS ")[2] for stage in stages] == ["base", "grader", "course"]
    assert all(
        [rest for word, rest in stage if word == "USER"] == ["student"]
        for stage in (grader, course)
    )
    assert any("solutions" in rest for _, rest in grader) and not any(
        "solutions" in rest for _, rest in base + course
    )


def test_what_the_image_tells_jupyter_is_python_that_runs(monkeypatch):
    """The configuration that is written leads to the lessons, and opens the tour; so it does in a
    hub that says nothing else.
    """
    (run,) = [
        rest for word, rest in instructions() if word == "RUN" and "jupyter_server_config" in rest
    ]
    lines = re.findall(r'"([^"]+)"', run)

    class Any:
        """Takes every attribute."""

    config = Any()
    for hub, opened in (("", "/lab/tree/notebooks/00_tour.ipynb"), ("/tree", "/tree")):
        config.ServerApp, config.LabApp = Any(), Any()
        monkeypatch.setenv("JUPYTERHUB_DEFAULT_URL", hub)
        exec("\n".join(lines), {"c": config})
        assert (
            Path(config.ServerApp.root_dir) / config.LabApp.default_url.removeprefix("/lab/tree/")
        ).is_file()
        assert config.ServerApp.default_url == opened


def test_the_recipe_for_a_class_fits_the_image():
    """It is Python that runs; its folders, image and options are those of the Containerfile and of
    Jupyter; its totals follow from its measurements.
    """
    page = (DOCS / "where_it_runs.md").read_text(encoding="utf-8")
    recipe = page.partition("\n## A class of 120\n")[2].partition("\n## ")[0]
    (code,) = re.findall(r"```python\n(.*?)```", recipe, re.DOTALL)
    hub = Config()
    exec(code, {"get_config": lambda: hub})
    image = dict(rest.split("=", 1) for word, rest in instructions() if word == "ENV")
    warmed = hub.DockerSpawner.environment["KINOEDU_WARMED"]
    assert warmed == image["KINOEDU_WARMED"]
    homes = [rest for word, rest in instructions() if word == "WORKDIR"]
    assert set(hub.DockerSpawner.volumes.values()) <= set(homes)
    options = {arg.split("=")[0].removeprefix("--") for arg in hub.DockerSpawner.args}
    assert options <= {
        f"{owner.__name__}.{name}"
        for owner in (MappingKernelManager, ServerApp)
        for name in owner.class_trait_names(config=True)
    }
    rows = re.findall(r"(?m)^\| .+? \| (\d+) \| (\d+)\D", recipe)
    (server, _), (kernel, _), (both, shared) = [tuple(map(int, row)) for row in rows]
    assert abs(server + kernel - both) <= 1
    assert f"{(120 * both + shared) / 1000:.0f} GB" in recipe
    assert f"{120 * (server + 467) / 1000:.0f} GB" in recipe


# --- a browser


@pytest.mark.parametrize("lesson", ["01_geometry", "02_bug_algorithms"])
def test_a_lesson_shows_the_same_in_a_browsers_python(lesson):
    """Without numba, processes and threads every cell runs, and every number is the stored one."""
    notebook = HOUSE / "notebooks" / f"{lesson}.ipynb"
    command = [sys.executable, str(HOUSE / "tests" / "like_pyodide.py"), str(notebook)]
    run = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", timeout=500)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    result = json.loads(run.stdout.splitlines()[-1])
    assert "numba" in result["requested"]
    cells = [
        cell
        for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == "code"
    ]
    assert len(cells) == len(result["texts"])
    for cell, text in zip(cells, result["texts"]):
        outputs = cell["outputs"]
        printed = [
            "".join(out["text"])
            for out in outputs
            if out["output_type"] == "stream" and out["name"] == "stdout"
        ]
        returned = [
            "".join(out["data"].get("text/plain", ""))
            for out in outputs
            if out["output_type"] == "execute_result"
        ]
        assert "".join([*printed, "\n", *returned]).split() == text.split()


def test_work_is_done_where_there_are_no_threads():
    """A student's function, and what it raises: in a browser nothing bounds its time."""
    code = (
        "import like_pyodide as p; from kinoedu.support.time_limit import run_within, "
        "run_within_processor_time; "
    )
    code += "p.refuse_processes_and_threads(); "
    code += "print(run_within(1.0, lambda: 42), run_within_processor_time(1.0, lambda: 43))"
    run = subprocess.run(
        [sys.executable, "-c", code],
        cwd=HOUSE / "tests",
        capture_output=True,
        text=True,
        timeout=100,
    )
    assert run.stdout == "42 43\n", run.stderr


def test_the_browsers_lessons_bring_what_they_need(tmp_path):
    """The first cell names all that kinoedu stands on but what a browser cannot have; nothing else
    of a lesson changes.
    """
    build = load(HOUSE / "jupyterlite" / "build.py")
    wanted = build.packages()
    assert {"numpy", "anywidget", "shapely", "trimesh"} <= set(
        wanted
    ) and not build.ELSEWHERE & set(wanted)
    build.copy_lessons(HOUSE, tmp_path)
    assert (tmp_path / "notebooks" / "maps" / "Paris_1_256.map").is_file() and not (
        tmp_path / "solutions"
    ).exists()
    for room in ("notebooks", "exercises"):
        for file in (HOUSE / room).glob("*.ipynb"):
            book, copy = (
                json.loads((place / room / file.name).read_text(encoding="utf-8"))
                for place in (HOUSE, tmp_path)
            )
            assert copy["cells"][1:] == book["cells"]
            assert (
                copy["cells"][0]["source"].endswith(" kinoedu")
                and " numpy " in copy["cells"][0]["source"]
            )


# --- the boards' page


def test_every_board_has_its_picture_and_its_line():
    """Small enough to be sent, wide enough to be read; the line that opens it names what is there,
    as does the lesson.
    """
    import kinoedu.boards

    page = (DOCS / "boards.md").read_text(encoding="utf-8")
    entries = re.findall(
        r"!\[(.+?)\]\(boards/(\w+)\.png\)\n\n(.+?)\n\n```python\n(.+?)\n```", page, re.DOTALL
    )
    boards = {name for name in kinoedu.boards.__all__ if name == "board" or name.endswith("_board")}
    assert {name for _, name, _, _ in entries} == boards and len(entries) == len(boards)
    assert {file.stem for file in (DOCS / "boards").iterdir()} == boards
    for alt, name, text, code in entries:
        picture = DOCS / "boards" / f"{name}.png"
        with Image.open(picture) as image:
            assert 400 <= image.width <= 1280 and picture.stat().st_size < 80_000
        assert len(alt) > 20 and f"{name}(" in code
        for lesson in re.findall(r"\]\((.+?\.ipynb)\)", text):
            assert f"{name}(" in (DOCS / lesson).read_text(encoding="utf-8"), (
                f"{name} is not in {lesson}"
            )


# --- a dev container and Colab


def test_the_dev_container_sets_the_course_up():
    """By start.py, with a command that kinoedu has; the editor finds its Python and the tour."""
    container = json.loads((HOUSE / ".devcontainer" / "devcontainer.json").read_text("utf-8"))
    assert re.fullmatch(r"[\w./-]+/python:3\.1[1-4]", container["image"])
    python, start, *command = container["onCreateCommand"].split()
    assert (python, start) == ("python", "start.py")
    make_parser().parse_args(command)
    settings = container["customizations"]["vscode"]["settings"]
    python = Path(load(HOUSE / "start.py").PYTHON).relative_to(HOUSE)
    if os.name != "nt":
        assert settings["python.defaultInterpreterPath"].endswith(f"}}/{python.as_posix()}")
    assert all(
        (HOUSE / file).is_file() for file in container["customizations"]["codespaces"]["openFiles"]
    )


COLAB = """
import os, sys, types
output = types.ModuleType("google.colab.output")
output.enable_custom_widget_manager = lambda: print("boards are allowed")
colab = types.ModuleType("google.colab")
colab.output = output
sys.modules |= {"google": types.ModuleType("google"), "google.colab": colab}
sys.modules["google.colab.output"] = output
"""
A_BOARD = """
import kinoedu as ke
print(type(ke.board(ke.read_problem("maps/Paris_1_256.map", query=324))).__name__)
"""


def test_the_cell_for_colab_sets_the_course_up(tmp_path):
    """Run by IPython with a stand-in for Colab, but for the installation: the lessons are copied,
    their maps are found, and a board opens.
    """
    page = (DOCS / "where_it_runs.md").read_text(encoding="utf-8")
    cell, kit = re.findall(
        r"```ipython3\n(.*?)```", page.partition("\n## Colab\n")[2].partition("\n## ")[0], re.DOTALL
    )
    first, copy, *rest = cell.splitlines()
    assert first == "%pip install --quiet kinoedu" and copy.startswith("!kinoedu lessons /content/")
    assert "%pip install --quiet /content/kinoedu-course" in kit
    copy = copy.replace("!kinoedu", f'!"{sys.executable}" -m kinoedu')
    lines = "\n".join([copy, *rest]).replace("/content", tmp_path.as_posix())
    (tmp_path / "cell.ipy").write_text(COLAB + lines + A_BOARD, encoding="utf-8")
    command = [sys.executable, "-P", "-m", "IPython", "--no-banner", "cell.ipy"]
    variables = os.environ | {"IPYTHONDIR": str(tmp_path / "ipython")}
    run = subprocess.run(
        command, cwd=tmp_path, env=variables, capture_output=True, text=True, timeout=200
    )
    assert "boards are allowed\nBoard\n" in run.stdout, run.stdout + run.stderr
    assert (tmp_path / "kinoedu" / "exercises" / "01_geometry.ipynb").is_file()
