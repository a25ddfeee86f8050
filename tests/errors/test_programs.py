"""Invalid programs of `mint`, each with its output up to the error and all its messages in a `.txt`.

`pytest --update` rewrites the texts.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang import run
from motionlang.kernel import Source
from motionlang.views.diagnostics import render

PROGRAMS = sorted(Path(__file__).parent.glob("mint/*.mnt"))


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_the_message_teaches(path: Path, golden: Callable[[Path, str], None]) -> None:
    source = Source.read(path)
    result = run(source)
    shown = [f"{line}\n" for line in result.output]
    golden(path.with_suffix(".txt"), "".join(shown + [render(each, source) for each in result.diagnostics]))


def test_a_hundred_warnings_hide_no_error() -> None:
    text = "AUTOTUNE(0, 1)\n" * 150 + 'SPEED(0) = "fast"\n'
    found = run(Source("a.mnt", text)).diagnostics
    assert [(each.code, each.line) for each in found if each.severity == "error"] == [("type", 151)]


def test_of_many_errors_a_hundred_are_reported() -> None:
    found = run(Source("a.mnt", 'SPEED(0) = "fast"\n' * 120)).diagnostics
    assert [(each.code, each.line) for each in found] == [("type", line) for line in range(1, 101)]
