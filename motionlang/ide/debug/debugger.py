"""The debugger: forward and back through a run, breakpoints, and manual changes.

Problem. A user stops a program and asks how it reached this state. By then the run has moved on.

Idea. A stop is identified by the number of a statement. To go forward, the waiting thread of the run continues. To go
back, the run is put back to a checkpoint before the statement and goes on to it (`replay.py`). A search for the last
statement of some kind begins at the last checkpoint before the stop, then at the second, fourth, eighth last and so on,
and each time runs up to the stop again.

Moments without a statement, such as a limit in the middle of a wait, are found in the log, whenever the run stops and
every `STRIDE` statements. The first statement after the moment becomes the stop, or the last statement if the program
ends before that.

A program may wait for something that never happens, while events go on for eight hours. A command that needs a
statement gives up after as many advances of the clock as the run has made so far (`Patience`), which are the same in
every run. The last statement is then the stop. `go_on` and `go_to_line` run on, until they are paused.

Invariants.
- There is one run. After each command it is stopped at `stop`, or ended (`stop` is None, `run` has the result).
- A command that is cancelled or paused leaves the run at the statement that it has reached.
- The same commands give the same stops, and no command changes the result of the run. Manual changes are in the
  journal.
- Hit counts count executed statements from the start of the program. Skipped iterations of a polling loop execute
  none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import nextafter
from typing import Concatenate, ParamSpec, TypeVar

from motionlang.ide.debug import moments, scopes
from motionlang.ide.debug.breakpoints import Breakpoint, Watched
from motionlang.ide.debug.checkpoints import Checkpoint
from motionlang.ide.debug.journal import Assigned, Entered, Journal
from motionlang.ide.debug.moments import Occurrence, Search
from motionlang.ide.debug.replay import EVERY, PAUSE, Replay, SessionOutput, Setup, StopPoint
from motionlang.ide.debug.state import StoppedRun
from motionlang.kernel import DEFAULT_AXES, INFINITY, Dialect, Run, Source, Variable

Given = ParamSpec("Given")

Found = TypeVar("Found")

# Statements between two searches of the log.
STRIDE = 4096
# Two searches find the same moment within this time, s: that of a condition depends on the samples.
CLOSE = 1e-8
# The advances of the clock that a command always waits; it waits longer if the run up to there took more.
ADVANCES = 16384


@dataclass(eq=False, slots=True)
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


class _Paused(Exception):
    """A search has been paused or cancelled."""


def _search(
    command: Callable[Concatenate[Debugger, Given], Stop | None],
) -> Callable[Concatenate[Debugger, Given], Stop | None]:
    """Make the statement at which a search is paused the stop."""

    def searching(debugger: Debugger, /, *arguments: Given.args, **named: Given.kwargs) -> Stop | None:
        try:
            return command(debugger, *arguments, **named)
        except _Paused:
            return debugger._paused()

    return searching


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
        self._output = SessionOutput(show)
        self.breakpoints: list[Breakpoint] = []
        # The source offsets at which hits are counted.
        self._counted: frozenset[int] = frozenset()
        self.searches: list[Search] = []
        self.watched: list[Watched] = []
        self.stops_at_errors = False
        self.stop: Stop | None = None
        self.source = source
        self._lines: dict[int, list[int]] = {}
        self._locations: dict[int, tuple[int, int, int]] = {}
        # Called with the fraction of a long replay that is done, and the last statement of the one that goes on.
        self.progress: Callable[[float], None] = lambda fraction: None
        self._last = 0
        self._load(source)
        self._replay = self._new()
        # The time up to which moments have been searched, and the number of the statement of the last log point.
        self._after, self._logged = -1.0, 0
        # The numbers and times at which the run has been checked since the last stop.
        self._marks: list[tuple[int, float]] = []
        # The advances of the clock after which moments are searched.
        self._next_search = STRIDE

    def _load(self, source: Source) -> None:
        program = self.language.program(source, self._settings, is_debug=True)
        program.require()
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
        return Replay(self._setup, self.journal, self._output, self._ask, self._meanwhile)

    def _meanwhile(self) -> None:
        """Pause the run after Ctrl-C, and report the progress of a replay."""
        if self._interrupted is not None and self._can_interrupt and self._interrupted():
            self.pause()
        if self._last:
            self.progress(min(self._replay.hook.count / self._last, 1.0))

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

    def state(self) -> StoppedRun:
        """Return the state at the stop, or at the end.

        Raises NotStopped before the first statement.
        """
        replay = self._replay
        if replay.point is None and replay.run is None:
            raise NotStopped
        return StoppedRun(self, replay)

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
        self._replay.pause()

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
        return self._replay.depth(task)

    def _point(self) -> StopPoint:
        if self._replay.point is None:
            raise NotStopped
        return self._replay.point

    def _forward(self, steps: Callable[[StopPoint], bool] | None, reason: str) -> Stop | None:
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

        def decide(point: StopPoint) -> bool:
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
            self._note_values(self._point())
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

    def _still_waits(self, point: StopPoint, time: float) -> str:
        scheduler = self._replay.machine.scheduler
        if scheduler is not None and scheduler.ended is not None:
            return f"the program has ended, but motion continues at {time:.9g} s"
        return f"line {self.location_of(point.offset)[0]} still waits at {time:.9g} s"

    def _stopping_offsets(self) -> frozenset[int]:
        return frozenset(offset for each in self.breakpoints for offset in each.offsets)

    def _at(self, point: StopPoint | None, reason: str, text: str = "") -> Stop | None:
        """Make a point the stop, and show the output before it."""
        self._output.release(self._replay.written)
        if point is None:
            self.stop = None
            return None
        line, column, _ = self.location_of(point.offset)
        self.stop = Stop(point.number, point.time, point.task.name, line, column, reason, text)
        # What the statement itself causes has its time, too.
        self._after = nextafter(point.time, -INFINITY)
        found = self._moments(point.time) if self.searches else []
        if found:
            self._after = point.time
        return self.stop

    # ------------------------------------------------------------------------------------------- breakpoints

    def _hit(self, point: StopPoint, live: bool) -> tuple[str, str] | None:
        """Return reason and text of a stop at a point; None if the program does not stop."""
        hit = self._line_hit(point, live)
        for watched in self.watched:
            change = watched.change(self._replay, point)
            if change:
                return "change", f"{change} before line {self.location_of(point.offset)[0]}"
        return hit

    def _count_hits(self, point: StopPoint) -> None:
        if point.offset in self._counted:
            self._line_hit(point, False)

    def _line_hit(self, point: StopPoint, live: bool) -> tuple[str, str] | None:
        for each in self.breakpoints:
            if point.offset not in each.offsets:
                continue
            state = StoppedRun(self, self._replay, point)
            try:
                if each.condition is not None and not each.condition(state):
                    continue
            except ValueError as error:
                return "breakpoint", f"the condition has no value: {error}"
            count = self._replay.hits[each] = self._replay.hits.get(each, 0) + 1
            if not each.counts(count):
                continue
            if each.message is None:
                return "breakpoint", each.text
            if live and point.number > self._logged:
                self._logged = point.number
                self._log_message(each.message(state))
        return None

    def set_breakpoints(self, breakpoints: Iterable[Breakpoint]) -> None:
        """Replace all line breakpoints; hits are counted from the start of the program."""
        self.breakpoints = list(breakpoints)
        self._counted = frozenset().union(*[each.offsets for each in self.breakpoints if each.is_counted])
        if self._replay.point is None:
            self._replay.hook.offsets = self._stopping_offsets()
        if any(each.is_counted for each in self.breakpoints) and self._replay.point is not None:
            number = self._replay.point.number
            self._replay.back(None)
            self._go_on_to(number)

    def offsets_at(self, line: int) -> tuple[int, ...]:
        """Return the source offsets at which execution of a line may begin."""
        offsets = self._lines.get(line, [])
        return (*offsets[:1], *(each for each in offsets[1:] if each in self._entries))

    def _note_values(self, point: StopPoint) -> None:
        for watched in self.watched:
            watched.note(self._replay, point)

    # ----------------------------------------------------------------------------------------------- moments

    def _has_come(self, moment: Occurrence, point: StopPoint) -> bool:
        """True if a moment has occurred by a point, according to the log.

        The statement that causes a moment may have the same time and not be executed yet.
        """
        return point.time >= moment.time and any(
            abs(each.time - moment.time) <= CLOSE for each in self._moments(point.time)
        )

    def _moments(self, until: float) -> list[Occurrence]:
        machine = self._replay.machine
        found = [each for search in self.searches for each in search(machine, self._after, until)]
        return sorted(found, key=lambda each: each.time)

    def _earliest(self, point: StopPoint | None) -> Occurrence | None:
        """Return the first moment between the last stop and a point, or the end."""
        run = self._replay.run
        if not self.searches and not self.stops_at_errors:
            return None
        until = point.time if point is not None else self._end()
        found = self._moments(until)
        if found:
            return moments.together(found)
        if point is None and run is not None and self.stops_at_errors and self._after < INFINITY:
            # Errors that did not end the program are moments of their own.
            passed = set(map(id, self._replay.machine.diagnostics))
            wrong = [each for each in run.diagnostics if each.severity == "error" and id(each) not in passed]
            if wrong:
                return moments.Occurrence(INFINITY, wrong[0].message, None, "exception")
        return None

    def _end(self) -> float:
        """Return the time, s, at which the run ended or gave up."""
        replay = self._replay
        return replay.run.time if replay.run is not None else replay.machine.clock.now

    def _to_moment(self, moment: Occurrence, begin: int) -> Stop | None:
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

    def _at_moment(self, moment: Occurrence) -> Stop | None:
        """Make the current statement the stop for a moment."""
        text = moment.text if moment.time == INFINITY else self._described(moment)
        stop = self._at(self._replay.point, moment.reason, text)
        self._after = moment.time
        if stop is not None and moment.time < stop.time:
            stop.moment = moment.time
        return stop

    # -------------------------------------------------------------------------------------------------- back

    def _go_to(
        self, number: int, decide: Callable[[StopPoint], bool] | None = None, time: float = INFINITY
    ) -> StopPoint | None:
        """Go back, and on to a statement, or from there to where `decide` is true.

        The run gives up a while after `time`.
        """
        self._replay.back(next(self._beginnings(number)), number)
        return self._go_on_to(number, decide, time)

    def _go_on_to(
        self, number: int, decide: Callable[[StopPoint], bool] | None = None, time: float = INFINITY
    ) -> StopPoint | None:
        replay = self._replay

        def there(point: StopPoint) -> bool:
            self._count_hits(point)
            return point.number >= number and (decide is None or decide(point))

        self._last = number
        try:
            return replay.go(there, number, self._counted, Patience(replay, time))
        finally:
            self._last = 0

    def _beginnings(self, number: int) -> Iterator[Checkpoint | None]:
        """Yield the last checkpoint before a statement, the second, fourth, eighth last, and the start."""
        known = self._replay.checkpoints.before(number)
        distance = 1
        while distance <= len(known):
            yield known[-distance]
            distance *= 2
        yield None

    def _arrive(self, number: int, reason: str, text: str = "") -> Stop | None:
        """Go to a statement and make it the stop."""
        return self._arrive_on_replay(self._go_to(number), reason, text)

    def _arrive_on_replay(self, point: StopPoint | None, reason: str, text: str) -> Stop | None:
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

    def _last_before(
        self, last: int, find: Callable[[StopPoint], Found | None], offsets: frozenset[int] | None = None
    ) -> tuple[int, Found] | None:
        """Return the last statement up to `last` for which `find` returns something, and that.

        Only statements at `offsets` are considered if they are given. The run is then at statement `last`.
        """
        replay, found = self._replay, None
        for begin in self._beginnings(last):

            def decide(point: StopPoint) -> bool:
                nonlocal found
                what = find(point)
                if what is not None:
                    found = point.number, what
                return point.number >= last

            replay.back(begin, last)
            self._last = last
            try:
                replay.go(decide, EVERY if offsets is None else last, offsets)
            finally:
                self._last = 0
            if replay.paused:
                raise _Paused
            if found is not None:
                break
        return found

    @_search
    def step_back(self) -> Stop | None:
        """Go to the previous statement of the task, stepping over calls."""
        if self._replay.run is not None:
            return self._arrive(self._replay.hook.count, "step")
        point, depth = self._point(), self._depth()
        if point.number == 1:
            return self._at(point, "start", "this is the first statement")
        name, here = point.task.name, point.number

        def is_before(each: StopPoint) -> bool | None:
            self._count_hits(each)
            is_of_task = each.number < here and each.task.name == name
            return True if is_of_task and self._replay.depth(each.task) <= depth else None

        found = self._last_before(here, is_before)
        # A task that began here has none.
        return self._arrive(here - 1 if found is None else found[0], "step")

    @_search
    def reverse(self) -> Stop | None:
        """Go back to the last breakpoint or moment before this stop, or to the beginning."""
        here, found = self._here(), self._last_moment()

        def hit(point: StopPoint) -> tuple[str, str] | None:
            what = self._hit(point, False)
            return what if point.number < here else None

        if self.breakpoints or self.watched:
            offsets = None if self.watched else self._stopping_offsets()
            last = self._last_before(here, hit, offsets)
            if last is not None and (found is None or last[0] >= found[0]):
                found = last
        if found is None:
            return self._arrive(1, "start", "this is the first statement")
        number, (reason, text) = found
        return self._arrive(number, reason, text)

    def _here(self) -> int:
        """Return the number of the statement at the stop; at the end, that after the last one."""
        return self._replay.hook.count + 1 if self._replay.run is not None else self._point().number

    def _last_moment(self) -> tuple[int, tuple[str, str]] | None:
        """Return the stop after the last moment before this one: number, reason and text."""
        if not self.searches:
            return None
        run, stop, here = self._replay.run, self.stop, self._here()
        end = run.time if run is not None else stop.time if stop is not None else 0.0
        after, self._after = self._after, -1.0
        try:
            found = self._moments(end)
            while found:
                moment = found.pop()
                number = self._first_after(moment, here)
                if number is None:
                    number = here - 1 if run is not None else here
                if number < here:
                    return number, (moment.reason, self._described(moment))
        finally:
            self._after = after
        return None

    def _described(self, moment: Occurrence) -> str:
        where = "" if moment.at is None or moment.at < 0 else f" in line {self.location_of(moment.at)[0]}"
        return f"{moment.text} at {moment.time:.9g} s{where}"

    def _first_after(self, moment: Occurrence, before: int) -> int | None:
        """Return the number of the first statement after a moment, if below `before`."""
        replay = self._replay

        def has_come(point: StopPoint) -> bool:
            self._count_hits(point)
            return point.number >= before or self._has_come(moment, point)

        replay.back(replay.checkpoints.before_time(moment.time), before)
        self._last = before
        try:
            point = replay.go(has_come, EVERY)
        finally:
            self._last = 0
        if replay.paused:
            raise _Paused
        return point.number if point is not None and point.number < before else None

    def go_to_time(self, time: float) -> Stop | None:
        """Go to the first statement at or after a time, or to the last statement."""
        replay = self._replay
        if replay.point is None or replay.point.time >= time:
            replay.back(replay.checkpoints.before_time(time))
        self._output.hold()

        def there(point: StopPoint) -> bool:
            self._count_hits(point)
            return point.time >= time

        point = replay.go(there, EVERY, None, Patience(replay, time))
        if replay.paused:
            return self._paused()
        if point is None:
            point = self._go_to(replay.hook.count)
        return self._arrive_on_replay(point, "goto", "")

    def go_to_line(self, line: int) -> Stop | None:
        """Go to the next execution of a line; stay if there is none."""
        offsets = frozenset(self.offsets_at(line))
        before = self._point().number
        self._output.hold()

        def decide(point: StopPoint) -> bool:
            self._count_hits(point)
            return point.offset in offsets

        point = self._replay.go(decide, INFINITY, offsets | self._counted)
        if self._replay.paused:
            return self._paused()
        if point is None:
            return self._arrive(before, "goto", f"line {line} does not begin again")
        return self._at(point, "goto")

    @_search
    def go_back_to_line(self, line: int) -> Stop | None:
        """Go back to the previous execution of a line; stay if there is none."""
        here = self._here()
        offsets = frozenset(self.offsets_at(line))

        def is_line(point: StopPoint) -> bool | None:
            self._count_hits(point)
            return True if point.offset in offsets and point.number < here else None

        found = self._last_before(here, is_line, offsets | self._counted)
        if found is None:
            return self.stay(f"line {line} has not begun before")
        return self._arrive(found[0], "goto")

    @_search
    def last_change(self, path: Sequence[str]) -> Stop | None:
        """Go back to the statement that last changed a variable, an axis or a channel; stay if there is none."""
        watched = Watched(tuple(path))
        found = self._last_before(
            self._point().number, lambda each: watched.change(self._replay, each) or None
        )
        if found is None:
            return self.stay(f"nothing has changed {path[-1]} yet")
        return self._arrive(found[0] - 1, "change", f"this statement changes {path[-1]}")

    # ------------------------------------------------------------------------------------------------ changes

    def assign(self, path: Sequence[str], value: object) -> Variable:
        """Change the value of a variable; raise ValueError if that is not possible."""
        point, replay = self._point(), self._replay
        variable = scopes.find(replay.hook, point, path)
        if variable is None:
            raise ValueError(f"there is no variable {path[-1]} here")
        if variable.set is None:
            raise ValueError(f"{variable.name} cannot be set; set one of its elements")
        give = variable.set
        give(value)
        self._changed()
        self.journal.add(Assigned(point.number, tuple(path), value))
        found = scopes.find(replay.hook, point, path)
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

    def restart(self, source: Source) -> Stop | None:
        """Run another text with the same journal, up to the time of the stop.

        Raises ProgramError, and changes nothing, if the text has errors.
        """
        time = self.stop.time if self.stop is not None else 0.0
        self._load(source)
        self._replay.abandon()
        self._replay = self._new()
        self._output.forget(0)
        return self.go_to_time(time)


class Patience:
    """A number of advances of the clock after `time`.

    It is as many as the run had made up to then, and at least `ADVANCES`.
    An instance is what `Replay.go` calls to give up: shortly after the end, for a statement of another task.
    """

    def __init__(self, replay: Replay, time: float) -> None:
        self._replay = replay
        self._last = INFINITY
        # The last time to which the clock has advanced.
        self._time = self.reached = time

    @property
    def is_over(self) -> bool:
        return self._replay.advances > self._last

    def renew(self) -> None:
        """Wait as long again, since the program makes progress."""
        self._last = self._replay.advances + max(ADVANCES, self._replay.advances)

    def __call__(self, time: float) -> bool:
        self.reached = time
        if self._last == INFINITY and time >= self._time:
            self.renew()
        return self._replay.advances > self._last + PAUSE
