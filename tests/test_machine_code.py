"""What is compiled before a run of all tests."""

import machine_code
import pytest
from machine_code import decode, encode, read_lines, read_requests, request_of

from kinoedu.compiled.tiers import TieredFunction, find_function


def test_every_line_fits():
    """It names a compiled function, as many kinds as that has arguments, and records that exist."""
    assert len(read_lines()) > 20
    for request in map(request_of, read_lines()):
        function = find_function(request.module, request.function)
        assert isinstance(function, TieredFunction), request.name
        assert function.py_func.__code__.co_argcount == len(request.kinds), request.name


def test_a_kind_comes_back_from_json():
    """Numbers, arrays, tuples and records."""
    kinds = {kind for request in read_requests() for kind in request.kinds}
    kinds |= {"f8", (tuple, ("f8", ("i8", 2, "C", True)))}
    assert {decode(encode(kind)) for kind in kinds} == kinds


def test_a_function_that_cannot_be_compiled_ends_the_run(monkeypatch):
    """It is named; without it the tests would interpret the function, and nobody would notice."""
    monkeypatch.setattr(machine_code, "HAS_COMPILER", False)
    monkeypatch.setattr(machine_code, "warm_all", list)
    machine_code.compile_ahead()
    monkeypatch.setattr(machine_code, "warm_all", lambda: ["kinoedu.planners.rrt"])
    with pytest.raises(SystemExit, match=r"no machine code for kinoedu\.planners\.rrt"):
        machine_code.compile_ahead()
