"""The call depth of a program, and space for it on Python's stack.

A language has a maximum depth of its own, so that a recursion ends at the same call and the same time in any
environment: from the command line, from `run` at any depth of Python calls, in a thread, on any version of
Python. Python's recursion limit is raised for the duration of a run, relative to the depth at its beginning,
so that it never ends a program.
"""

from __future__ import annotations

from _thread import allocate_lock
from sys import _getframe, getrecursionlimit, setrecursionlimit

# Nested calls of subs, functions and Gosubs, in one task or handler.
MAX_DEPTH = 1000
# Python frames that one call may take: the generator, its dispatcher, and functions for groups of labels and nested
# blocks.
MAX_FRAMES = 12
# Frames for the functions that the deepest statement calls, and for passes over the nested text of a program.
_REST = 5000
_FRAMES = MAX_DEPTH * MAX_FRAMES + _REST

_lock = allocate_lock()
# The limits that the open blocks need, after the limit before the first of them.
_limits: list[int] = []


class StackSpace:
    """A block in which Python may nest enough calls for any program.

    Blocks of several threads may overlap. The limit belongs to all threads, so it is restored when the last
    block ends.
    """

    def __enter__(self) -> None:
        self._limit = _depth() + _FRAMES
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


def _depth() -> int:
    """Return the depth of the caller in Python calls."""
    depth = 0
    frame = _getframe().f_back
    while frame is not None:
        depth, frame = depth + 1, frame.f_back
    return depth
