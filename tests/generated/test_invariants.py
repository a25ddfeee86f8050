"""The checks of generated programs detect violations."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest

from motionlang import run
from motionlang.kernel import Run, Source
from motionlang.kernel.report import text
from tests.generated.invariants import in_order, matches_schema, phases_add_up, table_agrees
from tests.generated.prefix import differences

MOVE = "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\nMOVER(0) = 30 : GO(0)\n"
PROGRAM = f'{MOVE}WAIT = 100\nPRINT "on its way"\nSPEED(0) = 40\nSTOP(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n'


def ran(program: str, until: float = 5.0) -> tuple[Run, dict[str, Any]]:
    result = run(Source("move.mnt", program), machine={}, until=until)
    return result, json.loads(text(result))


def test_a_run_has_no_finding() -> None:
    result, report = ran(PROGRAM)
    found = [*in_order(result), *phases_add_up(report), *matches_schema(report)]
    assert [*found, *table_agrees(result, report)] == []


def test_an_event_before_the_one_before_it_is_found() -> None:
    result, _ = ran(PROGRAM)
    assert [each.kind for each in result.controller.log.events] == ["stop"]
    result.controller.log.note(0.05, "handler", text="TIMER")
    assert next(in_order(result)).startswith("order: events")


CHANGES: dict[str, tuple[Callable[[dict[str, Any]], object], str]] = {
    "a phase takes longer": (lambda move: move["phases"][0].update(duration=0.3), "phases: line 2: duration"),
    "a phase goes farther": (lambda move: move["phases"][0].update(distance=5.0), "phases: line 2: distance"),
    "a name is missing": (lambda move: move.pop("command"), "schema: $.moves[0]: 'command' is a required"),
    "a speed is below 0": (lambda move: move.update(peak_speed=-20.0), "schema: $.moves[0].peak_speed"),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_wrong_entry_is_found(name: str) -> None:
    change, found = CHANGES[name]
    _, report = ran(PROGRAM)
    change(report["moves"][0])
    (message,) = [*phases_add_up(report), *matches_schema(report)]
    assert message.startswith(found)


@pytest.mark.parametrize(
    ("rows", "name", "value"),
    [
        ("moves", "distance", 2.2),
        ("moves", "profile", "s-curve"),
        ("events", "time", 0.2),
        ("axes", "position", 2.2),
    ],
)
def test_a_figure_that_the_table_does_not_show_is_found(rows: str, name: str, value: object) -> None:
    result, report = ran(PROGRAM)
    report[rows][0][name] = value
    (message,) = table_agrees(result, report)
    assert f"for {value!r} in" in message


def test_a_wrapped_position_is_the_one_that_the_table_shows() -> None:
    assert list(table_agrees(*ran("POSWRAP(0) = 360\nMOVER(0) = -2 : GO(0)\nPAUSE IDLE(0)\n"))) == []


def test_a_row_that_the_table_lacks_is_found() -> None:
    result, report = ran(PROGRAM)
    report["moves"] *= 2
    assert list(table_agrees(result, report)) == ["table: 1 of 2 moves"]


@pytest.mark.parametrize(
    ("before", "after", "found"),
    [
        ("on its way", "on my way", "prints"),
        ("SPEED(0) = 40", "SPEED(0) = 10", "axis 0"),
        ("= 30 :", "= -30 :", "axis 0"),
        ("MOVER(0)", "MOVEA(0)", "moves"),
        ("WAIT = 100", "WAIT = 90", "waits"),
        ("STOP(0)", "CANCEL(0)", "events"),
    ],
)
def test_a_run_that_begins_differently_is_found(before: str, after: str, found: str) -> None:
    whole, prefix = ran(PROGRAM)[0], ran(PROGRAM.replace(before, after), until=0.15)[0]
    assert any(f"s: {found}" in each for each in differences(whole, prefix, 0.15))


@pytest.mark.parametrize("until", [0.05, 0.15, 0.2])
def test_a_run_that_is_cut_off_begins_as_the_whole_one_does(until: float) -> None:
    whole, prefix = ran(PROGRAM)[0], ran(PROGRAM, until)[0]
    assert prefix.time == pytest.approx(until, abs=1e-4)
    assert list(differences(whole, prefix, until)) == []
