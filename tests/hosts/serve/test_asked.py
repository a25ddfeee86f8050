"""What answers when the program asks, while it is served: with several clocks it answers as in a run."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang.hosts.serve.outside import LockStepQueue, QuestionQueue, RealTimeQueue
from tests.hosts.serve.test_modbus import Served

# The client reads when the input has come; element 9 ends the program.
TEXT = """\
Repeat : WAIT = 10 : Until INX(1)
NETINTEGER(2) = TIME
PAUSE NETINTEGER(9)
PRINT NETINTEGER(2)
"""
WORLD: dict[str, object] = {
    "input": [{"channel": 1, "asked": 0.05}],
    "netdata": [{"element": 5, "value": 7, "asked": 0.1}],
}


@pytest.mark.parametrize("clock", [lambda: RealTimeQueue(20.0), LockStepQueue])
def test_it_answers_while_a_client_reads(clock: Callable[[], QuestionQueue]) -> None:
    served = Served(TEXT, clock(), WORLD)
    try:
        while not (found := served.read(4, 2)[0]):
            assert served.read(10, 2) == [0, 0]  # the client's own reads ask for nothing
        result = served.end()
    finally:
        served.close()
    assert found == 60
    assert result.output == ["60"]
