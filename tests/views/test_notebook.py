"""Drawings and tables of a notebook."""

from __future__ import annotations

import re

import pytest

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
