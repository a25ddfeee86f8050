"""A compiled Mint program: started on a machine, or kept as bytes for the next run."""

from __future__ import annotations

from motionlang.lang.program import Program
from motionlang.mint.runtime.code_units import FILE, loaded
from motionlang.mint.runtime.environment import Environment
from motionlang.mint.runtime.task import PARENT, MintTask

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    from motionlang.errors import Diagnostic
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.task import Task
    from motionlang.mint.runtime.code_units import Code
    from motionlang.source import Source


class MintProgram(Program):
    """The source stays with the program: `--set` changes constants, which are written into the code."""

    __slots__ = ("_warnings", "code", "name", "settings", "text")

    def __init__(
        self,
        code: Code,
        name: str,
        text: str,
        settings: Mapping[str, object] | None,
        warnings: Sequence[Diagnostic] = (),
    ) -> None:
        self.code, self.name, self.text, self.settings = code, name, text, dict(settings or {})
        self._warnings = [(each.code, each.message, each.line, each.column, each.length, each.hint)
                          for each in warnings]  # fmt: skip

    @property
    def size(self) -> int:
        """How much of it is compiled; it grows as it runs."""
        return self.code.size

    @property
    def warnings(self) -> list[Diagnostic]:
        """Where the run may end before the program does: at words that are not simulated."""
        if not self._warnings:
            return []
        return [_warning(*each) for each in self._warnings]

    def payload(self) -> bytes:
        """The program as bytes, for `load`."""
        from marshal import dumps

        everything: Any = (
            self.code.payload(),
            self.name,
            self.text,
            self.settings,
            self._warnings,
        )
        return dumps(everything)

    def start(self, machine: Machine) -> Task:
        """The parent task, bound to `machine`; ProgramError when an override names nothing."""
        if machine.overrides:
            from motionlang.source import Source

            return compile_source(Source(self.name, self.text), self.settings, machine.overrides).run(machine)
        return self.run(machine)

    def _line_of(self, place: int) -> int:
        from motionlang.mint.syntax.parser import parse
        from motionlang.source import Source

        return parse(Source(self.name, self.text)).line(place)

    def run(self, machine: Machine) -> Task:
        """The parent task of the program as it stands."""
        environment = Environment(machine)
        environment.prepare()
        code, statements = self.code, environment.statements
        environment.files[FILE] = code.places
        environment.line_of = self._line_of
        operations = environment.make_operations(code.specs)
        namespace: dict[str, object] = {f"k{n}": operation for n, operation in enumerate(operations)}
        namespace.update(E=environment, C=environment.clock, P=environment.say)
        namespace.update(S=statements, dt=statements.cost)
        code.link(namespace)
        environment.blocks = {key: namespace[name] for key, name in code.blocks.items()}  # type: ignore[misc]
        if len(environment.blocks) > 1:
            environment.listen()
        task = environment.tasks[PARENT] = MintTask(PARENT, environment.blocks["main"], environment)
        task.timer = environment.timer
        return task


def compile_source(
    source: Source,
    settings: dict[str, object] | None = None,
    overrides: Mapping[str, float | str] | None = None,
) -> MintProgram:
    """The program of a text, `overrides` in the place of its own values. ProgramError with every mistake."""
    from motionlang.mint.compile.compiler import compile_text

    compiled = compile_text(source, settings, overrides)
    return MintProgram(compiled.code, source.name, source.text, settings, compiled.problems.of_the_run())


def load(payload: bytes) -> MintProgram:
    """The program that `MintProgram.payload` was made of."""
    from marshal import loads

    code, name, text, settings, warnings = loads(payload)
    program = MintProgram(loaded(code), name, text, settings)
    program._warnings = warnings
    return program


def _warning(code: str, message: str, line: int, column: int, length: int, hint: str) -> Diagnostic:
    from motionlang.errors import Diagnostic

    return Diagnostic(code, message, line, column, length=length, hint=hint, severity="warning")
