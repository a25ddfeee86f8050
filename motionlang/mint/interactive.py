"""Mint at a prompt: every line is compiled separately, and names persist.

All variables are globals of one namespace. The time is in cells, as in a program. Types, subs and tasks
declared in one line are known in later lines. A new declaration of a name replaces the old one from then on.
"""

from __future__ import annotations

from motionlang.errors import ProgramError
from motionlang.lang.dialect import Interactive
from motionlang.lang.machine.machine import Machine
from motionlang.lang.task import Task
from motionlang.mint.compile.compiler import compile_line
from motionlang.mint.compile.overrides import override, override_if_there
from motionlang.mint.resolve.symbols import Function, Scope
from motionlang.mint.runtime.code_units import TIME, bind
from motionlang.mint.runtime.environment import Environment
from motionlang.mint.runtime.task import PARENT, MintTask
from motionlang.mint.syntax.nodes import Module
from motionlang.mint.syntax.parser import is_complete, parse
from motionlang.source import Source


class MintInteractive(Interactive):
    """The names of an interactive session on one machine."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.environment = Environment(machine)
        self.environment.prepare()
        self._inputs = 0
        # The tasks of lines that declared no function, with what is of no use when they have ended.
        self._passing: list[tuple[MintTask, list[str], str]] = []
        self._scope: Scope
        self._namespace: dict[str, object]
        self.forget()
        self.environment.variables = self._variables

    def forget(self) -> None:
        """Discard all names, as before a program is run; the machine does not change."""
        environment = self.environment
        self._scope = Scope(Function("main", "main", "main", [], None), None)
        self._namespace = {"E": environment, "P": environment.print_text, "T": environment.operations.now}
        environment.forget_program()

    def _variables(self) -> list[object]:
        return [value for name, value in self._namespace.items() if name.startswith("v_")]

    def is_complete(self, text: str) -> bool:
        return is_complete(text)

    def task(self, source: Source) -> Task:
        """Compile a line that may use the names of earlier lines.

        Raises ProgramError for a line with errors, which then declares nothing.
        """
        module = parse(source)
        override_if_there(module, self.machine.overrides)
        return self._task_of(module, of_program=False)

    def program(self, source: Source, strict: bool = False) -> Task:
        """Compile a whole program, whose lines may trigger faults of the machine file.

        Raises ProgramError for errors; if `strict`, also if `--set` names an unknown name.
        """
        module = parse(source)
        (override if strict else override_if_there)(module, self.machine.overrides)
        self.environment.timer = [self.environment.clock.now]
        return self._task_of(module, of_program=True)

    def _drop_ended(self) -> None:
        """Discard the operations of lines that have ended.

        This limits memory, because hosts may type lines for days.
        """
        for _, operations, file in [each for each in self._passing if each[0].done]:
            for name in operations:
                self._namespace.pop(name, None)
            self.environment.files.pop(file, None)
        self._passing = [each for each in self._passing if not each[0].done]

    def _task_of(self, module: Module, of_program: bool) -> Task:
        self._drop_ended()
        before = dict(self._scope.names)
        file = f"<mint {self._inputs}>"
        try:
            compiled = compile_line(
                module, self.machine.settings, self._scope, f"_{self._inputs}", file, of_program
            )
        except ProgramError:
            self._scope.names = before  # a line with errors declares nothing
            raise
        self._inputs += 1
        names = self._namespace
        names.update(zip(compiled.operations, self.environment.make_operations(compiled.specs), strict=True))
        exec(compiled.first, names)
        bind(compiled.unit, names, dict(zip(TIME, self.environment.time_cells, strict=True)))
        self.environment.files[file] = compiled.offsets
        self.environment.blocks.update((key, names[name]) for key, name in compiled.blocks.items())  # type: ignore[misc]
        if compiled.blocks:
            self.environment.listen()
        task = MintTask(PARENT, names["main"], self.environment)  # type: ignore[arg-type]
        task.priority = self.environment.priorities.get(PARENT, 0)
        self.environment.tasks[PARENT] = task
        task.timer = self.environment.timer  # TIME continues from one line to the next
        if compiled.unit.names == ("main",) and not compiled.blocks:
            self._passing.append((task, compiled.operations, file))
        return task
