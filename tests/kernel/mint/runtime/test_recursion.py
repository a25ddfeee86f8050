"""Calls nest exactly 1000 deep, from anywhere and of any kind."""

from __future__ import annotations

import sys
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from subprocess import run as run_process
from typing import TYPE_CHECKING, Any

import pytest

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT as MINT

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from pathlib import Path

ENDLESS = "Dim n As Integer\n{}\nEnd\n"
HANDLER = "Event ONERROR\n  PRINT ERRCODE, n\nEnd Event\n"
# Each begins in the first line after the Dim, and counts its own calls in n. From nine nested loops on, a sub is more
# than one function of Python.
RECURSIONS = {
    "a sub": ("Down()", "Sub Down()\n  n = n + 1\n  Down()\nEnd Sub\n"),
    "a sub that waits": ("Down()", "Sub Down()\n  n = n + 1\n  WAIT = 0\n  Down()\nEnd Sub\n"),
    "a sub with a loop": (
        "Down()",
        "Sub Down()\n  n = n + 1\n  While 1\n    Down()\n    Exit Sub\n  End While\nEnd Sub\n",
    ),
    "a function in an expression": (
        "x = F(1)",
        "Function F(ByVal a As Integer) As Integer\n  n = n + 1\n  F = 1 + 2 * (a + F(a))\nEnd Function\n",
    ),
    "two that call each other": (
        "Down()",
        "Sub Down()\n  n = n + 1\n  Other()\nEnd Sub\nSub Other()\n  n = n + 1\n  Down()\nEnd Sub\n",
    ),
    "through a sub of one line": (
        "Down()",
        "Sub Down()\n  n = n + 1\n  One(n)\n  Down()\nEnd Sub\nSub One(ByRef a As Integer)\n  a = a + 0\nEnd Sub\n",
    ),
    "nine loops within one another": (
        "Down()",
        "Sub Down()\n  Dim i As Integer\n  n = n + 1\n"
        + "For i = 1 To 1\n" * 9
        + "  Down()\n"
        + "Next\n" * 9
        + "End Sub\n",
    ),
    "a long sub": ("Down()", "Sub Down()\n  n = n + 1\n" + "  x = x + 1\n" * 1500 + "  Down()\nEnd Sub\n"),
    "a Gosub among hundreds of labels": (
        "Down()",
        "Sub Down()\n  Gosub again\n  Return\n"
        + "".join(f"#l{n}\nn = n + 1\n" for n in range(300))
        + "#again\nn = n + 2\nDown()\nReturn\nEnd Sub\n",
    ),
    "a sub with a Gosub": (
        "Down()",
        "Sub Down()\n  Gosub again\n  Return\n  #again\n  n = n + 2\n  Down()\n  Return\nEnd Sub\n",
    ),
}


# Those that take a second.
LONG = ("nine loops within one another", "a long sub", "ElseIfs", "Defines", "too many Defines")


def named(programs: Iterable[str]) -> list[Any]:
    """Return the names of programs for `parametrize`; those that take a second are slow."""
    return [pytest.param(each, marks=pytest.mark.slow if each in LONG else ()) for each in programs]


def outcome(text: str, file: str = "a.mnt") -> tuple[object, ...]:
    """Return the output and the end time of a run."""
    result = run(Source(file, text))
    found = [(each.code, each.message, each.line) for each in result.diagnostics]
    return result.status, result.output, found, result.time


# The outcome of a test's caller, which several tests compare with.
outcome_here = cache(outcome)


def below(frames: int, call: Callable[[], object]) -> object:
    """Call a function `frames` Python frames deeper, and return its result."""
    return below(frames - 1, call) if frames else call()


@pytest.mark.parametrize("name", named(RECURSIONS))
def test_calls_nest_a_thousand_deep(name: str) -> None:
    start, subs = RECURSIONS[name]
    result = run(Source("a.mnt", ENDLESS.format(start) + subs))
    (error,) = result.diagnostics
    assert (result.status, error.code, error.message) == (
        "fault",
        "recursion",
        "calls are nested more than 1000 deep",
    )
    assert outcome_here(ENDLESS.format(start) + subs + HANDLER)[1][0] == "10031000"  # type: ignore[index]


def test_the_error_is_at_the_call() -> None:
    _, _, found, _ = outcome("Down(1)\nEnd\nSub Down(ByVal a As Integer)\n\n  Down(a)\nEnd Sub")
    assert found == [("recursion", "calls are nested more than 1000 deep", 5)]


def test_a_gosub_is_a_call() -> None:
    """The main program pauses within Gosub 1000; Gosub 1001 is an error."""
    text = "Dim n As Integer\n#again\nn = n + 1\nIf n > {} Then PRINT n : End\nGosub again\nEnd\n"
    assert outcome(text.format(1000))[:2] == ("ended", ["1001"])
    assert outcome(text.format(1001))[2] == [("recursion", "calls are nested more than 1000 deep", 5)]


