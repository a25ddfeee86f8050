"""What a run left behind: its status, its diagnostics, and the machine as it stood at the end.

Apart from `motionlang.report`, which most runs of a script do not ask for.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.analysis.certificate import Limit
    from motionlang.analysis.proof.checker import Proof
    from motionlang.controller.controller import Controller
    from motionlang.errors import Diagnostic
    from motionlang.lang.dialect import Dialect
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.program import Program
    from motionlang.log.orders import Orders
    from motionlang.log.trace import Trace
    from motionlang.source import Source


class Run:
    """What a run left behind.

    `status` is "ended", "until" (virtual time was up), "fault" (the program is wrong or went wrong) or
    "interrupted" (Ctrl-C or a signal); `time` is the machine time at its end, in seconds.
    """

    __slots__ = (
        "certificate",
        "crash",
        "diagnostics",
        "dialect",
        "machine",
        "not_counted",
        "orders",
        "program",
        "source",
        "status",
        "time",
    )

    def __init__(self, source: Source, dialect: Dialect, machine: Machine) -> None:
        self.source, self.dialect = source, dialect
        self.machine: Machine = machine
        self.status: str = "ended"
        self.time: float = 0.0
        self.diagnostics: list[Diagnostic] = []
        self.not_counted: list[str] = []
        # An error of motionlang's own, which ended the run.
        self.crash: Exception | None = None
        self.program: Program | None = None  # what the source was compiled to
        self.orders: Orders | None = None  # of a run that is to be proved
        self.certificate: list[Limit] | None = None  # of one whose limits are certified

    @property
    def controller(self) -> Controller:
        return self.machine.controller

    @property
    def output(self) -> list[str]:
        """Every line the program printed."""
        return self.machine.terminal.lines

    @property
    def terminals(self) -> dict[str, list[str]]:
        """Every line that the program printed elsewhere, by "terminal 2", "serial 1"."""
        return {label: terminal.lines for label, terminal in self.machine.terminals.items() if terminal.lines}

    @property
    def trace(self) -> Trace:
        """The motion, to be sampled at any rate."""
        return self.controller.trace

    def proof(self, views: bool = True) -> Proof:
        """The motion held against what the program ordered; ValueError for a run without `prove`.

        With `views` its report and its trace are held against it, too.
        """
        from motionlang.analysis.proof.outputs import ROWS
        from motionlang.analysis.proof.prove import prove
        from motionlang.log.track import Recorded

        if self.orders is None:
            raise ValueError("a run is proved that was made with prove=True")
        if not views:
            return prove(Recorded(self.controller), self.orders, self.time)
        from motionlang.report import moves

        samples = self.trace.sample(ROWS / self.time) if self.time > 0.0 else None
        return prove(Recorded(self.controller), self.orders, self.time, moves(self), samples)

    def _repr_html_(self) -> str:
        # Asked for by a notebook, which has the views; nothing below them may import them.
        from importlib import import_module

        shown: str = import_module("motionlang.views.notebook").html(self)
        return shown

    @property
    def report(self) -> dict[str, object]:
        """The run as `motionlang.report/1`."""
        from motionlang.report import build

        return build(self)
