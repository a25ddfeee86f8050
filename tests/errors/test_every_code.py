"""Every code of a diagnostic, of a rejected command and of a reply is shown by a program in text.

The programs are those of `tests/spec`, `tests/errors`, `tests/lint` and `tests/states`.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from motionlang.kernel import CODES
from motionlang.kernel.mccl import MEANINGS
from motionlang.kernel.mint import NUMBERS
from tests.spec.cases import cases, files

TESTS = Path(__file__).parents[1]
# Codes that no program leads to, each with its reason.
NOT_BY_A_PROGRAM = {
    "address": "a server cannot be started or reached",
    "beyond-limit": "the command certify finds it",
    "budget": "the command profile compares a run with the budget of its machine file",
    "crash": "an internal error",
    "extra": "a library is not installed",
    "file": "a file cannot be read or written",
    "golden": "the command verify finds it",
    "interrupted": "Ctrl-C or a signal",
    "option": "an option of the command line",
    "recording": "the command compare reads a recording",
    "window": "a command draws or traces a part of a run",
}
# Numbers of MCCL's replies that no program leads to: no error, no serial port, Escape at a prompt.
NOT_REPLIED = {0, 3, -7}


@cache
def shown() -> set[str]:
    """Return the codes of all diagnostics in the texts."""
    found: set[str] = set()
    for path in [*TESTS.glob("errors/*/*.txt"), *TESTS.glob("lint/*/*.txt")]:
        found |= set(re.findall(r"^(?:error|warning)\[([a-z-]+)\]", path.read_text("utf-8"), re.MULTILINE))
    for path in TESTS.glob("states/*.txt"):
        found |= set(re.findall(r": refused: ([a-z-]+)", path.read_text("utf-8")))
    for case in (case for path in files() for case in cases(path)):
        found |= {each[1] for text in case.texts("?") if (each := re.match(r"(?:\d+ )?([a-z-]+)", text))}
    return found


def test_every_code_of_a_diagnostic_is_shown_by_a_program() -> None:
    assert sorted(set(CODES) - shown() - set(NOT_BY_A_PROGRAM)) == []
    assert sorted(shown() & set(NOT_BY_A_PROGRAM)) == []


def test_every_error_of_mint_is_shown_by_a_program() -> None:
    assert sorted(set(NUMBERS) - shown()) == []


def test_every_reply_of_mccl_is_shown_by_a_program() -> None:
    replies = {text for path in files() for case in cases(path) for text in case.texts(">")}
    assert {code for code in MEANINGS if f"?{code}" not in replies} == NOT_REPLIED
