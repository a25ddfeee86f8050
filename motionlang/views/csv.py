"""Fast conversion of columns to fixed-point CSV text, with tables of digits.

It is many times as fast as `np.savetxt` and gives the same digits. A number becomes words of four bytes. One
to four words hold the digits before the decimal point, the first including the sign. Two to four words of three
digits hold the decimals, the last including the separator. Unused bytes are NUL, and one `translate` deletes them
all. Rows with values that do not fit, because they are too large or not a number, are formatted one by one.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

Words = NDArray[np.uint32]

# The numbers of decimals that a column can have.
DECIMALS = (6, 9, 12)
# The number of rows processed together, so that all data stays in the cache.
BLOCK = 16_384
# Shorter runs of equal rows are written like any others.
LONG_REST = 64
# A number times 10^decimals must stay below this: doubles represent every integer up to 2^53.
LARGEST = 9.0e15
# Bounds of integer parts with one, two and three words: three digits with the sign, then four each.
_WIDTHS = (1e3, 1e7, 1e11)
# A product this near to a half, with nine decimals and with more, may have been rounded in the wrong
# direction. Such numbers are formatted one by one.
_NEAR_HALF, _NEARER = 1e-6, 1e-3


def _table(texts: Sequence[bytes]) -> Words:
    return np.frombuffer(b"".join(texts), "<u4").copy()


# 0…9999 with leading zeros, and with NUL instead of them. In the latter, 0 has either no digit or one.
_FOUR = _table([b"%04d" % i for i in range(10_000)])
_LEADING = _table([b"\0\0\0\0", *((b"%d" % i).rjust(4, b"\0") for i in range(1, 10_000))])
_UNITS = _LEADING.copy()
_UNITS[0] = np.frombuffer(b"\0\0\x000", "<u4")[0]
# A sign and three digits, first for numbers from 0 up, then for those below it. There is one table for the
# first of several words and one for a single word.
_SIGNED = _table(
    [sign + text.tobytes()[1:] for sign in (b"\0", b"-") for text in np.split(_LEADING[:1000], 1000)]
)
_ALONE = _table(
    [sign + text.tobytes()[1:] for sign in (b"\0", b"-") for text in np.split(_UNITS[:1000], 1000)]
)
_AFTER_POINT = _table([b".%03d" % i for i in range(1000)])
_MIDDLE = _table([b"\0%03d" % i for i in range(1000)])
_COMMA = _table([b"%03d," % i for i in range(1000)])
_NEWLINE = _table([b"%03d\n" % i for i in range(1000)])


def decimals_for(resolution: float) -> int:
    """Return the fewest of `DECIMALS` that show a thousandth of `resolution`."""
    for decimals in DECIMALS:
        if 10.0**-decimals <= abs(resolution) / 1000.0 * (1.0 + 1e-9):
            return decimals
    return DECIMALS[-1]


class Formatter:
    """Formats columns of equal length as CSV lines.

    `decimals` has one of `DECIMALS` for each column.
    """

    def __init__(self, decimals: Sequence[int]) -> None:
        assert all(each in DECIMALS for each in decimals)
        self._decimals = tuple(decimals)
        self._rows = _Buffer()
        self._first = _Buffer()

    def lines(self, columns: Sequence[Array]) -> list[bytes]:
        """Return the lines of the columns, in blocks."""
        texts: list[bytes] = []
        for first in range(0, len(columns[0]), BLOCK):
            texts += self._block([column[first : first + BLOCK] for column in columns])
        return texts

    def _block(self, columns: Sequence[Array]) -> list[bytes]:
        standstills = _standstills(columns)
        is_moving = np.ones(len(columns[0]), np.bool_)
        for begin, end in standstills:
            is_moving[begin:end] = False
        moving = [column[is_moving] for column in columns] if standstills else columns
        if not self._rows.fill(moving, self._decimals, _NEWLINE):
            return [self._slow(columns)]
        if standstills and not self._first.fill(columns[:1], self._decimals[:1], _COMMA):
            return [self._slow(columns)]
        texts: list[bytes] = []
        done, left_out = 0, 0
        for begin, end in standstills:
            text = self._rows.text(done, begin - left_out)
            last = text[text.rfind(b"\n", 0, -1) + 1 :]
            texts += text, self._first.text(begin, end).replace(b",", last[last.index(b",") :])
            done, left_out = begin - left_out, left_out + end - begin
        texts.append(self._rows.text(done, len(moving[0])))
        return texts

    def _slow(self, columns: Sequence[Array]) -> bytes:
        # Adding 0.0 turns -0.0 into 0.0, to match the fast path.
        row = ",".join(f"%.{decimals}f" for decimals in self._decimals) + "\n"
        values = zip(*((column + 0.0).tolist() for column in columns), strict=True)
        return "".join([row % each for each in values]).encode("ascii")


class _Buffer:
    """Rows of words in reused memory."""

    def __init__(self) -> None:
        self._bytes = bytearray()
        self._row = 0

    def fill(self, columns: Sequence[Array], decimals: Sequence[int], last_ends: Words) -> bool:
        """Write the columns; return False if one of them does not fit into words."""
        sizes = [max(-column.min(), column.max()) for column in columns]
        for size, each in zip(sizes, decimals, strict=True):
            if not size * 10.0**each < LARGEST:
                return False
        integer_words = [1 + len([most for most in _WIDTHS if size >= most - 1.0]) for size in sizes]
        # Each has an even number of words, because they are copied two or four at a time.
        widths = [whole + each // 3 for whole, each in zip(integer_words, decimals, strict=True)]
        edges = [0, *accumulate(width + width % 2 for width in widths)]
        self._row = 4 * edges[-1]
        room = len(columns[0]) * self._row
        if len(self._bytes) < room:
            self._bytes = bytearray(room)
        words = np.frombuffer(self._bytes, "<u4", room // 4).reshape(-1, edges[-1])
        last = len(columns) - 1
        for i, (column, each) in enumerate(zip(columns, decimals, strict=True)):
            chunk = words[:, edges[i] : edges[i + 1]]
            cell, spare = np.empty(chunk.shape, "<u4"), chunk.shape[1] - widths[i]
            cell[:, :spare] = 0
            _write(cell, spare, spare + integer_words[i], column, each, last_ends if i == last else _COMMA)
            at_once = np.complex128 if chunk.shape[1] % 4 == 0 else np.uint64
            chunk.view(at_once)[...] = cell.view(at_once)
        return True

    def text(self, begin: int, end: int) -> bytes:
        """Return the text of some of the rows."""
        return bytes(memoryview(self._bytes)[begin * self._row : end * self._row]).translate(None, b"\0")


def _standstills(columns: Sequence[Array]) -> list[tuple[int, int]]:
    """Find the long runs of rows that differ from their predecessor only in column 0."""
    if len(columns) < 2:
        return []
    changes = columns[1][1:] != columns[1][:-1]
    for column in columns[2:]:
        changes |= column[1:] != column[:-1]
    edges = np.concatenate(([-1], np.flatnonzero(changes), [len(changes)]))
    long = np.flatnonzero(np.diff(edges) > LONG_REST)
    return list(zip((edges[long] + 2).tolist(), (edges[long + 1] + 1).tolist(), strict=True))


def _write(words: Words, first: int, point: int, column: Array, decimals: int, ends: Words) -> None:
    """Write the digits of one column into words.

    The integer part begins at `first`, the decimals at `point`.
    """
    below = column <= -0.5 * 10.0**-decimals if column.min() < 0.0 else None
    fractions = np.abs(column)
    whole = np.floor(fractions)
    fractions -= whole  # exact
    # Up to nine decimals are one 32-bit number; of twelve, the last three are another.
    upper = min(decimals, 9)
    fractions *= 10.0**upper
    high = None
    if decimals > upper:
        high = np.floor(fractions)
        fractions -= high
        fractions *= 10.0 ** (decimals - upper)
    digits = np.rint(fractions)
    fractions -= digits
    np.abs(fractions, out=fractions)
    near = 0.5 - (_NEAR_HALF if high is None else _NEARER)
    if fractions.max() > near:
        _write_exactly(
            column, decimals, np.flatnonzero(fractions > near).tolist(), (whole, high, digits, below)
        )
    _carry(digits, 10.0 ** (decimals - upper if high is not None else upper), whole if high is None else high)
    index = point + decimals // 3 - 1
    if high is not None:
        words[:, index] = ends.take(digits.astype(np.int32))
        _carry(high, 10.0**upper, whole)
        digits, index, ends = high, index - 1, _MIDDLE
    rest = digits.astype(np.int32)
    while index > point:
        left = rest // 1000
        rest -= left * 1000
        words[:, index] = ends.take(rest)
        rest, index, ends = left, index - 1, _MIDDLE
    words[:, point] = _AFTER_POINT.take(rest)
    _write_integers(words, first, point, whole, below)


def _carry(digits: Array, most: float, into: Array) -> None:
    """Carry digits that were rounded up to the next power of ten."""
    if digits.max() >= most:
        over = digits >= most
        into[over] += 1.0
        digits[over] = 0.0


def _write_exactly(
    column: Array,
    decimals: int,
    rows: Sequence[int],
    components: tuple[Array, Array | None, Array, NDArray[np.bool_] | None],
) -> None:
    """Replace the digits of some rows by those that Python formats.

    `components` are the arrays to change.
    """
    whole, high, digits, below = components
    for row in rows:
        shown = f"{abs(column[row]):.{decimals}f}"
        before, _, behind = shown.partition(".")
        whole[row], digits[row] = float(before), float(behind if high is None else behind[9:])
        if high is not None:
            high[row] = float(behind[:9])
        if below is not None:
            below[row] = column[row] < 0.0 and shown.strip("0.") != ""


def _write_integers(
    words: Words, first: int, point: int, whole: Array, below: NDArray[np.bool_] | None
) -> None:
    number: Any = whole.astype(np.int32 if point - first < 3 else np.int64)
    groups = []
    for _ in range(point - first - 1):
        left = number // 10_000
        groups.append(number - left * 10_000)
        number = left
    begun = number > 0 if groups else None
    if below is not None:
        number += below.view(np.int8) * number.dtype.type(1000)
    words[:, first] = (_ALONE if begun is None else _SIGNED).take(number)
    for index, group in enumerate(reversed(groups), first + 1):
        assert begun is not None
        table = _UNITS if index == point - 1 else _LEADING
        words[:, index] = np.where(begun, _FOUR.take(group), table.take(group))
        begun |= group > 0
