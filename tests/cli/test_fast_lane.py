"""Simple `run` command lines are parsed without argparse, with equal results."""

from __future__ import annotations

import itertools
import subprocess
import sys
from pathlib import Path

import lark
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

PARSER_OF_RUN = build_parser("run")


@cases("line", LINES, ids=" ".join)
def test_both_ways_to_read_a_line_agree(line: list[str]) -> None:
    quick = quick_options(line)
    try:
        arguments = PARSER_OF_RUN.parse_args(line)
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
READS = ["dataclasses", "lark", "re", "typing"]
PARSER, MACHINE_FILE = (
    ["dataclasses", "lark", "motionlang.mint.syntax.parser", "re", "typing"],
    ["motionlang.lang.machine.file", "tomllib"],
)


@pytest.mark.parametrize(
    ("name", "text", "options", "first", "second"),
    [
        ("hello.mnt", "PRINT 1\n", ("--format", "none"), PARSER, []),
        ("hello.mcl", "1MN,1TP\n", ("--format", "none"), READS, READS),
        ("hello.mnt", "MOVER(0) = 1 : GO(0)\nPAUSE IDLE(0)\n", ("--profile",), PARSER, []),
        ("wired.mnt", "PAUSE INX(5)\nPRINT POS(0)\n", ("--format", "none"), [*PARSER, *MACHINE_FILE], []),
        ("caught.mnt", CAUGHT, ("--format", "none"), PARSER, []),
    ],
)
def test_a_plain_run_imports_nothing_slow(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    name: str,
    text: str,
    options: tuple[str, ...],
    first: list[str],
    second: list[str],
) -> None:
    """The first run compiles; the second imports no module that takes milliseconds.

    MCCL, which is not compiled, is parsed in each run. A profile takes lines and blocks from the compiled program,
    and parses nothing.
    """
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "cache"))
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
    monkeypatch.setenv("PYTHONPATH", str(Path(lark.__file__).parents[1]))
    shown = [
        subprocess.run(command, capture_output=True, text=True, check=True, cwd=".").stdout for _ in range(2)
    ]
    assert [text.splitlines()[-1] for text in shown] == [f"0 {sorted(first)}", f"0 {second}"]
