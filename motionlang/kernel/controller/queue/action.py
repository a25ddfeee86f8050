"""The base of all buffer entries and motions in progress that are not moves to a position."""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.queue import buffer
from motionlang.kernel.controller.queue.life import continue_with
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile


class Action:
    """A buffer entry or motion in progress that is not a move to a position."""

    __slots__ = ()

    # True if a suspended axis may begin it at standstill. If not, it waits in the buffer.
    can_stand = True
    # True if it takes no time, so that it does not delay a path.
    is_instant = False
    # True if it is superposed on following without waiting for its end, by `begin_on_top`.
    lies_on_top = False
    # True if the axis accepts no other motion before this one has been stopped.
    exclusive = False
    # True if its motion observes the rates of the axis, unlike that of a table, a master or a reference.
    keeps_rates = True
    # The limits of the axis that act on it at once, if not every setting does (`live`).
    live_limits: tuple[str, ...] = ()

    def release(self, move: LoggedMove) -> None:
        """Handle a GO that releases the entry."""
        move.released = True

    def purge(self, a: Axis) -> list[LoggedMove]:
        """Handle removal from the buffer of `a`; return the entries removed together."""
        return []

    def keep_end(self, a: Axis, move: LoggedMove, shift: float) -> bool:
        """True if the entry keeps its end although it will begin `shift` further on."""
        return False

    def ready(self, a: Axis, move: LoggedMove) -> bool:
        """True if the entry, first in its buffer and released, may begin."""
        return True

    def begin(self, a: Axis, move: LoggedMove) -> None:
        """Begin the motion; its entry has left the buffer."""
        raise NotImplementedError

    def begin_on_top(self, a: Axis, move: LoggedMove) -> None:
        """Begin superposed while the axis follows a master; the entry has left the buffer."""
        raise NotImplementedError

    def plan(self, a: Axis) -> Profile:
        """Return the rest of the motion with the present settings."""
        return a.profiles[-1].after(a.clock.now - a.starts[-1])

    def replan(self, a: Axis) -> None:
        """Apply a changed setting that acts at once."""
        continue_with(a, self.plan(a), "")

    def prolong(self, end: float) -> Profile | None:
        """Return the continuation from `end`; None if the motion comes to rest there."""
        return None

    def more(self, a: Axis) -> None:
        """Handle the release of further buffer entries during the motion."""

    def shift(self, a: Axis, shift: float) -> None:
        """Handle a new zero that is about to increase positions by `shift`."""

    def stops_itself(self, ended: str, hard: bool) -> bool:
        """True if `stop` makes such a stop; False to decelerate as usual."""
        return False

    def stop(self, a: Axis, ended: str, hard: bool) -> None:
        """Come to rest in a manner of its own, and empty the buffer."""
        raise NotImplementedError

    def is_stopping(self, hard: bool) -> bool:
        """True if it is coming to rest already, and such a stop would change nothing."""
        return False

    def suspend(self, a: Axis) -> bool:
        """Come to rest until `plan` is called; False if `plan` itself does it."""
        return False

    def resume(self, a: Axis) -> None:
        """Continue after `suspend`."""
        self.replan(a)

    def entries(self, a: Axis, move: LoggedMove) -> tuple[LoggedMove, ...]:
        """Return the log entries of the axis that may still change, oldest first.

        `move` is the move in progress.
        """
        return (move,)

    def together_with(self, a: Axis) -> tuple[Axis, ...]:
        """Return the axes that the action moves; they are suspended together with `a`."""
        return (a,)

    def leave(self, a: Axis, ended: str) -> None:
        """Handle the change of the axis to another motion, or its immediate halt."""

    @property
    def is_sequel(self) -> bool:
        """True for a repetition of a periodic entry, which no line of its own commanded."""
        return False

    @property
    def resting(self) -> bool:
        """True if the axis is at rest until another axis moves."""
        return False

    @property
    def live(self) -> bool:
        """True if a new speed or rate acts on the motion at once."""
        return False


def put_action(a: Axis, action: Action, command: str, line: int) -> None:
    """Load an entry that is not a move; it ends where the entry before it does."""
    move = buffer.counted(a, 0.0, command, line)
    move.action = action
    buffer.put(a, move)
