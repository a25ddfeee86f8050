"""`motionlang probe`: its programs run on the virtual controller, and their answers are read.

What it prints for each kind of question and answer is in `tests/cli/transcripts_probe.txt`.
"""

from __future__ import annotations

import random
import re
import tomllib
from collections.abc import Iterator

import pytest

from motionlang import run
from motionlang.kernel import Source, dialect, read_machine
from tests.cases import cases
from tests.cli.programs import Cell

FILES = {"mint": "probe.mnt", "mccl": "probe.mcl"}
# A wire, a voltage and a server that some of the questions need, as they say themselves.
WIRED = {"input": [{"channel": 0, "output": 0}], "analogue": [{"channel": 0, "value": 50}]}
SERVER = {"modbus.server": [{"id": 4, "registers": {"6": 1}}]}
# This one is answered by a refusal.
REFUSED = "mint.auxencoderzlatch-written"
# With fewer decimals a controller does not print enough to identify its settings.
DECIMALS = range(3, 10)
# Impossible at power-up: a precision mode without a table, blending alongside contours.
IMPOSSIBLE = {"mint.precisionmode-default", "mint.blendmode-default"}


def listed(cell: Cell, language: str) -> Iterator[tuple[str, str]]:
    """Yield the questions of a language: the name of each, and what it needs."""
    for line in cell("probe", language, "--list").out.splitlines():
        name, _, rest = line.partition(" ")
        yield name, rest.rpartition("(")[2]


def answers(language: str, text: str, machine: dict[str, object]) -> list[str]:
    result = run(Source(FILES[language], text), machine=machine)
    assert result.status == "ended"
    return result.output


def read(cell: Cell, lines: list[str]) -> str:
    """Return what is said of answers that are complete."""
    cell.write("log.txt", "\n".join(lines))
    ran = cell("probe", "--answers", "log.txt")
    assert (ran.status, "[answers]" in ran.err) == (0, False), ran.err
    return ran.err


def assert_confirmed(
    cell: Cell, language: str, names: list[str], distances: tuple[str, ...] = ("100",)
) -> None:
    for name in names:
        machine = WIRED | (SERVER if "server" in name else {})
        for distance in distances:
            text = cell("probe", name, "--motion", distance).out
            result = run(Source(FILES[language], text), machine=machine)
            found = read(cell, result.output)
            assert found == f"1 assumption confirmed:\n  {name}\n", (name, distance)
            for move in result.report["moves"]:
                assert all(-1e-6 <= move[key] <= float(distance) + 1e-6 for key in ("start", "end")), name


@pytest.mark.parametrize("language", FILES)
def test_a_question_of_its_own_is_answered_as_assumed(language: str, cell: Cell) -> None:
    """One in sixteen."""
    names = [name for name, needs in listed(cell, language) if "by name" in needs and name != REFUSED]
    assert_confirmed(cell, language, names[::16])


@pytest.mark.slow
@pytest.mark.parametrize("language", FILES)
def test_every_question_of_its_own_is_answered_as_assumed(language: str, cell: Cell) -> None:
    """What moves stays within the distance that is allowed, whatever it is."""
    of_its_own = {name: needs for name, needs in listed(cell, language) if "by name" in needs}
    assert len(of_its_own) > 50
    names = [name for name in of_its_own if name != REFUSED]
    assert_confirmed(cell, language, names)
    moving = [name for name in names if "motion" in of_its_own[name]]
    assert_confirmed(cell, language, moving, ("12.5", "4", "1000"))
    if language == "mint":
        result = run(Source("probe.mnt", cell("probe", REFUSED).out))
        assert (result.status, result.output) == ("fault", [])


def test_a_controller_that_differs_in_a_question_of_its_own_is_found(cell: Cell) -> None:
    found = 0
    for language in FILES:
        for name, needs in listed(cell, language):
            switch = dialect(language).switches().get(name)
            if "by name" in needs and switch is not None:
                text = cell("probe", name, "--motion", "100").out
                for choice in switch.choices[1:]:
                    cell.write("log.txt", "\n".join(answers(language, text, {f"assumptions.{name}": choice})))
                    ran = cell("probe", "--answers", "log.txt")
                    assert tomllib.loads(ran.out)["assumptions"] == {name: choice}
                    found += 1
    assert found >= 6


