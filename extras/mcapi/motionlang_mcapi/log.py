r"""Logs of calls, as `--record` and the C library write them.

    mcapi-log 1 multiflex
    0.000000000 0.000012000 1 MCOpen 0 2 - = 1
    0.100000000 0.100031000 1 MCGetPositionEx 1 1 + = 0 3125.0

The first line has the version, and the model if it is known. Every other line is a call: its start and end, s,
the number of the host process, and the line and the answer of the port. The answer of a function without a
result is `-` in a log of the real library, which does not know the error code. Lines are in the order of their
end times.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import BinaryIO

from motionlang_mcapi.call import ApiCall
from motionlang_mcapi.protocol import answer, decode, parse, request
from motionlang_mcapi.session import BadCall
from motionlang_mcapi.table import Value

HEAD = "mcapi-log 1"


class BadLog(ValueError):
    """A log that cannot be read; `line` is the line number of the error."""

    def __init__(self, line: int, message: str) -> None:
        self.line = line
        super().__init__(message)


@dataclass(eq=False, slots=True)
class LoggedCall:
    """A call of a log; `result` is None if it is not known."""

    line: int
    begin: float
    end: float
    host: int
    name: str
    handle: int
    arguments: tuple[Value | None, ...]
    result: int | None
    outputs: tuple[Value | None, ...]


class CallRecorder:
    """Writes every completed call with its machine times."""

    def __init__(self, write: Callable[[str], object], model: str) -> None:
        self._write = write
        write(f"{HEAD} {model}\n")

    def __call__(self, call: ApiCall) -> None:
        line = request(call.function.name, call.number, call.arguments)
        self._write(f"{call.begin:.9f} {call.end:.9f} {call.host} {line} = {answer(call)}\n")


def read_entry(text: str, number: int) -> LoggedCall:
    """Return the call of a line; raise BadLog if the line is not a call."""
    try:
        begin, end, host, rest = text.split(" ", 3)
        line, _, values = rest.rpartition(" = ")
        name, handle, arguments = parse(line)
        result, *outputs = decode(values)
        times = float(begin), float(end)
        if not (isinstance(result, int) or result is None) or not 0.0 <= times[0] <= times[1] < 1e9:
            raise ValueError
        return LoggedCall(number, *times, int(host), name, handle, tuple(arguments), result, tuple(outputs))
    except BadCall as problem:
        raise BadLog(number, f"this is no call: {problem}") from None
    except ValueError:
        raise BadLog(number, "this is no call: begin, end, host, call = answer") from None


def model_of(file: BinaryIO) -> str:
    """Return the model of a log, "" if the log does not state it.

    Raises BadLog for a file that is not a log.
    """
    file.seek(0)
    head = file.readline(200).decode("latin-1").rstrip("\r\n")
    if head == HEAD or head.startswith(HEAD + " "):
        return head[len(HEAD) :].strip()
    if head.startswith("mcapi-log "):
        raise BadLog(1, f"this is version {head.removeprefix('mcapi-log ')[:20]} of a log, not 1")
    raise BadLog(1, f"this is no log of MCAPI: the first line is not {HEAD!r}")


def read(file: BinaryIO) -> list[LoggedCall]:
    """Return the calls in the order of their start times.

    Raises BadLog at the first line that is not a call.
    """
    model_of(file)
    entries = [read_entry(_line(raw, number), number) for number, raw in enumerate(file, 2)]
    return sorted(entries, key=lambda entry: entry.begin)


def _line(raw: bytes, number: int) -> str:
    if not raw.endswith(b"\n"):
        raise BadLog(number, "the log is cut in the middle of this line")
    return raw.decode("latin-1").rstrip("\r\n")
