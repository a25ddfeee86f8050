"""A proof of a run: check all motion against the commands of the program.

Problem. A planner that is wrong in a rare case gives a plausible profile, and a test finds it only if it has
that case. The log and the report may be wrong in the same way. So a complete run can be checked afterwards,
by code that shares nothing with the planners and uses only what the run has recorded.

Idea. During the run `ExpectedMotion` records the expected motion, an `Order` for each profile: the kind of motion and
the settings in force when it began, never anything that a planner has computed. Afterwards each profile is
compared with its order and with the profile before it, and each entry of the log with the tracks of the axes.

    program ──▶ settings ──▶ planners ──▶ profiles ──▶ tracks, log ──▶ report, trace
                   │                                       │                │
                   └──────▶ expected motion ─────────▶ checkers ◀───────────┘

Data. `RunRecords` gives the checkers the tracks, the log and the expected motion. `Proof` takes their results: how
much was checked, the largest fraction used of each bound, exceptions by name, and violations, each a
diagnostic at the line of its move. The other files each check one kind of motion or record. They use the
arithmetic of `segments.py` (extremes of polynomials and waves) and `stretches.py` (motion above its limits).

`prove` checks, in this order:
1. the report and the trace, if there are any,
2. each axis: every profile, and how it continues the one before,
3. settings that were written in motion,
4. each entry of the log,
5. the entries of each axis together: none is missing, that of an OFFSET included, and the last one leads to
   where the axis is.

Invariants.
- The checkers import no planner, and compute neither a ramp nor how long motion may take.
- No bound is checked by sampling. Extremes are found in closed form.
- A rule that the program breaks on purpose, such as by CANCEL, a new zero or a kink within CONTOURANGLE, is
  an exception. Exceptions are counted by name, so none goes unseen.
- A figure may exceed its bound only by rounding (`SLACK`).
- A run with too many different orders to record is not proved, and that is a violation.

Cost. One pass over the profiles of each axis and one over the log; lookups are bisections. Packed records are
read chunk by chunk, so memory grows only with the orders and with the entries of paths and offsets. Other
runs record none.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from math import acos, degrees, fsum, inf, isfinite, nextafter, sqrt

from motionlang.kernel import Axis, Controller, Diagnostic
from motionlang.kernel.log import LoggedMove
from motionlang.kernel.planners import MotionState, Profile
from motionlang.kernel.tracks import Samples
from tests.proof.axes import PLANNED, check_profile
from tests.proof.checker import SLACK, Proof, RunRecords
from tests.proof.entries import Ends, check_ends, take_entry
from tests.proof.expected_motion import MAX_PROFILES, ExpectedMotion
from tests.proof.followers import check_points, check_tie
from tests.proof.offsets import check_missing
from tests.proof.order import Order, PathOrder
from tests.proof.outputs import check_report, check_trace
from tests.proof.paths import check_path, check_path_end, in_force
from tests.proof.segments import half_angle
from tests.proof.settings import check_settings

# The fractions of the time of a log entry at which the track is compared with it, in addition to its ends.
SAMPLE_FRACTIONS = (0.0, 0.21, 0.5, 0.83, 1.0)


def prove(
    controller: Controller,
    expected_motion: ExpectedMotion,
    until: float,
    report: Iterable[Mapping[str, object]] | None = None,
    samples: Samples | None = None,
) -> Proof:
    """Prove the motion of a controller up to a time, from its log.

    The moves of a report and a trace are checked too, if given. If a run has more motion than can be
    recorded, nothing is proved, and that is a violation.
    """
    proof = Proof()
    if expected_motion.is_full:
        message = f"nothing was verified: the run has more than {MAX_PROFILES} profiles of motion, the limit of a proof"
        proof.violations.append(Diagnostic("crash", message, hint="end the run sooner with --until"))
        return proof
    run = RunRecords(controller.axes, controller.log.moves, expected_motion, until)
    if report is not None:
        check_report(proof, run, report)
    if samples is not None:
        check_trace(proof, run, samples)
    for number, a in controller.axes.items():
        records = expected_motion.of[number]
        assert expected_motion.was_cut or len(records) == len(a.starts), (
            f"axis {number} has a profile that was not recorded"
        )
        for i, order in enumerate(records):
            begin, end = run.span(a, i)
            if end > begin:
                plan = order
                if order.path is not None:
                    master = run.axes[order.path.members[0]]
                    plan = in_force(run, master, master.index_at(begin), order)
                check_profile(proof, a, i, plan, records[max(i - 1, 0)], end - begin)
                if order.path is not None and order.path.members[0] == number:
                    check_path(proof, run, a, i, order, end)
                elif order.tie is not None:
                    check_tie(proof, run, a, i, order, end)
                elif order.points is not None:
                    check_points(proof, a, i, order)
            if i:
                _check_join(proof, run, a, i)
    check_settings(proof, run)
    ends: dict[int, Ends] = {}
    for move in run.moves:
        _check_move(proof, run, move)
        take_entry(proof, ends, run, move)
    check_ends(proof, run, ends)
    check_missing(proof, run)
    return proof


# ------------------------------------------------------------------------------------------------------- joins


def _check_join(proof: Proof, run: RunRecords, a: Axis, i: int) -> None:
    """Check continuity of position, velocity and S-ramp acceleration between profiles."""
    proof.counts["joins"] += 1
    expected_motion = run.expected_motion
    time, order, earlier = a.starts[i], expected_motion.of[a.index][i], expected_motion.of[a.index][i - 1]
    before = a.profiles[i - 1].at(time - a.starts[i - 1])
    after = a.profiles[i].at(0.0)
    shift = expected_motion.data[a.index][i] - expected_motion.data[a.index][i - 1]
    where = f"axis {a.index} at {time:.6f} s"
    line = order.line or earlier.line
    # The time of a join is rounded to the clock, and the axis has moved on accordingly.
    late = 4e-16 * (1.0 + time)
    moved = abs(after.position - before.position - shift)
    if shift:
        proof.excuses("a position set to a new value")
    if moved > SLACK * max(1.0, abs(before.position) * 1e-6) + 4.0 * late * abs(before.velocity):
        if a.feedback is not None and not after.velocity and order.kind == "rest":
            proof.excuses("a demand set to the motor position")
        else:
            proof.breaks(line, f"{where}: the position jumps by {moved:g} counts")
    jump = abs(after.velocity - before.velocity)
    kinds = (earlier.kind, order.kind)
    slack = SLACK * max(1.0, abs(before.velocity), abs(after.velocity)) + 4.0 * late * abs(
        before.acceleration
    )
    if jump > slack:
        excuse = _excuse(run, a, i, kinds)
        if not excuse and jump <= _step(run, a, i, earlier) + order.step + slack:
            excuse = "a step of a stepper that starts or stops at once"
        if excuse:
            proof.excuses(excuse)
        else:
            proof.breaks(line, f"{where}: the velocity jumps by {jump:g} counts/s")
        return
    if not order.bends:
        return
    size = SLACK * max(1.0, *order.rates)
    # While the time is rounded, the acceleration changes by the jerk: at once with a jerk time of 0.
    jerk = max(order.jerks) if order.jerks[0] < inf else abs(before.jerk)
    if kinds == ("path", "path") and order.path is not None and order.path.members[0] == a.index:
        bend = _bend(order.path, _both(run, order, time))
        if bend > size + 4.0 * late * jerk:
            proof.breaks(line, f"{where}: the acceleration along the path jumps by {bend:g}")
    elif order.kind in PLANNED and kinds[0] in (*PLANNED, "rest") and earlier.bends:
        bend = abs(after.acceleration - before.acceleration)
        if earlier.kind == "stop" and i > 1 and not expected_motion.of[a.index][i - 2].bends:
            bend = min(bend, abs(after.acceleration))  # it stopped as planned before, by a trapezoid
        if bend > size + 4.0 * late * jerk:
            proof.breaks(line, f"{where}: the acceleration of an S-ramp jumps by {bend:g} counts/s²")


def _step(run: RunRecords, a: Axis, i: int, earlier: Order) -> float:
    """Return the velocity, counts/s, at which a stepper may end the profile before i.

    A stop that continues the move as planned, because it would take longer, ends like that.
    """
    if earlier.kind != "stop" or i < 2:
        return earlier.step
    before, end = run.expected_motion.of[a.index][i - 2], a.profiles[i - 2].end
    return before.step if abs(a.profiles[i - 1].end - end) <= SLACK * max(1.0, abs(end)) else 0.0


def _excuse(run: RunRecords, a: Axis, i: int, kinds: tuple[str, str]) -> str:
    """Return the command that makes the velocity jump; "" if there is none."""
    if (a.index, a.starts[i]) in run.expected_motion.standstills:
        return "an immediate stop: cancelled, disabled, or at a limit"
    order, earlier = run.expected_motion.of[a.index][i], run.expected_motion.of[a.index][i - 1]
    if order.tie is not None and order.tie.ramp and order.tie.takes_up(earlier.tie):
        return ""
    named = [kind for kind in kinds if kind not in (*PLANNED, "rest", "path")]
    if named:
        return _at_once(earlier, order, named[-1])
    if order.path is None or earlier.path is None:
        return ""
    scales = order.path.scales
    old, new = _both(run, order, a.starts[i])
    before, after = _speed(scales, old), _speed(scales, new)
    if abs(before - after) > SLACK * max(1.0, before) or not before:
        return ""
    speeds = [
        (o.velocity / k / before, n.velocity / k / after) for k, o, n in zip(scales, old, new, strict=True)
    ]
    dot = fsum(o * n for o, n in speeds)
    chord = sqrt(fsum((o - n) ** 2 for o, n in speeds))
    angle = half_angle(chord) if dot > 0.5 else degrees(acos(max(-1.0, min(1.0, dot))))
    return "a kink within CONTOURANGLE" if angle <= order.path.angle_into + 1e-6 else ""


def _at_once(earlier: Order, order: Order, kind: str) -> str:
    """Return what the action `kind` did as the velocity jumped."""
    tie, before = order.tie, earlier.tie
    if tie is None:
        return f"{kind}: a table or a reference of the program"
    if before is None or before.master is not tie.master:
        return f"{kind} engaged at once"
    if tie.curve is None and before.ratio != tie.ratio:
        return f"{kind}: a new ratio at once"
    return f"{kind}: a jump of its master or in its table"


def _bend(path: PathOrder, both: Iterable[Sequence[MotionState]]) -> float:
    """Return the jump in acceleration along a path between two states of its axes."""
    scales = path.scales
    rates = []
    for states in both:
        speed = _speed(scales, states)
        power = fsum(s.velocity * s.acceleration / k**2 for k, s in zip(scales, states, strict=True))
        if speed < SLACK:
            return 0.0
        rates.append(power / speed)
    return abs(rates[1] - rates[0])


def _speed(scales: Sequence[float], states: Sequence[MotionState]) -> float:
    return sqrt(fsum((s.velocity / k) ** 2 for k, s in zip(scales, states, strict=True)))


def _at_last(profile: Profile, time: float) -> MotionState:
    """Return the state at `time`, taken just before the end if that is the end.

    At the end itself a profile has no acceleration.
    """
    return profile.at(min(time, nextafter(profile.duration, 0.0)))


def _both(run: RunRecords, order: Order, time: float) -> tuple[list[MotionState], list[MotionState]]:
    """Return the states of a path's axes just before and just after a time."""
    assert order.path is not None
    axes = [run.axes[number] for number in order.path.members]
    indices = [a.index_at(time) for a in axes]
    # An axis that was given another zero has a profile of its own from then on, the other axes of the path do
    # not.
    before = [k - (a.starts[k] == time) for a, k in zip(axes, indices, strict=True)]
    old = [_at_last(a.profiles[k], time - a.starts[k]) for a, k in zip(axes, before, strict=True)]
    return old, [a.profiles[k].at(time - a.starts[k]) for a, k in zip(axes, indices, strict=True)]


