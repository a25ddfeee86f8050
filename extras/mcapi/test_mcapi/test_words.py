"""How a call and its values are written in a line of the port."""

from __future__ import annotations

import pytest

from motionlang_mcapi.protocol import decode, encode, parse, request


@pytest.mark.parametrize(
    "line",
    [
        "MCStop 1 2",
        "MCGetPositionEx 1 2 +",
        "MCGetPositionEx 1 2 -",
        "MCSetScale 1 1 6 1.0 2.0 3.0 4.0 5.0 6.0",
        "MCSetScale 1 1 -",
        "MCDecodeStatusEx 1 4 1 2 3 4 5",
        "MCGetInstalledModules 1 + 4",
        "MCGetCaptureData 1 1 16 0 2 +",
        "MCTranslateErrorEx 15 + 7",
        'pmcputs 1 "a b"',
        'MCOpen 0 2 "\\xe9\\x3d\\n\\r\\t\\"\\\\~ "',
    ],
)
def test_a_call_is_read_as_it_is_written(line: str) -> None:
    assert request(*parse(line)) == line


def test_the_words_of_values() -> None:
    """A character that is not printable in ASCII is written as its code.

    Above 255 it is `?`.
    """
    assert encode([None, 7, -2.5, 1e300]) == "- 7 -2.5 1e+300"
    assert encode(["\x1f ~\x7f\xffĀ€"]) == '"\\x1f ~\\x7f\\xff??"'
    assert decode("+ - 7 -2.5 inf -INF") == [1, None, 7, -2.5, float("inf"), float("-inf")]
    assert decode('1 "\\x41\\xFFa b" 2') == [1, "A\xffa b", 2]
