"""Records of actions that repeat: their times by hand, and their templates."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.log import repeated
from motionlang.log.records import Changed
from motionlang.log.repeated import RepeatedRecords, rows_of
from motionlang.log.stream import Store, Stream

# Two rows that repeat three times, every second tick and every 8 statements. Ticks are 1.0, 1.5, 2.0, …; a
# statement takes 1/16 s. Repetition r begins at tick 3 + 2 r, that is 2.5 + r, and has executed 8 r statements. Its
# first row is 2 statements after that, the second one begins 4 and ends 6 statements after the next tick.
ROWS: list[Any] = [(0, (2.0,), ("a",)), (1, (4.0, 6.0), ("b",))]
TEMPLATE: Any = (ROWS, 3, 2, 8.0), (1.0, 3, 0.5, 0.0625)
RECORDS = [
    (2.625, "a"),
    (3.25, 3.375, "b", (0.125,)),
    (4.125, "a"),
    (4.75, 4.875, "b", (0.125,)),
    (5.625, "a"),
    (6.25, 6.375, "b", (0.125,)),
]


def made(template: Any) -> RepeatedRecords:
    return RepeatedRecords(template, list)


@pytest.mark.parametrize("batch", [1, 2, 4, 5, 6, 1024])
def test_records_of_a_template_read_like_a_list(batch: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(repeated, "_BATCH", batch)
    records = made(TEMPLATE)
    assert len(records) == 6
    assert list(records) == RECORDS
    assert list(reversed(records)) == RECORDS[::-1]
    for index in range(-6, 6):
        assert records[index] == RECORDS[index]
    for some in (slice(1, 5, 2), slice(None, None, -1), slice(4, 9), slice(3, 3)):
        assert records[some] == RECORDS[some]
    with pytest.raises(IndexError):
        records[6]


@pytest.mark.parametrize(
    ("row", "statements", "times"),
    [
        ((0, (0.0,)), 0.0, [3.0, 5.0, 7.0]),  # ticks 4, 8 and 12 of 0.5 s after 1.0
        ((2, (0.0,)), 0.0, [4.0, 6.0, 8.0]),
        ((2, (0.0,)), 4.0, [4.0, 6.25, 8.5]),
        ((2, (8.0,)), 0.0, [4.5, 6.5, 8.5]),
        ((0, (8.0,)), 4.0, [3.5, 5.75, 8.0]),
        ((0, (1.0,)), 0.0, [3.0625, 5.0625, 7.0625]),
    ],
)
def test_the_times_of_a_single_row(
    row: tuple[int, tuple[float, ...]], statements: float, times: list[float]
) -> None:
    template: Any = ([(*row, (7, 1.0))], 3, 4, statements), (1.0, 4, 0.5, 0.0625)
    assert list(made(template)) == [(time, 7, 1.0) for time in times]


def test_two_rows_at_the_first_statement_of_their_ticks() -> None:
    rows: list[Any] = [(0, (0.0,), ("a",)), (1, (0.0,), ("b",))]
    times = [(1.0, "a"), (1.5, "b"), (2.0, "a"), (2.5, "b")]
    assert list(made(((rows, 2, 2, 0.0), (1.0, 0, 0.5, 0.0625)))) == times


def test_the_rows_of_a_tick_count_its_statements() -> None:
    """With a statement of 1/16 s, 2.125 is 2 statements after 2.0."""
    records = [(2.125, 7, 1.0), (2.25, 2.5, ("task",), (0.25,)), (2.0, "text")]
    assert rows_of(records, 5, 2.0, 0.0625) == [
        (5, (2.0,), (7, 1.0)),
        (5, (4.0, 8.0), (("task",),)),
        (5, (0.0,), ("text",)),
    ]


@pytest.mark.parametrize(
    "record",
    [
        (2.13, 7, 1.0),
        (2.125 + 2**-51, 7, 1.0),
        (2.25, 2.51, ("task",), (0.26,)),
        (2.25, 2.5, ("task",), (0.125,)),  # the task did not compute all the time
        (2.25, 2.5, ("one", "two"), (0.125, 0.125)),
    ],
)
def test_a_record_at_the_time_of_no_statement_has_no_rows(record: tuple[Any, ...]) -> None:
    assert rows_of([(2.0, 7, 0.0), record], 5, 2.0, 0.0625) is None


def test_a_stream_has_repeated_records_between_others() -> None:
    """Every 0.5 s from 2.0 on channel 3 is set, four times."""
    numbers: Stream[Changed] = Stream(Store(), "Changed")
    numbers.add((1.0, 3, 0.0))
    numbers.repeat(([(0, (0.0,), (3, 1.0))], 0, 1, 0.0), (1.0, 2, 0.5, 1e-5))
    assert (len(numbers), numbers.packed) == (1, 0)
    numbers.repeat(([(0, (0.0,), (3, 1.0))], 4, 1, 0.0), (1.0, 2, 0.5, 1e-5))
    numbers.add((9.0, 3, 0.0))
    expected = [
        Changed(1.0, 3, 0.0),
        *(Changed(time, 3, 1.0) for time in (2.0, 2.5, 3.0, 3.5)),
        Changed(9.0, 3, 0.0),
    ]
    assert list(numbers) == expected
    assert list(reversed(numbers)) == expected[::-1]
    assert [numbers[k] for k in range(-6, 6)] == 2 * expected
    assert numbers[1:6:2] == expected[1:6:2]
    assert list(numbers.as_stored()) == expected
    assert all(type(each) is Changed for each in numbers)
