"""A loop may write any keyword in each iteration, with or without skipping.

The result is that of every iteration.
"""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.errors import ProgramError
from motionlang.lang.keyword import Keyword
from motionlang.mint.compile import polling
from motionlang.mint.keywords import table
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
