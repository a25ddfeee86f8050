"""How deep the calls of a program nest, and room for them on Python's own stack.

A language has a depth of its own, so that a recursion ends at the same call and the same time wherever it runs: from
the command line, from `run` at any depth of Python calls, in a thread, on any version of Python. Python's recursion
limit is raised for the length of a run, relative to where the run begins, so that it is never what ends a program.
"""

from __future__ import annotations

from _thread import allocate_lock
from sys import _getframe, getrecursionlimit, setrecursionlimit

TYPE_CHECKING = False
if TYPE_CHECKING:
    pass

# Calls of subs, functions and Gosubs within one another, in one task or handler.
MAX_DEPTH = 1000
# Python frames that one call may take: the generator, its dispatcher, and parts of its blocks within one another.
MAX_FRAMES = 10
# Frames for what the deepest statement calls, and for passes over the nested text of a program.
_REST = 5000
_ROOM = MAX_DEPTH * MAX_FRAMES + _REST

_lock = allocate_lock()
# The limits that the open blocks need, behind the limit before the first of them.
_limits: list[int] = []


class Room:
    """A block in which Python may nest enough calls for any program; blocks of several threads may overlap.

    The limit belongs to all threads, so it is restored when the last block ends.
    """

    __slots__ = ("_limit",)

    def __enter__(self) -> None:
        self._limit = _depth() + _ROOM
        with _lock:
            if not _limits:
                _limits.append(getrecursionlimit())
            _limits.append(self._limit)
            setrecursionlimit(max(_limits))

    def __exit__(self, *_: object) -> None:
        with _lock:
            _limits.reverse()  # what was first may be the same number
            _limits.remove(self._limit)
            _limits.reverse()
            setrecursionlimit(max(_limits))
            if len(_limits) == 1:
                _limits.clear()


def _depth() -> int:
    """How many Python calls the caller is deep."""
    depth = 0
    frame = _getframe().f_back
    while frame is not None:
        depth, frame = depth + 1, frame.f_back
    return depth
