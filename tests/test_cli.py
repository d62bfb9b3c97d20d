"""The command line, run as a user runs it."""

import errno
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from children import started
from PIL import Image

import kinoedu as ke
from kinoedu.cli import main
from kinoedu.compiled import store
from kinoedu.support.whole_files import written_whole

GRID = Path(__file__).parent / "data" / "grid"
MAZE = str(GRID / "maze-32-32-2.map")


@pytest.mark.parametrize("planner", ["rrt", "prm", "astar"])
def test_plan_says_what_it_found_and_draws_it(planner, tmp_path, capsys):
    """One line on standard output, exit status 0, a picture large enough to look at and nothing
    beside it.
    """
    picture = tmp_path / "plan.png"
    assert (
        main(
            [
                "plan",
                MAZE,
                "--planner",
                planner,
                "--seed",
                "1",
                "--out",
                str(picture),
                *(["--nodes", "4000"] if planner == "prm" else []),
            ]
        )
        == 0
    )
    out, err = capsys.readouterr()
    assert out.startswith("found: length ")
    assert out.count("\n") == 1
    assert "checks" in out
    assert "planning" in err
    with Image.open(picture) as image:
        assert min(image.size) > 600
    assert [p.name for p in tmp_path.iterdir()] == ["plan.png"]


def test_astar_length_is_the_scenarios(capsys):
    """The line carries the optimal length of the query."""
    assert main(["plan", MAZE, "--planner", "astar", "--query", "0"]) == 0
    assert "length 13.828427" in capsys.readouterr().out


def test_a_polygon_scene_is_planned_by_decomposition(tmp_path, capsys):
    """A path, or the proof that there is none; a scene that is no point among polygons is refused
    with what is needed.
    """
    world = ke.PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    problem = ke.Problem(ke.Point(), world, (1, 1), (8, 1))
    ke.write_scene(problem, tmp_path / "wall.json")
    scene = ["plan", str(tmp_path / "wall.json"), "--planner", "decomposition"]
    assert main([*scene, "--out", str(tmp_path / "plan.png")]) == 0
    assert f"length {ke.plan_by_decomposition(problem).cost:.8g}" in capsys.readouterr().out
    assert (tmp_path / "plan.png").stat().st_size > 1000
    shut = ke.PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 6), (3, 6)]])
    ke.write_scene(ke.Problem(ke.Point(), shut, (1, 1), (8, 1)), tmp_path / "shut.json")
    assert main(["plan", str(tmp_path / "shut.json"), "--planner", "decomposition"]) == 1
    assert "there is no path" in capsys.readouterr().out
    ke.write_scene(ke.Problem(ke.Disk(0.2), world, (1, 1), (8, 1)), tmp_path / "disk.json")
    disk = ["plan", str(tmp_path / "disk.json"), "--planner", "decomposition"]
    for wrong in ([*scene, "--step-size", "1"], disk, ["plan", MAZE, "--planner", "decomposition"]):
        assert main(wrong) == 2
        assert "decomposition" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["rrt-connect", "rrt-star", "visibility"])
def test_every_planner_has_its_name(name, tmp_path, capsys):
    """What the command line plans is what the function plans."""
    world = ke.PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    problem = ke.Problem(ke.Point(), world, (1, 1), (8, 1))
    ke.write_scene(problem, tmp_path / "wall.json")
    seeded = name != "visibility"
    options = ["--nodes", "300", "--seed", "2"] if seeded else []
    assert main(["plan", str(tmp_path / "wall.json"), "--planner", name, *options]) == 0
    function = {
        "rrt-connect": ke.rrt_connect,
        "rrt-star": ke.rrt_star,
        "visibility": ke.plan_by_visibility,
    }[name]
    plan = function(problem, **({"max_nodes": 300, "rng": 2} if seeded else {}))
    assert f"length {plan.cost:.8g}" in capsys.readouterr().out


