"""Alignment of two sequences by content: the longest common subsequence.

Common entries at both ends are removed first; the rest uses Myers' greedy algorithm.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Sequence

Pairs = list[tuple[int, int]]

# Insertions and deletions beyond which two sequences are not aligned exactly: the work grows with their
# square.
MAX_EDITS = 600


def common(a: Sequence[Hashable], b: Sequence[Hashable]) -> Pairs | None:
    """Return the positions of common entries, in order; None beyond `MAX_EDITS` edits."""
    first = 0
    while first < len(a) and first < len(b) and a[first] == b[first]:
        first += 1
    last = 0
    while last < min(len(a), len(b)) - first and a[-1 - last] == b[-1 - last]:
        last += 1
    middle = _myers(a[first : len(a) - last], b[first : len(b) - last])
    if middle is None:
        return None
    pairs = [(n, n) for n in range(first)]
    pairs += [(first + i, first + j) for i, j in middle]
    pairs += [(len(a) - n, len(b) - n) for n in range(last, 0, -1)]
    return _latest(pairs, a, b)


def _too_different(a: Sequence[Hashable], b: Sequence[Hashable]) -> bool:
    """True if more than `MAX_EDITS` entries have no counterpart in any order.

    Each of these entries is an edit.
    """
    here, there = Counter(a), Counter(b)
    return (here - there).total() + (there - here).total() > MAX_EDITS


def _latest(pairs: Pairs, a: Sequence[Hashable], b: Sequence[Hashable]) -> Pairs:
    """Return the pairs with insertions and deletions as late as possible.

    If a loop runs longer, the inserted entries are therefore its last iterations.
    """
    made: Pairs = []
    i_last = j_last = -1
    for i, j in pairs:
        if i == i_last + 1 and b[j_last + 1] == a[i]:
            j = j_last + 1
        elif j == j_last + 1 and a[i_last + 1] == b[j]:
            i = i_last + 1
        made.append((i, j))
        i_last, j_last = i, j
    return made


def _myers(a: Sequence[Hashable], b: Sequence[Hashable]) -> Pairs | None:
    if not a or not b:
        return []
    if _too_different(a, b):
        return None
    # furthest[k] is the furthest position in a on the diagonal k that so many edits reach.
    furthest, steps = {1: 0}, []
    for edits in range(min(len(a) + len(b), MAX_EDITS) + 1):
        steps.append(dict(furthest))
        for k in range(-edits, edits + 1, 2):
            down = k == -edits or (k != edits and furthest[k - 1] < furthest[k + 1])
            i = furthest[k + 1] if down else furthest[k - 1] + 1
            while i < len(a) and i - k < len(b) and a[i] == b[i - k]:
                i += 1
            furthest[k] = i
            if i >= len(a) and i - k >= len(b):
                return _backtrack(steps, len(a), len(b))
    return None


def _backtrack(steps: list[dict[int, int]], i: int, j: int) -> Pairs:
    """Return what is common up to i and j: the rest of a diagonal after each edit."""
    pairs = []
    for edits in range(len(steps) - 1, -1, -1):
        furthest, k = steps[edits], i - j
        down = k == -edits or (k != edits and furthest[k - 1] < furthest[k + 1])
        before = k + 1 if down else k - 1
        start = furthest[before] if edits else 0
        while i > start + (0 if down or not edits else 1):
            i, j = i - 1, j - 1
            pairs.append((i, j))
        if edits:
            i, j = start, start - before
    return pairs[::-1]


def aligned(
    a: Sequence[object], b: Sequence[object], *keys: Callable[[object], Hashable]
) -> list[tuple[int | None, int | None]]:
    """Return every entry of both, in order, with its counterpart or None.

    Entries that are equal by the first key are paired, those between them by the next key, and so on. If the
    sequences differ too much for the last key, the nth entry of a kind is paired with the nth of the other.
    """
    if not keys:
        return [*((i, None) for i in range(len(a))), *((None, j) for j in range(len(b)))]
    key = keys[0]
    found = common([key(each) for each in a], [key(each) for each in b])
    if found is None:
        found = [] if len(keys) > 1 else _by_number(a, b, key)
    out: list[tuple[int | None, int | None]] = []
    i = j = 0
    for i_next, j_next in [*found, (len(a), len(b))]:
        between = aligned(a[i:i_next], b[j:j_next], *keys[1:]) if i < i_next or j < j_next else []
        out += [(None if x is None else i + x, None if y is None else j + y) for x, y in between]
        if i_next < len(a) and j_next < len(b):
            out.append((i_next, j_next))
        i, j = i_next + 1, j_next + 1
    return out


def _by_number(a: Sequence[object], b: Sequence[object], key: Callable[[object], Hashable]) -> Pairs:
    """Pair the nth of a kind with the nth of the same kind, while both stay in order."""
    indices: dict[Hashable, list[int]] = {}
    for j in range(len(b) - 1, -1, -1):
        indices.setdefault(key(b[j]), []).append(j)
    pairs, last = [], -1
    for i, each in enumerate(a):
        waiting = indices.get(key(each), [])
        while waiting and waiting[-1] <= last:
            waiting.pop()
        if waiting:
            last = waiting.pop()
            pairs.append((i, last))
    return pairs
