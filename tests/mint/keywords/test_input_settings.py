"""Input settings apply to readings before and after the first one."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source


def output(text: str) -> list[str]:
    """Return the lines that a program prints.

    Analogue input 0 is at 40 %, and input 3 turns on at 0.5 ms.
    """
    machine = {"analogue": [{"channel": 0, "value": 40.0}], "input": [{"channel": 3, "at": 0.0005}]}
    result = run(Source("inputs.mnt", text), machine=machine, cache=False)
    assert not result.diagnostics
    return result.output


def test_an_analogue_input_follows_its_settings() -> None:
    """A gain of 50 % makes 20, plus 5 is 25: 1 from the middle of the dead band, 26.

    -400 % of 40 plus 5 is below the range, which is -100 to 100 first and then 0 to 100; 400 % is above it.
    """
    text = """WAIT(1) : PRINT ADC(0)
ADCGAIN(0) = 50 : PRINT ADC(0)
ADCOFFSET(0) = 5 : PRINT ADC(0)
ADCDEADBANDOFFSET(0) = 26 : ADCDEADBAND(0) = 2 : PRINT ADC(0)
ADCGAIN(0) = -400 : PRINT ADC(0)
ADCMODE(0) = 1 : PRINT ADC(0)
ADCGAIN(0) = 400 : PRINT ADC(0)
"""
    assert [float(line) for line in output(text)] == [40, 20, 25, 26, -100, 0, 100]


def test_an_input_shows_its_level_edge_and_active_level() -> None:
    """The first reading of an edge clears it; active low inverts the level."""
    text = """WAIT(1) : PRINT INX(3)
PRINT INX(4)
INPUTMODE(0) = 8 : PRINT INX(3)
PRINT INX(3)
INPUTMODE(0) = 0 : PRINT INX(3)
INPUTACTIVELEVEL(0) = -9 : PRINT INX(3)
INPUTDEBOUNCE(0) = 5 : PRINT INX(3)
"""
    assert output(text) == ["1", "0", "1", "0", "1", "0", "0"]


@pytest.mark.parametrize(
    "statement", ["k = INX(1000)", "x = ADC(64)", "OUTX(1000) = 1", "k = INX(-1)", "x = ADC(-1)"]
)
def test_a_channel_that_does_not_exist_is_rejected(statement: str) -> None:
    result = run(Source("inputs.mnt", f"Dim k As Integer, x As Float\nk = 0\n{statement}\n"), cache=False)
    (diagnostic,) = result.diagnostics
    assert (diagnostic.code, diagnostic.line) == ("channel", 3)
