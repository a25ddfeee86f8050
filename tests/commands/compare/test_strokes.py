"""How a recording of other motion is described, in both languages: its delay, its scale, and each stroke that differs.

The run moves 200, -100 and 50 uu at 200 uu/s and 1000 uu/s², in 1.2, 0.7 and 0.45 s, from 0.5 s on, and rests 0.3 s in
between. The recording is the same program with another line, or another column, at 500 Hz with six decimals.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from math import inf
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from motionlang import compare, run
from motionlang.kernel import Run, Source, settings_next_to

MINT = """\
SPEED(0) = 200 : ACCEL(0) = 1000 : DECEL(0) = 1000
WAIT = 500
MOVER(0) = 200 : GO(0) : PAUSE IDLE(0)
WAIT = 300
MOVER(0) = -100 : GO(0) : PAUSE IDLE(0)
WAIT = 300
MOVER(0) = 50 : GO(0) : PAUSE IDLE(0)
WAIT = 500
"""
MCCL = """\
1MN,1SV200,1SA1000,1DS1000
WA0.5
1MR200,1WS
WA0.3
1MR-100,1WS
WA0.3
1MR50,1WS
WA0.5
"""
PROGRAMS = {"mint": ("a.mnt", MINT, 0), "mccl": ("a.mcl", MCCL, 1)}


class Case(NamedTuple):
    """A change of line `line` to a text of Mint or of MCCL, or of the numbers of the recording."""

    line: int
    mint: str
    mccl: str
    delay: float
    scale: float
    differences: list[str]
    column: Callable[[np.ndarray], np.ndarray] = lambda values: values


FASTER = [
    "3: recorded the same 200 uu in 11 % less time: 240 against 200 uu/s "
    "(and 1 more: line 5 in 6.2 % less time: 240 against 200 uu/s)",
]
CASES = {
    "itself": Case(8, "WAIT = 500", "WA0.5", 0.0, 1.0, []),
    "another speed": Case(
        1, "SPEED(0) = 240 : ACCEL(0) = 1000 : DECEL(0) = 1000", "1MN,1SV240,1SA1000,1DS1000", 0.0, 1.0, FASTER
    ),
    "another speed, in inches": Case(
        1,
        "SPEED(0) = 240 : ACCEL(0) = 1000 : DECEL(0) = 1000",
        "1MN,1SV240,1SA1000,1DS1000",
        0.0,
        1.0 / 25.4,
        [*FASTER, "x moves 0.0393701 times as far as the run (7.874 against 200 uu): millimetres and inches"],
        lambda values: values / 25.4,
    ),
    # 0.7 s at 200 uu/s and 0.4 s at 500 uu/s² on each side are 1.4 s; 50 uu need √0.4 s, at most 158 uu/s.
    "another rate": Case(
        1,
        "SPEED(0) = 200 : ACCEL(0) = 500 : DECEL(0) = 500",
        "1MN,1SV200,1SA500,1DS500",
        0.0,
        1.0,
        [
            "3: recorded the same 200 uu in 17 % more time, accelerated at 500 against 1000 uu/s², "
            "decelerated at 500 against 1000 uu/s² (and 2 more: line 5 in 29 % more time, "
            "accelerated at 500 against 1000 uu/s², decelerated at 500 against 1000 uu/s²; "
            "line 7 in 41 % more time: 157.1 against 200 uu/s)",
        ],
    ),
    "a feed override": Case(
        2,
        "FEEDRATEMODE(0) = 2 : FEEDRATEOVERRIDE(0) = 50 : WAIT = 500",
        "1SV100,WA0.5",
        0.0,
        1.0,
        [
            "3: recorded the same 200 uu in 75 % more time: 100 against 200 uu/s (and 2 more: "
            "line 5 in 57 % more time: 100 against 200 uu/s; line 7 in 33 % more time: 100 against 200 uu/s)",
        ],
    ),
    "a late start": Case(2, "WAIT = 2500", "WA2.5", 2.0, 1.0, []),
    "a late move": Case(
        4, "WAIT = 800", "WA0.8", 0.0, 1.0, ["5: recorded 0.5 s later, counted from the move before"]
    ),
    "a missing move": Case(5, "", "", 0.0, 1.0, ["5: -100 uu at 2 s are not recorded"]),
    "the first move missing": Case(3, "", "", -1.2, 1.0, ["3: 200 uu at 0.5 s are not recorded"]),
    "an extra move": Case(
        4,
        "WAIT = 100 : MOVER(0) = 30 : GO(0) : PAUSE IDLE(0) : WAIT = 300",
        "WA0.1,1MR30,1WS,WA0.3",
        0.0,
        1.0,
        ["30 uu at 1.8 s are recorded, the run is at rest"],
    ),
    "millimetres for metres": Case(
        8,
        "WAIT = 500",
        "WA0.5",
        0.0,
        1000.0,
        ["x moves 1000 times as far as the run (200000 against 200 uu): a prefix of the unit, such as µm and mm"],
        lambda values: 1000.0 * values + 17.0,
    ),
    "a gear": Case(
        8,
        "WAIT = 500",
        "WA0.5",
        0.0,
        -1.5,
        ["x moves -1.5 times as far as the run (-300 against 200 uu): a gear of 3:2"],
        lambda values: -1.5 * values,
    ),
    "no usual factor": Case(
        8,
        "WAIT = 500",
        "WA0.5",
        0.0,
        1.1,
        ["x moves 1.1 times as far as the run (220 against 200 uu)"],
        lambda values: 1.1 * values,
    ),
    "other travel of one move": Case(
        3,
        "MOVER(0) = 220 : GO(0) : PAUSE IDLE(0)",
        "1MR220,1WS",
        0.0,
        1.0,
        ["3: recorded 1.1 times as far, 220 against 200 uu"],
    ),
    "an encoder of four counts per unit": Case(
        1,
        "SPEED(0) = 240 : ACCEL(0) = 1000 : DECEL(0) = 1000",
        "1MN,1SV240,1SA1000,1DS1000",
        0.0,
        1.0,
        ["3: recorded the same 200 uu in 10 % less time: 239.6 against 200 uu/s"],
        lambda values: np.round(4.0 * values) / 4.0,
    ),
}  # fmt: skip


@cache
def made(language: str, line: int = 0, text: str = "") -> Run:
    name, program, _ = PROGRAMS[language]
    lines = program.splitlines(keepends=True)
    lines[line - 1 : line] = [text + "\n"] if line else lines[-1:]
    return run(Source(name, "".join(lines)))


def compared(language: str, case: Case, later: float = 0.0, end: float = inf, rate: float = 500.0) -> Any:
    axis = PROGRAMS[language][2]
    other = made(language, case.line, getattr(case, language))
    samples = other.trace.sample(rate, [axis], None, ["position"])
    rows = zip(samples.time + later, case.column(samples.get(axis, "position")), strict=True)
    text = "\n".join(["t,x", *(f"{time:.6f},{value:.6f}" for time, value in rows if time < end)])
    return compare(made(language), Source("real.csv", text), {f"position.{axis}": "x"})


@pytest.mark.parametrize("later", [0.0, 2.0])
@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("language", PROGRAMS)
def test_a_recording_of_other_motion(language: str, name: str, later: float) -> None:
    case, axis = CASES[name], PROGRAMS[language][2]
    found = compared(language, case, later)
    assert found.delay == pytest.approx(case.delay + later, abs=2e-4)
    (row,) = found.signals
    assert row["scale"] == pytest.approx(case.scale, rel=1e-5)
    command = "MOVER" if language == "mint" else "MR"
    starts = (f"position.{axis}: ", f"position.{axis}, {command} of line ")
    assert [
        each.message.removeprefix(starts[0]).removeprefix(starts[1]) for each in found.remarks
    ] == case.differences


@pytest.mark.parametrize("language", PROGRAMS)
def test_a_move_that_the_end_of_the_recording_cuts_is_named_once(language: str) -> None:
    case = next(each for each in CASES.values() if each.differences == FASTER)
    faster, cut = (each.message.split(" of ", 1)[1] for each in compared(language, case, end=3.0).remarks)
    assert [faster] == [f"line {each}" for each in FASTER]
    assert cut == "line 7: not recorded, the recording has 0 s to 2.998 s of the run"


@pytest.mark.parametrize("language", PROGRAMS)
def test_ramps_of_ten_rows_have_both_rates(language: str) -> None:
    """The ramps of the run to 200 uu/s at 1000 uu/s² take 0.2 s, which are ten rows at 50 Hz."""
    message = compared(language, CASES["another rate"], rate=50.0).remarks[0].message
    rates = re.search(
        r"accelerated at 500 against (\S+) uu/s², decelerated at 500 against (\S+) uu/s²", message
    )
    assert rates is not None, message
    assert [float(each) for each in rates.groups()] == pytest.approx([1000.0, 1000.0], rel=0.02)


@pytest.mark.parametrize("language", PROGRAMS)
def test_a_run_compared_with_itself_has_no_offset(language: str) -> None:
    (row,) = compared(language, CASES["itself"]).signals
    assert (row["scale"], row["offset"]) == (1.0, 0.0)


@pytest.mark.parametrize(("rate", "noise"), [(500.0, 0.0), (100.0, 0.0), (1000.0, 1e-3)])
@pytest.mark.parametrize(
    "name", ["mint/indexing-table.mnt", "mint/lift.mnt", "mint/tool-changer.mnt", "mccl/contour-arcs.mcl"]
)
def test_a_program_of_the_gallery_does_not_differ_from_itself(name: str, rate: float, noise: float) -> None:
    """These jog, home, reverse without rest, creep, and end in motion; the noise is a share of the travel."""
    path = Path(__file__).parents[3] / "scripts" / name
    result = run(Source.read(path), machine=settings_next_to(str(path)), until=20.0)
    axis = result.trace.axes[0]
    samples = result.trace.sample(rate, [axis], None, ["position"])
    values = samples.get(axis, "position")
    values = values + noise * np.ptp(values) * np.random.default_rng(3).normal(size=len(values))
    rows = "\n".join(f"{t + 0.3:.6f},{x:.6f}" for t, x in zip(samples.time, values, strict=True))
    found = compare(result, Source("real.csv", "t,x\n" + rows), {f"position.{axis}": "x"})
    assert found.remarks == []
    assert found.delay == pytest.approx(0.3, abs=1e-3)


# A feed of four equal strokes, what the machine does instead, the delay, the lag of each move in ms, and the remarks.
FEED = "SPEED(0) = 200 : ACCEL(0) = 2000 : DECEL(0) = 2000\nWAIT = 200\n"
STROKE = "MOVER(0) = {} : GO(0) : PAUSE IDLE(0)\nWAIT = {}\n"
FOUR = FEED + 4 * STROKE.format(25, 100)
MISSING = "25 uu at {} s are not recorded"
FEEDS: dict[str, tuple[str, float, list[float | None], list[str]]] = {
    "the first move missing": (
        FEED + "WAIT = 325\n" + 3 * STROKE.format(25, 100),
        0.325,  # as far as the recording shows, the feed began later
        [0.0, 0.0, 0.0, None],
        ["9: not recorded, the recording has 0 s to 1.175 s of the run"],
    ),
    "a middle move missing": (
        FEED + STROKE.format(25, 100) + "WAIT = 325\n" + 2 * STROKE.format(25, 100),
        0.0,
        [0.0, None, 0.0, 0.0],
        ["5: " + MISSING.format(0.525)],
    ),
    "the last move missing": (
        FEED + 3 * STROKE.format(25, 100) + "WAIT = 325\n",
        0.0,
        [0.0, 0.0, 0.0, None],
        ["9: " + MISSING.format(1.175)],
    ),
    "a jam in the third move": (
        FEED + 2 * STROKE.format(25, 100) + "MOVER(0) = 25 : GO(0) : PAUSE POS(0) > 60 : CANCEL(0)\nWAIT = 500\n",
        0.0,
        [0.0, 0.0, 0.0, None],
        ["9: " + MISSING.format(1.175), "7: recorded 0.4001 times as far, 10.002 against 25 uu"],
    ),
    "a jam in the first move": (
        FEED + "MOVER(0) = 25 : GO(0) : PAUSE POS(0) > 12 : CANCEL(0)\nWAIT = 1300\n",
        0.0,
        [0.0, None, None, None],
        [f"5: {MISSING.format(0.525)} (and 2 more: line 7 at 0.85 s; line 9 at 1.175 s)",
         "3: recorded 0.4801 times as far, 12.002 against 25 uu"],
    ),
    "half the speed": (
        FEED.replace("200 :", "100 :") + 4 * STROKE.format(25, 100),
        0.0,
        [0.0, 75.0, 150.0, 225.0],
        ["3: recorded the same 25 uu in 33 % more time: 100 against 200 uu/s (and 3 more: "
         + "; ".join(f"line {line} in 33 % more time: 100 against 200 uu/s" for line in (5, 7, 9)) + ")"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("noise", [0.0, 0.01])
@pytest.mark.parametrize("what", FEEDS)
def test_a_feed_of_equal_moves_shows_which_is_missing_and_how_late_each_is(what: str, noise: float) -> None:
    text, delay, lags, remarks = FEEDS[what]
    samples = run(Source("a.mnt", text)).trace.sample(500.0, [0], None, ["position"])
    values = samples.get(0, "position")
    values = values + noise * np.random.default_rng(7).normal(size=len(values))
    rows = "\n".join(f"{t:.6f},{x:.6f}" for t, x in zip(samples.time, values, strict=True))
    found = compare(run(Source("a.mnt", FOUR)), Source("real.csv", "t,x\n" + rows), {"position.0": "x"})
    assert found.delay == pytest.approx(delay, abs=2e-3)
    assert [each["lag"] is None for each in found.moves] == [each is None for each in lags]
    known = [(each["lag"], lag) for each, lag in zip(found.moves, lags, strict=True) if lag is not None]
    assert [1000.0 * there for there, _ in known] == pytest.approx([here for _, here in known], abs=2.0)
    if not noise:
        said = [each.message.removeprefix("position.0, MOVER of line ") for each in found.remarks]
        assert said == remarks


def test_an_axis_at_rest_compares_like_any_other() -> None:
    text = "t,x,y\n" + "\n".join(f"{k / 100},{min(k, 30)},5" for k in range(60))
    program = "SPEED(0) = 100\nMOVER(0) = 30 : GO(0) : PAUSE IDLE(0)\nWAIT = 300\n"
    mapping = {"position.0": "x", "position.1": "y"}
    found = compare(run(Source("a.mnt", program)), Source("real.csv", text), mapping)
    assert [(row["signal"], row["moves"], row["peak"]) for row in found.signals[1:]] == [
        ("position.1", False, 5.0)
    ]


def test_a_line_that_differs_each_time_is_reported_once() -> None:
    text = "SPEED(0) = {} : ACCEL(0) = 1000 : DECEL(0) = 1000\nWAIT(100)\nFor i = 1 To 5\n"
    text += "  MOVER(0) = 20 : GO(0) : PAUSE IDLE(0) : WAIT(100)\nNext\n"
    slow, fast = (run(Source("a.mnt", text.format(speed))) for speed in (50, 100))
    samples = fast.trace.sample(1000.0, [0], None, ["position"])
    rows = "\n".join(f"{t:.6f},{x:.6f}" for t, x in zip(*samples.data, strict=True))
    found = compare(slow, Source("real.csv", "t,x\n" + rows), {"position.0": "x"})
    message = "position.0, MOVER of line 4: recorded the same 20 uu in 33 % less time: 100 against 50 uu/s"
    assert [each.message for each in found.remarks] == [f"{message} (and 4 more)"]


@pytest.mark.parametrize("until", [4.35, 4.5, 4.62, 4.85])
def test_a_move_that_the_end_of_the_run_cuts_is_not_compared(until: float) -> None:
    text = (
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nLoop\n  MOVER(0) = 50 : GO(0) : PAUSE IDLE(0)\n"
    )
    text += "  WAIT(300)\n  MOVER(0) = -50 : GO(0) : PAUSE IDLE(0)\n  WAIT(200)\nEnd Loop\n"
    samples = run(Source("a.mnt", text), until=10.0).trace.sample(200.0, [0], None, ["position"])
    rows = "\n".join(f"{t:.6f},{x:.6f}" for t, x in zip(*samples.data, strict=True))
    found = compare(
        run(Source("a.mnt", text), until=until), Source("real.csv", "t,x\n" + rows), {"position.0": "x"}
    )
    assert all("after the end of the run, and not compared" in each.message for each in found.remarks)
