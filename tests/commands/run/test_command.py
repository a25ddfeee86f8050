"""`motionlang run`, used by a person or by a program."""

from __future__ import annotations

import io
import json
import re
import sys
from pathlib import Path

import pytest

from motionlang.cli import run_command as simulated
from motionlang.cli.commands import COMMANDS
from tests.cases import cases
from tests.cli.programs import BALLSCREW, Cell

WRONG = """\
error[unknown-word]: there is no command XX (?1: unrecognised command)
 --> wrong.mcl:2:1
  |
2 | 1XX3
  | ^^^^

error[disabled-axis]: axis 2 is off
 --> wrong.mcl:3:1
  |
3 | 2MR10
  | ^^^^^
"""


def without_hints(text: str) -> str:
    """Return a text without its hints, which depend on the language."""
    return "".join(line for line in text.splitlines(keepends=True) if "hint: " not in line)


def test_json_has_the_mistakes_too(cell: Cell) -> None:
    ran = cell("run", "wrong.mcl", "--format", "json")
    report = json.loads(ran.out)
    assert (ran.status, without_hints(ran.err)) == (1, WRONG)
    assert [(d["code"], d["line"], d["column"]) for d in report["diagnostics"]] == [
        ("unknown-word", 2, 1),
        ("disabled-axis", 3, 1),
    ]


def test_json_of_a_file_that_cannot_be_read_has_the_mistake(cell: Cell) -> None:
    assert json.loads(cell("run", "none.mcl", "--format", "json").out)["diagnostics"][0]["code"] == "file"


def test_a_folder_is_no_program(cell: Cell) -> None:
    assert cell("run", ".").err == "error[file]: . cannot be read: is a directory\n"


def test_a_suffix_that_no_dialect_owns(cell: Cell) -> None:
    cell.write("pick.txt", BALLSCREW)
    ran = cell("run", "pick.txt")
    assert (ran.status, ran.out) == (2, "")
    assert ran.err == (
        "error[file]: unknown language of pick.txt: no language has the extension .txt\n"
        "  hint: add --lang mint or --lang mccl; .mnt, .mntx and .prg are Mint, .mcl and .mccl are MCCL\n"
    )
    assert cell("run", "pick.txt", "--lang", "mccl", "--format", "none").status == 0


def test_standard_input(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"1MN,1TP\r1XX\r")))
    ran = cell("run", "-", "--lang", "mccl", "--format", "none")
    assert ran.status == 1
    assert " --> <stdin>:2:1\n" in ran.err
    assert "unknown language of standard input: it has no name" in cell("run", "-").err


@pytest.mark.parametrize("content", [b"", b"\0\xff\xfe\x00" * 50, b"\xef\xbb\xbf1MN\r\n", bytes(range(256))])
def test_any_bytes_end_without_a_traceback(cell: Cell, content: bytes) -> None:
    cell.write("bytes.mcl", content)
    ran = cell("run", "bytes.mcl", "--format", "json", "--until", "10")
    assert ran.status in (0, 1)
    assert json.loads(ran.out)["schema"] == "motionlang.report/3"


def test_set_gives_machine_keys_their_kind(cell: Cell) -> None:
    ran = cell("run", "ballscrew.mcl", "--set", "controller.instruction_time=1e-3", "--format", "json")
    assert json.loads(ran.out)["moves"][0]["start_time"] == pytest.approx(8e-3)


def test_the_machine_file_and_what_overrides_it(cell: Cell) -> None:
    cell.write("cell.toml", "[controller]\ninstruction_time = 1e-3\naxes = 2\n")
    ran = cell("run", "ballscrew.mcl", "--machine", "cell.toml", "--format", "json")
    assert json.loads(ran.out)["moves"][0]["start_time"] == pytest.approx(8e-3)
    override = ("--set", "controller.instruction_time=1e-6")
    ran = cell("run", "ballscrew.mcl", "--machine", "cell.toml", *override, "--format", "json")
    assert json.loads(ran.out)["moves"][0]["start_time"] == pytest.approx(8e-6)


def test_a_picture_shows_the_requested_window(cell: Cell) -> None:
    plot = ("plot", "ballscrew.mcl", "x.svg")
    assert cell(*plot, "--from", "0.2", "--to", "0.5", "--axes", "1").err == ""
    assert "the run ended after 1.0" in cell(*plot, "--from", "7").err
    assert "axis 3 did not move in this run: 1 did" in cell(*plot, "--axes", "3").err
    assert "axis 2 did not move in this run: 1 did" in cell(*plot, "--path", "1,2").err


