"""Captures: triggers, and the times, the number and the progress of the points."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source

RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
# The instruction time is nearly 0, so that times are whole milliseconds.
MACHINE: dict[str, object] = {"controller.instruction_time": 1e-9}


def ran(text: str, **machine: object) -> Run:
    return run(Source("a.mnt", text), machine={**MACHINE, **machine}, cache=False, until=20.0)


def printed(text: str, **machine: object) -> list[str]:
    result = ran(text, **machine)
    assert [each.message for each in result.diagnostics] == []
    return list(result.output)


# The axis moves from 0 to 20, to -20 and back to 0. Ramps are 5 long, so it passes 10 and -10 at 100 per second.
RISING, FALLING, EITHER = 1, 2, 3


@pytest.mark.parametrize(
    ("mode", "value", "absolute", "position", "velocity"),
    [
        (RISING, 10, 0, 10, 100),
        (FALLING, 10, 0, 10, -100),
        (EITHER, 10, 0, 10, 100),
        (RISING, -10, 0, -10, 100),
        (FALLING, -10, 0, -10, -100),
        (EITHER, -10, 0, -10, -100),
        (RISING, 10, 1, 10, 100),
        (FALLING, 10, 1, 10, -100),
    ],
)
def test_a_position_triggers_in_its_direction(
    mode: int, value: int, absolute: int, position: int, velocity: int
) -> None:
    text = (
        RATES + "CAPTUREMODE(0) = 3 : CAPTUREMODE(1) = 4 : CAPTURENUMPOINTS = 1\n"
        f"CAPTURETRIGGERSOURCE(0) = 3 : CAPTURETRIGGERMODE(0) = {mode} : CAPTURETRIGGERVALUE(0) = {value}\n"
        f"CAPTURETRIGGERABSOLUTE(0) = {absolute} : CAPTURECOMMAND = 1\n"
        "MOVEBUFFERSIZE(0) = 3 : MOVEA(0) = 20 : MOVEA(0) = -20 : MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\n"
        "PRINT CAPTUREPOINT(0, 0) : PRINT CAPTUREPOINT(1, 0)"
    )
    assert printed(text) == [f"{position}.0000", f"{velocity}.0000"]


@pytest.mark.parametrize(("mode", "velocity"), [(RISING, -100), (FALLING, 100), (EITHER, -100)])
def test_without_its_sign_a_position_rises_on_the_way_down(mode: int, velocity: int) -> None:
    """The axis moves from 0 to -20 and back: its distance from 0 rises first."""
    text = (
        RATES + "CAPTUREMODE(0) = 3 : CAPTUREMODE(1) = 4 : CAPTURENUMPOINTS = 1\n"
        f"CAPTURETRIGGERSOURCE(0) = 3 : CAPTURETRIGGERMODE(0) = {mode} : CAPTURETRIGGERVALUE(0) = 10\n"
        "CAPTURETRIGGERABSOLUTE(0) = 1 : CAPTURECOMMAND = 1\n"
        "MOVEA(0) = -20 : MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\n"
        "PRINT CAPTUREPOINT(0, 0) : PRINT CAPTUREPOINT(1, 0)"
    )
    assert printed(text) == ["-10.0000", f"{velocity}.0000"]


@pytest.mark.parametrize(
    ("mode", "value", "absolute", "milliseconds"),
    [
        (RISING, 20, 0, 100),
        (RISING, 50, 0, 100),
        (FALLING, 20, 0, 200),
        (FALLING, 50, 0, 200),
        (EITHER, 20, 0, 100),
        (FALLING, -20, 0, 300),
        (RISING, -20, 0, 400),
        (EITHER, -20, 0, 300),
        (FALLING, -50, 0, None),
        (RISING, 20, 1, 100),
    ],
)
def test_an_analogue_input_triggers_in_its_direction(
    mode: int, value: int, absolute: int, milliseconds: int | None
) -> None:
    """Input 2 is 50 % from 100 ms to 200 ms, and -50 % from 300 ms to 400 ms.

    A rising input passes a value that it reaches, and a falling one a value that it leaves. So -50 is never passed by
    a falling input. Input 1 is 50 % from 50 ms on, which is another channel.
    """
    entries = [
        {"channel": 1, "at": 0.05, "value": 50.0},
        {"channel": 2, "at": 0.1, "for": 0.1, "value": 50.0},
        {"channel": 2, "at": 0.3, "for": 0.1, "value": -50.0},
    ]
    text = (
        "CAPTUREMODE(0) = 3 : CAPTURENUMPOINTS = 1 : CAPTURETRIGGERCHANNEL(0) = 2\n"
        f"CAPTURETRIGGERSOURCE(0) = 11 : CAPTURETRIGGERMODE(0) = {mode} : CAPTURETRIGGERVALUE(0) = {value}\n"
        f"CAPTURETRIGGERABSOLUTE(0) = {absolute} : CAPTURECOMMAND = 1\n"
        "While CAPTURESTATUS <> 3 And TIME < 600 : WAIT 1 : End While\nPRINT TIME"
    )
    (time,) = printed(text, analogue=entries)
    assert int(time) == pytest.approx(600 if milliseconds is None else milliseconds, abs=1)


@pytest.mark.parametrize(("mode", "milliseconds"), [(RISING, 100), (FALLING, 200), (EITHER, 100)])
def test_an_input_triggers_in_its_direction(mode: int, milliseconds: int) -> None:
    """Input 35 is on from 100 ms to 200 ms, and input 34 from 50 ms on."""
    entries = [{"channel": 34, "at": 0.05}, {"channel": 35, "at": 0.1, "for": 0.1}]
    text = (
        "CAPTUREMODE(0) = 3 : CAPTURENUMPOINTS = 1 : CAPTURETRIGGERCHANNEL(1) = 35\n"
        f"CAPTURETRIGGERSOURCE(1) = 13 : CAPTURETRIGGERMODE(1) = {mode} : CAPTURECOMMAND = 1\n"
        "PAUSE CAPTURESTATUS = 3\nPRINT TIME"
    )
    assert int(printed(text, input=entries)[0]) == pytest.approx(milliseconds, abs=1)


def test_the_three_settings_of_the_period() -> None:
    """The last one written applies: 500 ms of 100 points are 5 ms or 5 ticks each."""
    show = 'PRINT CAPTUREDURATION, " ", CAPTUREPERIOD, " ", CAPTUREINTERVAL'
    writes = (
        "CAPTURENUMPOINTS = 100 : CAPTUREDURATION = 500",
        "CAPTUREPERIOD = 2000",
        "CAPTUREINTERVAL = 3",
        "CAPTURENUMPOINTS = 50",
    )
    text = "".join(f"{each}\n{show}\n" for each in writes)
    assert printed(text) == ["500 5000 5", "200 2000 2", "300 3000 3", "150 3000 3"]


def test_points_are_recorded_at_once_and_then_each_period() -> None:
    """11 points are 100 ms long. After 55 ms there are 6, which are 54 %."""
    text = (
        "CAPTUREMODE(0) = 3 : CAPTURENUMPOINTS = 11 : CAPTUREPERIOD = 10000\n"
        "PRINT CAPTURESTATUS, CAPTUREPROGRESS(0), CAPTUREPROGRESS(1)\nCAPTURE = 1\n"
        "WAIT 55 : PRINT CAPTURESTATUS, CAPTURE, ' ', CAPTUREPROGRESS(0), ' ', CAPTUREPROGRESS(1)\n"
        "PAUSE CAPTURESTATUS = 3 : PRINT TIME, ' ', CAPTURE, ' ', CAPTUREPROGRESS(1)\n"
        "CAPTURE = 1 : WAIT 55 : CAPTURE = 0 : PRINT CAPTURESTATUS, ' ', CAPTUREPROGRESS(1), ' ', CAPTUREPOINT(0, 5)"
    ).replace("'", '"')
    assert printed(text) == ["000", "21 100 54", "100 0 100", "3 100 0.0000"]


def test_a_capture_that_waits_ends_without_a_point() -> None:
    """All of the time before its trigger, 0, has passed: 100 %, and 0 % behind it."""
    text = (
        "CAPTUREMODE(0) = 3 : CAPTURETRIGGERSOURCE(0) = 13 : CAPTURETRIGGERMODE(0) = 1\n"
        "CAPTURECOMMAND = 1 : PRINT CAPTURESTATUS, CAPTURE, CAPTUREPROGRESS(0), CAPTUREPROGRESS(1)\n"
        "CAPTURECOMMAND = 0 : PRINT CAPTURESTATUS, CAPTURE"
    )
    assert printed(text) == ["111000", "00"]


@pytest.mark.parametrize(
    "wait", ["PAUSE CAPTUREPROGRESS({}) >= {}", "While CAPTUREPROGRESS({}) < {} : WAIT 1 : End While"]
)
def test_progress_is_seen_at_the_time_of_its_percent(wait: str) -> None:
    """300 points are 10 ms apart, and point n comes after (n - 1) 10 ms.

    3 points are 1 % after 20 ms, 150 are 50 % after 1490 ms, and 297 are 99 % after 2960 ms.
    Of 30 ms before a trigger 10 % are 3 ms, and 50 % are 15 ms.
    """
    text = "CAPTUREMODE(0) = 3 : CAPTURENUMPOINTS = 300 : CAPTUREPERIOD = 10000\nTIME = 0 : CAPTURE = 1\n"
    text += "".join(f"{wait.format(1, percent)}\nPRINT TIME\n" for percent in (1, 50, 99))
    text += "PAUSE CAPTURESTATUS = 3\nCAPTURETRIGGERSOURCE(0) = 13 : CAPTURETRIGGERMODE(0) = 1\n"
    text += "CAPTUREPRETRIGGERDURATION = 30 : TIME = 0 : CAPTURECOMMAND = 1\n"
    text += "".join(f"{wait.format(0, percent)}\nPRINT TIME\n" for percent in (10, 50))
    assert printed(text) == ["20", "1490", "2960", "3", "15"]


def test_the_time_before_the_trigger_is_whole_periods_and_leaves_a_point() -> None:
    """35 ms are 3 periods of 10 ms; of 4 points at most 3 come before the trigger.

    The axis jogs at 100 per second, so points are 1 apart, and the trigger is at 100.
    """
    text = (
        RATES + "CAPTUREMODE(0) = 3 : CAPTUREPERIOD = 10000 : CAPTURENUMPOINTS = 6\n"
        "CAPTURETRIGGERSOURCE(0) = 3 : CAPTURETRIGGERMODE(0) = 1 : CAPTURETRIGGERVALUE(0) = 100\n"
        "CAPTUREPRETRIGGERDURATION = 35 : JOG(0) = 100 : CAPTURECOMMAND = 1 : PAUSE CAPTURESTATUS = 3\n"
        "PRINT CAPTUREPOINT(0, 0), ' ', CAPTUREPOINT(0, 3), ' ', CAPTUREPOINT(0, 5)\n"
        "CAPTURENUMPOINTS = 4 : CAPTUREPRETRIGGERDURATION = 99 : CAPTURETRIGGERVALUE(0) = 200 : CAPTURECOMMAND = 1\n"
        "PAUSE CAPTURESTATUS = 3 : PRINT CAPTUREPOINT(0, 0), ' ', CAPTUREPOINT(0, 3)\n"
        "CAPTUREPRETRIGGERDURATION = 30 : CAPTURECOMMAND = 1 : WAIT 15 : CAPTURETRIGGER : PAUSE CAPTURESTATUS = 3\n"
        "PRINT CAPTUREPOINT(0, 1) - CAPTUREPOINT(0, 0), ' ', CAPTUREPROGRESS(0), CAPTUREPROGRESS(1)"
    ).replace("'", '"')
    assert printed(text) == ["97.0000 100.0000 102.0000", "197.0000 200.0000", "1.0000 100100"]


RUNNING = "CAPTUREMODE(0) = 3 : CAPTURENUMPOINTS = 3 : CAPTUREPERIOD = 10000 : CAPTURE = 1\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (RUNNING + "CAPTURE = 1", "a capture is running"),
        (RUNNING + "CAPTUREMODE(1) = 3", "a capture is running"),
        (RUNNING + "CAPTURENUMPOINTS = 3", "a capture is running"),
        (RUNNING + "CAPTUREPERIOD = 3", "a capture is running"),
        (RUNNING + "CAPTUREPRETRIGGERDURATION = 3", "a capture is running"),
        (RUNNING + "CAPTURETRIGGER", "the capture has been triggered already"),
        ("CAPTURETRIGGER", "no capture is running"),
        (RUNNING + "WAIT 30 : CAPTURETRIGGER", "no capture is running"),
        ("PRINT CAPTUREPOINT(0, 0)", "capture channel 0 has recorded nothing"),
        (RUNNING + "PRINT CAPTUREPOINT(1, 0)", "capture channel 1 has recorded nothing"),
        (RUNNING + "PRINT CAPTUREPOINT(8, 0)", "there is no capture channel 8"),
        (RUNNING + "PRINT CAPTUREPOINT(0, 1)", "the capture has no point 1"),
        (RUNNING + "WAIT 30 : PRINT CAPTUREPOINT(0, 3)", "the capture has no point 3"),
        (RUNNING + "WAIT 30 : PRINT CAPTUREPOINT(0, -1)", "the capture has no point -1"),
        ("PRINT CAPTUREPROGRESS(2)", "there is no part of a capture 2"),
        ("CAPTURETRIGGERMODE(2) = 1", "there is no trigger 2"),
    ],
)
def test_what_a_capture_refuses(text: str, message: str) -> None:
    assert [each.message for each in ran(text).diagnostics] == [message]


def test_the_last_of_its_parts() -> None:
    text = (
        "CAPTUREMODE(7) = 13 : CAPTUREMODEPARAMETER(7) = 1 : CAPTURETRIGGERMODE(1) = 0 : CAPTURENUMPOINTS = 1\n"
        "CAPTURE = 1 : PRINT CAPTUREPOINT(7, 0), CAPTUREPROGRESS(1), CAPTUREMODENAME(7)"
    )
    assert printed(text, input=[{"channel": 34}]) == ["4.0000100Digital inputs"]


@pytest.mark.parametrize("scale", ["0.5", "2"])
@pytest.mark.parametrize(("mode", "velocity"), [(RISING, 100), (FALLING, -100)])
def test_the_direction_of_a_trigger_does_not_depend_on_the_scale(
    scale: str, mode: int, velocity: int
) -> None:
    text = (
        f"SCALE(0) = {scale}\n{RATES}CAPTUREMODE(0) = 3 : CAPTUREMODE(1) = 4 : CAPTURENUMPOINTS = 1\n"
        f"CAPTURETRIGGERSOURCE(0) = 3 : CAPTURETRIGGERMODE(0) = {mode} : CAPTURETRIGGERVALUE(0) = 10\n"
        "CAPTURECOMMAND = 1\nMOVEA(0) = 20 : MOVEA(0) = -20 : GO(0) : PAUSE IDLE(0)\n"
        "PRINT CAPTUREPOINT(0, 0) : PRINT CAPTUREPOINT(1, 0)"
    )
    assert printed(text) == ["10.0000", f"{velocity}.0000"]


@pytest.mark.parametrize(("before", "milliseconds"), [(0, 50), (40, 50), (60, 200), (190, 200), (210, 600)])
def test_a_trigger_within_the_time_before_it_is_ignored(before: int, milliseconds: int) -> None:
    """Input 35 comes on at 50 ms and at 200 ms.

    The points before the trigger are recorded first, so a trigger in this time comes too early.
    """
    entries = [{"channel": 35, "at": at, "for": 0.05} for at in (0.05, 0.2)]
    text = (
        "CAPTUREMODE(0) = 3 : CAPTURENUMPOINTS = 300 : CAPTUREPERIOD = 1000\n"
        f"CAPTUREPRETRIGGERDURATION = {before}\n"
        "CAPTURETRIGGERSOURCE(0) = 13 : CAPTURETRIGGERCHANNEL(0) = 35 : CAPTURETRIGGERMODE(0) = 1\n"
        "CAPTURECOMMAND = 1\nWhile CAPTURESTATUS = 1 And TIME < 600 : WAIT 1 : End While\nPRINT TIME"
    )
    (time,) = printed(text, input=entries)
    assert int(time) == pytest.approx(milliseconds, abs=1)
