"""What `compare` says about a recording: passes, clocks, speeds; its spelling changes none of it."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.commands.compare.baseline import baseline_of, read_compared
from motionlang.commands.compare.comparison import Comparison, compare
from motionlang.commands.recording import RecordedTable, read_file, table_of
from motionlang.kernel import ProgramError, Run, Source, run
from tests.cases import examples
from tests.commands.recording.spelled import STEP, Spelling, answer, text_of, write

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


@st.composite
def spelled(draw: st.DrawFn) -> Spelling:
    """Return a spelling of some order, unit, clock, decimal sign, levels and format."""
    name = draw(st.sampled_from(sorted(TIMES)))
    comma = draw(st.booleans())
    separator = draw(st.sampled_from([",", ";", "\t", "|"]))
    level = draw(st.sampled_from(["", ":w", ":o", ":v", ":m"]))
    options = {
        "order": draw(st.sampled_from(["", "newest", "swapped", "doubled", "shuffled"])),
        "encoding": draw(st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "latin-1"])),
    }
    position = "{xc}" if comma and separator != "," else "{x:.4f}"
    if draw(st.sampled_from(["csv", "csv", "csv", "parquet"])) != "csv":  # numbers in seconds
        separator, position, name, level, options = ",", "{x:.4f}", "time", "", {"format": "parquet"}
    levels = [f"{{{each}{level}}}" for each in "abc"]
    lines = [
        separator.join([name, "position.0", "in1", "out1", "out2"]),
        separator.join([TIMES[name], position, *levels]),
    ]
    return Spelling("", lines, options)


@cache
def exact() -> RecordedTable:
    """Return the recording in its plainest spelling."""
    lines = ["time,axis0_position_uu,in1,out1,out2", "{t:.3f},{x:.4f},{a},{b},{c}"]
    return table_of(Source("rec.csv", text_of(Spelling("", lines))))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recordings")


@settings(max_examples=examples(80), deadline=None)
@given(spelled())
def test_no_spelling_changes_an_answer(folder: Path, spelling: Spelling) -> None:
    """Order, unit, clock, decimal sign, levels and format change nothing beyond a step."""
    found, right = answer(read_file(str(write(spelling, folder)))), answer(exact())
    assert abs(found.delay - right.delay) < STEP
    assert found.residual < 0.01
    assert found.points == right.points
