"""The names of channels and axes that a reader of a map knows."""

from __future__ import annotations

from collections.abc import Iterable

from motionlang.commands.map.axes import AxisMap
from motionlang.commands.map.channels import Channel
from motionlang.exploration import Act, Change


class ReaderNames:
    """Channels and axes by the names that a reader knows."""

    def __init__(self, channels: Iterable[Channel], axes: Iterable[AxisMap]) -> None:
        self._known = {each.title: each.known_as for each in channels}
        self._known |= {f"axis {each.axis}": each.title for each in axes}

    def __contains__(self, subject: str) -> bool:
        return subject in self._known

    def __getitem__(self, subject: str) -> str:
        return self._known.get(subject, subject)

    def change(self, change: Change) -> str:
        """Return a change with the name of its channel."""
        return self._named(change.subject, str(change))

    def act(self, act: Act) -> str:
        """Return an act with the name of its axis or output."""
        return self._named(act.subject, str(act))

    def _named(self, subject: str, text: str) -> str:
        return f"{self[subject]}{text[len(subject) :]}" if text.startswith(subject) else text