def test_a_page_and_an_svg_need_no_matplotlib(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("matplotlib", "pyarrow"):
        monkeypatch.setitem(sys.modules, name, None)
    assert cell("plot", "ballscrew.mcl", "x.html").err == ""
    assert cell("plot", "ballscrew.mcl", "x.svg").err == ""
    assert "MR" in (cell.folder / "x.html").read_text(encoding="utf-8")
    for verb, file, extra in (("plot", "x.png", "plot"), ("trace", "x.parquet", "parquet")):
        ran = cell(verb, "ballscrew.mcl", file)
        assert ran.status == 1
        assert f'python -m pip install "motionlang[{extra}]"' in ran.err


@cases(
    "line, message",
    [
        (
            "trace OUT.csv --rate nan",
            "argument --rate: 'nan' is not a rate above 0 and up to 10,000,000 samples per second",
        ),
        ("trace OUT.txt", "OUT writes .csv, .npz and .parquet, not .txt files"),
        ("plot OUT.html --from 1 --to 1", "--to must be after --from"),
        ("plot OUT.html --path 0", "argument --path: '0' is not a path: give two or three axes, such as 0,1"),
        ("plot OUT.svg --path 0,1,2", "--path draws three axes in an .html page only"),
        ("plot OUT", "OUT writes .png, .svg and .html, so the file needs one of these extensions"),
        (
            "run --realtime 0",
            "argument --realtime: '0' is not a factor above 0: --realtime 10 is ten times as fast",
        ),
        ("run --rate 5", "unrecognized arguments: --rate 5"),
    ],
)
def test_a_wrong_command_line_is_2(line: str, message: str, cell: Cell) -> None:
    verb, *options = line.split()
    ran = cell(verb, "ballscrew.mcl", *options)
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.splitlines()[0] == f"motionlang {verb}: error: {message}"


def test_a_typing_error_is_answered_with_a_suggestion(cell: Cell) -> None:
    assert cell("rnu", "x").err == "motionlang: error: there is no command rnu\n  hint: did you mean run?\n"
    assert cell("pick.mnt").err.splitlines()[-1] == "  hint: motionlang run pick.mnt runs a program"
    report = cell("run", "x", "--format", "jsn").err
    assert report == (
        "motionlang run: error: argument --format: 'jsn' is not one of text, json, csv, none\n"
        "  hint: did you mean json?\n"
    )
    for option, suggestion in (
        ("--alow", "--allow"),
        ("--json", "--format json"),
    ):
        assert cell("run", "x", option).err.splitlines()[-1] == f"  hint: did you mean {suggestion}?"
    set_key = cell("run", "ballscrew.mcl", "--set", "controller.axs=4").err
    assert "there is no key controller.axs; did you mean controller.axes?" in set_key


def test_a_path_that_cannot_be_written_is_known_before_the_run(cell: Cell) -> None:
    ran = cell("trace", "ballscrew.mcl", "no/x.csv", "--format", "text")
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.startswith("motionlang trace: error: there is no folder no\n")


def test_a_full_disk_ends_in_a_diagnostic(cell: Cell) -> None:
    (cell.folder / "full.csv").symlink_to("/dev/full")
    ran = cell("trace", "ballscrew.mcl", "full.csv")
    assert ran.status == 1
    assert ran.err == "error[file]: full.csv cannot be written: no space left on device\n"


def test_realtime_waits_as_long_as_the_machine_takes(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """Only sleeping advances the clock; 1 s at twice real time is a sleep of 0.5 s."""
    clock = [100.0]
    monkeypatch.setattr(simulated, "monotonic", lambda: clock[0])
    monkeypatch.setattr(simulated, "sleep", lambda seconds: clock.__setitem__(0, clock[0] + seconds))
    ran = cell("run", "ballscrew.mcl", "--realtime", "2", "--format", "none")
    assert (ran.status, ran.out) == (0, "01 200.000000\n")
    assert clock[0] - 100.0 == pytest.approx(0.5, abs=1e-3)


def test_ctrl_c_reports_what_ran_so_far(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(seconds: float) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(simulated, "sleep", interrupted)
    ran = cell("run", "ballscrew.mcl", "--realtime", "--format", "json")
    report = json.loads(ran.out)
    assert (ran.status, report["status"]) == (130, "interrupted")
    assert report["moves"][0]["ended"] == "end-of-run"
    assert ran.err.startswith("error[interrupted]: the run was ended from the keyboard")


def test_a_terminal_without_lines_gets_a_plain_table(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    out = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    monkeypatch.setattr(sys, "stdout", out)
    assert cell("run", "ballscrew.mcl").status == 0
    out.seek(0)
    text = out.read()
    assert "ballscrew.mcl - MCCL - ended after" in text
    assert "      | accel " in text


def test_paths_are_shown_as_they_were_given(cell: Cell) -> None:
    Path("cell").mkdir()
    Path("cell/x.mcl").write_text("XX\n")
    assert " --> cell/x.mcl:1:1\n" in cell("run", "cell/x.mcl").err


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_is_listed_and_explained(cell: Cell, command: str) -> None:
    assert re.search(rf"\n  {command}\s", cell("--help").out)
    shown = cell(command, "--help").out
    assert shown.startswith(f"usage: motionlang {command} ")


@pytest.mark.parametrize("value", ["9" * 5000, "[" * 3000, "0x" + "f" * 5000])
def test_a_setting_of_any_length_is_reported(cell: Cell, value: str) -> None:
    ran = cell("run", "ballscrew.mcl", "--set", f"controller.axes={value}")
    assert ran.status in (1, 2)
    assert "controller.axes must be " in ran.err
    assert len(ran.err) < 500


def test_more_than_a_page_takes_is_reported(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("motionlang.commands.scope.MAX_RECORDS", 1)
    ran = cell("plot", "ballscrew.mcl", "a.html", "--format", "text")
    assert ran.status == 1
    assert "a.html was not written: the run has 2 records, but a page holds at most 1; " in ran.err
    assert not (cell.folder / "a.html").exists()
