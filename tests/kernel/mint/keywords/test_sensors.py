"""Analogue inputs that follow an axis are computed when sampled, not by events."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source
from motionlang.kernel.controller.io import samples
from motionlang.kernel.controller.io.channels import AnalogueInputs
from motionlang.kernel.log.records import Sampled
from tests.kernel.mint.polling_programs import COST

HEAD = "SPEED(0, 1) = 100, 70;\nACCEL(0, 1) = 500, 900;\nDECEL(0, 1) = 500, 400;\n"
WORLD: dict[str, object] = {
    "controller.instruction_time": COST,
    "analogue": [
        {"channel": 0, "axis": 0, "above": 0.0, "value": 0.0, "per_unit": 0.5},
        {"channel": 1, "axis": 0, "between": [20.0, 60.0], "value": -3.0, "per_unit": -2.0},
        {"channel": 2, "axis": 1, "below": 30.0, "value": 5.0, "per_unit": 1.0},
        {"channel": 3, "value": 12.0, "at": 0.31},
        {"channel": 1, "value": 9.0, "at": 0.4567, "for": 0.1},
    ],
}
PROGRAMS = {
    "while": "MOVEA(0) = 100 : GO(0)\nWhile Not IDLE(0)\n  If ADC(0) > 30 Then STOP(0)\nEnd While\n"
    "PRINT TIME, POS(0)",
    "wait in the loop": "MOVEA(0) = 100 : GO(0)\nRepeat\n  WAIT(1)\nUntil ADC(0) >= 25 Or IDLE(0)\n"
    "PRINT TIME, ADC(0)",
    "pause": "MOVEA(0) = 80 : GO(0)\nPAUSE ADC(0) > 20\nPRINT TIME, ADC(0)\nPAUSE ADC(1) < -40 Or IDLE(0)\n"
    "PRINT TIME, ADC(1)\nPAUSE IDLE(0)\nPRINT TIME, ADC(0), ADC(1)",
    "sub": "MOVEA(0, 1) = 100, 50;\nGO(0, 1)\nWhile Not IDLE(0)\n  Guard\nEnd While\nPRINT TIME, ADC(2)\nEnd\n"
    "Sub Guard\n  If ADC(0) > 30 And ADC(2) < 0 Then FEEDRATEOVERRIDE(0) = 50\nEnd Sub",
    "there and back": "MOVEA(0) = 90 : MOVEA(0) = 10 : GO(0)\nPAUSE ADC(0) > 44\nPRINT TIME\n"
    "PAUSE ADC(0) < 44\nPRINT TIME\n"
    "While ADC(1) > -50 : End While\nPRINT TIME, POS(0)\nPAUSE IDLE(0)",
    "jog": "JOG(0) = 60\nPAUSE ADC(0) > 40\nPRINT TIME\nJOG(0) = -80\nWhile ADC(0) > 20 : End While\n"
    "PRINT TIME\nSTOP(0)\n"
    "PAUSE IDLE(0)\nPRINT ADC(0)",
    "gain and dead band": "ADCGAIN(0) = -150 : ADCOFFSET(0) = 20 : ADCDEADBAND(0) = 4\nMOVEA(0) = 100 : GO(0)\n"
    "While ADC(0) > 0 : End While\nPRINT TIME\nWhile ADC(0) = 0 : End While\n"
    "PRINT TIME\nWhile ADC(0) > -40 : End While\n"
    "PRINT TIME, POS(0)\nPAUSE ADC(0) < -50\nPRINT TIME, POS(0)",
    "a new position": "MOVEA(0) = 100 : GO(0)\nWAIT = 350\nPOS(0) = 5\nPAUSE ADC(0) > 33\nPRINT TIME, POS(0)",
    "a copy and a maximum": "Dim x As Float, most As Float\nMOVEA(0) = 70 : MOVEA(0) = 20 : GO(0)\nWhile Not IDLE(0)\n"
    "  x = ADC(0)\n  If ADC(0) > most Then most = ADC(0)\nEnd While\nPRINT x, most, TIME",
    "its size": "MOVEA(0) = 70 : GO(0)\nPAUSE ABS(ADC(1)) > 20\nPRINT TIME\n"
    "While ABS(ADC(1)) < 60 And Not IDLE(0)\nEnd While\nPRINT TIME",
    "a listener that comes later": "MOVEA(0) = 100 : GO(0)\nWAIT = 300\nADCMAX(0) = 35 : ADCMONITOR(0) = 1\n"
    "While Not IDLE(0) And Not AXISERROR(0) : End While\nPRINT TIME, POS(0)",
    "no reader": "MOVEA(0, 1) = 100, 50;\nGO(0, 1)\nPAUSE IDLE(0)\nPRINT TIME",
}


FORCE: dict[str, object] = {
    "analogue": [{"channel": 0, "axis": 0, "above": 0.0, "value": 0.0, "per_unit": 0.5}]
}
# Worlds with one moving sensor at a time, whose samples the log computes.
ALONE: dict[str, dict[str, object]] = {
    "a force": {"controller.instruction_time": COST, **FORCE},
    "a stretch": {
        "controller.instruction_time": COST,
        "analogue": [
            {"channel": 1, "axis": 0, "between": [20.0, 60.0], "value": -3.0, "per_unit": -2.0},
            {"channel": 1, "value": 9.0, "at": 0.4567, "for": 0.1},
            {"channel": 3, "value": 12.0, "at": 0.31},
        ],
    },
    "a constant": {
        "controller.instruction_time": COST,
        "analogue": [{"channel": 0, "axis": 0, "above": 10.0, "value": 8.0, "per_unit": 1e-12}],
    },
}


def ran(text: str, machine: dict[str, object] = WORLD, until: float = 6.0) -> Run:
    return run(Source("a.mnt", HEAD + text), machine=machine, until=until)


def outcome(result: Run) -> list[object]:
    log = result.machine.log
    moves = [(move.start_time, move.profile and move.profile.duration, move.ended) for move in log.moves]
    wrong = [each.message for each in result.diagnostics]
    return [result.output, wrong, result.status, result.time, moves, sorted(log.analogue_inputs)]


@pytest.mark.parametrize("name", PROGRAMS)
def test_samples_are_those_of_ticks_that_are_events(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    computed = outcome(ran(PROGRAMS[name]))
    monkeypatch.setattr(AnalogueInputs, "may_compute", lambda *_: False)
    assert computed == outcome(ran(PROGRAMS[name]))
    assert computed[2] == "ended"


@pytest.mark.parametrize("world", ALONE)
@pytest.mark.parametrize("name", PROGRAMS)
def test_samples_that_the_log_computes_are_those_of_ticks_that_are_events(
    name: str, world: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    computed = outcome(ran(PROGRAMS[name], ALONE[world]))
    monkeypatch.setattr(AnalogueInputs, "may_compute", lambda *_: False)
    assert computed == outcome(ran(PROGRAMS[name], ALONE[world]))


def test_a_sample_that_nothing_reads_is_not_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    """A move takes 1.2 s. Its samples are computed when the log is read."""
    computed = 0
    value_at = samples.value_at

    def counted(sampled: Sampled, position: float) -> float:
        nonlocal computed
        computed += 1
        return value_at(sampled, position)

    monkeypatch.setattr(samples, "value_at", counted)
    text = "Dim n As Integer\nFor n = 1 To 5\n  MOVEA(0) = 100 : GO(0)\n  PAUSE IDLE(0)\n  PRINT ADC(0)\n"
    found = ran(f"{text}  MOVEA(0) = 0 : GO(0)\n  PAUSE IDLE(0)\nNext\n", FORCE, until=20.0)
    assert 0 < computed <= 10 * 2 * 4
    computed = 0
    assert len(list(found.machine.log.analogue_inputs)) in range(10 * 1190, 10 * 1210)
    assert computed in range(10 * 1190, 10 * 1210)


@pytest.mark.parametrize("wait", ["PAUSE ADC(0) > 20", "While ADC(0) <= 20 : End While"])
def test_a_level_is_passed_at_a_tick(wait: str) -> None:
    """20 % is at 40 uu, reached after 0.2 s of acceleration and 0.3 s at full speed.

    The move begins just after 0, so the tick that sees it is at 501 ms.
    """
    result = ran(f"MOVEA(0) = 100 : GO(0)\n{wait}\nPRINT ADC(0) USING 1, 4\nPRINT TIME", FORCE)
    assert result.machine.log.moves[0].start_time < 1e-4
    position = 10.0 + 100.0 * (0.501 - result.machine.log.moves[0].start_time - 0.2)
    assert result.output == [f"{0.5 * position:.4f}", "501"]


def test_a_ramp_that_is_compared_is_no_event_until_it_passes() -> None:
    """The move takes 1.2 s, which is 1200 ticks."""
    result = ran("MOVEA(0) = 100 : GO(0)\nWhile Not IDLE(0)\n  If ADC(0) > 80 Then STOP(0)\nEnd While", FORCE)
    assert result.machine.clock.fired < 20
    assert len(list(result.machine.log.analogue_inputs)) == pytest.approx(1200, abs=2)
