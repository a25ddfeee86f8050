"""Digital outputs in banks of 32, and analogue channels in percent."""

from __future__ import annotations

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.lang.keyword import BANK, Actions, Keyword
from motionlang.kernel.mint.keywords.defaults import ANALOGUE
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, bits_of, checked
from motionlang.kernel.mint.runtime.binding import Operation, of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable, reported
from motionlang.kernel.mint.runtime.environment import Environment

LAST_BANK = LAST_CHANNEL // BANK


def read_bank(environment: Environment, row: Keyword) -> Operation:
    outputs = environment.controller.outputs
    return lambda bank: bits_of(bank, outputs.__getitem__)


@reported
def write_bank(environment: Environment, row: Keyword) -> Operation:
    """OUT: make the operation that writes a bank of outputs."""
    outputs = environment.controller.outputs

    def write(bank: int, bits: int) -> bool:
        return outputs.set_bank(checked(bank, LAST_BANK, "bank") * BANK, BANK, bits)

    return write


def read_bit(environment: Environment, row: Keyword) -> Operation:
    output = environment.controller.output
    return lambda channel: int(output(checked(channel, LAST_CHANNEL, "output")) != 0)


@reported
def write_bit(environment: Environment, row: Keyword) -> Operation:
    """OUTX: make the operation that writes an output."""
    set_output = environment.controller.outputs.set

    def write(channel: int, value: float) -> bool:
        if not 0 <= channel <= LAST_CHANNEL:
            checked(channel, LAST_CHANNEL, "output")
        return set_output(channel, 1 if value != 0 else 0)

    return write


def write_active_level(environment: Environment, bank: int, bits: int) -> None:
    """OUTPUTACTIVELEVEL: a 0 bit makes an output of the bank active low."""
    outputs = environment.controller.outputs
    first = checked(bank, LAST_BANK, "bank") * BANK
    low = {first + k for k in range(BANK) if not bits >> k & 1}
    outputs.set_active_low((outputs.active_low - set(range(first, first + BANK))) | low)


def read_active_level(environment: Environment, bank: int) -> int:
    outputs = environment.controller.outputs
    return bits_of(bank, lambda channel: channel not in outputs.active_low)


# ------------------------------------------------------------------------------------------------- analogue

LAST_ANALOGUE = 63
# The end of the range of an analogue input, percent.
HIGHEST = 100.0


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
        """Return an input in percent, after gain, offset and range limits."""
        return self.shown(channel, float(self._inputs[channel]))

    def until(self, channel: int, level: float | None = None) -> float:
        """Return the earliest time at which an input that follows an axis crosses a level."""
        sensor = self._inputs.computed.get(channel)
        return INFINITY if sensor is None else sensor.until(lambda value: self.shown(channel, value), level)

    def shown(self, channel: int, level: float) -> float:
        """Return the value that a level of the input would give, like `read`."""
        value = level
        if self._settings:
            value = level * self.setting("ADCGAIN", channel) / 100.0 + self.setting("ADCOFFSET", channel)
        return value if -HIGHEST < value < HIGHEST else max(-HIGHEST, min(HIGHEST, value))


def read_adc(environment: Environment, row: Keyword) -> Operation:
    """ADC: make an operation that reads an input in percent."""
    analogue, dependencies = environment.component(Analogue), environment.dependencies
    inputs = environment.controller.analogue_inputs
    inputs.compute()
    computed, shown = inputs.computed, analogue.shown

    def read(channel: int, level: float | None = None) -> float:
        if dependencies.notes is not None and channel in computed:
            dependencies.note(analogue.until, channel, level)
        if not 0 <= channel <= LAST_ANALOGUE:
            analogue_input(channel)
        return shown(channel, inputs[channel])

    return read


def analogue_input(channel: int) -> int:
    return checked(channel, LAST_ANALOGUE, "analogue input")


