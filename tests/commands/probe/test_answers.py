"""Answers to a probe: comparison, problems, and the machine file made of them."""

from __future__ import annotations

import pytest

from motionlang.commands.probe.answers import HOLDS, OTHER, UNKNOWN, is_answer, machine_text, read
from motionlang.commands.probe.assumption import REFUSED
from motionlang.commands.probe.probe import Motion, as_shown, mark


@pytest.mark.parametrize(
    ("expected", "answer", "fits"),
    [
        ("1", "1.0000", True),
        ("1", "1.4", False),
        ("1", "1.04", False),
        ("1", "1.0000000004", True),
        ("1", "1.0000000006", False),
        ("2.5 yes", "2.50 yes", True),
        ("2.5 yes", "2.5", False),
        ("yes", "no", False),
        # Half a unit of the last digit that both have: 0.05, 0.005.
        ("2.5", "2.55", True),
        ("2.5", "2.56", False),
        ("2.50", "2.505", True),
        ("2.505", "2.50", True),
        ("2.50", "2.506", False),
        ("2.50e0", "2.505", True),
        # An exponent has six digits at least.
        ("100000", "1E5", True),
        ("1000000", "1.0000009e6", True),
        ("1000000", "1.0000011e6", False),
        ("1.0000009e6", "1000000", False),
        (r"re:\d+", "12", True),
        (r"re:\d+", "12 13", False),
    ],
)
def test_numbers_are_compared_by_value(expected: str, answer: str, fits: bool) -> None:
    assert is_answer(expected, answer) is fits


def lines_of(*answers: tuple[str, str], count: int | None = None) -> list[str]:
    number = len(answers) if count is None else count
    return [
        f"<probe|mint {number}>",
        *(f"<{name}|{answer}>" for name, answer in answers),
        f"<end|mint {number}>",
    ]


# A name, an answer, the status of the assumption, and the value that is set.
VALUES = (
    ("mint.homespeed-default", "4000.0000", HOLDS, None),
    ("mint.homespeed-default", "4000.000003", HOLDS, None),
    ("mint.homespeed-default", "4000.000005", OTHER, 4000.000005),
    ("mint.homespeed-default", "77.0000", OTHER, 77),
    ("mint.homespeed-default", "0.12345678949", OTHER, 0.1234567895),
    ("mint.homespeed-default", "fast", UNKNOWN, None),
    ("mint.idlemode-default", "0", HOLDS, None),
    ("mint.float-decimals", "1.5000", HOLDS, None),
    ("mint.float-decimals", "1.50", OTHER, 2),
    ("mint.statement-time", "100", HOLDS, None),
    ("mint.statement-time", "250", OTHER, 2.5e-05),
    ("mint.truth", "1 1", HOLDS, None),
    ("mint.truth", "1", UNKNOWN, None),
    ("mint.float-precision", "0", OTHER, None),
)


@pytest.mark.parametrize(("name", "answer", "status", "value"), VALUES)
def test_an_answer_has_a_status_and_a_value(name: str, answer: str, status: str, value: object) -> None:
    found = read("\n".join(lines_of((name, answer))))
    assert found.problems == []
    (verdict,) = found.verdicts
    assert (verdict.status, verdict.value, verdict.can_be_set) == (status, value, value is not None)
    assert type(verdict.value) is type(value)


MIXED = (
    ("mint.truth", "1 1"),
    ("mint.float-precision", "0"),
    ("mint.statement-time", "200"),
    ("mint.float-decimals", "1.50"),
    ("mint.homespeed-default", "77"),
    ("mint.precedence", "yes"),
)
MACHINE = """\
# Answers of a controller in log.txt: 1 assumption confirmed, 4 refuted, 1 answer unknown.

[assumptions]
"mint.float-decimals" = 2  # Decimals of a Float
"mint.homespeed-default" = 77  # What HOMESPEED is until a program writes it

[controller]
instruction_time = 2e-05  # What a statement costs

# Also refuted, but without a key to set:
# mint.float-precision: IEEE single (answered 0)
"""


