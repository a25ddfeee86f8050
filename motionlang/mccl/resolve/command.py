"""A decoded command: what is left of a piece of text once it has been understood, or why it has not been."""

from __future__ import annotations

from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.keyword import Keyword
    from motionlang.mccl.runtime.task import Action

# What stands after the mnemonic.
NONE, NUMBER, REGISTER, TEXT = range(4)


@record
class Command:
    """`text` as it was written; `axis` 0 where none, or 0, was given; `value` the number, register or text.

    `pure` commands read and write nothing but the accumulator: a loop of them only polls. `action` carries the
    command out; in a command that could not be understood it raises the fault.
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
    def number(self) -> int | None:
        """The parameter where it is a whole number that is known before the program runs."""
        if self.kind == NONE:
            return 0
        if self.kind != NUMBER or self.value != int(self.value):
            return None
        return int(self.value)
