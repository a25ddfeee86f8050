"""A debug build counts its statements and behaves like the plain program."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.kernel import Hook, Source, dialect_for, run
from tests.cases import examples, one_in
from tests.generated.tasks import program as tasks_of
from tests.golden.test_gallery import PROGRAMS, ROOT
from tests.ide.debug.whole import whole

SQUARES = """\
Dim i As Integer, total As Integer
For i = 1 To 3
  total = total + i * i
Next
Print total
"""


def _nothing(*_: object) -> None:
    """Let the program continue."""


@pytest.mark.parametrize(
    "program", one_in(3, PROGRAMS), ids=lambda path: path.relative_to(ROOT / "scripts").as_posix()
)
def test_a_debug_build_of_the_gallery_does_the_same(program: Path) -> None:
    hook = Hook(_nothing)
    debugged = run(program, hook=hook)
    assert whole(debugged) == whole(run(program))
    assert hook.count > 0


def test_a_debug_build_of_several_tasks_does_the_same() -> None:
    for seed in range(examples(40)):
        text, settings = tasks_of(seed)
        plain, debugged = (
            run(Source("tasks.mnt", text), machine=settings, until=1.5, hook=hook)
            for hook in (None, Hook(_nothing))
        )
        assert whole(debugged) == whole(plain), seed


def test_statements_are_counted_in_mint() -> None:
    """One For, three times the sum, and one Print."""
    hook = Hook(_nothing)
    run(Source("a.mnt", SQUARES), hook=hook)
    assert hook.count == 5


def test_commands_are_counted_in_mccl() -> None:
    """AL, AA and TR."""
    hook = Hook(_nothing)
    run(Source("a.mcl", "AL2\nAA1\nTR0\n"), hook=hook)
    assert hook.count == 3


def test_the_hook_is_called_before_a_statement_with_its_time() -> None:
    """Each statement takes 10 µs: For, then the sum and Next in each iteration."""
    found: list[tuple[int, float]] = []
    source = Source("a.mnt", SQUARES)
    hook = Hook(lambda task, time, offset: found.append((dialect.locate(source, offset)[0], time)), limit=0)
    dialect = dialect_for(source, None)
    run(source, hook=hook)
    assert found == [
        (2, 0.0),
        (3, pytest.approx(1e-5)),
        (3, pytest.approx(3e-5)),
        (3, pytest.approx(5e-5)),
        (5, pytest.approx(7e-5)),
    ]


@pytest.mark.parametrize(
    "text", ["", "' nothing\n", "Sub S\nEnd Sub\nS\n", "a:\nGoto b\nb:\n", "Task T\nEnd Task\nRun T\n"]
)
def test_functions_without_statements_are_debug_builds_too(text: str) -> None:
    source = Source("a.mnt", text)
    assert whole(run(source, hook=Hook(_nothing))) == whole(run(source))


@pytest.mark.parametrize("branch", ["done = done + 1", "Print TIME"])
def test_a_call_in_a_condition_begins_at_the_same_time(branch: str) -> None:
    """`If` takes its 10 µs after the call."""
    text = f"""\
Dim done As Integer
Repeat
  If done + Late(1) > 1 Then
    {branch}
  End If
Until TIME > 20
Function Late(ByVal k As Integer) As Integer
  WAIT(2)
  Late = k
End Function
Task Other
  Repeat
  Until TIME > 20
End Task
"""
    source = Source("a.mnt", f"Run Other\n{text}")
    assert whole(run(source, hook=Hook(_nothing))) == whole(run(source))


def test_an_empty_loop_can_be_stopped() -> None:
    hook = Hook(_nothing)
    run(Source("a.mnt", "TIME = 0\nWhile TIME < 5\nEnd While\n"), hook=hook)
    assert hook.count > 2
