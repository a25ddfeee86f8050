"""The grammars are the only source of the syntax.

The package follows a changed grammar once its tables are written. Each experiment changes a grammar in a copy
of the package, writes the tables and runs a program.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.built import copy_with_bytecode

ROOT = Path(__file__).parents[3]
# Runs the command line, for a package that is not installed.
Product = Callable[..., "subprocess.CompletedProcess[str]"]
MOTION = "1MN,1SV1000,1SA1000,1DS1000\n"


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the package and the grammars."""
    folder = tmp_path_factory.mktemp("copy")
    for name in ("motionlang", "grammars"):
        copy_with_bytecode(ROOT / name, folder / name)
    return folder


@pytest.fixture
def product(copy: Path, tmp_path: Path) -> Product:
    """Return a function that changes a grammar and then runs a program with it.

    It replaces texts of the grammar, and writes the tables and the program first.
    """

    def start(grammar: str, changes: dict[str, str], name: str, program: str, *words: str) -> object:
        path, text = copy / "grammars" / grammar, (ROOT / "grammars" / grammar).read_text(encoding="utf-8")
        for before, after in changes.items():
            assert before in text
            text = text.replace(before, after)
        path.write_text(text, encoding="utf-8")
        file = tmp_path / name
        file.write_text(program, encoding="utf-8")
        environment = {**os.environ, "PYTHONPATH": str(copy)}
        generate = [sys.executable, "-m", "motionlang.lang.parsing.generate"]
        subprocess.run(generate, cwd=tmp_path, env=environment, check=True)
        command = [sys.executable, "-m", "motionlang", *(words or ("run",)), str(file)]
        try:
            return subprocess.run(
                command, cwd=tmp_path, env=environment, check=False, text=True, capture_output=True
            )
        finally:
            path.write_text((ROOT / "grammars" / grammar).read_text(encoding="utf-8"), encoding="utf-8")

    return start  # type: ignore[return-value]


@pytest.mark.slow
def test_a_further_separator_of_mccl(product: Product) -> None:
    """`|` becomes a separator, and ends a parameter."""
    changes = {"/[, \\t]/": "/[, \\t|]/", "[, \\t\\n;]|$": "[, \\t\\n;|]|$"}
    program = f'{MOTION}1MR100|1WS0|1TP,OT"a|b" ; x|y\n'
    ran = product("mccl.lark", changes, "a.mcl", program)
    assert (ran.returncode, ran.stdout.splitlines()[:2]) == (0, ["01 100", "a|b"])


def test_another_comment_sign_of_mccl(product: Product) -> None:
    """`//` begins a comment; a single `/` does not end a command."""
    changes = {"REMARK: /;[^": "REMARK: /\\/\\/[^", "[, \\t\\n;]|$": "[, \\t\\n]|\\/\\/|$"}
    program = f'{MOTION}1MR50,1WS0.1//1MR50;\n// lint: ignore\n1MR5//,"\n1WS0,1TP,OT"a//b"//\n1XX/\n'
    ran = product("mccl.lark", changes, "a.mcl", program)
    assert ran.stdout.splitlines()[:3] == ["01 55", "a//b", "?1"]
    assert ran.returncode == 1  # 1XX/ is one command, which the board does not know


def test_a_mistake_is_found_with_the_changed_grammar(product: Product) -> None:
    changes = {"/[, \\t]/": "/[, \\t|]/", "[, \\t\\n;]|$": "[, \\t\\n;|]|$"}
    ran = product("mccl.lark", changes, "a.mcl", "1MN|1MR1x|1TP\n", "check")
    assert "a.mcl:1:5" in ran.stdout  # the command after the first |


def test_another_keyword_of_mint(product: Product) -> None:
    """WHILE is renamed to DURING, so that `while` is an ordinary name."""
    program = (
        "Dim while As Integer = 7\nDim i As Integer\nDuring i < 3\n  i = i + 1\nEnd During\nPRINT i, while\n"
    )
    ran = product("mint.lark", {'WHILE: "While"i': 'WHILE: "During"i'}, "a.mnt", program)
    assert (ran.returncode, ran.stdout.splitlines()[0]) == (0, "37")
