"""Streams of records: which are packed, and what is read, stored and dropped."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.controller.faults import Rejected
from motionlang.log import stream
from motionlang.log.stream import Chunks, Store, Stream


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave three of six records, and pack two at a time."""
    for name, value in (("MAX_TAIL", 6), ("LEFT", 3), ("CHUNK_SIZE", 2)):
        monkeypatch.setattr(stream, name, value)


def rows(count: int) -> list[tuple[int]]:
    return [(k,) for k in range(count)]


def numbers(count: int) -> Stream[tuple[int]]:
    made: Stream[tuple[int]] = Stream(Store())
    for row in rows(count):
        made.add(row)
    return made


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize(
    ("count", "packed", "firsts"),
    [(0, 0, []), (5, 0, []), (6, 3, [0, 2]), (8, 3, [0, 2]), (9, 6, [0, 2, 3, 5])],
)
def test_the_sixth_record_packs_three(count: int, packed: int, firsts: list[int]) -> None:
    found = numbers(count)
    assert (found.packed, len(found.tail), found._chunks.firsts) == (packed, count - packed, firsts)
    assert (len(found), bool(found), found.first) == (count, count > 0, 0)
    assert list(found) == rows(count)
    assert list(reversed(found)) == rows(count)[::-1]
    assert [found[k] for k in range(-count, count)] == 2 * rows(count)
    for some in (slice(None), slice(1, 7, 2), slice(-2, None), slice(4, 2)):
        assert found[some] == rows(count)[some]
    assert list(found.as_stored()) == rows(count)


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize(
    ("before", "added", "packed"),
    [(0, 3, 0), (0, 5, 0), (0, 6, 3), (2, 3, 0), (2, 4, 3), (2, 7, 5), (5, 3, 5)],
)
def test_records_that_are_added_together_are_packed_too(before: int, added: int, packed: int) -> None:
    """Three are added at a time; of six or more all but three are packed."""
    found = numbers(before)
    found.extend(rows(before + added)[before:])
    assert (found.packed, list(found)) == (packed, rows(before + added))


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize(
    ("count", "retained", "first"),
    [
        (5, 2, 3),  # nothing is packed: the two newest are left
        (5, 3, 0),
        (4, 2, 0),
        (12, 6, 0),  # chunks begin at 0, 2, 3, 5, 6 and 8; a chunk is dropped while more than 12 are left
        (12, 5, 2),
        (12, 4, 5),
        (12, 1, 11),  # all chunks, and two of the three that are not packed
    ],
)
def test_old_records_are_dropped_and_others_keep_their_numbers(count: int, retained: int, first: int) -> None:
    found = numbers(count)
    found.forget(retained)
    assert (found.first, len(found), list(found)) == (first, count, rows(count)[first:])
    assert found[0:count] == rows(count)[first:]
    assert found[count - 1] == (count - 1,)
    if first:
        with pytest.raises(IndexError):
            found[first - 1]
    found.add((count,))
    assert (list(found), bool(found)) == (rows(count + 1)[first:], True)


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


def chunks(*sizes: int) -> tuple[Chunks, list[list[int]]]:
    """Return chunks of the numbers from 0 on, and a list of what is read."""
    read: list[list[int]] = []

    def reader(rows: list[Any], first: int) -> list[Any]:
        assert rows[0] == first
        read.append(rows)
        return rows

    made = Chunks(Store(), reader)
    for size in sizes:
        tail = list(range(made.count, made.count + size + 1))
        made.pack(tail[:size], tail)
        assert tail == [made.count]
    return made, read


@pytest.mark.parametrize("first", range(7))
@pytest.mark.parametrize("past", range(8))
def test_records_of_several_chunks(first: int, past: int) -> None:
    made, _ = chunks(2, 1, 4)
    assert (len(made), made.first, made.count) == (3, 0, 7)
    assert made.records(first, past) == list(range(first, past))
    assert made.record(first) == first


