"""The rules behind the changes of an input by a hand."""

from __future__ import annotations

import pytest

from motionlang.commands.panel.rule import in_words, rules
from motionlang.exploration import Change
from motionlang.kernel import Machine

# Output 1 is on from 1 to 2 s, and again from 4 to 5 s.
SWITCHED = ((1.0, 1), (2.0, 0), (4.0, 1), (5.0, 0))


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ([(1.2, 1), (2.2, 0), (4.2, 1), (5.2, 0)], "follows output 1 after 0.2 s"),
        ([(0.5, 1), (1.1, 0), (2.1, 1), (4.1, 0)], "follows output 1, inverted, after 0.1 s"),
        ([(1.3, 1), (1.5, 0), (4.3, 1), (4.5, 0)], "on for 0.2 s, 0.3 s after output 1 goes on"),
        ([(2.3, 1), (2.7, 0), (5.3, 1), (5.7, 0)], "on for 0.4 s, 0.3 s after output 1 goes off"),
        ([(1.2, 1)], ""),
        ([(3.5, 1), (3.6, 0)], ""),
    ],
)
def test_the_rule_of_an_input(changes: list[tuple[float, float]], words: str) -> None:
    machine = Machine()
    for time, level in SWITCHED:
        machine.clock.advance(time)
        machine.controller.set_output(1, level)
    found = rules([(time, Change("input", 3, value)) for time, value in changes], machine)
    assert {number: in_words(entry) for number, entry in found.items()} == ({3: words} if words else {})
