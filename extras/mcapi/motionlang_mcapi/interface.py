"""An interface of a board, which carries out the calls of its handles one by one.

A board has two: the binary handles share one and the ASCII handles the other. Each is a task of the board's
interpreter, so a call takes the time of its commands and sees the machine at that time. An interface has its
own accumulator and registers 0 to 9, and one block, which a handle begins and which collects the commands of
all handles of the interface.

A call that polls, such as MCIsStopped with a time-out, occupies no interface: it is a task of its own that
ends when its condition holds.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.hosts.mccl.port import Port
from motionlang.kernel import INFINITY, Rejected, Task, Wait
from motionlang.kernel.mccl import FORMS, Board, CommandTask, Fault, Line
from motionlang_mcapi import table as mc
from motionlang_mcapi.errors import code_of

if TYPE_CHECKING:
    from motionlang_mcapi.block import CommandBlock
    from motionlang_mcapi.call import ApiCall
    from motionlang_mcapi.session import Handle

ESC = 27
# Characters that an ASCII interface holds for its host, and for the board while a call is carried out.
MAX_BUFFERED = 65536


class Interface(CommandTask):
    """The task that carries out calls.

    `port` belongs to an ASCII interface, which shares its registers.
    """

    def __init__(self, board: Board, port: Port | None = None) -> None:
        super().__init__("mcapi", board, None if port is None else port.task.registers)
        self.serve()
        self.write = self._replied
        self.port = port
        self.current_call: ApiCall | None = None
        self.block: CommandBlock | None = None
        # The handle for which pmclock has reserved the interface.
        self.owner: Handle | None = None
        self.reply_text = ""
        self._queue: deque[ApiCall] = deque()
        # Characters from the board that no host has read, and from a host that wait for the end of a call.
        self._unread = bytearray()
        self._buffered = bytearray()

    @property
    def occupied(self) -> bool:
        """True while a call or a line is being carried out."""
        return (
            self.current_call is not None or bool(self._queue) or (self.port is not None and self.port.busy)
        )

    def submit(self, call: ApiCall) -> None:
        """Queue a call that has a line of commands."""
        self._queue.append(call)

    def drop(self, call: ApiCall) -> None:
        """Abandon a call whose host is gone, or that timed out before it began."""
        if call is self.current_call:
            self.abandon()
            self.wait = None
        elif call in self._queue:
            self._queue.remove(call)

    # ------------------------------------------------------------------------------------------- as a task

    def next_line(self) -> Line | None:
        """End the current call and begin the next one."""
        if self.current_call is not None:
            call, self.current_call = self.current_call, None
            call.finish(self.board.controller.clock.now)
        following = self._following()
        if following is None:
            self._send_buffered()
            return None
        self._queue.remove(following)
        self.current_call, self.reply_text = following, ""
        return following.line

    def rest(self) -> Wait | None:
        return Wait(self.clock.now, self._may_begin, lambda: INFINITY, "for the host to call", "host")

    def _may_begin(self) -> bool:
        return bool(self._queue) and self._following() is not None

    def _following(self) -> ApiCall | None:
        """Return the next call; while a handle owns the interface, its next call."""
        if self.port is not None and self.port.busy:
            return None
        if self.owner is None:
            return self._queue[0] if self._queue else None
        return next((call for call in self._queue if call.handle is self.owner), None)

    def refused(self, trouble: Fault | Rejected) -> bool:
        ends_line = super().refused(trouble)
        if ends_line and self.current_call is not None:
            self.current_call.code = code_of(trouble)
        return ends_line

    def tell(self, axis: int, text: str) -> None:
        """Report a value in the default form.

        The form and the base of ASCII replies do not apply to binary ones.
        """
        self.write(FORMS["01 1234"].format(axis, text))

    def whole_text(self, value: int) -> str:
        return str(value)

    def _replied(self, text: str) -> None:
        if len(self.reply_text) < MAX_BUFFERED:
            self.reply_text += text

    # ----------------------------------------------------------------------------- characters, ASCII only

    def put(self, data: bytes) -> int:
        """Send characters to the board and return how many it accepts.

        Characters wait while a call runs.
        """
        assert self.port is not None
        if ESC in data:
            self._buffered.clear()
        elif self.current_call is not None or self._buffered:
            data = data[: MAX_BUFFERED - len(self._buffered)]
            self._buffered += data
            return len(data)
        return self.port.feed(data)

    def has_text(self, size: int) -> bool:
        """True if pmcgets with a buffer of `size` characters need not wait."""
        assert self.port is not None
        self._pull()
        return self._end_of_text(size) > 0 or not (self.port.working or self.current_call or self._buffered)

    def get(self, size: int) -> str:
        """Return the characters up to the first CR or prompt, at most `size`."""
        self._pull()
        end = self._end_of_text(size) or len(self._unread)
        found = self._unread[:end].decode("latin-1")
        del self._unread[:end]
        return found

    def get_one(self) -> str:
        """Return the next character, "" if there is none."""
        self._pull()
        found = self._unread[:1].decode("latin-1")
        del self._unread[:1]
        return found

    def _end_of_text(self, size: int) -> int:
        """Return the length of the text that pmcgets returns, 0 if it is incomplete."""
        ends = [self._unread.find(mark) for mark in (b"\r", self.board.prompt.encode("latin-1")) if mark]
        found = min((end + 1 for end in ends if end >= 0), default=0)
        return min(found or (size if len(self._unread) >= size else 0), size)

    def _pull(self) -> None:
        assert self.port is not None
        if len(self._unread) < MAX_BUFFERED:
            self._unread += self.port.take()

    def _send_buffered(self) -> None:
        if self._buffered:
            assert self.port is not None
            del self._buffered[: self.port.feed(bytes(self._buffered))]


class Poll(Task):
    """A call that waits for a condition and occupies no interface.

    It ends when `ready` returns True, or at the time `until`. `due` returns the earliest time at which `ready` may
    become True. `finish` gets the last result of `ready`.
    """

    def __init__(
        self,
        board: Board,
        ready: Callable[[], bool],
        due: Callable[[], float],
        until: float,
        finish: Callable[[bool], None],
    ) -> None:
        super().__init__("mcapi poll")
        self._ready, self._finish = ready, finish
        clock = board.controller.clock
        self.wait = Wait(
            clock.now,
            lambda: self.done or ready() or clock.now >= until,
            lambda: min(due(), until),
            "for a condition of MCAPI",
            "host",
        )

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        if not self.done:
            self.done = True
            self._finish(self._ready())
        return now, None


def expire(call: ApiCall, interface: Interface, now: float) -> None:
    """End a call that has exceeded the time-out of its handle.

    The board continues its work.
    """
    if call is not interface.current_call:
        interface.drop(call)
    call.finish(now, mc.MCERR_TIMEOUT)
