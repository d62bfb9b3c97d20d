"""Public names that check and make records serve as types as well."""

import pickle

import numpy as np
import pytest

import kinoedu as ke
from kinoedu.geometry import ConvexPolygons
from kinoedu.robots import ArmChain
from kinoedu.support.constructors import Constructor

SQUARE = [(0, 0), (9, 0), (9, 9), (0, 9)]
WEDGE = [(0, 0), (1, 0), (0, 1)]
WORLD = ke.PolygonWorld(SQUARE)
MADE = {
    ke.Point: ke.Point(),
    ke.Disk: ke.Disk(0.5),
    ke.TranslatingPolygon: ke.TranslatingPolygon(WEDGE),
    ke.RigidPolygon: ke.RigidPolygon(WEDGE),
    ArmChain: ArmChain([1, 1, 1], 0.1),
    ke.TwoLinkArm: ke.TwoLinkArm(1, 1, 0.1),
    ke.Car: ke.Car(3, 1, 2),
    ke.PolygonWorld: WORLD,
    ke.Terrain: ke.Terrain([[1, 0]]),
    ke.UncertainWorld: ke.UncertainWorld(SQUARE, [((4, 4), 1)], 0.1),
    ke.Moving: ke.Moving(0.5, times=[0, 1], places=[(1, 1), (2, 2)]),
    ke.MovingWorld: ke.MovingWorld(WORLD, []),
    ke.Problem: ke.Problem(ke.Point(), WORLD, (1, 1), (8, 8)),
    ConvexPolygons: ConvexPolygons([WEDGE]),
}


@pytest.mark.parametrize("name", MADE, ids=lambda name: name.__name__)
def test_isinstance_knows_what_a_name_makes_and_nothing_else(name):
    """Also of two names with one record; a two-link arm is a chain as well."""
    also = {(ArmChain, ke.TwoLinkArm)}
    for other, thing in MADE.items():
        assert isinstance(thing, name) == (other is name or (name, other) in also)
    assert not isinstance(None, name)


@pytest.mark.parametrize("thing", MADE.values(), ids=[name.__name__ for name in MADE])
def test_what_is_made_is_the_record_itself(thing):
    """Compiled code knows the record's class alone; a copy by pickle is of that class too."""
    assert not isinstance(type(thing), Constructor)
    assert type(pickle.loads(pickle.dumps(thing))) is type(thing)


def test_a_name_serves_as_an_annotation():
    """In a union, too."""

    def area(world: ke.PolygonWorld | ke.Terrain) -> float:
        return float(np.prod(world.hi - world.lo))

    assert area(WORLD) == 81.0
