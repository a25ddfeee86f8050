"""`motionlang pvt`: its output, its error messages, and its exit status."""

from __future__ import annotations

import io
import json
from pathlib import Path

import pytest

from tests.lab.pvt.command import pvt

BAD = """position,velocity,time
0,0,10
100,500,0
200,500,256
3e9,0,10
nan,0,10
300,0,0
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_bad_points_are_named_with_what_the_drive_would_do(folder: Path) -> None:
    (folder / "bad.csv").write_text(BAD)
    answer = pvt("export", "bad.csv")
    assert (answer.status, answer.out) == (1, "")
    assert (
        answer.err
        == """\
error[range]: point 1: the time is 0 in mid-move
 --> bad.csv:3
  |
3 | 100,500,0
  hint: the drive would end the move at this point and keep the 4 points after it for the next start

error[range]: point 2: the time 256 ms is longer than 255 ms
 --> bad.csv:4
  |
4 | 200,500,256
  hint: the field holds eight bits: the drive would end the move at this point

error[range]: point 3: the position 3000000000 counts does not fit 32 bits
 --> bad.csv:5
  |
5 | 3e9,0,10
  hint: the drive would read -1294967296 counts

error[range]: point 4: the position is not a number
 --> bad.csv:6
  |
6 | nan,0,10
  hint: there is nothing that could be sent: no drive would see it
