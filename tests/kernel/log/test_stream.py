"""Streams of records: what is read is what was written, wherever its bytes are."""

from __future__ import annotations

from math import inf
from random import Random
from typing import Annotated, Any, NamedTuple

import pytest

from motionlang.kernel import Rejected
from motionlang.kernel.log import Changed, Store, Stream, stream
from motionlang.kernel.log.columns import ColumnOfTexts, Numbers


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Seal two rows at a time."""
    monkeypatch.setattr(stream, "CHUNK", 2)


class Everything(NamedTuple):
    """A record with a field of each kind of column."""

    time: float
    what: object
    text: Annotated[str, ColumnOfTexts]
    numbers: Annotated[tuple[float, ...], Numbers]


ROWS: list[Any] = [
    (0.0, 1, "", ()),
    (-0.0, True, "plain", (1.0,)),
    (inf, None, "größer", (1.5, -2.0, inf)),
    (1e-300, 2**60, "\udcff", ()),
    (2.5, 0.1, "a\nb", (3.0,)),
    (3.0, ("a", 1, (None, 2)), "plain", (4.0, 5.0)),
    (4.0, -7, "", (6.0,)),
    (5.0, "text", "last", ()),
    (6.0, False, "", ()),
]


@pytest.mark.parametrize("memory", [0, 100, 10_000])
def test_values_are_read_as_they_were_written(memory: int, small: None) -> None:
    """In columns, in chunks in memory, and in the file."""
    found = Stream(Store(memory=memory), Everything)
    for row in ROWS:
        found.add(row)
    assert repr([tuple(each) for each in found]) == repr(ROWS)
    assert [found[k].what for k in range(-9, 9)] == 2 * [what for _, what, _, _ in ROWS]
    assert [each.text for each in found[3:7]] == [text for _, _, text, _ in ROWS[3:7]]
    assert [each.numbers for each in reversed(found)] == [numbers for *_, numbers in reversed(ROWS)]


def at(time: float) -> tuple[float, int, float]:
    return time, 3, time


def times(found: Stream[Changed]) -> list[float]:
    return [each.time for each in found]


def changes(count: int) -> Stream[Changed]:
    made = Stream(Store(), Changed)
    for k in range(count):
        made.add(at(float(k)))
    return made


@pytest.mark.parametrize("count", range(6))
def test_a_stream_is_read_like_a_list(count: int, small: None) -> None:
    found, expected = changes(count), [Changed(*at(float(k))) for k in range(count)]
    assert (len(found), bool(found), list(found), list(reversed(found))) == (
        count, count > 0, expected, expected[::-1]
    )  # fmt: skip
    for some in (slice(None), slice(1, 4, 2), slice(-2, None), slice(4, 2), slice(None, None, -1)):
        assert found[some] == expected[some]
    for wrong in (count, -count - 1):
        with pytest.raises(IndexError):
            found[wrong]


def test_records_occur_again_a_period_later(small: None) -> None:
    """Records 1 and 2 three times more, 10 apart; then the last two of these with another one, twice, 100 apart."""
    found = changes(3)
    found.repeat(1, 3, 10.0)
    found.add(at(40.0))
    assert times(found) == [0, 1, 2, 11, 12, 21, 22, 31, 32, 40]
    assert [each.time for each in found.written()] == [0, 1, 2, 40]
    found.repeat(8, 2, 100.0)
    assert times(found)[8:] == [32, 40, 132, 140, 232, 240]
    found.add(at(300.0))
    assert [found[k].time for k in range(-len(found), 0)] == times(found)
    assert [each.time for each in found[4:13:3]] == [12, 31, 132]
    assert [(each.time, count) for each, count in found.condensed(100)] == [
        (time, 1) for time in times(found)
    ]
    # Of ten repeated records at most five: two repetitions are one.
    assert [(each.time, count) for each, count in found.condensed(5)] == [
        (0, 1), (1, 1), (2, 1), (11, 2), (12, 2), (31, 1), (32, 1), (40, 1), (132, 2), (140, 2), (300, 1)
    ]  # fmt: skip


def test_a_repeated_moment_is_that_of_a_repetition_that_is_carried_out() -> None:
    """It is the base and the number of statements, not the original and a sum of periods."""
    cost, base = 1e-5, 0.1
    found = Stream(Store(), Changed)
    found.add(at(base + 7.0 * cost))
    found.repeat(0, 5000, 3.0 * cost, base, cost)
    assert times(found) == [base + (7.0 + 3.0 * k) * cost for k in range(5001)]


@pytest.mark.parametrize("retained", [0, 1, 3])
def test_old_records_are_dropped_and_others_keep_their_numbers(retained: int, small: None) -> None:
    found = changes(20)
    found.forget(retained)
    assert 2 * retained - 2 <= len(found) - found.first <= max(2 * retained, 0)
    assert times(found) == [float(k) for k in range(found.first, 20)]
    assert (len(found), bool(found)) == (20, retained > 0)
    found.add(at(20.0))
    assert found[20].time == 20.0
    with pytest.raises(IndexError):
        found[found.first - 1]


def test_a_repetition_is_dropped_with_its_originals(small: None) -> None:
    found = changes(4)
    found.repeat(2, 3, 10.0)
    found.add(at(50.0))
    found.add(at(51.0))
    before = list(found)
    found.forget(2)
    assert (found.first, list(found)) == (2, before[2:])
    found.forget(1)
    assert (found.first, times(found), found[10].time) == (10, [50.0, 51.0], 50.0)


@pytest.mark.parametrize("seed", range(20))
def test_whatever_is_done_to_a_stream_it_reads_like_a_list(seed: int, small: None) -> None:
    draw, found, expected = Random(seed), Stream(Store(memory=40), Changed), list[float]()
    extents: list[tuple[int, list[float]]] = []
    for k in range(60):
        match draw.choice("aaaarec"):
            case "a":
                found.add(at(100.0 * k))
                expected.append(100.0 * k)
            case "r" if len(expected) < 2000:
                first, count = draw.randint(0, len(expected)), draw.randint(0, 3)
                found.repeat(first, count, 7.0)
                expected += [time + 7.0 * n for n in range(1, count + 1) for time in expected[first:]]
            case "e":
                extents.append((found.extent(), list(expected)))
            case "c" if extents:
                extents = extents[: draw.randint(1, len(extents))]
                extent, expected = extents[-1][0], list(extents[-1][1])
                found.cut(extent)
        assert times(found) == expected
        first, past = sorted(draw.randint(0, len(expected)) for _ in range(2))
        assert [each.time for each in found[first:past]] == expected[first:past]


def test_a_cut_drops_the_bytes(small: None) -> None:
    store = Store()
    found = Stream(store, Changed)
    for k in range(5):
        found.add(at(float(k)))
    extent, size = found.extent(), store.size
    for k in range(40):
        found.add(at(float(k)))
    found.cut(extent)
    assert (times(found), store.size) == ([0, 1, 2, 3, 4], size)


def test_chunks_are_in_memory_first_then_in_the_file() -> None:
    """Of 100 bytes, 60 and 40 fit; one more is written to the file, at its beginning."""
    store = Store(memory=100, disk=12)
    locations = [store.put(each) for each in (60 * b"a", 40 * b"b", b"c", b"defg")]
    assert locations == [60 * b"a", 40 * b"b", (0, 1), (1, 4)]
    assert [store.get(each) for each in locations] == [60 * b"a", 40 * b"b", b"c", b"defg"]
    assert (store.size, store.in_memory) == (105, 100)
    store.drop(locations[3])
    store.drop(locations[1])
    assert (store.size, store.in_memory) == (65, 60)
    assert store.put(40 * b"h") == 40 * b"h"
    with pytest.raises(Rejected, match=r"the log of the run has reached 1\.2e-08 GB"):
        store.put(8 * b"i")
    assert store.put(7 * b"i") == (5, 7)


class Interrupting:
    """A value of a column that takes it only after an interrupt."""

    __class__ = property(lambda self: self._raise())

    def _raise(self) -> Any:
        raise KeyboardInterrupt


@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_an_interrupt_while_a_record_is_written_leaves_the_others(count: int, small: None) -> None:
    found = changes(count)
    with pytest.raises(KeyboardInterrupt):
        found.add((9.0, Interrupting(), 9.0))
    found.finish_updates()
    found.add(at(7.0))
    assert times(found) == [*map(float, range(count)), 7.0]


def test_an_interrupt_while_a_chunk_is_sealed_leaves_its_records(
    small: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = changes(3)

    def interrupted(first: int) -> Any:
        raise KeyboardInterrupt

    with monkeypatch.context() as m:
        m.setattr(found, "_new_chunk", interrupted)
        with pytest.raises(KeyboardInterrupt):
            found.add(at(3.0))
    found.finish_updates()
    found.add(at(4.0))
    assert times(found) == [0, 1, 2, 3, 4]
