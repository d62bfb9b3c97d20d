"""What is compiled before a run of all tests."""

from machine_code import decode, encode, read_requests

from kinoedu.compiled.tiers import TieredFunction, find_function


def test_requests_fit_functions():
    """Every one names a compiled function, and as many kinds as it has arguments."""
    found = read_requests()
    assert len(found) > 20
    for request in found:
        function = find_function(request.module, request.function)
        assert isinstance(function, TieredFunction), request.name
        assert function.py_func.__code__.co_argcount == len(request.kinds), request.name


def test_a_kind_comes_back_from_json():
    """Numbers, arrays, tuples and records."""
    kinds = {kind for request in read_requests() for kind in request.kinds}
    kinds |= {"f8", (tuple, ("f8", ("i8", 2, "C", True)))}
    assert {decode(encode(kind)) for kind in kinds} == kinds
