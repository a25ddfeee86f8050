"""The result of a run: status, diagnostics, final machine state, and notes.

The figures are computed in `motionlang.kernel.report`, which most runs of a script do not import.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.failures import failures
from motionlang.kernel.lang.dialect import Dialect
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.program import Program
from motionlang.kernel.source import Source
from motionlang.kernel.tools import count_of, in_notebook

if TYPE_CHECKING:
    from motionlang.kernel.log.cycle import Cycle
    from motionlang.kernel.moves import Moves
    from motionlang.kernel.report_types import Report, ReportMove
    from motionlang.kernel.tracks.trace import Trace


class Run:
    """The result of a run.

    `status` is "ended", "until" (the time limit), "stopped" (by `run.stop`), "fault" (the program is invalid or
    failed) or "interrupted" (Ctrl-C or a signal); `time` is the machine time at its end, in seconds.
    """

    def __init__(self, source: Source, dialect: Dialect, machine: Machine) -> None:
        self.source, self.dialect = source, dialect
        self.machine: Machine = machine
        self.status: str = "ended"
        self.time: float = 0.0
        self.diagnostics: list[Diagnostic] = []
        # Notes for the report; those on tasks that only wait at the time limit are in `wait_notes`, too.
        self.notes: list[str] = []
        self.wait_notes: list[str] = []
        # True if the run ended since the machine file had nothing more for a wait that it had ended before.
        self.has_run_out = False
        # The quantities that a caller has asked for, by name.
        self.quantities: dict[str, float | str | bool | None] = {}
        # An internal error, which ended the run.
        self.crash: Exception | None = None
        self.program: Program | None = None  # the compiled source
        self.findings: dict[str, object] = {}  # what questions about the run add to its report, by field

    @property
    def controller(self) -> Controller:
        return self.machine.controller

    @property
    def output(self) -> list[str]:
        """Every line that the program printed."""
        return self.machine.terminal.lines

    @property
    def terminals(self) -> dict[str, list[str]]:
        """Every line that the program printed elsewhere, by label, such as "terminal 2"."""
        return {label: terminal.lines for label, terminal in self.machine.terminals.items() if terminal.lines}

    @property
    def ok(self) -> bool:
        """True if the run had no error, and no limit, following error or fault, as the exit status of `run`."""
        return not failures(self)

    @property
    def trace(self) -> Trace:
        """The motion, for sampling at any rate."""
        from motionlang.kernel.tracks.trace import Trace

        return Trace(self.controller)

    def _repr_html_(self) -> str:
        return in_notebook("html", self)

    def __repr__(self) -> str:
        counts = count_of(len(self.machine.log.moves), "move")
        if self.diagnostics:
            counts += f", {count_of(len(self.diagnostics), 'diagnostic')}"
        return f"<Run of {self.source.name}: {self.status} at {self.time:g} s, {counts}>"

    @property
    def moves(self) -> Moves:
        """Every move that was started, in order.

        `to_polars` and `to_pandas` convert them to a table.
        """

        from motionlang.kernel.moves import Moves
        from motionlang.kernel.report import moves

        return Moves(cast("list[ReportMove]", list(moves(self))), self)

    @property
    def cycle(self) -> Cycle | None:
        """The repetition of the task that moves most; None if it repeats nothing."""
        from motionlang.kernel.log.cycle import cycle

        if self.program is None or not len(self.machine.log.moves):
            return None
        structure, homes = self.program.structure, self.dialect.table().homes
        has_ended = self.status == "ended"
        return cycle(self.machine.log, self.time, has_ended, structure.line, structure.owners().get, homes)

    @property
    def report(self) -> Report:
        """The report of the run, in the schema `motionlang.report/3`."""
        from motionlang.kernel.report import build

        return build(self)
