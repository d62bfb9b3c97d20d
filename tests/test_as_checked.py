"""Functions as their checks saw them: what is found, and at what cost."""

import time

import pytest

from kinoedu.grading.collect.notebook import Cell
from kinoedu.grading.judge.as_checked import find_cells_as_checked


def test_cells_as_checked_are_found_without_compiling():
    """Python compiles what is in `finally` twice: in eighteen of them 250,000 times."""
    nested = "".join(f"{' ' * deep}try: pass\n{' ' * deep}finally:\n" for deep in range(1, 19))
    function = f"def f():\n{nested}{' ' * 19}return d({'a, ' * 50})\n"
    cells = [Cell(at, text) for at, text in enumerate([function, "check(f)", "d = 1"], 1)]
    start = time.process_time()
    assert find_cells_as_checked(["f"], cells) == {"f": cells[:2]}
    assert time.process_time() - start < 1.0


@pytest.mark.parametrize(
    ("above", "below", "is_found"),
    [
        ("def f(x):\n    return d(x)", "d = 1", True),
        ("def f(x):\n    return [d(x) for d in x]", "d = 1", False),
        ("def f(d):\n    return d", "d = 1", False),
        ("def f(x):\n    return d(min(x, key=lambda d: d[0]))", "d = 1", True),
        ("class C:\n    def f(self):\n        return d\nf = C().f", "import a as d", True),
        ("f = lambda x: d.e(x)", "e = 1", False),
        ("def f(x):\n    return d", "def f(:\nd = 2", True),
        ("def f(x):\n    return d", "def d():\n    raise NotImplementedError", False),
        ("d = 1\ndef f(x):\n    return x", "d = 2", False),
        ("def g(x):\n    return d", "d = 1\ndef f(x):\n    return d", False),
    ],
)
def test_a_cell_below_changes_what_functions_use(above, below, is_found):
    """A name that is the function's own, or that of an attribute, is another one."""
    cells = [Cell(1, above), Cell(2, "check( f )"), Cell(3, below)]
    assert ("f" in find_cells_as_checked(["f"], cells)) == is_found
