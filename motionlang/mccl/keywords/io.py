"""Digital and analogue channels."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("input and output")
_row = _G.row

ROWS = (
    _row("CN", "command", "W", "none", "number", "channel_on", "Switch an output channel on.", "CT9,CN9", low=1,
         high=255),
    _row("CF", "command", "W", "none", "number", "channel_off", "Switch an output channel off.", "CT9,CF9", low=1,
         high=255),
    _row("CI", "command", "W", "none", "number", "channel_input", "Make the channel an input.", "CI1", low=1,
         high=255),
    _row("CT", "command", "W", "none", "number", "channel_output", "Make the channel an output.", "CT9", low=1,
         high=255),
    _row("CH", "command", "W", "none", "number", "channel_high", "High level means on.", "CH1", low=1, high=255),
    _row("CL", "command", "W", "none", "number", "channel_low", "Low level means on.", "CL1", low=1, high=255),
    _row("DN", "command", "W", "none", "number", "do_if_on",
         "Carry out the rest of the line only if the channel is on.",
         "DN1,1TP", low=1, high=255),
    _row("DF", "command", "W", "none", "number", "do_if_off",
         "Carry out the rest of the line only if the channel is off.", "DF1,1TP", low=1, high=255),
    _row("IN", "command", "W", "none", "number", "if_on",
         "If the channel is on carry out the next two commands, else skip them.", "IN1,AL1,NO", low=1, high=255),
    _row("IF", "command", "W", "none", "number", "if_off",
         "If the channel is off carry out the next two commands, else skip them.", "IF1,AL1,NO", low=1, high=255),
    _row("WN", "command", "W", "none", "number", "wait_on", "Wait until the channel is on.", "CT9,CN9,WN9",
         low=1, high=255),
    _row("WF", "command", "W", "none", "number", "wait_off", "Wait until the channel is off.", "WF1", low=1,
         high=255),
    _row("GA", "command", "W", "none", "number", "get_analog", "Get an analogue input into the accumulator, volts.",
         "GA1,TR0", low=1, high=255),
    _row("OA", "command", "W", "none", "number", "set_analog",
         "Put the accumulator out on an analogue channel, volts.",
         "AL5,OA1", low=1, high=255),
)  # fmt: skip
