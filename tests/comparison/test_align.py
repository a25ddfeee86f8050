"""The alignment of two sequences, against a table of all prefixes."""

from __future__ import annotations

import random

from motionlang.comparison.align import aligned


def common_length(a: list[str], b: list[str]) -> int:
    """Return the length of the longest common subsequence, by a table of all prefixes."""
    table = [[0] * (len(b) + 1) for _ in range(len(a) + 1)]
    for i, one in enumerate(a):
        for j, other in enumerate(b):
            best = max(table[i][j + 1], table[i + 1][j])
            table[i + 1][j + 1] = table[i][j] + 1 if one == other else best
    return table[-1][-1]


def test_what_two_outputs_have_in_common_is_the_longest_there_is_and_the_first_of_equal_lines() -> None:
    """Lines are put in and taken out as late as possible."""
    draw = random.Random(4)
    for _ in range(500):
        a, b = ([draw.choice("wxyz") for _ in range(draw.randrange(13))] for _ in range(2))
        found = aligned(a, b, str)
        pairs = [(i, j) for i, j in found if i is not None and j is not None]
        assert all(a[i] == b[j] for i, j in pairs)
        assert pairs == sorted(pairs)
        assert len({i for i, _ in pairs}) == len({j for _, j in pairs}) == common_length(a, b)
        assert sorted(i for i, _ in found if i is not None) == list(range(len(a)))
        assert sorted(j for _, j in found if j is not None) == list(range(len(b)))
        i_last = j_last = -1
        for i, j in pairs:
            assert not (i == i_last + 1 and j > j_last + 1 and b[j_last + 1] == a[i])
            assert not (j == j_last + 1 and i > i_last + 1 and a[i_last + 1] == b[j])
            i_last, j_last = i, j


def test_sequences_that_are_too_different_are_compared_entry_by_entry() -> None:
    a, b = ([f"{sign}{n}" for n in range(3000)] for sign in ("a ", "b "))
    assert len(aligned(a, b, str)) == 6000
    assert aligned(a, a[::-1], str, lambda _: 0) == [(n, n) for n in range(3000)]
