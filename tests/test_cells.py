"""How a student's cells are read and run: honest work is not punished, a mistake costs little.

The cells run in a process of their own, which has only Python's standard library and numpy, starts
no thread, and gets the two modules that the sandbox gets.
"""

import ast
import json
import linecache
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinoedu.course.exceptions import MAX_LINE, describe_exception
from kinoedu.grading.collect.left_out import MOST_LISTED, find_left_out
from kinoedu.grading.collect.notebook import Cell, read_cells
from kinoedu.grading.collect.notebook_python import LONGEST, PythonReader, split_lines
from kinoedu.grading.sandbox import cells

HOUSE = Path(__file__).resolve().parent.parent
SANDBOX = Path(cells.__file__).parent
RUNNER = """
import json, sys, _thread
def refuse(*_, **__):
    raise RuntimeError("can't start new thread")
_thread.start_new_thread = _thread.start_joinable_thread = refuse
sys.path[:0] = sys.argv[1:]
import cells, stand_ins
space, compiler = {"__name__": "__main__"}, cells.Compiler()
stand_ins.install(space)
failures = [
    (number, failure.line, type(failure.error).__name__, str(failure.error), failure.names)
    for number, source in json.load(sys.stdin)
    for failure in cells.run_cell(source, f"cell {number}", space, compiler)
]
print(json.dumps([failures, repr(space.get("answer"))]))
"""


