"""Generated programs have every simulated keyword of both languages: a sample."""

from __future__ import annotations

import pytest

from tests import cases
from tests.generated.__main__ import main
from tests.generated.checks import findings
from tests.generated.draw import table
from tests.generated.motion import generate
from tests.generated.words import NEVER, examples, simulated, words

# Seeds of the sample in CI, and of a long run in batches.
FIRST, SLICE, BATCHES, BATCH = 1, 40, 20, 500


def test_programs_of_a_slice_of_seeds_have_no_finding() -> None:
    for seed in range(FIRST, FIRST + cases.examples(SLICE)):
        assert findings(generate(seed, "words")) == [], f"--family words --show {seed}"


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_of_many_seeds_have_no_finding(batch: int) -> None:
    first = 10_000 + batch * BATCH
    programs = {seed: generate(seed, "words") for seed in range(first, first + BATCH)}
    assert {seed: messages for seed, program in programs.items() if (messages := findings(program))} == {}


@pytest.mark.parametrize("language", NEVER)
def test_each_simulated_word_is_in_an_example_that_is_drawn_or_has_its_reason(language: str) -> None:
    drawn = {name for row in examples(language) for name in words(language, row.example)}
    assert simulated(language) - drawn == NEVER[language].keys()


def test_words_are_counted_by_their_rows() -> None:
    assert table("mint")["SPEED"].short == "SP"
    assert words("mint", 'sp(0) = 5 : PRINT "ACCEL", Sin(2) \' DECEL\n') == {"SPEED", "Print", "Sin"}
    assert words("mccl", '1MR50,WA0.1,FD"MA"\n') == {"MR", "WA", "FD"}


def test_the_count_lists_the_rarest_first(capsys: pytest.CaptureFixture[str]) -> None:
    """Every Mint program sets SPEED; a keyword missing from all twenty has no reason."""
    count = sum(generate(seed, "words").language == "mint" for seed in range(1, 21))
    assert main(["20", "--family", "words", "--words"]) == 1
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert len(lines) == len(simulated("mint")) + len(simulated("mccl"))
    assert lines[0] == ["mint", "ABORT", "0", "no", "reason"]
    assert ["mint", "SPEED", str(count)] in lines