# ---------------------------------------------------------------------------------------------------- the log


def _check_move(proof: Proof, run: RunRecords, move: LoggedMove) -> None:
    """Check an entry of the log: duration, phases, end, and agreement with the track."""
    proof.counts["moves"] += 1
    profile, a = move.profile, run.axes[move.axis]
    assert profile is not None
    where = f"axis {move.axis} from {move.start_time:.6f} s"
    size = max(1.0, abs(profile.start), abs(profile.end) if isfinite(profile.end) else 0.0)
    if not profile.duration and abs(profile.distance) > SLACK * size:
        proof.breaks(move.line, f"{where}: {profile.distance:g} counts in no time")
    if isfinite(profile.duration):
        phases = profile.phases
        time, distance = fsum(each.duration for each in phases), fsum(each.distance for each in phases)
        if abs(time - profile.duration) > SLACK * max(1.0, profile.duration):
            proof.breaks(move.line, f"{where}: the phases take {time:g} s, the move {profile.duration:g} s")
        if abs(distance - profile.distance) > SLACK * size:
            proof.breaks(
                move.line, f"{where}: the phases cover {distance:g} counts, the move {profile.distance:g}"
            )
    kind = run.order_of(move).kind
    over = move.start_time + profile.duration <= run.until and a.move is not move and not move.ended
    if (
        over
        and kind in ("move", "step", "rest")
        and abs(profile.end + move.offset - move.target) > SLACK * size
    ):
        proof.breaks(
            move.line, f"{where}: it ends at {profile.end + move.offset:g}, commanded {move.target:g}"
        )
    if kind == "path":
        check_path_end(proof, run, move, over)
    if move.overlaid or move.offset or not isfinite(profile.start):
        return
    length = min(profile.duration, run.until - move.start_time)
    zero = _zero(run, a, move.start_time)
    for share in SAMPLE_FRACTIONS:
        time = move.start_time + share * length
        if _zero(run, a, time) != zero:  # another zero, which a later one may cancel
            continue
        if not a.starts or time < move.start_time:
            continue
        stated = profile.position(time - move.start_time)
        done = run.logged(a, move, time, share == 1.0 and length > 0.0)
        speed = abs(profile.velocity(time - move.start_time))
        if abs(stated - done) > SLACK * size + 8e-16 * (1.0 + time) * speed:
            proof.breaks(
                move.line, f"{where}: the log has it at {stated:g} at {time:.6f} s, the track at {done:g}"
            )
            return


def _zero(run: RunRecords, a: Axis, time: float) -> float:
    """Return the zero of an axis at a time, or the last one before an interrupt."""
    data = run.expected_motion.data[a.index]
    return data[min(a.index_at(time), len(data) - 1)] if data and a.starts else 0.0
