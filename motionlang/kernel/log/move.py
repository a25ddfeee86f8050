"""A move: its command, its line, and its outcome."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis
    from motionlang.kernel.controller.motion.follow import Follow
    from motionlang.kernel.controller.queue.life import Core


# Pieces of a profile after which the move continues as a new entry of the log.
MAX_PIECES = 500
# The value of `ended` of a move that continues as another entry.
CONTINUED = "continued"


class Move:
    """An entry of the move buffer and, once started, of the controller's log.

    `target` is the end point in counts. A relative entry also has the `base` that it was counted from: its
    target moves with the position of the axis when it starts. `profile` and `start_time` are set when it
    starts. `ended` is "" for a complete move. It is "stop", "cancel", "fault" or "retarget" for one cut
    short, or `CONTINUED` if it continues as another entry. `offset` is how far the axis's zero was moved
    during the move: the profile stays as planned. `action` makes it something other than a move to a
    position. `speed` is the speed that it was loaded with; None means the axis's speed when it starts. `rates` are
    its own acceleration and deceleration, `rates_in_force` those of its present plan, counts/s²; `overridden` is true
    if the axis's override multiplies its speed.
    """

    __slots__ = (
        "action",
        "axis",
        "base",
        "command",
        "commanded_speed",
        "ended",
        "id",
        "line",
        "offset",
        "overridden",
        "profile",
        "rates",
        "rates_in_force",
        "released",
        "scale",
        "speed",
        "start_time",
        "target",
        "zero",
    )

    # True if it is superposed on another entry, which continues.
    overlaid = False

    def __init__(self, axis: int, command: str, line: int, target: float) -> None:
        self.axis, self.command, self.line, self.target = axis, command, line, target
        self.action: Action | None = None
        self.commanded_speed: float | None = None  # the commanded speed, before its axis's limit, counts/s
        self.base: float | None = None
        self.id = 0
        self.speed: float | None = None
        self.rates: tuple[float | None, float | None] | None = None
        self.rates_in_force: tuple[float, float] | None = None
        self.overridden = False
        self.released = False
        self.start_time = 0.0
        self.profile: Profile | None = None
        self.scale = 1.0
        self.zero = 0.0
        self.ended = ""
        self.offset = 0.0

    def until(self, time: float) -> Profile:
        """Return the motion of the move up to a machine time."""
        assert self.profile is not None
        return self.profile.cut(time - self.start_time)


def keeps_rates(move: Move | None) -> bool:
    """True if a move uses the rates of its axis, unlike a table or following."""
    return move is None or move.action is None or move.action.keeps_rates


class Action:
    """A buffer entry or motion in progress that is not a move to a position."""

    __slots__ = ()

    # True if a suspended axis may begin it at standstill. If not, it waits in the buffer.
    can_stand = True
    # True if it is superposed on following without waiting for its end, by `begin_on_top`.
    lies_on_top = False
    # True if the axis accepts no other motion before this one has been stopped.
    exclusive = False
    # True if its motion observes the rates of the axis, unlike that of a table, a master or a reference.
    keeps_rates = True
    # The limits of the axis that act on it at once, if not every setting does (`live`).
    live_limits: tuple[str, ...] = ()

    @property
    def tie(self) -> Follow | None:
        """The tie of the axis to its master, None if it follows none."""
        return None

    def release(self, move: Move) -> None:
        """Handle a GO that releases the entry."""
        move.released = True

    def purge(self, a: Axis) -> list[Move]:
        """Handle removal from the buffer of `a`; return the entries removed together."""
        return []

    def keep_end(self, a: Axis, move: Move, shift: float) -> bool:
        """True if the entry keeps its end although it will begin `shift` further on."""
        return False

    def ready(self, controller: Core, a: Axis, move: Move) -> bool:
        """True if the entry, first in its buffer and released, may begin."""
        return True

    def begin(self, controller: Core, a: Axis, move: Move) -> None:
        """Begin the motion; its entry has left the buffer."""
        raise NotImplementedError

    def begin_on_top(self, controller: Core, a: Axis, move: Move) -> None:
        """Begin superposed while the axis follows a master; the entry has left the buffer."""
        raise NotImplementedError

    def plan(self, controller: Core, a: Axis) -> Profile:
        """Return the rest of the motion with the present settings."""
        return a.profiles[-1].after(controller.clock.now - a.starts[-1])

    def replan(self, controller: Core, a: Axis) -> None:
        """Apply a changed setting that acts at once."""
        controller.continue_with(a, self.plan(controller, a), "")

    def prolong(self, end: float) -> Profile | None:
        """Return the continuation from `end`; None if the motion comes to rest there."""
        return None

    def more(self, controller: Core, a: Axis) -> None:
        """Handle the release of further buffer entries during the motion."""

    def shift(self, controller: Core, a: Axis, shift: float) -> None:
        """Handle a new zero that is about to increase positions by `shift`."""

    def stop(self, controller: Core, a: Axis, ended: str, hard: bool) -> bool:
        """Come to rest in a manner of its own; False to decelerate as usual."""
        return False

    def is_stopping(self, hard: bool) -> bool:
        """True if it is coming to rest already, and such a stop would change nothing."""
        return False

    def suspend(self, controller: Core, a: Axis) -> bool:
        """Come to rest until `plan` is called; False if `plan` itself does it."""
        return False

    def resume(self, controller: Core, a: Axis) -> None:
        """Continue after `suspend`."""
        self.replan(controller, a)

    def entries(self, a: Axis, move: Move) -> tuple[Move, ...]:
        """Return the log entries of the axis that may still change, oldest first.

        `move` is the move in progress.
        """
        return (move,)

    def together_with(self, a: Axis) -> tuple[Axis, ...]:
        """Return the axes that the action moves; they are suspended together with `a`."""
        return (a,)

    def leave(self, controller: Core, a: Axis, ended: str) -> None:
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
