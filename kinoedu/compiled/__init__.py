"""The only access to numba: functions that run interpreted or as machine code.

Every algorithm can run in two ways, from the same source. Python interprets it at once. Machine
code, made by numba, runs some hundred times as fast and gives bit-identical results. No call waits
for the compiler: machine code on the disk is loaded, and otherwise the call is interpreted. A call
that takes too long to interpret is compiled by another process, and later calls find its machine
code on the disk.

| file | content |
|---|---|
| tiers.py | decides how a call runs, and measures the time of interpreted calls |
| kinds.py | the kinds of a call's arguments, for which machine code is made |
| numba_thread.py | the thread that loads machine code, and interrupts long interpreted calls |
| store.py | the folder of machine code, and the requests for more |
| requests.py | requests machine code, and starts the processes that compile |
| machine.py | loads machine code with numba |
| compiler.py, worker.py | make machine code with numba, in a separate process |
| savings.py | parts of numba, replaced because they took much of the time |
| boxing.py | arguments and results between Python and machine code |
| intermediate.py | compiles functions for other processors, as far as LLVM |
| choices.py | generic functions, methods and properties of records |
| attributes.py | the same methods and properties for numba |
| modes.py | the modes in which calls run |

Decorators: `compiled` is for kernels, `inlined` for short kernels that take records, `algorithm`
for whole algorithms that Python starts. `generic` makes a function with an implementation for each
kind of record, and `record` lets compiled code use a record's methods and properties. A *record* is
a NamedTuple of arrays, numbers and records, the only objects that Python and machine code share.

Without numba, or under NUMBA_DISABLE_JIT=1, the decorators leave functions unchanged.
"""

from .choices import generic, record
from .modes import COMPILED_FIRST, INTERPRETED, WHEN_IT_PAYS, compiled_first, running
from .tiers import (
    HAS_COMPILER,
    Compiled,
    algorithm,
    callable_from_compiled,
    compiled,
    in_python,
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
    "compiled_first",
    "generic",
    "in_python",
    "inlined",
    "record",
    "running",
]
