"""Open assumptions have alternatives and probes; the exceptions may only decrease."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang import run
from motionlang.commands.probe.answers import HOLDS, OTHER, is_answer, read
from motionlang.commands.probe.assumption import REFUSED, Assumption
from motionlang.commands.probe.entries import assumptions
from motionlang.commands.probe.probe import Motion, alone
from motionlang.kernel import Source, read_machine
from motionlang.kernel.lang import switch

# Assumptions about the line or bus of a host, which no program on a controller can settle.
ON_THE_LINE = 20
# Open assumptions about a controller without an alternative, and those without a probe.
WITHOUT_ALTERNATIVES, WITHOUT_PROBE = 0, 185 + ON_THE_LINE
# The number of assumptions that no controller can confirm, because they are choices of this program.
OWN = 63
# The assumptions about PMC's library for hosts. A log that it records answers them, not a program on a controller.
OF_HOSTS = 24
NAMES = {"mint": ("probe.mnt", 0), "mccl": ("probe.mcl", 1)}
DISTANCE = 100.0


def open_ones() -> list[Assumption]:
    """Return the open assumptions that a controller can confirm."""
    return [each for each in assumptions().values() if each.is_open and not each.own]


def by_name() -> list[Assumption]:
    """Return the assumptions that have a probe of their own."""
    return [each for each in assumptions().values() if each.probe is not None and each.probe.alone]


def text_of(assumption: Assumption) -> Source:
    assert assumption.probe is not None
    name, axis = NAMES[assumption.probe.language]
    return Source(name, alone(assumption, axis, Motion(axis, DISTANCE) if assumption.probe.motion else None))


def machine_of(assumption: Assumption) -> dict[str, object]:
    """Return the machine settings that a probe needs, from its entry."""
    assert assumption.probe is not None
    return read_machine(Source("probe.machine.toml", assumption.probe.machine))


def test_assumptions_without_alternatives_become_fewer() -> None:
    assert sum(not each.alternatives for each in open_ones()) == WITHOUT_ALTERNATIVES


def test_assumptions_that_no_program_settles_become_fewer() -> None:
    without = [each.name for each in open_ones() if each.probe is None]
    of_hosts = [name for name in without if name.startswith("mcapi.")]
    assert (len(without) - len(of_hosts), len(of_hosts)) == (WITHOUT_PROBE, OF_HOSTS)


def test_what_is_our_own_is_asked_of_no_controller() -> None:
    own = [each for each in assumptions().values() if each.own]
    assert len(own) == OWN
    for each in own:
        assert each.is_open, each.name
        assert each.probe is None, each.name


def test_each_answer_is_distinct_and_belongs_to_an_alternative() -> None:
    for each in assumptions().values():
        if each.probe is None or each.probe.form:
            continue
        assert len(each.probe.answers) <= 1 + len(each.alternatives), each.name
        plain = [answer for answer in each.probe.answers if not answer.startswith("re:")]
        for answer in plain:
            assert sum(is_answer(other, answer) for other in each.probe.answers) == 1, (each.name, answer)


@pytest.mark.parametrize("each", by_name(), ids=lambda each: each.name)
def test_a_question_of_its_own_is_answered_as_assumed(each: Assumption) -> None:
    """The probe compiles, runs and prints the answer, or is rejected as stated."""
    assert each.probe is not None
    source = text_of(each)
    if each.probe.answers[0] == REFUSED:
        result = run(source, machine=machine_of(each))
        assert (result.status, result.output) == ("fault", [])
        return
    result = run(source, machine=machine_of(each))
    found = read("\n".join(result.output))
    assert [problem.message for problem in found.problems] == []
    assert {verdict.answer: verdict.status for verdict in found.verdicts} == {found.verdicts[0].answer: HOLDS}


@pytest.mark.parametrize("distance", [12.5, 4.0, 1000.0])
@pytest.mark.parametrize(
    "each",
    [each for each in assumptions().values() if each.probe and each.probe.motion],
    ids=lambda each: each.name,
)
def test_a_question_fits_any_distance_that_is_allowed(each: Assumption, distance: float) -> None:
    """The virtual controller confirms its own assumption at any distance."""
    assert each.probe is not None
    name, axis = NAMES[each.probe.language]
    result = run(Source(name, alone(each, axis, Motion(axis, distance))), machine=machine_of(each))
    (verdict,) = read("\n".join(result.output)).verdicts
    assert (verdict.assumption.name, verdict.status) == (each.name, HOLDS), verdict.answer


def switched() -> list[tuple[Assumption, object]]:
    """Return assumptions with a probe and a switch, each with its alternative values."""
    return [
        (each, choice)
        for each in by_name()
        if each.key and (found := switch(each.name)) is not None
        for choice in found.choices[1:]
    ]


@pytest.mark.parametrize(("each", "choice"), switched(), ids=lambda each: getattr(each, "name", each))
def test_a_controller_that_differs_is_found_and_can_be_configured(each: Assumption, choice: object) -> None:
    machine = machine_of(each) | {each.key: choice}
    (verdict,) = read("\n".join(run(text_of(each), machine=machine).output)).verdicts
    assert (verdict.status, verdict.value) == (OTHER, choice)


@pytest.mark.parametrize("each", by_name(), ids=lambda each: each.name)
def test_every_other_answer_names_its_alternative(each: Assumption) -> None:
    assert each.probe is not None
    for answer, alternative in zip(each.probe.answers[1:], each.alternatives, strict=False):
        if not answer.startswith("re:") and answer and each.probe.language == "mint":
            (verdict,) = read(f"<probe|mint 1>\n<{each.name}|{answer}>\n<end|mint 1>\n").verdicts
            assert (verdict.status, verdict.what) == (OTHER, alternative)


@pytest.mark.parametrize(
    "each", [each for each in by_name() if each.probe and each.probe.motion], ids=lambda each: each.name
)
def test_what_moves_stays_within_the_distance_that_is_allowed(each: Assumption) -> None:
    result = run(text_of(each), machine=machine_of(each))
    assert result.report["moves"]
    for move in result.report["moves"]:
        assert all(-1e-6 <= move[key] <= DISTANCE + 1e-6 for key in ("start", "end")), move


def test_what_a_probe_needs_is_stated_in_words() -> None:
    for each in by_name():
        assert each.probe is not None
        if each.probe.machine:
            assert each.probe.needs, each.name
        assert not re.search(r"[.]$", each.probe.needs), each.name


def test_the_page_of_probes_names_the_options() -> None:
    page = (Path(__file__).parents[3] / "docs" / "probe.md").read_text(encoding="utf-8")
    for option in ("--list", "--motion", "--skip", "--axis", "--answers"):
        assert option in page
