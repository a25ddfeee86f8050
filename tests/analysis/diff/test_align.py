"""Alignment of sequences by content, compared with an exhaustive search."""

from __future__ import annotations

import random
from itertools import product

import pytest

from motionlang.analysis.diff import align
from motionlang.analysis.diff.align import aligned, common


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
