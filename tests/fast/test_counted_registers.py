"""Registers that a loop counts, their steps, and the constants they meet."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.fast.command_counters import (
    CountedRegisters,
    Counter,
    _counters_in,
    counters_of,
    uses_register,
)
from motionlang.mccl.resolve.command import NUMBER, REGISTER

COUNT = "recall 40, add 1, store 40"
VERBS = {
    "below": "if_below",
    "equal": "if_equal",
    "add": "add",
    "subtract": "subtract",
    "on": "if_on",
}


def command(text: str) -> Any:
    """Return a command of a verb and a number, or of a register if that begins with @."""
    verb, _, value = text.partition(" ")
    number: Any = float(value) if "." in value else int(value.lstrip("@")) if value else None
    kind = REGISTER if value.startswith("@") else NUMBER
    return SimpleNamespace(
        row=SimpleNamespace(verb=VERBS.get(verb, verb)), kind=kind, value=number, pure=True
    )


def counters(text: str, governs: int = 2) -> list[Counter]:
    return _counters_in([command(each) for each in text.split(", ")], governs)


@pytest.mark.parametrize(
    ("loop", "found"),
    [
        (f"{COUNT}, repeat", [(40, 1, (), True)]),
        (f"{COUNT}, below 3000, repeat", [(40, 1, (3000.0,), True)]),
        (f"{COUNT}, below 3000, equal 7, repeat", [(40, 1, (3000.0, 7.0), True)]),
        ("recall 40, subtract 3, store 40, repeat", [(40, -3, (), True)]),
        (f"{COUNT}, load 5, below 3000, repeat", [(40, 1, (), False)]),
        # The accumulator still has the count as the next iteration begins.
        (f"equal 4, nothing, nothing, {COUNT}, below 9, repeat", [(40, 1, (9.0, 4.0), True)]),
        (f"load 1, nothing, {COUNT}, repeat", [(40, 1, (), True)]),
        (
            f"equal 4, nothing, nothing, load 1, equal 5, nothing, nothing, {COUNT}, repeat",
            [(40, 1, (4.0,), True)],
        ),
        (f"{COUNT}, on 5, nothing, nothing, load 1, repeat", [(40, 1, (), False)]),
        (f"{COUNT}, recall 41, add 2, store 41, repeat", [(40, 1, (), False), (41, 2, (), True)]),
    ],
)
def test_the_counters_of_a_loop(loop: str, found: list[tuple[Any, ...]]) -> None:
    assert [(each.register, each.step, each.levels, each.is_left) for each in counters(loop)] == found


@pytest.mark.parametrize(
    "loop",
    [
        "recall 40, add 1, store 41, repeat",  # another register
        "recall 40, add 1.5, store 40, repeat",
        "recall 40, add 0, store 40, repeat",
        "recall 0, add 1, store 0, repeat",
        "recall @40, add 1, store @40, repeat",
        "recall 40, add @1, store 40, repeat",
        "recall 40, multiply 2, store 40, repeat",
        f"{COUNT}, recall 40, repeat",  # it is read again
        f"{COUNT}, add @40, repeat",
        f"{COUNT}, recall @7, repeat",  # any register may be read
        f"{COUNT}, add 3, repeat",  # its value is used
        f"add 3, {COUNT}, repeat",
        f"{COUNT}, below @5, repeat",
        f"on 5, {COUNT}, repeat",  # it counts in some iterations
        f"on 5, nothing, {COUNT}, repeat",
        f"{COUNT}, on 5, load 1, nothing, repeat",  # it is in the accumulator in some iterations
        f"{COUNT}, below 9, nothing, load 1, repeat",
        f"{COUNT}, jump 2, nothing, repeat",
        f"{COUNT}, jump 2, repeat",
        f"on 5, load 1, nothing, {COUNT}, repeat",
        f"{COUNT}, wait 2, repeat",
    ],
)
def test_a_loop_without_a_counter(loop: str) -> None:
    assert counters(loop) == []


def test_a_condition_governs_as_many_commands_as_the_controller_skips() -> None:
    loop = f"on 5, nothing, nothing, {COUNT}, repeat"
    assert [len(counters(loop, governs)) for governs in (1, 2, 3)] == [1, 1, 0]


@pytest.mark.parametrize(
    ("text", "uses"),
    [
        ("recall 40", True),
        ("store 40", True),
        ("recall 41", False),
        ("recall @7", True),
        ("store @7", True),
        ("add 40", False),
        ("add @40", True),
        ("add @41", False),
    ],
)
def test_a_command_that_uses_a_register(text: str, uses: bool) -> None:
    """A register may be named by another one, so RA@ and AR@ use any."""
    assert uses_register(command(text), 40) is uses


class Counting:
    """A task at the jump back of a loop; register 40 has 10, register 41 has 5.

    Commands precede the loop and follow it.
    """

    def __init__(self, loop: str, before: str = "recall 41", after: str = "store 40") -> None:
        commands = [command(each) for each in f"{before}, {loop}, {after}".split(", ")]
        self.line: Any = SimpleNamespace(commands=commands)
        self.pc, self.here = before.count(",") + 1, len(commands) - after.count(",") - 2
        self.board = SimpleNamespace(assumptions={})
        self.registers = [7, 8]
        self.memory: dict[int, float] = {40: 10, 41: 5}

    @property
    def loop(self) -> Any:
        return self.line, self.pc, self.here

    def register(self, number: int) -> float:
        return self.memory[number]

    def set_register(self, number: int, value: float) -> None:
        self.memory[number] = value


TWO = f"{COUNT}, recall 41, subtract 2, store 41, below -20, repeat"


def advanced(task: Any, *values: tuple[int, float, float]) -> list[list[int]]:
    """Return the counters of each iteration.

    It ends with given effects and values of registers 40 and 41.
    """
    made, found = CountedRegisters(task), []
    for effects, first, second in values:
        task.memory = {40: first, 41: second}
        found.append([each.register for each in made.advanced(effects)])
    return found


@pytest.mark.parametrize(
    ("values", "found"),
    [
        (((2, 11, 3), (2, 12, 1)), [[], [40, 41]]),
        (((2, 11, 3), (3, 12, 1)), [[], []]),
        (((2, 11, 3), (1, 12, 1)), [[], []]),
        (((2, 11, 3), (-1, 12, 1)), [[], []]),
        (((2, 11, 3), (2, 13, 1)), [[], []]),
        (((2, 11, 3), (2, 12, 0)), [[], []]),
        (((2, 11, 3), (2, 13, 1), (2, 14, -1)), [[], [], [40, 41]]),
        (((2, 11.0, 3.0), (2, 12.0, 1.0)), [[], []]),
    ],
)
def test_counters_must_explain_all_effects_of_an_iteration(
    values: tuple[tuple[int, float, float], ...], found: list[list[int]]
) -> None:
    """Register 40 counts by 1, and 41 by -2, both in whole numbers."""
    assert advanced(Counting(TWO), *values) == found


def test_a_loop_without_counters_is_no_count() -> None:
    assert advanced(Counting("recall 40, repeat"), (0, 11, 3), (0, 11, 3)) == [[], []]


def test_counters_advance_by_a_number_of_iterations() -> None:
    """Register 41 goes from 3 to -19 in eleven iterations, and stays above -20.

    It is left in the accumulator.
    """
    task: Any = Counting(TWO)
    made = CountedRegisters(task)
    made.advanced(2)
    task.memory = {40: 11, 41: 3}
    counters = made.advanced(2)
    assert made.leaves_accumulator(counters)
    assert made.most(counters) == 11
    made.count(counters, 11)
    assert (task.memory, task.registers) == ({40: 22, 41: -19}, [-19, 8])
    assert made.most(counters) == 0
    task.memory = {40: 23, 41: -21}
    assert [each.register for each in made.advanced(2)] == [40, 41]
    other: Any = Counting(f"{COUNT}, load 1, repeat")
    made = CountedRegisters(other)
    made.advanced(1)
    other.memory[40] = 11
    assert not made.leaves_accumulator(made.advanced(1))


def test_another_loop_of_the_task_has_other_counters() -> None:
    task: Any = Counting(TWO)
    made = CountedRegisters(task)
    assert [each.register for each in made._counters()] == [40, 41]
    task.pc += 3
    assert [each.register for each in made._counters()] == [41]
    task.here -= 1
    assert made._counters() == made._counters() != ()


ONE = f"{COUNT}, load 1, repeat"
PRIVATE_ONE = "recall 3, add 1, store 3, load 1, repeat"


@pytest.mark.parametrize(
    ("loops", "found"),
    [
        ((ONE, "on 5, nothing, repeat"), [(0, 40, True)]),
        ((TWO, "on 5, nothing, repeat"), [(0, 40, True), (0, 41, False)]),
        ((ONE, "recall 41, add 1, store 41, repeat"), [(0, 40, True), (1, 41, True)]),
        ((ONE, "recall 40, repeat"), []),
        ((ONE, "recall @7, repeat"), []),
        ((ONE, "recall 41, repeat"), [(0, 40, True)]),
        ((ONE, "call_macro 5, repeat"), []),
        ((PRIVATE_ONE, "recall 3, repeat"), [(0, 3, True)]),
        (("recall 9, add 1, store 9, load 1, repeat", "recall 9, repeat"), [(0, 9, True)]),
        (("recall 10, add 1, store 10, load 1, repeat", "recall 10, repeat"), []),
        ((ONE, ""), []),
    ],
)
def test_the_counters_of_several_tasks(loops: tuple[str, ...], found: list[tuple[int, int, bool]]) -> None:
    """A register that another task uses is none; each task has its own 0 to 9.

    No task may be without a loop, or leave its line.
    """
    tasks: list[Any] = [Counting(each) for each in loops]
    running = [(task, task.loop if loop else None) for task, loop in zip(tasks, loops, strict=True)]
    made = counters_of(running)
    assert [(tasks.index(each.task), each.counter.register, each.is_first) for each in made] == found


def test_a_task_that_has_left_its_line_counts_nothing() -> None:
    task: Any = Counting(ONE)
    loop = task.loop
    assert len(counters_of([(task, loop)])) == 1
    task.line = Counting(ONE).line
    assert counters_of([(task, loop)]) == []


def test_a_command_of_no_keyword_is_no_count() -> None:
    task: Any = Counting(ONE)
    task.line.commands[-3].row = None
    assert counters_of([(task, task.loop)]) == []


def test_a_condition_governs_two_commands_unless_assumed_otherwise() -> None:
    """With three, the count after two other commands would be governed, too."""
    loop = f"on 5, nothing, nothing, {COUNT}, repeat"
    task: Any = Counting(loop)
    assert len(CountedRegisters(task)._counters()) == 1
    task.board.assumptions["mccl.skipped"] = 3
    assert CountedRegisters(task)._counters() == ()
