"""Probes: their questions, and detecting other behaviour from the answers."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from typing import Any

import pytest

from motionlang import run
from motionlang.commands.probe.answers import HOLDS, Answers, machine_text, read
from motionlang.commands.probe.entries import assumptions
from motionlang.commands.probe.probe import BEGIN, END, NEXT, Motion, alone, asked, mark, written
from motionlang.commands.probe.questions import questions
from motionlang.kernel import Source, dialect, read_machine
from motionlang.kernel.lang.machine.switch import Switch
from tests.cases import cases

# The questions of separate programs.
BY_NAME = {each.name for each in assumptions().values() if each.probe is not None and each.probe.alone}
LANGUAGES = {"mint": ("probe.mnt", 0), "mccl": ("probe.mcl", 1)}
# Assumptions without a switch, set by other keys of the machine file, and values that a probe can
# distinguish.
OTHER_KEYS = {"mint": {"controller.instruction_time": [2e-5, 5e-5, 1e-4]}, "mccl": {}}
# With fewer decimals a controller does not print enough to identify its settings.
DECIMALS = range(3, 10)
# Impossible at power-up: a precision mode without a table, blending alongside contours.
IMPOSSIBLE = ("assumptions.mint.precisionmode-default", "assumptions.mint.blendmode-default")


def answers(
    language: str, settings: dict[str, object], motion: Motion | None = None, further: int = 0
) -> list[str]:
    name, axis = LANGUAGES[language]
    axis += further
    result = run(Source(name, written(language, axis, motion)), machine=settings)
    assert result.status == "ended"
    return result.output


def another(name: str, switch: Switch, draw: random.Random) -> object:
    """Return a random allowed value of the switch of an assumption."""
    if switch.choices:
        return draw.choice(switch.choices)
    if name == "mint.float-decimals":
        return draw.choice(DECIMALS)
    low = max(-1000.0, -1000.0 if switch.low is None else switch.low)
    high = min(1000.0, 1000.0 if switch.high is None else switch.high)
    quarters = draw.randint(-int(-low // 0.25) if low >= 0 else int(low / 0.25), int(high / 0.25))
    return quarters // 4 if switch.whole else quarters / 4


def noise(lines: list[str], draw: random.Random) -> str:
    """Return answers as captured from a terminal.

    They have line ends, time stamps, colours, prompts and a listing.
    """
    end = draw.choice(["\n", "\r\n", "\r"])
    shown = ["\x1b[2J", "Connected.", *lines, "Goodbye."]
    stamp = draw.choice(["", "[12:01:02.345] ", "2026-01-02 12:01:02 "])
    return "".join(f"{stamp}\x1b[0m{line} {end}" for line in shown)


@pytest.mark.parametrize("language", [pytest.param("mint", marks=pytest.mark.slow), "mccl"])
@cases("seed", range(10))
def test_what_differs_on_a_controller_is_found(language: str, seed: int) -> None:
    draw = random.Random(seed)
    settings: dict[str, object] = {
        f"assumptions.{name}": another(name, switch, draw)
        for name, switch in dialect(language).switches().items()
        if draw.random() < 0.5 and name not in BY_NAME
    }
    for key in IMPOSSIBLE:
        settings.pop(key, None)
    for key, values in OTHER_KEYS[language].items():
        settings[key] = draw.choice(values)
    found = read(noise(answers(language, settings), draw))
    assert [each.message for each in found.problems] == []
    answered = read_machine(Source("found.toml", machine_text(found, "log.txt")))
    for key, value in settings.items():
        name = key.removeprefix("assumptions.")
        if key in answered:
            assert (
                answered[key] == pytest.approx(value) if isinstance(value, float) else answered[key] == value
            ), key
        else:
            verdict = next(
                each for each in found.verdicts if name in (each.assumption.name, each.assumption.key)
            )
            assert verdict.status == HOLDS, key
    assert set(answered) <= set(settings)
    assert answers(language, answered) == answers(language, settings)


@pytest.mark.parametrize("language", LANGUAGES)
@cases(("moves", "further"), [(False, 0), (True, 0), (False, 2), (True, 2)])
def test_every_chosen_assumption_holds_on_the_virtual_controller(
    language: str, moves: bool, further: int
) -> None:
    """The choice of axis has no influence."""
    motion = Motion(LANGUAGES[language][1] + further, 100.0) if moves else None
    found = read("\n".join(answers(language, {}, motion, further)))
    assert [each.message for each in found.problems] == []
    wrong = {each.assumption.name: each.answer for each in found.verdicts if each.status != HOLDS}
    assert wrong == {}
    assert len(found.verdicts) == len(asked(language, motion=moves))


def test_many_open_assumptions_are_probed() -> None:
    open_ones = [each for each in assumptions().values() if each.probe is not None and each.is_open]
    assert len(open_ones) >= 60
    assert len([each for each in open_ones if each.probe and each.probe.language == "mccl"]) >= 25


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_probe_moves_nothing_and_writes_nothing_unless_it_is_asked(language: str) -> None:
    name, axis = LANGUAGES[language]
    text = written(language, axis)
    assert "moves nothing" in text
    result = run(Source(name, text))
    assert result.report["moves"] == []
    if language == "mint":
        assert re.findall(r"^(?!PRINT)\w+\(.*", text, re.MULTILINE) == []
    moved = run(Source(name, written(language, axis, Motion(axis, 100.0))))
    moves: list[dict[str, Any]] = moved.report["moves"]  # type: ignore[assignment]
    assert {move["axis"] for move in moves} == {axis}
    assert all(-1e-9 <= move[key] <= 100.0 + 1e-9 for move in moves for key in ("start", "end"))
    assert moves[-1]["end"] == pytest.approx(0.0, abs=1e-9)


def test_questions_are_marked_apart() -> None:
    marks = [mark(name) for name in (*assumptions(), BEGIN, END, NEXT)]
    assert len(set(marks)) == len(marks)


def log(change: Callable[[list[str]], list[str]], language: str = "mint") -> Answers:
    """Return the virtual controller's answers, changed and then read again."""
    return read("\n".join(change(answers(language, {}))))


