"""Plain `run` lines are read without argparse, and mean the same."""

from __future__ import annotations

import itertools
import subprocess
import sys
from pathlib import Path

import pytest

from motionlang.cli import quick_options
from motionlang.cli.commands import build_parser
from motionlang.cli.run_options import run_options
from tests.cases import cases

PARTS = (
    ("pick.mnt",),
    ("--no-cache",),
    ("--report", "json"),
    ("--report", "none"),
    ("--dialect", "mccl"),
    ("-",),
)
LINES = [
    ["run", *itertools.chain.from_iterable(chosen)]
    for count in range(1, 4)
    for chosen in itertools.permutations(PARTS, count)
]


@cases("line", LINES, ids=" ".join)
def test_both_ways_to_read_a_line_agree(line: list[str]) -> None:
    quick = quick_options(line)
    parser = build_parser("run")
    try:
        arguments = parser.parse_args(line)
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
        ["run", "x.mnt", "--report"],
        ["run", "x.mnt", "--report", "yaml"],
        ["run", "x.mnt", "--dialect", "basic"],
        ["run", "x.mnt", "y.mnt"],
        ["run", "x.mnt", "--report=json"],
        ["run", "--", "x.mnt"],
    ],
    ids=" ".join,
)
def test_everything_else_is_left_to_argparse(line: list[str]) -> None:
    assert quick_options(line) is None


@pytest.mark.parametrize(
    ("name", "text", "needed"),
    [("hello.mnt", "PRINT 1\n", []), ("hello.mcl", "1MN,1TP\n", ["enum", "re"])],
)
def test_a_plain_run_imports_nothing_slow(tmp_path: Path, name: str, text: str, needed: list[str]) -> None:
    """First sight may compile; the second run imports nothing that costs milliseconds but the patterns of MCCL."""
    program = tmp_path / name
    program.write_text(text)
    script = (
        "import sys; from motionlang.cli import main; code = main(sys.argv[1:]); "
        "slow = {'argparse', 'json', 'numpy', 'lark', 'rich', 'dataclasses', 're', 'typing', 'enum', 'pathlib'}; "
        "print(code, sorted(slow & set(sys.modules)))"
    )
    command = [sys.executable, "-S", "-c", script, "run", str(program), "--report", "none"]
    for _ in range(2):
        ran = subprocess.run(command, capture_output=True, text=True, check=True, cwd=".")
    assert ran.stdout.splitlines()[-1] == f"0 {needed}"
