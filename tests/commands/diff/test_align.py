"""Alignment of sequences by content, compared with an exhaustive search."""

from __future__ import annotations

import random
from itertools import product

import pytest

from motionlang.commands.diff import align
from motionlang.commands.diff.align import _by_number, _latest, aligned, common


def common_length(a: list[int], b: list[int]) -> int:
    """Return the length of the longest common subsequence, by a table of all prefixes."""
    table = [[0] * (len(b) + 1) for _ in range(len(a) + 1)]
    for i, one in enumerate(a):
        for j, other in enumerate(b):
            best = max(table[i][j + 1], table[i + 1][j])
            table[i + 1][j + 1] = table[i][j] + 1 if one == other else best
    return table[-1][-1]


@pytest.mark.parametrize("most", [600, 3, 0])
def test_what_is_common_is_the_longest_there_is(most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(align, "MAX_EDITS", most)
    draw = random.Random(4)
    for _ in range(500):
        a, b = ([draw.randrange(4) for _ in range(draw.randrange(13))] for _ in range(2))
        pairs = common(a, b)
        edits = len(a) + len(b) - 2 * common_length(a, b)
        assert (pairs is None) is (edits > most and bool(a) and bool(b) and pairs is None)
        if pairs is not None:
            assert all(a[i] == b[j] for i, j in pairs)
            assert pairs == sorted(pairs)
            assert len({i for i, _ in pairs}) == len({j for _, j in pairs}) == common_length(a, b)
        whole = aligned(a, b, lambda x: x, lambda x: int(str(x)) % 2)
        assert [i for i, _ in whole if i is not None] == list(range(len(a)))
        assert [j for _, j in whole if j is not None] == list(range(len(b)))


def test_insertions_and_deletions_are_as_late_as_possible() -> None:
    """If several adjacent entries are equal, the first ones count as common.

    All 961 pairs of sequences of up to four entries of two kinds are tried.
    """
    sequences = [list(each) for length in range(5) for each in product("xy", repeat=length)]
    for a, b in product(sequences, repeat=2):
        pairs = common(a, b)
        assert pairs is not None
        i_last = j_last = -1
        for i, j in pairs:
            assert not (i == i_last + 1 and j > j_last + 1 and b[j_last + 1] == a[i])
            assert not (j == j_last + 1 and i > i_last + 1 and a[i_last + 1] == b[j])
            i_last, j_last = i, j


def test_twenty_thousand_entries_that_all_differ() -> None:
    a, b = (list(range(0, sign * 20_000, sign)) for sign in (1, -1))
    pairs = aligned(a, b, lambda x: x, lambda x: abs(int(str(x))) % 8)
    assert all(i == j for i, j in pairs)


def test_sequences_too_different_for_a_key_are_aligned_by_the_next_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The last key pairs the nth entry of a kind with the nth; no key pairs nothing."""
    monkeypatch.setattr(align, "MAX_EDITS", 0)
    a, b = [1, 2, 3, 4], [4, 3, 2, 1]

    def parity(x: object) -> bool:
        return int(str(x)) % 2 == 0

    assert aligned(a, b, lambda x: x) == [
        (None, 0),
        (None, 1),
        (None, 2),
        (0, 3),
        (1, None),
        (2, None),
        (3, None),
    ]
    assert aligned(a, b, lambda x: x, parity) == [(None, 0), (0, 1), (1, 2), (2, 3), (3, None)]
    assert aligned(a, b) == [*((n, None) for n in range(4)), *((None, n) for n in range(4))]


@pytest.mark.parametrize(
    ("a", "b", "pairs"),
    [
        ("xyx", "xyx", [(0, 0), (1, 1), (2, 2)]),
        ("xyx", "yxx", [(0, 1), (2, 2)]),  # the y comes too early
        ("xyxy", "yxxy", [(0, 1), (1, 3)]),
        ("xx", "yx", [(0, 1)]),
        ("x", "xx", [(0, 0)]),
        ("z", "xy", []),
        ("", "x", []),
    ],
)
def test_the_nth_of_a_kind_is_paired_with_the_nth_in_order(
    a: str, b: str, pairs: list[tuple[int, int]]
) -> None:
    assert _by_number(a, b, str) == pairs


@pytest.mark.parametrize(
    ("a", "b", "pairs", "latest"),
    [
        ("x", "xx", [(0, 1)], [(0, 0)]),
        ("xx", "x", [(1, 0)], [(0, 0)]),
        ("xyy", "xy", [(0, 0), (2, 1)], [(0, 0), (1, 1)]),
        ("xy", "xyy", [(0, 0), (1, 2)], [(0, 0), (1, 1)]),
        ("xy", "xzy", [(0, 0), (1, 2)], [(0, 0), (1, 2)]),
        ("axx", "bx", [(2, 1)], [(2, 1)]),  # the first pair may not move beyond an entry that differs
    ],
)
def test_pairs_move_to_the_front(
    a: str, b: str, pairs: list[tuple[int, int]], latest: list[tuple[int, int]]
) -> None:
    assert _latest(pairs, a, b) == latest


@pytest.mark.parametrize(("most", "pairs"), [(3, None), (4, [(0, 1), (1, 3)])])
def test_a_difference_of_just_as_many_edits_as_allowed(
    most: int, pairs: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """From abyc to zaxb takes out y and c, and puts in z and x."""
    monkeypatch.setattr(align, "MAX_EDITS", most)
    assert common("abyc", "zaxb") == pairs
