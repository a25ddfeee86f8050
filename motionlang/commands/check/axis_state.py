"""Data-flow analysis: the facts known about each axis before each statement, for both languages.

The rules about motion ask for these facts. Only certain ones are stored: where two paths of execution join, those on
which they disagree are dropped. What a keyword does to its axis is its role (`keyword.ROLES`), and each role has a
method here, so a rule and a language need no further knowledge of keywords.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import reduce
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

from motionlang.commands.check.reach import LOWER, UPPER, Reach
from motionlang.kernel.lang import TEST, UNTIL, Use
from motionlang.kernel.lang import AxisKey as Key

if TYPE_CHECKING:
    from motionlang.commands.check.rule_facts import Facts, Part

# Roles of keywords that command an axis. A keyword that only stops an axis is not among them.
COMMANDS = frozenset((
    "move", "entry", "course", "path", "go", "act", "zero", "scale", "start", "run", "mode", "enable", "rescale",
))  # fmt: skip
# What was wrong at a use of a keyword, for one of its axes, and what was known of that.
Problem = tuple[Use, Key, "AxisFacts"]

IDLE, MOVES, UNKNOWN = "idle", "moves", "unknown"
TARGETS, ENDLESS, OTHER = "targets", "endless", "other"
# No offset of a statement.
NONE = -1
# No buffer holds more entries, so larger counts are not distinguished.
MAX_ENTRIES = 101
# The properties that only the paths of a contour use, and those that no motion uses.
_OF_PATHS = frozenset(("vector speed", "vector accel", "vector decel"))


class AxisFacts(NamedTuple):
    """The facts known about one axis.

    - `motion`: IDLE, MOVES or UNKNOWN.
    - `fresh`: no time has passed since GO.
    - `waiting`: the minimum number of entries that wait for a GO.
    - `target`: the end of the last loaded move in user units, None if unknown.
    - `frame`: the distance of the program's zero from the position at power-up in user units, None if
      unknown.
    - `set`: the settings made so far, in user units, those of moves and the software limits.
    - `stale`: the settings in an older unit; the last change of the scale, to `scale` if known, is at offset `scaled`.
    - `timed`: the offset of what set a ramp time before any speed was set, None if there is none.
    - `speeded`: a speed may have been set.
    - `zeros`: the move settings that are 0.
    - `loaded`: the offset of the first move that waits for a GO, None if unknown.
    - `empty`: no move waits for a GO.
    - `span`: the lowest and the highest position that the moves so far can have reached, None if unknown.
    - `jogs`: the axis jogs, and no statement has stopped it.
    - `mode`: the mode that decides what a start does: TARGETS, ENDLESS or another, "" if unknown.
    - `pending`: the offset of the first change of the scale that waits for the axis to be switched on, NONE if
      there is none, None if unknown.
    - `limited`: the sides on which a software limit has certainly been set, or in MCCL enabled.
    - `shape`: the keyword of the last shape of moves, "" if unknown.
    - `unmoved`: nothing has moved the axis.
    - `distance`: the length of the only move since the axis was at rest, None if unknown.
    - `off`: the axis is switched off.
    """

    motion: str = UNKNOWN
    fresh: bool = False
    waiting: int = 0
    target: float | None = None
    frame: float | None = None
    set: frozenset[str] = frozenset()
    stale: frozenset[str] = frozenset()
    scaled: int | None = None
    scale: float | None = None
    timed: int | None = None
    speeded: bool = True
    zeros: frozenset[str] = frozenset()
    loaded: int | None = None
    empty: bool = False
    span: tuple[float, float] | None = None
    jogs: bool = False
    mode: str = ""
    pending: int | None = None
    limited: frozenset[str] = frozenset()
    shape: str = ""
    unmoved: bool = False
    distance: float | None = None
    off: bool = False

    def joined(self, other: AxisFacts, at_loop_head: bool) -> AxisFacts:
        """Return the facts on which both agree; at a loop head time has passed."""
        if self == other:
            return self._replace(fresh=False) if at_loop_head and self.fresh else self
        return AxisFacts(
            motion=self.motion if self.motion == other.motion else UNKNOWN,
            fresh=self.fresh and other.fresh and not at_loop_head,
            waiting=min(self.waiting, other.waiting),
            target=self.target if self.target == other.target else None,
            frame=self.frame if self.frame == other.frame else None,
            set=self.set & other.set,
            stale=self.stale & other.stale,
            scaled=self.scaled if self.scaled == other.scaled else None,
            scale=self.scale if self.scale == other.scale else None,
            timed=self.timed if self.timed == other.timed else None,
            speeded=self.speeded or other.speeded,
            zeros=self.zeros & other.zeros,
            loaded=self.loaded if self.loaded == other.loaded else None,
            empty=self.empty and other.empty,
            span=self.span if self.span == other.span else None,
            jogs=self.jogs and other.jogs,
            mode=self.mode if self.mode == other.mode else "",
            pending=self.pending if self.pending == other.pending else None,
            limited=self.limited & other.limited,
            shape=self.shape if self.shape == other.shape else "",
            unmoved=self.unmoved and other.unmoved,
            distance=self.distance if self.distance == other.distance else None,
            off=self.off and other.off,
        )

    def reaching(self, target: float | None) -> tuple[float, float] | None:
        """Return `span` after a move to a target (None if the target is unknown)."""
        if self.span is None or target is None:
            return None
        return min(self.span[0], target), max(self.span[1], target)


ANY = AxisFacts()
AT_POWER_UP = AxisFacts(
    IDLE,
    target=0.0,
    frame=0.0,
    scale=1.0,
    speeded=False,
    empty=True,
    span=(0.0, 0.0),
    mode=TARGETS,
    pending=NONE,
    unmoved=True,
    distance=0.0,
)
# Verbs of the settings that must not be 0 for a move to run.
_NEEDED = frozenset(("speed", "accel", "decel"))


@dataclass(eq=False, slots=True)
class AllAxes:
    """The facts about all axes: `axes` by key, and `rest` for all axes not in it.

    `skipped` is the state of a run in which a command of line `line` was rejected, so that the rest of that line is
    not carried out; None if none can have been. `is_sure`: the command was certainly rejected.
    """

    rest: AxisFacts
    axes: dict[Key, AxisFacts]
    skipped: AllAxes | None = None
    line: int = 0
    is_sure: bool = False

    __hash__ = None  # type: ignore[assignment]

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, AllAxes)
            and self.rest == other.rest
            and self.axes == other.axes
            and self.skipped == other.skipped
            and self.is_sure == other.is_sure
        )

    def joined(self, other: AllAxes, at_loop_head: bool) -> AllAxes:
        if self is other and not at_loop_head:
            return self
        keys = self.axes.keys() | other.axes.keys()
        axes = {key: self[key].joined(other[key], at_loop_head) for key in keys}
        skipped = self.skipped or other.skipped
        if self.skipped is not None and other.skipped is not None:
            skipped = self.skipped.joined(other.skipped, at_loop_head)
        is_sure, line = self.is_sure and other.is_sure, self.line or other.line
        return AllAxes(self.rest.joined(other.rest, at_loop_head), axes, skipped, line, is_sure)

    def __getitem__(self, key: Key) -> AxisFacts:
        return self.axes.get(key, self.rest)

    def put(self, key: Key, axis: AxisFacts) -> AllAxes:
        return replace(self, axes={**self.axes, key: axis})

    def passed(self) -> AllAxes:
        """Return the state after time has passed."""
        if not any(axis.fresh for axis in self.axes.values()):
            return self
        axes = {key: axis._replace(fresh=False) if axis.fresh else axis for key, axis in self.axes.items()}
        return replace(self, axes=axes)

    def rejected(self, before: AllAxes, line: int, is_sure: bool) -> AllAxes:
        """Return the state behind a command that may have been rejected in the state `before`."""
        one = AllAxes(before.rest, before.axes)
        skipped = one if before.skipped is None else one.joined(before.skipped, False)
        return replace(self, skipped=skipped, line=line, is_sure=before.is_sure or is_sure)

    def in_line(self, line: int) -> AllAxes:
        """Return the state at a command of a line: behind the line before, all its runs come together."""
        if self.skipped is None or self.line == line:
            return self
        return self.skipped if self.is_sure else AllAxes(self.rest, self.axes).joined(self.skipped, False)


ANYTHING = AllAxes(ANY, {})
# The facts about the axes that a sub changes, when it returns.
After = dict[Key, AxisFacts]


class Follower:
    """Tracks the facts about the axes through every part.

    `before` has the states before the points of a part, `after` the facts on return about the axes that the part
    changes, and `problems` what is certainly wrong, by kind.
    """

    def __init__(self, facts: Facts) -> None:
        self.facts = facts
        self.reach = Reach(self)
        self.before: dict[Part, dict[int, AllAxes]] = {}
        self.after: dict[Part, After] = {}
        self.apart = self._shared()
        self.stopped = self._stopped_by_handlers()
        self.led = self._led()
        self.before_act = ANYTHING
        # The line of the statement that is followed, and True if it reads again and again.
        self._line, self._polls = 0, False
        self._at_work: set[Part] = set()
        self.problems: dict[str, list[Problem]] = {}
        self._reports = False
        for part in facts.parts:
            self._analyse(part)
        self._reports = True
        for states in self.before.values():
            for p, state in sorted(states.items(), key=itemgetter(0)):
                self._follow(p, state)

    def _shared(self) -> set[Key]:
        """Return the axes commanded by more than one of parent task, tasks and handlers.

        Nothing is certain about them.
        """
        seen: dict[Key, Part] = {}
        shared: set[Key] = set()
        for root in self.facts.parts:
            if root.kind == "sub":
                continue
            for key in self.facts.touched(root, COMMANDS):
                if seen.setdefault(key, root) is not root:
                    shared.add(key)
        if None in seen and len(set(seen.values())) > 1:
            shared |= {*seen, None}
        return shared

    def _stopped_by_handlers(self) -> set[Key]:
        """Return the axes that a handler or a task stops; their moves may end early."""
        found: set[Key] = set()
        for root in self.facts.parts:
            if root.kind in ("task", "event"):
                found |= self.facts.touched(root, frozenset(("stop",)))
        return found

    def is_over(self, p: int, key: Key, later: int) -> bool:
        """True if a move that is commanded at a point of the program is over at a later one: the axis is at rest."""
        main = next(part for part in self.facts.parts if part.kind == "main")
        states = self.before.get(main, {})
        if p not in states or later not in states:
            return False
        axis = self.known(states[later], key)
        return axis.motion == IDLE and axis.empty

    def known(self, state: AllAxes, key: Key) -> AxisFacts:
        """Return the certain facts about an axis."""
        unsure = isinstance(key, str) and self.apart
        if key is None or unsure or key in self.apart or None in self.apart:
            return ANY
        axis = state[key]
        if {key, None} & self.led or (isinstance(key, str) and self.led):
            return axis._replace(motion=UNKNOWN, fresh=False, empty=False, span=None, jogs=False, mode="")
        return axis

    def _led(self) -> set[Key]:
        """Return the axes that may move without a GO of their own.

        They follow a master, belong to the path of another axis, or are started by a trigger.
        """
        found = self.facts.given("follows", "hands-over")
        for act in self.facts.written_by(lambda row: row.role == "path"):
            found.update(act.axes[1:])
        return found

    # ---------------------------------------------------------------------------------------- following

    def _analyse(self, part: Part) -> None:
        """Track the axes through a part; the functions that it calls come first."""
        if part in self.after or part in self._at_work:
            return
        self._at_work.add(part)
        for each in sorted(part.calls, key=lambda f: f.at):
            self._analyse(each)
        self._at_work.discard(part)
        self.after[part] = self._states(part)

    def _states(self, part: Part) -> After:
        graph, own = self.facts.graph, self.facts.points[part]
        first = ANYTHING
        if part.kind == "main":
            off = self.facts.at_power_up._replace(off=True)
            first = AllAxes(self.facts.at_power_up, dict.fromkeys(self.facts.never_on, off))
        found: dict[int, AllAxes] = {}

        def follow(p: int, state: AllAxes) -> tuple[AllAxes, AllAxes]:
            found[p] = state
            return self._follow(p, state)

        def join(one: AllAxes, other: AllAxes, p: int) -> AllAxes:
            joined = one.joined(other, p in graph.heads)
            return one if joined == one else joined

        begin, *handlers = self.facts.entries[part]
        graph.forward({**dict.fromkeys(handlers, ANYTHING), begin: first}, follow, join)
        self.before[part] = found
        ends = [found[p] for p in own if p in found and self.facts.leaves(p)]
        last = reduce(lambda one, other: one.joined(other, False), ends) if ends else ANYTHING
        return {key: _after_call(last[key]) for key in self.facts.touched(part, CHANGES)}

    def _follow(self, p: int, state: AllAxes) -> tuple[AllAxes, AllAxes]:
        statement = self.facts.statement_at.get(p)
        if statement is None:
            return state, state
        self._polls, self._line = p in self.facts.polling, statement.line
        state = state.in_line(statement.line)
        for act in self.facts.acts[p]:
            state = self._act(act, state)
        if statement.waits or statement.starts:
            state = state.passed()
        role = self.facts.graph.points[p].role
        if role in (TEST, UNTIL):
            return self.facts.refined(p, role == TEST, state), self.facts.refined(p, role == UNTIL, state)
        if statement.waits:
            state = self.facts.refined(p, True, state)
        return state, state

    def _act(self, act: Use, state: AllAxes) -> AllAxes:
        if act.role == "call":
            return self._call(act, state)
        if act.row is not None and act.row.function == "wait" and act.values and act.number(0) != 0:
            return state.passed()
        follow = _FOLLOW.get(act.role)
        if follow is None:
            return state
        self.before_act = state
        for number, key in enumerate(act.axes):
            if key is None and self.facts.names_all:
                state = self._all(follow, act, number, state)
                continue
            old = self.known(state, key)
            new = follow(self, act, number, key, old)
            if key is None:
                if act.role not in ("read", "slot"):
                    state = ANYTHING
            else:
                after = state if new == old else state.put(key, new)
                fails, is_sure = self.facts.may_fail(act, old)
                # What waits for a move that was rejected is not reported a second time.
                before = state.put(key, old._replace(unmoved=False)) if fails and old.unmoved else state
                state = after.rejected(before, self._line, is_sure) if fails else after
        return state

    def _all(self, follow: Callable[..., AxisFacts], act: Use, number: int, state: AllAxes) -> AllAxes:
        """Return the state after an act on all axes; nothing is reported of those that nothing has named."""
        axes = {key: follow(self, act, number, key, self.known(state, key)) for key in state.axes}
        reports, self._reports = self._reports, False
        rest = follow(self, act, number, None, state.rest)
        self._reports = reports
        return replace(state, rest=rest, axes=axes)

    def _call(self, call: Use, state: AllAxes) -> AllAxes:
        callee = self.facts.callee(call)
        state = state.passed()
        after = self.after.get(callee, {})  # none while it is being analysed: it is recursive
        changed = self.facts.touched(callee, CHANGES)
        for key in changed:
            outer = self.facts.outer(call, key)
            if outer is None:
                return ANYTHING
            state = state.put(outer, after.get(key, ANY))
        if any(isinstance(key, str) for key in state.axes) and changed:
            named = {self.facts.outer(call, key) for key in changed}
            if any(not isinstance(key, str) for key in named):
                return ANYTHING
        return state

    def _report_problem(self, problem: str, act: Use, key: Key, axis: AxisFacts) -> None:
        if self._reports:
            self.problems.setdefault(problem, []).append((act, key, axis))

    # ------------------------------------------------------------------------------------ one axis, one word

    def _read(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        if act.row is not None and act.row.does("position") and axis.fresh and not self._polls:
            self._report_problem("in-motion", act, key, axis)
        return axis

    def _move(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        assert act.row is not None
        target = self._target(act, number, key, axis, act.row.does("relative"))
        loaded = self._loaded(self._entry(act, number, key, axis), act)
        span = axis.reaching(target)
        return self._checked(act, number, key, loaded._replace(target=target, span=span))

    def _loaded(self, axis: AxisFacts, act: Use) -> AxisFacts:
        """Record the offset of the move if it is the first one in the buffer."""
        return axis._replace(loaded=act.at) if axis.waiting == 1 else axis

    def _target(self, act: Use, number: int, key: Key, axis: AxisFacts, relative: bool) -> float | None:
        """Return the end position of a move in user units, None if unknown."""
        value = act.number(number)
        if not relative or value is None:
            return value
        certain = axis.target is not None and not {key, None} & self.stopped and not isinstance(key, str)
        return axis.target + value if certain and axis.target is not None else None

    def _checked(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        """Report a target that is out of reach, and drop it from the facts."""
        if axis.target is None or not self.reach.beyond(act, key, axis):
            return axis
        self._report_problem("beyond-travel", act, key, axis)
        return axis._replace(target=None)

    def _entry(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        self._check_scale(act, key, axis)
        return axis._replace(waiting=min(axis.waiting + 1, MAX_ENTRIES), empty=False)

    def _check_scale(self, act: Use, key: Key, axis: AxisFacts) -> None:
        """Report the settings in an old unit that a motion uses, which `stale` then has."""
        is_path = act.row is not None and act.row.family == "contours"
        unused = {f"{side} limit" for side in (UPPER, LOWER) if side not in axis.limited}
        if act.row is not None and act.row.does("endless"):
            unused.add("speed")  # it has a speed of its own
        stale = axis.stale & _OF_PATHS if is_path else axis.stale - _OF_PATHS - unused
        if stale and axis.scaled is not None:
            self._report_problem("scale-after-speed", act, key, axis._replace(stale=stale))

    def _course(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        return self._entry(act, number, key, axis)._replace(target=None, span=None)

    def _path(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        """Load a path, which waits for the GO of its first axis.

        The target is known only for a line.
        """
        assert act.row is not None
        target = None
        if act.row.does("line") and number < len(act.values):
            target = self._target(act, number, key, axis, act.row.does("relative"))
        span = axis.reaching(target)
        if number == 0:
            axis = self._loaded(self._entry(act, number, key, axis), act)
        return self._checked(act, number, key, axis._replace(target=target, span=span, empty=False))

    def _go(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        sure = axis.waiting > 0
        if sure and axis.motion == IDLE and axis.loaded is not None and axis.zeros:
            self._report_problem("zeros", act, key, axis)
        if number == 0 and all(self.known(self.before_act, key).empty for key in act.axes):
            self._report_problem("nothing-loaded", act, key, axis)
        return axis._replace(
            motion=MOVES if sure else axis.motion if axis.empty else UNKNOWN,
            fresh=sure,
            waiting=0,
            loaded=None,
            empty=True,
            jogs=axis.jogs and axis.empty,
        )

    def _stop(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        assert act.row is not None
        if axis.fresh:
            self._report_problem("cut-short", act, key, axis)
        stops = axis.motion == IDLE or act.row.does("abrupt")
        target = axis.target if axis.motion == IDLE and not axis.waiting else None
        axis = axis._replace(
            motion=IDLE if stops else UNKNOWN,
            fresh=False,
            waiting=0,
            target=target,
            loaded=None,
            empty=True,
            jogs=False,
            distance=0.0 if stops else None,
            off=axis.off or act.row.does("off"),
        )
        if not act.row.does("datum"):
            return axis
        return axis._replace(target=None, frame=None, span=None, zeros=frozenset())

    def _at_once(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        assert act.row is not None
        if act.row.family == "contours" or act.row.does("endless"):
            self._check_scale(act, key, axis)
        jogs = act.row.does("endless") and act.number(number) not in (None, 0)
        return axis._replace(
            motion=MOVES if jogs else UNKNOWN,
            fresh=False,
            target=None,
            frame=None if act.row.does("datum") else axis.frame,
            empty=False,
            span=None,
            jogs=jogs,
            unmoved=False,
            distance=None,
        )

    def _slot(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        assert act.row is not None
        slot = act.row.gives
        if slot == "speed":
            if axis.timed is not None:
                self._report_problem("time-before-speed", act, key, axis)
            axis = axis._replace(speeded=True, timed=None)
        elif act.row.function in ("accel_time", "decel_time") and not axis.speeded:
            axis = axis._replace(timed=act.at if axis.timed is None else axis.timed)
        in_units = act.row.unit.startswith("uu")
        nothing = act.row.function in _NEEDED and act.number(number) == 0
        return axis._replace(
            set=axis.set | {slot} if in_units else axis.set - {slot},
            stale=axis.stale - {slot},
            zeros=axis.zeros | {slot} if nothing else axis.zeros - {slot},
            shape=act.row.name if slot == "shape" else axis.shape,
        )

    def _scale(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        scale = act.number(number)
        if scale is not None and scale == axis.scale:
            return axis
        if axis.motion == MOVES:
            self._report_problem("scale-in-motion", act, key, axis)
        target = axis.target if axis.target == 0 else None
        span = axis.span if axis.span == (0, 0) else None
        return axis._replace(
            stale=axis.stale | axis.set, scaled=act.at, scale=scale, set=frozenset(), target=target, span=span
        )

    def _zero(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        if axis.fresh:
            self._report_problem("in-motion", act, key, axis)
        value = act.number(number)
        if axis.motion != IDLE or axis.waiting or value is None:
            return axis._replace(target=None, frame=None, span=None)
        moved = None if axis.frame is None or axis.target is None else axis.frame + axis.target - value
        return axis._replace(target=value, frame=moved, span=(value, value))

    # ---------------------------------------------------------------------- motion at once, without a buffer

    def _start(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        """Start a move to a known end; it takes the place of the motion before it."""
        assert act.row is not None
        if axis.off:
            return self._started_off(act, key, axis)
        self._check_unit(act, key, axis)
        if axis.fresh and not axis.jogs and not act.row.does("relative") and self._replaces(key, axis):
            self._report_problem("replaced", act, key, axis)
        if axis.jogs and axis.mode == TARGETS and self.facts.needs_rest(axis.shape):
            self._report_problem("still-running", act, key, axis)
        axis = axis._replace(unmoved=False)
        if axis.mode != TARGETS:
            return axis._replace(
                motion=UNKNOWN, fresh=False, target=None, span=None, jogs=False, distance=None
            )
        if axis.zeros:
            self._report_problem("zeros", act, key, axis._replace(loaded=act.at))
        value = act.number(number) if act.values else 0.0
        relative = act.row.does("relative")
        target = (
            self._target(act, number, key, axis, relative) if act.values else axis.target if relative else 0.0
        )
        is_first = axis.motion == IDLE and axis.distance == 0.0
        started = axis._replace(
            motion=MOVES,
            fresh=axis.motion == IDLE,
            target=target,
            span=axis.reaching(target),
            jogs=False,
            distance=abs(value) if relative and is_first and value is not None else None,
        )
        return self._checked(act, number, key, started)

    def _replaces(self, key: Key, axis: AxisFacts) -> bool:
        """True if a move takes the place of another one in motion, and does not wait for its end."""
        if axis.shape:
            return not self.facts.needs_rest(axis.shape)
        shaped = {key for act in self.facts.written_by(lambda row: row.gives == "shape") for key in act.axes}
        return not {key, None} & shaped

    def _started_off(self, act: Use, key: Key, axis: AxisFacts) -> AxisFacts:
        """Report the start of a motion that the axis rejects, because it is off."""
        self._report_problem("motor-off", act, key, axis)
        return axis._replace(unmoved=False)

    def _check_unit(self, act: Use, key: Key, axis: AxisFacts) -> None:
        """Report a motion that is in another unit than the program has set."""
        if axis.pending is not None and axis.pending != NONE:
            self._report_problem("scale-pending", act, key, axis)
        else:
            self._check_scale(act, key, axis)

    def _mode(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        assert act.row is not None
        mode = next((each for each in (TARGETS, ENDLESS) if act.row.does(each)), OTHER)
        return axis._replace(mode=mode)

    def _run(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        """Start the motion of the mode."""
        if axis.mode == TARGETS:
            self._report_problem("nothing-loaded", act, key, axis)
            return axis._replace(unmoved=False)
        if axis.off:
            return self._started_off(act, key, axis)
        self._check_unit(act, key, axis)
        runs = axis.mode == ENDLESS and (axis.motion == IDLE or axis.jogs)
        return axis._replace(
            motion=MOVES if runs else UNKNOWN,
            fresh=runs and axis.motion == IDLE,
            target=None,
            span=None,
            jogs=runs,
            unmoved=False,
            distance=None,
        )

    def _rest(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        """Wait for standstill."""
        if axis.jogs:
            self._report_problem("still-running", act, key, axis)
        elif axis.unmoved:
            self._report_problem("nothing-to-wait-for", act, key, axis)
        reached = None if axis.target is None or axis.motion != MOVES else (axis.target, axis.target)
        return axis._replace(motion=IDLE, fresh=False, jogs=False, distance=0.0, span=axis.span or reached)

    def _enable(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        """Switch the axis on: a scale that waits for this comes into force."""
        motion = IDLE if axis.motion == IDLE else UNKNOWN
        axis = axis._replace(motion=motion, fresh=False, jogs=False, off=False)
        if axis.frame is None:  # a change of the zero may wait for this, too
            axis = axis._replace(target=None, span=None)
        if axis.pending == NONE:
            return axis
        sure = axis.pending is not None
        return axis._replace(
            stale=axis.stale | axis.set if sure else frozenset(),
            scaled=axis.pending,
            set=frozenset(),
            pending=NONE,
            target=axis.target if axis.target == 0.0 else None,
            span=axis.span if axis.span == (0.0, 0.0) else None,
            distance=0.0 if axis.distance == 0.0 else None,
        )

    def _rescale(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        """Change the scale, or the zero, from the next time on that the axis is switched on."""
        assert act.row is not None
        if act.row.does("datum"):
            return axis._replace(frame=None)
        return axis._replace(pending=act.at if axis.pending in (NONE, None) else axis.pending)

    def _use(self, act: Use, number: int, key: Key, axis: AxisFacts) -> AxisFacts:
        assert act.row is not None
        if self.facts.disturbs(act.row):
            return axis._replace(
                motion=UNKNOWN,
                fresh=False,
                waiting=0,
                target=None,
                zeros=frozenset(),
                loaded=None,
                empty=False,
                span=None,
                jogs=False,
                unmoved=False,
                distance=None,
                off=False,
                scale=None,
            )
        side = next((f"{each} limit" for each in (UPPER, LOWER) if act.row.does(each)), "")
        if side:
            axis = axis._replace(set=axis.set | {side}, stale=axis.stale - {side})
        fresh = axis.fresh and not act.row.does(
            "target"
        )  # a motion may have been started for its target alone
        return axis._replace(fresh=fresh, limited=self.facts.limited(act, number, axis.limited))


def _after_call(inner: AxisFacts) -> AxisFacts:
    """Return the facts about an axis after a sub; earlier settings remain valid."""
    return inner._replace(fresh=False, set=frozenset(), speeded=True, timed=None, stale=frozenset())


# Roles of keywords in a sub that change the facts its caller has about an axis.
CHANGES = COMMANDS | {"stop", "rest", "use"}
_FOLLOW: dict[str, Callable[..., AxisFacts]] = {
    "read": Follower._read,
    "move": Follower._move,
    "entry": Follower._entry,
    "course": Follower._course,
    "path": Follower._path,
    "go": Follower._go,
    "stop": Follower._stop,
    "act": Follower._at_once,
    "slot": Follower._slot,
    "scale": Follower._scale,
    "zero": Follower._zero,
    "start": Follower._start,
    "mode": Follower._mode,
    "run": Follower._run,
    "rest": Follower._rest,
    "enable": Follower._enable,
    "rescale": Follower._rescale,
    "use": Follower._use,
}
