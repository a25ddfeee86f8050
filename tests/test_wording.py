"""The tool that counts banned words finds them outside of quotations and code."""

from __future__ import annotations

from tests.cases import cases
from tests.wording import Text, instead


@cases(
    ("text", "banned"),
    [
        ("nobody waits", ["nobody"]),
        ("the axis stands at 0", ["stands"]),
        ("`name` stands for an expression", []),
        ('the manual says "the axis stands"', []),
        ("each turn of the loop", ["each turn"]),
        ("each turn on of a drive", []),
        ("BESIDE is a keyword", []),
        ("by `kept` values", []),
        ("see [the page](docs/kept.md)", []),
    ],
)
def test_a_banned_word_is_found_outside_of_quotations(text: str, banned: list[str]) -> None:
    assert Text("comment", "a.py", 1, text).found() == banned
    assert all(instead(word) for word in banned)
