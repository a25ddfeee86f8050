"""The keys of the operator."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.binding import Row
    from motionlang.mint.environment import Environment

    Operation = Callable[..., object]


def read_key(environment: Environment, row: Row) -> Operation:
    """INKEY."""
    operator, clock = environment.machine.operator, environment.clock

    def read() -> int:
        key = operator.next_key()
        if key:
            environment.taken = clock.now
        return key

    return read


def read_held_key(environment: Environment, row: Row) -> Operation:
    """READKEY."""
    return environment.machine.operator.held_key