@pytest.mark.parametrize("depth", [1000, 1001])
def test_a_recursion_of_a_given_depth(depth: int) -> None:
    """1 + 2 + … + n takes n recursive calls."""
    text = (
        f"PRINT Sum({depth})\nEnd\nFunction Sum(ByVal n As Integer) As Integer\n"
        "  If n = 1 Then Sum = 1 : Exit Function\n  Sum = n + Sum(n - 1)\nEnd Function"
    )
    status, output, found, _ = outcome(text)
    if depth <= 1000:
        assert (status, output) == ("ended", [str(depth * (depth + 1) // 2)])
    else:
        assert (status, found[0][0]) == ("fault", "recursion")  # type: ignore[index]


@pytest.mark.slow
@pytest.mark.parametrize("depth", [1000, 1001])
def test_a_chain_of_subs(depth: int) -> None:
    """Each sub calls the next one, so a chain of n subs takes n calls."""
    subs = [
        f"Sub s{k}()\n  n = n + 1\n{f'  s{k + 1}()' if k < depth else ''}\nEnd Sub\n"
        for k in range(1, depth + 1)
    ]
    status, output, found, _ = outcome("Dim n As Integer\ns1()\nPRINT n\nEnd\n" + "".join(subs))
    assert (status, output or found[0][0]) == (  # type: ignore[index]
        ("ended", ["1000"]) if depth == 1000 else ("fault", "recursion")
    )


@pytest.mark.parametrize("name", named(RECURSIONS))
def test_it_does_not_matter_how_deep_the_caller_is(name: str) -> None:
    start, subs = RECURSIONS[name]
    text = ENDLESS.format(start) + subs + HANDLER
    first = outcome_here(text)
    before = sys.getrecursionlimit()
    for frames in (100, 400, 800) if name == "a sub" else (800,):
        assert below(frames, lambda: outcome(text)) == first
    assert sys.getrecursionlimit() == before


def test_threads_at_the_same_time() -> None:
    text = ENDLESS.format("Down()") + RECURSIONS["a sub"][1] + HANDLER
    before = sys.getrecursionlimit()
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda frames: below(frames, lambda: outcome(text)), [0, 150, 300, 450] * 3))
    assert found == [outcome(text)] * 12
    assert sys.getrecursionlimit() == before


def test_each_task_and_handler_has_a_stack_of_its_own() -> None:
    """The main program waits 600 calls deep while a task and a handler nest 600 calls."""
    text = (
        "Dim a As Integer, b As Integer\nTIMEREVENT = 10\nRun Other\nDeep(600)\nPRINT a, b\nEnd\n"
        "Sub Deep(ByVal n As Integer)\n  If n > 1 Then\n    Deep(n - 1)\n  Else\n    WAIT = 50\n  End If\nEnd Sub\n"
        "Sub Quick(ByVal n As Integer)\n  If n > 1 Then Quick(n - 1)\nEnd Sub\n"
        "Task Other\n  Quick(600)\n  a = 1\nEnd Task\n"
        "Event TIMER\n  TIMEREVENT = 0\n  Quick(600)\n  b = 1\nEnd Event\n"
    )
    assert outcome(text)[:3] == ("ended", ["11"], [])


def test_command_line_reports_the_same(tmp_path: Path) -> None:
    path = tmp_path / "down.mnt"
    text = ENDLESS.format("Down()") + RECURSIONS["a sub"][1]
    path.write_text(text + HANDLER, encoding="utf-8")
    command = [sys.executable, "-m", "motionlang", "run", str(path)]
    done = run_process(command, capture_output=True, text=True, check=False)
    assert done.stdout.splitlines()[0] == "10031000"


NESTED = {
    "brackets and signs": "x = " + "-(" * 90 + "1" + ")" * 90,
    "calls": "x = " + "Abs(" * 99 + "1" + ")" * 99,
    "an If for each line": "y = 1\n" + "If y Then\n" * 199 + "x = 1\n" + "End If\n" * 199,
    "loops": "Dim i As Integer\n" + "For i = 1 To 1\n" * 199 + "x = 1\n" + "Next\n" * 199,
    "Defines": "".join(f"Define d{k} = d{k - 1} + 1\n" for k in range(1, 150)).replace("d0", "1")
    + "x = d149\n",
    "ElseIfs": "Dim n As Integer\nIf n Then\n"
    + "".join(f"ElseIf n = {k} Then\n n = {k}\n" for k in range(1, 3000))
    + "End If\n",
    "too many Defines": "".join(f"Define d{k} = d{k - 1} + 1\n" for k in range(1, 3000)).replace("d0", "1")
    + "x = d2999\n",
    "constants": "".join(f"Const d{k} = d{k - 1} + 1\n" for k in range(1, 900)).replace("d0", "1")
    + "x = d899\n",
}


@pytest.mark.parametrize("name", named(NESTED))
def test_a_nested_text_is_read_from_anywhere(name: str) -> None:
    text = NESTED[name]
    first = outcome(text)
    assert below(800, lambda: outcome(text)) == first
    assert [each[0] for each in first[2]] == (["syntax"] if name == "too many Defines" else [])  # type: ignore[attr-defined]
    checked = [each.message for each in check(MINT.program(Source("a.mnt", text)))]
    assert (
        below(800, lambda: [each.message for each in check(MINT.program(Source("a.mnt", text)))]) == checked
    )


def test_macros_that_call_each_other() -> None:
    text = "MD1,MC2\nMD2,MC1\nMC1\n"
    first = outcome(text, "a.mccl")
    assert "macros are nested deeper than 100" in first[2][0][1]  # type: ignore[index]
    assert below(800, lambda: outcome(text, "a.mccl")) == first
