"""Latches of auxiliary encoders that inputs trigger, and index marks of encoders."""

from __future__ import annotations

from math import floor

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.motion.encoder import AUXILIARY
from motionlang.kernel.controller.triggers.position_zones import Cells
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.following_auxiliary import AuxEncoders, checked_channel
from motionlang.kernel.mint.keywords.latches import FastLatches, Latch, reading_row
from motionlang.kernel.mint.keywords.sensing import channel_of
from motionlang.kernel.mint.runtime.binding import of, of_word, unchecked
from motionlang.kernel.mint.runtime.environment import Environment


class AuxLatch(Latch):
    """The fast latch of an auxiliary encoder.

    Its `axis` is the number of the encoder, and its positions are in counts.
    """

    def _position(self) -> float:
        return self._controller.encoder_position(AUXILIARY + self.axis)


class AuxLatches(FastLatches):
    """The fast latches of auxiliary encoders, created on first use.

    A latched position raises FASTIN.
    """

    kind = AuxLatch

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.encoders = environment.component(AuxEncoders)

    def checked(self, number: int) -> int:
        return checked_channel(number)

    def default(self, axis: int) -> None:
        """Do nothing on DEFAULT, which resets axes only."""


def _per_unit(latches: AuxLatches, row: Keyword, channel: int) -> float:
    """Return the counts per unit of the encoder for a distance, 1 for other settings."""
    return latches.encoders.per_unit(channel) if row.unit == "number" else 1.0


def read_setting(latches: AuxLatches, row: Keyword, channel: int) -> float:
    """Read FASTAUXSELECT, FASTAUXLATCHEDGE, FASTAUXLATCHMODE or FASTAUXLATCHDISTANCE.

    The distance is in encoder units.
    """
    value: float = getattr(latches.latch(channel), row.attribute)
    return value / _per_unit(latches, row, channel) if row.unit == "number" else int(value)


def write_setting(latches: AuxLatches, row: Keyword, channel: int, value: float) -> None:
    """Set FASTAUXSELECT, FASTAUXLATCHEDGE, FASTAUXLATCHMODE or FASTAUXLATCHDISTANCE.

    The distance is in encoder units.
    """
    latches.latch(channel).set(row.attribute, value * abs(_per_unit(latches, row, channel)))


def read_encoder(latches: AuxLatches, channel: int) -> float:
    """FASTAUXENCODER: return the encoder's reading at the latched counts."""
    return latches.encoders.shown(channel, latches.latch(channel).value)


# ---------------------------------------------------------------------------------------------- index marks

ONCE, AGAIN = 0, 1


class Index:
    """The index marks of one encoder, and a latch for the next mark.

    `passed` is True if a mark was passed since `take` was last called.
    """

    def __init__(self, environment: Environment, track: Axis, physical: bool) -> None:
        self._environment, self._controller, self._track = environment, environment.controller, track
        self._physical = physical
        self._cells: Cells | None = None
        self.passed = self.armed = False
        self.mode, self.position = ONCE, 0.0
        self.put()

    def put(self) -> None:
        """Watch for the marks at their positions in the current scale."""
        if self._cells is not None:
            self._cells.remove()
            self._cells = None
        track = self._track
        pitch = track.index_pitch
        if pitch:
            origin = track.index_origin - floor(track.index_origin / pitch) * pitch
            self._cells = Cells(track, (origin,), self._mark, pitch, self._physical)

    def take(self) -> bool:
        """Return True if a mark was passed since the last call."""
        passed, self.passed = self.passed, False
        self._environment.acts += passed
        return passed

    def _mark(self, index: int) -> None:
        self.passed = True
        if self.armed:
            position = self._track.here(self._controller.clock.now)
            self.position = position - self._track.datum if self._physical else position
            self.armed = self.mode == AGAIN


class Indexes:
    """The index marks of the encoders of axes and of the machine file.

    They are watched from the start of the program.
    """

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        controller = environment.controller
        self._found: dict[int, Index] = {}
        for channel in [*controller.axes, *controller.encoders]:
            self.of(channel)
        controller.listeners.append(self._on_event, "scale")

    def of(self, channel: int) -> Index:
        """Return the index marks of an encoder; auxiliary encoders start at `AUXILIARY`."""
        if channel not in self._found:
            controller = self.environment.controller
            of_axis = channel in controller.axes and channel not in controller.encoders
            track = controller.axes[channel] if of_axis else controller.encoder(channel)
            self._found[channel] = Index(self.environment, track, of_axis)
        return self._found[channel]

    def of_aux(self, channel: int) -> Index:
        return self.of(AUXILIARY + checked_channel(channel))

    def _on_event(self, what: str, axis: int) -> None:
        if what == "scale" and axis in self._found:
            self._found[axis].put()


