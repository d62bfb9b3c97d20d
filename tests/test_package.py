"""The course as a package: built, installed in a clean environment, and used as a student would.

Nothing here needs the network. The clean environment has the package from its wheel, and sees the
other packages of the environment that runs the tests.
"""

import json
import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import tomllib
import urllib.request
import venv
import zipfile
from pathlib import Path
from typing import NamedTuple

import pytest
import yaml
from children import started
from lab_driver import wait_for

import kinoedu
from kinoedu.course.release import RESULTS, files_for_students
from kinoedu.lab import TOUR

HOUSE = Path(__file__).resolve().parent.parent
ROOMS = ("notebooks", "exercises")
LESSONS = {
    file.relative_to(HOUSE).as_posix(): file.read_bytes()
    for room in ROOMS
    for file in (HOUSE / room).rglob("*")
    if file.is_file() and not any(part.startswith(".") for part in file.parts)
}


def build(kind, source, folder):
    """Build a package from a folder; the file."""
    line = [sys.executable, "-m", "hatchling", "build", "-t", kind, "-d", str(folder)]
    subprocess.run(line, cwd=source, check=True, capture_output=True)
    (made,) = folder.glob("kinoedu-*.tar.gz" if kind == "sdist" else "kinoedu-*.whl")
    return made


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The package as pip installs it."""
    return build("wheel", HOUSE, tmp_path_factory.mktemp("wheel"))


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    """The folder of the unpacked source distribution."""
    folder = tmp_path_factory.mktemp("sdist")
    with tarfile.open(build("sdist", HOUSE, folder)) as archive:
        archive.extractall(folder, filter="data")
    return folder / f"kinoedu-{kinoedu.__version__}"


def read_wheel(file):
    """The files of a wheel, by their paths."""
    with zipfile.ZipFile(file) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


class Clean(NamedTuple):
    """An environment with the package alone, and a home with nothing in it."""

    scripts: Path
    home: Path

    def line(self, *arguments):
        return [str(self.scripts / "kinoedu"), *map(str, arguments)]

    def variables(self):
        """Those of a user who has never seen kinoedu; what is compiled once is shared."""
        kept = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
        jupyter = {name: str(self.home / name) for name in ("JUPYTER_CONFIG_DIR", "IPYTHONDIR")}
        homes = {"HOME": str(self.home), "USERPROFILE": str(self.home), "PYTHONUTF8": "1"}
        return kept | homes | jupyter | {"JUPYTER_RUNTIME_DIR": str(self.home / "run")}

    def run(self, *arguments):
        return subprocess.run(
            self.line(*arguments),
            cwd=self.home,
            env=self.variables(),
            capture_output=True,
            text=True,
            encoding="utf-8",
            timeout=300,
        )


@pytest.fixture(scope="module")
def clean(wheel, tmp_path_factory):
    """The wheel, installed by pip without an index."""
    place, home = tmp_path_factory.mktemp("clean") / "venv", tmp_path_factory.mktemp("home")
    venv.create(place, with_pip=True)
    paths = sysconfig.get_paths("venv", vars={"base": str(place), "platbase": str(place)})
    ours = sysconfig.get_path("purelib")
    Path(paths["purelib"], "of_the_tests.pth").write_text(f"{ours}\n", encoding="utf-8")
    python = Path(paths["scripts"], "python")
    options = ["--no-deps", "--no-index", "--quiet", "--disable-pip-version-check"]
    line = [python, "-I", "-m", "pip", "install", *options, wheel]
    subprocess.run(line, check=True, cwd=home)
    return Clean(Path(paths["scripts"]), home)


def test_the_package_has_the_lessons_and_no_solutions(wheel):
    """Every file of notebooks and exercises, byte for byte; nothing that running has left."""
    files = read_wheel(wheel)
    packed = {
        name.removeprefix("kinoedu/"): data
        for name, data in files.items()
        if name.split("/")[1] in ROOMS
    }
    assert len(packed) > 40 and packed == LESSONS
    assert {name.split("/")[0] for name in files} == {
        "kinoedu",
        f"kinoedu-{kinoedu.__version__}.dist-info",
    }
    assert not any("__pycache__" in name or ".ipynb_checkpoints" in name for name in files)
    assert not any(b"### BEGIN SOLUTION" in data for data in packed.values())
    assert wheel.stat().st_size < 12e6


def test_the_source_distribution_makes_the_same_package(wheel, source, tmp_path):
    """And has neither solutions nor tests."""
    assert not {path.name for path in source.iterdir()} & {"solutions", "tests", "benchmarks"}
    rebuilt, made = (
        {name: data for name, data in read_wheel(file).items() if not name.endswith("/RECORD")}
        for file in (build("wheel", source, tmp_path), wheel)
    )
    assert rebuilt == made


def test_the_kit_can_be_installed_too(tmp_path):
    """Its package has the kit's files, and so no answer; the wheel of the course has answers."""
    kit = files_for_students() | {RESULTS: b"recorded"}
    for place, data in kit.items():
        (tmp_path / "kit" / place).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "kit" / place).write_bytes(data)
    files = read_wheel(build("wheel", tmp_path / "kit", tmp_path))
    rooms = {f"kinoedu/{name}" if name.split("/")[0] in ROOMS else name for name in kit}
    assert {name for name in rooms if name.startswith("kinoedu/")} == {
        name for name in files if name.startswith("kinoedu/")
    }
    answer = "kinoedu/course/lessons/trees/rrt.py"
    assert files[answer] == kit[answer] != (HOUSE / answer).read_bytes()
    assert files[RESULTS] == b"recorded"


