"""Errors as values: their fields in a report, hints, and texts of limited length."""

from __future__ import annotations

import pytest

from motionlang.kernel import Diagnostic, ProgramError, Terminated
from motionlang.kernel.tools import MissingExtra, Spellings, as_hint, clipped, missing, nearest, shown


def test_a_diagnostic_in_a_report() -> None:
    """Occurrences are counted from the second one on."""
    found = Diagnostic("range", "too large")
    fields = {
        "severity": "error",
        "code": "range",
        "message": "too large",
        "line": 0,
        "column": 0,
        "hint": "",
    }
    assert found.as_dict() == fields
    assert (found.length, found.first, found.last, found.fix, found.candidates) == (1, 0.0, 0.0, "", ())
    found.again(2.5)
    assert found.as_dict() == fields | {"count": 2, "first_time": 0.0, "last_time": 2.5}
    found.again(3.5)
    assert found.as_dict() == fields | {"count": 3, "first_time": 0.0, "last_time": 3.5}


def test_the_errors_of_a_program_are_in_the_order_of_its_text() -> None:
    positions = [(3, 1), (1, 7), (1, 2)]
    error = ProgramError(Diagnostic("syntax", f"at {at}", *at) for at in positions)
    assert [(each.line, each.column) for each in error.diagnostics] == [(1, 2), (1, 7), (3, 1)]
    assert str(error) == "line 1: at (1, 2); line 1: at (1, 7); line 3: at (3, 1)"


def test_a_signal_has_the_exit_status_of_a_shell() -> None:
    assert (Terminated(15).code, Terminated(15).number) == (143, 15)


@pytest.mark.parametrize(("length", "text"), [(61, "x" * 61), (62, "x" * 60 + "…")])
def test_a_value_in_a_message_has_at_most_61_characters(length: int, text: str) -> None:
    assert clipped("x" * length) == text


def test_a_number_without_a_text_is_described() -> None:
    assert shown(10**5000) == "the text there"
    assert shown("a\nb") == "'a\\nb'"


# A word, known words, and the one that was probably meant. The ratio of two words is twice the number of equal letters
# by the number of all letters, 0.6 at least.
MEANT: tuple[tuple[str, list[str], str | None], ...] = (
    ("spede", ["SPEED", "SPREAD"], "SPEED"),
    ("spd", ["SPEED"], "SPEED"),
    ("psx", ["POS"], None),
    ("goo", ["GO"], "GO"),
    # Each means a function that Mint has not.
    ("hex", ["HELIXR"], None),
    ("bin", ["IN"], None),
    ("oct", ["OUT"], None),
    ("pow", ["POS"], None),
    ("ab", ["abcd", "xy"], "abcd"),  # 2 · 2 / 6
    ("abc", ["abcdefg"], "abcdefg"),  # 2 · 3 / 10
    ("abc", ["abcdefgh"], None),  # 2 · 3 / 11
    ("abxxx", ["abyy"], None),  # 2 · 2 / 9
    ("", ["a"], None),
    ("", [""], None),
    ("a", [], None),
    ("q", ["w"], None),
)


@pytest.mark.parametrize(("word", "words", "meant"), MEANT)
def test_the_word_that_was_probably_meant(word: str, words: list[str], meant: str | None) -> None:
    assert nearest(word, words) == meant


def test_a_stricter_cutoff_leaves_out_what_is_less_similar() -> None:
    assert Spellings(["abcd"]).nearest("abcx", 0.75) == "abcd"  # 2 · 3 / 8
    assert Spellings(["abcd"]).nearest("abcx", 0.76) is None


@pytest.mark.parametrize(
    ("description", "hint"),
    [
        ("Show this list.", "show this list"),
        ("A move.", "a move"),
        ("MOVER moves.", "MOVER moves"),
        ("X = 5.", "x = 5"),
        ("I.", "I"),
        ("", ""),
    ],
)
def test_a_description_as_a_hint(description: str, hint: str) -> None:
    assert as_hint(description) == hint


def test_a_missing_library_is_named_with_its_extra() -> None:
    several = MissingExtra("--plot", ["matplotlib", "pyarrow"])
    assert (several.message, several.hint, several.is_required) == (
        "--plot needs matplotlib and pyarrow", 'python -m pip install "motionlang[plot]"', False,
    )  # fmt: skip
    assert str(several) == f"{several.message}: {several.hint}"
    required = missing(ImportError("no numpy", name="numpy"), "motionlang servo")
    assert required is not None
    assert (required.message, required.hint, required.is_required) == (
        "motionlang servo needs numpy", "python -m pip install numpy", True,
    )  # fmt: skip
    assert missing(several, "motionlang run") is several
    assert missing(ImportError("no polars", name="polars"), "motionlang run") is None
    assert missing(ValueError("numpy"), "motionlang run") is None
