r"""A Mint controller and the lines of its hosts, which a server feeds and runs.

The controller has one program memory and runs one thing at a time: its program, or a line that a host has typed. Each
host has a serial line of its own. The output of a program goes to all hosts, as if they shared one cable. The output of
a typed line goes to the host that typed it.

    console = MintConsole(settings)
    console.load(Source("packer.mnt", text))
    port = console.open()
    console.run(1.0)          # one second of machine time
    port.feed(b"\5")          # Ctrl-E
    port.take()               # b"Break at line 7\r\nP>"

Time is machine time. `run` advances it to a given time, `settle` until no typed line runs. Frames, keys and breaks act
between two calls, when every axis is consistent.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping

from motionlang.hosts.console import HostConsole
from motionlang.hosts.mint.editor import PROGRAM, ControllerTexts
from motionlang.hosts.mint.hcp import Elements
from motionlang.hosts.mint.port import MAX_PRINTED, MintPort
from motionlang.kernel import (
    INFINITY,
    Diagnostic,
    Machine,
    ProgramError,
    Scheduler,
    Source,
    Stuck,
    Task,
    Wait,
)
from motionlang.kernel.lang import explain
from motionlang.kernel.mint import DIALECT, NUMBERS, MintInteractive, shows_float
from motionlang.kernel.tools import StackSpace

INTERNAL = "internal error, see the output of the server"


class MintConsole(HostConsole[MintPort]):
    """One controller for any number of hosts.

    `complain(diagnostics, source)` is called with the errors of its programs, for the person who runs the server.
    """

    break_key = "Ctrl-E"
    # What a host is sent when no more can connect.
    no_room = b""

    def __init__(
        self,
        settings: Mapping[str, object] | None = None,
        overrides: Mapping[str, float | str] | None = None,
        *,
        complain: Callable[[list[Diagnostic], Source], None] = lambda diagnostics, source: None,
    ) -> None:
        machine = Machine(settings, show=self._show, overrides=overrides)
        machine.terminal.repeats = True
        self._idle = _Idle()
        super().__init__(
            machine, Scheduler(machine.controller, self._idle, outside=_Hosts(machine)), self._idle
        )
        self.texts = ControllerTexts()
        self.elements = Elements(lambda: self.machine.host, shows_float(self.machine))
        self._complain = complain
        self._interactive = MintInteractive(self.machine)
        # The host whose line is carried out, the text that runs, and those that RUN starts after it.
        self._by: MintPort | None = None
        self._source: Source | None = None
        self._is_program = False
        self._next: deque[Source] = deque()
        # The host that pressed the last key for the program.
        self._key_port: MintPort | None = None
        # What was printed while no host was connected.
        self._early = ""
        # The answer to INPUT that the host has already seen as it typed.
        self._typed: str | None = None

    # ---------------------------------------------------------------------------------------------- its state

    @property
    def is_busy(self) -> bool:
        """True while the program or a typed line runs."""
        return self._source is not None

    @property
    def runs(self) -> bool:
        """True while the program runs."""
        return self.is_busy and self._is_program

    @property
    def is_asking(self) -> bool:
        """True while an INPUT waits for a line."""
        return self.is_busy and self.machine.has_operator and self.machine.operator.asking

    @property
    def working(self) -> bool:
        """True while a typed line runs and does not wait for input from the host."""
        return self.is_busy and not self._is_program and not self.is_asking

    @property
    def wait(self) -> Wait | None:
        """The wait of the running program or line, None if it does not wait."""
        return self._scheduler.parent.wait if self.is_busy else None

    def serves(self, port: MintPort) -> bool:
        """True while a line typed by this host runs."""
        return self._by is port and not self._is_program

    # --------------------------------------------------------------------------------------- for the server

    def load(self, source: Source) -> None:
        """Store a program in the memory and run it, as at power-up.

        Raises ProgramError if it has errors.
        """
        self.texts.set(PROGRAM, source.text)
        self._interactive.forget()
        self._begin(source, self._interactive.program(source, strict=True), None, program=True)

    def open(self, echo: bool | None = None) -> MintPort:
        """Open a line for another host.

        With `echo` False the characters that it sends are not echoed; None echoes, as on a terminal. The first host
        receives the output printed before it connected.
        """
        port = MintPort(self, echo is not False)
        self.ports.append(port)
        port.send(self._early)
        self._early = ""
        if not self.is_busy:
            port.prompt()
        return port

    def close(self, port: MintPort) -> None:
        """Close the line of a host that has disconnected, and end the line it was running.

        The program and motion continue.
        """
        if port in self.ports:
            self.ports.remove(port)
            port.close()
            if self._key_port is port:
                self._key_port = None
            if self.serves(port):
                self._stop()
                self._go_on()

    def run(self, until: float) -> None:
        """Advance time to `until`, in seconds."""
        self._pass(until, settle=False)
        self.machine.clock.advance(until)
        self._forget()

    def settle(self, limit: float = INFINITY) -> bool:
        """Advance time until no typed line runs, but not beyond `limit`.

        Returns False if one still runs. Neither a line that waits for its host nor a running program counts.
        """
        if self.working:
            self._pass(limit, settle=True)
            self._forget()
        return not self.working

    def drop_broken(self, error: Exception) -> None:
        """End the program or line after an internal error; the controller continues."""
        self._ended([Diagnostic("crash", INTERNAL)])

    # ---------------------------------------------------------------------------------------- for the lines

    def enter(self, port: MintPort, text: str) -> None:
        """Execute a line that a host has typed at the prompt."""
        if not port.block:
            if not port.editor.number and text.strip().upper() == "RUN":
                self._run_program(port)
                return
            answer = port.editor.take(text)
            if answer is not None:
                port.send(answer)
                port.prompt()
                return
        port.block.append(text)
        whole = "\n".join(port.block)
        if self._interactive.is_complete(whole):
            port.block.clear()
            if whole.strip():
                self._execute(port, Source("line", whole))
                return
        port.prompt()

    def break_off(self, port: MintPort) -> None:
        """End the running program or line (Ctrl-E); motion continues."""
        text = "Break"
        if self.runs and self._source is not None:
            line, _, _ = DIALECT.locate(self._source, self._scheduler.parent.at)
            text = f"Break at line {line}"
        self._end_line()
        others = self.ports if self.runs else []
        if self.machine.has_operator:
            self.machine.operator.keys.clear()
        self._stop()
        for each in (port, *(other for other in others if other is not port)):
            each.send(f"{text}\n")
            each.prompt()
        self._go_on()

    def press(self, port: MintPort, code: int) -> None:
        """Press a key of a host for the program."""
        self._key_port = port
        self.machine.operator.press(chr(code))

    def answer(self, text: str) -> None:
        """Supply the line that an INPUT waits for."""
        operator = self.machine.operator
        operator.lines.append((text, ""))
        operator.asking = False
        self._typed = text
        self.touched()

    def touched(self) -> None:
        """Make polling loops check again, because a host has changed something."""
        clock = self.machine.clock
        clock.at(clock.now, _nothing)

    # ------------------------------------------------------------------------------------------- what runs

    def _run_program(self, port: MintPort) -> None:
        sources = [Source(name, text) for name, text in self.texts.sources()]
        if not sources:
            port.send("Error: there is no program to run\n")
            port.prompt()
            return
        self._interactive.forget()
        self._next.extend(sources[1:])
        self._start(sources[0], port)

    def _start(self, source: Source, port: MintPort | None) -> None:
        """Start a text of the memory; its errors are reported to all hosts."""
        try:
            task = self._interactive.program(source)
        except ProgramError as error:
            self._source, self._is_program, self._by = source, True, port
            self._ended(error.diagnostics)
        else:
            self._begin(source, task, port, program=True)

    def _execute(self, port: MintPort, source: Source) -> None:
        """Start a typed line."""
        try:
            task = self._interactive.task(source)
        except ProgramError as error:
            port.send("".join(map(_sentence, error.diagnostics)))
            port.prompt()
        else:
            self._begin(source, task, port, program=False)

    def _begin(self, source: Source, task: Task, port: MintPort | None, program: bool) -> None:
        scheduler = self._scheduler
        scheduler.tasks = [
            task,
            *(each for each in scheduler.tasks if each is not self._idle and not each.done),
        ]
        scheduler.current = task
        self._source, self._by, self._is_program = source, port, program

    def _pass(self, limit: float, settle: bool) -> None:
        """Advance time to `limit` or, with `settle`, until no typed line runs."""
        while True:
            over = True
            try:
                with StackSpace():
                    over = self._scheduler.run_program(limit)
            except Stuck:
                over = False
            except Exception as error:
                diagnostic = self._explain(error)
                if diagnostic is None:
                    raise
                self._ended([diagnostic])
            else:
                if over:
                    self._finish()
            if not over and not self._takes_keys():
                return
            if settle and not self.working:
                return

    def _takes_keys(self) -> bool:
        """Pass the characters typed ahead to an INPUT; True if they answer it."""
        if not self.is_asking or not self.ports:
            return False
        keys, port = self.machine.operator.keys, self._key_port or self._by or self.ports[0]
        while keys and self.is_asking:
            port.type(keys.pop(0))
        if self._by is not None and not self._is_program:
            self._by.go_on()
        return not self.is_asking

    def _explain(self, error: Exception) -> Diagnostic | None:
        source = self._source or Source("line", "")
        task = self._scheduler.current
        known = self.is_busy and task is not self._idle
        return explain(DIALECT, source, task if known else None, error)

    def _finish(self) -> None:
        """End a text that is complete; start the next one, if any."""
        if self._next:
            self._stop_tasks()
            self._start(self._next.popleft(), self._by)
        else:
            self._ended([])

    def _ended(self, diagnostics: list[Diagnostic]) -> None:
        """End the running program or line, report its errors, and send the prompt."""
        self._end_line()
        source, by, program = self._source, self._by, self._is_program
        recipients = self.ports if program or by is None else [by]
        self._stop()
        text = "".join(_sentence(each, with_line=program) for each in diagnostics)
        for port in recipients:
            if port in self.ports:
                port.send(text)
                if source is not None:
                    port.prompt()
        if diagnostics and program and source is not None:
            self._complain(diagnostics, source)
        self._go_on()

    def _stop(self) -> None:
        """End the running program or line.

        Motion continues, and so do tasks that a typed line has started.
        """
        if self._is_program:
            self._stop_tasks()
            self._interactive.environment.forget_program()
        scheduler = self._scheduler
        parent = scheduler.parent
        parent.done = True
        scheduler.interrupts = [each for each in scheduler.interrupts if not each.done]
        self._idle.rest(self.now)
        scheduler.tasks = [
            self._idle,
            *(each for each in scheduler.tasks if not each.done and each is not self._idle),
        ]
        scheduler.current = self._idle
        self._source, self._by, self._is_program = None, None, False
        self._next.clear()
        if self.machine.has_operator:
            self.machine.operator.asking = False

    def _stop_tasks(self) -> None:
        """End all tasks and handlers of the program."""
        for task in (*self._scheduler.tasks, *self._scheduler.interrupts):
            task.done = True

    def _go_on(self) -> None:
        """Process the characters that hosts have typed ahead."""
        for port in list(self.ports):
            port.go_on()

    # --------------------------------------------------------------------------------------------- its output

    def _show(self, text: str) -> None:
        if self._typed is not None and text == f"{self._typed}\n":
            self._typed, text = None, "\n"  # the host has seen its own answer
        if self._by is not None and not self._is_program:
            self._by.send(text)
            return
        if not self.ports:
            self._early = (self._early + text)[-MAX_PRINTED:]
        for port in self.ports:
            port.send(text, MAX_PRINTED)

    def _end_line(self) -> None:
        self.machine.terminal.close()

    def _forget(self) -> bool:
        """Trim the output, too, and report what the machine remarks."""
        trimmed = super()._forget()
        if trimmed:
            machine = self.machine
            machine.terminal.forget()
            for terminal in machine.terminals.values():
                terminal.forget()
            found, machine.diagnostics = machine.diagnostics, []
            if found and self._source is not None:
                self._complain(found, self._source)
        return trimmed


class _Idle(Task):
    """The scheduler's parent task while nothing runs; it waits for the hosts."""

    def __init__(self) -> None:
        super().__init__("prompt")
        self.rest(0.0)

    def rest(self, now: float) -> None:
        """Start another wait."""
        self.done = False
        self.wait = Wait(now, lambda: False, lambda: INFINITY, "for a host to send a line", "host")

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        return now, self.wait


class _Hosts:
    """The hosts in the role of a world, which acts only between calls of the console."""

    def __init__(self, machine: Machine) -> None:
        self._clock = machine.clock

    def start(self, machine: Machine) -> None:
        """Do nothing: hosts come and go at any time."""

    def may_act(self) -> bool:
        """Return False, because no host acts while time passes."""
        return False

    def advance(self, time: float) -> None:
        self._clock.advance(time)


def _sentence(diagnostic: Diagnostic, with_line: bool = False) -> str:
    number = NUMBERS.get(diagnostic.code)
    kind = "Warning" if diagnostic.severity != "error" else f"Error {number[0]}" if number else "Error"
    where = f" at line {diagnostic.line}" if with_line and diagnostic.line else ""
    hint = f" ({diagnostic.hint})" if diagnostic.hint else ""
    return f"{kind}{where}: {diagnostic.message}{hint}\n"


def _nothing() -> None:
    """Do nothing: the event only makes polling loops check again."""
