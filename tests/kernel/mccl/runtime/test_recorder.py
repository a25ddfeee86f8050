"""The calls that MCCL makes to the controller, recorded without physics."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.kernel import Machine, Scheduler, Source
from motionlang.kernel.controller import Channels
from motionlang.kernel.controller.listeners import Listeners
from motionlang.kernel.mccl import MacroFile
from tests.recorder import Recorder
from tests.verbs import VERBS

# Readings, and the board's calls at power-up, are not the subject of a test.
QUIET = {"setting", "is_idle", "is_enabled", "position", "velocity", "target", "following_error", "idle_time",
         "is_at_standstill", "standstill_time", "master_of"}  # fmt: skip


class Written(Recorder):
    """A recorder that has the channels and listeners to which the board subscribes."""

    def __init__(self, **answers: Any) -> None:
        super().__init__(2, 1, {"setting": 100.0, "target": 500.0, **answers})
        self.inputs, self.analogue_inputs = Channels(self.clock), Channels(self.clock)
        self.listeners = Listeners()


def calls(text: str, **answers: Any) -> list[tuple[Any, ...]]:
    """Return the verbs that a program calls, in order."""
    machine = Machine({"controller.axes": 2}, first_axis=1)
    recorder = Written(**answers)
    machine.controller, machine.clock = recorder, recorder.clock  # type: ignore[assignment]
    task = MacroFile(Source("test.mcl", text)).start(machine)
    recorder.calls.clear()
    Scheduler(machine, task).run_program(1.0)
    return [call for call in recorder.calls if call[0] not in QUIET]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1MN", [("set_scale", 1, 1.0, 1.0, 0.0), ("enable", 1)]),
        ("1US1200,1UR60,1UO2,1MN", [("set_scale", 1, 1200.0, 60.0, 2400.0), ("enable", 1)]),
        ("MF", [("disable", 1), ("disable", 2)]),
        ("1SV4000.4", [("configure", 1, "speed", 4000.0)]),
        ("SA5", [("configure", 1, "accel", 5.0), ("configure", 2, "accel", 5.0)]),
        ("1US100,1UR60,1MN,1SV600,1SA3600", [
            ("set_scale", 1, 100.0, 60.0, 0.0), ("enable", 1),
            ("configure", 1, "speed", 1000.0), ("configure", 1, "accel", 100.0),
        ]),
        ("1PS0.1", [("configure", 1, "ramp", 0.1), ("configure", 1, "shape", "scurve")]),
        ("1PS", [("configure", 1, "shape", "sinusoidal")]),
        ("1PP,2PT", [("configure", 1, "shape", "parabolic"), ("configure", 2, "shape", "trapezoid")]),
        ("1MA-7.6", [("move_to", 1, -8.0, "MA", 1)]),
        ("\n2MR10", [("move_to", 2, 510.0, "MR", 2)]),
        ("GH", [("move_to", 1, 0.0, "GH", 1), ("move_to", 2, 0.0, "GH", 1)]),
        ("1VM,1DI1,1SV5,1GO", [("configure", 1, "speed", 5.0), ("jog", 1, -100.0, "GO", 1)]),
        ("1ST,2AB", [("stop", 1), ("abort", 2)]),
        ("1DH77", [("define_position", 1, 77.0)]),
        ("CN33,CF34", [("set_output", 33, 1), ("set_output", 34, 0)]),
        ("AL5,OA2", [("set_analogue_output", 2, 50.0)]),
        ("1WP100", [("crossing_time", 1, 100.0)]),
    ],
)  # fmt: skip
def test_a_command_is_its_verbs(text: str, expected: list[tuple[Any, ...]]) -> None:
    made = calls(text)
    assert made[: len(expected)] == expected
    assert len(made) == len(expected) or text == "1WP100"
    assert {call[0] for call in made} <= set(VERBS)


def test_a_reversal_is_braked_for_before_the_new_target_is_given() -> None:
    answers = {
        "is_idle": False,
        "velocity": 100.0,
        "position": 0.0,
        "setting": "trapezoid",
        "standstill_time": 1.0,
    }
    answers |= {"setting": 100.0, "is_at_standstill": False}
    # 100 counts/s at 100 counts/s2 come to rest at 50: the target is behind that.
    assert calls("1MA-500", **answers) == []
