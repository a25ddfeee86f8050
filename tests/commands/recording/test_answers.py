"""What `compare` says about a recording: passes, clocks, speeds; its spelling changes none of it."""

from __future__ import annotations

from functools import cache
from itertools import cycle
from pathlib import Path
from time import process_time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.commands.compare.baseline import baseline_of, read_compared
from motionlang.commands.compare.comparison import Comparison, compare
from motionlang.commands.recording import read_file, table_of
from motionlang.kernel import ProgramError, Run, Source, run
from motionlang_explore.init.recorded.drafting import entries_of
from motionlang_explore.init.recorded.recording import measured_recording
from tests.cases import examples
from tests.commands.recording.spelled import STEP, Answer, Spelling, answer, moments, text_of, write

HEAD = "SPEED(0) = {} : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
CYCLE = (
    "MOVEA(0) = 40 : GO(0) : PAUSE IDLE(0) : WAIT(300)\nMOVEA(0) = 0 : GO(0) : PAUSE IDLE(0) : WAIT(500)\n"
)


@cache
def passes(count: int, speed: float = 100.0) -> Run:
    return run(Source("m.mnt", HEAD.format(speed) + CYCLE * count), dialect="mint")


def recorded(result: Run, step: float = 0.01, before: float = 0.0, clock: float = 1.0) -> Source:
    times = np.arange(-before, result.time, step)
    positions = result.trace.at(0, "position", np.maximum(times, 0.0))
    rows = (f"{clock * (time + before):.6f},{each:.5f}" for time, each in zip(times, positions, strict=True))
    return Source("rec.csv", "\n".join(["time,position.0", *rows]))


def compared(result: Run, source: Source) -> Comparison:
    baseline = baseline_of(result)
    return compare(baseline, read_compared(table_of(source), [], baseline))


@pytest.mark.parametrize("before", [0.0, 0.7])
@pytest.mark.parametrize(("mine", "theirs"), [(1, 1), (1, 2), (1, 3), (2, 1), (2, 5), (5, 2)])
def test_the_first_of_several_passes_is_compared(mine: int, theirs: int, before: float) -> None:
    made = compared(passes(mine), recorded(passes(theirs), before=before))
    assert made.delay == pytest.approx(before, abs=1e-4)
    assert abs(made.signals[0]["peak"]) < 1e-3
    later = [each.message for each in made.remarks if "after the end of the run" in each.message]
    count = 2 * (theirs - mine)
    assert later == (
        [
            f"position.0: {count} moves from {1.8 * mine:.3g} s on are recorded after the end of the run, "
            "and not compared"
        ]
        if count > 0
        else []
    )


@pytest.mark.parametrize("clock", [0.99, 0.998, 1.001, 1.002])
@pytest.mark.parametrize("step", [0.001, 0.005])
def test_a_clock_of_another_rate_is_one_sentence(clock: float, step: float) -> None:
    """`init` finds the same from the same strokes."""
    made = compared(passes(8), recorded(passes(8), step, clock=clock))
    text = f"{100.0 * abs(clock - 1.0):.1g} % {'fast' if clock > 1.0 else 'slow'}"
    assert [each.message for each in made.remarks] == [
        f"the clock of the recording is {text}; its times are corrected"
    ]
    assert abs(made.signals[0]["peak"]) < 0.01


@pytest.mark.parametrize("speed", [98.5, 99.5])
def test_a_slower_drive_is_no_clock(speed: float) -> None:
    """The rests take as long as in the run."""
    made = compared(passes(8), recorded(passes(8, speed), 0.005))
    assert not any("clock" in each.message for each in made.remarks)


def test_nine_moves_at_another_speed_are_one_warning() -> None:
    made = compared(passes(5), recorded(passes(5, 80.0)))
    (remark,) = made.remarks
    assert remark.message.startswith(
        "position.0, MOVEA of line 2: recorded the same 40 uu in 17 % more time: 80 against 100 uu/s "
        "(and 9 more: line 3 "
    )
    assert remark.message.endswith("line 11 in 17 % more time: 80 against 100 uu/s)")