@pytest.mark.parametrize("language", LANGUAGES)
def test_answers_that_are_cut_off(language: str) -> None:
    found = log(lambda lines: lines[:20], language)
    assert "the end of the answers is missing" in found.problems[-1].message
    assert found.verdicts
    assert all(each.status == HOLDS for each in found.verdicts)


def test_an_answer_that_is_cut_off_is_none() -> None:
    found = log(lambda lines: [*lines[:5], lines[5][:-3]])
    assert [each.message for each in found.problems] == [
        f"the answer to {lines_name(5)} is cut off",
        "the end of the answers is missing: 4 were found",
    ]


def lines_name(number: int) -> str:
    return answers("mint", {})[number].partition("|")[0].lstrip("<")


def test_answers_in_another_order_say_the_same() -> None:
    straight, backwards = log(lambda lines: lines), log(lambda lines: lines[::-1])
    assert [(each.assumption.name, each.status) for each in straight.verdicts] == [
        (each.assumption.name, each.status) for each in backwards.verdicts
    ]
    assert backwards.problems == []


def test_a_question_without_an_answer_is_reported() -> None:
    found = log(lambda lines: [*lines[:5], *lines[7:]])
    assert [each.message for each in found.problems] == [
        f"2 of {len(found.verdicts) + 2} questions have no answer"
    ]


def test_two_answers_to_one_question_set_nothing() -> None:
    found = log(lambda lines: [*lines, "<mint.homespeed-default|77>"])
    assert "mint.homespeed-default is answered twice, by '4000.0000' and '77'" in found.problems[0].message
    assert "mint.homespeed-default" not in {each.assumption.name for each in found.verdicts}


