"""Derived files are current, and the documented recipes for adding a keyword and a command work with made-up ones."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from itertools import chain
from pathlib import Path

import pytest

from tests.built import copy_with_bytecode
from tests.extras import ABSENT
from tools.derived import GROUPS, derived

ROOT = Path(__file__).parent.parent
# The writer of the most pages.
SLOW = "tools.keyword_pages:mint"
# The files that the recipe touches, and that the writers read.
COPIED = ("motionlang", "grammars", "docs", "playground", "tests", "tools")
# The files of a command, without their folder.
LONGEST = {
    "__init__.py": """\
\"\"\"The move of a run that takes longest.\"\"\"

from __future__ import annotations

from motionlang.kernel import Move, Run


def longest(run: Run) -> Move | None:
    \"\"\"Return the first of the moves that take longest, or None.\"\"\"
    return max(run.moves, key=lambda move: move.duration, default=None)
""",
    "view.py": """\
\"\"\"The longest move in words.\"\"\"

from __future__ import annotations

from motionlang.kernel import Move


def longest_line(move: Move | None) -> str:
    return "no move" if move is None else f"line {move.line}: {move.duration:.3f} s"
""",
    "command.py": """\
\"\"\"`motionlang longest`: the move of a run that takes longest.\"\"\"

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.run_command import Simulated
from motionlang.commands.longest import longest
from motionlang.commands.longest.view import longest_line
from motionlang.kernel import Run


@dataclass
class Longest(Simulated):
    \"\"\"Name the move that takes longest.\"\"\"

    title: ClassVar[str] = "longest"

    def conclusion(self, result: Run, *, width: int, colour: bool) -> str:
        return f"{longest_line(longest(result))}\\n"
""",
}


@pytest.mark.parametrize(
    "writer",
    [pytest.param(each, marks=pytest.mark.slow) if each == SLOW else each for each in chain(*GROUPS)],
)
def test_derived_files_are_current(writer: str) -> None:
    for path, text in derived(writer).items():
        stored = path.read_text(encoding="utf-8") if path.exists() else None
        assert stored == text, "python -m tools.derived writes it"


def insert(path: Path, before: str, text: str) -> None:
    """Insert `text` before the last occurrence of `before` in a file."""
    head, found, tail = path.read_text(encoding="utf-8").rpartition(before)
    assert found
    path.write_text(f"{head}{text}{found}{tail}", encoding="utf-8")


def python(folder: Path, *arguments: str) -> str:
    """Return the output of Python, run in a folder so that it imports its package."""
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the project in which keywords and a command were added by the recipes."""
    folder = tmp_path_factory.mktemp("recipe")
    for name in COPIED:
        copy_with_bytecode(ROOT / name, folder / name, "golden", "node_modules", "dist")
    for name in ("mkdocs.yml", "pyproject.toml"):
        shutil.copy(ROOT / name, folder)
    mint, mccl = folder / "motionlang/kernel/mint/keywords", folder / "motionlang/kernel/mccl/keywords"
    row = (
        '    Keyword("HALFWAY", "HFW", "reading", "R", "axis", "uu", Actions(read=of(Environment, halfway)),\n'
        '            "Half of the position.", "POS(0) = 5\\nPRINT HALFWAY(0)", changes="motion"),\n'
    )
    does = (
        "def halfway(environment: Environment, axis: int) -> float:\n"
        "    counts = environment.controller.position(axis) / 2\n"
        "    return scale_of(environment, axis).position_to_user(counts)\n"
        "\n\n"
    )
    insert(mint / "state.py", "def wrapped_position(", does)
    insert(mint / "state.py", ")  # fmt: skip", row)
    insert(
        mint / "state.py",
        "\nfrom motionlang.kernel.mint.runtime.",
        "\nfrom motionlang.kernel.mint.runtime.binding import of",
    )
    row = '    _row("HY", "reading", "R", "none", "number", tell_half, "Tell a half.", "HY"),\n'
    does = 'def tell_half(task: CommandTask, command: Command) -> None:\n    task.reply("0.5")\n\n\n'
    insert(mccl / "reports.py", "# ---", does)
    insert(mccl / "reports.py", ")  # fmt: skip", row)
    for language, word, facts in (
        ("mint", "HALFWAY", "meaning short index unit"),
        ("mccl", "HY", "meaning unit"),
    ):
        with (folder / f"motionlang/commands/evidence/{language}/facts.txt").open(
            "a", encoding="utf-8"
        ) as evidence:
            evidence.write(f"\n{facts} · memory high · made up\n  {word}\n")
    add_command(folder)
    python(folder, "-m", "tools.derived")
    return folder


