"""Robots in scenes: how they are read and written. scenes.py describes the whole format."""

import math
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
from ..support.json_fields import Field, JsonObject
from .meshes import mesh_outline


def parse_point(field: Field) -> RoundRobot:
    """A point robot of a scene."""
    field.members(("kind",))
    return Point()


def parse_disk(field: Field) -> RoundRobot:
    """A disk robot of a scene."""
    return Disk(field.members(("kind", "radius"))["radius"].number())


def parse_polygon(field: Field) -> TranslatingPolygonRobot:
    """A polygon that translates, of a scene."""
    return TranslatingPolygon(field.members(("kind", "vertices"))["vertices"].points())


def parse_turning_polygon(field: Field) -> RigidPolygonRobot:
    """A polygon that translates and rotates, of a scene."""
    fields = field.members(("kind", "vertices"), ("turn_weight",))
    weight = fields["turn_weight"].number() if "turn_weight" in fields else None
    return RigidPolygon(fields["vertices"].points(), turn_weight=weight)


def parse_arm(field: Field) -> ArmRobot:
    """An arm of a scene."""
    fields = field.members(("kind", "lengths", "width"), ("base",))
    base = fields["base"].numbers() if "base" in fields else (0.0, 0.0)
    return ArmChain(fields["lengths"].numbers(), fields["width"].number(), base=base)


def read_mesh_file(field: Field) -> RigidPolygonRobot:
    """A polygon that translates and rotates, from a mesh file beside the scene."""
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


def mesh_options(fields: dict[str, Field]) -> JsonObject:
    """The options of `read_mesh` that the scene gives."""
    slicing = {"slice_at": fields["slice_at"].number()} if "slice_at" in fields else {}
    return slicing | ({"up": fields["up"].text()} if "up" in fields else {})


def parse_car(field: Field) -> CarRobot:
    """A car of a scene."""
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
    "point": parse_point,
    "disk": parse_disk,
    "polygon": parse_polygon,
    "turning polygon": parse_turning_polygon,
    "arm": parse_arm,
    "mesh": read_mesh_file,
    "car": parse_car,
}


@singledispatch
def describe_for_scene(thing: object) -> JsonObject:
    """The object of a scene that describes a robot or a world.

    Returns
    -------
    dict of numbers, text and lists, as JSON holds them.

    Raises
    ------
    UnreadableScene
        Where scenes have no such kind of robot or world.
    """
    raise UnreadableScene(f"scenes cannot hold a {type(thing).__name__} yet")


@describe_for_scene.register
def _(robot: RoundRobot) -> JsonObject:
    return {"kind": "disk", "radius": robot.radius} if robot.radius else {"kind": "point"}


@describe_for_scene.register
def _(robot: TranslatingPolygonRobot) -> JsonObject:
    return {"kind": "polygon", "vertices": robot.outline.tolist()}


@describe_for_scene.register
def _(robot: RigidPolygonRobot) -> JsonObject:
    shape = {"vertices": robot.outline.tolist(), "turn_weight": robot.turn_weight}
    return {"kind": "turning polygon", **shape}


@describe_for_scene.register
def _(robot: ArmRobot) -> JsonObject:
    width = 2.0 * float(robot.shape.radius[0])
    shape = {"lengths": robot.lengths.tolist(), "width": width, "base": robot.base.tolist()}
    return {"kind": "arm", **shape}


@describe_for_scene.register
def _(robot: CarRobot) -> JsonObject:
    width, behind = float(np.ptp(robot.outline[:, 1])), -float(robot.outline[0, 0])
    size = {"length": length_of(robot), "width": width}
    axles = {"wheelbase": robot.wheelbase, "rear_overhang": behind}
    limits = {"max_steering": robot.max_steering, "speeds": robot.speeds.tolist()}
    return {"kind": "car", **size, **axles, **limits}


def length_of(robot: CarRobot) -> float:
    """The length from which `Car` gets the same two ends: their sum, or a float beside it."""
    behind, front = -float(robot.outline[0, 0]), float(robot.outline[1, 0])
    rounded = behind + front
    beside = (rounded, math.nextafter(rounded, math.inf), math.nextafter(rounded, 0.0))
    fits = (
        length
        for length in beside
        if length - behind == front and behind <= length - robot.wheelbase
    )
    return next(fits, rounded)
