"""Serial ports, character by character."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword


def _command(name: str, verb: str, help: str) -> Keyword:
    example = f"{name}(1)\nPRINT SERIALBUFFERUSAGE"
    return Keyword(name, "", "command", "C", "port", "", f"serial.{verb}", help, example, group="terminal")  # fmt: skip


ROWS = (
    Keyword("SERIALCHAR", "", "setting", "RW", "port", "integer", "serial.character",
            "Read the next character that has come in at a serial port, 0 when there is none; written, send one. "
            "Port 1 where none is given.",
            "SERIALCHAR = 65\nSERIALCHAR = 13\nPRINT SERIALCHAR",
            default=0.0, low=0, high=255, group="terminal", driven="serial"),
    Keyword("SERIALBUFFERUSAGE", "", "reading", "R", "port", "integer", "serial.waiting",
            "How many characters have come in at a serial port and were not read yet.",
            "PRINT SERIALBUFFERUSAGE", default=0.0, group="terminal"),
    _command("SERIALCLEARRECEIVEBUFFER", "forget", "Forget what has come in at a serial port and was not read."),
    _command("SERIALCLEARTRANSMITBUFFER", "nothing",
             "Forget what was not sent yet: nothing, as characters are sent at once."),
    _command("SERIALCLEARERROR", "nothing", "Clear the errors of a serial port, of which there are none here."),
)  # fmt: skip
