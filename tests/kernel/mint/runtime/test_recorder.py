"""Mint without physics: the verbs that it calls, in counts and seconds."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.kernel import Machine, Scheduler, Source
from motionlang.kernel.mint import DIALECT
from tests.recorder import Recorder


def heard(text: str, **answers: Any) -> list[tuple[Any, ...]]:
    """Return the calls of the controller, without those of the start-up.

    At start-up, Mint sets every axis so that its speeds act at once.
    """
    machine = Machine()
    recorder = Recorder(answers=answers)
    machine.controller, machine.clock = recorder, recorder.clock  # type: ignore[assignment]
    task = DIALECT.compile(Source("a.mnt", text)).start(machine)
    recorder.calls.clear()
    Scheduler(machine, task).run_program()
    return recorder.calls


@pytest.mark.parametrize(
    ("statement", "calls"),
    [
        ("SPEED(1) = 250", [("configure", 1, "speed", 250.0)]),
        ("SPEED = 250", [("configure", 0, "speed", 250.0)]),
        ("SPEED(0, 2) = 10;", [("configure", 0, "speed", 10.0), ("configure", 2, "speed", 10.0)]),
        ("ACCELTIME(0) = 200", [("configure", 0, "accel_time", 0.2)]),
        ("STOP(0, 1)", [("stop", 0, "stop", False), ("stop", 1, "stop", False)]),
        ("GO(0, 1)", [("go", (0, 1))]),
        ("CANCEL(3)", [("abort", 3), ("clear_faults", 3)]),
        ("DRIVEENABLE(2) = 0", [("disable", 2)]),
        ("DRIVEENABLE(2) = 1", [("enable", 2)]),
        ("POS(0) = 5", [("define_position", 0, 5.0)]),
        ("MOVER(0) = -5", [("room", 0), ("load_by", 0, -5.0, "MOVER", 1)]),
        ("MOVEA(0) = 5", [("room", 0), ("load_to", 0, 5.0, "MOVEA", 1)]),
    ],
)
def test_a_statement_is_a_verb(statement: str, calls: list[tuple[Any, ...]]) -> None:
    assert heard(statement) == calls


def test_values_pass_through_the_scale() -> None:
    calls = heard("SCALE(0) = 100\nSPEED(0) = 2\nACCEL(0) = 3\nMOVER(0) = 4\nMOVEA(1) = 4")
    assert calls == [
        ("set_scale", 0, 100.0, 1.0, 0.0),
        ("configure", 0, "speed", 200.0),
        ("configure", 0, "accel", 300.0),
        ("room", 0),
        ("load_by", 0, 400.0, "MOVER", 4),
        ("room", 1),
        ("load_to", 1, 4.0, "MOVEA", 5),
    ]


def test_recorded_values_are_in_user_units() -> None:
    assert heard("SCALE(0) = 100\nSPEED(1) = POS(0) + VEL(0)", position=250.0, velocity=50.0)[-1] == (
        "configure",
        1,
        "speed",
        3.0,
    )


def test_conditions_ask_the_controller() -> None:
    assert heard("If IDLE(0) Then STOP(0)", is_idle=True)[-1] == ("stop", 0, "stop", False)
    assert heard("If IDLE(0) Then STOP(0)", is_idle=False) == [("is_idle", 0)]
