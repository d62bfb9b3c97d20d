"""A problem with planner, seed and step to choose, and the growth of the plan to scrub."""

import io
from typing import Any

import ipywidgets as widgets
from matplotlib import pyplot as plt

from ..figures import draw_plan
from ..figures.drawing import axes_for
from ..planners import plan_on_grid, prm, rrt
from ..planners.asking import world_size
from ..problems import Plan, ProblemRecord

PLANNERS = {"RRT: a tree that grows at random": "rrt", "PRM: a roadmap of samples": "prm", "A* on a grid": "astar"}
FRAMES = 60  # in which the whole growth is shown


class Explorer(widgets.VBox):
    """Plan on a problem again whenever a control changes; the last slider goes back in the plan's growth.

    Without JavaScript the notebook's figures tell the same story; `explorer.plan` is the plan on show.
    """

    def __init__(self, problem: ProblemRecord, *, planner: str = "rrt", samples: int = 1000) -> None:
        self.problem = problem
        size = world_size(problem)
        wide = widgets.Layout(width="30em")
        style = {"description_width": "6em"}
        self.planner = widgets.Dropdown(options=PLANNERS, value=planner, description="planner", layout=wide, style=style)
        self.seed = widgets.IntSlider(0, 0, 99, description="seed", layout=wide, style=style)
        self.step = widgets.FloatSlider(
            size / 20,
            min=size / 200,
            max=size / 4,
            step=size / 200,
            readout_format=".1f",
            description="step",
            layout=wide,
            style=style,
        )
        self.samples = widgets.IntSlider(samples, 50, 3000, step=50, description="samples", layout=wide, style=style)
        self.growth = widgets.IntSlider(FRAMES, 0, FRAMES, description="growth", readout=False, layout=wide, style=style)
        self.play = widgets.Play(min=0, max=FRAMES, interval=100, description="watch it grow")
        self.state = widgets.HTML()
        self.state.add_class("kinoedu-state")
        self.picture = widgets.Image(format="png", layout=widgets.Layout(width="560px", max_width="100%", height="auto"))
        self.picture.add_class("kinoedu-explorer")
        super().__init__(
            [self.planner, self.seed, self.step, self.samples, widgets.HBox([self.growth, self.play]), self.state, self.picture]
        )
        widgets.jslink((self.play, "value"), (self.growth, "value"))
        for control in (self.planner, self.seed, self.step, self.samples):
            control.observe(self.replan, "value")
        self.growth.observe(self.redraw, "value")
        self.plan: Plan
        self.replan()

    def replan(self, _: Any = None) -> None:
        """Plan with what the controls say, and show the whole plan."""
        self.step.disabled = self.planner.value != "rrt"
        self.samples.disabled = self.planner.value != "prm"
        self.seed.disabled = self.planner.value == "astar"
        if self.planner.value == "rrt":
            self.plan = rrt(self.problem, step=self.step.value, rng=self.seed.value)
        elif self.planner.value == "prm":
            self.plan = prm(self.problem, n=self.samples.value, rng=self.seed.value)
        else:
            self.plan = plan_on_grid(self.problem)
        if self.growth.value == FRAMES:
            self.redraw()
        else:
            self.growth.value = FRAMES  # which redraws

    def redraw(self, _: Any = None) -> None:
        """Show the plan as far as it had grown."""
        built = (
            len(self.plan.roadmap.edges) if self.plan.roadmap is not None else len(self.plan.tree.nodes) if self.plan.tree else 0
        )
        ax = axes_for(self.problem.world)
        draw_plan(self.plan, ax, upto=None if self.growth.value == FRAMES else built * self.growth.value // FRAMES)
        stream = io.BytesIO()
        ax.figure.savefig(stream, format="png", dpi=80)  # type: ignore[union-attr]
        plt.close(ax.figure)  # type: ignore[arg-type]
        self.picture.value = stream.getvalue()
        self.state.value = f"<div role='status' aria-live='polite'><b>{ax.get_title()}</b></div>"

    def __repr__(self) -> str:
        return f"Explorer({self.plan!r})"
