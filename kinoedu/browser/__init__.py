"""Boards that answer without Python: planners as WebAssembly, for pages without a kernel.

A body is a function from arrays to arrays: from a scene (`scenes.py`) to what is shown. It calls
the same functions as the boards of a lesson, so that both give the same numbers, to the last bit.

| file | what it is |
|---|---|
| `scenes.py` | a scene as arrays, what a body returns, and the words for what is wrong |
| `plans.py` | the bodies of the planners |
| `bodies.py` | the table of all bodies, with the look of their layers |
| `wasm.py` | from a body to a WebAssembly module |
| `runtime.c` | what a module needs besides: memory, and numpy's random numbers |
| `worker.js` | runs a module beside the page |
| `live.js` | the page's side: it sends a scene and shows the answer |
"""
