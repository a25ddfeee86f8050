"""A sub called as in another Basic: the message shows how Mint calls it."""

from __future__ import annotations

import pytest

from motionlang import Source, check

SUB = "End\nSub Feed(x)\nPRINT x\nEnd Sub\n"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("Call feed(3)", "Call is neither a keyword nor a sub of this program"),
        ("Gosub feed", "Feed is a sub, not a label"),
        ("Goto feed", "Feed is a sub, not a label"),
    ],
)
def test_the_hint_is_the_name_of_the_sub(line: str, message: str) -> None:
    found = [each for each in check(Source("a.mnt", f"{line}\n{SUB}")) if each.severity == "error"]
    assert [(each.line, each.code, each.message) for each in found] == [(1, "unknown-word", message)]
    assert found[0].hint == "a sub is called by its name alone: Feed"


def test_another_word_after_call_is_no_sub() -> None:
    (found,) = [each for each in check(Source("a.mnt", "Call OUT(1)\n")) if each.severity == "error"]
    assert found.hint == "a sub is called by its name alone"


def test_missing_label_has_a_suggestion() -> None:
    (found,) = check(Source("a.mnt", "Goto backk\n#back\nPRINT 1\n"))[:1]
    assert (found.message, found.hint) == ("there is no label backk", "did you mean back?")
