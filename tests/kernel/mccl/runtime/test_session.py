"""MCCL at the prompt: registers, and errors in a macro of an earlier line."""

from __future__ import annotations

import pytest

from motionlang.kernel import Diagnostic, Machine, Rejected, Scheduler, Source
from motionlang.kernel.mccl import DIALECT


class Prompt:
    """Prompt at which a test enters one line after the other, numbered throughout."""

    def __init__(self, **overrides: float) -> None:
        self.machine = Machine(first_axis=1, overrides=overrides)
        self.session = DIALECT.interactive(self.machine)
        self.lines = 0

    def enter(self, line: str) -> list[str]:
        """Enter a line and return its output."""
        task = self.session.task(Source("input", "\n" * self.lines + line))
        self.lines += 1
        before = len(self.machine.terminal.lines)
        scheduler = Scheduler(self.machine.controller, task)
        self.machine.scheduler = scheduler
        scheduler.tasks.extend(self.session.board.background.values())  # type: ignore[attr-defined]
        scheduler.run_program()
        return self.machine.terminal.lines[before:]

    def mistake(self, line: str) -> Diagnostic:
        """Enter a line and return its only diagnostic."""
        self.machine.diagnostics.clear()
        self.enter(line)
        (found,) = self.machine.diagnostics
        return found


def test_registers_are_given_from_outside() -> None:
    prompt = Prompt(R10=5.0, r3=2.5)
    assert prompt.enter("TR10,TR3") == ["5", "2.500000"]
    assert prompt.enter("AL1,AR3") == []
    assert prompt.enter("TR3") == ["1"]


def test_a_name_that_is_no_register() -> None:
    with pytest.raises(Rejected, match="SPEED is not a register"):
        Prompt(SPEED=5.0)


def test_a_mistake_in_a_macro_of_an_earlier_line_is_where_the_macro_is() -> None:
    prompt = Prompt()
    prompt.enter("MD1,AL5,AS1,XX7,AL9")
    prompt.enter("1TP")
    found = prompt.mistake("1TP,2TP,MC1")
    assert (found.line, found.column, found.length) == (1, 13, 3)
    found = prompt.mistake("MJ1")
    assert (found.line, found.column, found.length) == (1, 13, 3)


def test_a_mistake_in_a_background_task_is_where_the_macro_is() -> None:
    prompt = Prompt()
    prompt.enter("MD1,WA0.1,XX")
    prompt.enter("GT1")
    found = prompt.mistake("WA0.2")
    assert (found.line, found.column, found.length) == (1, 11, 2)


def test_a_mistake_in_the_line_itself() -> None:
    prompt = Prompt()
    prompt.enter("MD1,AL5")
    found = prompt.mistake("MC1,XX")
    assert (found.line, found.column, found.length) == (2, 5, 2)
    found = prompt.mistake("1TP," * 100)
    assert (found.line, found.column) == (3, 1)
