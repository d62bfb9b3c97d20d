"""Boards that answer without Python: bodies as WebAssembly, for pages without a kernel.

A body is a function from arrays to arrays: from a scene (`scenes.py`) to what is shown. It calls
the same functions as the boards of a lesson, so that both give the same numbers, to the last bit.
The boards of a distance, of curves and of searches call the body's own functions, and
`boards/core/shown.py` draws what they return.

| file | what it is |
|---|---|
| `scenes.py` | a scene as arrays, and the faults in it |
| `plans.py` | the bodies of the planners |
| `grids.py` | the body of A* on a grid |
| `terrains.py` | the same planners on a bitmap |
| `nearest.py` | the body of the distance board |
| `curves.py` | the body of the curves' board |
| `searches.py`, `search_runs.py`, `search_layers.py` | the bodies of the search board |
| `sweeps.py` | the body of the sweep's board |
| `arms.py`, `regions.py` | the body of the arm's board |
| `bugs.py`, `walks.py`, `bug_looks.py` | the bodies of the bugs' board, and their looks |
| `looks.py` | what a body says, and how its layers look |
| `bodies.py` | the table of all bodies, with their words and looks |
| `wasm.py` | from a body to a WebAssembly module |
| `runtime.c` | what a module needs besides: memory, and numpy's random numbers |
| `worker.js` | runs a module beside the page |
| `live.js` | the page's side: it sends a scene and shows the answer |
"""