"""
    )


def test_where_nothing_is_sent_they_are_warnings(tmp_path: Path) -> None:
    file = tmp_path / "bad.csv"
    file.write_text(BAD)
    answer = pvt("plot", str(file))
    assert answer.status == 0
    assert answer.err.count("warning[range]") == 4
    assert "1 segment, 10 ms" in answer.out


def test_many_bad_points_are_counted(folder: Path) -> None:
    (folder / "bad.csv").write_text("position,velocity,time\n" + "0,0,300\n" * 50 + "0,0,0\n")
    answer = pvt("export", "bad.csv")
    assert answer.err.count("error[range]") == 21
    assert answer.err.endswith("error[range]: 30 more points like these\n --> bad.csv\n")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["plot"], "give one of: a file of points or a program, --positions, --scurve"),
        (["plot", "--positions", "0,1", "--scurve", "5"], "give one of"),
        (["plot", "--positions", "0,1"], "--positions needs --time"),
        (["plot", "--positions", "0,1,2,3", "--time", "1,2"], "4 positions need 1 or 3 times"),
        (["plot", "--positions", "0", "--time", "1"], "at least two positions"),
        (["plot", "--scurve", "5"], "--scurve needs --time"),
        (["plot", "--scurve", "5", "--time", "1", "--jerk", "1"], "--scurve takes either --time"),
        (["plot", "--positions", "0,1", "--time", "0"], "'0' is not a number greater than zero"),
        (["plot", "--positions", "0,1", "--time", "1,2"], "2 positions need 1 time, not 2"),
        (["plot", "--scurve", "5", "--time", "1", "--speed", "1"], "four equal segments"),
        (["plot", "--positions", "0,1", "--time", "5", "--jerk", "1"], "--jerk has no effect here"),
        (["plot", "--scurve", "5", "--time", "1", "--axis", "1"], "--axis has no effect here"),
        (["plot", "--positions", "0,1", "--time", "5", "--sweeps", "2"], "--sweeps has no effect here"),
        (
            ["plot", "--scurve", "5", "--time", "1", "--plot", "x.gif"],
            "--plot writes .png and .svg, not .gif files",
        ),
        (["plot", "--positions", "0,x", "--time", "1"], "not numbers with commas between them"),
        (["plot", "--scurve", "nan", "--time", "1"], "'nan' is not a number"),
        (["export", "--scurve", "5", "--time", "1", "--node", "128"], "'128' is not a node from 1 to 127"),
        (["export", "--scurve", "5", "--time", "1", "--format", "xml"], "'xml' is not one of"),
        ([], "required"),
    ],
)
def test_a_wrong_command_line_is_status_2(words: list[str], message: str) -> None:
    answer = pvt(*words)
    assert answer.status == 2
    assert message in " ".join(answer.err.split())
    assert answer.out == ""


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["plot", "nowhere.csv"], "error[file]: nowhere.csv cannot be read: no such file or directory\n"),
        (
            ["plot", "--positions", "0,nan,2", "--time", "5"],
            "error[range]: position is not a number\n",
        ),
        (
            ["export", "--positions", "0,20000000,0", "--time", "5", "--format", "pdo"],
            "error[range]: point 1: neither its position nor its distance fits the 24 bits of object 0x2010;",
        ),
        (
            ["export", "--scurve", "1000", "--time", "100.5"],
            "error[range]: point 0: the time 100.5 ms is not a whole number of milliseconds\n",
        ),
        (["plot", "--scurve", "1e300", "--jerk", "1"], "distance must lie between"),
        (["plot", "--scurve", "1", "--jerk", "1e300", "--accel", "1e-9"], "jerk must lie between"),
        (["plot", "--scurve", "1", "--time", "1e-200"], "segment time must lie between"),
    ],
)
def test_what_cannot_be_done_is_status_1(words: list[str], message: str) -> None:
    answer = pvt(*words)
    assert answer.status == 1
    assert message in answer.err


def test_a_start_elsewhere_is_a_warning() -> None:
    answer = pvt("export", "--scurve", "1000", "--time", "100", "--start", "7")
    assert answer.status == 0
    assert answer.err.startswith("warning[range]: point 0: the move begins at 0 but the motor is at 7\n")


def test_refined_points_are_written_and_read(tmp_path: Path) -> None:
    out = tmp_path / "refined.csv"
    words = ["--positions", "0,5000,15000,20000", "--time", "10", "--velocities", "average"]
    assert pvt("refine", *words, "--to", str(out)).status == 0
    assert out.read_text(encoding="utf-8").splitlines()[-4:] == [
        "0,0,10", "5000,750000,10", "15000,750000,10", "20000,0,0",
    ]  # fmt: skip
    assert pvt("plot", str(out), "--format", "none").out == ""


def test_a_file_of_positions_gets_times_and_velocities(tmp_path: Path) -> None:
    file = tmp_path / "positions.csv"
    file.write_text("0\n5000\n15000\n20000\n")
    answer = pvt("export", str(file), "--time", "10")
    assert answer.out.splitlines()[1:] == [
        "position,velocity,time",
        "0,0,10",
        "5000,900000,10",
        "15000,900000,10",
        "20000,0,0",
    ]


def test_linear_and_relative_exports() -> None:
    answer = pvt(
        "export", "--positions", "5,10,30", "--time", "10,20", "--linear", "--relative", "--start", "5"
    )
    assert answer.out.splitlines()[1:] == [
        "position,velocity,time,relative",
        "0,,10,1",
        "5,,20,1",
        "20,,0,1",
    ]


@pytest.mark.parametrize(("count", "shown"), [(1, {"v1"}), (12, {"v1", "v2"}), (13, set())])
def test_up_to_twelve_velocities_are_columns(count: int, shown: set[str]) -> None:
    positions = ",".join(str(100 * n * n) for n in range(count + 2))
    out = pvt("refine", "--positions", positions, "--time", "10").out
    assert {"v1", "v2"} & set(out.split()) == shown


def test_reports_as_json() -> None:
    plot = json.loads(pvt("plot", "--scurve", "1000", "--time", "100", "--format", "json").out)
    assert plot["schema"] == "motionlang/1"
    assert [round(s["jerk"]) for s in plot["segments"]] == [500_000, -500_000, -500_000, 500_000]
    words = ["--positions", "0,5000,15000,20000", "--time", "10", "--format", "json"]
    refined = json.loads(pvt("refine", *words).out)
    assert [m["velocities"] for m in refined["methods"]] == [
        "zero",
        "average",
        "1 sweep",
        "2 sweeps",
        "exact",
    ]


POINTS = ["--positions", "0,5000,15000,20000", "--time", "10"]


@pytest.mark.parametrize(
    ("command", "name", "head"),
    [("plot", "move.svg", b"<svg"), ("refine", "move.png", b"\x89PNG")],
)
def test_a_picture_has_the_format_of_its_file(command: str, name: str, head: bytes, tmp_path: Path) -> None:
    assert pvt(command, *POINTS, "--plot", str(tmp_path / name)).status == 0
    assert (tmp_path / name).read_bytes().startswith(head)


@pytest.mark.usefixtures("unrendered")
def test_export_draws(tmp_path: Path) -> None:
    assert pvt("export", *POINTS, "--plot", str(tmp_path / "move.png")).status == 0
    assert (tmp_path / "move.png").exists()


def test_a_picture_that_cannot_be_written_is_refused_before(tmp_path: Path) -> None:
    answer = pvt("plot", "--scurve", "10", "--time", "5", "--plot", str(tmp_path / "no" / "where.png"))
    assert answer.status == 2
    assert answer.err.startswith("motionlang pvt plot: error: there is no folder ")


SCRIPTS = Path(__file__).parents[3] / "scripts"


def test_a_program_is_fitted() -> None:
    """AN00115's exercise is a trapezoid, which cubics follow exactly."""
    answer = pvt("export", str(SCRIPTS / "mint" / "ballscrew.mnt"))
    assert answer.out.splitlines() == [
        "# ballscrew.mnt, axis 0: 5 segments, 1.000 s, no error",
        "position,velocity,time",
        "0,0,200",
        "30000,300000,90",
        "57000,300000,255",
        "133500,300000,255",
        "210000,300000,200",
        "240000,0,0",
    ]


