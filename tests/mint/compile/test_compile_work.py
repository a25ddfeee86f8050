"""Compilation is linear in the number of labels, jumps and variables.

That applies to the number of calls and to memory.
"""

from __future__ import annotations

import sys
import tracemalloc
from collections.abc import Callable
from functools import partial
from types import FrameType
from typing import Any

import pytest

from motionlang import run
from motionlang.fast.ranges import ranges
from motionlang.mint.compile.compiler import compile_module
from motionlang.mint.lint import check
from motionlang.mint.resolve.problems import MAX_PROBLEMS, Problems
from motionlang.mint.runtime.code_units import FILE
from motionlang.mint.syntax.parser import parse
from motionlang.source import Source


def labels(count: int) -> str:
    return "".join(f"#l{i}\nn = n + 1\n" for i in range(count))


def handler(count: int) -> str:
    return f"{labels(count)}End\n#ONERROR\nReturn\n"


def jumps(count: int) -> str:
    return "".join(f"#l{i}\nn = n + 1\nIf n > {i} Then Goto l{i * 7 % count}\n" for i in range(count))


def subroutines(count: int) -> str:
    calls = "".join(f"Gosub l{i}\n" for i in range(count))
    return f"{calls}End\n" + "".join(f"#l{i}\nReturn\n" for i in range(count))


def in_blocks(count: int) -> str:
    return "".join(f"If n > 0 Then\n#l{i}\nn = n + 1\nGoto l{i}\nEnd If\n" for i in range(count))


def back_to_few_labels(count: int) -> str:
    """Return jumps back to 20 labels, so that each one closes a loop that is analysed."""
    iterations = "n = n + 1\nIf n > 5 Then Goto l0\n" * (count // 20)
    return "".join(f"#l{i}\n{iterations}" for i in range(20))


def counted_loops(count: int) -> str:
    """Return For loops whose limits differ, so that each counter has its own range."""
    return "Dim i As Integer\n" + "".join(
        f"For i = 1 To {n + 3}\nIf i = 2 Then n = n + i\nNext\n" for n in range(count)
    )


def calls_to_compile(text: str) -> int:
    module = parse(Source("a.mnt", f"n = 0\n{text}"))
    return calls_of(lambda: compile_module(module, ranges=ranges))


def calls_of(work: Callable[[], object]) -> int:
    calls = 0

    def note(_frame: FrameType, event: str, _argument: object) -> None:
        nonlocal calls
        calls += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        work()
    finally:
        sys.setprofile(before)
    return calls


@pytest.mark.parametrize(
    "write", [labels, handler, jumps, subroutines, in_blocks, back_to_few_labels, counted_loops]
)
@pytest.mark.slow
def test_twice_the_statements_are_twice_the_work(write: object) -> None:
    assert callable(write)
    calls_to_compile(write(40))  # imports and caches are complete after this
    once, twice = calls_to_compile(write(200)), calls_to_compile(write(400))
    assert twice < 2.2 * once


def declared(count: int) -> str:
    return "".join(f"Dim x{i} As Integer\n" for i in range(count)) + "".join(
        f"x{i} = {i}\n" for i in range(count)
    )


def undeclared(count: int) -> str:
    return "".join(f"x{i} = x{(i + 1) % count} + 1\n" for i in range(count))


def peak_memory(text: str) -> int:
    """Return the peak memory that compilation adds, bytes."""
    module = parse(Source("a.mnt", text))
    tracemalloc.start()
    try:
        compile_module(module)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize("write", [declared, undeclared])
def test_a_variable_takes_less_than_ten_kilobytes(write: object) -> None:
    """So 20 000 variables stay below 200 MB."""
    assert callable(write)
    peak_memory(write(40))
    fewer, more = peak_memory(write(500)), peak_memory(write(1500))
    assert more - fewer < 1000 * 10_000


@pytest.mark.parametrize("write", [labels, jumps, subroutines])
@pytest.mark.slow
def test_a_label_takes_less_than_eight_kilobytes(write: object) -> None:
    """So 20 000 labels stay below 200 MB, with the text and the syntax tree."""
    assert callable(write)
    peak_memory("n = 0\n" + write(300))
    fewer, more = (peak_memory("n = 0\n" + write(count)) for count in (500, 1500))
    assert more - fewer < 1000 * 8_000


def lines_run(text: str) -> int:
    """Return the number of lines of generated Python that a run executes."""
    lines = 0

    def trace(frame: FrameType, event: str, _argument: object) -> Any:
        nonlocal lines
        lines += event == "line"
        return trace if frame.f_code.co_filename == FILE else None

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        run(Source("a.mnt", text), cache=False)
    finally:
        sys.settrace(before)
    return lines


def back_and_forth(count: int) -> str:
    """Return a program that jumps a thousand times between its first and last label."""
    first = f"n = 0\n#first\nn = n + 1\nGoto last\n{labels(count)}"
    return f"{first}#last\nIf n < 500 Then Goto first\n"


def test_a_jump_takes_no_longer_in_a_program_with_more_labels() -> None:
    assert lines_run(back_and_forth(1200)) < 1.2 * lines_run(back_and_forth(400))


def names_without_a_value(count: int) -> str:
    return "".join(f"Dim frodo{i} As Integer\nPrint frodo{i}\n" for i in range(count))


def names_without_a_use(count: int) -> str:
    return "".join(f"abc{i} = {i}\n" for i in range(count))


@pytest.mark.parametrize("write", [names_without_a_value, names_without_a_use])
def test_suggestions_are_searched_for_the_first_mistakes_alone(write: object) -> None:
    """Twice the number of wrong names takes twice the work.

    A search for a suggestion compares with all names, so only the first mistakes have one.
    """
    assert callable(write)
    calls_of(lambda: check(Source("a.mnt", write(10))))
    once, twice = (calls_of(partial(check, Source("a.mnt", write(n)))) for n in (200, 400))
    assert twice < 2.2 * once


def test_each_of_the_first_mistakes_has_a_suggestion() -> None:
    """Of 5 findings more than are shown, the last 5 have none.

    A declared variable that nothing reads is not compared with others, so it uses up no suggestion.
    """
    found = check(
        Source(
            "a.mnt",
            "".join(
                f"Dim part{i}x, part{i}y As Integer\nPRINT part{i}x\npart{i}y = 1\n"
                for i in range(MAX_PROBLEMS + 5)
            ),
        )
    )
    hints = [each.hint for each in found if each.code == "no-value"]
    assert hints[0] == "did you mean part0y in its assignment?"
    assert [hint.startswith("did you mean part") for hint in hints] == [True] * MAX_PROBLEMS + [False] * 5


@pytest.mark.parametrize(
    ("reads", "hint"),
    [(1, "did you mean totl in its assignment?"), (2, "assign it in its Dim or before it is read")],
)
def test_a_variable_that_is_read_twice_is_not_misspelled(reads: int, hint: str) -> None:
    text = "Dim total\ntotl = 1\n" + "PRINT totl\n" * reads + "PRINT total\n"
    assert [(each.code, each.hint) for each in check(Source("a.mnt", text))] == [("no-value", hint)]


def test_the_words_to_compare_with_are_collected_only_for_reported_mistakes() -> None:
    problems = Problems(parse(Source("a.mnt", "a = 1\n" * MAX_PROBLEMS)))
    collected = []

    def words(at: int) -> list[str]:
        collected.append(at)
        return ["y"]

    for at in range(2 * MAX_PROBLEMS):
        problems.unknown("x is unknown", "x", partial(words, at), at)
    assert collected == list(range(MAX_PROBLEMS))