@pytest.mark.parametrize("name", ["kinodynamic-rrt", "sst", "hybrid-astar"])
def test_a_car_is_driven(name, tmp_path, capsys):
    """What the command line drives is what the function drives; a robot that is no car is
    refused.
    """
    yard = ke.PolygonWorld(
        [(0, 0), (20, 0), (20, 20), (0, 20)], [[(9, 0), (11, 0), (11, 10), (9, 10)]]
    )
    problem = ke.Problem(ke.Car(3, 1, 2), yard, (4, 4, 0), (16, 4, 0))
    ke.write_scene(problem, tmp_path / "yard.json")
    tuning, options = (
        ({}, [])
        if name == "hybrid-astar"
        else ({"max_iterations": 300, "rng": 2}, ["--iterations", "300"])
    )
    plan = {"kinodynamic-rrt": ke.kinodynamic_rrt, "sst": ke.sst, "hybrid-astar": ke.hybrid_astar}[
        name
    ](problem, **tuning)
    drive = [
        "plan",
        str(tmp_path / "yard.json"),
        "--planner",
        name,
        "--seed",
        "2",
        *options,
        "--out",
        str(tmp_path / "plan.png"),
    ]
    assert main(drive) == (plan.path is None)
    out = capsys.readouterr().out
    assert (f"length {plan.cost:.8g}" if plan.path is not None else plan.reason) in out
    assert f"{plan.stats['nodes']:,} nodes" in out
    assert (tmp_path / "plan.png").stat().st_size > 1000
    assert main(["plan", MAZE, "--planner", name]) == 2
    assert "Car(" in capsys.readouterr().err


def test_no_path_is_status_1_with_its_reason(tmp_path, capsys):
    """A closed room is an answer, and its picture is drawn."""
    ring = [(3, 3), (6, 3), (6, 6), (3, 6)]
    world = ke.PolygonWorld(
        [(0, 0), (9, 0), (9, 9), (0, 9)], [(ring, [[(4, 4), (5, 4), (5, 5), (4, 5)]])]
    )
    ke.write_scene(ke.Problem(ke.Point(), world, (1, 1), (4.5, 4.5)), tmp_path / "room.json")
    assert (
        main(
            [
                "plan",
                str(tmp_path / "room.json"),
                "--nodes",
                "50",
                "--out",
                str(tmp_path / "room.svg"),
            ]
        )
        == 1
    )
    assert capsys.readouterr().out.startswith("no path: ")
    assert "<svg" in (tmp_path / "room.svg").read_text(encoding="utf-8")


def test_a_picture_is_planned_on(tmp_path, capsys):
    """Black is blocked; x goes right and y goes up."""
    image = Image.new("L", (60, 40), 255)
    image.paste(0, (20, 0, 30, 30))
    image.save(tmp_path / "terrain.png")
    arguments = [
        "plan",
        str(tmp_path / "terrain.png"),
        "--start",
        "5,35",
        "--goal",
        "55,35",
        "--planner",
        "astar",
    ]
    assert main(arguments) == 0
    assert "found" in capsys.readouterr().out
    assert main([*arguments, "--radius", "4.9"]) == 1
    assert main([*arguments[:2], "--start", "25,20", "--goal", "55,35"]) == 2
    assert "not free" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--out", "--save"])
def test_a_folder_that_is_closed_is_named_before_anything_is_planned(option, capsys, monkeypatch):
    """So that no long plan is lost."""
    monkeypatch.setattr(os, "access", lambda *_: False)
    ending = "png" if option == "--out" else "json"
    assert main(["plan", MAZE, option, f"plan.{ending}"]) == 2
    shown = capsys.readouterr().err
    assert f"{option} plan.{ending}: nothing can be written in {Path.cwd()}" in shown
    assert "planning" not in shown


