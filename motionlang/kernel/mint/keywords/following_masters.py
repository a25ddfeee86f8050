"""Masters, selected by MASTERSOURCE and MASTERCHANNEL, and settings of following."""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.motion.encoder import AUXILIARY
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.following_auxiliary import AuxEncoders
from motionlang.kernel.mint.keywords.io_inputs import checked
from motionlang.kernel.mint.keywords.sensing import Encoders
from motionlang.kernel.mint.runtime.binding import axis_of
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

AXIS, ENCODER, AUX_ENCODER = range(3)
LAST_ENCODER = 63
# Settings with a default other than 0.
DEFAULTS = {
    "FOLLOWNUMERATOR": 1.0,
    "FOLLOWDENOM": 1.0,
    "GEARING": 100.0,
    "CAMAMPLITUDE": 1.0,
    "CAMSTART": 1.0,
}


@dataclass(eq=False, slots=True)
class Master:
    """An axis or encoder that axes can follow.

    It has a track, a number in the controller, and its counts per unit.
    """

    track: Axis
    number: int
    encoder: bool
    per_unit: float

    def refuse(self, environment: Environment, axis: int) -> None:
        """Raise Rejected if the axis would follow itself."""
        if self.track is environment.controller.axes[axis]:
            words = f"axis {axis} cannot follow axis {self.number}: it would follow itself"
            raise Rejected("axis", words, f"write MASTERCHANNEL({axis}) first")

    def to_counts(self, position: float) -> float:
        """Convert a position from units of the master to counts."""
        return position * self.per_unit


def master(environment: Environment, source: int, channel: int) -> Master:
    """Return the master for a source and a channel; raise Rejected if there is none."""
    controller = environment.controller
    if source == AXIS:
        a = controller.axes[axis_of(environment, channel)]
        return Master(a, channel, False, a.scale.counts)
    checked(channel, LAST_ENCODER, "encoder")
    if source == AUX_ENCODER:
        number, per_unit = AUXILIARY + channel, environment.component(AuxEncoders).per_unit(channel)
        return Master(controller.encoder(number), number, True, per_unit)
    per_unit = environment.component(Encoders).per_unit(channel)
    if channel in controller.axes and channel not in controller.encoders:
        return Master(controller.axes[channel], channel, False, per_unit)
    return Master(controller.encoder(channel), channel, True, per_unit)


class Masters(StoredSettings):
    """The settings of following, by keyword and axis, and the ratios in force."""

    defaults = DEFAULTS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.ratios: dict[int, float] = {}

    def set(self, name: str, axis: int, value: float) -> None:
        """Set the master of an axis, or how it follows.

        A GEARINGMODE has no effect, which the report states.
        """
        super().set(name, axis, value)
        if name == "GEARINGMODE" and value:  # no source says how it corrects a lag
            self.environment.machine.without_effect.setdefault(name, [])

    def of(self, axis: int) -> Master:
        """Return the master of an axis."""
        return master(
            self.environment,
            int(self.setting("MASTERSOURCE", axis)),
            int(self.setting("MASTERCHANNEL", axis)),
        )

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        super().default(axis)
        self.ratios.pop(axis, None)


def distance(environment: Environment, axis: int, word: str) -> tuple[Master, float]:
    """Return the master of an axis, and its MASTERDISTANCE in counts.

    Raises Rejected, with the keyword `word`, if MASTERDISTANCE is not set.
    """
    masters = environment.component(Masters)
    over = masters.setting("MASTERDISTANCE", axis)
    if not over:
        raise Rejected(
            "range", f"{word} needs the distance of the master", f"write MASTERDISTANCE({axis}) first"
        )
    found = masters.of(axis)
    return found, over * found.per_unit


# ------------------------------------------------------------------------------------------------- keywords

MASTER_SETTING = Actions(read=setting_reader(Masters), write=repeatable(setting_writer(Masters)))

_MAX_VALUE = 8388607.0


def _setting(
    name: str, short: str, unit: str, help: str, default: float, low: float, high: float, family: str = ""
) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, MASTER_SETTING, help,
                   f"{name}(1) = 1\nPRINT {name}(1)", default=default, low=low, high=high,
                   group="following", family=family)  # fmt: skip


ROWS = (
    _setting("MASTERSOURCE", "", "integer",
             "Type of MASTERCHANNEL: _msPOS an axis, _msENCODER an encoder, _msAUXENCODER an auxiliary "
             "encoder.",
             0.0, 0, 2),
    _setting("MASTERCHANNEL", "", "integer", "The axis or encoder that the axis follows.", 0.0, 0, 63),
    _setting("MASTERDISTANCE", "", "number",
             "Distance of the master, in its own units, in a FLY or a cam segment; negative for reverse.",
             0.0, -_MAX_VALUE, _MAX_VALUE),
    _setting("FOLLOWMODE", "", "integer",
             "Start of FOLLOW: 0 at the master's speed at once, 1 with ramps at ACCEL and DECEL.", 0.0, 0, 1),
    _setting("GEARING", "GR", "%",
             "Percent of the slave's lag that GEARINGMODE corrects. Without a simulated motor there is no lag.",
             100.0, -_MAX_VALUE, _MAX_VALUE, "gearing"),
    _setting("GEARINGMODE", "GRM", "integer", "1: the slave's lag behind its master is corrected, see GEARING.",
             0.0, 0, 1),
    _setting("OFFSETDISTANCE", "", "number",
             "Distance of the master, in its own units, during an OFFSET of mode 2 or 3.",
             0.0, -_MAX_VALUE, _MAX_VALUE),
)  # fmt: skip
