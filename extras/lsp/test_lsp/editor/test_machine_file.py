"""Completion and hover in a machine file agree with docs/machine-file.md."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source
from motionlang_lsp.editor.machine_file import complete_machine_file, hover_machine_file


def completed(text: str) -> list[str]:
    """Return the texts that completion offers at the end of a text."""
    return [each.text for each in complete_machine_file(Source("a.machine.toml", text), len(text))]


def shown(text: str, word: str) -> str | None:
    found = hover_machine_file(Source("a.machine.toml", text), text.rindex(word) + 1)
    return None if found is None else found.markdown


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("[contr", ["controller]"]),
        ("[axis.2.p", ["axis.2.plant]"]),
        ("[[enc", ["encoder]]"]),
        ("[axis.3]\ntra", ["travel = "]),
        ("[axis.3]\nlimits.j", ["limits.jerk = "]),
        ("axis.3.tra", ["axis.3.travel = "]),
        ("[axis.3]\n[[fault]]\nki", ["kind = "]),
        ("[axis.0]\nmotor = ", ['"servo"', '"stepper"']),
        ('[axis.0]\nmotor = "st', ['"stepper"']),
        ("[axis.0]\nguess = ", ["true", "false"]),
        ("[axis.0.plant]\nkind = ", ['"dc"', '"brushless"', '"drive"']),
        ('[[fault]]\nkind = "d', ['"drive"']),
        ('[controller]\nmodel = "dcx-pci', ['"dcx-pci300"', '"dcx-pci100"']),
        ("[axis.0]\n# tra", []),
        ("[axis.0]\ntravel = [0, 1] ", []),
        ("[nothing]\ntra", []),
        ("[mint.values]\n", []),
    ],
)
def test_completion(text: str, found: list[str]) -> None:
    assert completed(text) == found


TRAVEL = "two numbers in brackets", "The positions of the two limit switches, in user units."


@pytest.mark.parametrize(
    ("text", "label", "kind", "detail", "help", "start", "wanted"),
    [
        ("[[enc", "[[encoder]]", "type", "entries", "", 2, "encoder]]"),
        ("\n[axis.2.p", "[axis.2.plant]", "type", "", "", 2, "axis.2.plant]"),
        ("[axis.3]\ntra", "travel", "setting", *TRAVEL, 9, "travel = "),
        ("axis.3.tra", "axis.3.travel", "setting", *TRAVEL, 0, "axis.3.travel = "),
        ("[axis.0]\nguess = t", "true", "constant", "", "", 17, "true"),
        ('[axis.0]\nmotor = "st', "stepper", "constant", "", "", 17, '"stepper"'),
        (
            "[axis.1.plant]\nqu",
            "quantised",
            "setting",
            "one of true, false",
            "true: the encoder gives whole counts. Default false.",
            15,
            "quantised = ",
        ),
    ],
)
def test_a_proposal_replaces_what_was_begun(
    text: str, label: str, kind: str, detail: str, help: str, start: int, wanted: str
) -> None:
    """`start` is where the word or the value begins that the text ends with."""
    (found,) = complete_machine_file(Source("a.machine.toml", text), len(text))
    assert (found.label, found.kind, found.detail, found.help) == (label, kind, detail, help)
    assert (found.start, found.text, found.snippet, found.rank) == (start, wanted, "", 0)


def test_hover_has_meaning_unit_and_default() -> None:
    assert shown("[axis.3]\ntravel = [0, 1]", "travel") == (
        "**axis.3.travel** · two numbers in brackets\n\nThe positions of the two limit switches, in user units."
    )
    assert shown("[[input]]\nchannel = 3", "channel") == (
        "**[[input]] channel** · the number of a channel · required\n\nThe digital input."
    )
    page = shown('[axis.0.plant]\nkind = "dc"', "kind")
    assert page is not None
    assert page.endswith("Default dc.")
    assert "one of dc, brushless, drive" in page


def test_hover_of_a_key_that_any_keyword_may_be() -> None:
    page = shown("[mint.values]\nDRIVEBUSVOLTS = 325", "DRIVE")
    assert page is not None
    assert page.startswith("**mint.values.DRIVEBUSVOLTS**")


def test_there_is_no_page_for_values_comments_and_unknown_keys() -> None:
    assert shown("[axis.3]\ntravel = [0, 1]", "[0") is None
    assert shown("[axis.3]\n# travel = 1", "travel") is None
    assert shown("[axis.3]\ntravvel = 1", "travvel") is None


@pytest.mark.parametrize("before", ["", "  ", "\t", "# travel\n    "])
def test_the_hover_of_a_key_spans_the_key(before: str) -> None:
    text = f"[axis.1]\n{before}travel = 300.0  # uu\n"
    begin = text.rindex("travel = ")
    found = hover_machine_file(Source("a.machine.toml", text), begin + 2)
    assert found is not None
    assert found.span == (begin, begin + len("travel"))
