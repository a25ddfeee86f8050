"""Every program of this folder shows what is written beside it. `--update` rewrites it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.spec.cases import Case, cases, differences, files, read_line, updated

CASES = [case for path in files() for case in cases(path)]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_a_program_shows_what_is_written_beside_it(
    case: Case, update: bool, golden: Callable[[Path, str], None]
) -> None:
    if update:
        golden(case.path, updated(case.path))
        return
    wrong = differences(case)
    assert not wrong, "\n".join([case.name, *wrong])


def test_an_unknown_mark_is_an_error() -> None:
    with pytest.raises(ValueError, match="'~ is no mark"):
        read_line(1, "'~ PRINT 1", "'")


def test_a_wrong_result_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One line of each kind, each other than what the program shows."""
    monkeypatch.setattr("tests.spec.cases.FOLDER", tmp_path)
    path = tmp_path / "a.mnt"
    path.write_text("PRINT 1\nWAIT 5\n'> 2\nSPED = 1\n'? 2 range\n")
    (case,) = cases(path)
    assert [each[:1] for each in differences(case)] == [">", "?"]
    path.write_text("PRINT 1\nWAIT 5\n'> 1\n'# ended 0.5 s\nSTOP(0)\n'= stop axis 3\n'! nothing\n")
    (case,) = cases(path)
    assert [each[:1] for each in differences(case)] == ["!", "=", "#"]
