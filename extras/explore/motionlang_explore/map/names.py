"""The names of channels and axes that a reader of a map knows."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable

from motionlang.commands.channels import Channel
from motionlang_explore.exploration import Act, Change, names_alarm
from motionlang_explore.map.axes import AxisMap
from motionlang_explore.map.units import MapVariable

# Where a word begins within a name of the program.
_WORD = re.compile(r"(?<=[a-z])(?=[A-Z])")


class ReaderNames:
    """Channels and axes by the names that a reader knows."""

    def __init__(
        self, channels: Collection[Channel], axes: Iterable[AxisMap], variables: Iterable[MapVariable]
    ) -> None:
        self._known = {each.title: each.known_as for each in channels}
        meant = {f"{each.kind} {each.name}": each.meaning for each in variables if each.meaning}
        self._known |= {subject: f"{subject} ({meaning})" for subject, meaning in meant.items()}
        self._known |= {f"axis {each.axis}": each.title for each in axes}
        outputs = [each for each in channels if each.kind == "output"]
        self.alarms = {each.title for each in outputs if is_alarm(each.name)}

    def __contains__(self, subject: str) -> bool:
        return subject in self._known

    def __getitem__(self, subject: str) -> str:
        return self._known.get(subject, subject)

    def of(self, one: Act | Change) -> str:
        """Return an act or a change with the name of its axis or channel."""
        text = str(one)
        return f"{self[one.subject]}{text[len(one.subject) :]}" if text.startswith(one.subject) else text


def spaced(name: str) -> str:
    """Return a name with its words apart, such as "ip Run"."""
    return _WORD.sub(" ", name)


def is_alarm(name: str) -> bool:
    """True if a name, such as "opRed", is that of something that is on when something is wrong."""
    return names_alarm(spaced(name))