def test_a_machine_file_has_what_differs() -> None:
    found = read("\n".join(lines_of(*MIXED)))
    assert found.problems == []
    assert machine_text(found, "log.txt") == MACHINE
    assert machine_text(read("\n".join(lines_of(MIXED[0], ("mint.idlemode-default", "0")))), "a") == (
        "# Answers of a controller in a: 2 assumptions confirmed, 0 refuted, 0 answers unknown.\n"
    )


TRUTH, SPEED = MIXED[0], MIXED[4]
COUNTS = "what is here counts"
# The lines of a terminal, and the problems: message, hint, line, severity.
PROBLEMS: tuple[tuple[list[str], list[tuple[str, str, int, str]]], ...] = (
    (lines_of(TRUTH), []),
    (lines_of(TRUTH, count=0), []),
    (lines_of(TRUTH, count=2), [("1 of 2 questions have no answer", COUNTS, 0, "warning")]),
    (lines_of(TRUTH)[1:], [("the beginning of the answers is missing: 1 were found", COUNTS, 0, "error")]),
    (lines_of(TRUTH)[:-1], [("the end of the answers is missing: 1 were found", COUNTS, 0, "error")]),
    # A program that is refused prints neither.
    ([f"<mint.speed-short|{REFUSED}>"], []),
    (
        lines_of(SPEED, TRUTH, ("mint.homespeed-default", "78"), ("mint.homespeed-default", "79"), count=2),
        [("mint.homespeed-default is answered twice, by '77' and '78'", "keep one of them", 4, "error")],
    ),
    (lines_of(SPEED, SPEED, count=1), []),
    (
        lines_of(TRUTH, ("mint.nothing", "5"), count=1),
        [("mint.nothing is no reading", "was the probe written by another version?", 3, "error")],
    ),
    (
        [*lines_of(TRUTH), "<mint.float-decimals|1.5"],
        [("the answer to mint.float-decimals is cut off", "", 4, "error")],
    ),
    # The echo of a line with a mark, and of a remark, is no answer.
    (
        [
            f"{mark('probe')}",
            "1",
            f"AL{mark('mccl.gain-default')},TR0",
            f"{mark('mccl.gain-default')}",
            "; gain",
            "01 0.2",
            f"AL{mark('end')},TR0",
            f"{mark('end')}",
        ],
        [],
    ),
    # A mark may follow a prompt, and so does the echo of a line.
    (
        [f">{mark('probe')}", "1", f"> {mark('mccl.gain-default')}", ">1TG", "01 0.2", f">{mark('end')}"],
        [],
    ),
    (
        [f"{mark('probe')}", "1", f"{mark('mccl.gain-default')}", "01 0.2", f"{mark('mccl.quotient')}"],
        [
            ("the answer to mccl.quotient is cut off", "", 5, "error"),
            ("the end of the answers is missing: 1 were found", COUNTS, 0, "error"),
        ],
    ),
)


@pytest.mark.parametrize(("lines", "problems"), PROBLEMS)
def test_what_is_wrong_with_answers(lines: list[str], problems: list[tuple[str, str, int, str]]) -> None:
    found = read("\n".join(lines))
    assert [each.answer for each in found.verdicts if each.assumption.name == "mccl.gain-default"] in (
        [],
        ["01 0.2"],
    )
    assert [(each.message, each.hint, each.line, each.severity) for each in found.problems] == problems


@pytest.mark.parametrize(
    ("distance", "step"), [(100.0, 25.0), (10.0, 2.0), (4.0, 1.0), (3.0, 0.75), (7.9, 1.0)]
)
def test_a_question_moves_by_a_quarter_of_the_distance(distance: float, step: float) -> None:
    """It is a whole number if the distance is 4 or more."""
    assert Motion(0, distance).step == step


@pytest.mark.parametrize(
    ("answer", "text"),
    [(r"re:(\S+) \1", "… the same"), (REFUSED, "(the compiler refuses it)"), ("", "(nothing)"), ("re", "re")],
)
def test_an_answer_is_shown_without_a_pattern(answer: str, text: str) -> None:
    assert as_shown(answer) == text
