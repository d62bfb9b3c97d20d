"""C code as a ruler: compiled here and now for this processor, called through ctypes on kinoedu's
own arrays.
"""

import ctypes
import shutil
import subprocess
import tempfile
from ctypes import POINTER, c_double, c_int64
from pathlib import Path

import numpy as np
from timing import Missing

from kinoedu.problems import ProblemRecord
from kinoedu.spaces.buckets import GrowingTree

FLAGS = [
    "-O3",
    "-march=native",
    "-ffp-contract=off",
    "-shared",
    "-fPIC",
]  # no fused multiply-add: it rounds differently
DOUBLES, INTEGERS = POINTER(c_double), POINTER(c_int64)


class World(ctypes.Structure):
    """`World` of ruler.h."""

    _fields_ = (
        *[
            ("hull", DOUBLES),
            ("hull_size", c_int64),
            ("points", DOUBLES),
            ("first", INTEGERS),
            ("boxes", DOUBLES),
        ],
        *[
            ("cell_first", INTEGERS),
            ("cell_parts", INTEGERS),
            ("x", c_double),
            ("y", c_double),
            ("cell", c_double),
        ],
        *[("columns", c_int64), ("rows", c_int64)],
    )


class Tree(ctypes.Structure):
    """`Tree` of ruler.h."""

    _fields_ = (
        *[("nodes", DOUBLES), ("parent", INTEGERS), ("size", c_int64), ("capacity", c_int64)],
        *[
            ("x", c_double),
            ("y", c_double),
            ("cell", c_double),
            ("columns", c_int64),
            ("rows", c_int64),
        ],
        *[("head", INTEGERS), ("next", INTEGERS)],
    )


def compile_c(name: str) -> ctypes.CDLL:
    """The library made of a C file beside this one; Missing where there is no compiler."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    if compiler is None:
        raise Missing("no C compiler: neither cc nor gcc is on the PATH")
    source = Path(__file__).with_name(f"{name}.c")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        library = Path(folder) / f"{name}.so"
        subprocess.run([compiler, *FLAGS, "-o", library, source, "-lm"], check=True)
        return ctypes.CDLL(str(library))  # it stays loaded when its file is deleted


def pointer(array: np.ndarray) -> ctypes.POINTER:
    """Where an array's numbers are; the array must be contiguous, and outlive the call."""
    if not array.flags.c_contiguous:
        raise ValueError("an array of a ruler must be contiguous")
    return array.ctypes.data_as(DOUBLES if array.dtype == np.float64 else INTEGERS)


def world_of(problem: ProblemRecord) -> World:
    """A polygon world's arrays, as C sees them."""
    world, cells = problem.world, problem.world.cells
    return World(
        *[
            pointer(world.hull),
            len(world.hull),
            pointer(world.obstacles.points),
            pointer(world.obstacles.first),
        ],
        *[
            pointer(cells.boxes),
            pointer(cells.first),
            pointer(cells.parts),
            cells.x,
            cells.y,
            cells.cell,
            cells.columns,
            cells.rows,
        ],
    )


def tree_of(tree: GrowingTree) -> Tree:
    """An empty tree's arrays, as C sees them."""
    buckets = [
        tree.x,
        tree.y,
        tree.cell,
        tree.columns,
        tree.rows,
        pointer(tree.head),
        pointer(tree.next),
    ]
    return Tree(pointer(tree.nodes), pointer(tree.parent), 0, len(tree.nodes), *buckets)
