"""What a language says of its paths itself, where they do not go by the settings of their first axis."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.controller.moves.geometry import Segment
    from motionlang.planners.lookahead import Pace


class Guide:
    """The pace of a path and which one it goes on into; and it is told what becomes of the path.

    `scales` are the counts per user unit of each of its axes, as they were when the path was described.
    """

    __slots__ = ("scales",)

    def __init__(self, scales: Sequence[float]) -> None:
        self.scales = list(scales)

    def pace(self) -> Pace:
        """Speed and rates along the path now, user units."""
        raise NotImplementedError

    def joins(self, own: Segment, following: Guide, its: Segment) -> bool:
        """Whether the path goes on into the next one without coming to rest."""
        raise NotImplementedError

    def starts(self) -> None:
        """A run is about to be planned that starts with the path, at rest."""

    def begins(self) -> None:
        """The path is under way."""

    def stops(self) -> None:
        """It comes to rest before its end, or at it where that is nearer."""

    def ends(self, whole: bool) -> None:
        """It is under way no more; `whole`: it has come to its end."""
