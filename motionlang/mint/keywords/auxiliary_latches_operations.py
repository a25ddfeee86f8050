"""Latches of auxiliary encoders, at an edge of an input, and the index marks of encoders."""

from __future__ import annotations

from math import floor

from motionlang.controller.io.encoder import AUXILIARY
from motionlang.controller.triggers.position_zones import Cells
from motionlang.mint.keywords.following_auxiliary import AuxEncoders, _channel
from motionlang.mint.keywords.latches_operations import SETTINGS, Latch
from motionlang.mint.keywords.sensing_operations import channel_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment


class AuxLatch(Latch):
    """The fast latch of an auxiliary encoder, whose number is its `axis`; what it catches are counts."""

    def _place(self) -> float:
        return self._controller.encoder_position(AUXILIARY + self.axis)


class AuxLatches:
    """The fast latch of every auxiliary encoder, from its first use on."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._latches: dict[int, AuxLatch] = {}

    def latch(self, channel: int) -> AuxLatch:
        """The latch of an auxiliary encoder, made on first use; a catch raises FASTIN."""
        latch = self._latches.get(_channel(channel))
        if latch is None:
            events = self._environment.events
            latch = AuxLatch(self._environment, channel, lambda fired: events.raise_("fastin", fired.input))
            self._latches[channel] = latch
        return latch


def _setting(row: Row) -> str:
    return SETTINGS[row.name.replace("AUX", "")]


def _per_unit(environment: Environment, row: Row, channel: int) -> float:
    """Counts in one unit of what the encoder shows, for distances."""
    return environment.part(AuxEncoders).per_unit(channel) if row.unit == "number" else 1.0


def read_setting(environment: Environment, row: Row) -> Operation:
    """FASTAUXSELECT, -LATCHEDGE, -LATCHMODE, and -LATCHDISTANCE in the encoder's units."""
    latches, name, whole = environment.part(AuxLatches), _setting(row), row.unit != "number"

    def read(channel: int) -> float:
        value: float = getattr(latches.latch(channel), name)
        return int(value) if whole else value / _per_unit(environment, row, channel)

    return read


def write_setting(environment: Environment, row: Row) -> Operation:
    """FASTAUXSELECT, -LATCHEDGE, -LATCHMODE, and -LATCHDISTANCE in the encoder's units."""
    latches, name = environment.part(AuxLatches), _setting(row)

    def write(channel: int, value: float) -> None:
        latches.latch(channel).set(name, value * abs(_per_unit(environment, row, channel)))

    return write


def write_enable(environment: Environment, row: Row) -> Operation:
    latch = environment.part(AuxLatches).latch
    return lambda channel, armed: latch(channel).arm(bool(armed))


def read_caught(environment: Environment, row: Row) -> Operation:
    latch = environment.part(AuxLatches).latch
    return lambda channel: int(latch(channel).read())


def read_encoder(environment: Environment, row: Row) -> Operation:
    """FASTAUXENCODER: what the encoder would show at the counts that were caught."""
    latch, encoders = environment.part(AuxLatches).latch, environment.part(AuxEncoders)
    return lambda channel: encoders.shown(channel, latch(channel).value)


# ---------------------------------------------------------------------------------------------- index marks

ONCE, AGAIN = 0, 1


class Index:
    """The index marks of one encoder: whether one was passed since that was asked last, and a latch at the next one."""

    def __init__(self, environment: Environment, track: Axis, physical: bool) -> None:
        self._environment, self._controller, self._track = environment, environment.controller, track
        self._physical = physical
        self._cells: Cells | None = None
        self.passed = self.armed = False
        self.mode, self.place = ONCE, 0.0
        self.put()

    def put(self) -> None:
        """Look for the marks where the scale has them now."""
        if self._cells is not None:
            self._cells.remove()
            self._cells = None
        track = self._track
        pitch = track.index_pitch
        if pitch:
            origin = track.index_origin - floor(track.index_origin / pitch) * pitch
            self._cells = Cells(self._controller, track, (origin,), self._mark, pitch, self._physical)

    def take(self) -> bool:
        """Whether a mark was passed since this was asked last."""
        passed, self.passed = self.passed, False
        self._environment.acts += passed
        return passed

    def _mark(self, index: int) -> None:
        self.passed = True
        if self.armed:
            place = self._track.position(self._controller.clock.now)
            self.place = place - self._track.datum if self._physical else place
            self.armed = self.mode == AGAIN


class Indexes:
    """The index marks of the encoders of axes and of the world: they are looked for from the program's start."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        controller = environment.controller
        self._found: dict[int, Index] = {}
        for channel in [*controller.axes, *controller.encoders]:
            self.of(channel)
        controller.listeners.append(self._heard, "scale")

    def of(self, channel: int) -> Index:
        """The marks of an encoder; auxiliary ones are numbered from `AUXILIARY` on."""
        if channel not in self._found:
            controller = self._environment.controller
            of_axis = channel in controller.axes and channel not in controller.encoders
            track = controller.axes[channel] if of_axis else controller.encoder(channel)
            self._found[channel] = Index(self._environment, track, of_axis)
        return self._found[channel]

    def _heard(self, what: str, axis: int) -> None:
        if what == "scale" and axis in self._found:
            self._found[axis].put()


def _aux(channel: int) -> int:
    return AUXILIARY + _channel(channel)


def read_passed(environment: Environment, row: Row) -> Operation:
    """ENCODERZLATCH."""
    indexes = environment.part(Indexes)
    return lambda channel: int(indexes.of(channel_of(environment, channel)).take())


def read_aux_passed(environment: Environment, row: Row) -> Operation:
    """AUXENCODERZLATCH."""
    indexes = environment.part(Indexes)
    return lambda channel: int(indexes.of(_aux(channel)).take())


def write_zero_enable(environment: Environment, row: Row) -> Operation:
    """AUXENCODERZEROENABLE: the next index mark is caught."""
    indexes = environment.part(Indexes)

    def write(channel: int, armed: int) -> None:
        indexes.of(_aux(channel)).armed = bool(armed)

    return write


def read_zero_mode(environment: Environment, row: Row) -> Operation:
    indexes = environment.part(Indexes)
    return lambda channel: indexes.of(_aux(channel)).mode


def write_zero_mode(environment: Environment, row: Row) -> Operation:
    """AUXENCODERZEROLATCHMODE."""
    indexes = environment.part(Indexes)

    def write(channel: int, mode: int) -> None:
        indexes.of(_aux(channel)).mode = mode

    return write


def read_zero_place(environment: Environment, row: Row) -> Operation:
    """AUXENCODERZEROPOSITION: what the encoder would show at the mark that was caught."""
    indexes, encoders = environment.part(Indexes), environment.part(AuxEncoders)
    return lambda channel: encoders.shown(channel, indexes.of(_aux(channel)).place)


OPERATIONS = {
    "auxiliary_latches.setting": {"read": read_setting, "write": write_setting},
    "auxiliary_latches.enable": {"write": write_enable},
    "auxiliary_latches.caught": {"read": read_caught},
    "auxiliary_latches.encoder": {"read": read_encoder},
    "auxiliary_latches.passed": {"read": read_passed},
    "auxiliary_latches.aux_passed": {"read": read_aux_passed},
    "auxiliary_latches.zero_enable": {"write": write_zero_enable},
    "auxiliary_latches.zero_mode": {"read": read_zero_mode, "write": write_zero_mode},
    "auxiliary_latches.zero_place": {"read": read_zero_place},
}
