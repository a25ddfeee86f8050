"""nv data: a run finds the data of the previous one, if they match its variables."""

from __future__ import annotations

from json import dumps, loads
from pathlib import Path

import pytest

from motionlang.kernel import Run, Source, run
from tests.cases import cases

COUNTERS = """\
Type Point
  x As Float
  n As Integer
End Type
Dim nv total As Integer = 10
Dim nv label As String * 8 = "new"
Dim nv place(3) As Float = 1, 2, 3
Dim nv corner As Point
Dim nv corners(2) As Point
total = total + 1
label = Left(label, 3) + Str(total)
place(2) = place(2) * 2
corner.x = corner.x + 0.5 : corner.n = corner.n + 1
corners(2).n = corners(2).n + 7
count() : count()
NVLONG(3) = NVLONG(3) + 1
NVFLOAT(4) = NVFLOAT(4) - 0.25
PRINT total, " ", label, " ", place(2), " ", corner.x, " ", corner.n, " ", corners(2).n
PRINT NVLONG(3), " ", NVFLOAT(4)
Sub count()
  Dim nv calls As Integer
  calls = calls + 1
  PRINT calls;
End Sub
"""


def ran(text: str, file: Path | None, status: str = "ended") -> Run:
    result = run(Source("a.mnt", text), nv=None if file is None else str(file))
    assert result.status == status
    return result


def test_the_next_run_goes_on_where_the_last_one_ended(tmp_path: Path) -> None:
    file = tmp_path / "kept.json"
    outputs = [ran(COUNTERS, file).output for _ in range(3)]
    assert outputs == [
        ["1211 new11 4.0000 0.5000 1 7", "1 -0.2500"],
        ["3412 new12 8.0000 1.0000 2 14", "2 -0.5000"],
        ["5613 new13 16.0000 1.5000 3 21", "3 -0.7500"],
    ]


def test_without_a_file_nothing_is_stored_and_the_run_reports_it() -> None:
    first, second = ran(COUNTERS, None), ran(COUNTERS, None)
    assert first.output == second.output
    assert first.notes == [
        "nv data stored only during the run (use --nv FILE): "
        "total, label, place, corner, corners, count.calls, NVLONG"
    ]


def test_program_without_nv_data_reports_nothing(tmp_path: Path) -> None:
    assert ran("PRINT 1", None).notes == []
    file = tmp_path / "kept.json"
    ran("Dim nv a As Integer = 4", file)
    ran("PRINT 1", file)
    assert loads(file.read_text())["values"] == {"a": [4]}


def stored(folder: Path, **tree: object) -> Path:
    """Return a file with nonvolatile data."""
    path = folder / "kept.json"
    path.write_text(dumps({"schema": "motionlang.nv/1", **tree}), encoding="utf-8")
    return path


@cases(
    "value, declared, shown",
    [
        ([5], "v As Integer = 1", "5"),
        ([2147483647], "v As Integer = 1", "2147483647"),
        ([2147483648], "v As Integer = 1", "1"),
        ([-2147483648], "v As Integer = 1", "-2147483648"),
        ([-2147483649], "v As Integer = 1", "1"),
        ([1.5], "v As Integer = 1", "1"),
        ([True], "v As Integer = 1", "1"),
        (["a"], "v As Integer = 1", "1"),
        (5, "v As Integer = 1", "1"),
        ([1, 2], "v As Integer = 7", "7"),
        ([5], "v As Float = 1", "5.0000"),
        ([True], "v As Float = 1", "1.0000"),
        ([5], 'v As String = "no"', "no"),
        (["a"], 'v As String = "no"', "a"),
        ([0, 3, 4], "v(2) As Integer = 1, 2", "34"),
        ([0, 3, "a"], "v(2) As Integer = 1, 2", "12"),
        ([0, 3, 4, 5], "v(2) As Integer = 1, 2", "12"),
    ],
)
def test_a_stored_value_is_restored_if_its_kind_size_and_range_fit(
    value: object, declared: str, shown: str, tmp_path: Path
) -> None:
    items = "v(1); v(2)" if declared.startswith("v(") else "v"
    assert ran(f"Dim nv {declared}\nPRINT {items}", stored(tmp_path, values={"v": value})).output == [shown]


def test_words_have_addresses_up_to_1023_and_32_bits(tmp_path: Path) -> None:
    words = {
        "0": 5, "1023": -2147483648, "7": 2147483647, "1024": 1, "-1": 1, "8": 2147483648, "9": -2147483649,
        "10": 1.5, "011": 3, "x": 4,
    }  # fmt: skip
    text = "".join(f"PRINT NVLONG({address})\n" for address in (0, 1023, 7, 8, 9, 10, 11))
    assert ran(text, stored(tmp_path, words=words)).output == [
        "5", "-2147483648", "2147483647", "0", "0", "0", "0",
    ]  # fmt: skip


def test_failed_run_stores_its_nv_data(tmp_path: Path) -> None:
    file = tmp_path / "kept.json"
    ran("Dim nv a As Integer\na = 7\na = a / 0", file, "fault")
    assert ran("Dim nv a As Integer\nPRINT a", file).output == ["7"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{}",
        '{"schema": "other/1"}',
        "\x00",
        '{"schema": "motionlang.nv/1", ',
        "[" * 100_000,
        '{"schema": "motionlang.nv/1", "words": {"1": ' + "9" * 5000 + "}}",
    ],
    ids=lambda text: text[:20],
)
def test_a_file_that_is_none_is_refused_and_left_alone(text: str, tmp_path: Path) -> None:
    file = tmp_path / "kept.json"
    file.write_text(text)
    result = ran("Dim nv a As Integer\nPRINT 1", file, "fault")
    assert result.output == []
    assert [each.code for each in result.diagnostics] == ["file"]
    assert file.read_text() == text


@pytest.mark.parametrize(
    "part",
    [
        '"values": 3',
        '"words": [1]',
        '"values": {"a": 4}',
        '"words": {"x": 1}',
        '"words": {"3": 1e9}',
        f'"words": {{"{"3" * 5000}": 1}}',
    ],
)
def test_nonsense_inside_is_no_traceback(part: str, tmp_path: Path) -> None:
    file = tmp_path / "kept.json"
    file.write_text('{"schema": "motionlang.nv/1", ' + part + "}")
    result = run(Source("a.mnt", "Dim nv a As Integer = 5\nPRINT a, NVLONG(3)"), nv=str(file))
    assert result.output == ["50"] or [each.code for each in result.diagnostics] == ["file"]


def test_unwritable_path_is_reported(tmp_path: Path) -> None:
    """The report comes before the run, so that a run of eight hours is not lost."""
    result = ran("Dim nv a As Integer\nPRINT 1", tmp_path / "none" / "kept.json", "fault")
    assert result.output == []
    assert "cannot be read" in result.diagnostics[0].message


def test_files_of_a_killed_run_do_not_block_the_next(tmp_path: Path) -> None:
    (tmp_path / ".kept.json.lock").write_text("")
    assert ran("Dim nv a As Integer = 1\nPRINT a", tmp_path / "kept.json").output == ["1"]


def test_a_handler_and_a_task_share_the_data_of_the_program(tmp_path: Path) -> None:
    file = tmp_path / "kept.json"
    text = (
        "Dim nv ticks As Integer\nTIMEREVENT = 10\nWAIT = 35\nRun more\nWAIT = 1\nPRINT ticks\nEnd\n"
        "Event TIMER\n ticks = ticks + 1\nEnd Event\nTask more\n ticks = ticks + 100\nEnd Task"
    )
    assert [ran(text, file).output for _ in range(2)] == [["103"], ["206"]]
