"""Small tools of every subpackage: spellings, plurals, missing libraries, exact sums, bisection, space on the stack.

`MissingExtra` is raised for a feature whose library is not installed. `total` is for results that do not depend on the
Python version: the builtin `sum` rounds differently from Python 3.12 on.
"""

from __future__ import annotations

from _thread import allocate_lock
from collections.abc import Callable, Collection, Iterable, Sequence
from difflib import get_close_matches
from importlib import import_module
from math import fsum
from sys import getrecursionlimit, setrecursionlimit
from traceback import walk_stack
from typing import Any

# Maximum characters of a value in a message.
_MAX_SHOWN = 61
# More halvings than lie between any two floats and neighbours.
TO_NEIGHBOURS = 2200


def named(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
    """Give a function a name in stacks and profiles; return it."""
    function.__code__ = function.__code__.replace(co_name=name, co_qualname=name)
    return function


def in_notebook(kind: str, *values: object) -> str:
    """Return the page that a notebook shows of a value.

    The notebook asks the value itself, so the views, which nothing in the kernel imports, are found by name.
    """
    page: str = getattr(import_module("motionlang.views.notebook"), kind)(*values)
    return page


def shown(value: object) -> str:
    """Return a user's value for a message, on one line of limited length."""
    try:
        text = repr(value)
    except (ValueError, RecursionError):  # Python writes no number of more than 4300 digits
        return "the text there"
    return clipped(text)


def clipped(text: str, most: int = _MAX_SHOWN) -> str:
    """Return a text, truncated to at most so many characters; by default for a quotation in one line."""
    return text if len(text) <= most else f"{text[: most - 1]}…"


def listed(words: Iterable[object]) -> str:
    """Return words as text: "a, b and c"; there is at least one."""
    *others, last = map(str, words)
    return f"{', '.join(others)} and {last}" if others else last


class Spellings:
    """Known words for "did you mean …?"; case does not matter.

    Most words are excluded by an upper bound of their similarity: a letter that only one of two words has cannot match.
    The bound takes a few machine instructions per word.
    """

    __slots__ = ("_rows", "_spelt")

    def __init__(self, words: Iterable[str]) -> None:
        self._spelt = {each.lower(): each for each in words}
        self._rows = [(each, len(each), _letters(each)) for each in self._spelt]

    def nearest(self, word: str, cutoff: float = 0.6) -> str | None:
        """Return the most similar word that `word` may be meant as, None if there is none.

        Its `difflib` ratio is at least `cutoff`, and it differs by few letters or is abbreviated by `word`.
        """
        word = word.lower()
        size, letters = len(word), _letters(word)
        likely = [
            each
            for each, length, others in self._rows
            if 2.0
            * min(size - (letters & ~others).bit_count(), length - (others & ~letters).bit_count())
            / (size + length or 1)
            >= cutoff
        ]
        found = get_close_matches(word, likely, n=5, cutoff=cutoff)
        return next((self._spelt[each] for each in found if _is_near(word, each)), None)


def _letters(word: str) -> int:
    """Return the letters of a word as a bit set, in which some letters share a bit."""
    bits = 0
    for letter in word:
        bits |= 1 << (ord(letter) & 63)
    return bits


def _is_near(word: str, other: str) -> bool:
    """True if the words differ little, or if `word` abbreviates `other`."""
    return differ_little(word, other) or _abbreviates(word, other)


def _abbreviates(word: str, other: str) -> bool:
    """True if `word` begins `other`, or has its first letter and more than half of its letters in their order."""
    if other.startswith(word):
        return True
    letters = iter(other)
    return word[:1] == other[:1] and 2 * len(word) > len(other) and all(each in letters for each in word)


def differ_little(word: str, other: str) -> bool:
    """True if a third of the letters differs at most, or one; case does not matter.

    Many words of three letters differ in one, such as OCT and OUT. Words so short have the same first letter, and one
    has all letters of the other.
    """
    word, other = word.lower(), other.lower()
    longest = max(len(word), len(other))
    if edits(word, other) > max(1, longest // 3):
        return False
    return longest > 3 or (word[:1] == other[:1] and (set(word) <= set(other) or set(word) >= set(other)))


def edits(word: str, other: str) -> int:
    """Return how many letters to insert, delete, change or swap with their neighbour turn `word` into `other`."""
    before: list[int] = []
    last: list[int] = []
    row = list(range(len(other) + 1))
    for i, letter in enumerate(word, 1):
        before, last, row = last, row, [i]
        for j, wanted in enumerate(other, 1):
            row.append(min(last[j] + 1, row[-1] + 1, last[j - 1] + (letter != wanted)))
            if i > 1 and j > 1 and (letter, wanted) == (other[j - 2], word[i - 2]):
                row[j] = min(row[j], before[j - 2] + 1)
    return row[-1]


def nearest(word: str, words: Iterable[str]) -> str | None:
    """Return the most similar word of `words`, for "did you mean …?", or None."""
    return Spellings(words).nearest(word)


# Libraries that may be missing, by their import name: the extra of `pyproject.toml` and the name of the
# distribution. numpy belongs to no extra, because the package depends on it. Some Pythons, such as a
# browser's, lack it, and most runs do without.
LIBRARIES = {
    "matplotlib": ("plot", "matplotlib"),
    "pyarrow": ("parquet", "pyarrow"),
    "serial": ("serial", "pyserial"),
    "shtab": ("completion", "shtab"),
}
# The libraries that the package depends on and that a run may do without.
REQUIRED = ("lark", "numpy")


def count_of(number: int, noun: str, plural: str = "") -> str:
    """Return a number with its noun, such as "1 move" or "2 moves"."""
    return f"{number} {noun if number == 1 else plural or f'{noun}s'}"


def numbered(noun: str, numbers: Iterable[int]) -> str:
    """Return numbers with their noun, such as "line 3" or "lines 3, 5"."""
    found = sorted(numbers)
    return f"{noun}{'s' * (len(found) > 1)} {', '.join(map(str, found))}"


def ranges(numbers: Iterable[int]) -> str:
    """Return numbers as text, with ranges: "3, 5-7"."""
    found: list[list[int]] = []
    for each in sorted(set(numbers)):
        if found and each == found[-1][1] + 1:
            found[-1][1] = each
        else:
            found.append([each, each])
    return ", ".join(str(a) if a == b else f"{a}-{b}" if b > a + 1 else f"{a}, {b}" for a, b in found)


def lines_words(lines: Collection[int]) -> str:
    """Return lines in words, such as "line 4" or "lines 3-5, 8"; "" if there are none."""
    return f"{'line' if len(lines) == 1 else 'lines'} {ranges(lines)}" if lines else ""


def as_hint(description: str) -> str:
    """Return a description as a hint: without capital and full stop."""
    second = description[1:2]
    begin = description[:1].lower() if second.islower() or second == " " else description[:1]
    return begin + description[1:].removesuffix(".")


class PicklableError(Exception):
    """An error that other processes can send, whatever its constructor takes."""

    def __reduce__(self) -> tuple[Callable[..., Exception], tuple[object, ...]]:
        return _error_of, (type(self), self.args, self.__dict__)


def _error_of(kind: type[Exception], args: tuple[object, ...], fields: dict[str, object]) -> Exception:
    made = kind.__new__(kind, *args)
    made.args = args
    made.__dict__.update(fields)
    return made


class MissingExtra(PicklableError, ImportError):
    """`user`, a feature or an option, needs libraries that are missing, mostly those of an extra.

    `message` names them and `hint` is the command that installs them. It uses double quotes, which every shell accepts.
    """

    def __init__(self, user: str, libraries: Sequence[str]) -> None:
        names = " and ".join(LIBRARIES.get(library, ("", library))[1] for library in libraries)
        self.message = f"{user} needs {names}"
        self.is_required = libraries[0] in REQUIRED
        if libraries[0] in LIBRARIES:
            self.hint = f'python -m pip install "motionlang[{LIBRARIES[libraries[0]][0]}]"'
        else:
            self.hint = f"python -m pip install {names}"
        super().__init__(f"{self.message}: {self.hint}")


def need(user: str, *libraries: str) -> None:
    """Raise MissingExtra if any of the `libraries`, all from one extra or from none, is missing."""
    missing = [library for library in libraries if not _is_installed(library)]
    if missing:
        raise MissingExtra(user, missing)


def _is_installed(library: str) -> bool:
    from importlib.util import find_spec

    try:
        return find_spec(library) is not None
    except ModuleNotFoundError:  # an import hook refuses it
        return False


def missing(error: BaseException, user: str) -> MissingExtra | None:
    """Return the MissingExtra for an error caused by a missing library, or None."""
    if isinstance(error, MissingExtra):
        return error
    if isinstance(error, ImportError) and error.name in REQUIRED:
        return MissingExtra(user, [error.name])
    return None


def signed(word: int) -> int:
    """Return the lowest 32 bits of an integer in two's complement, as banks of inputs and registers hold them."""
    return (word + 0x80000000 & 0xFFFFFFFF) - 0x80000000


def total(values: Iterable[float]) -> float:
    """Return the sum, rounded once; infinite or NaN if no float represents it."""
    terms = tuple(values)
    try:
        return fsum(terms)
    except (OverflowError, ValueError):
        beyond = 0.0  # adding one by one shows which
        for term in terms:
            beyond += term
        return beyond


def exact_terms(values: Iterable[float]) -> list[float]:
    """Return a few floats whose exact sum is the exact sum of all values.

    They are the rounded sum, its error, the error of that error, and so on.
    """
    rest = list(values)
    terms: list[float] = []
    while term := fsum(rest):
        terms.append(term)
        rest.append(-term)
    return terms


def bisected(
    good: float, bad: float, is_good: Callable[[float], object], halvings: int = TO_NEIGHBOURS
) -> float:
    """Return the good value next to a bad one: the two become neighbouring floats, or so many halvings are over."""
    for _ in range(halvings):
        middle = 0.5 * (good + bad)
        if middle in (good, bad):
            break
        good, bad = (middle, bad) if is_good(middle) else (good, middle)
    return good


# Frames for passes over the nested text of a program, and for the functions that the deepest statement calls.
_FRAMES = 5000

_lock = allocate_lock()
# The limits that the open blocks need, after the limit before the first of them.
_limits: list[int] = []


class StackSpace:
    """A block in which Python may nest enough calls for any program.

    Blocks of several threads may overlap. The limit belongs to all threads, so it is restored when the last
    block ends.
    """

    def __enter__(self) -> None:
        self._limit = sum(1 for _ in walk_stack(None)) + _FRAMES
        with _lock:
            if not _limits:
                _limits.append(getrecursionlimit())
            _limits.append(self._limit)
            setrecursionlimit(max(_limits))

    def __exit__(self, *_: object) -> None:
        with _lock:
            _limits.reverse()  # the first one may be an equal number
            _limits.remove(self._limit)
            _limits.reverse()
            setrecursionlimit(max(_limits))
            if len(_limits) == 1:
                _limits.clear()
