"""A course: contour paths that are run through as one, and what each of their axes does on it."""

from __future__ import annotations

from bisect import bisect_right

from motionlang.profile.composed import travelled
from motionlang.profile.curve import Profile, from_curve

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.mccl.motion.segment import Segment
    from motionlang.profile.ramps import Piece


class Course:
    """Paths that are run through as one: `segments`, and the length at which each begins and the last one ends."""

    __slots__ = ("marks", "segments")

    def __init__(self, segments: Sequence[Segment]) -> None:
        self.segments = list(segments)
        self.marks = [0.0]
        for segment in segments:
            self.marks.append(self.marks[-1] + segment.length)

    @property
    def length(self) -> float:
        """The length of the whole."""
        return self.marks[-1]

    def extend(self, segment: Segment) -> None:
        """Add a path at the end."""
        self.segments.append(segment)
        self.marks.append(self.marks[-1] + segment.length)

    def index(self, s: float) -> int:
        """The path that length s lies on."""
        return min(max(bisect_right(self.marks, s) - 1, 0), len(self.segments) - 1)

    def profile(self, path: Profile, axis: int) -> Profile:
        """What the axis does while the course is run as `path` says, in counts."""
        made = travelled(path, self._curve(axis))
        if path.start == 0.0:
            made.start = self.segments[0].start_counts(axis)
        if path.end == self.length:
            made.end = self.segments[-1].end_counts(axis)
        return made

    def _curve(self, axis: int) -> Profile:
        """The axis over the length of the course, counts."""
        curves = [segment.curve(axis) for segment in self.segments if segment.length]
        if len(curves) == 1:
            return curves[0]
        knots = [0.0]
        pieces: list[Piece] = []
        for curve in curves:
            begin = knots[-1]
            pieces += curve.pieces
            knots += [begin + knot for knot in curve.knots[1:]]
        first, last = curves[0], curves[-1]
        whole = (tuple(knots), tuple(pieces), (("path", 0),))
        return from_curve("path", first.start, last.end, whole, first.start_velocity, last.end_velocity)
