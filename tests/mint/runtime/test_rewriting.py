"""A loop may write any keyword in each iteration, with or without skipping.

The result is that of every iteration.
"""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.controller.clock import Clock
from motionlang.controller.io.channels import Channels
from motionlang.errors import ProgramError
from motionlang.lang.keyword import Keyword
from motionlang.mint.compile import polling
from motionlang.mint.keywords import table
from motionlang.mint.runtime.loop_skipping import Site
from motionlang.source import Source
from tests.cases import one_in

WORDS = [row for row in table() if "W" in row.access and row.kind != "move" and row.verb != "wait"]
# The same value in every iteration, and two alternating ones, which a task reads meanwhile if the keyword can
# be read.
STEADY = "Loop\n  {word} = {first}\n  Wait = 100\nEnd Loop\n"
CHANGING = """\
Dim n As Integer
Run watcher
Loop
  {word} = {first}
  Wait = 10
  {word} = {second}
  Wait = 10
End Loop
Task watcher
  Loop
    If {word} = {second} Then n = n + 1 : PRINT n
    Wait = 7
  End Loop
End Task
"""


def spellings(row: Keyword) -> list[str]:
    """Return the keyword without brackets, and with a 0 for each entry in them."""
    return [row.name, f"{row.name}({zeros(row)})"]


def zeros(row: Keyword) -> str:
    """Return a 0 for each entry in the brackets of a keyword."""
    return ", ".join("0" for _ in row.index.split(", "))


def outcome(text: str) -> object:
    try:
        result = run(Source("a.mnt", text), cache=False, until=0.1)
    except ProgramError as error:
        return error.diagnostics[0].code
    told = [(each.code, each.message, each.line) for each in result.diagnostics]
    return result.output, result.status, told, result.notes, round(result.time, 9)


def outcomes(program: str, words: list[Keyword]) -> dict[str, object]:
    """Return the result of a program with each keyword, in its first valid spelling.

    The program with the most lines decides which spelling is valid.
    """
    found: dict[str, object] = {}
    for row in words:
        first, second = ('"1"', '"0"') if row.unit == "text" else (1, 0)
        for word in reversed(spellings(row)):
            if program is CHANGING and isinstance(found.get(f"{row.name}({zeros(row)})"), tuple):
                continue
            found[word] = outcome(program.format(word=word, first=first, second=second))
    return found


@pytest.mark.parametrize("first", one_in(8, range(8)))
@pytest.mark.parametrize("program", [STEADY, CHANGING], ids=["steady", "changing"])
@pytest.mark.slow
def test_keyword_that_is_written_in_every_iteration(
    program: str, first: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    words = WORDS[first::8]
    watched = outcomes(program, words)
    monkeypatch.setattr(polling, "watched", lambda *_: None)
    assert outcomes(program, words) == watched
    # Nearly all of them can be written in one spelling, and so run.
    ran = {word.partition("(")[0] for word, result in watched.items() if isinstance(result, tuple)}
    assert len(ran) > 0.9 * len(words)


def test_read_before_a_write_is_no_dependency() -> None:
    result = run(Source("a.mnt", STEADY.format(word="ENCODERRESOLUTION(0)", first=1)), cache=False, until=1.0)
    assert result.notes == ["keywords without effect here: ENCODERRESOLUTION (line 2)"]


# How long a move takes, and a watch that writes outputs by its position.
MOVE = "SPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500\nMOVEA(0) = 100 : GO(0)\n"
WATCHES = {
    "OUTX": "  If POS(0) > 50 Then OUTX(1) = 1 Else OUTX(1) = 0\n",
    "OUT": "  If POS(0) > 50 Then OUT(0) = 5 Else OUT(0) = 4\n",
    "two": "  OUTX(1) = POS(0) > 50\n  OUT(1) = 4\n",
    "array": "  If POS(0) > r(2) Then OUTX(1) = 1 Else OUTX(1) = 0\n",
}


@pytest.mark.parametrize("name", WATCHES)
def test_an_output_that_is_switched_once_costs_two_iterations(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of 40 000 iterations at most eight are executed."""
    checks, check = 0, Site.check

    def counted(self: Site, *given: object) -> object:
        nonlocal checks
        checks += 1
        return check(self, *given)  # type: ignore[arg-type]

    monkeypatch.setattr(Site, "check", counted)
    text = f"Dim r(3) As Float\nr(2) = 50\n{MOVE}While Not IDLE(0)\n{WATCHES[name]}End While\nPRINT TIME"
    found = run(Source("a.mnt", text), cache=False)
    assert found.output == ["1200"]
    changes = [each for each in found.machine.log.outputs if each.time > 0.5]
    assert [(round(each.time, 3), each.value) for each in changes] == [(0.6, 1)]
    assert 4 <= checks <= 8


def test_outputs_that_do_not_change_are_no_actions() -> None:
    """A bank is 32 outputs; one of them that changes is an action."""
    outputs = Channels(Clock())
    assert [outputs.set_bank(0, 32, 5), outputs.set_bank(0, 32, 5), outputs.set_bank(0, 32, 4)] == [
        True, False, True,
    ]  # fmt: skip
    assert outputs.values == ((0, 0), (2, 1))
    assert [outputs.set(2, 1), outputs.set(2, 0), outputs.set(9, 0)] == [False, True, False]
