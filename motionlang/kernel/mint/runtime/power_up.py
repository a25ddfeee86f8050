"""Power-up values of settings from the machine file, written as a program would.

They are in the section `[assumptions]` of that file.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from motionlang.kernel.errors import ProgramError, Rejected
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.keywords.switchable import word_of
from motionlang.kernel.mint.runtime.binding import bind
from motionlang.kernel.mint.runtime.environment import Environment


class PowerUp:
    """The settings whose default the machine file changes.

    `set` writes them to an axis, at the start and after DEFAULT.
    """

    def __init__(self, environment: Environment, assumptions: Mapping[str, object]) -> None:
        self._writers: list[tuple[str, Callable[..., object], tuple[object, ...]]] = []
        for name, value in assumptions.items():
            row = table().get(word_of(name))
            if row is not None:
                # A keyword of the group "motion" also gets the number of its line.
                given = (value, 0) if row.group == "motion" else (value,)
                self._writers.append((name, bind(environment, "write", row), given))

    def set(self, axis: int) -> None:
        """Write all of these settings to an axis.

        Raises ProgramError if one cannot be written, for example because another one forbids it.
        """
        for name, write, given in self._writers:
            try:
                write(axis, *given)
            except Rejected as rejected:
                message = f"the assumption {name} cannot be {given[0]:.10g}: {rejected.message}"
                raise ProgramError.of("machine-file", message, hint=rejected.hint) from None
