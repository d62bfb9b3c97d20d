"""kinoedu plan: a path in a scene, a map or a picture."""

import argparse
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future, wait
from pathlib import Path
from typing import Any

from ..errors import InvalidParameter
from ..progress import stage

PLAN_HELP = """\
Plan a path in a scene, a map or a picture, and draw it.

SCENE is one of
  .json            a scene: robot, world, start and goal (see kinoedu/scenes.py)
  .map             a MovingAI map; --query K takes start and goal from the .scen beside it
  .png .bmp .pgm   a picture: bright is free, dark is blocked; needs --start and --goal
  .yaml            a ROS map with its picture; needs --start and --goal

PLANNER is one of
  rrt              a tree that grows at random; any scene
  prm              a roadmap of random samples; any scene
  astar            a search on a grid; any scene
  decomposition    cells of the free space; exact, but only for a point among polygons: no map, picture, disc, radius or clearance

x goes right, y goes up, from the lower left corner; a pixel or map cell is one unit long (a ROS map's are in metres).
"""

PLAN_EXAMPLES = """\
examples:
  python start.py plan notebooks/maps/Paris_1_256.map --query 324 --planner prm --seed 3 --out plan.png
  python start.py plan notebooks/maps/maze-128-128-10.map --start 5,5 --goal 120,120 --planner astar
  python start.py plan scene.json --step 0.5
  python start.py plan scene.json --planner decomposition --out plan.svg

exit status: 0 a path was found, 1 there is none (with the reason), 2 the input was wrong
"""

OPTIONS: dict[str, dict[str, str]] = {  # of each planner: on the command line, and in its function
    "rrt": {"step": "step", "nodes": "max_nodes"},
    "prm": {"nodes": "n", "neighbours": "k"},
    "astar": {"spacing": "spacing"},
    "decomposition": {},
}


def add_plan(commands: Any) -> None:
    """The command and its options."""
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
    """The options of `kinoedu plan`."""
    plan.add_argument("scene", metavar="SCENE", type=Path, help="the file to plan in")
    plan.add_argument("--planner", choices=tuple(OPTIONS), default="rrt", help="default: %(default)s")
    plan.add_argument("--seed", type=int, default=0, metavar="N", help="of the random numbers; same seed, same plan (default: 0)")
    plan.add_argument("--out", type=Path, metavar="FILE", help="draw the plan into a picture: .png, .svg or .pdf")
    where = plan.add_argument_group("where")
    where.add_argument("--query", type=int, metavar="K", help="the K-th query, from 0, of a map's scenario (default: 0)")
    where.add_argument("--start", type=numbers, metavar="X,Y", help="where the robot starts")
    where.add_argument("--goal", type=numbers, metavar="X,Y", help="where it is to go")
    where.add_argument("--radius", type=float, metavar="R", help="the robot is a disk of this radius (default: a point)")
    where.add_argument("--clearance", type=float, default=0.0, metavar="C", help="keep this far from obstacles (default: 0)")
    how = plan.add_argument_group("how")
    how.add_argument("--step", type=float, metavar="D", help="rrt: the longest edge (default: a twentieth of the world's diagonal)")
    how.add_argument(
        "--nodes", type=int, metavar="N", help="rrt: give up after so many nodes (10,000); prm: how many to sample (1,000)"
    )
    how.add_argument("--neighbours", type=int, metavar="K", help="prm: how many neighbours each node is tried with (default: 10)")
    how.add_argument(
        "--spacing",
        type=float,
        metavar="D",
        help="astar: the side of the grid's cells (default: the map's own, or a hundredth of the world)",
    )


def numbers(text: str) -> list[float]:
    """Numbers between commas."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"expected X,Y such as 10,20, got {text!r}") from None


def run_plan(arguments: argparse.Namespace) -> int:
    """Read, plan, draw, and say in one line what came out."""
    check_picture(arguments.out, arguments.scene)
    from ..geometry.checks import as_generator  # imported here so that --help is quick
    from ..scenes import read_problem

    as_generator(arguments.seed)
    with stage(f"reading {arguments.scene.name}"):
        problem = read_problem(
            arguments.scene,
            robot=robot_for(arguments.radius),
            start=arguments.start,
            goal=arguments.goal,
            query=arguments.query,
            clearance=arguments.clearance,
        )
    with stage(f"planning with {arguments.planner}") as notes:
        started = time.perf_counter()
        plan = interruptible(lambda: planned(problem, arguments))
        seconds = time.perf_counter() - started
    if arguments.out is not None:
        with stage(f"drawing {arguments.out.name}"):
            from ..figures import save_plan

            save_plan(plan, arguments.out)
    counts = ", ".join(f"{count:,} {name}" for name, count in plan.stats.items())
    answer = f"found: length {plan.cost:.8g}" if plan.path is not None else f"no path: {plan.reason}"
    compiling = " with compiling, once" if notes.last else ""
    print(f"{answer}; {seconds:.3f} s{compiling}, {counts}" + (f"; drawn in {arguments.out}" if arguments.out else ""))
    return 0 if plan.path is not None else 1


def robot_for(radius: float | None) -> Any:
    """A disk of the radius given, or nothing said."""
    from ..robots import Disk

    return None if radius is None else Disk(radius)


def interruptible(work: Callable[[], Any]) -> Any:
    """Do it in another thread, so that Ctrl-C is heard while compiled code runs."""
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


def planned(problem: Any, arguments: argparse.Namespace) -> Any:
    """Ask the planner that was named, with the options that were given; one that it does not have is refused."""
    from ..planners import plan_by_decomposition, plan_on_grid, prm, rrt

    given = {name: getattr(arguments, name) for name in ("step", "nodes", "neighbours", "spacing")}
    given = {name: value for name, value in given.items() if value is not None}
    names = OPTIONS[arguments.planner]
    for name in given:
        if name not in names:
            has = ", ".join(f"--{other}" for other in names) or "no such options"
            raise InvalidParameter(f"--planner {arguments.planner} has no --{name}; it has {has}")
    tuning = {names[name]: value for name, value in given.items()}
    if arguments.planner == "decomposition":
        return plan_by_decomposition(problem)
    if arguments.planner == "astar":
        return plan_on_grid(problem, **tuning)
    return (rrt if arguments.planner == "rrt" else prm)(problem, rng=arguments.seed, **tuning)


def check_picture(path: Path | None, scene: Path) -> None:
    """Refuse a picture that could not be written, before any work is done."""
    if path is None:
        return
    if path.suffix.lower() not in (".png", ".svg", ".pdf"):
        raise OSError(f"--out {path}: a picture ends in .png, .svg or .pdf")
    if path.is_dir() or (path.exists() and scene.exists() and path.samefile(scene)):
        raise OSError(f"--out {path}: is a folder or the scene itself; name another file")
    if not path.absolute().parent.is_dir():
        raise OSError(f"--out {path}: there is no folder {path.absolute().parent}")
