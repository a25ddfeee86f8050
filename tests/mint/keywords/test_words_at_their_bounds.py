"""Hints with ranges, logged outputs, and modes without an effect."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source

# A number outside its range, and the hint.
LIMITS = {
    "TASKPRIORITY(T) = n\nTask T\nEnd Task": "it takes 0 to 255",
    "SPEED(0) = n - 301": "it takes 0 to 8388607",
    "POS(0) = n * 1e308": "a position is finite, in counts too",
    "JOG(0) = n * 1e308 - n * 1e308": "it takes -8388607 to 8388607",
}


@pytest.mark.parametrize("text", LIMITS)
def test_a_hint_has_the_range(text: str) -> None:
    result = run(Source("a.mnt", f"Dim n As Integer = 300\n{text}"), cache=False, until=10.0)
    assert [each.hint for each in result.diagnostics] == [f"{LIMITS[text]} (Mint error 3, value invalid)"]


def test_an_output_is_logged_as_1_or_0_when_it_changes() -> None:
    text = "OUTX(5) = 7 : OUTX(5) = 1 : OUTX(6) = -1 : OUTX(5) = 0 : OUT(1) = 5"
    result = run(Source("a.mnt", text), cache=False)
    assert [(each.channel, each.value) for each in result.controller.log.outputs] == [
        (5, 1),
        (6, 1),
        (5, 0),
        (32, 1),
        (34, 1),
    ]


def test_a_mode_of_an_encoder_that_has_no_effect_is_reported() -> None:
    """0 and 8, the virtual axis, have their effect."""
    for mode, reported in ((0, []), (8, []), (2, ["AUXENCODERMODE"])):
        result = run(Source("a.mnt", f"AUXENCODERMODE(0) = {mode}"), cache=False)
        assert list(result.machine.without_effect) == reported
