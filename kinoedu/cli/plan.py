"""kinoedu plan: plan a path in a scene, a map or a picture."""

import argparse
import inspect
import os
import re
import threading
import time
from collections.abc import Callable, Iterable
from concurrent.futures import Future, wait
from copy import deepcopy
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from ..errors import InvalidParameter, KinoeduError
from ..planners.registry import PLANNERS
from ..support.progress import show_stage
from .commands import Commands

CHOICES = {planner.name.replace("_", "-"): planner for planner in PLANNERS.values()}
SETTINGS = ("step_size", "nodes", "neighbours", "spacing", "iterations")

PLAN_HELP = f"""\
Plan a path in a scene, a map or a picture, and draw it.

SCENE is one of
  .json            a scene: robot, world, start and goal (see kinoedu/files/scenes.py); or a map
                   of polygons; needs --start and --goal, unless it has both without headings
  .csv             a parking case of TPCAP: a car, its start and goal (see kinoedu/files/tpcap.py)
  .map             a MovingAI map; --query K takes start and goal from the .scen beside it
  .png .bmp .pgm   a picture: bright is free, dark is blocked; needs --start and --goal
  .yaml .yml       a ROS map with its picture; needs --start and --goal
  .stl .obj .dae .glb  a mesh, seen from above; needs --start and --goal

PLANNER is one of
{chr(10).join(f"  {name:<20} {planner.about}" for name, planner in CHOICES.items())}
  mine.py:potential    the function potential of your own file mine.py: f(problem) or
                       f(problem, rng), which returns a path, a Plan or None. The file is run with
                       all your rights on this computer. Its path is checked
  * only among polygons: not in a map or a picture, nor with discs, a radius or a clearance
  ** only among polygons and discs: not in a map or a picture

x points right and y up, from the lower left corner. The side of a pixel or map cell is one unit; a
ROS map is in metres.
"""

PLAN_EXAMPLES = """\
examples:
  python start.py plan notebooks/maps/Paris_1_256.map --query 324 --planner prm --out plan.png
  python start.py plan notebooks/maps/maze-128-128-10.map --start 5,5 --goal 120,120 --planner astar
  python start.py plan scene.json --step-size 0.5 --seed 3 --save plan.json
  python start.py plan scene.json --planner decomposition --out plan.svg
  python start.py plan scene.json --planner mine.py:potential --out plan.png

exit status: 0 a path was found, 1 there is none, or yours is not free (with the reason), 2 the
input was wrong
"""


