"""The machine file: its valid contents, and every error with its line."""

from __future__ import annotations

import pytest

import motionlang
from motionlang.errors import ProgramError
from motionlang.lang.machine.file import read_machine
from motionlang.source import Source
from tests.machine_page import PAGE, written


def read(text: str) -> dict[str, object]:
    return read_machine(Source("machine.toml", text))


def mistakes(text: str) -> list[tuple[int, int, str, str]]:
    with pytest.raises(ProgramError) as error:
        read(text)
    return [(d.line, d.column, d.message, d.hint) for d in error.value.diagnostics]


def test_keys_and_tables() -> None:
    settings = read(
        """
[controller]
axes = 4
instruction_time = 5e-6
[axis.0]
travel = [-5, 250.0]
[[input]]
channel = 3
at = 1.5
[[input]]
channel = 4
axis = 0
above = 100.0
"""
    )
    assert settings["controller.axes"] == 4
    assert settings["axis.0.travel"] == [-5, 250.0]
    assert settings["input"] == [{"channel": 3, "at": 1.5}, {"channel": 4, "axis": 0, "above": 100.0}]


def test_an_empty_file_is_all_defaults() -> None:
    assert read("") == {}


def test_misspelt_key_is_reported_with_its_line_and_a_suggestion() -> None:
    assert mistakes("[axis.0]\n  travl = [0, 1]\n") == [
        (2, 3, "there is no key axis.0.travl", "did you mean axis.N.travel?")
    ]


def test_all_mistakes_are_reported_in_one_pass() -> None:
    found = mistakes(
        """[controller]
axes = 0
instruction_time = "fast"
[[input]]
channel = -1
whne = 3
[[fault]]
axis = 0
kind = "fire"
"""
    )
    assert [(line, message.split(",")[0]) for line, _, message, _ in found] == [
        (2, "controller.axes must be 1 to 64"),
        (3, "controller.instruction_time must be a time"),
        (5, "channel of [[input]] must be a whole number from 0 to 999"),
        (6, "[[input]] has no key whne"),
        (9, "kind of [[fault]] must be one of following-error"),
    ]


def test_a_missing_key_and_a_contradiction() -> None:
    found = mistakes("[[input]]\nat = 1\nabove = 3\n")
    assert {message for _, _, message, _ in found} == {
        "[[input]] needs channel",
        "[[input]] is active by one trigger only",
        "[[input]] needs an axis",
    }


def test_every_entry_of_a_table_has_its_own_lines() -> None:
    found = mistakes(
        """[[input]]  # the door
channel = 1
at = 1.0

[[ input ]]
at = 2.0 # no channel
[[comms]]
element = 1
value = 2
[[input]]
  channel = -1
  at = 3
[[input]]
channel = 2
above = 1
at = 3
[[comms]]
element = 2
"""
    )
    assert [(line, column, message.split(",")[0]) for line, column, message, _ in found] == [
        (5, 1, "[[input]] needs channel"),
        (11, 3, "channel of [[input]] must be a whole number from 0 to 999"),
        (15, 1, "[[input]] is active by one trigger only"),
        (15, 1, "[[input]] needs an axis"),
        (17, 1, "[[comms]] needs a value or a text"),
    ]


def test_entries_written_as_a_list_have_the_line_of_the_list() -> None:
    assert [line for line, *_ in mistakes("\ninput = [{ channel = 1, at = 1 }, { at = 2 }]\n")] == [2]


def test_what_the_host_writes_is_checked_too() -> None:
    found = mistakes("[[comms]]\nelement = 100\nvalue = 1\n[[netdata]]\nelement = 7\nas = 'word'\n")
    assert [(line, message) for line, _, message, _ in found] == [
        (2, "element of [[comms]] must be 1 to 99, not 100"),
        (4, "[[netdata]] needs a value or a text"),
        (6, "as of [[netdata]] must be one of integer, float, not 'word'"),
    ]


def test_fault_has_one_trigger() -> None:
    found = mistakes("[[fault]]\naxis = 0\nkind = 'error-input'\nline = 12\nat = 1.0\n")
    assert [(line, message, hint) for line, _, message, hint in found] == [
        (4, "[[fault]] occurs by one trigger only", "give at, line, or one of above, below")
    ]


def test_text_that_is_not_toml() -> None:
    ((line, column, message, hint),) = mistakes("axes = = 3\n")
    assert (line, column, hint) == (1, 8, "the machine file must be TOML")
    assert message


def test_machine_file_page_matches_its_vocabulary() -> None:
    assert PAGE.read_text(encoding="utf-8") == written(), "python -m tests.derived writes it anew"


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"controller.axis": 4}, "did you mean controller.axes"),
        ({"controller.axes": "four"}, "must be a whole number"),
    ],
)
def test_settings_of_a_caller_are_held_to_the_same_vocabulary(
    settings: dict[str, object], words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        motionlang.run(Source("hello.mnt", "PRINT 1\n"), machine=settings)


def test_an_input_that_comes_again_is_over_before() -> None:
    text = """\
[[input]]
channel = 1
every = 1.0
[[input]]
channel = 1
for = 2
every = 1.0
times = 3
[[input]]
channel = 1
above = 5
axis = 0
for = 1
every = 2.5
times = 3
[[input]]
channel = 2
axis = 0
between = [10, 20]
every = 10
times = 100000
"""
    again, more = "[[input]] repeats before it ends", "every must be more than"
    assert mistakes(text) == [
        (3, 1, "[[input]] needs a duration to repeat",
         "give for (a duration) or between (two positions of an axis)"),
        (7, 1, again, f"{more} 2"),
        (14, 1, "[[input]] needs a duration to repeat",
         "give for (a duration) or between (two positions of an axis)"),
        (20, 1, again, f"{more} 10"),
        (21, 1, "times of [[input]] must be a whole number from 1 to 10000, not 100000",
         "number of times that it happens in total, 1 to 10000. Default: until the end of the run; with between it is "
         "required"),
    ]  # fmt: skip
