"""Assumptions that the machine file's `[assumptions]` can set, with their values.

The evidence files, which are not loaded in a run, explain each assumption and the reason for its default.
"""

from __future__ import annotations

from collections.abc import Iterable

from motionlang.kernel.lang.dialect import PACKAGES, dialect
from motionlang.kernel.tools import nearest, shown

# The section of the assumptions that the owner of a controller has settled.
ASSUMPTIONS = "assumptions."

# The list of all assumptions, with their names and alternatives.
LIST = "docs/contributing/assumptions.md"


class Switch:
    """The allowed values of an assumption: one of `choices`, or a number in a range.

    The first choice is the default. A number lies from `low` to `high`, and is an integer if `whole` is set.
    """

    def __init__(
        self, *choices: object, low: float | None = None, high: float | None = None, whole: bool = False
    ) -> None:
        self.choices, self.low, self.high, self.whole = choices, low, high, whole

    def problem(self, value: object) -> str | None:
        """Return the problem of a value, or None if it is allowed."""
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
    """Return the problem of a key of `[assumptions]` and a hint; None if it is valid."""
    name = key.removeprefix(ASSUMPTIONS)
    found = switch(name)
    if found is not None:
        wrong = found.problem(value)
        hint = f"{LIST} has the choices"
        return None if wrong is None else (f"the assumption {name} {wrong}, not {shown(value)}", hint)
    near = nearest(name, switches())
    hint = f"did you mean {near}?" if near else f"{LIST} marks the ones that can be set"
    return f"no assumption {name} can be set", hint


def switch(name: str) -> Switch | None:
    """Return the allowed values of an assumption; None if it cannot be set."""
    language = name.partition(".")[0]
    return dialect(language).switches().get(name) if language in PACKAGES else None


def switches() -> Iterable[str]:
    """Return the names of all assumptions that can be set."""
    return [name for language in PACKAGES for name in dialect(language).switches()]
