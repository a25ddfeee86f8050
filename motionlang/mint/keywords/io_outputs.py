"""Digital outputs, in banks of 32, and analogue channels in percent."""

from __future__ import annotations

from motionlang.mint.keywords.defaults import ANALOGUE
from motionlang.mint.keywords.io_inputs import BANK, LAST_CHANNEL, bits_of, checked
from motionlang.mint.runtime.binding import of, of_word
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row

LAST_BANK = LAST_CHANNEL // BANK


def read_bank(environment: Environment, row: Row) -> Operation:
    outputs = environment.controller.outputs
    return lambda bank: bits_of(bank, outputs.__getitem__)


@repeatable
def write_bank(environment: Environment, row: Row) -> Operation:
    outputs = environment.controller.outputs
    return lambda bank, bits: outputs.set_bank(checked(bank, LAST_BANK, "bank") * BANK, BANK, bits)


def read_bit(environment: Environment, row: Row) -> Operation:
    output = environment.controller.output
    return lambda channel: int(output(checked(channel, LAST_CHANNEL, "output")) != 0)


@repeatable
def write_bit(environment: Environment, row: Row) -> Operation:
    set_output = environment.controller.set_output
    return lambda channel, value: set_output(checked(channel, LAST_CHANNEL, "output"), int(value != 0))


def write_active_level(environment: Environment, bank: int, bits: int) -> None:
    """OUTPUTACTIVELEVEL: a bit of 0 makes an output of the bank active low."""
    outputs = environment.controller.outputs
    first = checked(bank, LAST_BANK, "bank") * BANK
    low = {first + k for k in range(BANK) if not bits >> k & 1}
    outputs.set_active_low((outputs.active_low - set(range(first, first + BANK))) | low)


def read_active_level(environment: Environment, bank: int) -> int:
    outputs = environment.controller.outputs
    return bits_of(bank, lambda channel: channel not in outputs.active_low)


# ------------------------------------------------------------------------------------------------- analogue

LAST_ANALOGUE = 63


class Analogue:
    """The settings of the analogue inputs, by keyword and channel."""

    def __init__(self, environment: Environment) -> None:
        self._inputs = environment.controller.analogue_inputs
        self._settings: dict[tuple[str, int], float] = {}

    def setting(self, name: str, channel: int) -> float:
        return self._settings.get((name, channel), ANALOGUE[name])

    def set(self, name: str, channel: int, value: float) -> None:
        self._settings[name, channel] = value

    def read(self, channel: int) -> float:
        """Percent: the input times the gain plus the offset, without the dead band, within the range."""
        return self.shown(channel, float(self._inputs[channel]))

    def shown(self, channel: int, level: float) -> float:
        """The same of any level of the input."""
        value = level * self.setting("ADCGAIN", channel) / 100.0
        value += self.setting("ADCOFFSET", channel)
        if abs(value - self.setting("ADCDEADBANDOFFSET", channel)) < self.setting("ADCDEADBAND", channel):
            value = self.setting("ADCDEADBANDOFFSET", channel)
        lowest, highest = self.range(channel)
        return max(lowest, min(highest, value))

    def range(self, channel: int) -> tuple[float, float]:
        """The lowest and the highest value of an input, percent."""
        return (0.0 if self.setting("ADCMODE", channel) else -100.0), 100.0


def analogue_input(channel: int) -> int:
    return checked(channel, LAST_ANALOGUE, "analogue input")


def analogue_output(channel: int) -> int:
    return checked(channel, LAST_ANALOGUE, "analogue output")


def write_adc_setting(analogue: Analogue, row: Row, channel: int, value: float) -> None:
    """ADCGAIN, ADCOFFSET and the like, percent, and ADCMODE."""
    analogue.set(row.name, analogue_input(channel), value)


def write_dac(environment: Environment, channel: int, value: float) -> None:
    """DAC, percent."""
    environment.controller.set_analogue_output(analogue_output(channel), value)


OPERATIONS = {
    "io.outputs.bank": {"read": read_bank, "write": write_bank},
    "io.outputs.bit": {"read": read_bit, "write": write_bit},
    "io.outputs.active_level": {
        "read": of(Environment, read_active_level),
        "write": of(Environment, write_active_level),
    },
    "io.outputs.adc": {
        "read": of(Analogue, lambda analogue, channel: analogue.read(analogue_input(channel)))
    },
    "io.outputs.adc_setting": {
        "read": of_word(
            Analogue, lambda analogue, row, channel: analogue.setting(row.name, analogue_input(channel))
        ),
        "write": of_word(Analogue, write_adc_setting),
    },
    "io.outputs.dac": {
        "read": of(
            Environment, lambda e, channel: float(e.controller.analogue_outputs[analogue_output(channel)])
        ),
        "write": repeatable(of(Environment, write_dac)),
    },
}
