"""A port: where a host's characters go in and the board's come out, as at the board's ASCII interface.

Characters of a line are taken while the port is idle. While a line is being carried out they wait, except for the
control characters: ESC abandons the line (?-7), a blank pauses and goes on again, Ctrl-B single-steps. A blank behind
characters that wait is one of a line that was sent ahead, and waits with it. Every line is answered with at least one
line, then the prompt.
"""

from __future__ import annotations

from motionlang.lang.task import Wait
from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.resolve.line import line_of, too_long
from motionlang.mccl.runtime.task import CommandTask
from motionlang.mccl.syntax.parser import LONGEST

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.line import Line
    from motionlang.mccl.runtime.board import Board

INFINITY = float("inf")
CTRL_B, BACKSPACE, LF, CR, ESC, BLANK, DELETE = 2, 8, 10, 13, 27, 32, 127
# Characters that wait while the port is busy, and characters that a host may leave unread.
MOST_WAITING = 4096
MOST_UNREAD = 65536
# What one command may still add to them (TM-1 lists every macro). Beyond it answers are lost: only background tasks,
# which nothing holds, and an echo that nobody reads come so far.
MOST_KEPT = 8 * MOST_UNREAD


class Port:
    """One host's connection. `feed` takes characters, `take` gives what the board has to say, `busy` says whether it
    is carrying out a line.

    `echo` True sends back what comes in, as boards with a terminal do, False never does (a host that sends whole
    lines does not want it), None leaves it to the model.
    """

    def __init__(self, board: Board, echo: bool | None = None) -> None:
        self.board = board
        self._echoes = echo is not False
        if echo:
            board.echo = True
        self._waiting = bytearray()
        self._typed = bytearray()
        self._dropped = 0
        self._out = bytearray()
        self._held = False
        self._after_cr = self._closed = False
        # Whether the end of the line being carried out has been echoed.
        self._ended = False
        self.task = PortTask(board, self)
        self._prompt()

    @property
    def busy(self) -> bool:
        """Whether a line is being carried out."""
        return self.task.occupied

    @property
    def waiting(self) -> Wait | None:
        """What the line being carried out waits for."""
        return self.task.wait if self.working else None

    @property
    def working(self) -> bool:
        """Whether it is carrying out a line that goes on without the host: no key, no reading of what was said."""
        return self.task.occupied and not self.task.held

    @property
    def full(self) -> bool:
        """Whether the host leaves so much unread that the board holds its commands."""
        return len(self._out) >= MOST_UNREAD

    def feed(self, data: bytes) -> int:
        """Take characters; how many were taken. The rest has to come again when the port is idle."""
        for count, code in enumerate(data):
            if not self._take_in(code):
                return count
        return len(data)

    def take(self) -> bytes:
        """What the board has sent since the last call; nothing while XOFF holds it."""
        if self._held:
            return b""
        sent = bytes(self._out)
        self._out.clear()
        return sent

    def close(self) -> None:
        """The host is gone: the line is abandoned, motion and background tasks go on and tell nobody."""
        self._closed = True
        self._out.clear()
        self._waiting.clear()
        self.task.hang_up()

    # ----------------------------------------------------------------------------------------- for the task

    def send(self, text: str) -> None:
        """Send text, its line ends as the model has them."""
        if self._closed or len(self._out) >= MOST_KEPT:
            return
        if self.board.model.line_end != "\n":
            text = text.replace("\n", self.board.model.line_end)
        self._out += text.encode("latin-1", "replace")

    def line_done(self, answered: bool) -> None:
        """A line has been carried out: at least one line of answer, then the prompt, then what has been waiting."""
        if not answered and not self._ended:
            self.send("\n")
        self._prompt()

    def go_on(self) -> None:
        """Take the characters that have been waiting, as far as the port stays idle."""
        while self._waiting and not self.busy:
            self._idle(self._waiting.pop(0))

    # ----------------------------------------------------------------------------------------------- inside

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
            if len(self._waiting) >= MOST_WAITING:
                return False
            self._waiting.append(code)
        else:
            self._idle(code)
        return True

    def _flow(self, code: int) -> bool:
        """XON and XOFF."""
        board = self.board
        if code and code == board.xoff:
            self._held = True
            return True
        if code and code == board.xon:
            self._held = False
            return True
        return False

    def _escape(self) -> None:
        self._waiting.clear()
        self._typed.clear()
        self._dropped = 0
        self._held = False
        self.task.set_stepping(False)
        if self.busy:
            self.task.cancel()
        else:
            self.send("\n")
            self._prompt()

    def _idle(self, code: int) -> None:
        """A character of a line."""
        after_cr, self._after_cr = self._after_cr, code == CR
        if code in (CR, LF):
            if not (code == LF and after_cr):
                self._enter()
        elif code in (BACKSPACE, DELETE):
            if self._typed:
                self._typed.pop()
                self._echo("\b \b")
        elif code >= BLANK or code == 9:
            if len(self._typed) >= LONGEST:
                self._dropped += 1
            else:
                self._typed.append(code)
            self._echo(chr(code))

    def _enter(self) -> None:
        """The line is complete."""
        self._ended = self._echoes and self.board.echo
        self._echo("\n")
        text, dropped = self._typed.decode("latin-1"), self._dropped
        self._typed.clear()
        self._dropped = 0
        self.task.enter_text(text, dropped)

    def _echo(self, text: str) -> None:
        if self._echoes and self.board.echo:
            self.send(text)

    def _prompt(self) -> None:
        self.send(self.board.prompt)