def test_a_chunk_is_read_once_until_another_one_is() -> None:
    made, read = chunks(2, 1, 4)
    assert [made.record(k) for k in (3, 6, 4)] == [3, 6, 4]
    assert read == [[3, 4, 5, 6]]
    made.reread()
    assert [made.record(k) for k in (3, 0)] == [3, 0]
    assert read == [[3, 4, 5, 6], [3, 4, 5, 6], [0, 1]]
    assert [made.forget() for _ in range(3)] == [2, 1, 4]
    assert (len(made), made.first, made.count) == (0, 7, 7)
    with pytest.raises(IndexError):
        made.record(6)


def test_the_second_chunk_is_read_first() -> None:
    made, _ = chunks(1, 1)
    assert made.record(1) == 1
    made.reread()
    assert made.record(1) == 1


class Interrupted(list[int]):
    """A tail from which nothing can be removed the first time."""

    armed = True

    def __delitem__(self, index: Any) -> None:
        if self.armed:
            self.armed = False
            raise KeyboardInterrupt
        super().__delitem__(index)


def test_a_chunk_that_is_interrupted_before_its_records_are_removed_is_completed() -> None:
    """Of 1 to 5, two more are packed; the two tails have the rest."""
    made, _ = chunks(1)
    one, other = Interrupted([1, 2, 3, 4, 5]), [10, 20, 30, 40, 50]
    with pytest.raises(KeyboardInterrupt):
        made.pack([1, 2], one, other)
    for _ in range(2):
        made.finish_updates(one, other)
        assert (one, other, made.count, made.firsts) == ([3, 4, 5], [30, 40, 50], 3, [0, 1])
    assert made.records(0, 3) == [0, 1, 2]


@pytest.mark.parametrize("firsts", [[], [2]])
def test_a_chunk_that_is_interrupted_before_it_is_counted_is_dropped(firsts: list[int]) -> None:
    """Of 2 to 4, two more were to be packed, after one and one."""
    made, _ = chunks(1, 1)
    made._locations.append(made._store.put(b""))
    made.firsts += firsts
    made._total = 5
    tail = [2, 3, 4]
    made.finish_updates(tail)
    assert (len(made), made.firsts, made.count, tail) == (2, [0, 1], 2, [2, 3, 4])


@pytest.mark.parametrize("sizes", [(), (1,), (2, 1)])
def test_between_two_chunks_there_is_nothing_to_complete(sizes: tuple[int, ...]) -> None:
    made, _ = chunks(*sizes)
    tail = [7, 8, 9]
    made.finish_updates(tail)
    assert (len(made), tail) == (len(sizes), [7, 8, 9])


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("count", range(10))
@pytest.mark.parametrize("added", [0, 1, 4, 20])
def test_a_stream_is_cut_to_an_earlier_extent_and_goes_on(count: int, added: int) -> None:
    found = numbers(count)
    extent = found.extent()
    found.extend([(-k,) for k in range(added)])
    found.cut(extent)
    assert (list(found), len(found)) == (rows(count), count)
    found.extend(rows(count + 9)[count:])
    assert list(found) == rows(count + 9)
    assert [found[k] for k in range(count + 9)] == rows(count + 9)


@pytest.mark.usefixtures("small")
def test_a_cut_drops_repeated_records_and_their_bytes() -> None:
    found = numbers(5)
    extent = found.extent()
    found.repeat(([(0, (0.0,), (7,))], 1000, 1, 0.0), (0.0, 0, 1e-3, 0.0))
    assert len(found) == 1005
    found.cut(extent)
    assert list(found) == rows(5)
    found.pack(5)
    other = numbers(5)
    other.pack(5)
    assert found._chunks._store.in_memory == other._chunks._store.in_memory


def test_records_with_names_are_cut_to_plain_rows(small: None) -> None:
    found: Stream[Any] = Stream(Store(), "Printed")
    for k in range(9):
        found.add((float(k), str(k)))
        if k == 4:
            extent, expected = found.extent(), list(found)
    found.cut(extent)
    assert list(found) == expected
    found.pack(5)
    assert list(found) == expected
