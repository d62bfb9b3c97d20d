"""The one door to numba: the lines a student reads are the lines that run.

Every algorithm has two ways to run. Python interprets it at once; machine code, made by numba from
the same lines, runs some hundred times as fast and gives the same bits. Nobody waits for the
compiler: machine code that lies on the disk is loaded, and otherwise a call is interpreted. What
costs too much that way is compiled by another process, and later calls find its code on the disk.

| file | what it does |
|---|---|
| tiers.py | chooses how a call runs, and adds up what interpreting has cost |
| kinds.py | says of which kinds a call's arguments are: machine code is made for kinds |
| keeper.py | one thread that loads machine code, and ends long interpreted calls when it has come |
| store.py | where machine code lies on the disk, and which is wanted |
| machine.py | loads machine code with numba |
| compiler.py, worker.py | make machine code with numba, in a process of their own |

`compiled` is for kernels, `inlined` for short ones that are handed records, `algorithm` for whole
algorithms that Python starts. `generic` makes a question that each kind of record answers in its
own way; `record` lets compiled code call a record's methods. A *record* is a NamedTuple of arrays,
numbers and records: the one kind of object that Python and machine code share.

Without numba, or under NUMBA_DISABLE_JIT=1, the decorators leave functions as they are.
"""

from .choices import generic, record
from .modes import COMPILED_FIRST, INTERPRETED, WHEN_IT_PAYS, running
from .tiers import (
    HAS_COMPILER,
    Compiled,
    algorithm,
    callable_from_compiled,
    compiled,
    inlined,
)

__all__ = [
    "COMPILED_FIRST",
    "HAS_COMPILER",
    "INTERPRETED",
    "WHEN_IT_PAYS",
    "Compiled",
    "algorithm",
    "callable_from_compiled",
    "compiled",
    "generic",
    "inlined",
    "record",
    "running",
]
