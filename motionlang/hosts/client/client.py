"""The client: send a line, read its answer, wait for an axis.

It works in the same way with a real, a served and a virtual board.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import TYPE_CHECKING, Self

from motionlang.hosts.client.answer import (
    CANCELLED,
    VERSION_QUERY,
    cancelled_in,
    code_of,
    end_of,
    lines_of,
    number_of,
    version_in,
)
from motionlang.hosts.client.connection import TIMEOUT, Connection
from motionlang.hosts.client.status import Status
from motionlang.hosts.errors import AxisFault, ClientError, CommandError, ConnectionLost, NoReply
from motionlang.kernel import Machine, Source
from motionlang.kernel.lang import first_mistake
from motionlang.kernel.mccl import without_comment

if TYPE_CHECKING:
    from motionlang.hosts.channel import Wire
    from motionlang.hosts.mccl.console import Console

# Seconds of silence after which the answer of a board without a prompt is complete, and a line has been
# drained.
QUIET = 0.05
# Seconds after which a line counts as drained even if it is never silent, because background tasks report all
# the time.
DRAIN = 0.5
ESC = b"\x1b"
ATTEMPTS = 3
# The largest number of stored lines that were not requested, from background tasks.
MAX_UNASKED = 1000


class Client(Connection):
    """A connection to a board, one line at a time; not thread-safe.

    Opening it sends ESC, to clear any unfinished line of an earlier host, and asks for the version. `version`
    is the board's answer, and `prompts` is True if the board has a prompt. `unasked` collects the output of
    background tasks between two lines. Time-outs are in seconds, for a virtual board in machine seconds.
    """

    def __init__(self, wire: Wire, timeout: float = TIMEOUT) -> None:
        super().__init__(wire, timeout)
        self.version = ""
        self.prompts: bool
        self.unasked: deque[str] = deque(maxlen=MAX_UNASKED)
        self._rest = b""
        try:
            self._find_board()
        except BaseException:
            wire.close()
            raise

    # -------------------------------------------------------------------------------------------- connecting

    @classmethod
    def virtual(
        cls,
        board: Console | Mapping[str, object] | None = None,
        *,
        step: float = 0.001,
        timeout: float = TIMEOUT,
    ) -> Self:
        """Create a virtual board in this process.

        `board` is a `Console`, or the settings of a machine file for a new one. Nothing takes real time. A
        line takes `step` machine seconds, or as long as it waits. Raises ValueError for an invalid setting.
        """
        from motionlang.hosts.client.virtual import VirtualWire
        from motionlang.hosts.mccl.console import Console

        if isinstance(board, Console):
            console = board
        else:
            mistake = first_mistake(board or {})
            if mistake:
                raise ValueError(mistake)
            console = Console(Machine(board, first_axis=1))
        return cls(VirtualWire(console, step), timeout)

    @classmethod
    def open(cls, where: str, timeout: float = TIMEOUT) -> Self:
        """Connect like `Connection.open`; the address `virtual` creates a virtual board."""
        return cls.virtual(timeout=timeout) if where == "virtual" else super().open(where, timeout)

    # ---------------------------------------------------------------------------------------------- commands

    def send(self, line: str, timeout: float | None = None) -> list[str]:
        """Send a line and return the lines of its answer; there may be none.

        Raises CommandError for `?code`, ConnectionLost, and NoReply if the line takes longer; it is then
        abandoned.
        """
        data = _encoded(line)
        self._collect_unasked()
        self._wire.send(data)
        seconds = self.timeout if timeout is None else timeout
        answer = self._answer(line, seconds)
        for k, each in enumerate(answer):
            code = code_of(each)
            if code is not None:
                raise CommandError(code, line, answer[:k])
        return answer

    def ask(self, line: str, timeout: float | None = None) -> str:
        """Send a line and return its one-line answer."""
        answer = self.send(line, timeout)
        if len(answer) != 1:
            raise ClientError(f"{line}: {len(answer)} lines of answer, not one: {answer}")
        return answer[0]

    def number(self, line: str, timeout: float | None = None) -> float | int:
        """Send a line and return the number in its answer, in decimal mode.

        For example, `1TP` returns 1234 for the answer `01 1234`.
        """
        answer = self.ask(line, timeout)
        try:
            return number_of(answer)
        except ValueError:
            raise ClientError(f"{line}: the answer is no number: {answer}") from None

    def download(self, text: str, timeout: float | None = None) -> list[str]:
        """Send the lines of a file without its comments; return all answers."""
        answer: list[str] = []
        for number, line in enumerate(Source("", text).text.split("\n"), 1):
            line = without_comment(line).strip()
            if line:
                try:
                    answer += self.send(line, timeout)
                except CommandError as error:
                    raise CommandError(error.code, line, answer + error.answer, number) from None
        return answer

    def escape(self) -> None:
        """Abandon the board's work for this client, including a wait; motion continues."""
        self._wire.send(ESC)
        self._await_cancelled()
        self._drain()

    # -------------------------------------------------------------------------------------------------- axes

    def position(self, axis: int) -> float | int:
        """Return the actual position, in the axis's units."""
        return self.number(f"{axis}TP")

    def status(self, axis: int) -> Status:
        """Return the primary status word."""
        return Status(int(self.number(f"{axis}TS")) & 0xFFFFFFFF)

    def wait_for_stop(self, axis: int, timeout: float | None = None) -> None:
        """Wait until the trajectory is complete (WS).

        Raises AxisFault if it ended in an error, NoReply if it did not end.
        """
        self._wait(axis, "WS", timeout)

    def wait_for_target(self, axis: int, timeout: float | None = None) -> None:
        """Wait until the axis is at target (WT): within the dead band DB for the time DT.

        Raises the errors of `wait_for_stop`.
        """
        self._wait(axis, "WT", timeout)

    def _wait(self, axis: int, command: str, timeout: float | None) -> None:
        try:
            self.send(f"{axis}{command}", timeout)
        except NoReply:
            self._check(axis)
            raise
        self._check(axis)

    def _check(self, axis: int) -> None:
        status = self.status(axis)
        if status & Status.MOTOR_ERROR:
            raise AxisFault(axis, status)

    # ----------------------------------------------------------------------------------------------- private

    def _find_board(self) -> None:
        if not self._wire.fresh:
            self._drain()
        for _ in range(ATTEMPTS):
            self._wire.send(ESC + VERSION_QUERY.encode() + b"\r")
            if self._await_version(self.timeout / ATTEMPTS):
                return
            self._drain()
        raise NoReply(VERSION_QUERY, self.timeout)

    def _await_version(self, seconds: float) -> bool:
        """Read the answer to VE; return False if there is none."""
        end, data, lines = self._wire.now() + seconds, b"", [""]
        while True:
            try:
                received = self._wire.receive(min(QUIET, seconds) if lines[-1] else end - self._wire.now())
            except ConnectionLost:
                if code_of(data.decode("latin-1").strip()) is not None:
                    raise ConnectionLost("the server accepts no more hosts") from None
                raise
            data += received
            self.version, whole = version_in(data)
            self.prompts = whole > 0
            if self.prompts:
                self._rest = data[whole:]
                return True
            if not received or self._wire.now() >= end:
                self.version = lines[-1]
                return bool(lines[-1])
            # A board without a prompt ends its answer with silence.
            ended = data[: max(data.rfind(b"\n"), data.rfind(b"\r")) + 1]
            lines = ["", *(line for line in lines_of(ended, VERSION_QUERY) if line != CANCELLED)]

    def _answer(self, line: str, seconds: float) -> list[str]:
        wire, data = self._wire, bytearray(self._rest)
        end, self._rest = wire.now() + seconds, b""
        while True:
            left = end - wire.now()
            ended = data.endswith((b"\n", b"\r")) and not self.prompts
            received = wire.receive(min(left, QUIET) if ended else left)
            searched = len(data)
            data += received
            whole = end_of(data, searched) if self.prompts else len(data) * (ended and not received)
            if whole:
                self._rest = bytes(data[whole:])
                return lines_of(data[:whole], line)
            if not received:
                self.escape()
                raise NoReply(line, seconds)

    def _collect_unasked(self) -> None:
        """Store the complete lines that have arrived; the rest of a line is still to come."""
        received = self._rest + self._wire.receive(0.0)
        complete = max(received.rfind(b"\n"), received.rfind(b"\r")) + 1
        self.unasked.extend(lines_of(received[:complete]))
        self._rest = received[complete:]

    def _await_cancelled(self) -> None:
        """Read until the board has answered an ESC, at most for the client's time-out.

        Without this, the answer of a busy board could arrive after the next line has been sent, and be taken for the
        answer to that line.
        """
        end, data = self._wire.now() + self.timeout, bytearray()
        while (left := end - self._wire.now()) > 0.0:
            searched = len(data)
            data += self._wire.receive(left)
            if end_of(data, searched) if self.prompts else cancelled_in(data):
                return

    def _drain(self) -> None:
        """Discard input until the line is silent, at most for `DRAIN` seconds."""
        self._rest = b""
        end = self._wire.now() + DRAIN
        while self._wire.receive(QUIET) and self._wire.now() < end:
            pass


def _encoded(line: str) -> bytes:
    try:
        data = line.encode("latin-1")
    except UnicodeEncodeError:
        data = b"\n"
    if any(code < 32 and code != 9 for code in data):
        raise ValueError(f"{line!r} is not one line of MCCL")
    return data + b"\r"
