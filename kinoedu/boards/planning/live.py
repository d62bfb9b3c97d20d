"""Which boards a page can answer without Python, and with which settings."""

import inspect
from typing import Any

from ...browser.bodies import PLANNED
from ...browser.grids import GridSettings
from ...planners.grids.grid import Cells, grid_for
from ...planners.problem_input import as_step_size
from ...planners.registry import PLANNERS
from ...planners.trees.rrt_star import sufficient_gamma
from ...planners.tuning import iteration_limit
from ...problems import ProblemRecord
from ...robots.round import RoundRobot
from ...support.json_fields import JsonObject
from ...worlds.polygon_world import PolygonWorldRecord, rings_of


def describe_live(
    problem: ProblemRecord, planner: str, seed: int, settings: dict[str, Any]
) -> JsonObject | None:
    """What a page needs to answer a board itself; None where it cannot.

    Bodies plan for a point or a disk, among polygons without rooms and discs or on a bitmap.

    Parameters
    ----------
    planner : the planner that is shown.
    settings : the values of the board's controls, by the names of the planners' settings.

    Returns
    -------
    dict
        `body`, the planner; `seed`; and `settings`, for each body the numbers that it takes.
    """
    names = answered_names(problem)
    if planner not in names:
        return None
    numbers = {body: list_settings(problem, name, settings) for name, body in names.items()}
    return {"body": names[planner], "seed": seed, "settings": numbers}


def answered_names(problem: ProblemRecord) -> dict[str, str]:
    """The planners that a page can answer with, each with the name of its body."""
    robot, world = problem.robot, problem.world
    if not isinstance(robot, RoundRobot):
        return {}
    if isinstance(world, PolygonWorldRecord):
        has_rooms = any(len(rings) > 1 for rings in rings_of(world))
        return {} if has_rooms else {name: name for name in PLANNED}
    # a page knows the box of a terrain and its cells, from which the side of a cell must follow
    side = (world.hi[0] - world.lo[0]) / world.free.shape[1]
    if world.cost.size > 0 or side != world.resolution:
        return {}
    names = {name: f"terrain_{name}" for name in PLANNED}
    if isinstance(grid_for(problem, None).moves, Cells):
        names["astar"] = "terrain_cells"
    return names


def list_settings(problem: ProblemRecord, name: str, settings: dict[str, Any]) -> list[float]:
    """The numbers that a planner's body takes; the planner's defaults where no control has one."""
    planner = PLANNERS[name]
    values = {name: p.default for name, p in inspect.signature(planner.function).parameters.items()}
    for setting in ("step_size",) if planner.board is None else planner.board:
        values[planner.options[setting]] = settings[setting]
    values["clearance"] = problem.clearance
    if "step_size" in values:
        values["step_size"] = as_step_size(problem, values["step_size"], "step_size")
        values["max_iterations"] = iteration_limit(values["max_iterations"], values["max_nodes"])
    if PLANNED[name].settings is GridSettings:
        grid = grid_for(problem, values["spacing"])
        values |= {"spacing": grid.side, "columns": grid.columns, "rows": grid.rows}
    if "gamma" in values:
        values["gamma"] = sufficient_gamma(problem)
    return [float(values[setting]) for setting in PLANNED[name].settings._fields]
