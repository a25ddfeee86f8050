"""Replay a log on a virtual board, and compare its answers.

Problem. A log was recorded on a real board, or on a virtual one in real time. A position read in motion depends
on the moment of reading, which is known only to lie between begin and end of the call.

Idea. Every call is made at its start, in virtual time. Result codes, states and settings must be equal. A
quantity that was read in motion must lie within the range that it covers in the replay from begin - skew to
end + skew. At rest it must be equal within the tolerance. A blocking call may take longer or shorter by skew.

Data. The track of an axis has its past positions, so a quantity that differs is checked again when machine
time has passed end + skew. A status word is masked by the bits of motion if the axis moves in that time.

Cost. One pass over the calls: a check waits for skew seconds at most.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import isclose

from motionlang.kernel.mccl.axis import flags
from motionlang.kernel.tools import count_of
from motionlang_mcapi.call import ApiCall
from motionlang_mcapi.calls.controller import MODELS
from motionlang_mcapi.client import VirtualBoard
from motionlang_mcapi.log import LoggedCall, model_of, read
from motionlang_mcapi.protocol import encode, request
from motionlang_mcapi.session import BadCall, HostProcess
from motionlang_mcapi.table import STRUCTURES, Value

# Quantities that change while an axis moves, by what each is in the track of the axis. The track has no following
# error: in motion any is accepted, and at rest one within the tolerance.
MOVING = {
    "MCGetPositionEx": "position",
    "MCGetOptimalEx": "position",
    "MCGetTargetEx": "position",
    "MCGetVelocityActual": "velocity",
    "MCGetFollowingError": "error",
}
STATES = frozenset(
    {
        "MCGetStatus",
        "MCGetStatusEx",
        "MCIsStopped",
        "MCIsAtTarget",
        "MCIsIndexFound",
        "MCIsEdgeFound",
        "pmcrdy",
    }
)
# Bits of the primary status word that depend on the moment while an axis moves.
MOTION_BITS = (
    flags.TRAJECTORY_COMPLETE
    | flags.AT_TARGET
    | flags.DIRECTION
    | flags.REACHED
    | flags.INDEX_INPUT
    | flags.INPUTS["home"]
)
# Seconds by which the times of a log may be off.
SKEW = 0.01
# Points of a track in the time of a check.
SAMPLES = 32
# Half a count: positions are reported in whole ones.
ROUNDED = 0.5
# Seconds by which a replay runs past the last call.
REST = 1e-3


@dataclass(eq=False, slots=True)
class AnswerDifference:
    """A call whose answer differs, in a code, state, setting, position or time."""

    entry: LoggedCall
    kind: str
    text: str


@dataclass(eq=False, slots=True)
class _Check:
    """A difference that is reported only if the track up to `due` does not explain it."""

    due: float
    entry: LoggedCall
    found: tuple[Value, ...]
    text: str
    kind: str


class CallReplay:
    """Carries out the calls of a log and collects the differences.

    `first` is the first difference in the log, `counts` their number by kind.
    """

    def __init__(self, board: VirtualBoard, skew: float = SKEW, tolerance: float = 0.0) -> None:
        self._board, self._skew, self._tolerance = board, skew, tolerance
        self._sessions: dict[int, HostProcess] = {}
        self._handles: dict[tuple[int, int], int] = {}
        self._checks: deque[_Check] = deque()
        self._open: dict[int, LoggedCall] = {}
        self.calls = 0
        self.first: AnswerDifference | None = None
        self.counts: dict[str, int] = {}

    def run(self, entries: Iterable[LoggedCall]) -> None:
        """Carry out all calls."""
        end = 0.0
        for entry in entries:
            self._reach(entry.begin)
            self._call(entry)
            end = max(end, entry.end)
        # A check is due later than that if a blocking call took longer here than in the log.
        self._reach(max([end + self._skew + REST, *(check.due for check in self._checks)]))
        for entry in self._open.values():
            self._differs(
                entry, "time", f"the call took {entry.end - entry.begin:.4f} s, and does not end here"
            )

    def _reach(self, time: float) -> None:
        """Advance machine time and make the checks that become due."""
        console = self._board.console
        while self._checks and self._checks[0].due <= time:
            check = self._checks.popleft()
            if console.now < check.due:
                console.run(check.due)
            self._settle(check)
        if console.now < time:
            console.run(time)

    def _call(self, entry: LoggedCall) -> None:
        self.calls += 1
        session = self._sessions.get(entry.host)
        if session is None:
            session = self._sessions[entry.host] = self._board.desk.session()
        handle = self._handles.get((entry.host, entry.handle), entry.handle)
        self._open[entry.line] = entry
        try:
            call = session.call(
                entry.name, handle, entry.arguments, lambda ended: self._compare(entry, ended)
            )
        except BadCall as problem:
            del self._open[entry.line]
            self._differs(entry, "code", f"this is no call: {problem}")
            return
        if not call.done and entry.end - entry.begin <= self._skew:
            # Nearly every call: it takes some 10 µs here, and ends before the next one begins.
            self._board.console.run_until(lambda: call.done, entry.end + self._skew)

    @property
    def summary(self) -> str:
        """The number of calls, and the differences by kind."""
        count = 0
        for number in self.counts.values():
            count += number
        kinds = ", ".join(f"{number} of {kind}" for kind, number in sorted(self.counts.items()))
        calls, differences = count_of(self.calls, "call"), count_of(count, "difference")
        return f"{calls}, {differences}{f': {kinds}' if kinds else ''}"

    # --------------------------------------------------------------------------------------------- comparing

    def _compare(self, entry: LoggedCall, call: ApiCall) -> None:
        self._open.pop(entry.line, None)
        if entry.name == "MCOpen" and call.value > 0 and isinstance(entry.result, int):
            self._handles[entry.host, entry.result] = call.value
        result = call.result
        if abs((call.end - call.begin) - (entry.end - entry.begin)) > self._skew:
            took, here = entry.end - entry.begin, call.end - call.begin
            self._differs(entry, "time", f"the call took {took:.4f} s, here {here:.4f} s")
        elif entry.result is not None and not self._same_result(entry, result):
            self._result_differs(entry, call, result)
        elif len(entry.outputs) != len(call.outputs):
            self._differs(
                entry, "code", f"the answer is {_shown(entry)}, here {encode((result, *call.outputs))}"
            )
        elif not all(map(self._same, entry.outputs, call.outputs)):
            self._outputs_differ(entry, call)

    def _same_result(self, entry: LoggedCall, result: int) -> bool:
        return entry.result == result or (
            entry.name == "MCOpen" and entry.result is not None and entry.result > 0 and result > 0
        )

    def _result_differs(self, entry: LoggedCall, call: ApiCall, result: int) -> None:
        text = f"the result is {entry.result}, here {result}"
        if entry.name in STATES:
            self._later(entry, (result,), text, "state")
        else:
            self._differs(entry, "code" if not call.function.is_value else "setting", text)

    def _outputs_differ(self, entry: LoggedCall, call: ApiCall) -> None:
        text = _difference(entry, call)
        if entry.name in MOVING:
            self._later(entry, call.outputs, text, "position")
        elif entry.name in STATES:
            self._later(entry, call.outputs, text, "state")
        else:
            self._differs(entry, "setting", text)

    def _same(self, logged: Value | None, here: Value) -> bool:
        if isinstance(logged, str) or isinstance(here, str) or logged is None:
            return logged == here
        return logged == here or isclose(logged, here, rel_tol=1e-9, abs_tol=1e-12)

    def _later(self, entry: LoggedCall, found: tuple[Value, ...], text: str, kind: str) -> None:
        due = max(entry.end, self._board.now) + self._skew
        self._checks.append(_Check(due, entry, found, text, kind))

    def _differs(self, entry: LoggedCall, kind: str, text: str) -> None:
        self.counts[kind] = self.counts.get(kind, 0) + 1
        if self.first is None or entry.line < self.first.entry.line:
            self.first = AnswerDifference(entry, kind, text)

    # --------------------------------------------------------------------------- what was read in motion

    def _settle(self, check: _Check) -> None:
        """Report a difference unless the track explains it."""
        entry = check.entry
        axis = entry.arguments[0] if entry.arguments else 0
        axes = [axis] if axis in self._board.console.board.axes else self._board.console.board.numbers
        times = [entry.begin - self._skew, entry.end + self._skew]
        if check.kind == "state":
            moved = any(self._moved(int(each or 0), *times) for each in axes)
            if moved and _same_but_for_motion(entry, check.found):
                return
        elif self._lies_within(entry, int(axis or 0), *times):
            return
        self._differs(entry, check.kind, check.text)

    def _moved(self, axis: int, begin: float, end: float) -> bool:
        values = self._track("position", axis, begin, end)
        return max(values) > min(values)

    def _lies_within(self, entry: LoggedCall, axis: int, begin: float, end: float) -> bool:
        quantity, logged = MOVING[entry.name], entry.outputs[0]
        state = self._board.console.board.axes.get(axis)
        if state is None or not isinstance(logged, (int, float)):
            return False
        if quantity == "error":
            return self._moved(axis, begin, end) or abs(logged) <= self._tolerance
        values = self._track(quantity, axis, begin, end)
        counts = (
            state.scale.position_to_counts(logged) - state.shift
            if quantity == "position"
            else state.scale.to_counts(logged, "uu/s")
        )
        margin = self._tolerance + (ROUNDED if max(values) > min(values) or not state.scaled else 0.0)
        return min(values) - margin <= counts <= max(values) + margin

    def _track(self, quantity: str, axis: int, begin: float, end: float) -> list[float]:
        """Return the positions or velocities of an axis in a past time span."""
        controller = self._board.console.board.controller
        a = controller.axes[axis]
        begin = max(begin, 0.0)
        times = [begin + (end - begin) * k / SAMPLES for k in range(SAMPLES + 1)]
        times += [start for start in a.starts[-SAMPLES:] if begin < start < end]
        times.sort()
        if quantity == "velocity":
            return [a.velocity(time) for time in times]
        from motionlang.kernel.tracks import recall

        return recall(controller, axis, "actual", times)


def _same_but_for_motion(entry: LoggedCall, found: tuple[Value, ...]) -> bool:
    """True if two states differ only in bits that motion changes."""
    if entry.name in ("MCGetStatus", "MCGetStatusEx"):
        logged = entry.outputs[0] if entry.outputs else entry.result
        return int(logged or 0) & ~MOTION_BITS == int(found[0]) & ~MOTION_BITS
    return True


def _shown(entry: LoggedCall) -> str:
    return encode((entry.result, *entry.outputs))


def _difference(entry: LoggedCall, call: ApiCall) -> str:
    """Return the first value that differs, with its name."""
    names: list[str] = []
    for each in call.function.outputs:
        if each.kind in STRUCTURES:
            names += STRUCTURES[each.kind].names()
        else:
            names.append(each.name)
    for k, (logged, here) in enumerate(zip(entry.outputs, call.outputs, strict=True)):
        if logged != here:
            name = names[min(k, len(names) - 1)]
            if name == "ControllerType":
                return f"the log is of a {_model(logged)}, this board is a {_model(here)}"
            return f"{name} is {encode([logged])}, here {encode([here])}"
    return f"the answer is {_shown(entry)}"


def _model(number: Value | None) -> str:
    return next((name for name, each in MODELS.items() if each[0] == number), f"model {number}")


def replay_file(
    path: str, settings: Mapping[str, object], skew: float = SKEW, tolerance: float = 0.0
) -> CallReplay:
    """Replay the log of a file.

    The model is that of the log unless the settings name one.

    Raises BadLog, OSError, and Rejected for a machine that cannot be made.
    """
    with open(path, "rb") as file:
        model = model_of(file)
        file.seek(0)
        board = VirtualBoard({"controller.model": model, **settings}, complain=lambda text: None)
        replay = CallReplay(board, skew, tolerance)
        replay.run(read(file))
    return replay


def call_of(entry: LoggedCall) -> str:
    """Return the call of an entry as it appears in the log."""
    return request(entry.name, entry.handle, entry.arguments)
