"""A simulated Copley drive in PVT mode, which turns buffered points into motion.

The motion is a sequence of profiles, exact at any time, like that of an axis. Time is virtual, in whole
microseconds while a move runs, and passes only in `run_until`.
"""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, inf

from motionlang.kernel.planners import Profile, from_curve, hold, plan_stop, pvt_piece
from motionlang.lab.pvt.drive.packet import UNDERFLOW
from motionlang.lab.pvt.drive.point import WirePoint
from motionlang_copley.buffer import Buffer, BufferedPoint, entry_of

IDLE, WAITING, MOVING, STOPPING = "idle", "waiting", "moving", "stopping"

# Servo period in microseconds; sub-mode 0 adjusts its times by one of them.
SERVO_PERIOD = 250
# Points that sub-mode 0 needs before it moves, and aims to keep in the buffer.
START_POINTS = 3
# Deceleration of an aborted move, counts/s².
ABORT_DECELERATION = 1_000_000.0


class Drive:
    """A drive at rest at `position` with an empty buffer.

    `log` lists the events (time in seconds, sentence). `listener` is called when a point leaves the buffer or an
    error is latched: the event of object 0x2012.
    """

    def __init__(
        self,
        position: float = 0.0,
        *,
        servo_period: int = SERVO_PERIOD,
        abort_deceleration: float = ABORT_DECELERATION,
    ) -> None:
        self.buffer = Buffer()
        self.servo_period, self.abort_deceleration = servo_period, abort_deceleration
        self.state = IDLE
        # Sub-mode 0: begin with an empty buffer, wait for points, and adjust the segment times.
        self.steering = False
        self.microseconds = 0
        self.starts: list[float] = [0.0]
        self.profiles: list[Profile] = [hold(position)]
        self.log: list[tuple[float, str]] = []
        self.listener: Callable[[], None] | None = None
        # Position on the machine minus the position that the drive shows; homing changes it.
        self.datum = 0.0
        # Called at the end of a motion outside the buffer.
        self._then: Callable[[], None] | None = None
        self._boundary: int | None = None
        self._reference = position
        self._velocity = 0.0
        self._entry = BufferedPoint(0, None, 0)

    # --------------------------------------------------------------------------------------------- state

    @property
    def now(self) -> float:
        """Virtual time in seconds."""
        return self.microseconds / 1e6

    @property
    def position(self) -> float:
        """The commanded position, counts."""
        return self.profiles[-1].position(self.now - self.starts[-1])

    @property
    def velocity(self) -> float:
        """The commanded velocity, counts/s."""
        return self.profiles[-1].velocity(self.now - self.starts[-1])

    @property
    def next_boundary(self) -> int | None:
        """The virtual time, microseconds, at which the current segment ends; None at rest."""
        return self._boundary

    # ------------------------------------------------------------------------------------------ commands

    def add(self, point: WirePoint) -> bool:
        """Put a point into the buffer; return False if it was full."""
        return self.add_entry(entry_of(point))

    def add_entry(self, entry: BufferedPoint) -> bool:
        """Put an entry into the buffer.

        In sub-mode 0 the third entry starts a waiting move.
        """
        taken = self.buffer.add(entry)
        if not taken:
            self._note("a point came to a full buffer and was dropped: overflow")
            self._event()
        elif self.state == WAITING and len(self.buffer.entries) >= START_POINTS:
            self._begin()
        return taken

    def latch(self, error: int, why: str) -> None:
        """Latch an error that was detected on the bus."""
        self.buffer.errors |= error
        self._note(why)
        self._event()

    def clear_errors(self, mask: int) -> None:
        """Clear the latched errors in a mask."""
        self.buffer.errors &= ~mask

    def clear(self) -> None:
        """Clear the buffer and abort the move in progress."""
        self.buffer.clear()
        self.stop("the buffer was cleared")

    def pop(self, count: int) -> None:
        """Remove the last points added; a move continues unless it runs out of points."""
        self.buffer.pop(count)

    def start(self) -> None:
        """Begin the move in the buffer; a no-op while one is in progress."""
        if self.state in (MOVING, STOPPING, WAITING):
            return
        if self.steering:
            self.buffer.clear()
            self.state = WAITING
            self._note(f"waiting for {START_POINTS} points")
        else:
            self._begin()

    def stop(self, why: str = "stopped by the master") -> None:
        """Abort the move in progress by braking to rest; the buffer stays unchanged."""
        if self.state == MOVING:
            word = "aborted" if self.velocity else "ended"
            self._note(f"move {word} at {self.position:.10g}: {why}")
            self._brake()
        elif self.state == WAITING:
            self.state = IDLE

    # ----------------------------------------------------------------------------- motion outside the buffer

    def follow(self, profile: Profile, seconds: float, then: Callable[[], None]) -> None:
        """Start a motion that replaces any current one; call `then` after `seconds`."""
        self._append(profile)
        self.state, self._then = MOVING, then
        self._boundary = None if seconds == inf else self.microseconds + max(1, ceil(seconds * 1e6 - 1e-6))

    def rest(self) -> None:
        """End the motion in progress at the end of its profile."""
        self._then = None
        self._rest(self.profiles[-1].end)

    def brake(self, deceleration: float) -> None:
        """Brake to rest at a deceleration, counts/s²; no function is called at the end."""
        self._then = None
        self._brake(deceleration)

    def shift(self, distance: float) -> None:
        """Shift the zero position by a distance, counts, at rest; the axis does not move."""
        self.datum += distance
        self._rest(self.position - distance)

    def forget(self, most: int) -> None:
        """Delete all but the last `most` profiles and log entries."""
        for records in (self.starts, self.profiles, self.log):
            del records[: max(0, len(records) - most)]

    # ---------------------------------------------------------------------------------------------- time

    def run_until(self, microseconds: int) -> None:
        """Advance virtual time to `microseconds`, segment by segment."""
        while self._boundary is not None and self._boundary <= microseconds:
            self.microseconds = self._boundary
            self._boundary = None
            self._arrive()
        self.microseconds = max(self.microseconds, microseconds)

    # ---------------------------------------------------------------------------------- the life of a move

    def _begin(self) -> None:
        """Take the first point, which sets the initial position and velocity of the move."""
        self._reference = here = self.position
        first = self._take()
        while first is not None and first.initial:
            self._reference = float(first.position)
            first = self._take()
        if first is None:
            self._run_dry("the move was started with no point in the buffer")
            return
        position = self._position_of(first)
        if position != here:
            self._note(f"commanded position steps from {here:.10g} to {position:.10g} at the start")
            self._append(hold(position))
        self._velocity = 0.0 if first.velocity is None else first.velocity / 10.0
        self._entry = first
        self.state = MOVING
        self._note(f"move started at {position:.10g}")
        self._next_segment()

    def _arrive(self) -> None:
        """End the current profile, and begin the next segment or come to rest."""
        if self._then is not None:
            then, self._then = self._then, None
            then()
        elif self.state == STOPPING:
            self._rest(self.profiles[-1].end)
        else:
            self._next_segment()

    def _next_segment(self) -> None:
        """Begin the segment from the point just reached to the next one in the buffer."""
        if self._entry.microseconds == 0:
            self._note(f"move ended at {self._reference:.10g}")
            self._rest(self._reference)
            return
        following = self._take()
        if following is None:
            self._run_dry("the next point was not in the buffer in time")
            return
        self._run(following)

    def _run(self, target: BufferedPoint) -> None:
        span = self._steered(self._entry.microseconds)
        begin = self._reference
        position = self._position_of(target)
        given = None if target.velocity is None else target.velocity / 10.0
        piece = pvt_piece(begin, self._velocity, position, given, span / 1e6)
        end_velocity = piece[1] if given is None else given
        curve = ((0.0, span / 1e6), (piece,), (("segment", 0),))
        self._append(from_curve("pvt", begin, position, curve, piece[1], end_velocity))
        self._velocity, self._entry = end_velocity, target
        self._boundary = self.microseconds + span

    def _steered(self, span: int) -> int:
        """Return the segment time adjusted for sub-mode 0.

        It is one servo period longer while the buffer has too few points, and one shorter while it has too
        many.
        """
        if not self.steering:
            return span
        surplus = len(self.buffer.entries) - START_POINTS
        step = self.servo_period if surplus < 0 else -self.servo_period if surplus > 0 else 0
        return max(span + step, self.servo_period)

    def _position_of(self, entry: BufferedPoint) -> float:
        """Return the absolute position of a point, the reference for the next one."""
        self._reference = self._reference + entry.position if entry.relative else float(entry.position)
        return self._reference

    def _take(self) -> BufferedPoint | None:
        entry = self.buffer.take()
        if entry is not None:
            self._event()
        return entry

    def _run_dry(self, why: str) -> None:
        self.buffer.errors |= UNDERFLOW
        self._note(f"underflow at {self.position:.10g}: {why}")
        self._event()
        self._brake()

    def _brake(self, deceleration: float = 0.0) -> None:
        velocity, self._then = self.velocity, None
        if velocity == 0.0:
            self._rest(self.position)
            return
        self.state = STOPPING
        stop = plan_stop("trapezoid", self.position, velocity, deceleration or self.abort_deceleration)
        self._append(stop)
        self._boundary = self.microseconds + max(1, round(stop.duration * 1e6))

    def _rest(self, position: float) -> None:
        self._append(hold(position))
        self.state, self._boundary = IDLE, None

    def _append(self, profile: Profile) -> None:
        self.starts.append(self.now)
        self.profiles.append(profile)

    def _note(self, what: str) -> None:
        self.log.append((self.now, what))

    def _event(self) -> None:
        if self.listener is not None:
            self.listener()
