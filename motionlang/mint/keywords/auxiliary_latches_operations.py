"""Latches of auxiliary encoders, at an edge of an input, and the index marks of encoders."""

from __future__ import annotations

from math import floor

from motionlang.controller.io.encoder import AUXILIARY
from motionlang.controller.triggers.position_zones import Cells
from motionlang.mint.keywords.following_auxiliary import AuxEncoders, _channel
from motionlang.mint.keywords.latches_operations import SETTINGS, FastLatches, Latch
from motionlang.mint.keywords.sensing_operations import channel_of
from motionlang.mint.runtime.binding import of, of_word, unchecked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment


class AuxLatch(Latch):
    """The fast latch of an auxiliary encoder, whose number is its `axis`; what it catches are counts."""

    def _place(self) -> float:
        return self._controller.encoder_position(AUXILIARY + self.axis)


class AuxLatches(FastLatches):
    """The fast latch of every auxiliary encoder, from its first use on; a catch raises FASTIN."""

    kind = AuxLatch

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.encoders = environment.part(AuxEncoders)

    def checked(self, number: int) -> int:
        return _channel(number)

    def default(self, axis: int) -> None:
        """DEFAULT: they are no axis's."""


def _per_unit(latches: AuxLatches, row: Row, channel: int) -> float:
    """Counts in one unit of what the encoder shows, for distances."""
    return latches.encoders.per_unit(channel) if row.unit == "number" else 1.0


def read_setting(latches: AuxLatches, row: Row, channel: int) -> float:
    """FASTAUXSELECT, -LATCHEDGE, -LATCHMODE, and -LATCHDISTANCE in the encoder's units."""
    value: float = getattr(latches.latch(channel), row.attribute)
    return value / _per_unit(latches, row, channel) if row.unit == "number" else int(value)


def write_setting(latches: AuxLatches, row: Row, channel: int, value: float) -> None:
    """FASTAUXSELECT, -LATCHEDGE, -LATCHMODE, and -LATCHDISTANCE in the encoder's units."""
    latches.latch(channel).set(row.attribute, value * abs(_per_unit(latches, row, channel)))


def read_encoder(latches: AuxLatches, channel: int) -> float:
    """FASTAUXENCODER: what the encoder would show at the counts that were caught."""
    return latches.encoders.shown(channel, latches.latch(channel).value)


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
            place = self._track.here(self._controller.clock.now)
            self.place = place - self._track.datum if self._physical else place
            self.armed = self.mode == AGAIN


class Indexes:
    """The index marks of the encoders of axes and of the world: they are looked for from the program's start."""

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        controller = environment.controller
        self._found: dict[int, Index] = {}
        for channel in [*controller.axes, *controller.encoders]:
            self.of(channel)
        controller.listeners.append(self._heard, "scale")

    def of(self, channel: int) -> Index:
        """The marks of an encoder; auxiliary ones are numbered from `AUXILIARY` on."""
        if channel not in self._found:
            controller = self.environment.controller
            of_axis = channel in controller.axes and channel not in controller.encoders
            track = controller.axes[channel] if of_axis else controller.encoder(channel)
            self._found[channel] = Index(self.environment, track, of_axis)
        return self._found[channel]

    def of_aux(self, channel: int) -> Index:
        return self.of(AUXILIARY + _channel(channel))

    def _heard(self, what: str, axis: int) -> None:
        if what == "scale" and axis in self._found:
            self._found[axis].put()


def _passed(indexes: Indexes, channel: int) -> int:
    return int(indexes.of(channel_of(indexes.environment, channel)).take())


def write_armed(indexes: Indexes, channel: int, armed: int) -> None:
    """AUXENCODERZEROENABLE: the next index mark is caught."""
    indexes.of_aux(channel).armed = bool(armed)


def write_mode(indexes: Indexes, channel: int, mode: int) -> None:
    """AUXENCODERZEROLATCHMODE."""
    indexes.of_aux(channel).mode = mode


def read_place(indexes: Indexes, channel: int) -> float:
    """AUXENCODERZEROPOSITION: what the encoder would show at the mark that was caught."""
    return indexes.environment.part(AuxEncoders).shown(channel, indexes.of_aux(channel).place)


_SETTING = {"read": of_word(AuxLatches, read_setting), "write": of_word(AuxLatches, write_setting)}
OPERATIONS = {
    **{f"auxiliary_latches.setting.{each}": _SETTING for each in SETTINGS},
    "auxiliary_latches.enable": {
        "write": unchecked(of(AuxLatches, lambda part, channel, armed: part.latch(channel).arm(bool(armed))))
    },
    "auxiliary_latches.caught": {
        "read": of(AuxLatches, lambda latches, channel: int(latches.latch(channel).read()))
    },
    "auxiliary_latches.encoder": {"read": of(AuxLatches, read_encoder)},
    # ENCODERZLATCH and AUXENCODERZLATCH.
    "auxiliary_latches.passed": {"read": of(Indexes, _passed)},
    "auxiliary_latches.aux_passed": {
        "read": of(Indexes, lambda indexes, channel: int(indexes.of_aux(channel).take()))
    },
    "auxiliary_latches.zero_enable": {"write": of(Indexes, write_armed)},
    "auxiliary_latches.zero_mode": {
        "read": of(Indexes, lambda indexes, channel: indexes.of_aux(channel).mode),
        "write": of(Indexes, write_mode),
    },
    "auxiliary_latches.zero_place": {"read": of(Indexes, read_place)},
}
