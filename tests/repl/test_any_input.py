"""Any input is answered, and a prompt follows."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import dialect
from motionlang.repl.session import Session
from tests.cases import examples

PIECES = {
    "mint": (
        "MOVER(0) = 5", "GO(0)", "MOVEA = 1", "PAUSE IDLE(0)", "JOG(1) = 3", "STOP(1)", "SPEED(0) = 0", "WAIT 5",
        "Print POS(0)", "If x Then", "Else", "End If", "For i = 1 To 3", "Next", "Dim x = 4", "x = 1 / x", "x = x - 4",
        "Sub s(a)", "End Sub", "s(3)", "End", "Exit", "(", ")", "_", '"', ":", "'", "= ", "1e999", "POS(99)",
    ),
    "mccl": (
        "1MN", "1PM", "1VM", "1GO", "1MR5", "2MA-3", "1WS0", "1ST", "1WA.1", "1TP", "TP", "MD1,1TP,RP2", "MC1", "MC2",
        "GT1", "ET1", "AL5", "AR20", "IG3", "RP3", "JR-1", "JR9", "US0", "1SV0", "1SA0", "9TP", "@5", '"', ",", "1e999",
    ),
}  # fmt: skip
PROMPTS = (
    ".run .1",
    ".settle",
    ".axes",
    ".time",
    ".report",
    ".plot",
    ".reset",
    ".help",
    ".help GO",
    ".run",
    ".x",
    ".load /",
)


@pytest.mark.parametrize("name", sorted(PIECES))
@settings(max_examples=examples(40))
@given(data=st.data())
def test_any_input_is_answered(name: str, data: st.DataObject) -> None:
    piece = st.one_of(st.sampled_from(PIECES[name]), st.sampled_from(PROMPTS), st.text(max_size=8))
    lines = data.draw(st.lists(st.lists(piece, max_size=3).map(" ".join), max_size=12))
    session = Session(dialect(name))
    session.interrupted = Patience(500).is_over
    for line in lines:
        session.feed(line)
    session.finish()
    session.interrupted = lambda: False
    session.feed(".reset")
    assert session.feed(".time") == "0 s\n"


class Patience:
    """A user who presses Ctrl-C after some polls, and holds it down."""

    def __init__(self, polls: int) -> None:
        self._left = polls

    def is_over(self) -> bool:
        self._left -= 1
        return self._left < 0