def test_points_are_exported_with_the_error_of_their_rounding(tmp_path: Path) -> None:
    """The drive takes whole counts: the second point is 10 instead of 10.4."""
    file = tmp_path / "there.csv"
    file.write_text("position,velocity,time\n0,0,100\n10.4,0,100\n0,0,0\n")
    answer = pvt("export", str(file))
    assert answer.out.splitlines()[0] == (
        "# there.csv: 2 segments, 0.200 s, largest error 0.4 counts at 0.100 s"
    )


def test_the_tolerance_counts() -> None:
    lines = [
        len(pvt("export", str(SCRIPTS / "mccl" / "scurve.mcl"), "--tolerance", t).out.splitlines())
        for t in ("0.6", "2", "50")
    ]
    assert lines[0] > lines[1] > lines[2]


@pytest.mark.parametrize(
    ("program", "words", "status", "message"),
    [
        ("PRINT 1", [], 1, "error[values]: no axis moves in p.mnt\n"),
        (
            "MOVER(0) = 5 : MOVER(1) = 5 : GO(0, 1)",
            [],
            2,
            "axes 0, 1 move in p.mnt: choose one with --axis",
        ),
        ("MOVER(0) = 5 : GO(0)", ["--axis", "3"], 2, "axis 3 does not move in p.mnt"),
        ("MOVR(0) = 5", [], 1, "error["),
        ("MOVER(0) = 5 : GO(0)", ["--velocities", "exact"], 2, "--velocities has no effect here"),
    ],
)
def test_programs_that_give_no_move(
    program: str, words: list[str], status: int, message: str, tmp_path: Path
) -> None:
    file = tmp_path / "p.mnt"
    file.write_text(program + "\n")
    answer = pvt("export", str(file), *words)
    assert answer.status == status
    assert message in answer.err


def test_a_file_of_no_language_is_a_wrong_command_line(tmp_path: Path) -> None:
    file = tmp_path / "move.foo"
    file.write_text("1\n")
    assert pvt("export", str(file)).status == 2


def test_points_come_from_standard_input(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"0\n10\n30\n")))
    answer = pvt("export", "-", "--time", "10", "--velocities", "zero")
    assert answer.out.splitlines()[1:] == ["position,velocity,time", "0,0,10", "10,0,10", "30,0,0"]


def test_a_file_that_is_no_text_is_named(folder: Path) -> None:
    (folder / "points.csv").write_bytes(b"0,0,10\0\1\2\n")
    answer = pvt("plot", "points.csv")
    assert (answer.status, answer.err) == (
        1,
        "error[file]: points.csv cannot be read: not a text file: line 1 has a zero byte\n",
    )


def test_a_time_that_prevents_velocities_is_named_with_its_line(folder: Path) -> None:
    (folder / "points.csv").write_text("position,time\n0,10\n100,-5\n200,0\n")
    answer = pvt("refine", "points.csv")
    assert (answer.status, answer.out) == (1, "")
    assert answer.err.startswith("error[range]: point 1: the time is negative\n --> points.csv:3\n")