@pytest.mark.parametrize("language", FILES)
@cases(("options", "axis"), [((), 0), (("--motion", "100"), 0), (("--axis", "2", "--motion", "100"), 2)])
def test_every_chosen_assumption_holds_on_the_virtual_controller(
    language: str, options: tuple[str, ...], axis: int, cell: Cell
) -> None:
    text = cell("probe", language, *options).out
    result = run(Source(FILES[language], text))
    assert re.match(r"\d+ assumptions confirmed:", read(cell, result.output))
    assert "refuted" not in cell("probe", "--answers", "log.txt").err
    axes = {move["axis"] for move in result.report["moves"]}
    assert axes == ({axis + (language == "mccl" and not axis)} if options else set())
    if not options and language == "mint":
        assert re.findall(r"^(?!PRINT)\w+\(.*", text, re.MULTILINE) == []


def another(name: str, draw: random.Random, language: str) -> object:
    """Return a random allowed value of the switch of an assumption."""
    switch = dialect(language).switches()[name]
    if switch.choices:
        return draw.choice(switch.choices)
    if name == "mint.float-decimals":
        return draw.choice(DECIMALS)
    low = max(-1000.0, -1000.0 if switch.low is None else switch.low)
    high = min(1000.0, 1000.0 if switch.high is None else switch.high)
    value = draw.randint(int(4.0 * low + 0.75), int(4.0 * high)) / 4.0
    return round(value) if switch.whole else value


def noise(lines: list[str], draw: random.Random) -> str:
    """Return answers as captured from a terminal.

    They have line ends, time stamps, colours, prompts and a listing.
    """
    end = draw.choice(["\n", "\r\n", "\r"])
    shown = ["\x1b[2J", "Connected.", *lines, "Goodbye."]
    stamp = draw.choice(["", "[12:01:02.345] ", "2026-01-02 12:01:02 "])
    return "".join(f"{stamp}\x1b[0m{line} {end}" for line in shown)


@pytest.mark.parametrize("language", [pytest.param("mint", marks=pytest.mark.slow), "mccl"])
@cases("seed", range(10))
def test_what_differs_on_a_controller_is_found(language: str, seed: int, cell: Cell) -> None:
    """With the machine file that the answers make, the virtual controller gives the same answers."""
    draw = random.Random(seed)
    asked = {name for name, needs in listed(cell, language) if "by name" not in needs} - IMPOSSIBLE
    settings = {
        f"assumptions.{name}": another(name, draw, language)
        for name in dialect(language).switches()
        if draw.random() < 0.5 and name in asked
    }
    if language == "mint":
        settings["controller.instruction_time"] = draw.choice([2e-5, 5e-5, 1e-4])
    text = cell("probe", language).out
    told = answers(language, text, settings)
    found = read(cell, noise(told, draw).split("\n"))
    made = cell("probe", "--answers", "log.txt").out
    answered = dict(read_machine(Source("found.machine.toml", made)))
    assert set(answered) <= set(settings)
    for key, value in answered.items():
        assert value == (pytest.approx(settings[key]) if isinstance(value, float) else settings[key]), key
    left = [key.removeprefix("assumptions.") for key in settings.keys() - answered.keys()]
    assert [name for name in left if re.search(rf"{name}: ", found)] == []
    assert answers(language, text, answered) == told


@pytest.mark.parametrize("language", FILES)
def test_answers_that_are_cut_off_or_in_another_order(language: str, cell: Cell) -> None:
    lines = answers(language, cell("probe", language).out, {})
    cell.write("log.txt", "\n".join(lines[:20]))
    ran = cell("probe", "--answers", "log.txt")
    assert ran.status == 1
    assert "the end of the answers is missing" in ran.err
    assert "refuted" not in ran.err
    if language == "mint":
        straight = read(cell, lines)
        assert read(cell, lines[::-1]) == straight
        listing = cell("probe", language).out.splitlines()
        echoed = [each for pair in zip(listing, lines, strict=False) for each in pair]
        assert read(cell, echoed + lines) == straight
