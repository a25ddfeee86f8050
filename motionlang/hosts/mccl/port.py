"""A port: a host's characters in, the board's out, like its ASCII interface.

While the port is idle it accepts the characters of a line. While it executes a line they wait, except the
control characters: ESC abandons the line (?-7), a blank pauses or resumes it, Ctrl-B single-steps. A blank
after waiting characters belongs to a line that was sent ahead, and waits with it. Every line is answered
with at least one line, then the prompt.
"""

from __future__ import annotations

from typing import Protocol

from motionlang.hosts.console import HostPort
from motionlang.hosts.typed_line import BLANK, CR, LF, TypedLine
from motionlang.kernel import INFINITY, Wait
from motionlang.kernel.mccl import (
    MAX_LINE,
    Board,
    CommandTask,
    Fault,
    Line,
    LineSteps,
    codes,
    line_of,
    too_long,
)


class BoardPort(HostPort, Protocol):
    """A port of a board, whatever the language of its host.

    `working` is True while a line is executed that does not need the host.
    """

    @property
    def working(self) -> bool: ...


CTRL_B, XON, XOFF, ESC = 2, 17, 19, 27
# Characters that a port accepts while it carries out a line, in addition to ESC: Ctrl-B, XON, XOFF and the
# blank.
AT_ONCE = (CTRL_B, XON, XOFF, BLANK)
# Limits of the characters that wait while the port is busy, and of those that a host leaves unread.
MAX_WAITING = 4096
MAX_UNREAD = 65536
# The limit of both with the output of one more command (TM-1 lists every macro). Beyond it answers are lost.
# Only background tasks, which nothing suspends, and an echo that is never read reach it.
MAX_STORED = 8 * MAX_UNREAD


class HostWait(Wait):
    """The wait of a task that has no line.

    A task reuses one object for all of its waits of this kind and sets `since` each time.
    """

    __slots__ = ()


class Port:
    """One host's connection.

    `feed` takes characters, `take` returns the board's output, and `busy` is true while a line is being
    executed. With `echo` True all input is sent back, as by boards with a terminal. False is for hosts that
    send whole lines; nothing is sent back. With None the model decides.
    """

    def __init__(self, board: Board, echo: bool | None = None) -> None:
        self.board = board
        self._echoes = echo is not False
        if echo:
            board.echo = True
        self._waiting = bytearray()
        self._typed = TypedLine(MAX_LINE)
        self._out = bytearray()
        self._is_paused = False
        self._closed = False
        # True if the last entry of `_next_entry` ended with CR.
        self._entered_cr = False
        # True if the end of the current line has been echoed.
        self._ended = False
        self.task = PortTask(board, self)
        self._prompt()

    @property
    def busy(self) -> bool:
        """True while a line is being executed."""
        return self.task.occupied

    @property
    def waiting(self) -> Wait | None:
        """The wait of the current line, if it has one."""
        return self.task.wait if self.working else None

    @property
    def working(self) -> bool:
        """True while a line is being executed and does not need the host.

        A line that waits for a key, or for its output to be read, needs the host.
        """
        return self.task.occupied and not self.task.held

    @property
    def full(self) -> bool:
        """True if so much output is unread that the board suspends the host's commands."""
        return len(self._out) >= MAX_UNREAD

    def accepts(self, data: bytes | bytearray, by_line: bool = False) -> bool:
        """True if the port would accept at least the first of a host's characters."""
        return not self.busy or ESC in data or (by_line and self._at_once(data) > 0)

    def next_piece(self, data: bytearray, by_line: bool) -> tuple[bytes, bool]:
        """Return what is fed next of `data`, and True if it is a line that the board has waited for.

        What a busy board has not accepted, and a following ESC abandons, is removed.
        """
        if self.busy and ESC in data:
            del data[: data.rindex(ESC)]
        if by_line and not self.busy:
            return self._next_entry(data)
        return bytes(data[: self._at_once(data)] if by_line else data), False

    def _at_once(self, data: bytes | bytearray) -> int:
        """Return how many characters at the start of `data` a busy port accepts.

        While single-stepping, this is one key; if not, it is control characters and blanks.
        """
        if self.task.stepping or data[0] == ESC:
            return 1
        return next((k for k, code in enumerate(data) if code not in AT_ONCE), len(data))

    def _next_entry(self, data: bytes | bytearray) -> tuple[bytes, bool]:
        """Return the first line of `data` and True, or an incomplete line and False."""
        for k, code in enumerate(data):
            if code in (CR, LF):
                complete = code == CR or not (self._entered_cr and k == 0)
                self._entered_cr = code == CR
                return bytes(data[: k + 1]), complete
        self._entered_cr = False
        return bytes(data), False

    def abandon(self) -> None:
        """Abandon the current line, as an ESC from the host would."""
        self.feed(bytes([ESC]))

    def feed(self, data: bytes) -> int:
        """Accept characters and return their number.

        The rest must be sent again when the port is idle.
        """
        if self._enters(data):
            return len(data)
        for count, code in enumerate(data):
            if not self._take_in(code):
                return count
        return len(data)

    def take(self) -> bytes:
        """Return the output since the last call; nothing while XOFF is in force."""
        if self._is_paused:
            return b""
        sent = bytes(self._out)
        self._out.clear()
        return sent

    def close(self) -> None:
        """Disconnect the host: abandon its line and discard all output.

        Motion and background tasks continue without output.
        """
        self._closed = True
        self._out.clear()
        self._waiting.clear()
        self.task.hang_up()

    # ----------------------------------------------------------------------------------------- for the task

    def send(self, text: str) -> None:
        """Send text with the model's line ends."""
        if self._closed or len(self._out) >= MAX_STORED:
            return
        if self.board.model.line_end != "\n":
            text = text.replace("\n", self.board.model.line_end)
        self._out += text.encode("latin-1", "replace")

    def line_done(self, answered: bool) -> None:
        """End a line: send at least one line of reply, then the prompt."""
        if not answered and not self._ended:
            self.send("\n")
        self._prompt()

    def go_on(self) -> None:
        """Process the waiting characters as long as the port stays idle."""
        while self._waiting and not self.busy:
            self._idle(self._waiting.pop(0))

    # ---------------------------------------------------------------------------------------------- private

    def _take_in(self, code: int) -> bool:
        if self._flow(code):
            return True
        if code == ESC:
            self._escape()
            return True
        if self.task.stepping and self.busy and code != CTRL_B:
            self.task.step()
            return True
        if code == CTRL_B:
            self.task.set_stepping(not self.task.stepping)
            return True
        if code == BLANK and self.busy and (self.task.paused or not self._waiting):
            self.task.pause()
            return True
        if self.busy or self._waiting:
            if len(self._waiting) >= MAX_WAITING:
                return False
            self._waiting.append(code)
        else:
            self._idle(code)
        return True

    def _enters(self, data: bytes) -> bool:
        """Accept a whole line on an idle port without echo.

        Returns False if the characters must be examined one by one.
        """
        board, task = self.board, self.task
        if task.occupied or self._waiting or task.stepping or (self._echoes and board.echo):
            return False
        if board.xon != XON or board.xoff != XOFF or not self._typed.enter(data):
            return False
        self._ended = False
        task.enter_text(*self._typed.take())
        return True

    def _flow(self, code: int) -> bool:
        """Process XON and XOFF."""
        board = self.board
        if code and code == board.xoff:
            self._is_paused = True
            return True
        if code and code == board.xon:
            self._is_paused = False
            return True
        return False

    def _escape(self) -> None:
        self._waiting.clear()
        self._typed.clear()
        self._is_paused = False
        self.task.set_stepping(False)
        if self.busy:
            self.task.cancel()
        else:
            self.send("\n")
            self._prompt()

    def _idle(self, code: int) -> None:
        """Process a character of a line."""
        echo = self._typed.type(code)
        if echo == "\n":
            self._ended = self._echoes and self.board.echo
        self._echo(echo)
        if echo == "\n":
            self.task.enter_text(*self._typed.take())

    def _echo(self, text: str) -> None:
        if self._echoes and self.board.echo:
            self.send(text)

    def _prompt(self) -> None:
        self.send(self.board.prompt)