def test_two_recordings_of_one_machine() -> None:
    """The strokes of the older one are the moves; both count from their first row."""
    older = read_compared(table_of(recorded(passes(2))), [])
    baseline = baseline_of(older)
    newer = recorded(passes(2, 80.0), before=0.3)
    made = compare(baseline, read_compared(table_of(newer), [], baseline))
    assert [row["start_time"] for row in made.moves] == pytest.approx([0.0, 0.8, 1.8, 2.6], abs=0.02)
    assert made.moves[0]["lag"] == pytest.approx(0.0, abs=0.01)
    (remark,) = made.remarks
    assert remark.message.startswith("position.0, move at 0 s: recorded the same 40 uu in 16 % more time: ")
    assert "80 against 100 uu/s (and 3 more: move at " in remark.message


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


def test_damaged_rows_of_a_parquet_file(tmp_path: Path) -> None:
    """Groups of rows are read one by one; without its end the file has no columns."""
    lines = ["time,position.0,in1,out1,out2", "{d:%Y-%m-%d %H:%M:%S.%f},{x:.4f},{a},{b},{c}"]
    path = write(Spelling("", lines, {"format": "parquet"}), tmp_path)
    data = bytearray(path.read_bytes())
    data[4:40] = bytes(36)
    path.write_bytes(data)
    found = read_compared(read_file(str(path)), [])
    assert found.remarks[0].message == "1 of 4 groups of rows cannot be read"
    path.write_bytes(data[:-20])
    with pytest.raises(ProgramError) as caught:
        read_file(str(path))
    assert "a file that is cut off cannot be read" in caught.value.diagnostics[0].hint


@pytest.mark.parametrize(
    ("unit", "count"), [("s", 2), ("ms", 2000), ("us", 2_000_000), ("ns", 2_000_000_000)]
)
def test_durations_of_a_parquet_file_are_seconds(unit: str, count: int, tmp_path: Path) -> None:
    pa, parquet = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    table = pa.table({"time": pa.array([0, count], pa.duration(unit)), "in1": [0, 1]})
    parquet.write_table(table, tmp_path / "rec.parquet")
    found = read_file(str(tmp_path / "rec.parquet"))
    assert [float(each) for each in found.columns["time"]] == [0.0, 2.0]


# Times by the name of their column, and the form of a cell.
TIMES = {
    "time": "{t:.3f}", "Zeit [ms]": "{ms}", "t_us": "{us}", "time_ns": "{ns}", "epoch": "{epoch:.3f}",
    "timestamp": "{d:%Y-%m-%dT%H:%M:%S.%f}Z", "Uhrzeit": "{d:%H:%M:%S.%f}", "datetime": "{d:%d.%m.%Y %H:%M:%S.%f}",
}  # fmt: skip


@cache
def right() -> Answer:
    lines = ["time,axis0_position_uu,in1,out1,out2", "{t:.3f},{x:.4f},{a},{b},{c}"]
    return answer(table_of(Source("rec.csv", text_of(Spelling("", lines)))))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recordings")


@settings(max_examples=examples(80), deadline=None)
@given(
    name=st.sampled_from(sorted(TIMES)),
    comma=st.booleans(),
    separator=st.sampled_from([",", ";", "\t", "|"]),
    level=st.sampled_from(["", ":w", ":o", ":v", ":m"]),
    order=st.sampled_from(["", "newest", "swapped", "doubled", "shuffled"]),
    encoding=st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "latin-1"]),
    form=st.sampled_from(["csv", "csv", "csv", "parquet"]),
)
def test_no_spelling_changes_an_answer(
    folder: Path, name: str, comma: bool, separator: str, level: str, order: str, encoding: str, form: str
) -> None:
    """Order, unit, clock, decimal sign, levels and format change nothing beyond a step."""
    options = {"order": order, "encoding": encoding}
    position = "{xc}" if comma and separator != "," else "{x:.4f}"
    if form != "csv":  # the tests write numbers in seconds
        separator, position, name, options = ",", "{x:.4f}", "time", {"format": form}
    levels = [f"{{{each}{level if form == 'csv' else ''}}}" for each in "abc"]
    lines = [
        separator.join([name, "position.0", "in1", "out1", "out2"]),
        separator.join([TIMES[name], position, *levels]),
    ]
    found = answer(read_file(str(write(Spelling("", lines, options), folder))))
    assert abs(found.delay - right().delay) < STEP
    assert found.residual < 0.01
    assert found.points == right().points
    assert [keys for keys, _ in found.rules] == [keys for keys, _ in right().rules]
    for (_, mine), (_, exact) in zip(found.rules, right().rules, strict=True):
        assert mine == pytest.approx(exact, abs=STEP)


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
