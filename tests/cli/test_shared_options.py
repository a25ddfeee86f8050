"""An option that several commands have does the same in each of them."""

from __future__ import annotations

import json
import re

import pytest

from tests.cases import cases
from tests.cli.programs import ALL, Cell
from tests.extras import INSTALLED

MOVE = "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n"
# Each command, with what it needs.
LINES: dict[str, str] = {
    **dict.fromkeys(("run", "profile", "certify", "check", "verify", "repl"), "a.mnt"),
    "trace": "a.mnt out.csv",
    "plot": "a.mnt out.html",
    "diff": "a.mnt a.mnt",
    "compare": "a.mnt a.csv --map position.0=p",
    "sweep": "a.mnt --vary rate=1,2 --keep time --jobs 1",
    "plan": "--distance 20 --time 0.6 --rule third",
    "help": "SPEED",
    "pvt plot": "--scurve 1000 --time 100",
    "pvt refine": "--positions=0,200,900,500 --time 20",
    "pvt export": "--scurve 1000 --time 100",
    "servo compare": "--speed 100 --accel 1000 --distance 50",
    "servo step": "",
    "servo tune": "",
    "servo run": "a.mnt",
    "serve": "a.mnt --tcp 127.0.0.1:0",
}
EXTRAS = {
    "explore": {**dict.fromkeys(("init", "cover", "panel", "map"), "a.mnt"), "improve": "c.mnt"},
    "copley": {"copley serve": "virtual:x", "copley stream": "--scurve 1000 --time 100"},
    "mcapi": {"mcapi run": "a.mnt", "mcapi serve": "--port 0", "mcapi replay": "a.log"},
}
LINES |= {command: line for each in INSTALLED for command, line in EXTRAS.get(each.name, {}).items()}
# A wrong value of an option, and what every command says to it.
WRONG = (
    ("--format x", "argument --format: 'x' is not one of "),
    ("--lang basic", ": 'basic' is not one of "),
    ("--jobs 0", "argument -j/--jobs: '0' is not a "),
    ("--until x", "argument --until: 'x' is not a time in seconds, 0 or more"),
    ("--until=-1", "argument --until: '-1' is not a time in seconds, 0 or more"),
    ("--until inf", "argument --until: 'inf' is not a time in seconds, 0 or more"),
    (
        "--input=2=5",
        'error[option]: "5" is not a level of input 2: 0 or 1\n  hint: write 2=1@0.5, 2=1@0.5..0.9',
    ),
    ("--input=door=1", "error[option]: the machine file names no input door\n  hint: write its number"),
    ("--keys=R@x", 'error[option]: "x" is not a time\n  hint: write R@0.5'),
    ("--set x", "--set needs NAME=VALUE, not 'x'"),
    ("--set axis.0.nothing=0", "there is no key axis.0.nothing"),
    ("--machine none.toml", "error[file]: none.toml cannot be read: no such file or directory"),
    ("--machine wrong.toml", " --> wrong.toml:2:1\n"),
    ("--output missing/out.txt", "missing/out.txt cannot be written: no such file or directory"),
    ("--no-such-option", "unrecognized arguments: --no-such-option"),
)


def having(option: str) -> list[str]:
    """Return the commands that have an option."""
    return [each.prog.removeprefix("motionlang ") for each in ALL if option in each._option_string_actions]


@pytest.fixture
def program(cell: Cell) -> Cell:
    cell.write("a.mnt", "Dim rate = 1\nSPEED(0) = rate\n" + MOVE)
    cell.write("a.csv", "time,p\n" + "".join(f"{time},{min(time, 5)}\n" for time in range(8)))
    cell.write("a.log", "")
    cell.write("c.mnt", "SPEED(0) = 50\n" + MOVE)
    cell.write("c.machine.toml", "[axis.0.limits]\nspeed = 200.0\n")
    cell.write("wrong.toml", "[controller]\naxs = 2\n")
    return cell


@cases("given, message", WRONG)
def test_a_wrong_value_gets_one_answer(given: str, message: str, program: Cell) -> None:
    option = re.split("[ =]", given)[0]
    commands = having(option) or list(LINES)
    assert len(commands) > 1
    for command in commands:
        ran = program(*command.split(), *LINES[command].split(), *given.split())
        shown = ran.out + ran.err
        assert (ran.status in (1, 2), message in shown) == (True, True), (command, ran.status, shown[-300:])


@cases(
    "file, message",
    [
        ("none.mnt", "error[file]: none.mnt cannot be read: no such file or directory\n"),
        ("drive.mnt", "error[file]: drive.mnt cannot be read: not a text file: line 1 has a zero byte\n"),
        ("a.txt", "error[file]: unknown language of a.txt: no language has the extension .txt\n"),
    ],
)
def test_a_program_that_cannot_be_read_gets_one_answer(file: str, message: str, program: Cell) -> None:
    program.write("a.txt", MOVE)
    program.write("drive.mnt", b"MZ\x90\0\3\0\0\0" * 500)
    for command, line in LINES.items():
        if line.startswith("a.mnt") and command not in ("repl", "verify", "serve", "mcapi run"):
            ran = program(*command.split(), *line.replace("a.mnt", file, 1).split())
            shown = ran.out + ran.err
            assert (ran.status in (1, 2), message in shown) == (True, True), (
                command,
                ran.status,
                shown[-300:],
            )


@pytest.mark.parametrize("command", having("--output"))
def test_o_writes_what_is_printed_into_a_file(command: str, program: Cell) -> None:
    line = [*command.split(), *LINES[command].split()]
    # init has no document, and the forms of pvt export are those of drives
    for form in (
        ([],) if command in ("init", "pvt export") else ([], ["--format", "json"], ["--format", "csv"])
    ):
        # a file without a form gets the report, which trace and plot print on request
        asked = ["--format", "text"] if command in ("trace", "plot") and not form else form
        printed = program(*line, *asked)
        (program.folder / "a.machine.toml").unlink(missing_ok=True)  # which `init` writes
        written = program(*line, *form, "-o", "out.txt")
        (program.folder / "a.machine.toml").unlink(missing_ok=True)
        assert (written.status, written.out, written.err) == (printed.status, "", printed.err), command
        text = (program.folder / "out.txt").read_text(encoding="utf-8")
        assert text == printed.out, command
        assert form != ["--format", "json"] or json.loads(text)["schema"].startswith("motionlang"), command


@pytest.mark.parametrize("command", having("--output"))
def test_a_quiet_file_is_that_of_the_command_without_q(command: str, program: Cell) -> None:
    found = []
    for quiet in ([], ["-q"]):
        ran = program(*command.split(), *LINES[command].split(), "-o", "report.csv", *quiet)
        (program.folder / "a.machine.toml").unlink(missing_ok=True)  # which `init` writes
        assert ran.out == ""
        found.append((program.folder / "report.csv").read_text())
    assert found[0] == found[1] != "", command
