"""Generated questions on facts: default, range, type, scale, short form, number."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from motionlang import run
from motionlang.commands.probe.answers import HOLDS, OTHER, read
from motionlang.commands.probe.assumption import REFUSED
from motionlang.commands.probe.facts import of_word
from motionlang.commands.probe.probe import alone
from motionlang.commands.probe.questions import questions
from motionlang.commands.probe.rules import unasked, unsettled_facts
from motionlang.kernel import Source, dialect

if TYPE_CHECKING:
    from motionlang.commands.probe.assumption import Assumption
    from motionlang.kernel import Keyword

NAMES = {"mint": ("probe.mnt", 0), "mccl": ("probe.mcl", 1)}


def word(language: str, name: str) -> Keyword:
    row = dialect(language).table().get(name)
    assert row is not None
    return row


def of(language: str, name: str) -> dict[str, Assumption]:
    """Return the facts of a keyword that have a question, by their names' suffix."""
    begin = f"{language}.{name.lower()}-"
    return {each.name.removeprefix(begin): each for each in unsettled_facts(language, word(language, name))}


def answered(assumption: Assumption, machine: dict[str, object] | None = None) -> str:
    """Return the output of a controller for one question."""
    assert assumption.probe is not None
    name, axis = NAMES[assumption.probe.language]
    result = run(Source(name, alone(assumption, axis)), machine=machine or {})
    assert result.status == "ended", assumption.name
    return "\n".join(result.output)


@pytest.mark.parametrize("language", NAMES)
@pytest.mark.slow
def test_each_question_is_answered_as_the_fact_that_was_taken(language: str) -> None:
    """The program compiles, runs and prints the assumed fact."""
    unsettled = [each for row in dialect(language).table() for each in unsettled_facts(language, row)]
    assert len(unsettled) > 50
    for each in unsettled:
        found = read(answered(each))
        assert [problem.message for problem in found.problems] == [], each.name
        assert [verdict.status for verdict in found.verdicts] == [HOLDS], each.name
        assert each.alternatives, each.name


def test_a_range_is_probed_by_its_last_value_and_one_beyond_it() -> None:
    high = of("mint", "IDLETIME")["range-high"]
    assert (high.question, high.chosen) == ("The greatest value of IDLETIME", "60000")
    assert high.probe is not None
    assert high.probe.before[0] == "fa = 60000"
    assert high.probe.before[2] == "fa = 60001"
    assert "refuses 60001" in answered(high)
    for answer, other in (("refuses 60000", "it ends before 60000"), ("60001", "60001 is taken, too")):
        (verdict,) = read(f"<probe|mint 1>\n<{high.name}|{answer}>\n<end|mint 1>\n").verdicts
        assert (verdict.status, verdict.what) == (OTHER, other)


def test_beyond_a_range_is_a_number_that_a_float_can_distinguish() -> None:
    assert [
        each.probe.before[2] for each in of("mint", "HOMEACCEL").values() if each.probe and each.probe.error
    ] == [
        "fa = 2e+12",
        "fa = 0",
    ]


def test_a_default_of_few_values_names_the_others() -> None:
    few = questions()["mint.idlemode-default"]
    assert few.alternatives == ("1", "2", "3")
    many = questions()["mint.homespeed-default"]
    assert many.alternatives == ("any other number",)
    (verdict,) = read("<probe|mint 1>\n<mint.homespeed-default|1250.0000>\n<end|mint 1>\n").verdicts
    assert (verdict.status, verdict.value) == (OTHER, 1250)


def test_a_scale_is_probed_by_reading_a_value_back_under_another_one() -> None:
    scale = of("mint", "HOMESPEED")["scale"]
    assert "<mint.homespeed-scale|2.5000>" in answered(scale)
    (verdict,) = read("<probe|mint 1>\n<mint.homespeed-scale|5>\n<end|mint 1>\n").verdicts
    assert verdict.what == "no, or it is stored as written"


def test_a_default_that_differs_on_a_controller_is_found() -> None:
    default = questions()["mint.homespeed-default"]
    shown = answered(default, {"assumptions.mint.homespeed-default": 25.0})
    assert [each.value for each in read(shown).verdicts] == [25]


def test_a_short_form_that_the_compiler_rejects_is_answered_by_hand() -> None:
    """A program that does not compile prints nothing, so a person writes the answer."""
    found = read(f"<mint.speed-short|{REFUSED}>\n")
    assert found.problems == []
    assert [each.what for each in found.verdicts] == ["no such short form is known"]


def test_a_board_answers_what_it_does_not_take_with_a_code() -> None:
    low = of("mccl", "SV")["range-low"]
    assert low.probe is not None
    assert (low.probe.ask, low.probe.answers) == ("{a}SV-1", ("?-1", ""))
    assert "?-1" in answered(low)


def test_what_a_source_prints_is_not_asked() -> None:
    assert of_word("mint", word("mint", "SPEED"))["range"].strength == "manual"
    assert "range-high" not in of("mint", "SPEED")


def test_nothing_that_switches_or_moves_is_written() -> None:
    """No output, drive, brake or jog: a probe writes only stored values of an axis."""
    for name in ("DRIVEENABLE", "DRIVEENABLEOUTPUT", "JOG", "MOTORBRAKE", "OUTX", "DAC", "RELAY", "TORQUE"):
        for each in unsettled_facts("mint", word("mint", name)):
            assert each.probe is not None
            assert not any(line.startswith(name) for line in each.probe.before), name


@pytest.mark.parametrize("language", NAMES)
def test_what_the_general_form_leaves_out_is_a_fact_of_its_word(language: str) -> None:
    for name, fact in unasked(language):
        row = word(language, name)
        assert fact in of_word(language, row)
        assert not any(fact in each.name for each in unsettled_facts(language, row) if fact == "range")


def test_a_word_that_is_not_simulated_is_not_asked() -> None:
    row = next(each for each in dialect("mint").table() if not each.simulated)
    assert unsettled_facts("mint", row) == []