def add_command(folder: Path) -> None:
    """Add a command by the recipe: its folder, its page, and three rows."""
    for name, text in LONGEST.items():
        path = folder / "motionlang/commands/longest" / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    row = '        "longest": ("commands.longest.command:Longest", "name the move that takes longest"),\n'
    insert(folder / "motionlang/cli/commands.py", '        "certify": (', row)
    insert(folder / "pyproject.toml", " | plan | profile", " | longest")
    insert(folder / "mkdocs.yml", "          - certify:", "          - longest: commands/longest.md\n")
    page = (
        "# longest\n\n`motionlang longest FILE` names one move.\n\n<!-- options: longest -->\n<!-- end -->\n"
    )
    (folder / "docs/commands/longest.md").write_text(page, encoding="utf-8")


@pytest.mark.parametrize(
    ("name", "text", "shown"),
    [("a.mnt", "POS(0) = 5\nPRINT HFW(0)\n", "2.5000"), ("a.mcl", "HY\n", "0.5")],
)
def test_a_word_added_by_the_recipe_runs(copy: Path, name: str, text: str, shown: str) -> None:
    (copy / name).write_text(text, encoding="utf-8")
    assert python(copy, "-m", "motionlang", "run", name, "--format", "none").split() == [shown]


@pytest.mark.parametrize("word", ["HALFWAY", "HY"])
def test_a_word_added_by_the_recipe_is_explained(copy: Path, word: str) -> None:
    pages = (copy / "docs/keywords" / ("mccl" if word == "HY" else "mint")).glob("*.md")
    assert len([page for page in pages if f"## {word}\n" in page.read_text(encoding="utf-8")]) == 1
    assert "known from  made up (from memory" in python(copy, "-m", "motionlang", "help", word)


def test_the_linter_knows_it_by_its_row(copy: Path) -> None:
    (copy / "wait.mnt").write_text("PAUSE HALFWAY(0) > 1\n", encoding="utf-8")
    result = subprocess.run(
        [sys.executable, "-m", "motionlang", "check", "wait.mnt"],
        cwd=copy,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    assert "endless-wait" in result.stdout + result.stderr


def test_a_command_added_by_the_recipe_runs(copy: Path) -> None:
    (copy / "move.mnt").write_text("MOVER(0) = 5\nGO(0)\nPAUSE IDLE(0)\n", encoding="utf-8")
    line = python(copy, "-m", "motionlang", "longest", "move.mnt", "--format", "none")
    assert re.fullmatch(r"line [12]: \d\.\d{3} s\n", line)


def test_a_command_added_by_the_recipe_is_listed_with_its_options(copy: Path) -> None:
    assert "longest     name the move that takes longest" in python(copy, "-m", "motionlang", "--help")
    folder = copy / "docs/commands"
    assert "| [`longest`](longest.md) | name the move" in (folder / "README.md").read_text(encoding="utf-8")
    assert "| `--until S` | end the run" in (folder / "longest.md").read_text(encoding="utf-8")


@pytest.mark.slow
@pytest.mark.skipif(bool(ABSENT), reason="the contracts are those of all distributions")
def test_a_command_added_by_the_recipe_keeps_the_contracts(copy: Path) -> None:
    run = "from importlinter.cli import lint_imports as run; exit(run(no_cache=True, no_logo=True))"
    assert " 0 broken." in python(copy, "-c", run)