def analogue_output(channel: int) -> int:
    return checked(channel, LAST_ANALOGUE, "analogue output")


def write_adc_setting(analogue: Analogue, row: Keyword, channel: int, value: float) -> None:
    """ADCGAIN and ADCOFFSET: write a setting in percent."""
    analogue.set(row.name, analogue_input(channel), value)


def write_dac(environment: Environment, channel: int, value: float) -> None:
    """DAC: set an analogue output in percent."""
    environment.controller.set_analogue_output(analogue_output(channel), value)


def write_pulse(environment: Environment, channel: int, milliseconds: float) -> None:
    """PULSEOUTX: turn an output on for a time in ms."""
    environment.controller.pulse(checked(channel, LAST_CHANNEL, "output"), milliseconds / 1000.0)


# ------------------------------------------------------------------------------------------------- keywords

_ACTIVE_LEVEL = Actions(read=of(Environment, read_active_level), write=of(Environment, write_active_level))
_ADC = Actions(read=read_adc)
_ADC_SETTING = Actions(
    read=of_word(
        Analogue, lambda analogue, row, channel: analogue.setting(row.name, analogue_input(channel))
    ),
    write=of_word(Analogue, write_adc_setting),
)
_DAC = Actions(
    read=of(Environment, lambda e, channel: float(e.controller.analogue_outputs[analogue_output(channel)])),
    write=repeatable(of(Environment, write_dac)),
)


def _adc(name: str, short: str, help: str, most: float) -> Keyword:
    return Keyword(name, short, "setting", "RW", "channel", "%", _ADC_SETTING, help,
                   f"{name}(0) = 50\nPRINT {name}(0)", default=ANALOGUE[name], low=-most, high=most,
                   group="io")  # fmt: skip


ROWS = (
    Keyword("OUT", "ot", "setting", "RW", "bank", "bits", Actions(read=read_bank, write=write_bank),
            "The digital outputs of a bank as bits, bank 0 when none is given.",
            "OUT(0) = 5\nPRINT OUT(0)", default=0.0, group="io", channel="output bank"),
    Keyword("OUTX", "otx", "setting", "RW", "output", "bool", Actions(read=read_bit, write=write_bit),
            "One digital output: 1 is on.",
            "OUTX(2) = _ON\nPRINT OUTX(2)", default=0.0, group="io", meant="DOUT SETOUT"),
    Keyword("PULSEOUTX", "", "setting", "W", "channel", "ms", Actions(write=of(Environment, write_pulse)),
            "Turn an output on for some milliseconds, from now on; the program goes on meanwhile.",
            "PULSEOUTX(3) = 50\nPRINT OUTX(3)\nWAIT = 50\nPRINT OUTX(3)", low=0, high=2147483647.0, group="io",
            channel="output"),
    Keyword("OUTPUTACTIVELEVEL", "oal", "setting", "RW", "bank", "bits", _ACTIVE_LEVEL,
            "Bit pattern of the outputs whose level is high while they are on; inputs wired to them see the level.",
            "OUTPUTACTIVELEVEL(0) = 0xFFFE\nPRINT OUTPUTACTIVELEVEL(0)", default=-1.0, group="io"),
    Keyword("ADC", "", "reading", "R", "channel", "%", _ADC,
            "An analogue input in percent of its range, after gain and offset.",
            "PRINT ADC(0)", default=0.0, group="io", driven="analogue", solved=True, meant="AIN"),
    _adc("ADCGAIN", "ag", "Gain of an analogue input in percent.", 10000.0),
    _adc("ADCOFFSET", "ao", "Offset added to an analogue input, in percent of its range.", 100.0),
    Keyword("DAC", "", "setting", "RW", "channel", "%", _DAC,
            "An analogue output in percent of its range.",
            "DAC(0) = 25.5\nPRINT DAC(0)", default=0.0, low=-100.0, high=100.0, group="io", meant="AOUT",
            channel="analogue output"),
)  # fmt: skip