@pytest.mark.parametrize(
    "arguments",
    [
        ["plan", "missing.map"],
        ["plan", "missing.json"],
        ["plan", "unknown.xyz"],
        ["plan", "."],
        ["plan", MAZE, "--query", "9999"],
        ["plan", MAZE, "--query", "-1"],
        ["plan", MAZE, "--start", "0.5,0.5"],
        ["plan", MAZE, "--seed", "-1"],
        ["plan", MAZE, "--step-size", "nan"],
        ["plan", MAZE, "--step-size", "0"],
        ["plan", MAZE, "--step", "0"],  # an abbreviation
        ["plan", MAZE, "--radius", "-1"],
        ["plan", MAZE, "--radius", "100"],
        ["plan", MAZE, "--clearance", "-1"],
        ["plan", MAZE, "--nodes", "0"],
        ["plan", MAZE, "--planner", "prm", "--neighbours", "0"],
        ["plan", MAZE, "--planner", "astar", "--spacing", "0"],
        ["plan", MAZE, "--start", "1e200,1", "--goal", "2,2"],
        ["plan", MAZE, "--out", "plan.gif"],
        ["plan", MAZE, "--spacing", "1"],
        ["plan", MAZE, "--planner", "prm", "--step-size", "1"],
        ["plan", MAZE, "--start", "-9,-9", "--goal", "-1e3,2"],
        ["plan", MAZE, "--out", "no/such/folder/plan.png"],
    ],
    ids=lambda a: " ".join(a[2:] or a[1:]),
)
def test_bad_input_is_status_2_and_one_line(arguments, capsys, tmp_path, monkeypatch):
    """No traceback, nothing on standard output, nothing written."""
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    complaints = [line for line in err.splitlines() if not line.endswith(" ...")]
    assert len(complaints) == 1
    assert complaints[0].startswith("kinoedu: ")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "arguments",
    [[], ["fly"], ["plan"], ["plan", MAZE, "--start", "1;2"], ["plan", MAZE, "--planner", "bug9"]],
)
def test_wrong_usage_is_status_2(arguments, capsys):
    """argparse's own refusals."""
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    assert "--help" in err


def test_a_picture_never_overwrites_its_scene(tmp_path, capsys):
    """Nor a folder; the scene is as it was."""
    Image.new("L", (40, 40), 255).save(tmp_path / "map.png")
    before = (tmp_path / "map.png").read_bytes()
    for out in ("map.png", "sub/../map.png"):
        (tmp_path / "sub").mkdir(exist_ok=True)
        assert (
            main(
                [
                    "plan",
                    str(tmp_path / "map.png"),
                    "--start",
                    "5,5",
                    "--goal",
                    "9,9",
                    "--out",
                    str(tmp_path / out),
                ]
            )
            == 2
        )
    (tmp_path / "folder.png").mkdir()
    assert main(["plan", MAZE, "--out", str(tmp_path / "folder.png")]) == 2
    assert (tmp_path / "map.png").read_bytes() == before
    assert capsys.readouterr().out == ""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to one process")
def test_ctrl_c_is_heard_while_planning(tmp_path):
    """Status 130 and no traceback, long before a hopeless search of millions of nodes would end."""
    ring = [(3, 3), (6, 3), (6, 6), (3, 6)]
    world = ke.PolygonWorld(
        [(0, 0), (9, 0), (9, 9), (0, 9)], [(ring, [[(4, 4), (5, 4), (5, 5), (4, 5)]])]
    )
    ke.write_scene(ke.Problem(ke.Point(), world, (1, 1), (4.5, 4.5)), tmp_path / "room.json")
    command = [
        sys.executable,
        "-m",
        "kinoedu",
        "plan",
        str(tmp_path / "room.json"),
        "--nodes",
        "10000000",
    ]
    with started(command, stderr=subprocess.PIPE) as run:
        heard = ""
        while "planning" not in heard:
            heard += run.stderr.readline()
        run.send_signal(signal.SIGINT)
        rest = run.communicate(timeout=120)[1]
    assert run.returncode == 130
    assert "Traceback" not in rest


