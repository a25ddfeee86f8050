"""The benchmarks run, and a figure beyond its limit is an error.

The limits themselves apply to an idle machine.
"""

from __future__ import annotations

import pytest

from benchmarks import __main__ as driver
from benchmarks.programs import PROGRAMS, SHIFT, Program
from benchmarks.styles import COMPUTING, STYLES
from motionlang.kernel import Source
from tests import proof


@pytest.mark.slow
def test_every_style_runs() -> None:
    assert len(STYLES) >= 85
    assert STYLES.keys() >= COMPUTING
    for name, style in STYLES.items():
        assert driver.started(style).run(0.05) == "until", name


def test_a_style_is_measured_in_machine_time() -> None:
    assert driver.main(["rest_pause"]) == 0


def test_a_figure_beyond_its_limit_is_marked(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(PROGRAMS, "shift", Program(lambda: 3.0, "x real time", 4.0, True))
    monkeypatch.setitem(PROGRAMS, "start", Program(lambda: 3.0, "x an empty Python", 4.0, False))
    assert driver.main(["shift", "start"]) == 1
    shift, start, total = capsys.readouterr().out.splitlines()
    assert shift.endswith("at least 4  BEYOND ITS LIMIT")
    assert start.endswith("at most 4")
    assert total == "2 programs, 1 beyond their limits"


def test_a_name_is_that_of_a_program_a_family_or_a_style() -> None:
    assert list(driver.chosen(["motors"])) == [
        "motors",
        "motors_pause",
        "motors_while",
        "motors_error_watched",
    ]
    assert list(driver.chosen(["filter", "rest_pause"])) == [
        "filter_task_wait_1",
        "filter_timer_1",
        "rest_pause",
    ]
    assert len(driver.chosen([])) == len(PROGRAMS) + len(STYLES)


def test_an_unknown_name_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    assert driver.main(["none"]) == 2
    assert capsys.readouterr().err.startswith(
        "there is no program none: shift, parse, start, motors, hosts, rest, "
    )


@pytest.mark.slow
def test_the_shift_is_20_000_moves_in_eight_hours() -> None:
    result = proof.run(Source("shift.mnt", SHIFT), machine={})
    assert len(result.machine.log.moves) == 20_000
    assert 28_700 < result.time < 28_900
    assert proof.prove(result).holds
