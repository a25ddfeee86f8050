"""Simple `run` command lines are parsed without argparse, with equal results."""

from __future__ import annotations

import itertools
import subprocess
import sys
from pathlib import Path

import pytest

from motionlang.cli import quick_options
from motionlang.cli.commands import build_parser
from motionlang.cli.run_options import check_options, run_options
from tests.cases import cases

ARGUMENTS = (
    ("pick.mnt",),
    ("--no-cache",),
    ("--profile",),
    ("--format", "json"),
    ("--format", "none"),
    ("--dialect", "mccl"),
    ("-",),
)
LINES = [
    ["run", *itertools.chain.from_iterable(chosen)]
    for count in range(1, 4)
    for chosen in itertools.permutations(ARGUMENTS, count)
]


@cases("line", LINES, ids=" ".join)
def test_both_ways_to_read_a_line_agree(line: list[str]) -> None:
    quick = quick_options(line)
    parser = build_parser("run")
    try:
        arguments = parser.parse_args(line)
        check_options(arguments, arguments.parser)
    except SystemExit:
        assert quick is None
    else:
        assert quick == run_options(arguments, arguments.parser)


@pytest.mark.parametrize(
    "line",
    [
        [],
        ["run"],
        ["check", "x.mnt"],
        ["run", "--help"],
        ["run", "x.mnt", "--until", "3"],
        ["run", "x.mnt", "--format"],
        ["run", "x.mnt", "--format", "yaml"],
        ["run", "x.mnt", "--dialect", "basic"],
        ["run", "x.mnt", "y.mnt"],
        ["run", "x.mnt", "--format=json"],
        ["run", "--", "x.mnt"],
    ],
    ids=" ".join,
)
def test_everything_else_is_left_to_argparse(line: list[str]) -> None:
    assert quick_options(line) is None


# Reads the line of an error.
CAUGHT = "PRINT 1 / NVLONG(0)\nEvent ONERROR\n  PRINT ERRLINE\n  ERRORCLEAR(_egALL, 0)\nEnd Event\n"


@pytest.mark.parametrize(
    ("name", "text", "options", "needed"),
    [
        ("hello.mnt", "PRINT 1\n", ("--format", "none"), []),
        ("hello.mcl", "1MN,1TP\n", ("--format", "none"), ["re"]),
        ("hello.mnt", "MOVER(0) = 1 : GO(0)\nPAUSE IDLE(0)\n", ("--profile",), []),
        ("wired.mnt", "PAUSE INX(5)\nPRINT POS(0)\n", ("--format", "none"), []),
        ("caught.mnt", CAUGHT, ("--format", "none"), []),
    ],
)
def test_a_plain_run_imports_nothing_slow(
    tmp_path: Path, name: str, text: str, options: tuple[str, ...], needed: list[str]
) -> None:
    """The first run may compile; the second imports no module that takes milliseconds.

    MCCL's patterns are an exception. A profile takes lines and blocks from the compiled program, and parses
    nothing.
    """
    program = tmp_path / name
    program.write_text(text)
    if name == "wired.mnt":
        (tmp_path / "wired.machine.toml").write_text(
            "[axis.0]\nstart = 3.0\n[[input]]\nchannel = 5\nat = 0.5\n"
        )
    script = (
        "import sys; from motionlang.cli import main; code = main(sys.argv[1:]); "
        "slow = {'argparse', 'json', 'numpy', 'lark', 'rich', 'dataclasses', 're', 'typing', 'pathlib', "
        "'motionlang.mint.syntax.parser', 'tomllib', 'motionlang.lang.machine.file'}; "
        "print(code, sorted(slow & set(sys.modules)))"
    )
    command = [sys.executable, "-S", "-c", script, "run", str(program), *options]
    for _ in range(2):
        ran = subprocess.run(command, capture_output=True, text=True, check=True, cwd=".")
    assert ran.stdout.splitlines()[-1] == f"0 {needed}"
