"""The rules behind the changes of an input by a hand."""

from __future__ import annotations

import pytest

from motionlang.kernel import Machine, Source, run
from motionlang_explore.exploration import Change
from motionlang_explore.identification import in_words, place
from motionlang_explore.panel.rule import rules

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
    found = rules([(time, Change("input", 3, value)) for time, value in changes], machine, {})
    assert {number: in_words(entry) for number, entry in found.items()} == ({3: words} if words else {})


def test_a_region_of_an_axis() -> None:
    """A hand changes the input whenever the axis passes 40 and 60."""
    stroke = "MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)\nMOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\n"
    machine = run(Source("a.mnt", "SPEED(0) = 20\n" + 2 * stroke)).machine
    axis, changes = machine.controller.axes[0], [(0.0, 0.0)]
    for k in range(round(machine.clock.now / 0.02)):
        level = float(40.0 <= place(axis, k * 0.02) <= 60.0)
        if level != changes[-1][1]:
            changes.append((k * 0.02, level))
    found = rules([(time, Change("input", 3, level)) for time, level in changes[1:]], machine, {})[3]
    assert (found["axis"], found["between"]) == (0, pytest.approx([40.0, 60.0], abs=0.5))


def test_a_hand_that_answers_when_it_is_asked() -> None:
    """No output changes before the input does."""
    machine, times = Machine(), (1.4, 3.4, 7.0, 8.4)
    machine.clock.advance(9.0)
    changes = [(time, Change("input", 3, 1.0 - k % 2)) for k, time in enumerate(times)]
    (entry,) = rules(changes, machine, {(3, time): 0.4 for time in times}).values()
    assert in_words(entry) == "0.4 s after it is asked for"
    assert rules(changes, machine, {(3, time): 0.4 for time in times[1:]}) == {}
