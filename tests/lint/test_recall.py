"""A check that reuses the previous one finds the same as a new one.

It checks only functions that have changed.

`motionlang lsp` passes one dict from each check of a text to the next. After every edit the result must equal
that of a check without the dict, in all details.
"""

from __future__ import annotations

import re
from pathlib import Path
from random import Random

import pytest

from motionlang.commands.check.mint import check
from motionlang.kernel.source import Source
from tests.cases import covering, one_in

GALLERY = Path(__file__).parents[2] / "scripts" / "mint"
PROGRAM = """\
Dim level
load
start
Sub load
 MOVEA(0) = 5
End Sub
Sub start
 GO(0)
 level = 1
End Sub
Sub slow(n)
 SPEED(2) = n
 SPEED(2) = 2
 MOVER(2) = level : GO(2)
End Sub
slow(3)
"""
# What the edits add: each changes what other functions see, or the place of what they have.
ADDED = (
    "", "' a comment", "MOVEA(0) = 100", "MOVER(n) = 5 : GO(n)", "GO(0)", "SPEED(0) = 0", "SPEED(1) = 10",
    "SCALE(0) = 100", "SOFTLIMITFORWARD(0) = 50", "MOVEBUFFERSIZE(0) = 10", "TRIGGERMODE(0) = 1", "JOG(1) = 5",
    "STOP(0)", "Pause IDLE(0)", "WAIT = POS(0) > 3", "AXES(1)", "level = level + 1", "x = y", "Return", "Loop",
    "End Loop", "While level", "End While", "Dim level", "Dim taken As Semaphore", "Const level = 3",
    "Define level = POS(0)", "Define quick = SPEED(0) = 7", "quick", "Task blink", "End Task", "Run blink",
    "Event ONERROR", "End Event", "Sub fill(n)", "End Sub", "fill(1)", "load", "If POS(0) = 5 Then Print 3",
    "MOVEA(0) = ", "mover(0) 5",
)  # fmt: skip


def found(text: str, known: dict[object, object] | None = None) -> list[dict[str, object]]:
    return [
        {name: getattr(each, name) for name in each.__slots__}
        for each in check(Source("a.mnt", text), {}, known)
    ]


def codes(text: str, known: dict[object, object]) -> list[tuple[int, str]]:
    return [(each.line, each.code) for each in check(Source("a.mnt", text), {}, known)]


def lines_with(code: str, text: str, known: dict[object, object]) -> list[int]:
    return [line for line, each in codes(text, known) if each == code]


def edited(lines: list[str], random: Random) -> list[str]:
    """Return the lines after adding, removing, moving or renumbering one of them."""
    at = random.randrange(len(lines))
    match random.randrange(4):
        case 0:
            return [*lines[:at], random.choice(ADDED), *lines[at:]]
        case 1:
            return [*lines[:at], *lines[at + 1 :]] or [""]
        case 2:
            other = random.randrange(len(lines))
            lines[at], lines[other] = lines[other], lines[at]
            return lines
        case _:
            lines[at] = re.sub(r"\d", lambda _: str(random.randrange(10)), lines[at], count=1)
            return lines


def test_a_sub_that_changes_changes_the_warnings_of_another_one() -> None:
    """`load` depends on the GO of `start`."""
    known: dict[object, object] = {}
    assert (5, "never-started") not in codes(PROGRAM, known)
    assert (5, "never-started") in codes(PROGRAM.replace("GO(0)", "GO(1)"), known)
    assert (5, "never-started") not in codes(PROGRAM, known)


def test_a_caller_sees_what_a_sub_leaves_in_motion() -> None:
    program = "start\nSCALE(0) = 100\nSub start\n MOVEA(0) = 5 : GO(0)\n x = 1\nEnd Sub\n"
    known: dict[object, object] = {}
    assert lines_with("scale-in-motion", program, known) == [2]
    assert lines_with("scale-in-motion", program.replace("x = 1", "Pause IDLE(0)"), known) == []
    assert lines_with("scale-in-motion", program, known) == [2]


def test_a_loop_sees_which_tasks_write_its_variable() -> None:
    task = "Task blink\n x = level\n {} = 1\nEnd Task\n"
    program = "Dim level, x\nRun blink\nWhile level = 0\nEnd While\n" + task
    known: dict[object, object] = {}
    assert lines_with("endless-loop", program.format("level"), known) == []
    assert lines_with("endless-loop", program.format("x"), known) == [3]