def test_the_echo_of_the_probe_is_no_answer() -> None:
    listing = written("mint", 0).splitlines()
    found = log(lambda lines: [each for pair in zip(listing, lines, strict=False) for each in pair] + lines)
    assert found.problems == []
    echoed = written("mccl", 1).splitlines()
    result = answers("mccl", {})
    bare = [
        each
        for line in result
        for each in ((line, "1TG") if line == str(mark("mccl.gain-default")) else (line,))
    ]
    for shown in ([*(f">{line}" for line in echoed), *result], bare):
        found = read("\n".join(shown))
        assert found.problems == []
        assert all(each.status == HOLDS for each in found.verdicts)


@pytest.mark.parametrize(
    ("text", "wanted", "message"),
    [
        ("", "", "there is no answer to a probe here"),
        (written("mint", 0), "", "the questions are here, and no answers"),
        ("<probe|mint 1>\n<mint.nothing|5>\n<end|mint 1>\n", "", "mint.nothing is no reading"),
        ("<probe|mint 1>\n<mccl.quotient|5>\n<end|mint 1>\n", "", "mccl.quotient is a reading of the other language"),
        ("<probe|mint 1>\n<mint.truth|1 1>\n<end|mint 1>\n", "mccl", "the answers to a probe of mint, not of mccl"),
        ("<probe|mint 1>\n<mint.idletime-default|7.5>\n<end|mint 1>\n", "", "must be a whole number"),
        ("<probe|mint 1>\n<mint.idletime-default|-4>\n<end|mint 1>\n", "", "must be 0 to 60000"),
    ],
)  # fmt: skip
def test_answers_that_say_nothing(text: str, wanted: str, message: str) -> None:
    found = read(text, wanted)
    assert message in found.problems[0].message
    assert found.verdicts == []


def test_an_unexpected_answer_sets_nothing() -> None:
    found = read("<probe|mint 2>\n<mint.truth|yes>\n<mint.homespeed-default|fast>\n<end|mint 2>\n")
    assert [each.status for each in found.verdicts] == ["unknown"] * 2
    assert "[assumptions]" not in machine_text(found, "log.txt")


@pytest.mark.parametrize(
    ("language", "motion", "wanted"),
    [
        ("mint", None, "It moves nothing and writes no setting."),
        ("mccl", None, "It moves nothing and writes no setting."),
        (
            "mint",
            Motion(2, 10.0),
            "It moves axis 2 within 10 user units of its position, and puts back what it writes.",
        ),
        (
            "mccl",
            Motion(2, 500.0),
            "It moves axis 2 within 500 user units of its position, which is 0 afterwards, "
            "switches it on and leaves its velocity at 250.",
        ),
    ],
)
def test_a_probe_says_first_what_it_does(language: str, motion: Motion | None, wanted: str) -> None:
    text = " ".join(line.strip(" ';") for line in written(language, 2, motion).splitlines())
    assert wanted in text


def test_a_question_alone_names_its_axis_and_the_next_one() -> None:
    """`{a}` is the axis of the question, and `{b}` the one after it."""
    found = [each for each in questions().values() if each.probe is not None and "{b}" in each.probe.needs]
    assert found
    for each in found:
        assert each.probe is not None
        text = " ".join(line.strip("';") for line in alone(each, 5, Motion(5, 10.0)).splitlines())
        expected = each.probe.needs.replace("{a}", "5").replace("{b}", "6")
        assert f"First: {expected}." in " ".join(text.split())


