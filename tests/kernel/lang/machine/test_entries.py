"""Entries of the machine file as short texts, given by options and by callers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest

import motionlang
from motionlang.kernel import Source, WrongEntry, entries, with_entries

NAMES: dict[str, object] = {
    "input": [{"channel": 7, "name": "Clamp", "at": 3.0}],
    "analogue": [{"channel": 1, "name": "force", "value": 5.0}],
}


@pytest.mark.parametrize(
    ("text", "entry"),
    [
        ("2", {"channel": 2, "value": 1}),
        ("2=on", {"channel": 2, "value": 1}),
        ("2=1@0.5", {"channel": 2, "value": 1, "at": 0.5}),
        ("2=0@0.5", {"channel": 2, "value": 0, "at": 0.5}),
        ("2=1@0.5..0.9", {"channel": 2, "value": 1, "at": 0.5, "for": 0.4}),
        ("2=1@every 1.2", {"channel": 2, "value": 1, "at": 1.2, "for": 0.6, "every": 1.2}),
        ("2=1@1 every 4", {"channel": 2, "value": 1, "at": 1.0, "for": 2.0, "every": 4.0}),
        ("2=1@1..1.5 every 4", {"channel": 2, "value": 1, "at": 1.0, "for": 0.5, "every": 4.0}),
        ("2=out4", {"channel": 2, "output": 4, "delay": 0.0}),
        ("2=OUT4 + 0.3", {"channel": 2, "output": 4, "delay": 0.3}),
        ("clamp=1@1", {"channel": 7, "value": 1, "at": 1.0}),
    ],
)
def test_an_input(text: str, entry: dict[str, object]) -> None:
    assert entries(NAMES, inputs=[text]) == {"input": [entry]}


def test_a_pulse_of_0_is_on_before_and_after_it() -> None:
    assert entries({}, inputs="2=0@0.5..0.9")["input"] == [
        {"channel": 2, "value": 1, "at": 0.0},
        {"channel": 2, "value": 0, "at": 0.5},
        {"channel": 2, "value": 1, "at": 0.9},
    ]


def test_the_shortest_period() -> None:
    """It is 10 ms; the default number of repetitions has no end."""
    found: Any = entries({}, inputs="2=1@1..1.005 every 0.01")["input"]
    assert [each["every"] for each in found] == [0.01]
    with pytest.raises(WrongEntry) as wrong:
        entries({}, inputs="2=1@1..1.005 every 0.009")
    assert str(wrong.value).startswith("a period is at least 0.01 s, not 0.009 s")


def test_the_other_tables() -> None:
    found = entries(NAMES, analog="force=25@1..3", answers=[5.5, "Turns=200", "=a=b"], keys=["R@0.5", "S"])
    assert found == {
        "analogue": [{"channel": 1, "value": 25.0, "at": 1.0, "for": 2.0}],
        "answer": [{"text": "5.5"}, {"text": "200", "prompt": "Turns"}, {"text": "a=b"}],
        "key": [{"text": "R", "at": 0.5}, {"text": "S", "at": 0.0}],
    }


def test_a_caller_gives_mappings() -> None:
    found = entries(NAMES, inputs={2: True, "clamp": ["1@1", "0@2"]}, answers={"Turns": 200, "Dia": [1, 2]})
    assert [(each["channel"], each["value"], each.get("at")) for each in found["input"]] == [  # type: ignore[attr-defined]
        (2, 1, None),
        (7, 1, 1.0),
        (7, 0, 2.0),
    ]
    assert [each["text"] for each in found["answer"]] == ["200", "1", "2"]  # type: ignore[attr-defined]


FORMS = "write 2=1@0.5, 2=1@0.5..0.9, 2=1@every 1.2 or 2=out4+0.3"


@pytest.mark.parametrize(
    ("given", "message", "hint"),
    [
        ({"inputs": "2=5"}, '"5" is not a level of input 2: 0 or 1', FORMS),
        ({"inputs": "2=1@soon"}, '"soon" is not a time', FORMS),
        ({"inputs": "2=1@"}, '"" is not a time', FORMS),
        ({"inputs": "2=1@-1"}, '"-1" is not a time', FORMS),
        (
            {"inputs": "2=1@0.9..0.5"},
            "the pulse ends at 0.5 s, not after it begins at 0.9 s",
            "write 0.5..0.9",
        ),
        ({"inputs": "2=0@every 1"}, '"2=0@every 1": only a pulse of 1 repeats', FORMS),
        ({"inputs": "2=1@every 0.001"}, "a period is at least 0.01 s, not 0.001 s", FORMS),
        ({"inputs": "clmap=1"}, "the machine file names no input clmap", "did you mean clamp?"),
        (
            {"inputs": "door=1"},
            "the machine file names no input door",
            "write its number, or add name = to its entry",
        ),
        ({"inputs": "1000=1"}, '"1000" is not an input', FORMS),
        ({"analog": "0=full"}, '"full" is not a value of analogue input 0', "write 0=25@1 or 0=25@1..3"),
        ({"keys": "R@x"}, '"x" is not a time', "write R@0.5"),
        ({"keys": "@1"}, '"@1" has no keys', "write R@0.5"),
    ],
)
def test_messages_say_what_to_write(given: Mapping[str, Any], message: str, hint: str) -> None:
    with pytest.raises(WrongEntry) as wrong:
        entries(NAMES, **given)
    assert (wrong.value.message, wrong.value.hint) == (message, hint)


def test_they_replace_the_entries_of_the_machine_file() -> None:
    below: dict[str, object] = {
        "input": [{"channel": 1, "at": 1.0}, {"channel": 2, "at": 1.0}],
        "answer": [{"text": "1", "prompt": "Turns"}, {"text": "2", "prompt": "Dia"}],
    }
    laid = with_entries(below, inputs="2=1@5", answers="Dia=3")
    assert laid["input"] == [{"channel": 1, "at": 1.0}, {"channel": 2, "value": 1, "at": 5.0}]
    assert laid["answer"] == [{"text": "1", "prompt": "Turns"}, {"text": "3", "prompt": "Dia"}]
    assert with_entries(below, answers="7")["answer"] == [{"text": "7"}]


def test_an_input_repeats_until_the_end_of_the_run() -> None:
    """The input turns on at 1.2 s for 0.6 s, every 1.2 s: its third rise is at 3.6 s.

    Eight hours have 24 000 rises.
    """
    text = (
        "Dim n\nFor n = 1 To 3\nPAUSE INX(2)\nPRINT TIME\nPAUSE Not INX(2)\nPRINT TIME\nNext\n"
        "WAIT = 7200000\nPAUSE INX(2)"
    )
    run = motionlang.run(Source("m.mnt", text), inputs={2: "1@every 1.2"})
    assert run.output == ["1200", "1800", "2400", "3000", "3600", "4200"]
    assert run.status == "ended"
    assert run.time == pytest.approx(7204.8, abs=1e-3)  # 6004 periods: the first rise after 7204.2 s


def test_answers_go_to_the_question_that_they_name() -> None:
    """If an INPUT has no prompt, its question is the line printed above it.

    Answers that name no question go to the other INPUTs, in order.
    """
    text = 'INPUT "Turns ", a\nPRINT "WIRE DIA?"\nINPUT b\nINPUT "Width ", c\nPRINT a; " "; b; " "; c'
    run = motionlang.run(Source("m.mnt", text), answers=["5", "dia=2", "Turns=1"])
    assert run.output == ["Turns 1", "WIRE DIA?", "2", "Width 5", "1.0000 2.0000 5.0000"]


def test_answers_that_nothing_asks_for_are_reported() -> None:
    run = motionlang.run(Source("m.mnt", 'INPUT "Turns ", a'), answers=["1", "2", "Dia=3"])
    assert [(each.code, each.message) for each in run.diagnostics] == [
        ("unasked", 'no INPUT took the answer "2"'),
        ("unasked", 'no INPUT took the answer "3"'),
    ]


def test_what_is_asked_for_is_told_with_its_value() -> None:
    text = """\
PAUSE INX(1)
PAUSE ADC(2) > 50
PAUSE COMMS(3) > 0
PAUSE NETFLOAT(4) > 0
While MODBUSTCP16(1, 5) = 0 : End While
PRINT 1
"""
    world = {
        "input": [{"channel": 1, "asked": 0.1}],
        "analogue": [{"channel": 2, "value": 80.5, "asked": 0.1}],
        "comms": [{"element": 3, "value": 5, "asked": 0.1}],
        "netdata": [{"element": 4, "value": 2.5, "asked": 0.1}],
        "modbus.register": [{"server": 1, "register": 5, "value": 7, "asked": 0.1}],
    }
    run = motionlang.run(Source("m.mnt", text), machine=world)
    assert [each.text for each in run.machine.log.events if each.kind == "asked"] == [
        "input 1 on",
        "analogue input 2 = 80.5",
        "comms element 3 = 5",
        "network data 4 = 2.5",
        "Modbus register 5 of server 1 = 7",
    ]