def make_notebook(*sources):
    """The bytes of a notebook with these code cells."""
    book = [{"cell_type": "code", "source": source} for source in sources]
    return json.dumps({"nbformat": 4, "cells": book}).encode()


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A function that reads and runs cells; it returns what failed, and the `answer`."""
    folder = tmp_path_factory.mktemp("sandbox")
    for module in ("cells.py", "stand_ins.py"):
        shutil.copy(SANDBOX / module, folder)
    packages = Path(np.__file__).parent.parent
    for part in packages.glob("numpy*"):
        (folder / part.name).symlink_to(part)

    def run_cells(*sources):
        read = [tuple(cell) for cell in read_cells(make_notebook(*sources))]
        command = [sys.executable, "-I", "-S", "-c", RUNNER, str(folder)]
        ran = subprocess.run(
            command, input=json.dumps(read), capture_output=True, text=True, timeout=60
        )
        assert ran.returncode == 0, ran.stderr
        return json.loads(ran.stdout.splitlines()[-1])

    return run_cells


HONEST = {
    "help in the last line": ["answer = 7\nimport numpy as np\nnp.clip?"],
    "help in the middle": ["?print\nlen??\nanswer = 7"],
    "the shell": ["files = !ls\n!pip install x\nanswer = 7 + len(files)"],
    "the shell over lines": ["files = !ls \\\n  -l\nanswer = 7"],
    "a magic with a value": [
        "f = max\nt = %timeit -o f(1, 2)\nround(t.average * 2, 3)\nanswer = 7"
    ],
    "a magic that assigns": ["%time answer = 7"],
    "a magic that returns": ["answer = %time 3 + 4"],
    "a magic with options": ["%prun -l 10 -s cumulative answer = 7"],
    "a magic in a block": ["if True:\n    %time 1\nanswer = 7"],
    "a magic alone in a block": ["answer = 7\nif True:\n    %matplotlib inline"],
    "%%prun": ["%%prun\nanswer = 7"],
    "%%prun with options": ["%%prun -s cumulative\ndef f():\n    return 7\nanswer = f()"],
    "%%time": ["\n%%time\nanswer = 7"],
    "%%timeit": ["%%timeit -n 1\nanswer = 7"],
    "%%capture and %%time": ["%%capture\n%%time\nanswer = 7"],
    "a page of HTML": ["%%html\n<p>", "%%bash\nls 'x", "answer = 7"],
    "prompts": [">>> answer = (3 +\n...     4)"],
    "an indented cell": ["    answer = 3\n    answer += 4"],
    "get_ipython": [
        "get_ipython().run_line_magic('matplotlib', 'inline')\nfrom IPython import get_ipython\n"
        "get_ipython().run_cell_magic('time', '', 'answer = 7')\nget_ipython().system('ls')"
    ],
    "a flag for the future": [
        "from __future__ import annotations",
        "import math\ndef f(x: nothing) -> nothing:\n    return 7",
        "answer = f(0)",
    ],
    "await": [
        "import asyncio\nasync def f():\n    await asyncio.sleep(0)\n    return 7",
        "answer = await f()",
    ],
    "numba": [
        "import numba\nfrom numba import njit, prange, vectorize, float64",
        "@njit\ndef f(x):\n    return x\n@njit(float64(float64[:]), cache=True)\ndef g(n):\n"
        "    return sum(f(i) for i in prange(n))\n@vectorize([float64(float64)])\ndef h(x):\n"
        "    return x if x > 0 else 0\nanswer = int(g(4) + h([1.0, -1.0]).sum())",
        "from numba.typed import List\nList().append(1)\nnumba.jit(nopython=True)(f)(1)",
    ],
    "threads": [
        "from concurrent.futures import ThreadPoolExecutor, as_completed",
        "with ThreadPoolExecutor(2) as pool:\n    answer = sum(pool.map(abs, [-3, -3]))\n"
        "    jobs = [pool.submit(abs, -1)]\nanswer += sum(j.result() for j in as_completed(jobs))",
        "from multiprocessing.pool import ThreadPool\nfrom multiprocessing import Pool",
        "with ThreadPool(2) as pool:\n    assert pool.map(abs, [-1]) == [1]",
        "assert Pool(2).apply_async(abs, (-1,)).get() == 1",
        "import threading\nseen = []\nthread = threading.Thread(target=seen.append, args=(1,))",
        "thread.start()\nthread.join()\nassert seen == [1] and not thread.is_alive()",
    ],
    "pictures": [
        "%matplotlib inline\nimport numpy as np\nimport matplotlib.pyplot as plt\n"
        "from matplotlib.patches import Polygon\nimport ipywidgets\nimport plotly.express as px",
        "fig, ax = plt.subplots(figsize=(3, 3))\nfig, (a, b) = plt.subplots(1, 2)\n"
        "fig, grid = plt.subplots(2, 3)\nassert grid.shape == (2, 3)\nax = fig.subplots()",
        "line, = ax.plot([0, 1], 'r-')\nn, bins, p = plt.hist([1])\nlow, high = ax.get_xlim()",
        "for one in grid.flat:\n    one.add_patch(Polygon([[0, 0]], color=plt.cm.viridis(0.5)))",
        "with plt.style.context('ggplot'):\n    plt.gca().set(xlim=(0, high), title=f'{low:.2f}')",
        "def draw(ax: plt.Axes | None = None):\n    return 7 + float(ax.x) + np.array(ax.y)",
        "plt.rcParams['font.size'] = 3\nassert not (low < high) and range(low) == range(0)",
        "class Mine(ipywidgets.Box):\n    pass\nMine().children[0].on_click(draw)\nfig += 1",
        "@ipywidgets.interact(x=(0, 1))\ndef shown(x):\n    return x\nassert shown(3) == 3",
        "from IPython.display import HTML\ndisplay(HTML('x'))\nplt.show()\nanswer = int(draw(ax))",
    ],
    "progress bars": [
        "from tqdm.notebook import tqdm, trange\nbar = tqdm(total=3)\nbar.update(1)",
        "answer = sum(tqdm([3, 3], desc='x')) + sum(trange(2))",
    ],
}


@pytest.mark.parametrize("sources", HONEST.values(), ids=HONEST)
def test_what_works_in_a_notebook_costs_nothing(run, sources):
    failures, answer = run(*sources)
    assert (failures, answer) == ([], "7")


BROKEN = """\
import math

@staticmethod
def helper(x)
    return x

text = '''one
two
''' + 'x'
def mine(x):
    return 2 * x

