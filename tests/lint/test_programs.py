"""Programs with every kind of lint message, and the complete output in a `.txt`.

A `.toml` next to a program is its machine file. `pytest --update` rewrites the texts.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang.commands.check import check
from motionlang.kernel import Source, dialect_of, read_machine
from motionlang.views.diagnostics import render

HERE = Path(__file__).parent
PROGRAMS = sorted([*HERE.glob("mint/*.mnt"), *HERE.glob("mccl/*.mcl")])
GALLERY = sorted([*HERE.parents[1].glob("scripts/mint/*.mnt"), *HERE.parents[1].glob("scripts/mccl/*.mcl")])


def diagnostics_of(path: Path) -> str:
    """Return all messages about a program, as they are displayed."""
    language, source = dialect_of(path.name), Source.read(path)
    assert language is not None
    machine = next((each for each in _machines(path) if each.exists()), None)
    settings = read_machine(Source.read(machine)) if machine is not None else {}
    return "".join(render(each, source) for each in check(language.program(source, settings)))


def _machines(path: Path) -> tuple[Path, ...]:
    return path.with_suffix(".toml"), path.with_suffix(".machine.toml")


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.name)
def test_the_diagnostics(path: Path, golden: Callable[[Path, str], None]) -> None:
    golden(path.with_suffix(".txt"), diagnostics_of(path))


@pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.name)
def test_no_program_of_the_gallery_gives_an_alarm(path: Path) -> None:
    assert diagnostics_of(path) == ""
