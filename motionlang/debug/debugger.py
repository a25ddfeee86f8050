"""The debugger: forward and back through a run, breakpoints, and manual changes.

Problem. A user stops a program and asks how it reached this state. By then the run has moved on.

Idea. A stop is identified by the number of a statement (`replay.py`). To go forward, the waiting thread of the run
continues. To go back, a new run executes up to an earlier number. To find that number, each run remembers the
statements just before a stop. If they do not suffice, a search runs to the stop once more and notes the last hit.

Moments without a statement, such as a limit in the middle of a wait, are found in the log, whenever the run stops and
every `STRIDE` statements. The first statement after the moment becomes the stop, or the last statement if the program
ends before that.

A program may wait for something that never happens, while events go on for eight hours. A command that needs a
statement gives up after as many advances of the clock as the run has made so far (`patience.py`). The last statement is
then the stop. `go_on` and `go_to_line` run on, until they are paused.

Invariants.
- After each command there is one run: stopped at `stop`, or ended (`stop` is None, `run` has the result).
- The same commands give the same stops, and no command changes the result of the run. Manual changes are in the
  journal.
- Hit counts count executed statements from the start of the program. Skipped iterations of a polling loop execute
  none.
"""

from __future__ import annotations

from collections import deque
from math import nextafter

from motionlang.controller.clock import INFINITY
from motionlang.debug import checkpoints, moments, scopes
from motionlang.debug.breakpoints import Breakpoint, Watched
from motionlang.debug.checkpoints import HandOver
from motionlang.debug.journal import Assigned, Entered, Journal
from motionlang.debug.patience import Patience
from motionlang.debug.replay import EVERY, MEMORY, Output, Point, Remembered, Replay, Setup
from motionlang.debug.state import State
from motionlang.lang.machine.machine import DEFAULT_AXES
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence
    from typing import Any

    from motionlang.debug.checkpoints import Checkpoints
    from motionlang.debug.moments import Moment, Search
    from motionlang.lang.debugging import Variable
    from motionlang.lang.dialect import Dialect
    from motionlang.result import Run
    from motionlang.source import Source

# Statements between two searches of the log.
STRIDE = 4096
# Statements that are recorded to find the one before a stop, if it is not among the last ones.
REACH = 65536
# Two searches find the same moment within this time, s: that of a condition depends on the samples.
CLOSE = 1e-8


@record
class Stop:
    """A stop before a statement.

    `moment` is the time, s, of the event that caused the stop, if that was before the statement.
    `reason` is "entry", "step", "breakpoint", "moment", "exception", "change", "pause", "goto" or "start".
    """

    number: int
    time: float
    task: str
    line: int
    column: int
    reason: str
    text: str = ""
    moment: float | None = None


class NotStopped(Exception):
    """The program has ended or not begun, so its state is not available."""


class Interrupted(Exception):
    """The user has cancelled a search; the program is at its previous stop."""