class Other:
    def f(self:
        pass
if mine(1) == 2:
    a = 3
else:
    a = 4
numbers = [
    1,
]
open_end = max(1,
def empty():
    if True:
answer = mine(a) + numbers[0]
"""


def test_a_syntax_error_costs_its_own_function(run):
    """Its line is that of the cell, and the names say which questions it concerns."""
    failures, answer = run(BROKEN)
    assert answer == "7"
    assert [(line, kind, names) for _, line, kind, _, names in failures] == [
        (4, "SyntaxError", ["helper"]),
        (14, "SyntaxError", ["Other"]),
        (23, "SyntaxError", ["open_end"]),
        (25, "IndentationError", ["empty"]),
    ]
    assert "'if' statement on line 25" in failures[3][3]
    assert "expected ':'" in failures[0][3] and "(cell 1, line 4)" in failures[0][3]


def test_lines_are_counted_with_commands_and_empty_lines(run):
    """A command over several lines, and empty lines above, move no line."""
    failures, _ = run(
        "\n\n%time max(1, \\\n 2)\nx = !ls \\\n -l\ndef f(x)\n    pass", "\n%%time\n1/0"
    )
    assert [(cell, line) for cell, line, *_ in failures] == [(1, 7), (2, 3)]


def test_a_statement_that_fails_costs_itself(run):
    """Also an exit, and an await of what never comes."""
    failures, answer = run(
        "x = 1 / 0\nanswer = 3\nimport sys\nsys.exit()\nraise SystemExit\nimport nobody",
        "import asyncio\nawait asyncio.sleep(1)\nreturn 3\nanswer += 4",
        "def f():\n    return 1 / 0\n\nf()\nraise KeyboardInterrupt",
    )
    assert answer == "7"
    assert [(cell, line, kind) for cell, line, kind, *_ in failures] == [
        (1, 1, "ZeroDivisionError"),
        (1, 4, "SystemExit"),
        (1, 5, "SystemExit"),
        (1, 6, "ModuleNotFoundError"),
        (2, 2, "RuntimeError"),
        (2, 3, "SyntaxError"),
        (3, 2, "ZeroDivisionError"),
        (3, 5, "KeyboardInterrupt"),
    ]
    assert failures[0][4] == ["x"]


def test_a_time_limit_passes_through():
    """What failed before it is known already."""
    space = {"TimeUp": cells.TimeUp}
    running = cells.run_cell("1 / 0\nraise TimeUp\nx = 1", "cell 1", space, cells.Compiler())
    assert next(running).line == 1
    with pytest.raises(cells.TimeUp):
        next(running)
    assert "x" not in space


def test_an_exception_of_ones_own_costs_its_statement_alone():
    """Also one that is no Exception."""
    space = {}
    source = "class Mine(BaseException): pass\ndef f(): return 1\nraise Mine\nx = f()"
    (failure,) = cells.run_cell(source, "cell 1", space, cells.Compiler())
    assert failure.line == 3
    assert space["x"] == 1


def test_errors_are_as_they_were_raised_with_the_lines_of_the_cell():
    failures = cells.run_cell("\nraise ValueError(3)", "cell 9", {}, cells.Compiler())
    (failure,) = failures
    assert failure.error.args == (3,)
    assert failure.error.__traceback__.tb_next.tb_next.tb_frame.f_code.co_filename == "cell 9"


def test_a_long_line_is_quoted_in_part(monkeypatch):
    """A table on the line that fails would be more than an outcome may hold."""
    source = "f = [" + "0, " * 20_000 + "1 / 0]"
    monkeypatch.setitem(linecache.cache, "cell 9", (len(source), None, [source], "cell 9"))
    (failure,) = cells.run_cell(source, "cell 9", {}, cells.Compiler())
    _, _, lines, _ = describe_exception(failure.error, lambda name: name == "cell 9")
    assert lines == [f"line 1: {source[:MAX_LINE]}"]


def test_a_function_as_handed_out_is_told_from_others_of_any_depth():
    """The longest expressions that Python parses are deeper than its own functions may recurse."""
    text = "def f():\n    'What it returns.'\n    raise {}"
    deep = "+".join(["1"] * 2000)
    for error, is_placeholder in (
        ("NotImplementedError", True),
        ("NotImplementedError('write it')", True),
        ("ValueError('no NotImplementedError')", False),
        (f"ValueError({deep})", False),
        (f"NotImplementedError({deep})", True),
    ):
        assert cells.is_placeholder(ast.parse(text.format(error)).body[0]) == is_placeholder


def test_an_await_that_never_ends_ends(monkeypatch):
    monkeypatch.setattr(cells, "MOST_STEPS", 100)
    source = "import asyncio\nwhile True:\n    await asyncio.sleep(0)"
    (failure,) = cells.run_cell(source, "cell 1", {}, cells.Compiler())
    assert "never happens" in str(failure.error)


def test_real_pictures_are_used_where_they_are_lent():
    """A process that has matplotlib keeps it."""
    program = (
        "import stand_ins\nstand_ins.install({}, has_pictures=True)\n"
        "import matplotlib.pyplot as plt\nassert plt.plot([1])[0].get_xdata()[0] == 0\n"
        "import IPython.display as d\nd.display(d.HTML())"
    )
    subprocess.run([sys.executable, "-c", program], cwd=SANDBOX, check=True)


SPELT = (
    '%time |!|?|??|%%|x| = |\n|\n    |def f(|):|\'|"""|(|]|\\|#|;|if x:|await x|@|{|1|\t|else:|'
    "\0|\r|\x0c|\u2028"
)
PIECES = st.sampled_from(SPELT.split("|"))


@given(source=st.lists(PIECES | st.text(max_size=3), max_size=30).map("".join))
@settings(deadline=None)
def test_any_text_is_read_and_parsed(source):
    """Without an exception, with the same number of lines, and every failure is on one of them."""
    found = PythonReader().read(source)
    for part in cells.parse_cell(found, "cell 1"):
        assert isinstance(part, ast.stmt | cells.Failure)
    if not found.startswith("get_ipython().run_cell_magic"):
        assert len(split_lines(found)) == len(split_lines(source))


@given(source=st.lists(PIECES, max_size=12).map("".join))
@settings(deadline=None)
def test_any_text_runs(source):
    """Without an exception that escapes; no loops or files can be spelt with these pieces."""
    space = {"x": 1, "get_ipython": lambda: None}
    for failure in cells.run_cell(source, "cell 1", space, cells.Compiler()):
        assert failure.line >= 1


@given(source=st.text(max_size=200))
@settings(deadline=None)
def test_valid_python_is_not_changed(source):
    """However it looks to a notebook."""
    text = f"x = {source!r}\ny = '''\n%a\n!b\n?\n'''\nz = (7\n  % 4)\n"
    assert PythonReader().read(text) == text


@pytest.mark.parametrize(
    "book", sorted((HOUSE / "solutions").glob("*.ipynb")), ids=lambda f: f.stem
)
def test_the_courses_own_cells_are_not_changed(book):
    for number, source in read_cells(book.read_bytes()):
        cell = json.loads(book.read_text(encoding="utf-8"))["cells"][number - 1]
        assert source == "".join(cell["source"])


BOMBS = ["(", "\\'", "x?\n", "x(\n"]


@pytest.mark.parametrize("part", BOMBS)
def test_a_bomb_is_read_in_bounded_time(part):
    """And parsed: a megabyte of it, in one cell and in many."""
    began = time.process_time()
    many = [(part * LONGEST)[: LONGEST - 3] + "\nx?"] * 52
    for sources in ([(part * 2**20)[: 2**20 - 1]], many):
        for _, source in read_cells(make_notebook(*sources)):
            assert len(list(cells.parse_cell(source, "cell 1"))) <= 2 + cells.MOST_BROKEN
    assert time.process_time() - began < 60.0  # some 10 seconds where nothing else runs


def test_commands_that_are_left_out_are_listed_with_their_places():
    """As the notebook has them; what is run, and what changes nothing, is not listed."""
    book = make_notebook("%matplotlib inline\nx = 1\n!ls -l", "len?\n%time 1", "%%bash\nls")
    listed = find_left_out(read_cells(book))
    assert [(one.line, one.command) for one in listed] == [
        (3, "!ls -l"),
        (1, "len?"),
        (1, "%%bash"),
    ]
    assert find_left_out([Cell(1, "def f(:\n  get_ipython().system('ls')")]) == []
    many = find_left_out([Cell(1, "get_ipython().system('ls')\n" * 1000)])
    assert len(many) == MOST_LISTED
