"""A host's line to a Mint controller: the host's characters and the output.

The state of the controller decides where a character goes:

    part of an HCP frame           to the comms array, at any time
    Ctrl-E                         ends the running program or line
    while a program runs           to the program: to a line if INPUT waits for one, otherwise as a key
    at the prompt                  to a line, which the editor or the interpreter executes

Characters that arrive while a line runs are queued, for its INPUT or for the prompt after it. Lines end with CR, LF or
both.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.hosts.mint.editor import Editor
from motionlang.hosts.mint.hcp import ENQ, EOT, Receiver
from motionlang.hosts.typed_line import BLANK, CR, LF, TypedLine
from motionlang.kernel import Wait

if TYPE_CHECKING:
    from motionlang.hosts.mint.console import MintConsole

CTRL_E = ENQ
# The longest line that is carried out.
MAX_LINE = 1000
# Characters that wait for the end of a line; further ones are lost.
MAX_WAITING = 65536
# Unread output of the program, and of lines and frames of the host itself; of more, the oldest is lost.
MAX_PRINTED, MAX_STORED = 65536, 4_000_000


class MintPort:
    """One host's connection.

    `feed` takes characters, `take` returns the controller's output. With `echo` False no character is echoed, for
    hosts that send whole lines.
    """

    def __init__(self, console: MintConsole, echo: bool) -> None:
        self.console, self._echoes = console, echo
        self.editor = Editor(console.texts)
        # The lines of a block that is not complete.
        self.block: list[str] = []
        self._frames = Receiver(console.elements)
        self._typed = TypedLine(MAX_LINE)
        self._waiting = bytearray()
        self._out = bytearray()

    @property
    def busy(self) -> bool:
        """True while a line or character of this host is being processed or is queued."""
        return bool(self._waiting) or self.console.serves(self)

    @property
    def waiting(self) -> Wait | None:
        """The wait of this host's line, None if it does not wait or waits for the host."""
        if not self.console.serves(self) or self.console.is_asking:
            return None
        return self.console.wait

    # --------------------------------------------------------------------------------------- for the server

    def accepts(self, data: bytes | bytearray, by_line: bool = False) -> bool:
        """Return True, because the line accepts every character at any time."""
        return True

    def next_piece(self, data: bytearray, by_line: bool) -> tuple[bytes, bool]:
        """Return what is fed next of `data`, all of it while a line runs, and True if it is a line, frame or key."""
        if self.busy or not by_line:
            return bytes(data), False
        if data[0] == EOT:
            end = _end_of_frame(data)
            return bytes(data[:end] if end else data), end > 0
        if data[0] == CTRL_E or (self.console.runs and not self.console.is_asking):
            return bytes(data[:1]), True
        for k, code in enumerate(data):
            if code in (CR, LF):
                alone = not (code == LF and self._typed.after_cr and k == 0)
                return bytes(data[: k + 1]), alone
            if code in (EOT, CTRL_E):
                return bytes(data[:k]), False
        return bytes(data), False

    def feed(self, data: bytes) -> int:
        """Take all characters, and return their number."""
        for code in data:
            self._take_in(code)
        return len(data)

    def abandon(self) -> None:
        """End the running program or line, as Ctrl-E does."""
        self._break()

    def take(self) -> bytes:
        """Return the output since the last call."""
        sent = bytes(self._out)
        self._out.clear()
        return sent

    def close(self) -> None:
        """Disconnect the host; discard the characters that are still queued."""
        self._waiting.clear()
        self._typed.clear()
        self._out.clear()

    # -------------------------------------------------------------------------------------- for the console

    def send(self, text: str, most: int = MAX_STORED) -> None:
        """Send a text; lines end with CR and LF.

        If more than `most` unread characters are stored, the oldest are discarded.
        """
        self._add(text.replace("\n", "\r\n").encode("latin-1", "replace"), most)

    def prompt(self) -> None:
        """Send the prompt."""
        self.send(">" if self.block else self.editor.prompt)

    def go_on(self) -> None:
        """Process the queued characters until something runs that does not ask for them."""
        while self._waiting and (self.console.is_asking or not self.console.is_busy):
            self.type(self._waiting.pop(0))

    def type(self, code: int) -> None:
        """Process a character of a line."""
        echo = self._typed.type(code)
        if echo == "\n":
            self._enter()
        else:
            self._echo(echo)

    # ---------------------------------------------------------------------------------------------- private

    def _take_in(self, code: int) -> None:
        answer = self._frames.take(code)
        if answer is not None:
            self._add(answer)
            if answer:
                self.console.touched()
        elif code == CTRL_E:
            self._break()
        elif self.console.is_asking:
            self.type(code)
        elif self.console.runs:
            self.console.press(self, code)
        elif self.console.is_busy or self._waiting:
            if len(self._waiting) < MAX_WAITING:
                self._waiting.append(code)
        else:
            self.type(code)

    def _break(self) -> None:
        self._waiting.clear()
        self._typed.clear()
        self.block.clear()
        self.editor.leave()
        self.console.break_off(self)

    def _enter(self) -> None:
        text, dropped = self._typed.take()
        if self.console.is_asking:
            self.console.answer(text)
            return
        self._echo("\n")
        if dropped:
            self.send(f"Error: the line is longer than {MAX_LINE} characters\n")
            self.prompt()
            return
        self.console.enter(self, text)

    def _echo(self, text: str) -> None:
        if self._echoes:
            self.send(text)

    def _add(self, data: bytes, most: int = MAX_STORED) -> None:
        self._out += data
        if len(self._out) > most:
            del self._out[: len(self._out) - most]


def _end_of_frame(data: bytes | bytearray) -> int:
    """Return the length of the frame at the start of `data`; 0 if it is incomplete."""
    end = next((k for k in range(3, len(data)) if data[k] < BLANK and data[k] != 2), 0)
    if not end or data[end] == ENQ:
        return end + 1 if end else 0
    return end + 2 if len(data) > end + 1 else 0
