"""docs/contributing/one-statement.md shows the present output of every stage."""

from __future__ import annotations

from tools.stages_page import written


def test_the_figures_on_the_page_are_those_worked_out_by_hand() -> None:
    """The move takes 0.45 s.

    25 uu are 250 counts; 25 / 100 + 100 / 500 = 0.45 s. The move starts after five statements of 10 µs.
    """
    assert "load_by(0, 250.0, 'MOVER', 5)" in written()
    assert "from 0.00005 s, 0.45 s, 0 to 250 counts" in written()
