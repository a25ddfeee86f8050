"""A compiled Mint program, started on a machine or stored as bytes for later runs."""

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
    from motionlang.mint.compile.stops import Stops
    from motionlang.mint.runtime.code_units import Code
    from motionlang.source import Source

# The maximum number of programs with other values that are cached for further runs.
MAX_STORED = 64
# Larger numbers are written into the program, because the code assumes that given values are finite.
LARGEST = 1e300


class MintProgram(Program):
    """A program with its source; `--set` changes constants, which are in the code.

    The values of names in `given` are bound when the program starts instead. It maps each name to True if its value
    is a string.
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
        stops: Stops | None = None,
    ) -> None:
        self.stops = stops  # the source offsets of statements and the variables, in a debug build
        self._outline = outline  # packed, because it is rarely needed
        self.code, self.name, self.text, self.settings = code, name, text, dict(settings or {})
        self.given = given or {}
        self._others: dict[tuple[tuple[str, float | str], ...], MintProgram] = {}
        self._warnings = [(each.code, each.message, each.line, each.column, each.length, each.hint)
                          for each in warnings]  # fmt: skip
        self._remarks: Sequence[str] = ()

    @property
    def size(self) -> int:
        """The number of compiled units, which grows while the program runs."""
        return self.code.size

    @property
    def warnings(self) -> list[Diagnostic]:
        """Warnings about keywords that are not simulated and may end the run early."""
        if not self._warnings:
            return []
        return [_warning(*each) for each in self._warnings]

    @property
    def remarks(self) -> Sequence[str]:
        """Chosen defaults that the motion depends on, a line each."""
        return self._remarks

    def payload(self) -> bytes:
        """Return the program as bytes, for `load`."""
        from marshal import dumps

        everything: Any = (
            self.code.payload(),
            self.name,
            self.text,
            self.settings,
            self._warnings,
            self._remarks,
            self._outline,
            self.stops,
        )
        return dumps(everything)

    @property
    def outline(self) -> Outline | None:
        """Return the program's blocks, and the line of each source offset in its code."""
        if not self._outline:
            return None
        from marshal import loads

        blocks, lines = loads(self._outline)
        return blocks, dict(zip(self.code.offsets, lines, strict=True))

    @property
    def offsets(self) -> Sequence[int]:
        return () if self.stops is None else self.stops[0]

    def start(self, machine: Machine) -> Task:
        """Return the parent task, bound to `machine`.

        Raises ProgramError if an override names no name of the program.
        """
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
            debug = self.stops is not None
            return compile_source(self._source, self.settings, overrides, ranges=ranges, debug=debug).run(
                machine
            )
        return self.run(machine)

    def _with(self, values: Mapping[str, float | str], ranges: Ranges | None) -> MintProgram:
        """Return the program compiled with these values; the last few are cached."""
        key = tuple(sorted(values.items()))
        found = self._others.get(key)
        if found is None:
            if len(self._others) >= MAX_STORED:
                self._others.clear()
            found = compile_source(self._source, self.settings, values, self.given, ranges)
            self._others[key] = found
        return found

    @property
    def _source(self) -> Source:
        from motionlang.source import Source

        return Source(self.name, self.text)

    def _line_of(self, offset: int) -> int:
        """Return the line of a source offset.

        The text is parsed again only for an offset that the code does not contain.
        """
        outline = self.outline
        line = outline[1].get(offset) if outline is not None else None
        if line is not None:
            return line

        return self._source.location(offset)[0]

    def run(self, machine: Machine, values: Mapping[str, float | str] | None = None) -> Task:
        """Return the parent task of the program as compiled.

        `values` are the values of its given names.
        """
        environment = Environment(machine)
        environment.prepare()
        code = self.code
        environment.files[FILE] = code.offsets
        environment.line_of = self._line_of
        operations = environment.make_operations(code.specs)
        namespace: dict[str, object] = {f"k{n}": operation for n, operation in enumerate(operations)}
        namespace.update(E=environment, P=environment.print_text, T=environment.operations.now)
        if values:
            namespace.update({given_name(name): value for name, value in values.items()})
        hook = machine.hook
        cells = code.link(namespace, environment.time_cells, () if hook is None else hook.cells)
        environment.variables = lambda: [cell.cell_contents for cell in cells]
        environment.blocks = {key: namespace[name] for key, name in code.blocks.items()}  # type: ignore[misc]
        if len(environment.blocks) > 1:
            environment.listen()
        if self.stops is not None:
            from motionlang.mint.runtime.debugging import Inspection, stopper

            assert hook is not None, "a debug build needs a machine with a hook"
            namespace["B"] = stopper(hook, environment)
            shared = dict(zip(code.shared, cells, strict=True))
            hook.inspection = Inspection(environment, self.stops[1], shared)
        task = environment.tasks[PARENT] = MintTask(PARENT, environment.blocks["main"], environment)
        task.timer = environment.timer
        return task


def compile_source(
    source: Source,
    settings: dict[str, object] | None = None,
    overrides: Mapping[str, float | str] | None = None,
    given: Mapping[str, bool] | None = None,
    ranges: Ranges | None = None,
    debug: bool = False,
) -> MintProgram:
    """Compile a program, with `overrides` in place of its own values.

    With `debug` the program counts its statements. Raises ProgramError with all errors.
    """
    from motionlang.mint.compile.compiler import compile_text

    compiled = compile_text(source, settings, overrides, given, ranges, debug)
    code, outline, warnings = compiled.code, compiled.outline, compiled.problems.of_the_run()
    program = MintProgram(code, source.name, source.text, settings, warnings, given, outline, compiled.stops)
    program._remarks = compiled.remarks
    return program


def compile_given(
    source: Source,
    settings: dict[str, object] | None,
    values: Mapping[str, float | str],
    ranges: Ranges | None = None,
) -> MintProgram:
    """Compile a text that will run with many values of some names, such as `values`.

    Names whose value affects the code, such as the size of an array, are not part of `given`: the text is
    compiled again for each of their values. Raises ProgramError with all errors of the text with `values`.
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
    """Recreate the program from the result of `MintProgram.payload`."""
    from marshal import loads

    code, name, text, settings, warnings, remarks, outline, stops = loads(payload)
    program = MintProgram(loaded(code), name, text, settings, outline=outline, stops=stops)
    program._warnings, program._remarks = warnings, remarks
    return program


def _warning(code: str, message: str, line: int, column: int, length: int, hint: str) -> Diagnostic:
    from motionlang.errors import Diagnostic

    return Diagnostic(code, message, line, column, length=length, hint=hint, severity="warning")