def test_pip_brings_what_the_lab_needs(wheel):
    """JupyterLab is no extra: pip install kinoedu, then kinoedu lab."""
    (metadata,) = (data for name, data in read_wheel(wheel).items() if name.endswith("/METADATA"))
    wanted = re.findall(r"(?m)^Requires-Dist: ([\w-]+)[^;\n]*$", metadata.decode())
    assert {"jupyterlab", "numba", "anywidget"} <= set(wanted)
    assert "# kinoedu" in metadata.decode() and "](" not in metadata.decode()  # no relative links


def test_the_installed_command_plans(clean):
    """With the package of the environment, and not with the one beside these tests."""
    code = "import kinoedu, sys; print(kinoedu.__version__, kinoedu.__file__)"
    printed = subprocess.check_output(
        [clean.scripts / "python", "-c", code], cwd=clean.home, text=True, env=clean.variables()
    )
    version, file = printed.split(maxsplit=1)
    assert version == kinoedu.__version__
    assert Path(file.strip()).is_relative_to(clean.scripts.parent)
    ended = clean.run("lessons", "mine")
    assert ended.returncode == 0, ended.stderr
    town = "mine/notebooks/maps/Paris_1_256.map"
    ended = clean.run("plan", town, "--query", "324", "--planner", "astar", "--out", "plan.png")
    assert ended.returncode == 0 and ended.stdout.startswith("found: length"), ended.stderr
    assert (clean.home / "plan.png").stat().st_size > 5000


def test_lessons_are_copied_and_work_is_kept(clean):
    """Once more, only what is missing is copied; a student's file stays, even if it is a broken
    link or a folder is in its place.
    """
    ended = clean.run("lessons", "copies")
    assert f"files copied to copies: {len(LESSONS)};" in ended.stdout, ended.stderr
    copies = clean.home / "copies"
    assert all((copies / name).read_bytes() == data for name, data in LESSONS.items())
    tour, first = copies / TOUR, copies / "exercises" / "01_geometry.ipynb"
    tour.write_text("mine", encoding="utf-8")
    first.unlink()
    first.mkdir()
    (copies / "notebooks" / "maps" / "README.md").unlink()
    assert "files copied to copies: 1;" in clean.run("lessons", "copies").stdout
    assert tour.read_text(encoding="utf-8") == "mine" and first.is_dir()
    assert not list(copies.rglob("*.part"))


def test_slides_are_made_of_the_lessons_in_the_package(clean):
    """Wherever the command is given; one that finds no lesson would end without a word."""
    ended = clean.run("slides", "01_geometry", "--out", "lecture")
    assert ended.returncode == 0, ended.stderr
    assert "<h1>" in (clean.home / "lecture" / "01_geometry.html").read_text(encoding="utf-8")
    assert "04_graph_search" in clean.run("slides", "graphs").stderr


def test_a_folder_that_is_a_file_is_refused_in_a_line(clean):
    """And the file stays as it is."""
    (clean.home / "essay.txt").write_text("mine", encoding="utf-8")
    for command in ("lessons", "lab"):
        ended = clean.run(command, "essay.txt")
        assert ended.returncode == 2 and ended.stderr.count("\n") == 1, ended.stderr
    assert (clean.home / "essay.txt").read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("arguments", [(), ("my lessons",)], ids=["at home", "in a folder"])
