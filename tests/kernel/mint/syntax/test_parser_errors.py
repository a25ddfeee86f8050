"""Invalid programs and their messages: `parser_errors.txt` and its golden file.

A line of `parser_errors.golden.txt` is `line:column+length code: message (hint)`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

from motionlang import parse
from motionlang.kernel import ProgramError
from tests.cases import one_in
from tests.kernel.mint.syntax import test_parser_spec as parser_spec

HERE = Path(__file__).parent


def samples() -> dict[str, str]:
    return parser_spec.samples("parser_errors.txt")


def shown(text: str) -> str:
    """Return every diagnostic of a text, one per line."""
    with pytest.raises(ProgramError) as caught:
        parse(text, "mint")
    lines = []
    for d in caught.value.diagnostics:
        hint = f" ({d.hint})" if d.hint else ""
        lines.append(f"{d.line}:{d.column}+{d.length} {d.code}: {d.message}{hint}")
    return "\n".join(lines)


def test_diagnostics(golden: Callable[[Path, str], None]) -> None:
    found = {name: shown(text) for name, text in samples().items()}
    golden(HERE / "parser_errors.golden.txt", parser_spec.together(found))


@pytest.mark.parametrize("text", ["9" * 400, "9" * 9_000, "0x" + "F" * 300, "0b1" + "0" * 1023])
def test_a_number_that_no_float_holds_is_too_large(text: str) -> None:
    message = f"`{text[:23]}…` is too large for a number"
    assert shown(f"x = {text}") == f"1:5+{len(text)} syntax: {message}"


def test_a_channel_that_no_float_holds_is_too_large() -> None:
    message = f"`POS.{'9' * 19}…` has a number that is too large"
    assert shown(f"x = POS.{'9' * 400}") == f"1:5+404 syntax: {message}"


@pytest.mark.parametrize(("wrong", "reported"), [(99, 100), (100, 100), (101, 100)])
def test_no_more_than_a_hundred_errors_are_reported(wrong: int, reported: int) -> None:
    """The open block is one more error, unless there are a hundred already."""
    assert len(shown("If a Then\n" + "PRINT )\n" * wrong).splitlines()) == reported


HOSTILE = {
    "brackets": "x = " + "(" * 10_000,
    "closed brackets": "x = " + "(" * 10_000 + "1" + ")" * 10_000,
    "calls in calls": "x = " + "f(" * 10_000 + "1" + ")" * 10_000,
    "a long sum": "x = 1" + "+1" * 10_000,
    "signs": "x = " + "-" * 10_000 + "1",
    "members": "x = a" + ".a" * 10_000,
    "blocks": "If a Then\n" * 5_000,
    "closed blocks": "If a Then\n" * 10_000 + "End If\n" * 10_000,
    "Ifs of one line": "If a Then " * 10_000 + "x = 1",
    "ElseIfs": "If a Then\n" + "ElseIf b Then\n" * 3_000 + "End If",
    "a long word": "x" * 2_000_000,
    "a long number": "x = " + "1" * 2_000_000,
    "a long bad number": "x = " + "1" * 2_000_000 + "a",
    "quotes": '"\\' * 200_000,
    "nothing but blanks": " " * 2_000_000,
    "nothing but colons": ":" * 100_000,
    "NULs": "\0" * 100_000,
    "every byte": bytes(range(256)).decode("latin-1") * 1_000,
    "a mistake a line": "x = (\n" * 20_000,
    "closers": "Next\n" * 20_000,
    "lines that go on": "x = 1 + \\\n" * 10_000,
    "empty": "",
}


@pytest.mark.parametrize("name", one_in(3, HOSTILE))
def test_hostile_text_is_answered_soon(name: str) -> None:
    began = time.process_time()
    with suppress(ProgramError):
        parse(HOSTILE[name], "mint")
    assert time.process_time() - began < 30  # a second or less; what is quadratic takes minutes


def test_a_tree_that_is_accepted_can_be_walked() -> None:
    deep = "x = " + "f(1 + " * 80 + "1" + ")" * 80
    assert repr(parse(deep, "mint")).count("'f'") == 80


ENDS = (
    *(
        "End If",
        "End For",
        "End While",
        "End Repeat",
        "End Loop",
        "End Select",
        "End Sub",
        "End Function",
        "End Task",
    ),
    *(
        "End Event",
        "End Startup",
        "End Type",
        "Next",
        "Until",
        "Else",
        "ElseIf",
        "EndIf",
        "EndWhile",
        "EndW",
        "Wend",
    ),
    *("EndLoop", "EndL", "Case"),
)


@pytest.mark.parametrize("end", ENDS)
def test_an_end_outside_its_block_is_an_error(end: str) -> None:
    """A contextual lexer would read `End If` as END and a name."""
    (line,) = shown(f"x = 1\n{end} : y = 2").split("\n")
    assert line.startswith(f"2:1+{len(end)} stray-end: `{end}` without a")


@pytest.mark.parametrize(
    "opener", ["While x < 3", "If x Then", "For i = 1 To 2", "Select Case x\nCase 1", "Repeat"]
)
def test_too_deep_nesting_is_reported_at_the_block_too_many(opener: str) -> None:
    (line,) = shown(f"{opener}\n" * 1000).split("\n")
    assert line.endswith("syntax: blocks are nested more than 200 deep here (move the inner ones into a Sub)")
    assert int(line.split(":")[0]) == 200 * (opener.count("\n") + 1) + 1
