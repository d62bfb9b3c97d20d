"""Robots in scenes, read and written. What a scene looks like as a whole stands in scenes.py."""

from collections.abc import Callable
from functools import singledispatch
from typing import Any

import numpy as np

from ..errors import UnreadableScene
from ..robots import ArmChain, Car, Disk, Point, RigidPolygon, TranslatingPolygon
from ..robots.arm import ArmRobot
from ..robots.car import CarRobot
from ..robots.polygon import RigidPolygonRobot, TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..support.json_fields import Field
from .meshes import mesh_outline


def point_from(field: Field) -> RoundRobot:
    """A point robot."""
    field.members(("kind",))
    return Point()


def disk_from(field: Field) -> RoundRobot:
    """A disk robot."""
    return Disk(field.members(("kind", "radius"))["radius"].number())


def polygon_from(field: Field) -> TranslatingPolygonRobot:
    """A polygon that does not turn."""
    return TranslatingPolygon(field.members(("kind", "vertices"))["vertices"].points())


def turning_polygon_from(field: Field) -> RigidPolygonRobot:
    """A polygon that turns."""
    fields = field.members(("kind", "vertices"), ("turn_weight",))
    weight = fields["turn_weight"].number() if "turn_weight" in fields else None
    return RigidPolygon(fields["vertices"].points(), turn_weight=weight)


def arm_from(field: Field) -> ArmRobot:
    """An arm."""
    fields = field.members(("kind", "lengths", "width"), ("base",))
    base = fields["base"].numbers() if "base" in fields else (0.0, 0.0)
    return ArmChain(fields["lengths"].numbers(), fields["width"].number(), base=base)


def mesh_from(field: Field) -> RigidPolygonRobot:
    """A polygon that turns, from a mesh beside the scene."""
    fields = field.members(("kind", "file"), (*MESH_OPTIONS, "reference", "turn_weight"))
    outline = mesh_outline(
        field.folder / fields["file"].text(),
        reference=fields["reference"].numbers() if "reference" in fields else (0.0, 0.0),
        **mesh_options(fields),
    )
    return RigidPolygon(
        outline, turn_weight=fields["turn_weight"].number() if "turn_weight" in fields else None
    )


MESH_OPTIONS = ("slice_at", "up")


def mesh_options(fields: dict[str, Field]) -> dict[str, Any]:
    """How a mesh becomes polygons, as far as the scene says it."""
    slicing = {"slice_at": fields["slice_at"].number()} if "slice_at" in fields else {}
    return slicing | ({"up": fields["up"].text()} if "up" in fields else {})


def car_from(field: Field) -> CarRobot:
    """A car."""
    fields = field.members(
        ("kind", "length", "width", "wheelbase"), ("rear_overhang", "max_steering", "speeds")
    )
    length, width, wheelbase = (fields[name].number() for name in ("length", "width", "wheelbase"))
    more = {
        name: fields[name].number() for name in ("rear_overhang", "max_steering") if name in fields
    }
    speeds = fields["speeds"].numbers() if "speeds" in fields else (-1.0, 1.0)
    return Car(length, width, wheelbase, speeds=speeds, **more)


ROBOTS: dict[str, Callable[[Field], Any]] = {
    "point": point_from,
    "disk": disk_from,
    "polygon": polygon_from,
    "turning polygon": turning_polygon_from,
    "arm": arm_from,
    "mesh": mesh_from,
    "car": car_from,
}


@singledispatch
def described(thing: Any) -> dict[str, Any]:
    """A robot or a world as a scene's object."""
    raise UnreadableScene(f"scenes cannot hold a {type(thing).__name__} yet")


@described.register
def _(robot: RoundRobot) -> dict[str, Any]:
    return {"kind": "disk", "radius": robot.radius} if robot.radius else {"kind": "point"}


@described.register
def _(robot: TranslatingPolygonRobot) -> dict[str, Any]:
    return {"kind": "polygon", "vertices": robot.outline.tolist()}


@described.register
def _(robot: RigidPolygonRobot) -> dict[str, Any]:
    return {
        "kind": "turning polygon",
        "vertices": robot.outline.tolist(),
        "turn_weight": robot.turn_weight,
    }


@described.register
def _(robot: ArmRobot) -> dict[str, Any]:
    width = 2.0 * float(robot.shape.radius[0])
    return {
        "kind": "arm",
        "lengths": robot.lengths.tolist(),
        "width": width,
        "base": robot.base.tolist(),
    }


@described.register
def _(robot: CarRobot) -> dict[str, Any]:
    (length, width), behind = np.ptp(robot.outline, axis=0).tolist(), -float(robot.outline[0, 0])
    sizes = {
        "length": length,
        "width": width,
        "wheelbase": robot.wheelbase,
        "rear_overhang": behind,
    }
    return {
        "kind": "car",
        **sizes,
        "max_steering": robot.max_steering,
        "speeds": robot.speeds.tolist(),
    }
