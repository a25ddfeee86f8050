"""The move buffer beyond moves: dwells and outputs in it, and what starts its entries (TRIGGERMODE)."""

from __future__ import annotations

from motionlang.controller.triggers.watch import Watch, arm
from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.keywords.io_inputs import BANK, LAST_CHANNEL, Inputs, checked
from motionlang.mint.keywords.motion_operations import refuse_stopping
from motionlang.mint.runtime.binding import axis_of, of
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.axis import Axis
    from motionlang.mint.runtime.binding import Maker, Operation, Row

AUTO, AT_GO, AT_INPUT, AT_POSITION = range(4)
_DEFAULTS = {"TRIGGERMODE": AT_GO, "TRIGGERINPUT": -1}


class Triggers(Settings):
    """TRIGGERMODE of every axis, and what it goes by."""

    defaults = _DEFAULTS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._watches: dict[int, tuple[Axis, Watch]] = {}
        # The counts at which TRIGGERVALUE lies where it is a position of an axis: it keeps them whatever the scale.
        self._places: dict[int, float] = {}
        environment.controller.listeners.append(self._rescaled)
        environment.part(Inputs).listeners.append(self._changed)
        environment.loaded = self.loaded

    def set(self, name: str, axis: int, value: float) -> None:
        """Go by another setting from now on; what waits already does so, too."""
        super().set(name, axis, value)
        watched = self._watched_axis(axis)
        if name not in ("TRIGGERINPUT", "TRIGGERMODE") and watched is not None:
            self._places[axis] = watched.scale.position_to_counts(self.setting("TRIGGERVALUE", axis))
        self._watch(axis)

    def _watched_axis(self, axis: int) -> Axis | None:
        """The axis whose position may start moves; None for an encoder."""
        if self.setting("TRIGGERSOURCE", axis):
            return None
        return self.controller.axes.get(int(self.setting("TRIGGERCHANNEL", axis)))

    def _rescaled(self, what: str, channel: int) -> None:
        """TRIGGERVALUE shows its counts in the units of now."""
        if what != "scale":
            return
        for axis, counts in self._places.items():
            watched = self._watched_axis(axis)
            if watched is not None and watched.index == channel:
                self._settings["TRIGGERVALUE", axis] = watched.scale.position_to_user(counts)

    def loaded(self, axis: int) -> None:
        """Something was put into the buffer of an axis."""
        if self.setting("TRIGGERMODE", axis) == AUTO:
            self.controller.go((axis,))

    def default(self, axis: int) -> None:
        """DEFAULT."""
        super().default(axis)
        self._places.pop(axis, None)
        self._watch(axis)

    def _start(self, axis: int) -> None:
        if self.controller.axes[axis].buffer:
            self.controller.go((axis,))

    def _changed(self, channel: int, on: bool) -> None:
        for (name, axis), mode in list(self._settings.items()):
            starts = on and name == "TRIGGERMODE" and mode == AT_INPUT
            if starts and self.setting("TRIGGERINPUT", axis) == channel:
                self._start(axis)

    def _watch(self, axis: int) -> None:
        """Watch for the position that starts the moves of an axis, as far as one does."""
        track, watch = self._watches.pop(axis, (None, None))
        if track is not None and watch is not None:
            track.watches.remove(watch)
        if self.setting("TRIGGERMODE", axis) != AT_POSITION:
            return
        from motionlang.mint.keywords.following_masters import master

        found = master(self.environment, int(self.setting("TRIGGERSOURCE", axis)),
                       int(self.setting("TRIGGERCHANNEL", axis)))  # fmt: skip
        place = found.to_counts(self.setting("TRIGGERVALUE", axis))
        made = Watch(place, lambda _: self._start(axis), False)
        found.track.watches.append(made)
        arm(found.track, made, self.controller.clock, self.controller.clock.now)
        self._watches[axis] = found.track, made


def read_status(environment: Environment, axis: int) -> int:
    """MOVEBUFFERSTATUS: the first three bits are those of the move that is executing."""
    controller = environment.controller
    a = controller.axes[axis]
    bits = (not a.buffer) << 3 | (controller.room(axis) <= 0) << 4
    if a.move is None:
        return bits
    at_rest = a.suspended and not a.velocity(controller.clock.now)
    run = getattr(a.move.action, "run", None)
    contour = run is not None and run.axes[0].contour_mode
    bits |= (a.move.speed is not None) << 0 | a.move.overridden << 1 | contour << 2 | at_rest << 5
    return bits | (run is not None and run.stops_at_corner) << 6


def loads(kind: type, put: Callable[..., None]) -> Maker:
    """What loads a move: true while the buffer of its axis is full.

    `put` is given a part of the environment, the row, the axis, …, the value and the line.
    """

    def made(environment: Environment, row: Row) -> Operation:
        room = environment.controller.room
        part: object = environment.part(kind)

        def load(axis: int, *arguments: float) -> bool:
            axis_of(environment, axis)
            refuse_stopping(environment, axis)
            if room(axis) <= 0:
                return True
            put(part, row, axis, *arguments)
            if environment.loaded is not None:
                environment.loaded(axis)
            return False

        return load

    return made


def put_dwell(environment: Environment, row: Row, axis: int, milliseconds: float, line: int) -> None:
    """MOVEDWELL: a rest between two moves, ms."""
    row.check(milliseconds)
    environment.controller.load_dwell(axis, milliseconds / 1000.0, row.name, line)


def put_bank(environment: Environment, row: Row, axis: int, bank: int, bits: int, line: int) -> None:
    """MOVEOUT: a bank of outputs, set between two moves."""
    first = checked(bank, LAST_CHANNEL // BANK, "bank") * BANK
    values = {first + k: bits >> k & 1 for k in range(BANK)}
    environment.controller.load_output(axis, values, row.name, line)


def put_bit(environment: Environment, row: Row, axis: int, channel: int, value: int, line: int) -> None:
    """MOVEOUTX: one output, set between two moves."""
    values = {checked(channel, LAST_CHANNEL, "output"): int(value != 0)}
    environment.controller.load_output(axis, values, row.name, line)


def put_pulse(
    environment: Environment, row: Row, axis: int, channel: int, milliseconds: float, line: int
) -> None:
    """MOVEPULSEOUTX: a pulse of an output, ms, that begins between two moves."""
    row.check(milliseconds)
    output = checked(channel, LAST_CHANNEL, "output")
    environment.controller.load_pulse(axis, output, milliseconds / 1000.0, row.name, line)


OPERATIONS = {
    "buffer.last_id": {"read": of(Environment, lambda e, axis: e.controller.move_id(axis))},
    "buffer.status": {"read": of(Environment, read_status)},
    "buffer.trigger": {"read": reading(Triggers), "write": writing(Triggers)},
    "buffer.dwell": {"load": loads(Environment, put_dwell)},
    "buffer.out": {"load": loads(Environment, put_bank)},
    "buffer.out_bit": {"load": loads(Environment, put_bit)},
    "buffer.pulse": {"load": loads(Environment, put_pulse)},
}
