"""Paths for other programs: nav_msgs/Path of ROS 2 as YAML, and the .path of OMPL.app."""

from __future__ import annotations

import math
import re
from pathlib import Path

from ..errors import InvalidParameter
from ..problems import Plan
from ..support.text import shortened
from .path_poses import poses_along

FRAME = "map"
NAME = re.compile(r"[A-Za-z_/][A-Za-z0-9_/]*")


def ros_path_text(plan: Plan, *, frame: str = FRAME, spacing: float | None = None) -> str:
    """A plan's path as the YAML of a nav_msgs/msg/Path, without poses where there is no path.

    `ros2 topic pub /plan nav_msgs/msg/Path "$(cat plan.yaml)"` publishes it. Lengths are metres.

    Parameters
    ----------
    frame : the frame in which the coordinates are, such as that of the map.
    spacing : as of `poses_along`.

    Raises
    ------
    InvalidParameter
        Where it is no plan, the robot is an arm, or the frame has no name.
    """
    if not isinstance(frame, str) or not NAME.fullmatch(frame):
        raise InvalidParameter(f"frame must be a name such as 'map', got {shortened(frame)}")
    header = f"{{stamp: {{sec: 0, nanosec: 0}}, frame_id: {frame}}}"
    poses = pose_rows(plan, spacing)
    lines = [f"header: {header}", "poses:" if poses else "poses: []"]
    for x, y, theta in poses:
        z, w = math.sin(theta / 2.0), math.cos(theta / 2.0)
        lines += [
            f"- header: {header}",
            "  pose:",
            f"    position: {{x: {number(x)}, y: {number(y)}, z: 0.0}}",
            f"    orientation: {{x: 0.0, y: 0.0, z: {number(z)}, w: {number(w)}}}",
        ]
    return "\n".join([*lines, ""])


def pose_rows(plan: Plan, spacing: float | None = None) -> list[list[float]]:
    """The poses of a plan, none where it has no path."""
    no_path = isinstance(plan, Plan) and plan.path is None
    return [] if no_path else list(poses_along(plan, spacing).tolist())


def number(value: float) -> str:
    """A number as every YAML reads it: 1e-17 without a point is text for some."""
    text = repr(float(value))
    return text.replace("e", ".0e") if "e" in text and "." not in text else text


def write_ros_path(plan: Plan, file: Path) -> None:
    """Write a path as YAML for ROS 2."""
    file.write_text(ros_path_text(plan), encoding="utf-8")


def write_ompl_path(plan: Plan, file: Path) -> None:
    """Write a path as OMPL.app does: x, y and theta of a pose on each line."""
    rows = pose_rows(plan)
    file.write_text("".join(f"{x!r} {y!r} {theta!r}\n" for x, y, theta in rows), encoding="utf-8")