class Debugger:
    """A program that runs forward and back."""

    def __init__(
        self,
        source: Source,
        language: Dialect,
        settings: Mapping[str, object] | None = None,
        *,
        overrides: Mapping[str, float | str] | None = None,
        until: float | None = None,
        show: Callable[[str], object] = lambda text: None,
        log_message: Callable[[str], object] = lambda text: None,
        ask: Callable[[str], str | None] | None = None,
        interrupted: Callable[[], bool] | None = None,
    ) -> None:
        """Compile the program; raise ProgramError with all its errors.

        `show` takes its output, and `log_message` the texts of log points. `ask` returns a line for INPUT. While
        `interrupted()` is true, whatever runs is paused.
        """
        self._log_message, self._ask, self._interrupted = log_message, ask, interrupted
        self._can_interrupt = True
        self._settings, self._overrides = dict(settings or {}), dict(overrides or {})
        self.language, self._until = language, until
        self.journal = Journal()
        self._output = Output(show)
        self.breakpoints: list[Breakpoint] = []
        self.searches: list[Search] = []
        self.watched: list[Watched] = []
        self.stops_at_errors = False
        self.stop: Stop | None = None
        self.source = source
        self._lines: dict[int, list[int]] = {}
        self._locations: dict[int, tuple[int, int, int]] = {}
        # Copies of the process to go back to, and where progress of a long replay is reported: a fraction.
        self.checkpoints: Checkpoints | None = None
        self.progress: Callable[[float], None] | None = None
        # The last statement of the replay that goes on, 0 for none.
        self._last = 0
        self._load(source)
        self._replay = self._new()
        # The time up to which moments have been searched, and the number of the statement of the last log point.
        self._after, self._logged = -1.0, 0
        # The numbers and times at which the run has been checked since the last stop.
        self._marks: list[tuple[int, float]] = []
        # The advances of the clock after which moments are searched.
        self._next_search = STRIDE
        # The run of a search, while there is one, and the statements before the stop that it has found.
        self._searching: Replay | None = None
        self._history: list[Remembered] = []

    def _load(self, source: Source) -> None:
        program = self.language.debug(source, self._settings)
        self.source = source
        self._setup = Setup(source, self.language, self._settings, self._overrides, self._until, program)
        self._entries = frozenset(program.entries)
        self._lines.clear()
        self._locations.clear()
        located = self.language.locations(source, program.offsets)
        for offset, (line, column, length) in zip(program.offsets, located, strict=True):
            self._locations[offset] = line, column, length
            self._lines.setdefault(line, []).append(offset)

    def _new(self) -> Replay:
        replay = Replay(
            self._setup,
            self.journal,
            self._output,
            self._ask,
            self._interrupted if self._can_interrupt else None,
        )
        if self.checkpoints is not None or self.progress is not None:
            replay.on_tick = lambda: self._tick(replay)
        return replay

    def observe(self, checkpoints: Checkpoints | None, progress: Callable[[float], None]) -> None:
        """Make copies of the process in slow runs, and report the progress of replays.

        Call it before `start`.
        """
        self.checkpoints, self.progress = checkpoints, progress
        self._replay = self._new()

    def _tick(self, replay: Replay) -> None:
        """Make a copy of a slow run, and report its progress; runs in a timer thread."""
        replay.ticks += 1
        if replay.ticks < checkpoints.SLOW:
            return
        if self.checkpoints is not None and replay is self._replay:
            replay.checkpoints = self.checkpoints
            replay.copy_soon()
        if self.progress is not None and self._last:
            self.progress(min(replay.hook.count / self._last, 1.0))

    # ------------------------------------------------------------------------------------------------- state

    @property
    def run(self) -> Run | None:
        """The result, if the program has ended."""
        return self._replay.run

    @property
    def axes(self) -> range:
        """The numbers of the axes of the controller."""
        first = self.language.first_axis
        count: int = self._settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
        return range(first, first + count)

    @property
    def lines(self) -> list[int]:
        """The lines with statements, at which the program can stop."""
        return sorted(self._lines)

    def line_for(self, line: int) -> int | None:
        """Return the first line from `line` on with a statement; None if there is none."""
        return min((each for each in self._lines if each >= line), default=None)

    def location_of(self, at: int) -> tuple[int, int, int]:
        """Return line, column and length of a source offset."""
        found = self._locations.get(at)
        if found is None:
            found = self._locations[at] = self.language.locate(self.source, at)
        return found

    def state(self) -> State:
        """Return the state at the stop, or at the end.

        Raises NotStopped before the first statement.
        """
        replay = self._replay
        if replay.point is None and replay.run is None:
            raise NotStopped
        return State(self, replay)

    def abandon(self) -> None:
        """End the session and its run."""
        self._replay.abandon()

    def problems(self) -> list[str]:
        """Return, once, the changes of the journal that could not be repeated."""
        found, self._replay.problems = self._replay.problems, []
        return found

    def stay(self, text: str) -> Stop | None:
        """Remain at the stop; `text` is the reason."""
        return self._at(self._replay.point, "goto", text)

    def pause(self) -> None:
        """Stop a run or a search before its next statement; may be called from any thread."""
        self._replay_in_force.pause()

    # ----------------------------------------------------------------------------------------------- forward

    def start(self, stop_on_entry: bool = True) -> Stop | None:
        """Begin the run and go to its first statement, or to the first stop."""
        if stop_on_entry:
            return self._at(self._replay.go(lambda point: True, EVERY), "entry")
        return self.go_on()

    def go_on(self) -> Stop | None:
        """Continue to the next stop; None at the end."""
        return self._forward(None, "")

    def step_in(self) -> Stop | None:
        """Go to the next statement of the task, also inside a sub or a macro."""
        task = self._point().task
        return self._forward(lambda point: point.task is task or task.done, "step")

    def next(self) -> Stop | None:
        """Go to the next statement of the task, stepping over calls."""
        return self._over(0)

    def step_out(self) -> Stop | None:
        """Go to the first statement after the current sub or macro."""
        return self._over(-1)

    def _over(self, more: int) -> Stop | None:
        task, replay = self._point().task, self._replay
        depth = self._depth() + more
        return self._forward(
            lambda point: (point.task is task and replay.depth(task) <= depth) or task.done, "step"
        )

    def _depth(self) -> int:
        task = self._point().task
        return self._replay.query(lambda: self._replay.depth(task))

    def _point(self) -> Point:
        if self._replay.point is None:
            raise NotStopped
        return self._replay.point

    def _forward(self, steps: Callable[[Point], bool] | None, reason: str) -> Stop | None:
        """Continue to a breakpoint, a moment, or a point at which `steps` is true."""
        if self._replay.run is not None:
            return None
        if self.stop is not None and nextafter(self._after, INFINITY) < self.stop.time:
            moment = self._earliest(self._replay.point)
            if moment is not None:  # it came with the last one, before this statement
                return self._at_moment(moment)
        replay, start = self._replay, self._replay.point
        begin = 0 if start is None else start.number
        patience = Patience(replay, 0.0)
        self._next_search = replay.advances + STRIDE
        found: list[tuple[str, str]] = []
        searching = bool(self.searches) or self.stops_at_errors
        every = steps is not None or bool(self.watched)
        self._marks = [(begin, self.stop.time if self.stop else 0.0)]

        def decide(point: Point) -> bool:
            hit = self._hit(point, True)
            if hit is not None:
                found.append(hit)
                return True
            if steps is not None and steps(point):
                found.append((reason, ""))
                return True
            if steps is not None and start is not None:
                if point.task is start.task:
                    patience.renew()
                elif patience.is_over:
                    found.append(("pause", self._still_waits(start, point.time)))
                    return True
            if searching and point.number >= self._marks[-1][0] + STRIDE:
                self._marks.append((point.number, point.time))
                if not every:
                    self._replay.consider_from(point.number + STRIDE)
                if self._moments(point.time):
                    return True
                self._output.release(self._replay.written)
                self._output.hold()
            return False

        def give_up(time: float) -> bool:
            return (steps is not None and patience(time)) or (searching and self._has_moment(replay))

        if searching:
            self._output.hold()
        if self.watched and self._replay.point is not None:
            self._replay.query(lambda: self._note_values(self._point()))
        while True:
            limit = EVERY if every else begin + STRIDE if searching else INFINITY
            point = replay.go(decide, limit, self._stopping_offsets(), give_up)
            moment = self._earliest(point)
            if moment is not None:
                return self._to_moment(moment, begin)
            if replay.paused and point is None:
                return self._paused()
            if replay.gave_up and start is not None:
                text = self._still_waits(start, patience.reached)
                return self._arrive_on_replay(self._go_to(start.number), "pause", text)
            if point is None:
                return self._at(None, "")
            if found:
                return self._at(point, *found[-1])
            if self._replay.paused:
                return self._at(point, "pause")
            begin = point.number

    def _has_moment(self, replay: Replay) -> bool:
        """True if the log has a moment; it is searched each time that it has doubled."""
        if replay.advances < self._next_search:
            return False
        self._next_search = 2 * replay.advances
        return bool(self._moments(replay.machine.clock.now))

    def _still_waits(self, point: Point, time: float) -> str:
        scheduler = self._replay.machine.scheduler
        if scheduler is not None and scheduler.ended is not None:
            return f"the program has ended, but motion continues at {time:.9g} s"
        return f"line {self.location_of(point.offset)[0]} still waits at {time:.9g} s"

    def _counted_offsets(self) -> frozenset[int]:
        return frozenset(offset for each in self.breakpoints if each.is_counted for offset in each.offsets)

    def _stopping_offsets(self) -> frozenset[int]:
        return frozenset(offset for each in self.breakpoints for offset in each.offsets)

    def _at(self, point: Point | None, reason: str, text: str = "") -> Stop | None:
        """Make a point the stop, and show the output before it."""
        self._output.release(self._replay.written)
        if point is None:
            self.stop = None
            return None
        line, column, _ = self.location_of(point.offset)
        self.stop = Stop(point.number, point.time, point.task.name, line, column, reason, text)
        # What the statement itself causes has its time, too.
        self._after = nextafter(point.time, -INFINITY)
        found = self._replay.query(lambda: self._moments(point.time)) if self.searches else []
        if found:
            self._after = point.time
        return self.stop

    # ------------------------------------------------------------------------------------------- breakpoints

    def _hit(self, point: Point, live: bool) -> tuple[str, str] | None:
        """Return reason and text of a stop at a point; None if the program does not stop."""
        for watched in self.watched:
            change = watched.change(self._replay_in_force, point)
            if change:
                return "change", f"{change} before line {self.location_of(point.offset)[0]}"
        for each in self.breakpoints:
            if point.offset not in each.offsets:
                continue
            state = State(self, self._replay_in_force, point)
            try:
                if each.condition is not None and not each.condition(state):
                    continue
            except ValueError as error:
                return "breakpoint", f"the condition has no value: {error}"
            count = self._replay_in_force.hits[each] = self._replay_in_force.hits.get(each, 0) + 1
            if not each.counts(count):
                continue
            if each.message is None:
                return "breakpoint", each.text
            if live and point.number > self._logged:
                self._logged = point.number
                self._log_message(each.message(state))
        return None

    @property
    def _replay_in_force(self) -> Replay:
        return self._searching or self._replay

    def set_breakpoints(self, breakpoints: Iterable[Breakpoint]) -> None:
        """Replace all line breakpoints; hits are counted from the start of the program."""
        self.breakpoints = list(breakpoints)
        if self._replay.point is None:
            self._replay.hook.offsets = self._stopping_offsets()
        if any(each.is_counted for each in self.breakpoints) and self._replay.point is not None:
            self._go_to(self._replay.point.number)

    def offsets_at(self, line: int) -> tuple[int, ...]:
        """Return the source offsets at which execution of a line may begin."""
        offsets = self._lines.get(line, [])
        return (*offsets[:1], *(each for each in offsets[1:] if each in self._entries))

    def _note_values(self, point: Point) -> None:
        for watched in self.watched:
            watched.note(self._replay, point)

    # ----------------------------------------------------------------------------------------------- moments

    def _has_come(self, moment: Moment, point: Point) -> bool:
        """True if a moment has occurred by a point, according to the log.

        The statement that causes a moment may have the same time and not be executed yet.
        """
        return point.time >= moment.time and any(
            abs(each.time - moment.time) <= CLOSE for each in self._moments(point.time)
        )

    def _moments(self, until: float) -> list[Moment]:
        machine = self._replay_in_force.machine
        found = [each for search in self.searches for each in search(machine, self._after, until)]
        return sorted(found, key=lambda each: each.time)

    def _earliest(self, point: Point | None) -> Moment | None:
        """Return the first moment between the last stop and a point, or the end."""
        run = self._replay.run
        if not self.searches and not self.stops_at_errors:
            return None
        until = point.time if point is not None else self._end()
        found = self._replay.query(lambda: self._moments(until))
        if found:
            return moments.together(found)
        if point is None and run is not None and self.stops_at_errors and self._after < INFINITY:
            # Errors that did not end the program are moments of their own.
            passed = set(map(id, self._replay.machine.diagnostics))
            wrong = [each for each in run.diagnostics if each.severity == "error" and id(each) not in passed]
            if wrong:
                return moments.Moment(INFINITY, wrong[0].message, None, "exception")
        return None

    def _end(self) -> float:
        """Return the time, s, at which the run ended or gave up."""
        replay = self._replay
        return replay.run.time if replay.run is not None else replay.machine.clock.now

    def _to_moment(self, moment: Moment, begin: int) -> Stop | None:
        """Go to the first statement at or after a moment, or else to the last one."""
        last = self._replay.hook.count
        if moment.time < INFINITY:
            lowest = max([number for number, time in self._marks if time < moment.time], default=begin)
            here = self._replay.point
            if here is None or here.number > lowest + 1:
                self._go_to(lowest + 1, lambda point: self._has_come(moment, point), moment.time)
                last = self._replay.hook.count
        else:
            self._go_to(last)
        if self._replay.point is None and not self._replay.paused:
            self._go_to(last)
        return self._paused() if self._replay.paused else self._at_moment(moment)

    def _at_moment(self, moment: Moment) -> Stop | None:
        """Make the current statement the stop for a moment."""
        text = moment.text if moment.time == INFINITY else self._described(moment)
        stop = self._at(self._replay.point, moment.reason, text)
        self._after = moment.time
        if stop is not None and moment.time < stop.time:
            stop.moment = moment.time
        return stop

    # -------------------------------------------------------------------------------------------------- back

    def _go_to(
        self, number: int, decide: Callable[[Point], bool] | None = None, time: float = INFINITY
    ) -> Point | None:
        """Run again up to a statement, or from there to where `decide` is true.

        The replay gives up a while after `time`.
        """
        self._replay.abandon()
        self._replay = replay = self._new()
        counted = self._counted_offsets()

        def there(point: Point) -> bool:
            if point.offset in counted:
                self._hit(point, False)
            return point.number >= number and (decide is None or decide(point))

        self._last = number
        try:
            return replay.go(there, number - MEMORY, counted, Patience(replay, time))
        finally:
            self._last = 0

    def _arrive(self, number: int, reason: str, text: str = "") -> Stop | None:
        """Go to a statement and make it the stop, in this process or in a closer copy."""
        self._hand_over(number, "arrive", number, reason, text)
        return self._arrive_on_replay(self._go_to(number), reason, text)

    def _arrive_on_replay(self, point: Point | None, reason: str, text: str) -> Stop | None:
        """Make the end of a replay the stop, or the pause that ended it."""
        return self._paused() if self._replay.paused else self._at(point, reason, text)

    def _paused(self) -> Stop | None:
        """Make the statement of a pause, or the last one before it, the stop."""
        if self._replay.point is not None:
            return self._at(self._replay.point, "pause")
        self._can_interrupt = False  # the same Ctrl-C must not end this replay, too
        try:
            return self._arrive(self._replay.hook.count, "pause")
        finally:
            self._can_interrupt = True
            self._replay.interrupted = self._interrupted

    def _hand_over(self, number: int, *then: object) -> None:
        """Raise HandOver if a copy waits at or before a statement."""
        key = self.checkpoints.before(number) if self._may_hand_over() and self.checkpoints else None
        if key is not None:
            raise HandOver(key, *then)

    def _may_hand_over(self) -> bool:
        """False if a copy would lack the hit count of a breakpoint or a watched value."""
        return not self.watched and not any(each.is_counted for each in self.breakpoints)

    def state_for_copy(self) -> dict[str, object]:
        """Return the state that a copy needs to continue this session."""
        assert self.checkpoints is not None
        return {
            "journal": (self.journal.changes, self.journal.answers),
            "shown": self._output.shown,
            "logged": self._logged,
            "copies": (self.checkpoints.known, self.checkpoints.last_key),
        }

    def revive(self, state: Mapping[str, Any]) -> None:
        """Continue the session in this copy, with its state."""
        assert self.checkpoints is not None
        self.journal.changes, self.journal.answers = state["journal"]
        self._output.revive(state["shown"])
        self._logged = state["logged"]
        self.checkpoints.known, self.checkpoints.last_key = state["copies"]
        self._searching, self._last, self._history, self._marks = None, 0, [], []
        self._replay.revive()

    def resume(self, then: Sequence[Any]) -> Stop | None:
        """Do the work that remained when the session was handed over to this copy."""
        what, number, *rest = then
        if what == "arrive":
            return self._arrive_on(number, *rest)
        if what == "time":
            self._replay.go(lambda each: each.time >= number, EVERY, frozenset())
            point = self._replay.point
            return self._at(point, "goto") if point else self._arrive(self._replay.hook.count, "goto")
        task, depth = rest
        self._replay.recent = deque(self._replay.recent, REACH)
        self._run_on_to(number - 1, REACH)
        found = _before(self._replay.recent, number, task, depth)
        if found == number - 1:
            return self._at(self._replay.point, "step")
        if found is not None:
            return self._arrive(found, "step")
        begin = self._recorded_from()
        if begin > 1:
            self._hand_over(begin - 1, "back", number, task, depth)
            self._remember_more(number, number)
            found = _before(self._history, number, task, depth)
        return self._arrive(found or max(number - 1, 1), "step")

    def _arrive_on(self, number: int, reason: str, text: str) -> Stop | None:
        """Continue from an earlier statement to one that becomes the stop."""
        self._run_on_to(number, MEMORY)
        return self._arrive_on_replay(self._replay.point, reason, text)

    def _run_on_to(self, number: int, reach: int) -> None:
        point = self._replay.point
        if point is not None and point.number < number:
            self._last = number
            self._replay.go(lambda each: each.number >= number, number - reach, frozenset())
            self._last = 0

    def _search(self, last: int, first: int, note: Callable[[Point], None], offsets: frozenset[int]) -> None:
        """Run to a statement once more, and call `note` for points before it."""
        self._searching = replay = self._new()
        try:

            def decide(point: Point) -> bool:
                if point.number < last:
                    note(point)
                return point.number >= last

            self._last = last
            replay.go(decide, first, offsets)
            if replay.paused:
                raise Interrupted
        finally:
            replay.abandon()
            self._searching, self._last = None, 0

    def step_back(self) -> Stop | None:
        """Go to the previous statement of the task, stepping over calls."""
        if self._replay.run is not None:
            return self._arrive(self._replay.hook.count, "step")
        point, depth = self._point(), self._depth()
        found = _before(list(self._replay.recent), point.number, point.task.name, depth)
        if found is None:
            self._hand_over(self._recorded_from() - 1, "back", point.number, point.task.name, depth)
        reach = MEMORY
        while found is None and self._recorded_from() > 1:
            reach *= 16
            self._remember_more(point.number, reach)
            found = _before(self._history, point.number, point.task.name, depth)
            if reach >= point.number:
                break
        if found is None and point.number > 1:
            found = point.number - 1  # the task began here
        if found is None:
            return self._at(point, "start", "this is the first statement")
        return self._arrive(found, "step")

    def _recorded_from(self) -> int:
        return self._replay.recent[0].number

    def _remember_more(self, number: int, reach: int) -> None:
        self._history = []

        def note(point: Point) -> None:
            replay = self._replay_in_force
            self._history.append(
                Remembered(point.number, point.task.name, replay.depth(point.task), point.offset)
            )

        self._search(number, number - reach, note, frozenset())

    def reverse(self) -> Stop | None:
        """Go back to the last breakpoint or moment before this stop, or to the beginning."""
        ended = self._replay.run is not None
        here = self._replay.hook.count + 1 if ended else self._point().number
        hits: list[tuple[int, str, str]] = []

        def note(point: Point) -> None:
            hit = self._hit(point, False)
            if hit is not None:
                hits.append((point.number, *hit))

        moment = self._last_moment()
        if self.breakpoints or self.watched:
            first = EVERY if self.watched else here
            self._search(here, first, note, self._stopping_offsets())
        if moment is not None and moment[0] < here and (not hits or moment[0] > hits[-1][0]):
            hits.append(moment)
        if not hits:
            return self._arrive(1, "start", "this is the first statement")
        number, reason, text = hits[-1]
        return self._arrive(number, reason, text)

    def _last_moment(self) -> tuple[int, str, str] | None:
        """Return the stop after the last moment before this one: number, reason, text."""
        if not self.searches:
            return None
        run, stop = self._replay.run, self.stop
        end = run.time if run is not None else stop.time if stop is not None else 0.0
        here = self._replay.hook.count + 1 if run is not None else self._point().number
        after, self._after = self._after, -1.0
        try:
            found = self._replay.query(lambda: self._moments(end))
        finally:
            self._after = after
        while found:
            moment = found.pop()
            number = self._first_after(moment, here)
            if number is None:
                number = self._replay.hook.count if run is not None else here
            if number < here:
                return number, moment.reason, self._described(moment)
        return None

    def _described(self, moment: Moment) -> str:
        where = "" if moment.at is None or moment.at < 0 else f" in line {self.location_of(moment.at)[0]}"
        return f"{moment.text} at {moment.time:.9g} s{where}"

    def _first_after(self, moment: Moment, before: int) -> int | None:
        """Return the number of the first statement after a moment, if below `before`."""
        found: list[int] = []

        def note(point: Point) -> None:
            if not found and self._has_come(moment, point):
                found.append(point.number)

        after, self._after = self._after, -1.0
        try:
            self._search(before, EVERY, note, frozenset())
        finally:
            self._after = after
        return found[0] if found else None

    def go_to_time(self, time: float) -> Stop | None:
        """Go to the first statement at or after a time, or to the last statement."""
        key = self.checkpoints.before_time(time) if self.checkpoints and self._may_hand_over() else None
        if key is not None:
            raise HandOver(key, "time", time)
        self._replay.abandon()
        self._output.hold()
        self._replay = replay = self._new()
        before = 0
        patience = Patience(replay, time)

        def decide(point: Point) -> bool:
            nonlocal before
            if point.time >= time:
                return True
            before = point.number
            replay.consider_from(before + STRIDE)
            return False

        def give_up(now: float) -> bool:
            nonlocal before
            if now < time:
                before = replay.hook.count
            else:
                replay.consider_next()
            return patience(now)

        point = replay.go(decide, EVERY, None, give_up)
        if replay.paused:
            return self._paused()
        if point is None:
            point = self._go_to(replay.hook.count)
        if point is not None and point.time >= time and point.number > before + 1:
            point = self._go_to(before + 1, lambda each: each.time >= time, time)
        return self._arrive_on_replay(point, "goto", "")

    def go_to_line(self, line: int) -> Stop | None:
        """Go to the next execution of a line; stay if there is none."""
        offsets, counted = frozenset(self.offsets_at(line)), self._counted_offsets()
        before = self._point().number
        self._output.hold()

        def decide(point: Point) -> bool:
            if point.offset in counted:
                self._hit(point, False)
            return point.offset in offsets

        point = self._replay.go(decide, INFINITY, offsets | counted)
        if self._replay.paused:
            return self._paused()
        if point is None:
            return self._arrive(before, "goto", f"line {line} does not begin again")
        return self._at(point, "goto")

    def go_back_to_line(self, line: int) -> Stop | None:
        """Go back to the previous execution of a line; stay if there is none."""
        offsets, found = frozenset(self.offsets_at(line)), [0]
        ended = self._replay.run is not None
        here = self._replay.hook.count + 1 if ended else self._point().number
        self._search(here, here, lambda point: found.append(point.number), offsets)
        if not found[-1]:
            return self.stay(f"line {line} has not begun before")
        return self._arrive(found[-1], "goto")

    def last_change(self, path: Sequence[str]) -> Stop | None:
        """Go back to the statement that last changed a variable, an axis or a channel.

        Returns None if there is no such statement.
        """
        point = self._point()
        watched = Watched(tuple(path))
        replay, previous, found = self._replay, 0, 0
        values: dict[tuple[str, ...], object] = {}

        def note(each: Point) -> None:
            nonlocal previous, found, values
            if watched.change(self._replay_in_force, each):
                found = previous
            previous, values = each.number, self._replay_in_force.values

        self._search(point.number, EVERY, note, frozenset())
        replay.values |= values
        if replay.query(lambda: watched.change(replay, point)):
            found = previous
        if not found:
            return None
        return self._arrive(found, "change", f"this statement changes {path[-1]}")

    # ------------------------------------------------------------------------------------------------ changes

    def assign(self, path: Sequence[str], value: object) -> Variable:
        """Change the value of a variable; raise ValueError if that is not possible."""
        point, replay = self._point(), self._replay
        variable = replay.query(lambda: scopes.find(replay.hook, point, path))
        if variable is None:
            raise ValueError(f"there is no variable {path[-1]} here")
        if variable.set is None:
            raise ValueError(f"{variable.name} cannot be set; set one of its elements")
        give = variable.set
        replay.query(lambda: give(value))
        self._changed()
        self.journal.add(Assigned(point.number, tuple(path), value))
        found = replay.query(lambda: scopes.find(replay.hook, point, path))
        assert found is not None
        return found

    def enter(self, entries: Mapping[str, object]) -> None:
        """Change inputs or press keys now; the entries are those of a machine file."""
        point = self._point()
        self._replay.enter(entries)
        self._changed()
        self.journal.add(Entered(point.number, dict(entries)))

    def _changed(self) -> None:
        """Allow output from here on to be shown again, because the run now differs."""
        self._output.forget(self._replay.written)
        self._logged = min(self._logged, self._point().number)
        if self.checkpoints is not None:
            self.checkpoints.forget_from(self._point().number)

    def restart(self, source: Source) -> Stop | None:
        """Run another text with the same journal, up to the time of the stop.

        Raises ProgramError, and changes nothing, if the text has errors.
        """
        time = self.stop.time if self.stop is not None else 0.0
        self._load(source)
        self._replay.abandon()
        if self.checkpoints is not None:
            self.checkpoints.forget_from(0)
        self._output.forget(0)
        return self.go_to_time(time)


def _before(recent: Iterable[Remembered], number: int, task: str, depth: int) -> int | None:
    """Return a task's last statement before a number, in at most `depth` calls."""
    found = None
    for each in recent:
        if each.number < number and each.task == task and each.depth <= depth:
            found = each.number
    return found