class PortTask(CommandTask):
    """Carries out the lines of one port; between them it waits for the next."""

    def __init__(self, board: Board, port: Port) -> None:
        super().__init__("port", board)
        self._port = port
        self.write = self._send
        self.occupied = False
        self.stepping = False
        self.paused = self._granted = self._holds = False
        self._answered = False
        self._line: Line | None = None
        self._fault: Fault | None = None

    # ------------------------------------------------------------------------------------------ for the port

    def enter_text(self, text: str, dropped: int) -> None:
        """Begin to carry out a line."""
        self.occupied, self._answered = True, False
        try:
            if dropped:
                raise too_long(len(text) + dropped)
            self._line = line_of(text)
        except Fault as fault:
            self._fault = fault

    def cancel(self) -> None:
        """ESC: abandon the line, in a wait too. Motion goes on; ST or AB end it."""
        self.board.last_error = codes.CANCELLED
        self.abandon()
        self._line = None
        self.paused = self._holds = False
        self.wait = None
        self.reply(f"?{codes.CANCELLED}")

    def pause(self) -> None:
        """A blank: hold the next command, or go on."""
        self.paused = not self.paused

    def set_stepping(self, on: bool) -> None:
        """Ctrl-B: carry out one command a key."""
        self.stepping, self._granted = on, False

    def step(self) -> None:
        """A key: carry out one command."""
        self._granted = True

    @property
    def held(self) -> bool:
        """Whether the next command waits for the host: for a key, or for it to read."""
        return self._holds and not self._may_go_on()

    def hang_up(self) -> None:
        """The host is gone: its line is abandoned, motion and background tasks go on."""
        self.abandon()
        self.board.ended(self)
        self.occupied, self.done, self.wait = False, True, None

    # -------------------------------------------------------------------------------------------- as a task

    def next_line(self) -> Line | None:
        fault, self._fault = self._fault, None
        if fault is not None:
            self._refused(fault)
        line, self._line = self._line, None
        return line

    def _rest(self, now: float) -> Wait | None:
        if self.done:
            return None
        if self.occupied:
            self.occupied = False
            self._port.line_done(self._answered)
            self._port.go_on()
        if self.occupied:
            return Wait(now, lambda: True, lambda: now, "")
        return Wait(now, lambda: self.occupied, lambda: INFINITY, "for the host to send a line", "host")

    gated = True

    def _gate(self, line: Line) -> Wait | None:
        if not self._may_go_on():
            self.paid = self._holds = True
            if self.stepping:
                command = line.commands[self.pc]
                self._send(f"{{ C{self.pc},{command.text} }} <")
            return Wait(
                self.board.controller.clock.now, self._may_go_on, lambda: INFINITY, "for a key", "operator"
            )
        self._granted = self._holds = False
        return None

    def _may_go_on(self) -> bool:
        return self._granted or not (self.paused or self.stepping or self._port.full)

    def _send(self, text: str) -> None:
        self._answered = True
        self._port.send(text)
