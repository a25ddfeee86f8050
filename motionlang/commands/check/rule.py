"""A rule of the linter: one kind of code that runs and is probably a mistake."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol


class Warn(Protocol):
    """Records a warning of a rule at an offset of the text, each message once.

    `length` is that of the marked text, 0 for the word or command at the offset; `fix` replaces it.
    """

    def __call__(
        self,
        message: str,
        at: int,
        hint: str = "",
        *,
        candidates: Sequence[str] = (),
        length: int = 0,
        fix: str = "",
    ) -> None: ...


# Looks for a mistake in the facts about a program of one language.
Check = Callable[[Any, Warn], None]


@dataclass(eq=False)
class RuleCase:
    """A rule in one language: its check, a program with the mistake, and the corrected one.

    `check` is None if the kernel reports the mistake. `machine` is the machine file of both programs.
    """

    check: Check | None
    wrong: str
    right: str
    machine: str = ""


@dataclass(eq=False)
class Rule:
    """A rule with its code, its explanation in markdown, and a case for each language that has it.

    `fix` is the sentence of `help CODE` that says what to do.
    """

    code: str
    text: str
    fix: str
    mint: RuleCase | None = None
    mccl: RuleCase | None = None

    @cached_property
    def cases(self) -> Mapping[str, RuleCase]:
        """The cases by the names of their languages."""
        found = {"mint": self.mint, "mccl": self.mccl}
        return {language: case for language, case in found.items() if case is not None}
