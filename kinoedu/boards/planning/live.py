"""Which boards a page can answer without Python, and with which settings."""

import inspect
from typing import Any

from ...browser.bodies import PLANNED
from ...browser.grids import GridSettings
from ...planners.grids.grid import grid_for
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

    Bodies plan for a point or a disk among polygons without rooms, and discs.

    Parameters
    ----------
    planner : the planner that is shown.
    settings : the values of the board's controls, by the names of the planners' settings.

    Returns
    -------
    dict
        `body`, the planner; `seed`; and `settings`, for each body the numbers that it takes.
    """
    robot, world = problem.robot, problem.world
    if not isinstance(robot, RoundRobot) or not isinstance(world, PolygonWorldRecord):
        return None
    if planner not in PLANNED or any(len(rings) > 1 for rings in rings_of(world)):
        return None
    numbers = {name: list_settings(problem, name, settings) for name in PLANNED}
    return {"body": planner, "seed": seed, "settings": numbers}


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
