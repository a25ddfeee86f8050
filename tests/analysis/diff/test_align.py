"""Alignment of sequences by content, compared with an exhaustive search."""

from __future__ import annotations

import random

import pytest

from motionlang.analysis.diff import align
from motionlang.analysis.diff.align import aligned, common


def longest(a: list[int], b: list[int]) -> int:
    """The length of the longest common subsequence, by the table of all prefixes."""
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
        edits = len(a) + len(b) - 2 * longest(a, b)
        assert (pairs is None) is (edits > most and bool(a) and bool(b) and pairs is None)
        if pairs is not None:
            assert all(a[i] == b[j] for i, j in pairs)
            assert pairs == sorted(pairs)
            assert len({i for i, _ in pairs}) == len({j for _, j in pairs}) == longest(a, b)
        whole = aligned(a, b, lambda x: x, lambda x: int(str(x)) % 2)
        assert [i for i, _ in whole if i is not None] == list(range(len(a)))
        assert [j for _, j in whole if j is not None] == list(range(len(b)))


def test_twenty_thousand_entries_of_which_every_one_is_otherwise() -> None:
    a, b = (list(range(0, sign * 20_000, sign)) for sign in (1, -1))
    pairs = aligned(a, b, lambda x: x, lambda x: abs(int(str(x))) % 8)
    assert all(i == j for i, j in pairs)