class PortTask(CommandTask):
    """Executes the lines of one port and waits between them."""

    def __init__(self, board: Board, port: Port) -> None:
        super().__init__("port", board)
        self.serve()
        self._port = port
        self.write = self._send
        self.occupied = False
        self.stepping = False
        self.paused = self._granted = self._holds = False
        self._answered = False
        self._line: Line | None = None
        self._fault: Fault | None = None
        # The wait between two lines; `since` is set each time.
        self._for_line = HostWait(
            0.0, lambda: self.occupied, lambda: INFINITY, "for the host to send a line", "host"
        )

    # ------------------------------------------------------------------------------------------ for the port

    def enter_text(self, text: str, dropped: int) -> None:
        """Begin to execute a line."""
        self.occupied, self._answered = True, False
        try:
            if dropped:
                raise too_long(len(text) + dropped)
            self._line = line_of(text)
        except Fault as fault:
            self._fault = fault

    def cancel(self) -> None:
        """Abandon the line, including a wait (ESC).

        Motion continues; ST or AB end it.
        """
        self.board.last_error = codes.CANCELLED
        self.abandon()
        self._line = None
        self.paused = self._holds = False
        self.wait = None
        self.reply(f"?{codes.CANCELLED}")

    def pause(self) -> None:
        """Suspend execution before the next command, or resume it (a blank)."""
        self.paused = not self.paused

    def set_stepping(self, on: bool) -> None:
        """Switch single-stepping, one command per key, on or off (Ctrl-B)."""
        self.stepping, self._granted = on, False

    def step(self) -> None:
        """Execute one command (a key)."""
        self._granted = True

    @property
    def held(self) -> bool:
        """True if the next command waits for a key from the host, or for the host to read."""
        return self._holds and not self._may_go_on()

    def hang_up(self) -> None:
        """Disconnect the host: abandon its line; motion and background tasks continue."""
        self.abandon()
        self.board.ended(self)
        self.occupied, self.done, self.wait = False, True, None

    # -------------------------------------------------------------------------------------------- as a task

    def next_line(self) -> Line | None:
        fault, self._fault = self._fault, None
        if fault is not None:
            self.refused(fault)
        line, self._line = self._line, None
        return line

    def rest(self) -> Wait | None:
        """End the line, and return the wait for the next one."""
        now = self.clock.now
        if self.occupied:
            self.occupied = False
            self._port.line_done(self._answered)
            self._port.go_on()
        if self.occupied:
            return Wait(now, lambda: True, lambda: now, "")
        self._for_line.since = now
        return self._for_line

    def gate(self) -> Wait | None:
        """Return the wait for a key, or for the host to read."""
        if not self._may_go_on():
            self._holds = True
            steps = self.steps
            if self.stepping and isinstance(steps, LineSteps) and (command := steps.command(self.pc)):
                self._send(f"{{ C{steps.index_of(self.pc)},{command.text} }} <")
            return Wait(self.clock.now, self._may_go_on, lambda: INFINITY, "for a key", "operator")
        self._granted = self._holds = False
        return None

    def _may_go_on(self) -> bool:
        return self._granted or not (self.paused or self.stepping or self._port.full)

    def _send(self, text: str) -> None:
        self._answered = True
        self._port.send(text)