def test_help_tells_formats_and_examples(capsys):
    """--help names every format and shows commands to copy."""
    with pytest.raises(SystemExit) as caught:
        main(["plan", "--help"])
    assert caught.value.code == 0
    text = capsys.readouterr().out
    assert all(
        word in text for word in (".json", ".map", ".png", ".yaml", "examples:", "exit status")
    )


def test_the_version_is_the_packages(capsys):
    """For a report of a mistake."""
    with pytest.raises(SystemExit) as ended:
        main(["--version"])
    assert ended.value.code == 0
    assert capsys.readouterr().out == f"kinoedu {ke.__version__}\n"


def test_same_seed_same_line(capsys):
    """But for the time, two runs print the same."""
    lines = []
    for _ in range(2):
        main(["plan", MAZE, "--seed", "7"])
        lines.append(capsys.readouterr().out.split("; ")[0])
    assert lines[0] == lines[1]


def test_as_a_module_from_another_folder(tmp_path):
    """python -m kinoedu passes its exit status on."""
    run = subprocess.run(
        [sys.executable, "-m", "kinoedu", "plan", "none.map"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 2
    assert "Traceback" not in run.stderr


def test_warm_names_what_could_not_be_compiled(monkeypatch, capsys):
    """An algorithm that numba no longer takes would only be slow, and nobody would notice."""
    monkeypatch.setattr("kinoedu.warm.warm_up", lambda: ["kinoedu.planners.trees.rrt.grow"])
    assert main(["warm"]) == 1
    assert "rrt.grow could not be compiled" in capsys.readouterr().err


def test_warm_says_that_nothing_can_be_stored(monkeypatch, capsys, tmp_path):
    """As where an administrator misspells the folder, or the disk is read-only."""
    (tmp_path / "file").touch()
    monkeypatch.setenv("KINOEDU_CACHE", str(tmp_path / "file" / "cache"))
    store.folder.cache_clear()
    try:
        assert main(["warm"]) == 1
    finally:
        store.folder.cache_clear()
    assert "KINOEDU_CACHE" in capsys.readouterr().err


def test_a_planner_that_ends_python_is_an_error(tmp_path, capsys):
    """Not the end of the command, with the planner's status."""
    own = tmp_path / "own.py"
    own.write_text("def leaves(problem):\n    raise SystemExit(0)\n")
    assert main(["plan", MAZE, "--planner", f"{own}:leaves"]) == 2
    assert "SystemExit" in capsys.readouterr().err


def test_a_wrong_letter_of_a_variant_is_an_error_before_any_release(tmp_path, capsys):
    """It was noticed when all notebooks had been run."""
    assert main(["release", "--zip", str(tmp_path / "kit.zip"), "--variant", "Q9"]) == 2
    said = capsys.readouterr()
    assert "--variant is one of the letters A, B" in said.err
    assert "made exercises" not in said.out


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--out", "X"], "--out is for --variants and --variant"),
        (["--out", "X", "--zip", "X.zip", "--variant", "B"], "one of them at a time"),
        (["--out", "X", "--zip", "X.zip", "--variants", "S"], "one of them at a time"),
        (["--graded-questions", "01_geometry"], "--graded-questions is for --zip"),
        (["--graded-questions", "01", "--zip", "X.zip"], "there are no questions for '01'"),
        (["--secret", "S"], "--secret is for --variants"),
        (["--out", "X", "--variants", "S"], "save it as UTF-8"),
    ],
)
def test_what_a_release_would_ignore_is_refused_at_once(tmp_path, options, words, capsys):
    """Nothing is released, and no option is silently without effect."""
    (tmp_path / "S").write_bytes(b"J\xfcrgen\n")
    given = [str(tmp_path / one) if one[0] in "XS" else one for one in options]
    assert main(["release", "01_geometry", *given]) == 2
    said = capsys.readouterr()
    assert words in said.err and "made exercises" not in said.out
    assert [one.name for one in tmp_path.iterdir()] == ["S"]


