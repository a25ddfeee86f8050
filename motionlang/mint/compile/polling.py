"""Loops that only poll: what is written into their turns so that those which cannot differ are skipped.

A turn that did nothing (`E.acts` counts what a program does) and left every variable as it was before will be repeated
as it was until something happens. `motionlang.mint.runtime.loop_skipping` pays for all those turns at once, to the
exact same end. A `Goto` back to an earlier label ends a turn as `End Loop` does.

    if w1 == (w3 := (E.acts, v_state)): t = k1(t, w2, H, (), w3, E.resumed - w4)
    if t >= H: t, H = yield t; w3 = (E.acts, v_state)
    w1 = w3; w2 = t; w4 = E.resumed
"""

from __future__ import annotations

from motionlang.mint.syntax import nodes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.compile.body import Body
    from motionlang.mint.compile.poll_analysis import Look

# A loop that gives more variables a value is not looked at turn by turn.
MOST_VARIABLES = 40


class Poll:
    """One loop that is watched, and the names of what is kept of its last turn: state, end, milliseconds waited."""

    __slots__ = ("before", "how", "now", "others", "since", "state", "waited", "watches")

    def __init__(self, b: Body, state: list[str], watches: list[str], reads: bool, waits: bool) -> None:
        self.how = "skip" if reads else "rest"
        self.before, self.since, self.now, self.others = b.temp(), b.temp(), b.temp(), b.temp()
        self.waited = b.temp() if waits and reads else ""
        self.state = f"(E.acts, {', '.join(state)})" if state else "(E.acts,)"
        self.watches = f"({', '.join(watches)},)" if watches else "()"

    def first(self, time: str) -> str:
        """What stands before the first turn."""
        more = f"; {self.waited} = 0.0" if self.waited else ""
        return f"{self.before} = None; {self.since} = {time}; {self.others} = 0{more}"


def watched(b: Body, body: list[nodes.Stmt], *conditions: nodes.Expr) -> Poll | None:
    """The watch on a loop, None where it would never find anything to skip."""
    if any(_plainly_acts(b, node) for node in body):
        return None
    poll = _poll(b, _look(b, body, conditions, is_written=False))
    if poll is not None:
        b.emit(poll.first("t"))
    return poll


def look_at_jump(b: Body, body: list[nodes.Stmt]) -> Look:
    """What there is to watch in a turn that a Goto ends by leading back over these statements."""
    return _look(b, body, (), is_written=True)


def watched_jump(b: Body, look: Look) -> Poll | None:
    """The watch on a Goto that ends a turn which has been looked at."""
    return _poll(b, look)


def _look(b: Body, body: list[nodes.Stmt], conditions: tuple[nodes.Expr, ...], *, is_written: bool) -> Look:
    from motionlang.mint.compile.poll_analysis import Look

    look = Look(b)
    look.at_all(body, conditions, is_written=is_written)
    return look


def _poll(b: Body, look: Look) -> Poll | None:
    if look.acts or len(look.assigned) > MOST_VARIABLES or (look.computes and not look.reads):
        return None  # with nothing but its own variables it computes
    b.whole.rewritten |= look.rewritten
    return Poll(b, sorted(look.assigned), look.watches, look.reads, look.waits)


def turn(b: Body, poll: Poll) -> None:
    """The end of a turn, `t` being up to date."""
    now = poll.now
    waited = f", E.waited - {poll.waited}" if poll.waited else ""
    others = f"E.resumed - {poll.others}"
    skip = f"{b.whole.use('env', poll.how)}(t, {poll.since}, H, {poll.watches}, {now}, {others}{waited})"
    b.emit(f"if {poll.before} == ({now} := {poll.state}): t = {skip}")
    b.horizon(then=f"; {now} = {poll.state}")
    more = f"; {poll.waited} = E.waited" if poll.waited else ""
    b.emit(f"{poll.before} = {now}; {poll.since} = t; {poll.others} = E.resumed{more}")


def _plainly_acts(b: Body, node: nodes.Stmt) -> bool:
    """Whether a statement does something in every turn, at a glance."""
    if not isinstance(node, (nodes.Assign, nodes.Call)):
        return node.__class__ in _ACTS
    target = node.target
    if not isinstance(target, nodes.Name):
        return False
    if b.scope.find(target.name) is not None:
        return isinstance(node, nodes.Assign) and _counts(target, node)
    row = b.whole.table.get(target.name)
    if row is None or row.verb == "wait":
        return False
    return isinstance(node, nodes.Call) or row.verb not in REPEATABLE


def _counts(target: nodes.Name, node: nodes.Assign) -> bool:
    """`n = n + 1`."""
    value = node.values[0] if node.values else None
    return (
        isinstance(value, nodes.Binary)
        and value.op in ("+", "-")
        and isinstance(value.left, nodes.Name)
        and isinstance(value.right, nodes.Number)
        and target.args is None
        and value.left.name.lower() == target.name.lower()
    )


_ACTS = frozenset((nodes.Print, nodes.Input, nodes.End))
# Verbs that change nothing where they write what can be read there already.
REPEATABLE = frozenset(
    {
        "speed", "accel", "decel", "accel_time", "decel_time", "accel_jerk", "decel_jerk", "enabled", "error_decel",
        "feedrate.override", "feedrate.limit", "feedrate.jerk_time", "feedrate.s_ramp", "feedrate.time_to_most",
        "feedrate_mode", "profile_mode", "paths.mode", "following.part", "jogging.velocity", "jogging.setting",
        "drives.speed", "drives.setting", "drives.velocity", "io.outputs.bank", "io.outputs.bit", "io.outputs.dac",
        "relays.bank", "relays.relay", "relays.auxiliary", "io.signals.enable_output", "io.signals.error_output",
        "comms.real", "comms.whole", "modbus.real", "modbus.whole", "modbus.word", "modbus.coil",
        "modbus.own_register", "network.comms_real", "network.comms_whole", "network.first_bus_comms",
        "remote.bits", "remote.bit", "remote.percent", "limits.soft", "limits.mode", "following.masters.setting",
        "homing.setting", "sensing.window", "monitoring.limit", "nonvolatile.word", "nonvolatile.real",
        "no_effect.value", "servo.gain", "servo.fatal_error", "terminal.terminal",
    }
)  # fmt: skip