def test_the_installed_lab_opens_the_lessons(clean, arguments):
    """At the address that it prints; it ends when it is told to."""
    line = clean.line("lab", "--no-browser", *arguments)
    variables = clean.variables() | {"KINOEDU_MACHINE_CODE": "never"}
    log = clean.home / "server.log"
    with (
        log.open("w") as messages,
        started(
            line, cwd=clean.home, env=variables, stdout=subprocess.PIPE, stderr=messages
        ) as opened,
    ):
        address = next(text.strip() for text in opened.stdout if "?token=" in text)
        server, token = re.fullmatch(r"(http://.+/)lab/tree/.+\?token=(\w+)", address).groups()

        def ask(path, method="GET"):
            asked = urllib.request.Request(server + path, method=method)
            asked.add_header("Authorization", f"token {token}")
            with urllib.request.urlopen(asked, timeout=60) as answer:
                return answer.read()

        wait_for(f"{server}api?token={token}", opened, log)
        try:
            served = json.loads(ask(f"api/contents/{TOUR}"))["content"]
            exercises = json.loads(ask("api/contents/exercises"))["content"]
        finally:
            ask("api/shutdown", method="POST")
        opened.communicate(timeout=60)
    assert opened.returncode == 0
    stored = json.loads(LESSONS[TOUR])["cells"]
    assert [cell["source"] for cell in served["cells"]] == ["".join(c["source"]) for c in stored]
    assert len(exercises) == sum(name.startswith("exercises/") for name in LESSONS)
    folder = clean.home / (arguments[0] if arguments else "kinoedu")
    assert (folder / TOUR).read_bytes() == LESSONS[TOUR]


@pytest.mark.parametrize("command", ["release", "grade submissions --out grades"])
def test_what_needs_solutions_says_that_there_are_none(clean, command):
    """And nothing is written."""
    (clean.home / "submissions").mkdir(exist_ok=True)
    ended = clean.run(*command.split())
    assert ended.returncode == 2 and "Traceback" not in ended.stderr
    assert "has no solutions" in ended.stderr.splitlines()[-1]
    assert not (clean.home / "grades").exists()


# --- a release


def test_all_files_name_the_same_version():
    """The package, the citation and the newest entry of the changelog."""
    citation = yaml.safe_load((HOUSE / "CITATION.cff").read_text(encoding="utf-8"))
    changes = (HOUSE / "CHANGELOG.md").read_text(encoding="utf-8")
    newest = re.search(r"(?m)^## (\S+)", changes)[1]
    assert re.fullmatch(r"\d+\.\d+\.\d+", kinoedu.__version__)
    assert citation["version"] == newest == kinoedu.__version__


def test_the_citation_names_the_authors_of_the_licence():
    """And nobody else; its licence and title are those of the project."""
    citation = yaml.safe_load((HOUSE / "CITATION.cff").read_text(encoding="utf-8"))
    project = tomllib.loads((HOUSE / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    licence = (HOUSE / "LICENSE").read_text(encoding="utf-8")
    (author,) = citation["authors"]
    assert f"Copyright (c) 2026 {author['name']}\n" in licence
    assert project["authors"] == [author]
    assert {"cff-version", "message", "title", "type"} <= citation.keys()
    assert citation["license"] == project["license"] and project["name"] in citation["title"]


def test_publishing_is_bound_to_a_release_and_has_no_password():
    """The workflow builds what is tested, refuses a tag of another version, and lets the index
    know it by its identity.
    """
    text = (HOUSE / ".github" / "workflows" / "publish.yml").read_text(encoding="utf-8")
    workflow = yaml.safe_load(text)
    assert workflow[True] == {"release": {"types": ["published"]}}  # YAML reads `on` as true
    assert workflow["permissions"] == {"contents": "read"}
    build, publish = workflow["jobs"]["build"], workflow["jobs"]["publish"]
    assert "permissions" not in build and publish["permissions"] == {"id-token": "write"}
    assert publish["needs"] == "build" and publish["environment"] == "pypi"
    assert not re.search(r"secrets\.|password", text)
    runs = " ".join(step.get("run", "") for step in build["steps"])
    assert all(part in runs for part in ("start.py test", "hatchling build", "GITHUB_REF_NAME"))