def _passed(indexes: Indexes, channel: int) -> int:
    return int(indexes.of(channel_of(indexes.environment, channel)).take())


def write_armed(indexes: Indexes, channel: int, armed: int) -> None:
    """AUXENCODERZEROENABLE: arm the latch for the next index mark."""
    indexes.of_aux(channel).armed = bool(armed)


def write_mode(indexes: Indexes, channel: int, mode: int) -> None:
    """AUXENCODERZEROLATCHMODE: latch once or at every mark."""
    indexes.of_aux(channel).mode = mode


def read_zero_position(indexes: Indexes, channel: int) -> float:
    """AUXENCODERZEROPOSITION: return the encoder's reading at the latched mark."""
    return indexes.environment.component(AuxEncoders).shown(channel, indexes.of_aux(channel).position)


# ------------------------------------------------------------------------------------------------- keywords


def _setting_of(attribute: str) -> Actions:
    return Actions(
        read=of_word(AuxLatches, read_setting), write=of_word(AuxLatches, write_setting), attribute=attribute
    )


_ENABLE = Actions(
    write=unchecked(of(AuxLatches, lambda latches, channel, armed: latches.latch(channel).arm(bool(armed))))
)
_CAUGHT = Actions(read=of(AuxLatches, lambda latches, channel: int(latches.latch(channel).read())))
# ENCODERZLATCH and AUXENCODERZLATCH.
_PASSED = Actions(read=of(Indexes, _passed))
_AUX_PASSED = Actions(read=of(Indexes, lambda indexes, channel: int(indexes.of_aux(channel).take())))
_ZERO_MODE = Actions(
    read=of(Indexes, lambda indexes, channel: indexes.of_aux(channel).mode), write=of(Indexes, write_mode)
)

_FAST = "FASTAUXSELECT(0) = 3\nFASTAUXENABLE(0) = 1\nPRINT {}(0)"
_MARK = "AUXENCODERZEROENABLE(0) = 1\nPRINT {}(0)"


def _setting(name: str, unit: str, actions: Actions, value: str, help: str, high: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "auxchannel", unit, actions, help,
                   f"{name}(0) = {value}\nPRINT {name}(0)", default=0.0, low=0, high=high, group="latches")  # fmt: skip


def _enable(name: str, actions: Actions, help: str, example: str) -> Keyword:
    return Keyword(name, "", "setting", "W", "auxchannel", "bool", actions, help, example,
                   low=0, high=1, group="latches")  # fmt: skip


ROWS = (
    _setting("FASTAUXSELECT", "integer", _setting_of("input"), "3",
             "The input that triggers the latch of an auxiliary encoder.", 999),
    _enable("FASTAUXENABLE", _ENABLE, "Arm the latch of an auxiliary encoder; it forgets what it had caught.",
            _FAST.format("FASTAUXLATCH")),
    _setting("FASTAUXLATCHEDGE", "bool", _setting_of("edge"), "1",
             "0: the input triggers when it becomes active; 1: inactive.", 1),
    _setting("FASTAUXLATCHMODE", "integer", _setting_of("again"),
             "1", "0: the latch catches once; 1: it stays armed.", 1),
    _setting("FASTAUXLATCHDISTANCE", "number", _setting_of("inhibit_distance"), "5",
             "Distance from the last latched position within which edges are ignored.", 8388607.0),
    reading_row("FASTAUXLATCH", "auxchannel", "bool", _CAUGHT,
                "1 when the latch of an auxiliary encoder has caught.",
                _FAST),
    reading_row("FASTAUXENCODER", "auxchannel", "number", Actions(read=of(AuxLatches, read_encoder)),
                "AUXENCODER at the moment of its latch.",
                _FAST),
    reading_row("ENCODERZLATCH", "channel", "bool", _PASSED,
                "1 when an encoder has passed an index mark since this was read last.",
                "MOVER(0) = 100\nGO(0)\nPRINT ENCODERZLATCH(0)"),
    reading_row("AUXENCODERZLATCH", "auxchannel", "bool", _AUX_PASSED,
                "1 when an auxiliary encoder has passed an index mark since this was read last.", _MARK, short="aez"),
    _enable("AUXENCODERZEROENABLE", Actions(write=of(Indexes, write_armed)),
            "Catch the position of an auxiliary encoder at its next index mark.",
            _MARK.format("AUXENCODERZEROPOSITION")),
    _setting("AUXENCODERZEROLATCHMODE", "integer", _ZERO_MODE, "1",
             "0: AUXENCODERZEROENABLE is for one mark; 1: for every one from then on.", 1),
    reading_row("AUXENCODERZEROPOSITION", "auxchannel", "number", Actions(read=of(Indexes, read_zero_position)),
                "AUXENCODER at the index mark.", _MARK),
)  # fmt: skip
