"""Registers that a loop counts, their steps, and the constants they meet."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.fast.command_counters import Counter, _counters_in, uses_register
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