def test_a_loop_sees_whether_a_sub_that_it_calls_writes_its_variable() -> None:
    program = (
        "Dim level, x\nx = 1\nlevel = x\nWhile level < 3\n more\nEnd While\nSub more\n {} = 5 + x\nEnd Sub\n"
    )
    known: dict[object, object] = {}
    assert lines_with("endless-loop", program.format("x"), known) == [4]
    assert lines_with("endless-loop", program.format("level"), known) == []
    assert lines_with("endless-loop", program.format("x"), known) == [4]


def test_a_sub_sees_which_tasks_call_it() -> None:
    """`level` changes while `hold` waits, if the task `blink` also calls `hold`."""
    program = "Dim level\nRun blink\nhold\nlevel = 1\nSub hold\n Pause level = 1\nEnd Sub\n"
    known: dict[object, object] = {}
    alone, both = (f"{program}Task blink\n {each}\nEnd Task\n" for each in ("Wait = 1", "hold"))
    assert lines_with("endless-wait", alone, known) == [6]
    assert lines_with("endless-wait", both, known) == []


def test_a_machine_with_fewer_axes_refuses_what_was_accepted() -> None:
    known: dict[object, object] = {}
    program = Source("a.mnt", "MOVEA(5) = 1 : GO(5)")
    assert check(program, {}, known) == []
    assert [each.code for each in check(program, {"controller.axes": 4}, known)] == ["axis", "axis"]


def test_a_message_of_the_program_moves_to_the_next_function_that_causes_it() -> None:
    """A keyword without effect is reported where it is used for the first time."""
    program = "one\ntwo\nSub one\n {}\nEnd Sub\nSub two\n ABSENCODERCOSOFFSET(0) = 1\nEnd Sub\n"
    known: dict[object, object] = {}
    assert lines_with("not-simulated", program.format("ABSENCODERCOSOFFSET(0) = 1"), known) == [4]
    assert lines_with("not-simulated", program.format("x = 1 : Print x"), known) == [7]


def test_a_line_in_a_message_moves_with_its_sub() -> None:
    known: dict[object, object] = {}
    message = "SPEED of axis 2 is replaced by SPEED in line {} before any move"
    assert message.format(13) in [each["message"] for each in found(PROGRAM, known)]
    assert message.format(15) in [each["message"] for each in found("\n\n" + PROGRAM, known)]


def test_only_the_function_that_has_changed_is_checked_again() -> None:
    """The two stages are checking and linting."""
    known: dict[object, object] = {}
    check(Source("a.mnt", PROGRAM), {}, known)
    before = dict(known)
    check(Source("a.mnt", PROGRAM.replace("level = 1", "level = 1 + 1")), {}, known)
    stages = [key[0] for key in known.keys() - before.keys()]  # type: ignore[index]
    assert sorted(stages) == ["check", "lint"]
    assert len(known) == len(before) == 8
    assert len([key for key, entry in before.items() if known.get(key) is entry]) == 6


def test_what_is_no_longer_in_the_text_is_forgotten() -> None:
    known: dict[object, object] = {}
    for number in range(50):
        check(Source("a.mnt", PROGRAM.replace("level = 1", f"level = {number}")), {}, known)
    assert len(known) == 8


def test_a_half_typed_line_forgets_nothing() -> None:
    known: dict[object, object] = {}
    check(Source("a.mnt", PROGRAM), {}, known)
    before = dict(known)
    for typed in ("MOVEA(", "movve(0) = 1", "x = "):
        text = PROGRAM.replace("MOVEA(0) = 5", typed)
        assert found(text, known) == found(text)
        assert known == before


@pytest.mark.parametrize("path", one_in(2, sorted(GALLERY.rglob("*.mnt"))), ids=lambda path: path.stem)
def test_gallery_programs_with_edits(path: Path) -> None:
    random = Random(path.stem)
    lines = path.read_text(encoding="utf-8").split("\n")
    known: dict[object, object] = {}
    for _ in range(4):
        text = "\n".join(lines)
        assert found(text, known) == found(text)
        lines = edited(lines, random)


def lines_of(seed: int) -> set[str]:
    """Return the lines that the edits of a seed add."""
    random, lines, seen = Random(seed), PROGRAM.split("\n"), set[str]()
    for _ in range(22):
        lines = edited(lines, random)
        seen.update(lines)
    return seen


# Seeds whose edits add every line, for the normal run, and the others for a long one.
SLICE = covering(ADDED, 24, lines_of)
MORE = [pytest.param(seed, marks=pytest.mark.long) for seed in range(40) if seed not in SLICE]


@pytest.mark.parametrize("seed", [*SLICE, *MORE])
def test_generated_programs_with_edits(seed: int) -> None:
    random = Random(seed)
    lines = PROGRAM.split("\n")
    known: dict[object, object] = {}
    for _ in range(12):
        text = "\n".join(lines)
        assert found(text, known) == found(text)
        lines = edited(edited(lines, random), random)
