"""A session at the prompt: one line after the other on one living machine. There is no terminal in it.

Time is the machine's own. A line runs until its task has ended, so its waits pass; motion that it started stays under
way, and **time stands still at the prompt** until the next line, or `.run` and `.settle`, let it pass. The same lines
therefore always give the same answers, however long somebody thinks between them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from motionlang.errors import Diagnostic
from motionlang.execution import accelerators
from motionlang.lang.dialect import Dialect
from motionlang.lang.machine.machine import Machine
from motionlang.repl.commands import is_command, obey, without_dot
from motionlang.repl.runner import Interrupted, Runner
from motionlang.repl.status import moving
from motionlang.source import Source
from motionlang.views.diagnostics import render
from motionlang.views.terminal import WIDTH, harmless

Show = Callable[[str], None]

REMARK_ON_MOTION = (
    "-- axis {} in motion, and time stands still: .run S goes on S seconds, .settle to the end\n"
)


class Session:
    """`feed(text)` executes lines and answers with all that they made appear.

    `show` is called with the machine's output and the session's answers as they come, `complain` with troubles
    and remarks (by default `show` gets them too). `interrupted()` is polled while a command runs, `pace(time)` is
    called with the machine time that is about to be reached. `ask(begun)` answers with the line for an INPUT that
    stands behind the text `begun`, None where there is none; time stands still meanwhile. `failed` says whether
    anything ever went wrong, `over` that the user has asked to leave.
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
        # Whether machine time follows the wall; None where nobody sits before a clock.
        self.live: bool | None = None
        self._settings, self._overrides = settings, overrides
        self._show, self._complain = show, complain or show
        self._answer: list[str] = []
        self._remarked = False
        self.reset()

    def reset(self) -> None:
        """Power-up: a new machine at time zero, no names, no open block."""
        self.machine = Machine(
            self._settings,
            first_axis=self.dialect.first_axis,
            show=lambda text: self.say(harmless(text)),
            overrides=self._overrides,
            accelerators=accelerators(),
        )
        self.machine.ask = lambda: self.ask(self.machine.terminal.begun)
        self.runner = Runner(self.dialect, self.machine, self.trouble, self._poll)
        self._block: list[str] = []
        self._lines: list[str] = []
        self._ambiguous = 0

    # ------------------------------------------------------------------------------------------ what is typed

    @property
    def in_block(self) -> bool:
        """Whether a block is open, so that more lines must follow."""
        return bool(self._block)

    def is_complete(self, text: str) -> bool:
        """Whether `text` could be executed as it stands."""
        return is_command(text) or self.runner.is_complete(text)

    def feed(self, text: str) -> str:
        """Execute `text`, one line or more; the answer is all that it made appear."""
        self._answer.clear()
        for line in text.split("\n"):
            if self.over or self.interrupted():
                self._block.clear()
                break
            self._line(line)
        return "".join(self._answer)

    def finish(self) -> str:
        """No more lines will come: a block that is still open is executed, and says what it lacks."""
        self._answer.clear()
        if self._block:
            self._execute_block()
        return "".join(self._answer)

    def _line(self, line: str) -> None:
        if is_command(line):
            # Typed lines are counted, these too: the numbers of a piped session are those of its file.
            (self._block or self._lines).append("")
            obey(self, line.strip())
            return
        self._block.append(line)
        if self.runner.is_complete("\n".join(self._block)):
            self._execute_block()

    def _execute_block(self) -> None:
        """Lines are numbered through the session, as the report of moves names them."""
        text, before = "\n".join(self._block), len(self._lines)
        self._lines.extend(self._block)
        self._block.clear()
        if text.strip():
            self.execute(Source("input", "\n" * before + text))

    # ---------------------------------------------------------------------------------------------- executing

    def load(self, source: Source) -> bool:
        """Execute a whole program, keeping its names as far as the dialect can; False when something went wrong."""
        fine = self.execute(source)
        # A number up to here may mean a line of the program or of the session.
        self._ambiguous = max(len(self._lines), source.text.count("\n") + 1)
        return fine

    def execute(self, source: Source) -> bool:
        """Execute a source; False when something went wrong."""
        fine = self.runner.execute(source)
        self.machine.terminal.close()
        self.machine.terminal.forget()
        axes = moving(self.machine)
        if axes and not self._remarked and not self.live:
            self._remarked = True
            self.remark(REMARK_ON_MOTION.format(", ".join(map(str, axes))))
        return fine

    def _poll(self, time: float) -> None:
        if self.interrupted():
            raise Interrupted
        if self.pace is not None:
            self.pace(time)

    # ------------------------------------------------------------------------------------------------ telling

    def say(self, text: str) -> None:
        """Show text as part of the answer."""
        self._answer.append(text)
        if self._show is not None:
            self._show(text)

    def remark(self, text: str) -> None:
        """Show what is not output: a trouble, a remark."""
        self._answer.append(text)
        if self._complain is not None:
            self._complain(text)

    def trouble(self, diagnostics: list[Diagnostic], source: Source | None = None) -> None:
        """Show what went wrong."""
        self.machine.terminal.close()
        for diagnostic in diagnostics:
            self.failed = self.failed or diagnostic.severity == "error"
            origin = self._origin(diagnostic, source)
            if origin is not None and (meant := without_dot(origin.text.strip())):
                diagnostic.hint = f"the prompt's own words begin with a dot: {meant}"
            self.remark(render(diagnostic, origin, colour=self.colour, width=self.width))

    def _origin(self, diagnostic: Diagnostic, source: Source | None) -> Source | None:
        """The text that a diagnostic's line is a line of: an earlier one for what was left in a move buffer."""
        if source is None or not diagnostic.line:
            return None
        if source.line(diagnostic.line):
            return source
        if diagnostic.line > self._ambiguous:
            if not self.runner.keeps_places:
                diagnostic.column = 0  # what was left behind is somewhere in that line
            return Source("input", "\n".join(self._lines))
        diagnostic.line = 0
        return None
