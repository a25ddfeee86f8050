r"""A board with its ports, driven by a server.

It runs in real time, or only while hosts wait.

    console = Console(Machine(first_axis=1))
    port = console.open()
    port.feed(b"1MN,1MR1000,1WS,1TP\r")
    console.settle()
    port.take()        # b">01 1000\n>"
"""

from __future__ import annotations

from collections.abc import Callable
from traceback import walk_tb
from typing import TypeAlias

from motionlang.hosts.console import HostConsole
from motionlang.hosts.mccl.port import BoardPort, HostWait, Port
from motionlang.kernel import INFINITY, Diagnostic, Machine, Rejected, Scheduler, Source, Stuck, Task, Wait
from motionlang.kernel.mccl import Board, CommandTask, FileTask, MacroFile, codes, locate


class Console(HostConsole[BoardPort]):
    """One board for any number of hosts.

    `run(until)` lets machine time pass to `until`, whatever the hosts do, for a server in real time.
    `settle()` lets it pass until no port is busy, for tests and for servers in lock step, in which time
    stops between lines.
    """

    break_key = "ESC"
    # The reply to a host if no more can connect: the board's code for an I/O error.
    no_room = b"?3\n"

    def __init__(self, machine: Machine) -> None:
        self._gate = _Gate()
        super().__init__(machine, Scheduler(machine.controller, self._gate), self._gate)
        self.board = Board(machine)
        self._downloads: list[Download] = []

    @property
    def working(self) -> bool:
        """True if a port is executing a line, or a file is being downloaded."""
        for port in self.ports:
            if port.working:
                return True
        return any(not each.done for each in self._downloads) if self._downloads else False

    def start(self, task: Task) -> None:
        """Start a task that does not belong to a port, such as a call of MCAPI."""
        self._scheduler.start(task)

    def open(self, echo: bool | None = None) -> Port:
        """Open a port for another host; with `echo` None the model decides about the echo."""
        port = Port(self.board, echo)
        self.ports.append(port)
        self.board.join(port.task)
        self._scheduler.start(port.task)
        return port

    def join(self, port: BoardPort) -> None:
        """Add a port whose host speaks a language other than MCCL."""
        self.ports.append(port)

    def close(self, port: BoardPort) -> None:
        """Close the port of a host that has disconnected.

        An unfinished line is abandoned; motion and background tasks continue.
        """
        if port in self.ports:
            self.ports.remove(port)
            port.close()
            if isinstance(port, Port) and port.task in self._scheduler.tasks:
                self._scheduler.tasks.remove(port.task)

    def download(self, source: Source, write: Write, complain: Complain) -> Download:
        """Carry out the lines of a file; motion and background tasks outlive it."""
        task = Download(source, self.board, write, complain)
        self._downloads = [each for each in self._downloads if not each.done] + [task]
        self._scheduler.start(task)
        return task

    def drop_broken(self, error: Exception) -> None:
        """Abandon the line in which an internal error happened; the board continues."""
        task = self._scheduler.current
        frames = [frame.f_code.co_name for frame, _ in walk_tb(error.__traceback__)]
        by_itself = "advance" in frames and "resume" not in frames
        if isinstance(task, CommandTask) and not task.done and not by_itself:
            self.board.last_error = codes.IO
            task.abandon()
            task.reply(f"?{codes.IO}")
            task.wait = None

    def run(self, until: float) -> None:
        """Let time pass to `until`."""
        if self.next_time() <= until:
            self._pass(until, lambda: False)
        self.machine.controller.clock.advance(until)
        self._forget()

    def settle(self, limit: float = INFINITY) -> bool:
        """Let time pass until no port is busy.

        Returns False if that never happens, or not by the time `limit`. A port that waits for its host, for a
        key or to be read, counts as not busy.
        """
        return self.run_until(lambda: not self.working, limit)

    def run_until(self, enough: Callable[[], bool], limit: float = INFINITY) -> bool:
        """Let time pass until `enough` holds.

        Returns False if that never happens, or not by the time `limit`.
        """
        reached = self._pass(limit, enough)
        self._forget()
        return reached

    def _pass(self, limit: float, enough: Callable[[], bool]) -> bool:
        """Let time pass until `enough` holds.

        If an event's action is rejected, long after its command, only an error code is set.
        """
        self._gate.open_at(enough)
        while True:
            try:
                return self._scheduler.run_program(limit)
            except Stuck:
                return False
            except Rejected:
                self.board.last_error = codes.PARAMETER


class _Gate(Task):
    """The scheduler's parent task; it is done as soon as its condition holds.

    It is never resumed: to wake a task and let it wait again would take most of the time of a host's short line.
    """

    def __init__(self) -> None:
        self._is_open: Callable[[], bool] = lambda: False
        super().__init__("console")
        self.wait = HostWait(0.0, lambda: False, lambda: INFINITY, "for the hosts", "host")
        self.wait.ends = INFINITY

    @property
    def done(self) -> bool:
        return self._is_open()

    @done.setter
    def done(self, done: bool) -> None:
        """Ignore the value that `Task` sets: the condition decides."""

    def open_at(self, ready: Callable[[], bool]) -> None:
        """End the next run as soon as `ready` is true."""
        self._is_open = ready

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        raise AssertionError("the gate never runs")


Write: TypeAlias = Callable[[str], None]
Complain: TypeAlias = Callable[[Diagnostic], None]


class Download(FileTask):
    """The task of a file sent to a board with hosts: its lines run one by one, and the replies go to the sender.

    `complain` is called for every rejected command, with its position in the file.
    """

    def __init__(self, source: Source, board: Board, write: Write, complain: Complain) -> None:
        others = list(board.tasks)
        super().__init__(MacroFile(source), board)
        board.tasks = [*others, self]
        self._source, self._complain = source, complain
        self.write = write
        board.complain = self._record_complaint

    def _record_complaint(self, diagnostic: Diagnostic, task: CommandTask) -> None:
        if task is self:
            diagnostic.line, diagnostic.column, diagnostic.length = locate(self._source, self.at)
            self._complain(diagnostic)

    def rest(self) -> Wait | None:
        """End the download; background tasks that the file has started continue."""
        self.board.complain = None
        self.board.ended(self)
        return None
