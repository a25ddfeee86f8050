"""Points in CSV files: reading, writing, and all errors with their lines."""

from __future__ import annotations

import contextlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel import ProgramError, Source
from motionlang.lab.pvt.points import Point
from motionlang.lab.pvt.table import read_points, write_points

points = st.lists(
    st.builds(
        Point,
        st.integers(-(2**31), 2**31 - 1).map(float),
        st.one_of(st.none(), st.integers(-(2**31), 2**31 - 1).map(lambda v: v / 10)),
        st.integers(0, 255).map(lambda t: t / 1000),
        st.booleans(),
    ),
    min_size=1,
    max_size=20,
)


COLUMNS = "the columns are position, velocity, time, relative"


def read(text: str) -> list[Point]:
    return read_points(Source("points.csv", text)).points


@given(points)
def test_what_is_written_is_read_back(move: list[Point]) -> None:
    text = "\n".join(write_points(move))
    for found, expected in zip(read(text), move, strict=True):
        assert (found.position, found.velocity, found.relative) == (
            expected.position,
            expected.velocity,
            expected.relative,
        )
        assert found.time == pytest.approx(expected.time)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("position,velocity,time\n0,0,10\n5,,0\n", [Point(0, 0, 0.01), Point(5, None, 0)]),
        ("0,0,10\n5,1.5,0", [Point(0, 0, 0.01), Point(5, 1.5, 0)]),
        ("time, position\n10, 7\n", [Point(7, None, 0.01)]),
        # As a spreadsheet saves it: semicolons or tabs, decimal commas, a separator at the end of each line.
        ("position;velocity;time\n0;0,5;10\n5;;0\n", [Point(0, 0.5, 0.01), Point(5, None, 0)]),
        ("position;time;\n1000,5;10;\n2000;0;\n", [Point(1000.5, None, 0.01), Point(2000, None, 0)]),
        ("position\tvelocity\ttime\n7\t1,5\t10\n", [Point(7, 1.5, 0.01)]),
        ("7 1.5 10\n8 0 0\n", [Point(7, 1.5, 0.01), Point(8, 0, 0)]),
        ("# a comment\n\nPOSITION\n1\n2\n", [Point(1, None, 0), Point(2, None, 0)]),
        (
            "position,velocity,time,relative\n1,2,3,yes\n1,2,3,0",
            [Point(1, 2, 0.003, True), Point(1, 2, 0.003)],
        ),
    ],
)
def test_columns_come_in_any_order_and_may_be_missing(text: str, expected: list[Point]) -> None:
    assert read(text) == expected


@pytest.mark.parametrize(
    ("text", "line", "column", "message", "hint"),
    [
        ("position,velocty\n1,2\n", 1, 1, "there is no column 'velocty'", "did you mean velocity?"),
        ("# jog\nposition,colour\n1,2\n", 2, 1, "there is no column 'colour'", COLUMNS),
        ("velocity,time\n1,2\n", 1, 1, "there is no column 'position'", ""),
        ("position,time\n1,2\n3,x\n", 3, 1, "the time 'x' is not a number", ""),
        ("1,2,3\n1,2,3,4\n", 2, 1, "4 values for 3 columns", ""),
        ("1,2,3,0,5\n", 1, 1, "5 values for 4 columns", ""),
        ("1,2,3,0\n1,2,3,maybe\n", 2, 1, "the relative 'maybe' is not a number", ""),
        ("position,velocity,time\n,2,3\n", 2, 1, "the position '' is not a number", ""),
        ("position,velocity,time\n1,2\n", 2, 1, "the time '' is not a number", ""),
        ("", 0, 0, "there are no points", "a line per point: position,velocity,time,relative"),
        ("position\n", 0, 0, "there are no points", "a line per point: position,velocity,time,relative"),
    ],
)
def test_every_mistake_has_its_line(text: str, line: int, column: int, message: str, hint: str) -> None:
    with pytest.raises(ProgramError) as error:
        read(text)
    (first,) = error.value.diagnostics
    assert (first.line, first.column, first.message, first.hint) == (line, column, message, hint)


@pytest.mark.slow
@given(st.text(max_size=200))
def test_any_text_is_read_or_refused(text: str) -> None:
    with contextlib.suppress(ProgramError):
        assert read(text)


def test_all_mistakes_come_at_once() -> None:
    with pytest.raises(ProgramError) as error:
        read("1,2,3\nx,2,3\n1,y,3\n1,2,z\n")
    assert [d.line for d in error.value.diagnostics] == [2, 3, 4]