def test_a_folder_that_is_missing_is_named_at_once(tmp_path, capsys):
    """Not a temporary file in it, and before any work is done."""
    there = tmp_path / "no" / "kit.zip"
    assert main(["release", "--zip", str(there)]) == 2
    assert str(there.parent) in capsys.readouterr().err
    with pytest.raises(FileNotFoundError) as error, written_whole(there):
        pass
    assert error.value.filename == str(there)
    (tmp_path / "folder").mkdir()
    with pytest.raises(IsADirectoryError) as error, written_whole(tmp_path / "folder"):
        pass
    assert error.value.filename == str(tmp_path / "folder") and error.value.filename2 is None
    with (
        pytest.raises(OSError, match=r"No space left.*kit\.zip"),
        written_whole(tmp_path / "kit.zip"),
    ):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    assert not list(tmp_path.glob("*.part"))


def test_what_is_handed_in_is_a_notebook_that_is_there(tmp_path, capsys):
    """A folder, and a name with a slip in it, are named in the message."""
    for wrong in (tmp_path, tmp_path / "01_geometri.ipynb"):
        assert main(["hand-in", str(wrong)]) == 2
        assert f"{wrong}: there is no such notebook" in capsys.readouterr().err


def test_a_place_that_cannot_be_written_is_named_without_a_number(tmp_path, capsys):
    """As `ls` would say it: the file, and what the system says of it."""
    (tmp_path / "file").write_text("mine")
    assert main(["lessons", str(tmp_path / "file" / "lessons")]) == 2
    message = capsys.readouterr().err
    assert message.startswith(f"kinoedu: {tmp_path / 'file'}") and "Errno" not in message


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (["slides", "01_geometry", "--out", "file"], "file: File exists; where a folder is needed"),
        (["lessons", "file"], "Not a directory; where a folder is needed there is a file"),
        (
            ["questions", "--to", "moodle", "--out", "no/q.xml"],
            "no/q.xml: No such file or directory",
        ),
        (["questions", "--to", "moodle", "--out", "no/q.xml"], "make its folder first"),
    ],
)
def test_what_the_system_refuses_is_said_with_what_to_do(
    tmp_path, monkeypatch, command, words, capsys
):
    """In one line, without the system's number of the error."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    assert main(command) == 2
    said = capsys.readouterr().err
    assert words in said and "Errno" not in said and "kinoedu: " in said


def test_a_list_of_students_in_another_encoding_is_refused(tmp_path, capsys):
    """Spreadsheets of Windows write them; the message says what to do."""
    (tmp_path / "students.txt").write_bytes("Müller\n".encode("latin-1"))
    options = ["--variants", str(tmp_path / "students.txt"), "--out", str(tmp_path / "out")]
    assert main(["release", "02_bug_algorithms", *options]) == 2
    assert "save it as UTF-8" in capsys.readouterr().err


def test_a_notebook_is_not_overwritten_by_its_zip(tmp_path, capsys):
    """A slip in --out must not cost a student's answers."""
    mine = tmp_path / "01_geometry.ipynb"
    released = Path(__file__).parent.parent / "exercises" / mine.name
    mine.write_bytes(released.read_bytes())
    assert main(["hand-in", str(mine), "--out", str(mine)]) == 2
    assert "ends in .zip" in capsys.readouterr().err
    assert mine.read_bytes() == released.read_bytes()


def test_a_file_may_have_the_longest_name(tmp_path):
    """The temporary file beside it has a shorter one."""
    file = tmp_path / ("x" * 251 + ".csv")
    with written_whole(file) as part:
        part.write_text("whole")
    assert [one.name for one in tmp_path.iterdir()] == [file.name]
