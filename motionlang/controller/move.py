"""A move: what was asked for, by which line, and what became of it."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.controller.core import Core
    from motionlang.planners import Profile


# Pieces of which the profile of a move consists after which it goes on as another entry of the log.
MOST_PIECES = 500
# What `ended` says of the entry before.
CONTINUED = "continued"


class Move:
    """One entry of the move buffer and, once started, of the controller's log.

    `target` is the end point in counts. A relative entry has the `base` that it was counted from beside it: its
    target goes along with where the axis is when it starts. `profile` and `start_time` are set when it starts.
    `ended` is "" for a move that ran out by itself, else what cut it short: "stop", "cancel", "fault", "retarget", or
    `CONTINUED` where it goes on as another entry.
    `offset` is how far the axis's zero was moved while the move ran: the profile stays as planned.
    `action` makes it something else than a move to a position. `speed` is the one it was loaded with, None for that
    of the axis at the time; `rates` are an acceleration and a deceleration of its own; `overridden` says whether the
    axis's override multiplies its speed.
    """

    __slots__ = (
        "action",
        "asked",
        "axis",
        "base",
        "command",
        "ended",
        "id",
        "line",
        "offset",
        "overridden",
        "profile",
        "rates",
        "released",
        "scale",
        "speed",
        "start_time",
        "target",
        "zero",
    )

    # Whether it lies on top of another entry, which goes on.
    overlaid = False

    def __init__(self, axis: int, command: str, line: int, target: float) -> None:
        self.axis, self.command, self.line, self.target = axis, command, line, target
        self.action: Action | None = None
        self.asked: float | None = None  # the speed asked for, before its axis's limit, counts/s
        self.base: float | None = None
        self.id = 0
        self.speed: float | None = None
        self.rates: tuple[float | None, float | None] | None = None
        self.overridden = False
        self.released = False
        self.start_time = 0.0
        self.profile: Profile | None = None
        self.scale = 1.0
        self.zero = 0.0
        self.ended = ""
        self.offset = 0.0


def keeps_rates(move: Move | None) -> bool:
    """Whether an axis moves at rates of its own, not as a table, a master or a reference has it."""
    return move is None or move.action is None or move.action.keeps_rates


class Action:
    """What an entry of the buffer, or a motion in progress, is when it is not a move to a position."""

    __slots__ = ()

    # Whether an axis that is suspended may begin it, and stand; else it waits in the buffer.
    can_stand = True
    # Whether it begins on top of following, without waiting for that to end; then it has `begin_on_top`.
    lies_on_top = False
    # Whether the axis takes no other motion before this one has been stopped.
    exclusive = False
    # Whether its motion keeps the rates of the axis, as that of a table, a master or a reference does not.
    keeps_rates = True
    # The limits of the axis that act on it at once, where not every setting does (`live`).
    live_limits: tuple[str, ...] = ()

    def release(self, move: Move) -> None:
        """GO was given to the axis of the entry."""
        move.released = True

    def purge(self, a: Axis) -> list[Move]:
        """The entry was thrown out of the buffer of `a`: the entries of other axes that went with it."""
        return []

    def keep_end(self, a: Axis, move: Move, shift: float) -> bool:
        """The axis will be `shift` further on when it begins: whether it ends where it would have all the same."""
        return False

    def ready(self, controller: Core, a: Axis, move: Move) -> bool:
        """Whether it may begin, being the first of its buffer and released."""
        return True

    def begin(self, controller: Core, a: Axis, move: Move) -> None:
        """Begin; the entry has left the buffer."""
        raise NotImplementedError

    def begin_on_top(self, controller: Core, a: Axis, move: Move) -> None:
        """Begin while the axis follows a master; the entry has left the buffer."""
        raise NotImplementedError

    def plan(self, controller: Core, a: Axis) -> Profile:
        """The way on with the settings as they are now: what remains, as long as nothing else is said."""
        return a.profiles[-1].after(controller.clock.now - a.starts[-1])

    def replan(self, controller: Core, a: Axis) -> None:
        """A setting has changed that acts at once."""
        controller.continue_with(a, self.plan(controller, a), "")

    def prolong(self, end: float) -> Profile | None:
        """What it would go on with, from `end`, where the profile before it does not come to rest."""
        return None

    def more(self, controller: Core, a: Axis) -> None:
        """Further entries of the buffer were released while it is under way."""

    def shift(self, controller: Core, a: Axis, shift: float) -> None:
        """The axis's zero is about to move, so that positions grow by `shift`."""

    def stop(self, controller: Core, a: Axis, ended: str, hard: bool) -> bool:
        """Come to rest in a way of its own; False where the axis shall simply decelerate."""
        return False

    def suspend(self, controller: Core, a: Axis) -> bool:
        """Rest until `plan` is asked for the way on, in a way of its own; False where `plan` knows it."""
        return False

    def resume(self, controller: Core, a: Axis) -> None:
        """Go on after `suspend`."""
        self.replan(controller, a)

    def entries(self, a: Axis, move: Move) -> tuple[Move, ...]:
        """The entries of the axis in the log that may still change, the oldest first; `move` is the present one."""
        return (move,)

    def together_with(self, a: Axis) -> tuple[Axis, ...]:
        """The axes that move by it, and are suspended with `a`."""
        return (a,)

    def leave(self, controller: Core, a: Axis, ended: str) -> None:
        """The axis is about to leave the motion for another one, or is held where it is."""

    @property
    def is_sequel(self) -> bool:
        """Whether no line asked for it by itself: it is the next turn of one that goes on and on."""
        return False

    @property
    def resting(self) -> bool:
        """Whether the axis stands still, and will as long as nobody else moves."""
        return False

    @property
    def live(self) -> bool:
        """Whether a new speed or rate acts on it at once."""
        return False
