"""Readings that are values: what the machine file's `[readings]` may set, and to what.

What a reading means and why it was chosen is told by its entry in the files of evidence, which no run loads.
"""

from __future__ import annotations

from motionlang.errors import nearest, shown
from motionlang.lang.dialect import PACKAGES, dialect
from motionlang.lang.machine.machine import READINGS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


class Switch:
    """One of `choices`, of which the first is the reading chosen, or a number from `low` to `high`, `whole` or not."""

    __slots__ = ("choices", "high", "low", "whole")

    def __init__(
        self, *choices: object, low: float | None = None, high: float | None = None, whole: bool = False
    ) -> None:
        self.choices, self.low, self.high, self.whole = choices, low, high, whole

    def problem(self, value: object) -> str | None:
        """What is wrong with a value, None where it is one of the alternatives."""
        if self.choices:
            return None if value in self.choices else f"must be {' or '.join(map(shown, self.choices))}"
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not abs(value) < 1e300:
            return "must be a number"
        if self.whole and value != int(value):
            return "must be a whole number"
        if (self.low is not None and value < self.low) or (self.high is not None and value > self.high):
            low, high = (f"{bound:.10g}" if bound is not None else "…" for bound in (self.low, self.high))
            return f"must be {low} to {high}"
        return None


def problem(key: str, value: object) -> tuple[str, str] | None:
    """What is wrong with one key of `[readings]`, and a hint; None when nothing is."""
    name = key.removeprefix(READINGS)
    found = switch(name)
    if found is not None:
        wrong = found.problem(value)
        hint = "motionlang probe tells which holds on a controller; docs/fidelity.md lists the readings"
        return None if wrong is None else (f"the reading {name} {wrong}, not {shown(value)}", hint)
    near = nearest(name, switches())
    hint = f"did you mean {near}?" if near else "docs/fidelity.md lists them, with what each can be set to"
    return f"there is no reading {name} that can be set", hint


def switch(name: str) -> Switch | None:
    """What the reading of a name may be set to, None where no reading has the name or it is no value."""
    language = name.partition(".")[0]
    return dialect(language).switches().get(name) if language in PACKAGES else None


def switches() -> Iterable[str]:
    """The names of all readings that can be set."""
    return [name for language in PACKAGES for name in dialect(language).switches()]
