"""Data capture."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

# The quantities in their order, `motionlang.mint.keywords.captures_quantities.NAMES` in few words.
QUANTITIES = (
    "0 nothing, 1 measured position, 2 measured velocity, 3 demand position, 4 demand velocity, 5 demand acceleration, "
    "6 following error, 7 drive output in percent, 8 torque of the motor in N m, 9 encoder, 10 auxiliary encoder, "
    "11 analogue input, 12 analogue output, 13 bank of digital inputs, 14 bank of digital outputs"
)
_RUN = (
    "CAPTUREMODE(0) = 3\nCAPTURENUMPOINTS = 11\nCAPTURE = 1\nMOVER(0) = 100\nGO(0)\nPAUSE CAPTURESTATUS = 3\n"
    "PRINT {}"
)


def _word(
    name: str, short: str, access: str, index: str, unit: str, verb: str, help: str, example: str,
    default: float = 0.0, low: float | None = None, high: float | None = None,
) -> Keyword:  # fmt: skip
    kind = "reading" if access == "R" else "setting"
    return Keyword(name, short, kind, access, index, unit, f"captures.{verb}", help, example, default=default,
                   low=low, high=high, group="capture")  # fmt: skip


def _channel(
    name: str, short: str, verb: str, index: str, unit: str, help: str, high: float, low: float = 0
) -> Keyword:
    return _word(
        name, short, "RW", index, unit, verb, help, f"{name}(0) = 1\nPRINT {name}(0)", 0.0, low, high
    )


ROWS = (
    _channel("CAPTUREMODE", "cpm", "channel.mode", "channel", "integer",
             f"What a channel of the capture records: {QUANTITIES}.", 14),
    _channel("CAPTUREAXIS", "", "channel.axis", "channel", "integer", "The axis whose quantity a channel records.", 63),
    _channel("CAPTUREMODEPARAMETER", "cpmp", "channel.parameter", "channel", "integer",
             "The encoder, the analogue channel or the bank that a channel records.", 999),
    Keyword("CAPTUREMODENAME", "", "reading", "R", "channel", "text", "captures.name",
            "What a channel of the capture records, in words.", "CAPTUREMODE(0) = 3\nPRINT CAPTUREMODENAME(0)",
            group="capture"),
    _word("CAPTURENUMPOINTS", "", "RW", "none", "integer", "points", "How many points a channel records, 1 to 100000.",
          "CAPTURENUMPOINTS = 100\nPRINT CAPTURENUMPOINTS", 1000.0),
    _word("CAPTUREINTERVAL", "cpi", "RW", "none", "integer", "spacing", "Servo ticks (LOOPTIME) from point to point.",
          "CAPTUREINTERVAL = 2\nPRINT CAPTUREPERIOD", 1.0, 1, 2147483647),
    _word("CAPTUREPERIOD", "cpp", "RW", "none", "integer", "spacing", "Microseconds from point to point.",
          "CAPTUREPERIOD = 500\nPRINT CAPTUREDURATION", 1000.0, 1, 2147483647),
    _word("CAPTUREDURATION", "cpr", "RW", "none", "ms", "spacing",
          "The length of a capture; its points are this divided by their number apart.",
          "CAPTUREDURATION = 500\nPRINT CAPTUREPERIOD", 1000.0, 1, 2147483647.0),
    _word("CAPTUREPRETRIGGERDURATION", "", "RW", "none", "ms", "before",
          "For how long before its trigger a capture has recorded already; until then no trigger counts.",
          "CAPTUREPRETRIGGERDURATION = 50\nPRINT CAPTUREPRETRIGGERDURATION", 0.0, 0, 2147483647.0),
    _channel("CAPTURETRIGGERMODE", "", "trigger.mode", "trigger", "integer",
             "What triggers a capture: 0 nothing, 1 the source rising through the value, 2 falling, 3 either.", 3),
    _channel("CAPTURETRIGGERSOURCE", "", "trigger.source", "trigger", "integer",
             "The quantity that triggers a capture, numbered as in CAPTUREMODE; of digital channels a single one.", 14),
    _channel("CAPTURETRIGGERCHANNEL", "", "trigger.channel", "trigger", "integer",
             "The axis, the encoder or the channel whose quantity triggers a capture.", 999),
    _channel("CAPTURETRIGGERVALUE", "", "trigger.value", "trigger", "number",
             "The value that the source must pass.", 8388607.0, -8388607.0),
    _channel("CAPTURETRIGGERABSOLUTE", "", "trigger.absolute", "trigger", "bool",
             "1: the source counts without its sign.", 1),
    Keyword("CAPTURETRIGGER", "", "command", "C", "none", "", "captures.trigger",
            "Trigger the capture that waits.",
            "CAPTURETRIGGERMODE(0) = 1\nCAPTURETRIGGERSOURCE(0) = 13\nCAPTURECOMMAND = 1\nCAPTURETRIGGER\n"
            "PRINT CAPTURESTATUS", group="capture"),
    _word("CAPTURE", "", "RW", "none", "bool", "running",
          "1 begins a capture at once, 0 ends it; 1 while one is running.",
          _RUN.format("CAPTURE"), 0.0, 0, 1),
    _word("CAPTURECOMMAND", "", "RW", "none", "integer", "running",
          "1 begins a capture, which waits for its triggers where any is set; 0 ends it.",
          _RUN.replace("CAPTURE = 1", "CAPTURECOMMAND = 1").format("CAPTURECOMMAND"), 0.0, 0, 1),
    _word("CAPTURESTATUS", "", "R", "none", "integer", "status",
          "0 no capture, 1 it waits for its trigger, 2 it records, 3 it is done.", _RUN.format("CAPTURESTATUS")),
    _word("CAPTUREPROGRESS", "", "R", "part", "integer", "progress",
          "How many percent are recorded: part 0 of what is before the trigger, 1 of what follows it.",
          _RUN.format("CAPTUREPROGRESS(1)")),
    _word("CAPTUREPOINT", "", "R", "channel, point", "number", "point", "A point of a channel, counted from 0.",
          _RUN.format("CAPTUREPOINT(0, 10)")),
)  # fmt: skip
