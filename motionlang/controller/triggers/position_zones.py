"""Which stretch of its travel a track is in: the stretches lie between edges, which may repeat turn after turn.

Only the two edges next to the track are watched, however many there are, and each change is told at the very moment
at which the track reaches an edge, in either direction. A new zero that puts the track elsewhere is told as well.
"""

from __future__ import annotations

from bisect import bisect_right
from math import floor

from motionlang.controller.axis import Axis
from motionlang.controller.triggers.watch import Watch, arm, margin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.controller.core import Core
    from motionlang.planners import Profile


class Cells:
    """`index` is the number of edges that lie below the track, edge 0 the first of the turn that begins at 0.

    `edges` rise; with a `period` above 0 they repeat, and span less than it. Counts as the program counts them, or
    with `physical` as the machine does. `change(index)` is called when the track comes into another stretch. With a
    `view` it is what that makes of the demanded motion that decides: a position further on, or a velocity.
    """

    __slots__ = ("_controller", "_follow", "_source", "_track", "_watches", "change", "edges", "index", "period",
                 "physical")  # fmt: skip

    def __init__(
        self,
        controller: Core,
        track: Axis,
        edges: Sequence[float],
        change: Callable[[int], None],
        period: float = 0.0,
        physical: bool = False,
        view: Callable[[Profile], Profile] | None = None,
    ) -> None:
        self._controller, self._source, self._track = controller, track, track
        self.edges, self.change, self.period, self.physical = tuple(edges), change, period, physical
        self._watches: dict[int, Watch] = {}
        self._follow: Callable[[Profile], None] | None = None
        if view is not None:
            self._track = self._seen(view)
        self._track.followers.append(self._followed)
        self.index = self._count()
        self._window()

    def remove(self) -> None:
        """Stop watching."""
        self._track.followers.remove(self._followed)
        if self._follow is not None:
            self._source.followers.remove(self._follow)
        for k in list(self._watches):
            self._unwatch(k)

    def edge(self, k: int) -> float | None:
        """Where edge k is; None where there is none."""
        if self.period:
            turn, place = divmod(k, len(self.edges))
            return self.edges[place] + turn * self.period
        return self.edges[k] if 0 <= k < len(self.edges) else None

    # ------------------------------------------------------------------------------------------------- inside

    def _seen(self, view: Callable[[Profile], Profile]) -> Axis:
        """A track of what the source does as it is viewed."""
        source, controller = self._source, self._controller
        made = Axis(source.index)
        made.put_on(source.starts[-1], view(source.profiles[-1]))
        made.datum = source.datum

        def follow(profile: Profile) -> None:
            made.datum = source.datum
            controller.extend_track(made, view(profile))

        self._follow = follow
        source.followers.append(follow)
        return made

    def _here(self) -> float:
        track = self._track
        now = self._controller.clock.now
        place = track.position(now) if track.feedback is None else track.feedback.position
        return place - track.datum if self.physical else place

    def _count(self) -> int:
        """The edges below the track; it has passed the one that it stands on."""
        here = self._here()
        here += margin(here)
        if not self.period:
            return bisect_right(self.edges, here)
        turn = floor((here - self.edges[0]) / self.period)
        return turn * len(self.edges) + bisect_right(self.edges, here - turn * self.period)

    def _window(self) -> None:
        """Watch the edges next to the track and no others; those that are watched already stay as they are."""
        wanted = [k for k in (self.index - 1, self.index) if self.edge(k) is not None]
        for k in [k for k in self._watches if k not in wanted]:
            self._unwatch(k)
        for k in wanted:
            if k not in self._watches:
                self._watch(k)

    def _watch(self, k: int) -> None:
        position = self.edge(k)
        assert position is not None
        watch = Watch(position, lambda direction: self._enter(k + 1 if direction > 0 else k), self.physical)
        self._watches[k] = watch
        clock = self._controller.clock
        self._track.watches.append(watch)
        arm(self._track, watch, clock, clock.now)
        if not watch.side:
            watch.side = 1 if k < self.index else -1

    def _unwatch(self, k: int) -> None:
        self._track.watches.remove(self._watches.pop(k))

    def _enter(self, index: int) -> None:
        self.index = index
        self._window()
        self.change(index)

    def _followed(self, profile: Profile) -> None:
        """The track goes on otherwise: a new zero may have put it beyond the edges that are watched."""
        here = self._here()
        slack = margin(here)
        low, high = self.edge(self.index - 1), self.edge(self.index)
        if (low is None or here >= low - slack) and (high is None or here <= high + slack):
            return
        for k in list(self._watches):
            self._unwatch(k)
        self.index = self._count()
        self._window()
        self.change(self.index)
