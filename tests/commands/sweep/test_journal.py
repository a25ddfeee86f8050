"""The file of a sweep: the rows that are written, and those that are read again."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.commands.sweep.journal import SCHEMA, Journal, OtherSweep, read

HEAD = f'{{"schema": {SCHEMA!r}, "digest": "abc"}}\n'.replace("'", '"')


def journal(folder: Path, *, resume: bool) -> Journal:
    return Journal(str(folder / "rows"), "abc", resume=resume)


def test_a_row_is_a_line(tmp_path: Path) -> None:
    made = journal(tmp_path, resume=False)
    made.add((3, (1.5, None), None))
    made.add((1, ("é",), None))
    made.close()
    assert (tmp_path / "rows").read_text() == HEAD + '[3, [1.5, null], null]\n[1, ["\\u00e9"], null]\n'
    assert list(read(made.path, "abc")) == [(3, (1.5, None), None), (1, ("é",), None)]


@pytest.mark.parametrize("resume", [False, True])
def test_a_truncated_row_is_lost_only_if_the_sweep_continues(resume: bool, tmp_path: Path) -> None:
    """A sweep that starts again has none of the earlier rows."""
    (tmp_path / "rows").write_text(f"{HEAD}[0, [7], null]\n[1, [8")
    made = journal(tmp_path, resume=resume)
    made.add((2, (9,), None))
    made.close()
    earlier = [(0, (7,), None)] if resume else []
    assert list(read(made.path, "abc")) == [*earlier, (2, (9,), None)]


def test_a_sweep_that_continues_without_a_file_begins_one(tmp_path: Path) -> None:
    assert list(read(str(tmp_path / "rows"), "abc")) == []
    made = journal(tmp_path, resume=True)
    made.close()
    assert (tmp_path / "rows").read_text() == HEAD
    made = journal(tmp_path, resume=True)
    made.remove()
    assert list(tmp_path.iterdir()) == []


def test_lines_that_are_no_rows_are_ignored(tmp_path: Path) -> None:
    lines = [
        "7",
        "",
        "[0, [1]]",
        "[0, [1], null, 2]",
        '["0", [1], null]',
        "[0, 1, null]",
        "{}",
        "[[[",
        "[4, [], null]",
    ]
    (tmp_path / "rows").write_text(HEAD + "\n".join(lines))
    assert list(read(str(tmp_path / "rows"), "abc")) == [(4, (), None)]


@pytest.mark.parametrize(
    "head", [HEAD.replace("abc", "abd"), HEAD.replace("schema", "scheme"), "[]\n", "", '{"digest": "abc"}\n']
)
def test_the_file_of_another_sweep_is_refused(head: str, tmp_path: Path) -> None:
    (tmp_path / "rows").write_text(f"{head}[0, [7], null]\n")
    with pytest.raises(OtherSweep):
        list(read(str(tmp_path / "rows"), "abc"))
