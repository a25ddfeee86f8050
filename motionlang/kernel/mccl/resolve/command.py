"""A decoded command, or the fault of a text that is not a command."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.task import Action

# The kinds of parameters.
NONE, NUMBER, REGISTER, TEXT = range(4)


@dataclass(eq=False, slots=True)
class Command:
    """A command of a line, ready to run.

    `text` is the source text. `axis` is 0 if none was given. `value` is the number, register or text.
    `pure` commands read and write only the accumulator: a loop of them only polls. `action` executes the
    command; for an invalid command it raises the fault.
    """

    text: str
    name: str
    row: Keyword | None
    axis: int
    kind: int
    value: float | int | str
    action: Action
    pure: bool

    def __repr__(self) -> str:
        return f"Command({self.text!r})"

    @property
    def function(self) -> str:
        """The function of its keyword, "" for an invalid command."""
        return self.row.function if self.row is not None else ""

    @property
    def is_bare(self) -> bool:
        """True if it has no parameter, which then counts as 0."""
        return self.kind == NONE

    @property
    def reads(self) -> str:
        """The kind of value that it reads, as `Keyword.reads`; "" if none."""
        kind = "" if self.row is None else self.row.reads
        return kind or ("variable" if self.kind == REGISTER else "")

    @property
    def number(self) -> int | None:
        """The parameter, if it is an integer known before the program runs."""
        if self.kind == NONE:
            return 0
        if self.kind != NUMBER or self.value != int(self.value):
            return None
        return int(self.value)
