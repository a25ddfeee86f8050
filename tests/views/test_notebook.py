"""Drawings and tables of a notebook, and cells of a sweep, by hand."""

from __future__ import annotations

import re

import pytest

from motionlang.commands.sweep.table import cell, sweep_table
from motionlang.kernel import Source, run
from motionlang.views.notebook import MAX_LINES, MOST_MOVES, html


def test_a_move_of_a_notebook_has_its_own_times() -> None:
    """The move begins 1 s after the start, to 100 at 50 uu/s with 500 uu/s²."""
    made = run(
        Source(
            "a.mnt", "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500\nWAIT = 1000\nMOVER(0) = 100 : GO(0)\n"
        ),
    )
    (move,) = made.moves
    drawing = move._repr_html_()
    texts = re.findall(r"<text[^>]*>([^<]*)</text>", drawing)
    assert texts[0] == "axis 0"
    assert {"velocity", "(uu/s)", "time (s)", "50"} <= set(texts)


def test_a_table_of_moves_has_a_largest_length() -> None:
    for count, more in (
        (MOST_MOVES, ""),
        (MOST_MOVES + 1, "<p>… 1 more move</p>"),
        (MOST_MOVES + 2, "<p>… 2 more moves</p>"),
    ):
        text = f"Dim k As Integer\nFor k = 1 To {count}\nMOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\nNext\n"
        found = run(Source("a.mnt", text)).moves._repr_html_()
        assert found.count("<tr>") == MOST_MOVES + 1
        assert ("<p>" in found) == bool(more)
        assert more in found


@pytest.mark.parametrize("count", [MAX_LINES, MAX_LINES + 1])
def test_output_of_many_lines_is_shortened_in_the_middle(count: int) -> None:
    text = f"Dim k As Integer\nFor k = 1 To {count}\nPrint k\nNext\n"
    lines = html(run(Source("a.mnt", text))).partition("</pre>")[0].removeprefix("<pre>").split("\n")
    half = MAX_LINES // 2
    if count == MAX_LINES:
        assert len(lines) == MAX_LINES
    else:
        assert lines[half] == "… 1 lines …"
        assert len(lines) == MAX_LINES + 1


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (True, "true"),
        (False, "false"),
        (12, "12"),
        (1 / 3, "0.333333"),
        ("a\nb", "a · b"),
        ("x" * 40, "x" * 40),
        ("x" * 41, "x" * 39 + "…"),
    ],
)
def test_a_cell_of_a_sweep(value: object, text: str) -> None:
    assert cell(value) == text


def test_a_narrow_sweep_drops_its_last_columns() -> None:
    """The first two are always shown; texts are on the left, numbers on the right."""
    units = {"n": "", "name": "", "time": "s", "peak": "uu/s"}
    found = [[1, "x", 2.5, 3], [10, "yy", 2, 4]]
    table = sweep_table(units, [dict(zip(units, row, strict=True)) for row in found])
    wide = table.lines(80)
    assert [line.split() for line in wide[-2:]] == [["1", "x", "2.5", "3"], ["10", "yy", "2", "4"]]
    assert wide[-2].startswith(" 1  x ")
    assert wide[-1].startswith("10  yy")
    full = max(map(len, wide))
    for width, shown in ((full, 4), (full - 1, 3), (5, 2)):
        assert len(table.lines(width)[-1].split()) == shown
