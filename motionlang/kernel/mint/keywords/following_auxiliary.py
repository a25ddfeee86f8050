"""Auxiliary encoders, driven by the machine file's `[[encoder]]` or virtual.

A virtual encoder runs at AUXENCODERSPEED.
"""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.motion.encoder import AUXILIARY
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.io_inputs import checked
from motionlang.kernel.mint.keywords.latches import BY_INDEX, Latch
from motionlang.kernel.mint.keywords.sensing import (
    Encoders,
    compared,
    read_setting,
    read_speed,
    write_encoder,
    write_setting,
)
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.changes import moving
from motionlang.kernel.mint.runtime.environment import Environment

LAST_ENCODER = 63
# The AUXENCODERMODE of a virtual axis.
VIRTUAL = 8


class AuxEncoders(Encoders):
    """The auxiliary encoders, which belong to no axis."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.machine = environment.machine
        self.modes: dict[int, int] = {}
        self._speeds: dict[int, float] = {}

    def checked(self, channel: int) -> int:
        return checked_channel(channel)

    def track(self, channel: int) -> int:
        return AUXILIARY + channel

    def counts(self, channel: int) -> float:
        return self._controller.encoder_position(AUXILIARY + channel)

    def velocity(self, channel: int) -> float:
        return self._controller.encoder_velocity(AUXILIARY + channel)

    def virtual_speed(self, channel: int) -> float:
        """Return the speed set for an encoder as a virtual axis, in encoder units/s."""
        return self._speeds.get(channel, 0.0)

    def set_speed(self, channel: int, speed: float) -> None:
        """Set the speed of an encoder in its units; a virtual one changes speed at once."""
        self._speeds[channel] = speed
        if self.modes.get(channel) == VIRTUAL:
            self._controller.drive_encoder(AUXILIARY + channel, speed * self.per_unit(channel))

    def set_mode(self, channel: int, mode: int) -> None:
        """Make an encoder a virtual axis; any other mode ends that and stops it."""
        before = self.modes.get(channel, 0)
        self.modes[channel] = mode
        if mode == VIRTUAL:
            self.set_speed(channel, self.virtual_speed(channel))
        elif before == VIRTUAL:
            self._controller.drive_encoder(AUXILIARY + channel, 0.0)


class IndexMarks(Latch):
    """A latch that stays armed for the index marks of an auxiliary encoder."""

    def __init__(self, environment: Environment, channel: int) -> None:
        super().__init__(environment, channel, lambda _: None)
        self.trigger_mode, self.again = BY_INDEX, 1
        self.arm(True)

    @property
    def track(self) -> Axis:
        return self._controller.encoder(self.axis)


class Marks:
    """The index marks of the machine file's auxiliary encoders, watched from the start of the program."""

    def __init__(self, environment: Environment) -> None:
        encoders = environment.controller.encoders
        self.latches = {each: IndexMarks(environment, each) for each in encoders if each >= AUXILIARY}


def checked_channel(channel: int) -> int:
    """Return the number of an auxiliary encoder; raise Rejected if there is none."""
    return checked(channel, LAST_ENCODER, "auxiliary encoder")


# ----------------------------------------------------------------------------------------------- operations


def write_mode(encoders: AuxEncoders, row: Keyword, channel: int, mode: int) -> None:
    """AUXENCODERMODE: 8 makes the encoder a virtual axis.

    Any other mode has no effect, which the report states.
    """
    encoders.set_mode(checked_channel(channel), mode)
    if mode not in (0, VIRTUAL):
        encoders.machine.without_effect.setdefault(row.name, [])


def read_mark(marks: Marks, channel: int) -> int:
    """AUXENCODERZLATCH: return 1 if a mark was passed since this was read last."""
    found = marks.latches.get(AUXILIARY + checked_channel(channel))
    return int(found is not None and found.read())


# ------------------------------------------------------------------------------------------------- keywords

_SPEED = Actions(
    read=of(AuxEncoders, lambda encoders, channel: encoders.virtual_speed(checked_channel(channel))),
    write=of(
        AuxEncoders, lambda encoders, channel, speed: encoders.set_speed(checked_channel(channel), speed)
    ),
)
_MODE = Actions(
    read=of(AuxEncoders, lambda encoders, channel: encoders.modes.get(checked_channel(channel), 0)),
    write=of_word(AuxEncoders, write_mode),
)
_SETTING = Actions(read=of_word(AuxEncoders, read_setting), write=of_word(AuxEncoders, write_setting))

_MAX_VALUE = 8388607.0


ROWS = (
    Keyword("AUXENCODER", "", "setting", "RW", "auxchannel", "number",
            Actions(read=compared(AuxEncoders), write=of(AuxEncoders, write_encoder)),
            "Value of an auxiliary encoder, in units of AUXENCODERSCALE.",
            "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 100\nWAIT = 500\nPRINT AUXENCODER(0)",
            default=0.0, group="encoders", driven="encoder", solved=True),
    Keyword("AUXENCODERVEL", "", "reading", "R", "auxchannel", "number",
            Actions(read=moving(of(AuxEncoders, read_speed))),
            "Speed of an auxiliary encoder, in units of AUXENCODERSCALE a second.",
            "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 100\nPRINT AUXENCODERVEL(0)", default=0.0, group="encoders"),
    Keyword("AUXENCODERMODE", "", "setting", "RW", "auxchannel", "integer", _MODE,
            "8: the auxiliary encoder is a virtual axis, which runs at AUXENCODERSPEED. Other values have no effect.",
            "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 100\nWAIT = 500\nPRINT AUXENCODER(0)",
            default=0.0, low=0.0, high=2147483647.0, group="encoders"),
    Keyword("AUXENCODERSPEED", "", "setting", "RW", "auxchannel", "number", _SPEED,
            "The speed at which an auxiliary encoder of AUXENCODERMODE 8 counts by itself: a master without a machine.",
            "AUXENCODERMODE(0) = 8 : AUXENCODERSPEED(0) = 100\nWAIT = 500\nPRINT AUXENCODER(0)",
            default=0.0, low=-_MAX_VALUE, high=_MAX_VALUE, group="encoders"),
    *(
        Keyword(f"AUX{name}", "", "setting", "RW", "auxchannel", unit, _SETTING, help,
                f"AUX{name}(0) = 4\nPRINT AUX{name}(0)", default=default, low=low, high=_MAX_VALUE, group="encoders")
        for name, unit, help, default, low in (
            ("ENCODERSCALE", "number", "Counts of an auxiliary encoder in one of its units.", 1.0, 1e-6),
            ("ENCODERPRESCALE", "integer", "Prescaler of an auxiliary encoder, which divides its counts.", 1.0, 1),
            ("ENCODERWRAP", "number", "The range in which AUXENCODER counts, from 0 on; 0 for no end.", 0.0, 0),
        )
    ),
    Keyword("AUXENCODERZLATCH", "aez", "reading", "R", "auxchannel", "bool", Actions(read=of(Marks, read_mark)),
            "1 when an auxiliary encoder has passed an index mark since this was read last.",
            "PRINT AUXENCODERZLATCH(0)", default=0.0, group="latches"),
)  # fmt: skip
