"""Details of keywords from the printed manuals that a reader would try."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source


def ran(text: str) -> Run:
    result = run(Source("a.mnt", text), cache=False, until=10.0)
    assert [each.message for each in result.diagnostics] == []
    return result


def refused(text: str) -> list[str]:
    return [each.message for each in run(Source("a.mnt", text), cache=False, until=10.0).diagnostics]


def test_only_a_virtual_auxiliary_encoder_runs_at_its_speed() -> None:
    """MN1270 p. 34: AUXENCODERMODE.0 = 8 comes before AUXENCODERSPEED and FOLLOW.

    MASTERSOURCE comes in between.
    """
    page = """AUXENCODERMODE.0 = {}
AUXENCODERSPEED.0 = 1000
MASTERSOURCE.0 = _msAuxEncoder
FOLLOW = 1
WAIT = 1000
PRINT AUXENCODER(0) USING 1, 0, " ", AUXENCODERSPEED(0) USING 1, 0
STOP(0)
"""
    assert ran(page.format(8)).output == ["1000 1000"]
    assert ran(page.format(0)).output == ["0 1000"]
    result = ran(page.format(3))
    assert result.output == ["0 1000"]
    assert "AUXENCODERMODE" in result.machine.without_effect


@pytest.mark.parametrize("channel", [0, 1])
def test_encoder_stops_when_its_mode_is_reset(channel: int) -> None:
    text = "AUXENCODERSPEED({0}) = 50\nAUXENCODERMODE({0}) = 8\nWAIT = 1000\nAUXENCODERMODE({0}) = 0\nWAIT = 1000\n"
    text += "PRINT AUXENCODER({0}) USING 1, 1, AUXENCODERVEL({0})"
    assert ran(text.format(channel)).output == ["50.00.0000"]


def test_the_mark_of_a_move_has_16_bits() -> None:
    assert refused("MBI(0) = 70000") == ["MOVEBUFFERID cannot be 70000"]
    assert ran("MBI(0) = 32767\nMOVER(0) = 1\nGO(0)\nPRINT MOVEBUFFERIDLAST(0), MOVEBUFFERID(0)").output == [
        "3276732767"
    ]


SPLINE = "Dim way(3) As Float = 2, 10, 10\nDim times(3) As Float = 2, {}, 100\nSPLINETIME(0) = {}\n"
SPLINE += "SPLINETABLE(0, way, NULL, {})\nSPLINE(0) = 0\nGO(0)\nTIME = 0\nPAUSE IDLE(0)\nPRINT TIME\n"


@pytest.mark.parametrize(("given", "taken"), [(101, 200), (100, 200), (5, 8), (103, 204)])
def test_segments_of_splines_take_whole_steps_of_two_milliseconds(given: int, taken: int) -> None:
    """MN1270 p. 128: a segment takes 4 to 60000 ms, with a resolution of 2 ms."""
    assert ran(SPLINE.format(100, given, "NULL")).output == [str(taken)]
    assert ran(SPLINE.format(given, 100, "times")).output == [str(taken // 2 + 100)]


@pytest.mark.parametrize("given", [3, 60001, 0, -10])
def test_a_segment_of_a_spline_has_a_least_and_a_greatest_time(given: int) -> None:
    assert refused(SPLINE.format(given, 100, "times")) == [f"a segment of a spline cannot take {given} ms"]
