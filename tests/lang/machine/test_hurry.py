"""A loop that starts motion after motion without a wait is reported at its line."""

from __future__ import annotations

import pytest

from motionlang import Run
from motionlang.execution import run
from motionlang.lang.machine.machine import Machine
from motionlang.source import Source
from tests.cases import cases


def ran(name: str, text: str) -> Run:
    return run(Source(name, text), cache=False, until=0.05)


@cases(
    ("name", "text", "line"),
    [
        ("a.mnt", "Dim k As Float\nLoop\n  k = k + 0.1\n  JOG(0) = k\nEnd Loop\n", 4),
        ("a.mnt", "Loop\n  JOG(1) = 5 : JOG(1) = -5\nEnd Loop\n", 2),
        ("a.mcl", "1MN\n1MR1000,RP\n", 2),
    ],
)
@pytest.mark.slow
def test_warning_is_reported_once_with_its_line(name: str, text: str, line: int) -> None:
    (found,) = ran(name, text).diagnostics
    assert (found.code, found.severity, found.line) == ("never-waits", "warning", line)


def test_many_moves_that_are_waited_for_are_none() -> None:
    text = (
        "Dim i As Integer\nFor i = 1 To 1100\n  MOVER(0) = 0.001 : GO(0)\n  PAUSE IDLE(0)\n  WAIT = 1\nNext\n"
    )
    result = run(Source("a.mnt", text), cache=False)
    assert (len(result.controller.log.moves), result.diagnostics) == (1100, [])


def test_loop_that_moves_an_axis_to_its_own_position_is_reported() -> None:
    """The loop waits for its moves, but each of them ends at the moment it begins."""
    text = "Loop\n  MOVEA(0) = 0 : GO(0)\n  PAUSE IDLE(0)\nEnd Loop\n"
    (found,) = ran("a.mnt", text).diagnostics
    assert (found.code, found.line) == ("never-waits", 2)
    assert found.message.startswith("MOVEA moves its axis to its present position ")


@pytest.mark.slow
def test_warn_is_called_once_for_each_warning(monkeypatch: pytest.MonkeyPatch) -> None:
    """The log is checked at 1024 profiles, and whenever it is full.

    It is full at 2048, and after 2048 - 512 more, at 3584. One motion every 30 us gives 4000 in 0.12 s.
    """
    monkeypatch.setattr("motionlang.log.log.MAX_PROFILES", 2048)
    reported: list[tuple[float, int]] = []

    def begun(machine: Machine) -> None:
        machine.warn = lambda diagnostic: reported.append((machine.clock.now, diagnostic.line))

    text = "Dim k As Float\nLoop\n  k = k + 0.001\n  JOG(0) = k\nEnd Loop\n"
    result = run(Source("a.mnt", text), cache=False, until=0.12, begun=begun)
    ((time, line),) = reported
    (found,) = result.diagnostics
    assert (line, time, found.count) == (4, found.first, 3)
    assert time < 0.04
    assert result.machine.warned == [found]
