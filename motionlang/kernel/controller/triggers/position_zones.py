"""The interval of its travel that a track is in; the edges may repeat cyclically.

Only the two edges next to the track are watched, however many there are. Each change is notified at the exact
time at which the track reaches an edge, in either direction. A new zero that changes the interval is notified too.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from math import floor

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.queue.track import extend_track
from motionlang.kernel.controller.watch import Watch, begin, end, margin
from motionlang.kernel.planners import Profile


class Cells:
    """The `index` of the present interval: the number of edges below the track.

    Edge 0 is the first of the cycle that begins at 0. `edges` rise; with a positive `period` they repeat, and
    span less than it. They are counts of the program, or with `physical` machine counts. `change(index)` is
    called when the track enters another interval. A `view` transforms the commanded motion first, for example to a
    position further on, or to a velocity.
    """

    def __init__(
        self,
        track: Axis,
        edges: Sequence[float],
        change: Callable[[int], None],
        period: float = 0.0,
        physical: bool = False,
        view: Callable[[Profile], Profile] | None = None,
    ) -> None:
        self._source, self._track = track, track
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
        """Return the position of edge k; None if there is none."""
        if self.period:
            periods, index = divmod(k, len(self.edges))
            return self.edges[index] + periods * self.period
        return self.edges[k] if 0 <= k < len(self.edges) else None

    # ------------------------------------------------------------------------------------------------- inside

    def _seen(self, view: Callable[[Profile], Profile]) -> Axis:
        """Return a track of the source's motion, transformed by a view."""
        source = self._source
        made = Axis(source.index, source.controller)
        made.put_on(source.starts[-1], view(source.profiles[-1]))
        made.datum = source.datum

        def follow(profile: Profile) -> None:
            made.datum = source.datum
            extend_track(made, view(profile), BY_DESIGN)

        self._follow = follow
        source.followers.append(follow)
        return made

    def _here(self) -> float:
        track = self._track
        now = track.clock.now
        position = track.position(now) if track.feedback is None else track.feedback.position
        return position - track.datum if self.physical else position

    def _count(self) -> int:
        """Return the number of edges below or at the track's position."""
        here = self._here()
        here += margin(here)
        if not self.period:
            return bisect_right(self.edges, here)
        periods = floor((here - self.edges[0]) / self.period)
        return periods * len(self.edges) + bisect_right(self.edges, here - periods * self.period)

    def _window(self) -> None:
        """Watch only the edges next to the track; present watches of them remain."""
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
        begin(self._track, watch)
        if not watch.side:
            watch.side = 1 if k < self.index else -1

    def _unwatch(self, k: int) -> None:
        end(self._track, self._watches.pop(k))

    def _enter(self, index: int) -> None:
        self.index = index
        self._window()
        self.change(index)

    def _followed(self, profile: Profile) -> None:
        """Handle a new profile: a new zero may have moved the track past watched edges."""
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
