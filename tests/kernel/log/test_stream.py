"""Streams of records: they read like lists, with what repeats."""

from __future__ import annotations

from itertools import chain
from random import Random

import pytest

from motionlang.kernel import Rejected
from motionlang.kernel.log import Changed, Stream, stream
from motionlang.kernel.log.stream import Budget


def at(time: float) -> Changed:
    return Changed(time, 3, time)


def times(found: Stream[Changed]) -> list[float]:
    return [each.time for each in found]


def changes(count: int) -> Stream[Changed]:
    made: Stream[Changed] = Stream(Budget())
    for k in range(count):
        made.add(at(float(k)))
    return made


@pytest.mark.parametrize("count", range(6))
def test_a_stream_is_read_like_a_list(count: int) -> None:
    found, expected = changes(count), [at(float(k)) for k in range(count)]
    assert (len(found), bool(found), list(found), list(reversed(found))) == (
        count, count > 0, expected, expected[::-1]
    )  # fmt: skip
    for some in (slice(None), slice(1, 4, 2), slice(-2, None), slice(4, 2), slice(None, None, -1)):
        assert found[some] == expected[some]
    for wrong in (count, -count - 1):
        with pytest.raises(IndexError):
            found[wrong]


def test_records_occur_again_a_period_later() -> None:
    """Records 1 and 2 three times more, 10 apart; then all that with another one, twice, 100 apart."""
    found = changes(3)
    found.repeat(1, 3, 10.0)
    found.add(at(40.0))
    assert times(found) == [0, 1, 2, 11, 12, 21, 22, 31, 32, 40]
    assert [each.time for each in found.written()] == [0, 1, 2, 40]
    found.repeat(1, 2, 100.0)
    once = [1, 2, 11, 12, 21, 22, 31, 32, 40]
    assert times(found) == [0, *once, *[time + 100 for time in once], *[time + 200 for time in once]]
    found.add(at(300.0))
    assert len(found) == 29
    assert [found[k].time for k in range(-len(found), 0)] == times(found)
    assert [each.time for each in found[4:13:3]] == [12, 31, 101]
    assert [(each.time, count) for each, count in found.condensed(100)] == [
        (time, 1) for time in times(found)
    ]
    # Of 24 repeated records at most twelve: two repetitions are one.
    assert [(each.time, count) for each, count in found.condensed(12)] == [
        (0, 1), (1, 1), (2, 1), (11, 2), (12, 2), (31, 1), (32, 1), (40, 1),
        (101, 2), (102, 2), (111, 4), (112, 4), (131, 2), (132, 2), (140, 2), (300, 1),
    ]  # fmt: skip


def test_a_repeated_moment_is_that_of_a_repetition_that_is_carried_out() -> None:
    """It is the base and the number of statements, not the original and a sum of periods."""
    cost, base = 1e-5, 0.1
    found = changes(0)
    found.add(at(base + 7.0 * cost))
    found.repeat(0, 5000, 3.0 * cost, base, cost)
    assert times(found) == [base + (7.0 + 3.0 * k) * cost for k in range(5001)]


@pytest.mark.parametrize("retained", [0, 1, 3])
def test_old_records_are_dropped_and_others_keep_their_numbers(retained: int) -> None:
    found = changes(20)
    found.forget(retained)
    assert (len(found), found.first, found.past) == (retained, 20 - retained, 20)
    assert times(found) == [float(k) for k in range(found.first, 20)]
    found.forget(retained)
    assert len(found) == retained
    found.add(at(20.0))
    assert (found[-1].time, found.past) == (20.0, 21)


def test_a_repetition_is_left_when_its_originals_are_dropped() -> None:
    found = changes(4)
    found.repeat(2, 3, 10.0)
    found.add(at(50.0))
    before = list(found)
    found.forget(2)
    assert list(found) == before[4:]


def test_a_log_that_is_full_ends_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """A record counts as 220 bytes; streams share a budget, and what is dropped is free again."""
    monkeypatch.setattr(stream, "MAX_MEMORY", 1100)
    budget = Budget()
    one: Stream[Changed] = Stream(budget)
    two: Stream[Changed] = Stream(budget)
    for found in (one, one, one, two, two):
        found.add(at(1.0))
    one.forget(1)
    two.add(at(2.0))
    two.add(at(3.0))
    with pytest.raises(Rejected, match=r"has reached 1\.1e-06 GB"):
        one.add(at(4.0))


@pytest.mark.parametrize("seed", range(20))
def test_whatever_is_done_to_a_stream_it_reads_like_a_list(seed: int) -> None:
    draw, found = Random(seed), changes(0)
    expected: list[list[float]] = []  # of each row
    extents: list[tuple[object, list[list[float]]]] = []
    for k in range(60):
        match draw.choice("aaaarec"):
            case "a":
                found.add(at(100.0 * k))
                expected.append([100.0 * k])
            case "r" if len(found) < 2000:
                first, count = draw.randint(0, len(expected)), draw.randint(0, 3)
                found.repeat(first, count, 7.0)
                if count and first < len(expected):
                    records = list(chain.from_iterable(expected[first:]))
                    expected.append([time + 7.0 * n for n in range(1, count + 1) for time in records])
            case "e":
                extents.append((found.extent(), list(expected)))
            case "c" if extents:
                extents = extents[: draw.randint(1, len(extents))]
                found.cut(extents[-1][0])
                expected = list(extents[-1][1])
        whole = list(chain.from_iterable(expected))
        assert (times(found), len(found)) == (whole, len(whole))
        first, past = sorted(draw.randint(0, len(whole)) for _ in range(2))
        assert [each.time for each in found[first:past]] == whole[first:past]
