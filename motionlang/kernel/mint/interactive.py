"""Mint at a prompt: every line is checked and written separately, and names persist.

Types, subs and tasks declared in one line are known in later lines. A new declaration of a name replaces the old one
from then on.
"""

from __future__ import annotations

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.debugging import Variable
from motionlang.kernel.lang.dialect import Interactive
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.task import Task
from motionlang.kernel.mint.check.error_recovery import with_syntax_errors
from motionlang.kernel.mint.program import MintProgram
from motionlang.kernel.mint.resolve.overrides import override, override_if_there
from motionlang.kernel.mint.resolve.symbols import PromptSymbols
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.task import PARENT, MintTask
from motionlang.kernel.mint.steps.check import check_line
from motionlang.kernel.mint.steps.inspection import variable
from motionlang.kernel.mint.steps.places import Places
from motionlang.kernel.mint.steps.program import ProgramWriter
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.parser import is_complete, parse, read
from motionlang.kernel.source import Source


class MintInteractive(Interactive):
    """The names of an interactive session on one machine."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.environment = Environment(machine, Places())
        self.environment.prepare()
        # The tasks of lines, with functions of no use when they have ended.
        self._passing: list[MintTask] = []
        self._session: PromptSymbols
        self.forget()

    def forget(self) -> None:
        """Discard all names, as before a program is run; the machine does not change."""
        self._session = PromptSymbols()
        self.environment.forget_program()

    def is_complete(self, text: str) -> bool:
        return is_complete(text)

    def task(self, source: Source) -> Task:
        """Return the task of a line that may use the names of earlier lines.

        Raises ProgramError for a line with errors, which then declares nothing.
        """
        module = read(source)
        if module.errors:
            raise ProgramError(with_syntax_errors(self._errors(module), module, set()))
        override_if_there(module, self.machine.overrides)
        return self._task_of(module, source, of_program=False)

    def _errors(self, module: Module) -> list[Diagnostic]:
        """Return the errors of a module, whose names are not known in later lines."""
        session = PromptSymbols()
        session.scope.names, session.types = dict(self._session.scope.names), self._session.types
        try:
            check_line(module, self.machine.settings, session)
        except ProgramError as error:
            return error.diagnostics
        return []

    def variables(self) -> list[Variable]:
        names, places = self._session.scope.names.values(), self.environment.places
        found = [symbol for symbol in names if symbol.kind == "variable"]
        return [variable(symbol, places.shared, places.index(symbol)) for symbol in found]

    def program(self, source: Source, strict: bool = False) -> Task:
        """Return the task of a whole program, whose lines may trigger faults of the machine file.

        A machine without a model has that of the program from then on. Raises ProgramError for errors; if `strict`,
        also if `--set` names an unknown name.
        """
        module = parse(source)
        self.machine.model = self.machine.model or MintProgram(source).target.model
        (override if strict else override_if_there)(module, self.machine.overrides)
        self.environment.timer = [self.environment.clock.now]
        return self._task_of(module, source, of_program=True)

    def _drop_ended(self) -> None:
        """Discard the steps of lines that have ended; hosts may type lines for days."""
        for task in self._passing:
            if task.done:
                self.environment.forget(task.unit.function)
        self._passing = [each for each in self._passing if not each.done]

    def _task_of(self, module: Module, source: Source, of_program: bool) -> Task:
        self._drop_ended()
        environment = self.environment
        names = check_line(module, self.machine.settings, self._session, of_program)
        writer = ProgramWriter(names, environment, lambda offset: source.location(offset)[0], {})
        environment.take(writer)
        task = MintTask(PARENT, writer.unit(names.main), environment)
        task.timer = environment.timer  # TIME continues from one line to the next
        environment.by_name[PARENT] = environment.task = task
        self._passing.append(task)
        return task
