"""Comparison of a recording with a run: delay, residuals, lags and rejected files."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motionlang import compare, run
from motionlang.cli import main
from motionlang.commands.compare.view import render_comparison
from motionlang.kernel import ProgramError, Run, Source

PROGRAM = """\
SPEED(0, 1) = 100, 50
ACCEL(0, 1) = 1000;
DECEL(0, 1) = 1000;
WAIT(100)
MOVER(0, 1) = 80, -20 : GO(0, 1)
PAUSE IDLE(0) And IDLE(1)
WAIT(200)
MOVEA(0) = 0 : GO(0)
PAUSE IDLE(0)
WAIT(300)
"""
X = {"position.0": "x"}
BOTH = X | {"position.1": "y"}


@cache
def simulated() -> Run:
    return run(Source("two.mnt", PROGRAM), dialect="mint")


def recorded(values: Callable[[np.ndarray], Sequence[np.ndarray]], rate: float = 1000.0) -> Source:
    """Return a recording of two and a half seconds, columns t, x, y.

    `values` computes them from the times.
    """
    times = np.arange(int(2.5 * rate)) / rate
    rows = np.stack([times, *values(times)], 1)
    return Source("real.csv", "t,x,y\n" + "\n".join(",".join(f"{cell:.9f}" for cell in row) for row in rows))


def at(axis: int, times: np.ndarray) -> np.ndarray:
    made = simulated().trace
    return made.at(axis, "position", np.clip(times, 0.0, made.end))


def compared(source: Source, mapping: dict[str, str] | None = None, **options: Any) -> Any:
    return compare(simulated(), source, mapping or X, **options)


@pytest.mark.parametrize("delay", [0.0, 0.31234, -0.0421])
def test_the_same_motion_is_found_wherever_the_recording_begins(delay: float) -> None:
    made = compared(recorded(lambda t: (at(0, t - delay), at(1, t - delay))), BOTH)
    assert made.delay == pytest.approx(delay, abs=1e-7)
    for row in made.signals:
        assert abs(row["peak"]) < 1e-4
        assert (row["scale"], row["offset"]) == pytest.approx((1.0, 0.0), abs=1e-6)
    assert [row["line"] for row in made.moves if row["signal"] == "position.0"] == [5, 8]
    assert [phase["name"] for phase in made.moves[0]["phases"]] == ["accel", "slew", "decel"]


def test_what_was_put_in_comes_out() -> None:
    """Two axes, one of them 5 ms late; an overshoot of 3 uu; one outlier.

    The outlier is 2 uu off, at constant speed.
    """
    end = simulated().trace.end
    second = next(move for move in simulated().controller.log.moves if move.line == 8)
    over = second.start_time + (second.profile.duration if second.profile else 0.0) + 0.05

    def real(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        x = at(0, t)
        x[np.abs(t - 0.5).argmin()] += 2.0
        x[np.abs(t - over).argmin()] -= 3.0
        return x, at(1, t - 0.005)

    made = compared(recorded(real), BOTH, delay=0.0)
    assert end > over
    first, back, other = made.moves
    assert (first["peak"], first["peak_time"]) == pytest.approx((2.0, 0.5), abs=1e-6)
    assert [phase["peak"] for phase in first["phases"]] == pytest.approx([0.0, 2.0, 0.0], abs=1e-6)
    assert back["overshoot"] == pytest.approx(3.0)
    assert first["overshoot"] == 0.0
    assert other["lag"] == pytest.approx(0.005, rel=0.05)
    assert other["peak"] == pytest.approx(0.25, rel=0.01)  # 50 uu/s for 5 ms
    assert made.is_within is None


@pytest.mark.parametrize(("tolerance", "within"), [(0.2, False), (0.3, True)])
def test_a_tolerance_judges(tolerance: float, within: bool) -> None:
    made = compared(
        recorded(lambda t: (at(0, t - 0.0025), at(1, t))), tolerances={"position": tolerance}, delay=0.0
    )
    assert made.is_within is within
    assert made.moves[0]["phases"][1]["within"] is within


def test_another_unit_is_reported_with_its_factor() -> None:
    made = compared(recorded(lambda t: (1000.0 * at(0, t), at(1, t))))
    (remark,) = [each for each in made.remarks if "times as far" in each.message]
    assert "--map position.0=x*0.001" in remark.hint
    rescaled = compared(recorded(lambda t: (1000.0 * at(0, t), at(1, t))), {"position.0": "x*0.001"})
    assert rescaled.remarks == []


def test_a_trace_of_ours_needs_no_mapping(tmp_path: Path) -> None:
    (tmp_path / "two.mnt").write_text(PROGRAM)
    assert main(["trace", str(tmp_path / "two.mnt"), str(tmp_path / "x.csv"), "--rate", "500"]) == 0
    made = compare(simulated(), Source.read(tmp_path / "x.csv"))
    assert {row["signal"] for row in made.signals} == {
        f"{quantity}.{axis}" for quantity in ("position", "velocity", "acceleration") for axis in (0, 1)
    }
    assert abs(made.delay) < 1e-6


def test_a_column_with_the_name_of_a_quantity_needs_no_mapping() -> None:
    source = recorded(lambda t: (at(0, t), at(1, t)))
    named = Source("x.csv", source.text.replace("t,x,y", "time,position.0,position.1", 1))
    assert {row["signal"] for row in compare(simulated(), named).signals} == {"position.0", "position.1"}


def test_a_lag_of_nothing_has_no_sign() -> None:
    made = compared(recorded(lambda t: (at(0, t + 1e-7), at(1, t))), delay=0.0)
    assert -1e-6 < made.moves[0]["lag"] < 0.0
    assert "-0.000 " not in render_comparison(made, width=200, everything=True)


# ------------------------------------------------------------------------------------------ files as they come


def test_missing_numbers_gaps_and_time_that_starts_again_are_reported_and_skipped() -> None:
    lines = recorded(lambda t: (at(0, t), at(1, t))).text.split("\n")
    lines[10] = lines[10].split(",")[0] + ",NaN,0"
    lines[20] = lines[20].split(",")[0] + ",---,0"
    del lines[700:800]
    lines[1:1] = [f"{7 + i / 1000},0,0" for i in range(50)]
    lines.append("2.6,0")
    made = compared(Source("real.csv", "\n".join(lines)))
    remarks = {each.message: each for each in made.remarks}
    assert remarks["x: 2 values of 2451 not a number, the first is 'NaN'"].line == 61
    assert remarks["time starts again: 2 stretches, of 50 and 2401 rows"].line == 52
    assert "lines 52 to 2452" in remarks["time starts again: 2 stretches, of 50 and 2401 rows"].hint
    assert remarks["1 row without 3 columns"].line == 2452
    assert made.recording.sentence == (
        "real.csv: 2 401 of 2 451 rows, 0 to 2.6 s, every 0.001 s, 2 gaps (0.101 s at 0.698 s), "
        "2 columns used of 3"
    )
    assert abs(made.signals[0]["peak"]) < 1e-4


@pytest.mark.parametrize(
    ("text", "mapping", "message", "hint"),
    [
        ("", X, "fewer than two rows of numbers", "as a drive or a scope exports them to CSV"),
        ("hello\nworld\n", X, "fewer than two rows of numbers", "as a drive or a scope exports them to CSV"),
        ("a,x\n0,1\n1,2\n2,3\n", X, "real.csv has no column named time", "its columns are a, x"),
        ("t,pos\n0,1\n1,2\n2,3\n", X, "has no column 'x'", "its columns are t, pos"),
        ("t;pos;\n0;1;\n1;2;\n2;3;\n", X, "has no column 'x'", "its columns are t, pos"),
        ("t,x\n0,1\n1,1\n2,1\n", X, "nothing moves", "with --delay S"),
        (
            "t,x\n0,1\n1,1\n2,1\n",
            {},
            "the columns of real.csv are not assigned",
            "--map position.0=NAME; its columns are t, x",
        ),
        ("t,x\n0,n\n1,\n2,-\n3,4\n", X, "fewer than three numbers", ""),
        (
            "t,x\n0,1\n1,2\n",
            {"speed.0": "x"},
            "'speed' is no quantity",
            "velocity, acceleration, jerk, actual",
        ),
        ("t,x\n0,1\n1,2\n", {"position.9": "x"}, "names no axis", "position.0 is that of the first axis"),
        ("t,x\n0,1\n1,2\n", {"position": "x"}, "names no axis", "position.0 is that of the first axis"),
    ],
)
def test_what_cannot_be_compared_is_answered(
    text: str, mapping: dict[str, str], message: str, hint: str
) -> None:
    """A separator at the end of each line makes no column."""
    with pytest.raises(ProgramError) as caught:
        compare(simulated(), Source("real.csv", text), mapping)
    (diagnostic,) = caught.value.diagnostics
    assert message in diagnostic.message
    assert diagnostic.hint.endswith(hint)


def slow() -> Run:
    """Return a run that moves 8 uu at 4 uu/s in 2.5 s, and then waits 2 s."""
    text = "SPEED(0) = 4 : ACCEL(0) = 8 : DECEL(0) = 8\nMOVER(0) = 8 : GO(0) : PAUSE IDLE(0)\nWAIT = 2000\n"
    return run(Source("a.mnt", text), machine={"controller.instruction_time": 1e-9})


def rounded(value: object) -> object:
    if isinstance(value, dict):
        return {name: rounded(each) for name, each in value.items()}
    if isinstance(value, list):
        return list(map(rounded, value))
    return round(value, 6) if isinstance(value, float) else value


# The position every 0.5 s.
POSITIONS = (0.0, 1.0, 3.0, 5.0, 7.0, 8.0, 8.0, 8.0, 8.0, 8.0)


def test_a_recording_of_another_time_has_no_figures() -> None:
    text = "\n".join(f"{k / 2},{x}" for k, x in enumerate(POSITIONS))
    made = compare(slow(), Source("b.csv", "t,x\n" + text), X, delay=-9.0, tolerances={"position": 0.3})
    nothing = {"peak": None, "peak_time": None, "rms": None, "within": None}
    assert made.signals == [
        {
            "signal": "position.0",
            "column": "x",
            "points": 0,
            "scale": 1.0,
            "offset": 0.0,
            "moves": False,
            "lag": None,
        }
        | nothing
    ]
    (move,) = made.moves
    assert move["phases"] == [{"name": name, **nothing} for name in ("accel", "slew", "decel")]
    assert {name: move[name] for name in (*nothing, "lag", "overshoot")} == {
        **nothing,
        "lag": None,
        "overshoot": None,
    }
    assert made.is_within is None
    assert [each.message for each in made.remarks] == ["position.0: no time of x lies within the run"]


@pytest.mark.parametrize(("tolerance", "within"), [(0.25, True), (0.2499, False), (None, None)])
def test_a_residual_of_just_the_tolerance_is_within_it(tolerance: float | None, within: bool | None) -> None:
    """The axis is at rest in the recording, 0.25 uu too low."""
    given = {} if tolerance is None else {"position.0": tolerance, "position": 0.0}
    made = compare(slow(), Source("b.csv", "t,x\n3,7.75\n3.5,7.75\n4,7.75"), X, delay=0.0, tolerances=given)
    assert made.is_within is within
    assert [each["moves"] for each in made.signals] == [False]


@pytest.mark.parametrize(
    ("times", "gaps"),
    [
        ((0.0, 1.0, 2.0, 3.0, 6.5, 7.5), ""),
        ((0.0, 1.0, 2.0, 3.0, 7.0, 8.0), "1 gap (0.4 s at 0.3 s), "),
        ((0.0, 1.0, 2.0, 6.0, 7.0, 8.0, 13.0, 14.0, 15.0), "2 gaps (0.5 s at 0.8 s), "),
    ],
)
def test_a_time_step_of_more_than_three_and_a_half_usual_ones_is_a_gap(
    times: tuple[float, ...], gaps: str
) -> None:
    text = "\n".join(f"{time / 10},1" for time in times)
    made = compare(simulated(), Source("b.csv", "t,x\n" + text), X, delay=0.0)
    assert f"every 0.1 s, {gaps}2 columns" in made.recording.sentence


# ------------------------------------------------------------------------------------------ the command


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "two.mnt").write_text(PROGRAM)
    (tmp_path / "real.csv").write_text(recorded(lambda t: (at(0, t - 0.2), at(1, t - 0.2))).text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ("times", "points", "remark"),
    [
        ("0 1 2", 3, ""),
        ("0 nan 1 2", 3, "t: 1 value of 4 not a time"),
        ("0 1 1 2", 3, "1 row doubled"),
        ("0 2 1 3 4", 5, "1 row out of order"),
        ("2 1 0", 3, "the newest row comes first"),
        (f"{' '.join(map(str, range(40)))} 0 1 2", 40, "time starts again: 2 stretches, of 40 and 3 rows"),
        (
            f"{' '.join(map(str, range(40)))} {' '.join(map(str, range(90000, 90030)))}",
            40,
            "no rows for 900 s: 2",
        ),
        (f"{' '.join(map(str, range(20)))} 999 {' '.join(map(str, range(20, 40)))}", 40, "out of line"),
    ],
)
def test_rows_are_read_in_order(times: str, points: int, remark: str) -> None:
    text = "\n".join(f"{float(each) / 100},0" for each in times.split())
    made = compared(Source("b.csv", "t,x\n" + text), delay=0.0)
    assert made.signals[0]["points"] == points
    messages = [each.message for each in made.recording.remarks]
    assert len(messages) == bool(remark)
    assert all(remark in each for each in messages)