def add_plan(commands: Commands) -> None:
    """Add the command and its options."""
    plan = commands.add_parser(
        "plan",
        help="plan a path in a scene, a map or a picture, and draw it",
        description=PLAN_HELP,
        epilog=PLAN_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add_plan_options(plan)
    plan.set_defaults(run=run_plan)


def add_plan_options(plan: argparse.ArgumentParser) -> None:
    """Add the options of `kinoedu plan`."""
    plan.add_argument("scene", metavar="SCENE", type=Path, help="the file to plan in")
    plan.add_argument(
        "--planner",
        type=parse_planner,
        metavar="PLANNER",
        default="rrt",
        help="default: %(default)s",
    )
    plan.add_argument(
        "--seed",
        type=int,
        default=0,
        metavar="N",
        help="seed of the random numbers; the same seed gives the same plan (default: 0)",
    )
    plan.add_argument(
        "--out", type=Path, metavar="FILE", help="draw the plan into a picture: .png, .svg or .pdf"
    )
    plan.add_argument(
        "--save",
        type=Path,
        metavar="FILE",
        help="write the plan as .json, or its path as .csv, .yaml (ROS 2) or .path (OMPL.app)",
    )
    add_robot_options(plan.add_argument_group("robot, start and goal"))
    add_planner_options(plan.add_argument_group("parameters of planners"))


def add_robot_options(where: argparse._ArgumentGroup) -> None:
    """Add the options for the robot, its start and its goal."""
    where.add_argument(
        "--query",
        type=int,
        metavar="K",
        help="number of a query, from 0, in the map's scenario (default: 0)",
    )
    where.add_argument("--start", type=parse_numbers, metavar="X,Y", help="where the robot starts")
    where.add_argument("--goal", type=parse_numbers, metavar="X,Y", help="where it must go")
    where.add_argument(
        "--radius",
        type=float,
        metavar="R",
        help="the robot is a disk of this radius (default: a point)",
    )
    where.add_argument(
        "--clearance",
        type=float,
        default=0.0,
        metavar="C",
        help="the distance to keep from obstacles (default: 0)",
    )


def add_planner_options(how: argparse._ArgumentGroup) -> None:
    """Add the options for the planners' parameters."""
    how.add_argument(
        "--step-size",
        type=float,
        metavar="D",
        help="planners of the RRT family: the longest edge (default: a twentieth of the world)",
    )
    how.add_argument(
        "--nodes",
        type=int,
        metavar="N",
        help="planners of the RRT family: stop at this many nodes; prm: sample this many "
        f"configurations (default: {list_defaults('nodes')})",
    )
    how.add_argument(
        "--neighbours",
        type=int,
        metavar="K",
        help=f"how many neighbours to try for each node (default: {list_defaults('neighbours')})",
    )
    how.add_argument(
        "--spacing",
        type=float,
        metavar="D",
        help="the side of a cell (default: astar the map's own, or a hundredth of the world; "
        "hybrid-astar a quarter of the wheelbase, and finer where it is tight)",
    )
    how.add_argument(
        "--iterations",
        type=int,
        metavar="N",
        help="stop after this many iterations "
        f"(default: {list_defaults('iterations', none='ten for each node')})",
    )


def list_defaults(setting: str, none: str = "") -> str:
    """The default of a setting for each planner that has it; `none` in place of None.

    >>> list_defaults("neighbours")
    'prm 10'
    """
    defaults = {
        name: planner.default(setting)
        for name, planner in CHOICES.items()
        if setting in planner.options
    }
    return "; ".join(
        f"{name} {none if value is None else format(value, ',')}"
        for name, value in defaults.items()
    )


def parse_numbers(text: str) -> list[float]:
    """Parse numbers separated by commas."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"expected X,Y such as 10,20, got {text!r}") from None


def parse_planner(text: str) -> str:
    """The name of a planner, or of a function of a reader's own file."""
    from ..support.own_code import names_code

    if text not in CHOICES and not names_code(text):
        raise argparse.ArgumentTypeError(
            f"expected one of {', '.join(CHOICES)}, or file.py:function of your own, got {text!r}"
        )
    return text


def run_plan(arguments: argparse.Namespace) -> int:
    """Read the scene, plan, draw and save, and print the result in one line."""
    check_writable("--out", arguments.out, arguments.scene, "a picture ends in .png, .svg or .pdf")
    check_writable(
        "--save", arguments.save, arguments.scene, "a plan ends in .json, .csv, .yaml or .path"
    )
    from ..files.scenes import read_problem
    from ..geometry.checks import as_generator  # imported here so that --help is quick

    as_generator(arguments.seed)
    with show_stage(f"reading {arguments.scene.name}"):
        problem = read_problem(
            arguments.scene,
            robot=make_robot(arguments.radius),
            start=arguments.start,
            goal=arguments.goal,
            query=arguments.query,
            clearance=arguments.clearance,
        )
    with show_stage(f"planning with {arguments.planner}"):
        started = time.perf_counter()
        plan, faults = run_interruptibly(lambda: make_plan(problem, arguments))
        seconds = time.perf_counter() - started
    if arguments.out is not None:
        with show_stage(f"drawing {arguments.out.name}"):
            from ..figures import save_plan

            save_plan(plan, arguments.out)
    if arguments.save is not None:
        with show_stage(f"writing {arguments.save.name}"):
            from ..files.plans import write_plan

            write_plan(plan, arguments.save)
    counts = [f"{count:,} {name}" for name, count in plan.stats.items()]
    files = "".join(
        f"; {done} in {file}"
        for done, file in (("drawn", arguments.out), ("saved", arguments.save))
        if file
    )
    print(f"{describe(plan, faults)}; {', '.join([f'{seconds:.3f} s', *counts])}{files}")
    return 0 if plan.path is not None and not faults.is_wrong else 1


def describe(plan: Any, faults: Any) -> str:
    """The result in words."""
    if plan.path is None:
        return f"no path: {plan.reason}"
    if faults.is_wrong:
        return f"wrong path: {faults.text}"
    return f"found: length {plan.cost:.8g}" + (f"; {faults.text}" if faults.text else "")


def make_robot(radius: float | None) -> Any:
    """A disk of this radius, or None where no radius was given."""
    from ..robots import Disk

    return None if radius is None else Disk(radius)


def run_interruptibly(work: Callable[[], Any]) -> Any:
    """Run `work` in another thread, so that Ctrl-C works while compiled code runs."""
    answer: Future[Any] = Future()

    def run() -> None:
        try:
            answer.set_result(work())
        except BaseException as error:
            answer.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    while not answer.done():
        wait([answer], timeout=0.1)
    return answer.result()


def make_plan(problem: Any, arguments: argparse.Namespace) -> tuple[Any, Any]:
    """Plan with the planner and the settings of the command line.

    Returns
    -------
    The plan, and what is wrong with it where the planner is a reader's own.

    Raises
    ------
    InvalidParameter
        For a setting that this planner does not have, or where a reader's planner raises an error.
    """
    given = {name: getattr(arguments, name) for name in SETTINGS}
    given = {name: value for name, value in given.items() if value is not None}
    if arguments.planner not in CHOICES:
        return plan_with_own(problem, arguments.planner, arguments.seed, given)
    from ..planners.own import Faults

    planner = CHOICES[arguments.planner]
    check_settings(arguments.planner, given, planner.options)
    return planner.plan(problem, seed=arguments.seed, **given), Faults()


def plan_with_own(problem: Any, name: str, seed: int, settings: dict[str, Any]) -> tuple[Any, Any]:
    """Plan with a function of a reader's own file, and check its path."""
    from ..planners.own import as_plan, call_planner, find_faults
    from ..support.faults import describe_exception
    from ..support.own_code import load_function

    function = load_function(name, Path())
    check_settings(name, settings, inspect.signature(function).parameters)
    asked = deepcopy(problem)  # it cannot change the problem that its path is checked in
    try:
        answer = call_planner(partial(function, **settings), asked, seed)
    except KinoeduError:
        raise
    except (Exception, SystemExit) as error:
        raise InvalidParameter(describe_exception(error, name)) from error
    plan = as_plan(answer, problem)
    stats = plan.stats or {"checks": int(asked.query_counts[0])}
    return replace(plan, stats=stats, planner=plan.planner or name), find_faults(plan, problem)


def check_settings(planner: str, given: Iterable[str], options: Iterable[str]) -> None:
    """Raise InvalidParameter for a setting that a planner does not have."""
    known = [name for name in options if name in SETTINGS]
    for name in given:
        if name not in known:
            has = ", ".join(map(option_of, known)) or "no such options"
            raise InvalidParameter(f"--planner {planner} has no {option_of(name)}; it has {has}")


def option_of(setting: str) -> str:
    """The option of the command line for a setting."""
    return f"--{setting.replace('_', '-')}"


def check_writable(option: str, path: Path | None, scene: Path, endings: str) -> None:
    """Raise OSError for a file that cannot be written, before any work is done.

    `endings` is the message for a wrong file name extension; it names the right ones.
    """
    if path is None:
        return
    if path.suffix.lower() not in re.findall(r"\.\w+", endings):
        raise OSError(f"{option} {path}: {endings}")
    if path.is_dir() or (path.exists() and scene.exists() and path.samefile(scene)):
        raise OSError(f"{option} {path}: is a folder or the scene itself; name another file")
    folder = path.absolute().parent
    if not folder.is_dir():
        raise OSError(f"{option} {path}: there is no folder {folder}")
    if not os.access(folder, os.W_OK):
        raise OSError(f"{option} {path}: nothing can be written in {folder}")
