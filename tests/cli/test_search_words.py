"""Which words of a question match which words of a keyword's description."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.help.keyword_search import MAX_FOUND, search
from tests.cases import cases


def row(name: str, help: str, group: str = "") -> Any:
    return SimpleNamespace(name=name, help=help, group=group, meant="")


# A word of a question, one of a description, and True if they match. An ending is removed if three letters remain;
# then one stem has to begin with the other, and be at most two letters shorter.
WORDS = (
    ("moved", "moving", True),  # mov and mov
    ("limiting", "limit", True),  # limi and limit
    ("used", "us", False),  # two letters would remain
    ("abed", "abing", False),
    ("stop", "stopping", True),
    ("axes", "axis", False),  # axe and axis
    ("ramp", "rampart", False),  # three letters more
    ("ramp", "rampxy", True),
    ("ram", "ramp", True),
    ("ra", "ram", False),
    ("motions", "motion", True),
)


@cases("asked, described, is_found", WORDS)
def test_inflected_words_match(asked: str, described: str, is_found: bool) -> None:
    found, omitted = search(asked, {"mint": [row("X", described)]})
    assert (bool(found), omitted) == (is_found, 0)


def test_the_best_matches_are_listed_names_first() -> None:
    """Both words match four rows; a name with `stop` comes first, then the others."""
    both = [row("A", "Stop at the input."), row("B", "A stop.", "inputs"), row("STOPIN", "An input.")]
    rows = [row("C", "An input."), *both, row("D", "Nothing.")]
    found, omitted = search("how to stop at an input, the stop", {"mccl": [row("E", "Input.")], "mint": rows})
    assert {language: [each.name for each in each_found] for language, each_found in found.items()} == {
        "mint": ["STOPIN", "A", "B"]
    }
    assert omitted == 0


@pytest.mark.parametrize(
    ("count", "shown", "omitted"), [(MAX_FOUND, MAX_FOUND, 0), (MAX_FOUND + 1, MAX_FOUND, 1)]
)
def test_each_language_has_twelve_at_most(count: int, shown: int, omitted: int) -> None:
    rows = [row(f"A{number}", "jerk") for number in range(count)]
    found, left = search("jerk", {"mint": rows, "mccl": rows[:2]})
    assert [(language, len(each)) for language, each in found.items()] == [("mint", shown), ("mccl", 2)]
    assert left == omitted


def test_stop_words_alone_find_nothing() -> None:
    assert search("what is the", {"mint": [row("THE", "What is the")]}) == ({}, 0)
