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


@pytest.mark.parametrize(
    ("name", "text", "options"),
    [
        ("hello.mnt", "PRINT 1\n", ("--format", "none")),
        ("hello.mcl", "1MN,1TP\n", ("--format", "none")),
        ("hello.mnt", "MOVER(0) = 1 : GO(0)\nPAUSE IDLE(0)\n", ("--profile",)),
    ],
)
def test_a_plain_run_imports_no_large_library_but_the_parser(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, text: str, options: tuple[str, ...]
) -> None:
    program = tmp_path / name
    program.write_text(text)
    script = (
        "import sys; from motionlang.cli import main; code = main(sys.argv[1:]); "
        "slow = {'argparse', 'lark', 'numpy', 'rich', 'tomllib'}; "
        "print(code, sorted(slow & set(sys.modules)))"
    )
    command = [sys.executable, "-S", "-c", script, "run", str(program), *options]
    monkeypatch.setenv("PYTHONPATH", str(Path(lark.__file__).parents[1]))
    shown = subprocess.run(command, capture_output=True, text=True, check=True, cwd=".").stdout
    assert shown.splitlines()[-1] == "0 ['lark']"