MINT_PROBE = """\
' 2 questions of motionlang about this controller, one line of answer each.
' It moves axis 2 within 10 user units of its position, and puts back what it writes. The axis must be enabled. \
Stop it as any motion.
' Run it after power-up, with the settings of the factory. A line that does not compile may be deleted.
' Then: motionlang probe --answers LOG, where LOG is what the terminal showed.
Dim fa As Float, fb As Float, ia As Integer, ib As Integer
PRINT "<probe|mint 2>"
fa = 16777216
fa = fa + 1
PRINT "<mint.float-precision|"; fa - 16777216; ">"
Dim fs As Float
fs = SPEED(2)
SPEED(2) = 5
fa = SCALEFACTOR(2)
fb = SPEED(2)
SCALEFACTOR(2) = fa * 2
PRINT "<mint.scale-changed|"; SPEED(2) / fb; ">"
SCALEFACTOR(2) = fa
SPEED(2) = fb
SPEED(2) = fs
PRINT "<end|mint 2>"
End
"""
# A mark is a number in the accumulator, which TR0 shows.
MCCL_PROBE = f"""\
; 2 questions of motionlang about this controller, one line each.
; It moves axis 2 within 10 user units of its position, which is 0 afterwards, switches it on and leaves its \
velocity at 5. Stop it as any motion.
; Send it line by line after power-up, and keep what the terminal shows.
; Then: motionlang probe --answers LOG
DM,AL{mark(BEGIN)},TR0,AL2,TR0
2SV5
AL{mark("mccl.wrong-command")},TR0
ZZ,AL5,TR0
AL{mark(NEXT)},TR0
2DH0,2MN
2MA2.5,2WS0.1
AL{mark("mccl.target-rounding")},TR0
2TT
AL{mark(NEXT)},TR0
2MA0,2WS0.1
AL{mark(END)},TR0
"""
# Two axes, with the second one in the remarks; the longest remark has 110 characters.
ALONE = """\
' mint.path-speed-axis: Which axis's SPEED
' First: enable axis 3, too, which stands still; speeds and rates change, so restart the controller afterwards.
' It moves axes 2 and 3 within 10 user units of their positions. Enable what moves; stop it as any motion.
' What it shows, and what that says of the controller:
'   2  that of the first axis named, in its user units along the path (chosen here)
'   1  the lowest SPEED of its axes
' Then: motionlang probe --answers LOG, where LOG is what the terminal showed.
Dim fa As Float, fb As Float, ia As Integer, ib As Integer
PRINT "<probe|mint 1>"
Dim fs As Float
fs = SPEED(2)
SPEED(2) = 5
ACCEL(2) = 4 * 10
DECEL(2) = 4 * 10
SPEED(2) = 4
SPEED(3) = 2
VECTORR(2, 3) = 4, 0
GO(2)
WAIT = 600
fb = VEL(2) / 2
PAUSE IDLE(2)
VECTORR(2, 3) = -4, 0
GO(2)
PAUSE IDLE(2)
PRINT "<mint.path-speed-axis|"; fb; ">"
SPEED(2) = fs
PRINT "<end|mint 1>"
End
"""


@pytest.mark.parametrize(
    ("language", "names", "text"),
    [
        ("mint", ("mint.float-precision", "mint.scale-changed"), MINT_PROBE),
        ("mccl", ("mccl.wrong-command", "mccl.target-rounding"), MCCL_PROBE),
    ],
)
def test_a_probe_of_two_questions(language: str, names: tuple[str, ...], text: str) -> None:
    """The one with motion, of half the distance in a second, comes last."""
    without = {each.name for each in asked(language, motion=True)} - set(names)
    assert written(language, 2, Motion(2, 10.0), without) == text
    assert [each.name for each in asked(language, motion=False, without=without)] == [names[0]]


def test_a_probe_of_one_question() -> None:
    without = {each.name for each in asked("mint", motion=True)} - {"mint.float-precision"}
    assert written("mint", 2, None, without).splitlines()[:2] == [
        "' 1 question of motionlang about this controller, one line of answer each.",
        "' It moves nothing and writes no setting. It can be stopped at any time.",
    ]


def test_a_question_with_motion_of_two_axes() -> None:
    assert alone(questions()["mint.path-speed-axis"], 2, Motion(2, 10.0)) == ALONE


@pytest.mark.parametrize(
    ("name", "line"),
    [("mint.path-speed-axis", "VECTORR(2, 3) = 0, 0"), ("mccl.relative-to", "2MR0,2MR0,2WS0.1")],
)
def test_without_permission_a_distance_is_0(name: str, line: str) -> None:
    """The remark about motion is missing, too; a question without motion never has it."""
    text = alone(questions()[name], 2)
    assert line in text.splitlines()
    assert "It moves" not in text
    still = questions()["mint.idletime-range-high"]
    assert alone(still, 2, Motion(2, 10.0)) == alone(still, 2)
