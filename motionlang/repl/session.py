"""A session at the prompt: lines executed one by one on a running machine.

It does not depend on a terminal. Time is machine time. A line runs until its task has ended, so its waits
pass. Motion that it started continues later: **time stops at the prompt** until the next line, or `.run` or
`.settle`, lets it pass. The same lines therefore always give the same answers, regardless of the time between
them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from textwrap import wrap

from motionlang.commands.check import check
from motionlang.kernel import Diagnostic, Dialect, Machine, Rejected, Source
from motionlang.kernel.lang import AT_PROMPT, one_sentence
from motionlang.repl.commands import is_command, obey, without_dot
from motionlang.repl.debugging import Debugging
from motionlang.repl.runner import CommandInterrupted, Runner
from motionlang.repl.status import moving
from motionlang.views.diagnostics import render
from motionlang.views.terminal import WIDTH, harmless

Show = Callable[[str], None]

REMARK_ON_MOTION = "-- axis {} in motion, time is paused: .run S or .settle continues"


class Session:
    """An interactive session: `feed(text)` executes lines and returns their output.

    `show` is called at once with output of the machine and answers of the session, `complain` with errors
    and remarks (by default they go to `show`, too). `interrupted()` is polled while a command runs.
    `pace(time)` is called with the machine time of the next step. `ask(begun)` returns the line for an INPUT whose
    prompt is `begun`, or None if there is none; machine time stops meanwhile. `failed` is True after any error, `over`
    after the user has asked to leave.
    """

    def __init__(
        self,
        dialect: Dialect,
        settings: Mapping[str, object] | None = None,
        overrides: Mapping[str, float | str] | None = None,
        *,
        show: Show | None = None,
        complain: Show | None = None,
    ) -> None:
        self.dialect = dialect
        self.interrupted: Callable[[], bool] = lambda: False
        self.pace: Callable[[float], None] | None = None
        self.ask: Callable[[str], str | None] = lambda begun: None
        self.colour, self.width = False, WIDTH
        self.failed = self.over = False
        # True if machine time follows real time; None if no user is present.
        self.live: bool | None = None
        # The program in the debugger.
        self.debugging: Debugging | None = None
        self._settings, self._overrides = settings, overrides
        self.show, self.complain = show, complain or show
        self._answer: list[str] = []
        self._remarked = False
        self.reset()

    def reset(self) -> None:
        """Reset to power-up: a new machine at time zero, no names, no open block."""
        machine = Machine(
            self._settings,
            first_axis=self.dialect.first_axis,
            show=lambda text: self.write(harmless(text)),
            overrides=self._overrides,
        )
        machine.ask = lambda: self.ask(machine.terminal.begun)
        runner = Runner(self.dialect, machine, self.trouble, self._poll)
        # Both exist, so a machine that the language rejects leaves the session unchanged.
        self.machine, self.runner = machine, runner
        self._block: list[str] = []
        self._lines: list[str] = []
        self._ambiguous = 0

    def switch(self, dialect: Dialect) -> None:
        """Reset with another language; raise Rejected if it rejects the machine, and change nothing."""
        before, self.dialect = self.dialect, dialect
        try:
            self.reset()
        except Rejected:
            self.dialect = before
            raise
        self.debugging = None

    @property
    def shown(self) -> tuple[Machine, float]:
        """The machine that the user sees, and its time: that at the stop of the debugger, if there is one."""
        stopped = None if self.debugging is None else self.debugging.stopped
        return stopped or (self.machine, self.machine.clock.now)

    # -------------------------------------------------------------------------------------------------- input

    def is_complete(self, text: str) -> bool:
        """True if `text` could be executed as it is."""
        return is_command(text) or self.runner.interactive.is_complete(text)

    def feed(self, text: str) -> str:
        """Execute `text`, one or more lines, and return all of its output."""
        self._answer.clear()
        for line in text.split("\n"):
            if self.over or self.interrupted():
                self._block.clear()
                break
            self._line(line)
        return "".join(self._answer)

    def finish(self) -> str:
        """End the input: execute a block that is still open, and report its missing end."""
        self._answer.clear()
        if self._block:
            self._execute_block()
        return "".join(self._answer)

    def _line(self, line: str) -> None:
        if is_command(line):
            # Count these lines too, so that the line numbers of a piped session are those of its file.
            (self._block or self._lines).append("")
            obey(self, line.strip())
            return
        self._block.append(line)
        if self.runner.interactive.is_complete("\n".join(self._block)):
            self._execute_block()

    def _execute_block(self) -> None:
        """Execute the open block; lines are numbered through the session.

        The report of moves uses these numbers.
        """
        text, before = "\n".join(self._block), len(self._lines)
        self._lines.extend(self._block)
        self._block.clear()
        if text.strip():
            self.execute(Source("input", text, before))

    # ---------------------------------------------------------------------------------------------- execution

    def load(self, source: Source) -> bool:
        """Execute a whole program; return False after an error.

        Its names remain defined if the dialect allows it.
        """
        fine = self.execute(source)
        # A number up to here may be a line of the program or of the session.
        self._ambiguous = max(len(self._lines), source.text.count("\n") + 1)
        return fine

    def execute(self, source: Source) -> bool:
        """Execute a source; return False after an error."""
        fine = self.runner.execute(source)
        self.machine.terminal.close()
        self.machine.terminal.forget()
        axes = moving(self.machine)
        if axes and not self._remarked and not self.live:
            self._remarked = True
            text = REMARK_ON_MOTION.format(", ".join(map(str, axes)))
            self.remark("\n".join(wrap(text, self.width)) + "\n")
        return fine

    def _poll(self, time: float) -> None:
        if self.interrupted():
            raise CommandInterrupted
        if self.pace is not None:
            self.pace(time)

    # ------------------------------------------------------------------------------------------------- output

    def write(self, text: str) -> None:
        """Show text as part of the answer."""
        self._answer.append(text)
        if self.show is not None:
            self.show(text)

    def remark(self, text: str) -> None:
        """Show text that is not output: an error or a remark."""
        self._answer.append(text)
        if self.complain is not None:
            self.complain(text)

    def trouble(self, diagnostics: list[Diagnostic], source: Source | None = None) -> None:
        """Report errors."""
        self.machine.terminal.close()
        for diagnostic in self._in_its_language(diagnostics, source):
            self.failed = self.failed or diagnostic.severity == "error"
            origin = self._origin(diagnostic, source)
            rejected = diagnostic.code not in ("never", "interrupted")
            if rejected and origin is not None and (meant := without_dot(origin.text.strip())):
                diagnostic.hint = f"commands of the prompt begin with a dot: {meant}"
            wrapped = self.live is not None
            self.remark(render(diagnostic, origin, colour=self.colour, width=self.width, wrapped=wrapped))

    def _in_its_language(self, found: list[Diagnostic], source: Source | None) -> list[Diagnostic]:
        """Return the diagnostics, or a single one if the text is in the other language.

        MCCL reports wrong commands when it reaches them, so the whole text is checked.
        """
        if source is None or not source.text or all(each.severity != "error" for each in found):
            return found
        checked = one_sentence(self.dialect, source, check(self.dialect.program(source)), AT_PROMPT)
        return checked if checked and checked[0].code == "language" else found

    def _origin(self, diagnostic: Diagnostic, source: Source | None) -> Source | None:
        """Return the source that contains a diagnostic's line.

        For a move left in a move buffer this is an earlier text.
        """
        if source is None:
            return None
        if source.line(diagnostic.line):
            return source
        if diagnostic.line > self._ambiguous:
            if not self.runner.interactive.keeps_columns:
                diagnostic.column = 0  # the move is somewhere in that line
            return Source("input", "\n".join(self._lines))
        diagnostic.line = 0
        return None
