"""What a statement writes, loads or does, as generated code calls it:

    if k0(2.0, 10.0): yield

An operation pays for the statements before its own, is carried out at the machine time of that, and answers with False.
Where something else is due by then, or a move finds no room, it is put off and answers with True: the task gives way,
and the operation is what it does first when it goes on (`MintTask`).

`t`, the statement, and `H`, the first one at which something else wants to happen, are cells, which the functions of a
program share with each other and with their operations.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import CellType
    from typing import Any

    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., bool]
    # An operation that was put off, what it is given, and where it is for room the axes that have none.
    PutOff = tuple[Operation, tuple[Any, ...], tuple[int, ...] | None]


class Operations:
    """What makes operations of what words do, and the time that all of them go by.

    `timed` is for what is done at a statement. `repeated` is for what a loop that polls may write or do, told also what
    is `held`: where all is as it was before, nothing was done. `loading` is for moves, which are refused while there is
    no room for them, told also what loads a plain one, by axis, where that is something else, and the axis or the axes
    of all of them where these are known. `now` does nothing, at a statement that reads.
    """

    __slots__ = ("cells", "loading", "now", "repeated", "set_time", "timed")

    def __init__(self, environment: Environment) -> None:
        clock, attention, statements = environment.clock, environment.attention, environment.statements
        cost = statements.cost
        t = horizon = 0.0

        def set_time(place: tuple[float, float]) -> None:
            nonlocal t, horizon
            t, horizon = place

        def now(paid: float) -> bool:
            """`T`: the clock is told the time of a statement that reads it, unless something else is due by then."""
            nonlocal t
            t += paid
            if t >= horizon:
                return True
            clock.now = statements.base + t * cost
            return False

        def nearer() -> bool:
            """An event is nearer now. It comes before the next statement, and after what else this one does."""
            nonlocal horizon
            horizon = statements.limit(clock.horizon)
            if horizon <= t:
                horizon = t + 0.5
            return False

        def timed(operation: Callable[..., object]) -> Operation:
            def at(paid: float, *arguments: object) -> bool:
                nonlocal t
                t += paid
                if t >= horizon:
                    environment.put_off = at, arguments, None
                    return True
                clock.now = statements.base + t * cost
                environment.acts += 1
                operation(*arguments)
                return clock.horizon < statements.until and nearer()

            return at

        def repeated(operation: Callable[..., object], held: Callable[..., object]) -> Operation:
            def at(paid: float, *arguments: object) -> bool:
                nonlocal t
                t += paid
                if t >= horizon:
                    environment.put_off = at, arguments, None
                    return True
                clock.now = statements.base + t * cost
                acts = environment.acts
                environment.acts = acts + 1
                if attention.notes is None:  # nobody looks at this turn
                    operation(*arguments)
                else:
                    before, made = held(*arguments), clock.made
                    operation(*arguments)
                    if clock.made == made and held(*arguments) == before:
                        environment.acts = acts
                return clock.horizon < statements.until and nearer()

            return at

        def loading(to_axes: Callable[..., object], plain: Any = None, axes: Any = None) -> Operation:
            def at(paid: float, *arguments: Any) -> bool:
                nonlocal t
                t += paid
                if t >= horizon:
                    environment.put_off = at, arguments, None
                    return True
                clock.now = statements.base + t * cost
                environment.acts += 1
                if to_axes(*arguments):
                    full = arguments[0] if axes is None else axes
                    environment.put_off = at, arguments, full if isinstance(full, tuple) else (full,)
                    return True
                return clock.horizon < statements.until and nearer()

            if plain is None:
                return at
            wraps = environment.wraps
            if axes is not None:
                load = plain[axes]

                def plainly(paid: float, value: float, line: int) -> bool:
                    nonlocal t
                    t += paid
                    if t >= horizon:
                        environment.put_off = at, (value, line), None
                        return True
                    clock.now = statements.base + t * cost
                    if wraps or environment.loaded is not None or not load(value, line):
                        return at(0.0, value, line)
                    environment.acts += 1
                    return clock.horizon < statements.until and nearer()

                return plainly

            def each(paid: float, axis: int, value: float, line: int) -> bool:
                nonlocal t
                t += paid
                if t >= horizon:
                    environment.put_off = at, (axis, value, line), None
                    return True
                clock.now = statements.base + t * cost
                if wraps or environment.loaded is not None or not plain[axis](value, line):
                    return at(0.0, axis, value, line)
                environment.acts += 1
                return clock.horizon < statements.until and nearer()

            return each

        self.now, self.timed, self.repeated, self.loading, self.set_time = (
            now,
            timed,
            repeated,
            loading,
            set_time,
        )
        # The cells of `t` and `H`.
        self.cells: tuple[CellType, CellType] = cells_of(set_time, "t", "horizon")


def cells_of(function: Callable[..., object], *names: str) -> Any:
    """The cells in which a function has these names."""
    found = dict(zip(function.__code__.co_freevars, function.__closure__ or (), strict=True))
    return tuple(found[name] for name in names)
