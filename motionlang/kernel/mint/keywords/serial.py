"""Serial ports: characters received from the machine file and sent by the program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.environment import Environment

LAST_PORT = 8
# The number of characters that a port stores for a program that does not read.
MAX_QUEUE = 10_000
_LINE_END = 13, 10


class Ports:
    """The unread characters of each port; new ones raise the event SERIALRECEIVE."""

    def __init__(self, environment: Environment) -> None:
        self._environment, clock = environment, environment.clock
        self._waiting: dict[int, list[int]] = {}
        self._ended = False
        entries: Sequence[Mapping[str, Any]] = environment.machine.settings.get("serial", ())  # type: ignore[assignment]
        for entry in entries:
            codes = [ord(letter) & 0xFF for letter in entry["text"]]
            clock.at(
                max(entry.get("at", 0.0), clock.now), partial(self._receive, entry.get("port", 1), codes)
            )

    def _receive(self, port: int, codes: list[int]) -> None:
        waiting = self.waiting(port)
        waiting += codes[: MAX_QUEUE - len(waiting)]
        self._environment.events.raise_("serialreceive")

    def waiting(self, port: int) -> list[int]:
        """Return the unread characters of a port; port 0, the default, is port 1."""
        if not 0 <= port <= LAST_PORT:
            raise Rejected(
                "channel", f"there is no serial port {port}", f"they are numbered 1 to {LAST_PORT}"
            )
        return self._waiting.setdefault(port or 1, [])

    def take(self, port: int) -> int:
        waiting = self.waiting(port)
        if not waiting:
            return 0
        self._environment.acts += 1
        return waiting.pop(0)

    def send(self, port: int, code: int) -> None:
        """Send a character; the characters of a line are shown together.

        A carriage return, a line feed, or both in sequence, end a line.
        """
        self.waiting(port)
        stream = self._environment.machine.stream(f"serial {port or 1}")
        ends = code in _LINE_END
        if not (ends and self._ended):
            stream.write("\n" if ends else chr(code))
        self._ended = ends and code == _LINE_END[0]


# ------------------------------------------------------------------------------------------------- keywords

# SERIALCHAR, by the code of a character.
_CHARACTER = Actions(read=of(Ports, Ports.take), write=of(Ports, Ports.send))
_NOTHING = Actions(do=of(Ports, Ports.waiting))


def _command(name: str, actions: Actions, help: str) -> Keyword:
    example = f"{name}(1)\nPRINT SERIALBUFFERUSAGE"
    return Keyword(name, "", "command", "C", "port", "", actions, help, example, group="terminal")  # fmt: skip


ROWS = (
    Keyword("SERIALCHAR", "", "setting", "RW", "port", "integer", _CHARACTER,
            "Read the next character that has come in at a serial port, 0 when there is none; written, send one. "
            "Port 1 where none is given.",
            "SERIALCHAR = 65\nSERIALCHAR = 13\nPRINT SERIALCHAR",
            default=0.0, low=0, high=255, group="terminal", driven="serial"),
    Keyword("SERIALBUFFERUSAGE", "", "reading", "R", "port", "integer",
            Actions(read=of(Ports, lambda ports, port: len(ports.waiting(port)))),
            "Number of unread characters that a serial port has received.",
            "PRINT SERIALBUFFERUSAGE", default=0.0, group="terminal"),
    _command("SERIALCLEARRECEIVEBUFFER", Actions(do=of(Ports, lambda ports, port: ports.waiting(port).clear())),
             "Forget what has come in at a serial port and was not read."),
    _command("SERIALCLEARTRANSMITBUFFER", _NOTHING,
             "Forget what was not sent yet: nothing, as characters are sent at once."),
    _command("SERIALCLEARERROR", _NOTHING, "Clear the errors of a serial port; there are none here."),
)  # fmt: skip
# The event sources of each kind, created for programs that handle these events.
SOURCES = {"serialreceive": Ports}
