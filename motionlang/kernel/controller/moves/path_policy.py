"""Path policies of a language, which replace the settings of the first axis."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.controller.moves.geometry import PathSegment
from motionlang.kernel.planners.lookahead import PathPace


class PathPolicy:
    """The pace and joins of a path; its methods are called as the path progresses.

    `scales` are the counts per user unit of each axis when the path was described.
    """

    __slots__ = ("scales",)

    def __init__(self, scales: Sequence[float]) -> None:
        self.scales = list(scales)

    def pace(self) -> PathPace:
        """Return speed and rates along the path now, user units."""
        raise NotImplementedError

    def joins(self, own: PathSegment, following: PathPolicy, its: PathSegment) -> bool:
        """True if the path continues into the next one without a stop."""
        raise NotImplementedError

    def starts(self) -> None:
        """Handle the planning of a run from rest whose first path this is."""

    def begins(self) -> None:
        """Handle the start of the path."""

    def stops(self) -> None:
        """Handle a stop before the end of the path, or at its end if that comes first."""

    def ends(self, whole: bool) -> None:
        """Handle the end of motion on the path; `whole` is true if its end was reached."""
