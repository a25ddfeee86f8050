"""What `init` finds in a recording; its spelling changes none of it."""

from __future__ import annotations

from itertools import cycle
from pathlib import Path
from time import process_time

import pytest
from hypothesis import given, settings

from motionlang.commands.recording import read_file, table_of
from motionlang.kernel import Source
from motionlang_explore.init.recorded.drafting import entries_of
from motionlang_explore.init.recorded.recording import measured_recording
from test_explore.recording.rules import assert_same_rules, rules_of
from tests.cases import examples
from tests.commands.recording.spelled import STEP, Spelling, moments, text_of, write
from tests.commands.recording.test_answers import exact, folder, spelled  # noqa: F401


@pytest.mark.parametrize(
    ("times", "begin", "warning"),
    [
        # The first second has two rows of five: those of its end.
        ("0 0 1 1 1 1 1 2 2 2 2 2", [0.6, 0.8, 1.0], "the clock has whole seconds"),
        # Of an hour of summer time, rows a second apart show no more than four seconds too much.
        (
            "1:59:56 1:59:57 1:59:58 1:59:59 3:00:03 3:00:04 3:00:05 3:00:06 3:00:07 3:00:08 3:00:09 3:00:10",
            [0.0, 1.0, 2.0, 3.0, 7.0, 8.0],
            "the clock is put forward by an hour",
        ),
        (
            "1:59:56 1:59:57 1:59:58 1:59:59 3:00:04 3:00:05 3:00:06 3:00:07 3:00:08 3:00:09 3:00:10",
            [0.0, 1.0, 2.0],
            "no rows for 3.6e+03 s",
        ),
        ("1754400000000 1754400500000 1754401000000", [0.0, 500.0, 1000.0], "the times are large numbers"),
    ],
)
def test_the_times_of_rows(times: str, begin: list[float], warning: str) -> None:
    text = "\n".join(["time,position.0", *(f"{time},{k}" for k, time in enumerate(times.split()))])
    recording = measured_recording(table_of(Source("rec.csv", text)), ())
    assert recording.positions[0].times[: len(begin)].tolist() == pytest.approx(begin)
    assert warning in recording.remarks[0].message


def events(*, sparse: bool) -> str:
    """Return the recording with a row only where a level changes, or only the levels that have changed."""
    lines, before = ["time,in1,out1,out2"], ("", "", "")
    for each in moments():
        levels = (str(each.a), str(each.b), str(each.c))
        if levels != before:
            cells = [new if not sparse or new != old else "" for new, old in zip(levels, before, strict=True)]
            lines.append(",".join([f"{each.t:.3f}", *cells]))
            before = levels
    return "\n".join(lines)


@pytest.mark.parametrize("sparse", [False, True])
def test_a_row_only_where_something_changes(sparse: bool) -> None:
    """A level holds from its row, and a change has the time of its row."""
    measured = measured_recording(table_of(Source("rec.csv", events(sparse=sparse))), ())
    assert "a row only where something changes, 4 columns used of 4" in measured.sentence
    assert measured.remarks == ()
    rules = entries_of(measured)[1]["input"]
    assert [each["delay"] for each in rules] == pytest.approx([1.2, 0.35], abs=STEP)  # type: ignore[attr-defined]
    assert measured.outputs[1].changes[0].time == next(each.t for each in moments() if each.b)


@settings(max_examples=examples(80), deadline=None)
@given(spelled())
def test_no_spelling_changes_a_rule(folder: Path, spelling: Spelling) -> None:  # noqa: F811
    """Order, unit, clock, decimal sign, levels and format change nothing beyond a step."""
    assert_same_rules(rules_of(read_file(str(write(spelling, folder)))), rules_of(exact()))


@pytest.mark.slow
@pytest.mark.parametrize("form", ["{t:.3f}", "{d:%d.%m.%Y %H:%M:%S.%f}"])
def test_reading_takes_time_in_proportion_to_the_rows(form: str) -> None:
    def seconds(count: int) -> float:
        rows = [each._replace(t=k * STEP) for k, each in zip(range(count), cycle(moments()), strict=False)]
        lines = ["time,position.0,in1,out1,out2", form + ",{x:.4f},{a},{b},{c}"]
        source = Source("rec.csv", text_of(Spelling("", lines), rows))
        begin = process_time()
        measured_recording(table_of(source), ())
        return process_time() - begin

    assert min(seconds(40_000) for _ in range(2)) < 12.0 * min(seconds(8_000) for _ in range(3))
