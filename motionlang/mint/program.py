"""A compiled Mint program: started on a machine, or kept as bytes for the next run."""

from __future__ import annotations

from motionlang.errors import ProgramError
from motionlang.lang.program import Program
from motionlang.mint.runtime.code_units import FILE, given_name, loaded
from motionlang.mint.runtime.environment import Environment
from motionlang.mint.runtime.task import PARENT, MintTask

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    from motionlang.errors import Diagnostic
    from motionlang.lang.dialect import Ranges
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.program import Outline
    from motionlang.lang.task import Task
    from motionlang.mint.runtime.code_units import Code
    from motionlang.source import Source


# Programs with other values written into them that are kept for further runs.
MOST_KEPT = 64
# Numbers beyond this are written into the program: the code counts on those that it is given being finite.
LARGEST = 1e300


class MintProgram(Program):
    """The source stays with the program: `--set` changes constants, which are written into the code.

    Not so those of `given`: their values are bound when the program starts. It says which are texts.
    """

    def __init__(
        self,
        code: Code,
        name: str,
        text: str,
        settings: Mapping[str, object] | None,
        warnings: Sequence[Diagnostic] = (),
        given: Mapping[str, bool] | None = None,
        outline: bytes = b"",
    ) -> None:
        self._outline = outline  # packed: few look at it
        self.code, self.name, self.text, self.settings = code, name, text, dict(settings or {})
        self.given = given or {}
        self._others: dict[tuple[tuple[str, float | str], ...], MintProgram] = {}
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
            self._outline,
        )
        return dumps(everything)

    @property
    def outline(self) -> Outline | None:
        """Its blocks, and the lines of the places in its code."""
        if not self._outline:
            return None
        from marshal import loads

        blocks, lines = loads(self._outline)
        return blocks, dict(zip(self.code.places, lines, strict=True))

    def start(self, machine: Machine) -> Task:
        """The parent task, bound to `machine`; ProgramError when an override names nothing."""
        overrides = machine.overrides
        if self.given:
            values = {
                name: overrides[name]
                for name, is_text in self.given.items()
                if name in overrides and isinstance(overrides[name], str) is is_text
                and (is_text or abs(overrides[name]) < LARGEST)  # type: ignore[arg-type]
            }  # fmt: skip
            if len(values) == len(overrides) == len(self.given):
                return self.run(machine, values)
            if len(values) == len(self.given):
                others = {n: v for n, v in overrides.items() if n not in values}
                return self._with(others, machine.accelerators.ranges).run(machine, values)
        if overrides:
            ranges = machine.accelerators.ranges
            return compile_source(self._source, self.settings, overrides, ranges=ranges).run(machine)
        return self.run(machine)

    def _with(self, values: Mapping[str, float | str], ranges: Ranges | None) -> MintProgram:
        """The program with values written into it; the last few are kept."""
        key = tuple(sorted(values.items()))
        found = self._others.get(key)
        if found is None:
            if len(self._others) >= MOST_KEPT:
                self._others.clear()
            found = compile_source(self._source, self.settings, values, self.given, ranges)
            self._others[key] = found
        return found

    @property
    def _source(self) -> Source:
        from motionlang.source import Source

        return Source(self.name, self.text)

    def _line_of(self, place: int) -> int:
        """The line of a place in the code; only for one that stands nowhere in it the text is parsed again."""
        outline = self.outline
        line = outline[1].get(place) if outline is not None else None
        if line is not None:
            return line
        from motionlang.mint.syntax.parser import parse

        return parse(self._source).line(place)

    def run(self, machine: Machine, values: Mapping[str, float | str] | None = None) -> Task:
        """The parent task of the program as it stands, with `values` for the names that it is given."""
        environment = Environment(machine)
        environment.prepare()
        code = self.code
        environment.files[FILE] = code.places
        environment.line_of = self._line_of
        operations = environment.make_operations(code.specs)
        namespace: dict[str, object] = {f"k{n}": operation for n, operation in enumerate(operations)}
        namespace.update(E=environment, P=environment.say, T=environment.operations.now)
        if values:
            namespace.update({given_name(name): value for name, value in values.items()})
        cells = code.link(namespace, environment.time_cells)
        environment.variables = lambda: [cell.cell_contents for cell in cells]
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
    given: Mapping[str, bool] | None = None,
    ranges: Ranges | None = None,
) -> MintProgram:
    """The program of a text, `overrides` in the place of its own values. ProgramError with every mistake."""
    from motionlang.mint.compile.compiler import compile_text

    compiled = compile_text(source, settings, overrides, given, ranges)
    warnings = compiled.problems.of_the_run()
    return MintProgram(compiled.code, source.name, source.text, settings, warnings, given, compiled.outline)


def compile_given(
    source: Source,
    settings: dict[str, object] | None,
    values: Mapping[str, float | str],
    ranges: Ranges | None = None,
) -> MintProgram:
    """The program of a text that is to be run with many values of some names, such as `values`.

    Names whose value decides how the program is made, such as the size of an array, are not among what it is `given`:
    it is compiled anew for each of their values. ProgramError with every mistake of the text with `values`.
    """
    compile_source(source, settings, values, None, ranges)
    given = {name: isinstance(value, str) for name, value in values.items()}
    try:
        return compile_source(source, settings, {}, given, ranges)
    except ProgramError:
        given = {}
    for name, value in values.items():
        one = {name: isinstance(value, str)}
        others = {n: v for n, v in values.items() if n != name and n not in given}
        try:
            compile_source(source, settings, others, given | one, ranges)
        except ProgramError:
            continue
        given |= one
    others = {n: v for n, v in values.items() if n not in given}
    if not given:
        others = {}
    return compile_source(source, settings, others, given, ranges)


def load(payload: bytes) -> MintProgram:
    """The program that `MintProgram.payload` was made of."""
    from marshal import loads

    code, name, text, settings, warnings, outline = loads(payload)
    program = MintProgram(loaded(code), name, text, settings, outline=outline)
    program._warnings = warnings
    return program


def _warning(code: str, message: str, line: int, column: int, length: int, hint: str) -> Diagnostic:
    from motionlang.errors import Diagnostic

    return Diagnostic(code, message, line, column, length=length, hint=hint, severity="warning")
