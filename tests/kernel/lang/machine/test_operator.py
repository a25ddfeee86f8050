"""The operator's keys and lines, from the machine file and from a real person."""

from __future__ import annotations

from motionlang.kernel.controller import Clock
from motionlang.kernel.lang import Terminal
from motionlang.kernel.lang.machine.operator import Operator
from motionlang.kernel.log import Log


def operator(shown: list[str] | None = None, **settings: object) -> tuple[Clock, Operator]:
    clock = Clock()
    terminal = Terminal(clock, Log().prints, shown.append if shown is not None else None)
    return clock, Operator(clock, terminal, settings)


def test_keys_of_the_machine_file_come_at_their_time_and_are_held_for_a_while() -> None:
    clock, person = operator(key=[{"at": 1.0, "text": "ab", "for": 0.5}])
    assert (person.next_key(), person.held_key()) == (0, 0)
    clock.advance(1.2)
    assert (person.next_key(), person.held_key()) == (97, 98)
    clock.advance(1.5)
    assert (person.next_key(), person.next_key(), person.held_key()) == (98, 0, 0)


def test_a_live_operator_types_keys_and_where_the_program_asks_a_line() -> None:
    shown: list[str] = []
    _, person = operator(shown)
    person.type("x")
    person.asking = True
    person.type("12\x7f3\ry")
    assert (person.keys, person.lines, person.asking) == ([120, 121], [("13", "")], False)
    assert "".join(shown) == "12\b \b3\b \b\b \b"


def test_unread_keys_are_limited() -> None:
    _, person = operator()
    for _ in range(20_000):
        person.type("x")
    assert len(person.keys) == 10_000
