"""The arguments of `launch`: a program, its machine and its simulated world."""

from __future__ import annotations

import os
from collections.abc import Iterator

from motionlang.ide.dap.arguments import Arguments, RequestRefused
from motionlang.ide.debug.debugger import Debugger
from motionlang.kernel import (
    Dialect,
    ProgramError,
    Source,
    WrongEntry,
    dialect_for,
    dialect_of,
    dialects,
    machine_of,
    read_machine,
    with_entries,
)
from motionlang.kernel.files import reason
from motionlang.views.diagnostics import render


class Launch:
    """A program to debug, as a client describes it.

    `program` is its path. Optional are `machine`, `lang`, `stopOnEntry`, `stopAtEnd`, `until`, `set` (values by
    name), and `input`, `analog`, `answer` and `keys` as on the command line.
    """

    def __init__(self, given: Arguments) -> None:
        self.path = os.path.abspath(os.path.expanduser(given.text("program")))
        self._machine = given.text("machine", "")
        self._lang = given.text("lang", "")
        self.stop_on_entry = given.flag("stopOnEntry")
        self.stop_at_end = given.flag("stopAtEnd")
        self.until = given.seconds("until")
        self.overrides = given.items("set")
        self._entries = [given.texts(name) for name in ("input", "analog", "answer", "keys")]
        self.settings: dict[str, object] = {}

    def read(self) -> tuple[Source, Dialect, dict[str, object]]:
        """Read the program and its machine; raise Refused or ProgramError."""
        if "\0" in self.path:
            raise RequestRefused("the path of the program has a NUL in it")
        try:
            source = Source.read(self.path)
            machine = machine_of(self.path, self._machine or None)
            settings = {} if machine is None else read_machine(Source.read(machine))
        except OSError as error:
            raise RequestRefused(f"{error.filename or self.path} cannot be read: {reason(error)}") from None
        if self._lang and self._lang not in dialects():
            raise RequestRefused(f"there is no language {self._lang!r}: {' or '.join(dialects())}")
        if not self._lang and dialect_of(self.path) is None:
            raise RequestRefused("unknown file extension; choose the language with lang mint or mccl")
        try:
            self.settings = with_entries(settings, *self._entries)
        except WrongEntry as error:
            raise RequestRefused(str(error)) from None
        return source, dialect_for(source, self._lang or None), self.settings

    def summary(self, debugger: Debugger) -> Iterator[str]:
        """Yield the diagnostics of a completed run, and how it ended."""
        run = debugger.run
        if run is None:
            return
        for diagnostic in run.diagnostics:
            yield render(diagnostic, debugger.source)
        for note in run.notes:
            yield f"{note}\n"
        word = {"until": "still running", "fault": "fault"}.get(run.status, run.status)
        yield f"{word} after {run.time:.9g} s\n"


def problems(error: ProgramError) -> str:
    """Return the errors of a program as one message."""
    found = [f"line {each.line}: {each.message}" if each.line else each.message for each in error.diagnostics]
    return "; ".join(found[:10])
