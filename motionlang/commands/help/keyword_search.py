"""Search of keywords by description: `motionlang help stop at an input`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from motionlang.kernel import Keyword

# The most results in each language.
MAX_FOUND = 12
# Words of a question that say nothing about a keyword.
STOP_WORDS = frozenset((
    "a", "all", "an", "and", "any", "are", "as", "at", "be", "by", "can", "do", "does", "for", "from", "get",
    "how", "i", "if", "in", "into", "is", "it", "its", "my", "of", "on", "or", "set", "the", "that", "then",
    "this", "to", "up", "use", "want", "what", "when", "where", "which", "while", "with",
))  # fmt: skip
_ENDINGS = ("ping", "ting", "ning", "ing", "ed", "es", "s")


def search(question: str, tables: Mapping[str, Iterable[Keyword]]) -> tuple[dict[str, list[Keyword]], int]:
    """Return the keywords that share the most words with a question, by language.

    The second result is the number of keywords omitted. A word matches if a keyword's name contains it or its
    description has it in any inflected form. Matches in names come before those in descriptions, then the order
    of the table decides.
    """
    words = [_stem(word) for word in dict.fromkeys(_words(question)) if word not in STOP_WORDS]
    scores: list[tuple[int, int, str, Keyword]] = []
    for language, rows in tables.items():
        for row in rows:
            has = {_stem(word) for word in _words(f"{row.help} {row.group} {row.meant}")}
            named = len([word for word in words if word in row.name.lower()])
            described = [word for word in words if any(_are_similar(word, each) for each in has)]
            count = len({*described, *(word for word in words if word in row.name.lower())})
            scores.append((count, named, language, row))
    best = max((count for count, *_ in scores), default=0)
    if not best:
        return {}, 0
    found: dict[str, list[Keyword]] = {}
    omitted = 0
    for _, _, language, row in sorted(
        (each for each in scores if each[0] == best), key=lambda each: -each[1]
    ):  # stable
        rows_found = found.setdefault(language, [])
        if len(rows_found) < MAX_FOUND:
            rows_found.append(row)
        else:
            omitted += 1
    return {language: found[language] for language in tables if language in found}, omitted


def _words(text: str) -> list[str]:
    return re.findall(r"[a-z]{2,}", text.lower())


def _stem(word: str) -> str:
    for ending in _ENDINGS:
        if word.endswith(ending) and len(word) - len(ending) >= 3:
            return word.removesuffix(ending)
    return word


def _are_similar(one: str, other: str) -> bool:
    """True if one stem begins with the other, such as `mov` and `move`."""
    short, long = sorted((one, other), key=len)
    return one == other or (len(short) >= 3 and long.startswith(short) and len(long) - len(short) <= 2)
