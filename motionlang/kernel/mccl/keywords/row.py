"""Construction of the rows of this table, with their common defaults."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from motionlang.kernel.lang.keyword import Actions, Keyword

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask

Action = TypeVar("Action", bound=Callable[..., Any])


def pure(action: Action) -> Action:
    """Mark an action that affects only the accumulator."""
    action.pure = True  # type: ignore[attr-defined]
    return action


def written(action: Action) -> Action:
    """Mark a function that writes the steps of a command, for one that is more than an operation."""
    action.written = True  # type: ignore[attr-defined]
    return action


def accumulator(way: str) -> Callable[[Action], Action]:
    """Mark how a pure action treats the accumulator; without a mark it leaves it alone.

    It "sets" it, "reads" a value of the machine into it, "adds" to it, "computes" with it, "compares" it with a number,
    "tests" a bit of it, "stores" it in a register, or "recalls" it from one.
    """

    def mark(action: Action) -> Action:
        action.accumulator = way  # type: ignore[attr-defined]
        return action

    return mark


def forms(row: Keyword) -> tuple[str, ...]:
    """Return the spellings of a command, as in TN1069: a is an axis, n a number.

    A missing number is 0, so a command that accepts 0 has a form without it. A command that only replies has
    no forms: the syntax after it depends on what it reads.
    """
    bare = f"{'a' if row.index in ('axis', 'axes') else ''}{row.name}"
    if row.access == "C":
        return (bare,)
    if row.access != "W":
        return ()
    if row.unit == "text":
        return (f'{bare}"text"',)
    is_optional = (row.low is None or row.low <= 0) and (row.high is None or row.high >= 0)
    return (bare, f"{bare}n") if is_optional else (f"{bare}n",)


def takes_number(row: Keyword) -> bool:
    """True if a command uses the number behind it: a command that reports does so if its number has a range."""
    return row.access == "W" or (row.access == "R" and row.low is not None)


def not_simulated(task: CommandTask, command: Command) -> None:
    """Warn once that a command, which the board would accept, has no effect here."""
    assert command.row is not None
    task.board.warn(
        task,
        "not-simulated",
        f"{command.name} is not simulated: the command has no effect",
        command.row.help,
    )


class Group:
    """Creates the rows of one group."""

    def __init__(self, title: str) -> None:
        self.title = title

    def row(
        self,
        name: str,
        kind: str,
        access: str,
        index: str,
        unit: str,
        action: Actions | Callable[..., Any],
        help: str,
        example: str,
        **columns: Any,
    ) -> Keyword:
        """Return one simulated command, called by the name of its function; `columns` are further ones of `Keyword`."""
        made = action if isinstance(action, Actions) else Actions(action.__name__, do=action)
        return Keyword(name, "", kind, access, index, unit, made, help, example, group=self.title, **columns)

    def known(self, name: str, kind: str, index: str, help: str) -> Keyword:
        """Return a command that is recognized and answered as not simulated."""
        return Keyword(
            name,
            "",
            kind,
            "W",
            index,
            "",
            Actions(do=not_simulated),
            help,
            group=self.title,
            simulated=False,
        )
