"""What answers when the program asks, in the debugger: it answers again in the same way after a step back."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from motionlang.kernel import Source, run
from tests.ide.debug.test_debugger import at, line_of, mint, value
from tests.ide.debug.walks import differences

# A menu, a button, a part that comes when the program polls for it, and an order of a host.
MENU = """\
Dim k, n
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  Repeat : k = INKEY : Until k > 0
  If k = 48 Then Exit Loop
  PAUSE INX(1)
  Repeat
    n = n + 1
    WAIT = 20
  Until INX(2)
  MOVER(0) = 10 : GO(0) : PAUSE IDLE(0)
  PAUSE NETINTEGER(3) > 0
  NETINTEGER(3) = 0
  PAUSE INX(1) = 0 And INX(2) = 0
  PRINT TIME, " ", n
End Loop
"""
WORLD: Mapping[str, object] = {
    "run.until": 60.0,
    "key": [{"text": "1", "asked": 0.4, "times": 2}, {"text": "0", "asked": 0.7}],
    "input": [{"channel": 1, "asked": 0.3, "for": 1.5}, {"channel": 2, "asked": 0.25}],
    "netdata": [{"element": 3, "value": 1, "asked": 0.15}],
}
# Two tasks that ask for opposite levels.
TASKS = """\
Dim n
Run Other
For n = 1 To 4
  PAUSE INX(1)
  PAUSE INX(1) = 0
  PRINT "parent ", TIME
Next
End
Task Other
  Loop
    WAIT = 130
    PAUSE INX(1) And INX(2)
    PRINT "other ", TIME
    PAUSE INX(2) = 0
  End Loop
End Task
"""
MACROS = "1MN,1SV1000,1SA10000,1DS10000\nMD1,WN1,1MR100,1WS,WF1,WA0.02,IN2,JR3,NO,JR-4,RP3\nMC1\n"


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize(("name", "text"), [("menu.mnt", MENU), ("tasks.mnt", TASKS), ("macros.mcl", MACROS)])
def test_a_walk_changes_nothing(name: str, text: str, seed: int) -> None:
    assert list(differences(Source(name, text), WORLD, seed, 20.0)) == []


def test_a_step_back_behind_an_answer_is_answered_again() -> None:
    plain = run(Source("a.mnt", MENU), machine=WORLD)
    assert plain.output == ["2450 14.0000", "4900 28.0000"]
    output: list[str] = []
    debugger = mint(MENU, dict(WORLD), show=output.append)
    debugger.start()
    debugger.set_breakpoints([at(debugger, 11)])
    times = []
    for _ in range(3):
        debugger.go_on()
        assert (line_of(debugger), value(debugger, "input(2)")) == (11, 1)
        times.append(value(debugger, "time"))
        for _ in range(30):
            debugger.step_back()
        assert value(debugger, "input(2)") == 0
    assert len(set(times)) == 1
    debugger.set_breakpoints([])
    debugger.go_on()
    assert "".join(output).split("\n")[:-1] == plain.output


def test_a_condition_of_a_breakpoint_does_not_ask() -> None:
    """It is tested at each statement of a loop that never reads the input."""
    text = 'Dim n\nFor n = 1 To 40\n  WAIT = 20\nNext\nPRINT INX(2), " ", TIME\n'
    output: list[str] = []
    debugger = mint(text, dict(WORLD), show=output.append)
    debugger.start()
    debugger.set_breakpoints([at(debugger, 3, "input(2) = 1")])
    debugger.go_on()
    assert "".join(output) == "0 800\n"
