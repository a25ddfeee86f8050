"""Operations in time: writes, loads and commands as generated code calls them.

    if k0(2.0, 10.0): yield

An operation pays for the statements before its own, runs at the resulting machine time, and returns False. If
something else is due by then, or a move finds no space, the operation is put off and returns True. The task yields
and, when it is resumed, carries the operation out first (`MintTask`).

`t`, the statement, and `H`, the first one at which something else may happen, are cells that the functions of a program
share with each other and with their operations. The functions that they call are bound in `binding.py`.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import CellType
    from typing import Any

    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., bool]
    # An operation that was put off, its arguments, and the axes without space if it waits for that.
    PutOff = tuple[Operation, tuple[Any, ...], tuple[int, ...] | None]


class Operations:
    """Makes timed operations from the operations of keywords; all share one time.

    - `timed` is for operations at a statement.
    - `repeated` is for operations that a polling loop may repeat. It receives a function that reads the `replaced`
      value; if this does not change, the operation was a no-op.
    - `reported` is for writes that a polling loop may repeat and that return true if they have changed anything.
    - `copied` is for operations that do not prevent the skipping of a loop, except for its last iteration.
    - `loading` is for moves, which are put off while there is no space for them. It receives the fast-path loaders
      by axis, if any, and the axis or axes, if known.
    - `now` only sets the clock, for a statement that reads.
    """

    __slots__ = ("_environment", "cells", "now", "set_time", "timed")

    def __init__(self, environment: Environment) -> None:
        clock, statements = environment.clock, environment.statements
        cost = statements.cost
        t = horizon = 0.0

        def set_time(reached: tuple[float, float]) -> None:
            nonlocal t, horizon
            t, horizon = reached

        def now(paid: float) -> bool:
            """`T`: set the clock for a statement that reads it, unless something else is due."""
            nonlocal t
            t += paid
            if t >= horizon:
                return True
            clock.now = statements.base + t * cost
            return False

        def nearer() -> bool:
            """Shorten the horizon after an operation has scheduled an earlier event.

            The event happens before the next statement, but after the rest of this one.
            """
            nonlocal horizon
            horizon = statements.limit(clock.horizon)
            if horizon <= t:
                horizon = t + 0.5
            return False

        def timed(act: Callable[..., object], loads: bool = False, axes: Any = None) -> Operation:
            def at(paid: float, *arguments: Any) -> bool:
                nonlocal t
                t += paid
                if t >= horizon:
                    environment.put_off = at, arguments, None
                    return True
                clock.now = statements.base + t * cost
                environment.acts += 1
                if act(*arguments) and loads:  # there is no space
                    full = arguments[0] if axes is None else axes
                    environment.put_off = at, arguments, full if isinstance(full, tuple) else (full,)
                    return True
                return clock.horizon < statements.until and nearer()

            return at

        self.now, self.timed, self.set_time = now, timed, set_time
        # The cells of `t` and `H`.
        self.cells: tuple[CellType, CellType] = cells_of(set_time, "t", "horizon")
        self._environment = environment

    def reported(self, act: Callable[..., object]) -> Operation:
        """Return the operation for a write that reports whether it changed anything."""
        environment = self._environment

        def write(*arguments: object) -> None:
            acts, switches = environment.acts, environment.switches
            if not act(*arguments):
                environment.acts, environment.switches = acts - 1, switches

        return self.timed(write)

    def repeated(self, act: Callable[..., object], replaced: Callable[..., object]) -> Operation:
        """Return the operation for a write that a polling loop may repeat."""
        environment = self._environment
        clock = environment.clock

        def write(*arguments: object) -> None:
            acts, switches = environment.acts, environment.switches
            before, made = replaced(*arguments), clock.made
            act(*arguments)
            if clock.made == made and replaced(*arguments) == before:
                environment.acts, environment.switches = acts - 1, switches
                environment.repeats += 1

        return self.timed(write)

    def copied(self, act: Callable[..., object]) -> Operation:
        """Return the operation for a write to host memory that its loop does not read."""
        environment = self._environment

        def write(*arguments: object) -> None:
            act(*arguments)
            environment.acts -= 1
            environment.copies += 1

        return self.timed(write)

    def loading(self, load: Callable[..., object], plain: Any = None, axes: Any = None) -> Operation:
        """Return the operation that loads a move.

        `plain` are the fast-path loaders by axis, if there are any.
        """
        if plain is None:
            return self.timed(load, True, axes)
        environment = self._environment
        wraps = environment.wraps
        if axes is None:

            def load_each(axis: int, value: float, line: int) -> object:
                usual = wraps or environment.loaded is not None or not plain[axis](value, line)
                return usual and load(axis, value, line)

            return self.timed(load_each, True)
        load_plain = plain[axes]

        def load_one(value: float, line: int) -> object:
            usual = wraps or environment.loaded is not None or not load_plain(value, line)
            return usual and load(value, line)

        return self.timed(load_one, True, axes)


def cells_of(function: Callable[..., object], *names: str) -> Any:
    """Return the cells of a function's free variables with these names."""
    found = dict(zip(function.__code__.co_freevars, function.__closure__ or (), strict=True))
    return tuple(found[name] for name in names)
