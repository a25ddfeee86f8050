"""The move buffer beyond moves: dwells and outputs in it, and what starts its entries (TRIGGERMODE)."""

from __future__ import annotations

from motionlang.controller.triggers.watch import Watch, arm
from motionlang.mint.keywords.axis_settings import reading, writing
from motionlang.mint.keywords.io_inputs import BANK, LAST_CHANNEL, Inputs, checked
from motionlang.mint.keywords.motion_operations import refuse_stopping
from motionlang.mint.runtime.binding import axis_of, scale_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.axis import Axis
    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

AUTO, AT_GO, AT_INPUT, AT_POSITION = range(4)
_DEFAULTS = {"TRIGGERINPUT": -1.0, "TRIGGERSOURCE": 0.0, "TRIGGERCHANNEL": 0.0, "TRIGGERVALUE": 0.0}


class Triggers:
    """TRIGGERMODE of every axis, and what it goes by."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._controller = environment.controller
        self._modes: dict[int, int] = {}
        self._settings: dict[tuple[str, int], float] = {}
        self._watches: dict[int, tuple[Axis, Watch]] = {}
        # The counts at which TRIGGERVALUE lies where it is a position of an axis: it keeps them whatever the scale.
        self._places: dict[int, float] = {}
        environment.controller.listeners.append(self._rescaled)
        environment.part(Inputs).listeners.append(self._changed)
        environment.loaded = self.loaded

    def mode(self, axis: int) -> int:
        return self._modes.get(axis, AT_GO)

    def set_mode(self, axis: int, mode: int) -> None:
        """Start moves in another way from now on; what waits already waits for it, too."""
        self._modes[axis] = mode
        self._watch(axis)

    def setting(self, name: str, axis: int) -> float:
        return self._settings.get((name, axis), _DEFAULTS[name])

    def set(self, name: str, axis: int, value: float) -> None:
        self._settings[name, axis] = value
        watched = self._watched_axis(axis)
        if name != "TRIGGERINPUT" and watched is not None:
            self._places[axis] = watched.scale.position_to_counts(self.setting("TRIGGERVALUE", axis))
        self._watch(axis)

    def _watched_axis(self, axis: int) -> Axis | None:
        """The axis whose position may start moves; None for an encoder."""
        if self.setting("TRIGGERSOURCE", axis):
            return None
        return self._controller.axes.get(int(self.setting("TRIGGERCHANNEL", axis)))

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
        if self._modes.get(axis) == AUTO:
            self._controller.go((axis,))

    def default(self, axis: int) -> None:
        """DEFAULT."""
        self._modes.pop(axis, None)
        for name in _DEFAULTS:
            self._settings.pop((name, axis), None)
        self._places.pop(axis, None)
        self._watch(axis)

    def _start(self, axis: int) -> None:
        if self._controller.axes[axis].buffer:
            self._controller.go((axis,))

    def _changed(self, channel: int, on: bool) -> None:
        for axis, mode in self._modes.items():
            if on and mode == AT_INPUT and self.setting("TRIGGERINPUT", axis) == channel:
                self._start(axis)

    def _watch(self, axis: int) -> None:
        """Watch for the position that starts the moves of an axis, as far as one does."""
        track, watch = self._watches.pop(axis, (None, None))
        if track is not None and watch is not None:
            track.watches.remove(watch)
        if self.mode(axis) != AT_POSITION:
            return
        from motionlang.mint.keywords.following_masters import master

        found = master(self._environment, int(self.setting("TRIGGERSOURCE", axis)),
                       int(self.setting("TRIGGERCHANNEL", axis)))  # fmt: skip
        place = found.to_counts(self.setting("TRIGGERVALUE", axis))
        made = Watch(place, lambda _: self._start(axis), False)
        found.track.watches.append(made)
        arm(found.track, made, self._controller.clock, self._controller.clock.now)
        self._watches[axis] = found.track, made


# ----------------------------------------------------------------------------------------------- operations


def read_trigger_mode(environment: Environment, row: Row) -> Operation:
    triggers = environment.part(Triggers)
    return lambda axis: triggers.mode(axis_of(environment, axis))


def write_trigger_mode(environment: Environment, row: Row) -> Operation:
    """TRIGGERMODE."""
    triggers = environment.part(Triggers)

    def write(axis: int, mode: int) -> None:
        row.check(mode)
        triggers.set_mode(axis_of(environment, axis), mode)

    return write


def read_trigger(environment: Environment, row: Row) -> Operation:
    """TRIGGERINPUT, -SOURCE, -CHANNEL and -VALUE, the value in units of what is watched."""
    return reading(environment, row, environment.part(Triggers).setting)


def write_trigger(environment: Environment, row: Row) -> Operation:
    """TRIGGERINPUT, -SOURCE, -CHANNEL and -VALUE; moves that wait go by it at once."""
    return writing(environment, row, environment.part(Triggers).set)


def read_last_id(environment: Environment, row: Row) -> Operation:
    controller = environment.controller
    return lambda axis: controller.move_id(axis_of(environment, axis))


def read_status(environment: Environment, row: Row) -> Operation:
    """MOVEBUFFERSTATUS: the first three bits are those of the move that is executing."""
    controller = environment.controller

    def read(axis: int) -> int:
        a = controller.axes[axis_of(environment, axis)]
        bits = (not a.buffer) << 3 | (controller.room(axis) <= 0) << 4
        if a.move is None:
            return bits
        at_rest = a.suspended and not a.velocity(controller.clock.now)
        run = getattr(a.move.action, "run", None)
        contour = run is not None and run.axes[0].contour_mode
        bits |= (a.move.speed is not None) << 0 | a.move.overridden << 1 | contour << 2 | at_rest << 5
        return bits | (run is not None and run.stops_at_corner) << 6

    return read


def loader(environment: Environment, put: Callable[..., None]) -> Operation:
    """The operation of a move: true while the buffer of its axis is full; `put` takes axis, …, value and line."""
    room = environment.controller.room

    def load(axis: int, *arguments: float) -> bool:
        scale_of(environment, axis)
        refuse_stopping(environment, axis)
        if room(axis) <= 0:
            return True
        put(axis, *arguments)
        if environment.loaded is not None:
            environment.loaded(axis)
        return False

    return load


def load_dwell(environment: Environment, row: Row) -> Operation:
    """MOVEDWELL: a rest between two moves, ms."""
    load = environment.controller.load_dwell

    def put(axis: int, milliseconds: float, line: int) -> None:
        row.check(milliseconds)
        load(axis, milliseconds / 1000.0, row.name, line)

    return loader(environment, put)


def load_out(environment: Environment, row: Row) -> Operation:
    """MOVEOUT: a bank of outputs, set between two moves."""
    load = environment.controller.load_output

    def put(axis: int, bank: int, bits: int, line: int) -> None:
        first = checked(bank, LAST_CHANNEL // BANK, "bank") * BANK
        load(axis, {first + k: bits >> k & 1 for k in range(BANK)}, row.name, line)

    return loader(environment, put)


def load_out_bit(environment: Environment, row: Row) -> Operation:
    """MOVEOUTX: one output, set between two moves."""
    load = environment.controller.load_output

    def put(axis: int, channel: int, value: int, line: int) -> None:
        load(axis, {checked(channel, LAST_CHANNEL, "output"): int(value != 0)}, row.name, line)

    return loader(environment, put)


def load_pulse(environment: Environment, row: Row) -> Operation:
    """MOVEPULSEOUTX: a pulse of an output, ms, that begins between two moves."""
    load = environment.controller.load_pulse

    def put(axis: int, channel: int, milliseconds: float, line: int) -> None:
        row.check(milliseconds)
        load(axis, checked(channel, LAST_CHANNEL, "output"), milliseconds / 1000.0, row.name, line)

    return loader(environment, put)


OPERATIONS = {
    "buffer.last_id": {"read": read_last_id},
    "buffer.status": {"read": read_status},
    "buffer.trigger_mode": {"read": read_trigger_mode, "write": write_trigger_mode},
    "buffer.trigger": {"read": read_trigger, "write": write_trigger},
    "buffer.dwell": {"load": load_dwell},
    "buffer.out": {"load": load_out},
    "buffer.out_bit": {"load": load_out_bit},
    "buffer.pulse": {"load": load_pulse},
}
