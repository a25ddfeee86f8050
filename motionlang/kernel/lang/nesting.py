"""The call depth of a program, and space for nested text on Python's stack.

A language has a maximum depth of its own, so that a recursion ends at the same call and the same time in any
environment. Its calls are in lists, and take no space on Python's stack. Nested brackets and blocks do: in the passes
over a program, and in the functions of its expressions. So Python's recursion limit is raised meanwhile, relative to
the depth at which that begins, and never ends a program.
"""

from __future__ import annotations

from _thread import allocate_lock
from sys import getrecursionlimit, setrecursionlimit
from traceback import walk_stack

# Nested calls of subs, functions and Gosubs, in one task or handler.
MAX_DEPTH = 1000
# Frames for passes over the nested text of a program, and for the functions that the deepest statement calls.
_FRAMES = 5000

_lock = allocate_lock()
# The limits that the open blocks need, after the limit before the first of them.
_limits: list[int] = []


class StackSpace:
    """A block in which Python may nest enough calls for any program.

    Blocks of several threads may overlap. The limit belongs to all threads, so it is restored when the last
    block ends.
    """

    def __enter__(self) -> None:
        self._limit = sum(1 for _ in walk_stack(None)) + _FRAMES
        with _lock:
            if not _limits:
                _limits.append(getrecursionlimit())
            _limits.append(self._limit)
            setrecursionlimit(max(_limits))

    def __exit__(self, *_: object) -> None:
        with _lock:
            _limits.reverse()  # the first one may be an equal number
            _limits.remove(self._limit)
            _limits.reverse()
            setrecursionlimit(max(_limits))
            if len(_limits) == 1:
                _limits.clear()
