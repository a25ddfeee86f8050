"""Records the problems that are found in one function."""

from __future__ import annotations

from typing import Any


class Recorder:
    """The arguments with which problems are reported, between `begin` and `end`."""

    def __init__(self) -> None:
        self._found: list[dict[str, Any]] | None = None
        self._local = True

    def begin(self) -> None:
        """Start recording."""
        self._found, self._local = [], True

    def note(self, **given: Any) -> None:
        """Record a problem."""
        if self._found is not None:
            self._found.append(given)

    def depends(self) -> None:
        """Record that the findings depend on other functions of the program."""
        self._local = False

    def end(self) -> list[dict[str, Any]] | None:
        """Stop recording; return the record, None if it depends on other functions."""
        found, self._found = self._found, None
        return found if self._local else None
