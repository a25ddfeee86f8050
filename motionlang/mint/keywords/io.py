"""Digital and analogue inputs and outputs."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword
from motionlang.mint.keywords.defaults import ANALOGUE, PATTERNS


def _pattern(name: str, help: str, example: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "bank", "bits", "io.inputs.pattern", help, example,
                   default=float(PATTERNS[name]), group="io")  # fmt: skip


def _adc(name: str, short: str, help: str, low: float, high: float, unit: str = "%") -> Keyword:
    value = "1" if unit == "integer" else "50"
    return Keyword(name, short, "setting", "RW", "channel", unit, "io.outputs.adc_setting", help,
                   f"{name}(0) = {value}\nPRINT {name}(0)", default=ANALOGUE[name], low=low, high=high,
                   group="io")  # fmt: skip


ROWS = (
    Keyword("IN", "", "reading", "R", "bank", "bits", "io.inputs.bank",
            "The digital inputs of a bank as bits, bank 0 when none is given; edges that are latched are read off.",
            "PRINT IN(0) & 3", default=0.0, group="io", driven="input"),
    Keyword("INX", "", "reading", "R", "input", "bool", "io.inputs.bit",
            "One digital input: 1 when it is active or, with its INPUTMODE bit set, when its edge has come.",
            "PRINT INX(3)", default=0.0, group="io", driven="input"),
    Keyword("INSTATE", "", "reading", "R", "bank", "bits", "io.inputs.level_bank",
            "The electrical levels of a bank of inputs, whatever their active level, debouncing and edges.",
            "PRINT INSTATE(0)", default=0.0, group="io", driven="input"),
    Keyword("INSTATEX", "isx", "reading", "R", "input", "bool", "io.inputs.level_bit",
            "The electrical level of one input.",
            "PRINT INSTATEX(3)", default=0.0, group="io", driven="input"),
    Keyword("INPUTACTIVELEVEL", "", "setting", "RW", "bank", "bits", "io.inputs.active_level",
            "Bit pattern of the inputs that are active while their level is high; the others are active low.",
            "INPUTACTIVELEVEL(0) = 0xFFFE\nPRINT INX(0)", default=-1.0, group="io"),
    Keyword("INPUTDEBOUNCE", "", "setting", "RW", "bank", "integer", "io.inputs.debounce",
            "How many samples of 1 ms the inputs of a bank must stay the same before their state follows.",
            "INPUTDEBOUNCE(0) = 5\nPRINT INPUTDEBOUNCE(0)", default=0.0, low=0, high=1000, group="io"),
    _pattern("INPUTMODE", "Bit pattern of the inputs that report their edges (1) instead of their state (0).",
             "INPUTMODE(0) = 8\nPRINT INX(3)"),
    _pattern("INPUTPOSTRIGGER", "Bit pattern of the inputs whose becoming active is an edge and an event.",
             "INPUTPOSTRIGGER(0) = 8\nPRINT INPUTPOSTRIGGER(0)"),
    _pattern("INPUTNEGTRIGGER", "Bit pattern of the inputs whose becoming inactive is an edge and an event.",
             "INPUTNEGTRIGGER(0) = 8\nPRINT INPUTNEGTRIGGER(0)"),
    _pattern("IMASK", "Bit pattern of the inputs that may raise an event IN0, IN1 …",
             "IMASK(0) = 8\nPRINT IMASK(0)"),
    Keyword("OUT", "ot", "setting", "RW", "bank", "bits", "io.outputs.bank",
            "The digital outputs of a bank as bits, bank 0 when none is given.",
            "OUT(0) = 5\nPRINT OUT(0)", default=0.0, group="io"),
    Keyword("OUTX", "otx", "setting", "RW", "output", "bool", "io.outputs.bit",
            "One digital output: 1 is on.",
            "OUTX(2) = _ON\nPRINT OUTX(2)", default=0.0, group="io"),
    Keyword("OUTPUTACTIVELEVEL", "oal", "setting", "RW", "bank", "bits", "io.outputs.active_level",
            "Bit pattern of the outputs whose level is high while they are on; inputs wired to them see the level.",
            "OUTPUTACTIVELEVEL(0) = 0xFFFE\nPRINT OUTPUTACTIVELEVEL(0)", default=-1.0, group="io"),
    Keyword("DRIVEENABLEOUTPUT", "deo", "setting", "RW", "axis", "integer", "io.signals.enable_output",
            "The output that is on while the drive of the axis is enabled; -1 for none.",
            "DRIVEENABLEOUTPUT(0) = 4\nPRINT OUTX(4)", default=-1.0, low=-1, high=999, group="io"),
    Keyword("GLOBALERROROUTPUT", "geo", "setting", "RW", "none", "integer", "io.signals.error_output",
            "The output that is on while any axis has an error; -1 for none.",
            "GLOBALERROROUTPUT = 5\nPRINT OUTX(5)", default=-1.0, low=-1, high=999, group="io"),
    Keyword("ADC", "", "reading", "R", "channel", "%", "io.outputs.adc",
            "An analogue input in percent of its range, after gain, offset and dead band.",
            "PRINT ADC(0)", default=0.0, group="io", driven="analogue"),
    _adc("ADCGAIN", "ag", "Gain of an analogue input in percent.", -10000.0, 10000.0),
    _adc("ADCOFFSET", "ao", "What is added to an analogue input, in percent of its range.", -100.0, 100.0),
    _adc("ADCDEADBAND", "add", "An analogue input this near to ADCDEADBANDOFFSET reads as that.", 0.0, 100.0),
    _adc("ADCDEADBANDOFFSET", "", "The middle of the dead band of an analogue input.", -100.0, 100.0),
    _adc("ADCMODE", "am", "Range of an analogue input: 0 both signs, -100 to 100; 1 positive only.", 0, 1, "integer"),
    Keyword("DAC", "", "setting", "RW", "channel", "%", "io.outputs.dac",
            "An analogue output in percent of its range.",
            "DAC(0) = 25.5\nPRINT DAC(0)", default=0.0, low=-100.0, high=100.0, group="io"),
)  # fmt: skip
