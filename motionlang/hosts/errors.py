"""Errors that a client raises."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.mccl import MEANINGS
from motionlang.kernel.tools import PicklableError

if TYPE_CHECKING:
    from motionlang.hosts.client.status import Status


class ClientError(PicklableError):
    """Base class of the errors below."""


class CommandError(ClientError):
    """The board answered `?code`.

    `line` is the line sent, and `answer` the lines that came before the code. `number` is its line number in
    a downloaded file.
    """

    def __init__(self, code: int, line: str, answer: Sequence[str] = (), number: int | None = None) -> None:
        self.code, self.line, self.answer, self.number = code, line, list(answer), number
        self.meaning = MEANINGS.get(code, "a code that is not in the manual")
        prefix = "" if number is None else f"line {number}: "
        super().__init__(f"{prefix}{line}: ?{code}, {self.meaning}")


class FrameRejected(ClientError):
    """A Mint controller answered an HCP frame with NAK, or with an invalid frame."""

    def __init__(self, element: int) -> None:
        self.element = element
        super().__init__(f"element {element}: the controller rejected the frame")


class LineRejected(ClientError):
    """A Mint controller answered a typed `line` with the error `answer`."""

    def __init__(self, line: str, answer: str) -> None:
        self.line, self.answer = line, answer
        super().__init__(f"{line}: {answer}")


class NoReply(ClientError, TimeoutError):
    """The controller did not answer in time.

    A line of MCCL has been abandoned with ESC; motion continues.
    """

    def __init__(self, line: str, seconds: float) -> None:
        self.line, self.seconds = line, seconds
        super().__init__(f"{line}: no answer within {seconds:g} s")


class ConnectionLost(ClientError, ConnectionError):
    """No board is connected, or the connection has ended."""


class AxisFault(ClientError):
    """A wait ended because the axis has an error; `status` identifies it."""

    def __init__(self, axis: int, status: Status) -> None:
        self.axis, self.status = axis, status
        names = ", ".join(status.faults) or "motor error"
        super().__init__(f"axis {axis}: {names} (status {int(status)})")
